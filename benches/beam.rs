//! Cone and head on a gear of 100 k facets: detection, free sets, the search, the proof, and what lands; and a plan
//! with clamps by how near they are and of how many facets.
//!
//! `cargo bench --bench beam`; `cargo bench --bench beam -- dose` one of it.

use clearbeam::beam::{Head, Obstacle, Tool};
use clearbeam::cell::Setup;
use clearbeam::document::{Job, segmented};
use clearbeam::part::{Part, Placement, Units};
use clearbeam::planning::proof::prover;
use clearbeam::planning::surface_plan::tool_geometry;
use clearbeam::planning::{self, PlanCache};
use clearbeam::pose::access::AccessMap;
use clearbeam::pose::{BeamInterference, Correction, Tilt, TiltRule};
use clearbeam::progress::Progress;
use clearbeam::sample::solids::{cube, helical_gear, sphere};
use clearbeam::sample::{Triangles, stl_bytes};
use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::time::Duration;

/// Surfaces that are cleaned.
const SURFACES: u32 = 2;

/// Some surfaces of the gear, so many that there are about 100 k samples of a spot of 1 mm.
fn dose(c: &mut Criterion) {
    let bytes = stl_bytes(&helical_gear(40, 8, 15, 4));
    let Ok(part) = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]) else { return };
    let Ok(setup) = Setup::shipped() else { return };
    let mut job = Job::default();
    job.layers.direction = clearbeam::path::Direction::AXES[2].1;
    job.settings.choose((1..=SURFACES).collect::<Vec<u32>>());
    let surfaces = segmented(&part, &job);
    let Ok(plan) = planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()) else {
        return;
    };
    let run = || planning::dose(&part, &surfaces, &plan, &job, &setup, &Progress::default());
    let Ok(map) = run() else { return };
    let lit = map.samples.iter().filter(|s| s.fluence_j_cm2 > 0.0).count();
    let name = format!("dose, {lit} samples in the light of {} pieces/100k", map.light.pieces.len());
    let mut group = c.benchmark_group("beam");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(5));
    group.bench_function(name, |b| b.iter(run));
    group.finish();
}

/// A nozzle that comes near the spot, and the head behind it.
const HEAD: &str = "[[part]]\nfrom_mm = 40\nto_mm = 80\nr0_mm = 5\nr1_mm = 18\n\
                    [[part]]\nfrom_mm = 80\nto_mm = 240\nr0_mm = 25\nr1_mm = 25\n";
/// Poses that are looked at.
const POSES: usize = 3000;
/// Directions of a free set.
const DIRECTIONS: usize = 240;

/// Poses along the normals of the first surfaces' targets, and on a hexagonal grid around them.
fn proven(c: &mut Criterion) {
    let bytes = stl_bytes(&helical_gear(40, 8, 15, 4));
    let Ok(part) = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]) else { return };
    let (Ok(mut setup), Ok(head)) = (Setup::shipped(), Head::from_toml(HEAD)) else { return };
    setup.tool = Tool { head: Some(head), ..Tool::default() };
    let mut job = Job::default();
    job.layers.direction = clearbeam::path::Direction::AXES[2].1;
    job.path.correction = Correction::SectionPlane;
    let surfaces = segmented(&part, &job);
    job.settings.choose(surfaces.list.iter().map(|s| s.number).take(12).collect::<Vec<u32>>());
    let Ok(plan) = planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()) else {
        return;
    };
    let body = tool_geometry(&job, &setup);
    let beam = || BeamInterference::with(&part, body.as_ref());
    type Place = (Point3<f64>, Vector3<f64>, Vector3<f64>);
    let all: Vec<Place> = plan.passes.iter().flat_map(|p| &p.targets).map(|t| (t.p, t.n, t.tangent())).collect();
    let every = (all.len() / POSES).max(1);
    let places: Vec<Place> = all.into_iter().step_by(every).take(POSES).collect();
    let tilts: Vec<Tilt> = (0..DIRECTIONS)
        .map(|i| {
            // Evenly over the cap of 45 degrees, by the golden angle.
            let (r, turn) = (45.0 * ((i as f64 + 0.5) / DIRECTIONS as f64).sqrt(), i as f64 * 2.399_963_229_728_653);
            Tilt { lead_deg: r * libm::cos(turn), lean_deg: r * libm::sin(turn) }
        })
        .collect();
    let mut group = c.benchmark_group("beam");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(3));
    group.bench_function(format!("detection, {} poses/100k", places.len()), |b| {
        let free = |beam: &mut BeamInterference<'_>, (p, n, _): &Place| usize::from(beam.is_free(p, n));
        b.iter(|| places.par_iter().map_init(beam, free).sum::<usize>());
    });
    group.bench_function(format!("free sets, {} poses x {DIRECTIONS}/100k", places.len()), |b| {
        let free = |beam: &mut BeamInterference<'_>, (p, n, o): &Place| {
            tilts.iter().filter(|t| beam.is_free(p, &t.axis(n, o))).count()
        };
        b.iter(|| places.par_iter().map_init(beam, free).sum::<usize>());
    });
    group.bench_function("access map of one place, 3 degrees/100k", |b| {
        let Some((p, n, o)) = places.get(places.len() / 2) else { return };
        b.iter(|| AccessMap::at(&beam(), p, n, o, &TiltRule::default(), 45.0, 3.0).free_share());
    });
    let mut moves = plan.steps.lit_moves(&setup.mounted());
    moves.truncate(POSES);
    group.bench_function(format!("proof, {} moves/100k", moves.len()), |b| {
        let prover = prover(&part, &setup, &job);
        b.iter(|| prover.prove(moves.clone()).map(|proof| proof.proven));
    });
    let few = |job: &Job| {
        let mut job = job.clone();
        job.settings.choose(surfaces.list.iter().map(|s| s.number).take(2).collect::<Vec<u32>>());
        job
    };
    for correction in [Correction::SectionPlane, Correction::Clearance] {
        let mut job = few(&job);
        job.path.correction = correction;
        let planned = || planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default());
        let Ok(plan) = planned() else { return };
        let shown =
            || planning::preview(&part, &surfaces, &job, &PlanCache::default(), &Progress::default()).map(|l| l.len());
        group.bench_function(format!("preview before {}/100k", correction.word()), |b| b.iter(shown));
        let rows: usize = plan.passes.iter().map(|p| p.targets.len()).sum();
        group.bench_function(format!("plan with {}, {rows} rows/100k", correction.word()), |b| b.iter(planned));
    }
    group.finish();
}

/// A plan without a head and with one: without a clamp, with one far away, and with two at the lines.
fn clamps(c: &mut Criterion) {
    let part = Part::from_bytes(&stl_bytes(&sphere(40.0, 96, 48)), Units::Mm, &Placement::default(), &[]);
    let (Ok(part), Ok(mut setup), Ok(head), Ok(folder)) =
        (part, Setup::shipped(), Head::from_toml(HEAD), tempfile::tempdir())
    else {
        return;
    };
    let mut job = Job::default();
    job.layers.spacing_mm = 4.0;
    let surfaces = segmented(&part, &job);
    job.settings.choose(vec![1u32]);
    let clamp = |facets: &Triangles, x_mm: f64| {
        let mut clamp = Obstacle::named("clamp.stl".into());
        clamp.position_mm = [x_mm, 0.0, 0.0];
        std::fs::write(folder.path().join("clamp.stl"), stl_bytes(facets)).ok()?;
        clamp.load(Some(folder.path())).ok().map(|()| clamp)
    };
    let (coarse, fine) = (cube(20.0), sphere(10.0, 256, 128));
    let beside = [
        ("none", vec![]),
        ("12 facets 300 mm away", vec![clamp(&coarse, 340.0)]),
        ("12 facets 20 mm away", vec![clamp(&coarse, 60.0)]),
        ("65 k facets 20 mm away", vec![clamp(&fine, 70.0)]),
    ];
    let mut group = c.benchmark_group("beam");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(3));
    for head in [None, Some(head)] {
        for (name, clamps) in &beside {
            setup.tool =
                Tool { head: head.clone(), clamps: clamps.iter().flatten().cloned().collect(), ..Tool::default() };
            let with = if head.is_some() { "a head" } else { "a ray" };
            group.bench_function(format!("plan of {with}, clamps: {name}"), |b| {
                b.iter(|| planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, proven, dose, clamps);
criterion_main!(benches);
