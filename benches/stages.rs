//! Every stage of the main job, timed on one helical gear of 10 k, 100 k and 1 M facets.
//!
//! `cargo bench` runs all of it in about six minutes; `cargo bench -- 'slice/100k'` one of it.
//! Stages that planning runs on all cores are run so here, too. `benches/peers.py` times the same
//! stages of other programs on the same meshes; compare figures of one sitting only.

use clearbeam::beam::{Head, Optics, ProcessSettings, Tool, ToolConfiguration};
use clearbeam::cell::Setup;
use clearbeam::document::{Chosen, Job, segmented};
use clearbeam::part::inspect::InspectReport;
use clearbeam::part::merge_tree::dihedral_angles;
use clearbeam::part::orient::orient;
use clearbeam::part::surfaces::Surface;
use clearbeam::part::topology::FacetDefect;
use clearbeam::part::{Bvh, MergeTree, Mesh, Part, Placement, SurfaceEdit, SurfaceRule, Surfaces, Units, file};
use clearbeam::path::chord::ChordLimits;
use clearbeam::path::normals::VertexNormals;
use clearbeam::path::{Direction, TransversalLine, dense, section};
use clearbeam::planning::{PlanCache, plan};
use clearbeam::pose::clearance::free_set;
use clearbeam::pose::{BeamInterference, Correction, LineOnSurface, LineRules, Pass, TiltRule, plan_line};
use clearbeam::progress::Progress;
use clearbeam::sample::solids::{cube, helical_gear};
use clearbeam::sample::stl_bytes;
use criterion::measurement::WallTime;
use criterion::{BatchSize, BenchmarkGroup, Criterion, criterion_group, criterion_main};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::hint::black_box;
use std::time::Duration;

/// Label, and what [`helical_gear`] takes: 9 856, 97 280 and 998 400 facets.
const SIZES: [(&str, [usize; 4]); 3] = [("10k", [14, 4, 8, 3]), ("100k", [40, 8, 15, 4]), ("1M", [40, 24, 54, 11])];
const BEAMS: usize = 100_000;
/// Points of lines that are searched.
const SEARCHED: usize = 3000;
/// Tooth gaps whose lines are corrected.
const GAPS: usize = 3;
/// The planes of the corrected lines, mm apart.
const GAP_SPACING_MM: f64 = 0.5;
/// The planes of the whole plan, mm apart.
const PLAN_SPACING_MM: f64 = 4.0;
const Z: Vector3<f64> = Vector3::new(0.0, 0.0, 1.0);

fn stages(c: &mut Criterion) {
    many_bodies(c);
    for (size, [teeth, k, layers, rings]) in SIZES {
        let bytes = stl_bytes(&helical_gear(teeth, k, layers, rings));
        let Ok(part) = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]) else { return };
        let mut group = c.benchmark_group("stages");
        group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1500));
        preparation(&mut group, size, &bytes, &part);
        recut(&mut group, size, &part);
        slicing(&mut group, size, &part);
        beams(&mut group, size, &part);
        correction(&mut group, size, &part);
        clearance(&mut group, size, &part);
        whole_plan(&mut group, size, &part);
        group.finish();
    }
}

/// From the bytes of a file to a part.
fn preparation(group: &mut BenchmarkGroup<'_, WallTime>, size: &str, bytes: &[u8], part: &Part) {
    let Ok(raw) = file::read(bytes) else { return };
    let welded = Mesh::weld(&raw.facets, 1.0);
    group.bench_function(format!("read/{size}"), |b| b.iter(|| file::read(black_box(bytes))));
    group.bench_function(format!("read, weld, topology/{size}"), |b| {
        b.iter(|| file::read(black_box(bytes)).map(|raw| Mesh::weld(&raw.facets, 1.0)));
    });
    let indexed = || (welded.vertices.clone(), welded.facets.clone());
    group.bench_function(format!("topology/{size}"), |b| {
        b.iter_batched(indexed, |(v, f)| Mesh::from_indexed(v, f), BatchSize::PerIteration);
    });
    group.bench_function(format!("orientation/{size}"), |b| {
        let turn = |mut mesh: Mesh| (orient(&mut mesh), mesh);
        b.iter_batched(|| welded.clone(), turn, BatchSize::PerIteration);
    });
    group.bench_function(format!("dihedral angles, merge tree/{size}"), |b| {
        b.iter(|| MergeTree::new(&part.mesh, &dihedral_angles(black_box(&part.mesh))));
    });
    group.bench_function(format!("ray structure/{size}"), |b| b.iter(|| Bvh::new(black_box(&part.mesh))));
    group.bench_function(format!("whole part/{size}"), |b| {
        b.iter(|| Part::from_bytes(black_box(bytes), Units::Mm, &Placement::default(), &[]));
    });
}

/// From the bytes of a file to what `inspect` says of it: cubes that stand apart.
fn many_bodies(c: &mut Criterion) {
    let mut group = c.benchmark_group("stages");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1500));
    for side in [10, 16, 25] {
        let place = |i: usize| [i % side, i / side % side, i / side / side].map(|k| 2.0 * k as f64);
        let moved = |by: [f64; 3]| cube(1.0).into_iter().map(move |t| t.map(|p| [0, 1, 2].map(|k| p[k] + by[k])));
        let count = side * side * side;
        let bytes = stl_bytes(&(0..count).flat_map(|i| moved(place(i))).collect());
        group.bench_function(format!("inspect/{count} bodies"), |b| {
            b.iter(|| {
                let part = Part::from_bytes(black_box(&bytes), Units::Mm, &Placement::default(), &[]).ok()?;
                let job = Job::default();
                let surfaces = segmented(&part, &job);
                Some(InspectReport::new(&part, &surfaces, &job.surfaces.rule(), job.beam.spot_area_mm2()))
            });
        });
    }
    group.finish();
}

/// The α slider, dragged: another angle each time.
fn recut(group: &mut BenchmarkGroup<'_, WallTime>, size: &str, part: &Part) {
    let mut angle_deg = 1.0;
    let mut next = move || {
        angle_deg = if angle_deg > 89.0 { 1.0 } else { angle_deg + 1.3 };
        angle_deg
    };
    group.bench_function(format!("recut, tree alone/{size}"), |b| b.iter(|| part.tree.cut(next())));
    group.bench_function(format!("recut, all surfaces/{size}"), |b| {
        b.iter(|| Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &rule(next()), &[], &[]));
    });
}

fn rule(angle_deg: f64) -> SurfaceRule {
    SurfaceRule { angle_deg, min_area_mm2: 0.0, hysteresis_deg: 0.0 }
}

/// All surfaces at 20°, by planes z = constant, vertex normals included.
fn slicing(group: &mut BenchmarkGroup<'_, WallTime>, size: &str, part: &Part) {
    let surfaces = segmented(part, &Job::default());
    let (lo, hi) = part.mesh.bounds();
    let sliced = |heights_mm: &[f64]| -> usize {
        let lines = |s: &Surface| lines_of(part, &surfaces, s, heights_mm).len();
        surfaces.list.par_iter().map(lines).sum()
    };
    for planes in [100, 500].into_iter().filter(|&n| n == 100 || size == "100k") {
        let height = |i: usize| lo.z + (i as f64 + 0.5617) / planes as f64 * (hi.z - lo.z);
        let heights_mm: Vec<f64> = (0..planes).map(height).collect();
        group.bench_function(format!("slicing, {planes} planes/{size}"), |b| b.iter(|| sliced(black_box(&heights_mm))));
    }
}

fn lines_of(part: &Part, surfaces: &Surfaces, surface: &Surface, heights_mm: &[f64]) -> Vec<TransversalLine> {
    let normals = VertexNormals::new(&part.mesh, surfaces, surface);
    section::sections(&part.mesh, surface, &normals, &Z, heights_mm, 1e-6 * part.mesh.diagonal())
}

/// Beams along the normals of points that are spread evenly over the area.
fn beams(group: &mut BenchmarkGroup<'_, WallTime>, size: &str, part: &Part) {
    let points = surface_points(&part.mesh);
    let free_of = |beam: &BeamInterference<'_>, (p, a): &(Point3<f64>, Vector3<f64>)| usize::from(beam.is_free(p, a));
    group.bench_function(format!("interference, 100k beams/{size}"), |b| {
        let count =
            || points.par_iter().map_init(|| BeamInterference::on(part), |beam, q| free_of(beam, q)).sum::<usize>();
        b.iter(count);
    });
    group.bench_function(format!("interference, 100k beams, one thread/{size}"), |b| {
        let beam = BeamInterference::on(part);
        b.iter(|| points.iter().map(|q| free_of(&beam, q)).sum::<usize>());
    });
}

/// Points with the normal of their facet, stratified over the area; within a facet by the R2
/// sequence. The same on every run.
fn surface_points(mesh: &Mesh) -> Vec<(Point3<f64>, Vector3<f64>)> {
    let whole: f64 = mesh.areas.iter().sum();
    let mut sum = 0.0;
    let mut out = Vec::with_capacity(BEAMS);
    for f in (0..mesh.facets.len()).filter(|&f| mesh.defects[f] == FacetDefect::None) {
        sum += mesh.areas[f];
        while out.len() < BEAMS && (out.len() as f64 + 0.5) / BEAMS as f64 * whole < sum {
            let i = out.len() as f64 + 1.0;
            let (u, v) = ((i * 0.754_877_666_246_692_7).fract().sqrt(), (i * 0.569_840_290_998_053_2).fract());
            let [a, b, c] = mesh.corners(f);
            out.push((a + ((b - a) * (1.0 - v) + (c - a) * v) * u, mesh.normals[f]));
        }
    }
    out
}

fn planned(
    part: &Part,
    configuration: &ToolConfiguration<'_>,
    surface: u32,
    line: &TransversalLine,
    rules: &LineRules,
) -> Pass {
    let line = LineOnSurface { line, surface, number: 0, m: Some(Z) };
    plan_line(part, std::slice::from_ref(configuration), &line, rules, &Progress::default()).expect("nobody cancels")
}

/// Lines over tooth gaps (flank, root, flank). With 40 teeth 228 of the 240 have a run on either
/// flank, and all of it is corrected; the 14 teeth of 10 k stand too far apart: detection alone.
fn correction(group: &mut BenchmarkGroup<'_, WallTime>, size: &str, part: &Part) {
    let rules = line_rules(Correction::SectionPlane);
    let ray = ToolConfiguration::ray(ProcessSettings::default());
    let lines = gap_lines(part);
    group.bench_function(format!("correction, {} lines/{size}", lines.len()), |b| {
        b.iter(|| lines.par_iter().map(|(s, line)| planned(part, &ray, *s, line, &rules)).collect::<Vec<_>>());
    });
}

fn line_rules(correction: Correction) -> LineRules {
    LineRules {
        max_gap_mm: dense::max_gap_mm(GAP_SPACING_MM),
        max_dense_turn_deg: dense::MAX_TURN_DEG,
        chord: ChordLimits { chord_error_mm: 0.02, max_step_mm: 5.0, max_turn_deg: 5.0 },
        correction,
        max_tilt_deg: 45.0,
        tilt_rate_deg_mm: 5.0,
        tilt: TiltRule::default(),
        pins: Vec::new(),
    }
}

fn gap_lines(part: &Part) -> Vec<(u32, TransversalLine)> {
    let (gaps, surfaces) = tooth_gaps(part);
    let (lo, hi) = part.mesh.bounds();
    let count = ((hi.z - lo.z) / GAP_SPACING_MM).floor() as usize;
    let heights_mm: Vec<f64> = (0..count).map(|i| lo.z + (i as f64 + 0.5) * GAP_SPACING_MM).collect();
    gaps.iter()
        .filter_map(|&number| surfaces.get(number))
        .flat_map(|s| lines_of(part, &surfaces, s, &heights_mm).into_iter().map(|line| (s.number, line)))
        .collect()
}

/// A nozzle that comes near the spot, and the head behind it.
const HEAD: &str = "[[part]]\nfrom_mm = 40\nto_mm = 80\nr0_mm = 5\nr1_mm = 18\n\
                    [[part]]\nfrom_mm = 80\nto_mm = 240\nr0_mm = 25\nr1_mm = 25\n";

/// The search over the same lines, as many as have 3000 points; and the free sets of 3000 points alone.
fn clearance(group: &mut BenchmarkGroup<'_, WallTime>, size: &str, part: &Part) {
    let rules = line_rules(Correction::Clearance);
    let ray = ToolConfiguration::ray(ProcessSettings::default());
    let mut points = 0;
    let mut lines = gap_lines(part);
    lines.retain(|(_, line)| {
        let take = points < SEARCHED;
        points += if take { dense::dense(line, rules.max_gap_mm, rules.max_dense_turn_deg).len() } else { 0 };
        take
    });
    group.bench_function(format!("search and polish, {points} points/{size}"), |b| {
        b.iter(|| lines.par_iter().map(|(s, line)| planned(part, &ray, *s, line, &rules)).collect::<Vec<_>>());
    });
    let Ok(head) = Head::from_toml(HEAD) else { return };
    let tool = Tool { head: Some(head), ..Tool::default() };
    let held = ToolConfiguration::new(&tool, &Optics::default(), ProcessSettings::default(), 0.5);
    group.bench_function(format!("search and polish with a head, {points} points/{size}"), |b| {
        b.iter(|| lines.par_iter().map(|(s, line)| planned(part, &held, *s, line, &rules)).collect::<Vec<_>>());
    });
    let mut stands: Vec<_> =
        lines.iter().flat_map(|(_, line)| dense::dense(line, rules.max_gap_mm, rules.max_dense_turn_deg)).collect();
    stands.truncate(SEARCHED);
    group.bench_function(format!("free sets, {} points/{size}", stands.len()), |b| {
        let set =
            |beam: &mut BeamInterference<'_>, q: &dense::DensePoint| free_set(beam, &q.p, &q.n, &Z, rules.max_tilt_deg);
        b.iter(|| stands.par_iter().map_init(|| BeamInterference::on(part), set).collect::<Vec<_>>());
    });
}

/// Root surfaces merged with their two flanks; numbers, and the segmentation.
fn tooth_gaps(part: &Part) -> (Vec<u32>, Surfaces) {
    let mesh = &part.mesh;
    let cut = |edits: &[SurfaceEdit]| Surfaces::new(mesh, &part.tree, &part.dihedral_deg, &rule(20.0), edits, &[]);
    let plain = cut(&[]);
    let radius = |v: u32| mesh.vertices[v as usize].coords.xy().norm();
    let spread = |s: &Surface| {
        let radii = s.facets.iter().flat_map(|&f| mesh.facets[f as usize]).map(radius);
        radii.fold((f64::INFINITY, 0.0f64), |(lo, hi), r| (lo.min(r), hi.max(r)))
    };
    // Roots lie at 40 mm, flanks go from there to 46 mm.
    let is = |s: &Surface, (lo, hi): (f64, f64)| (spread(s).0 - lo).abs() < 0.1 && (spread(s).1 - hi).abs() < 0.1;
    let flank = |n: &u32| plain.get(*n).is_some_and(|s| is(s, (40.0, 46.0)));
    let edits: Vec<SurfaceEdit> = plain
        .list
        .iter()
        .filter(|s| is(s, (40.0, 40.0)))
        // Every second one, so that no flank is wanted twice.
        .step_by(2)
        .take(GAPS)
        .map(|root| {
            let flanks = plain.neighbours(mesh, root.number).into_iter().filter(flank);
            SurfaceEdit::Merge { merge: std::iter::once(root.number).chain(flanks).collect() }
        })
        .collect();
    let lowest = |e: &SurfaceEdit| match e {
        SurfaceEdit::Merge { merge } => merge.iter().min().copied(),
        SurfaceEdit::Split { .. } | SurfaceEdit::Cut { .. } => None,
    };
    (edits.iter().filter_map(lowest).collect(), cut(&edits))
}

/// All surfaces, the direction that suits each, from the part to the steps of the program.
fn whole_plan(group: &mut BenchmarkGroup<'_, WallTime>, size: &str, part: &Part) {
    let mut job = Job::default();
    job.settings.choose(Chosen::All);
    job.layers.direction = Direction::Auto;
    job.layers.spacing_mm = PLAN_SPACING_MM;
    let surfaces = segmented(part, &job);
    let Ok(setup) = Setup::shipped() else { return };
    group.bench_function(format!("whole plan/{size}"), |b| {
        b.iter(|| plan(part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()));
    });
}

criterion_group!(benches, stages);
criterion_main!(benches);
