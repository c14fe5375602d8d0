//! Every strategy on a wavy plate of 100 k facets, 500 mm wide, with lines 1 mm apart.

use clearbeam::part::surfaces::Surface;
use clearbeam::part::{Mesh, Surfaces};
use clearbeam::path::normals::VertexNormals;
use clearbeam::path::planes::{Direction, PlaneRaster, planes};
use clearbeam::path::strategy::{Layout, lines, spacing};
use clearbeam::path::{Strategy, section};
use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::Point3;
use std::hint::black_box;
use std::time::Duration;

/// Quads along a side: 100 352 facets.
const SIDE: usize = 224;
const WIDTH_MM: f64 = 500.0;
const SPACING_MM: f64 = 1.0;

fn plate() -> (Mesh, Surfaces) {
    let at = |i: usize| WIDTH_MM * i as f64 / SIDE as f64;
    let points = (0..=SIDE).flat_map(|j| {
        (0..=SIDE).map(move |i| Point3::new(at(i), at(j), 10.0 * libm::sin(at(i) / 60.0) * libm::sin(at(j) / 60.0)))
    });
    let v = |i: usize, j: usize| (j * (SIDE + 1) + i) as u32;
    let quads = (0..SIDE * SIDE).map(|q| (q % SIDE, q / SIDE));
    let facets =
        quads.flat_map(|(i, j)| [[v(i, j), v(i + 1, j), v(i + 1, j + 1)], [v(i, j), v(i + 1, j + 1), v(i, j + 1)]]);
    let mesh = Mesh::from_indexed(points.collect(), facets.collect());
    let all = (0..mesh.facets.len() as u32).collect();
    let surface = Surface { number: 1, facets: all, area_mm2: mesh.areas.iter().sum() };
    let (of_facet, normals) = (vec![1; mesh.facets.len()], mesh.normals.clone());
    (mesh, Surfaces { of_facet, list: vec![surface], normals, last_number: 1, ..Surfaces::default() })
}

fn strategies(c: &mut Criterion) {
    let (mesh, surfaces) = plate();
    let Some(surface) = surfaces.get(1) else { return };
    let normals = VertexNormals::new(&mesh, &surfaces, surface);
    let family = planes(
        &mesh,
        &surfaces,
        &[PlaneRaster {
            surface: 1,
            direction: Direction::Along([1.0, 0.0, 0.0]),
            spacing_mm: SPACING_MM,
            offset_mm: None,
        }],
        &nalgebra::Rotation3::identity(),
    );
    let Some(family) = family.first() else { return };
    let mut group = c.benchmark_group("strategies");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1500));
    for strategy in Strategy::ALL {
        let rule = Layout::new(strategy, SPACING_MM);
        group.bench_function(strategy.word(), |b| {
            b.iter(|| lines(&mesh, surface, &normals, black_box(&rule), family, 1e-6));
        });
    }
    let cut = section::sections(&mesh, surface, &normals, &family.normal, &family.heights_mm, 1e-6);
    group.bench_function("spacing", |b| b.iter(|| spacing::achieved(black_box(&cut), None, SPACING_MM)));
    group.finish();
}

criterion_group!(benches, strategies);
criterion_main!(benches);
