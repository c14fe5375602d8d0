//! What lands on a gear of 100 k facets, on 100 k samples.
//!
//! `cargo bench --bench beam -- dose`.

use clearbeam::cell::Setup;
use clearbeam::job::plan::segmented;
use clearbeam::job::{self, Cache, Chosen, Job, Progress};
use clearbeam::part::{Part, Placement, Units};
use clearbeam::path::Direction;
use clearbeam::sample::{solids::helical_gear, stl_bytes};
use criterion::{Criterion, criterion_group, criterion_main};
use std::time::Duration;

/// All surfaces of the gear, planned with planes 2 mm apart. The spot is so wide that its samples are
/// about as large as the facets.
fn dose(c: &mut Criterion) {
    let bytes = stl_bytes(&helical_gear(40, 8, 15, 4));
    let Ok(part) = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]) else { return };
    let Ok(setup) = Setup::shipped() else { return };
    let mut job = Job::default();
    job.clean.surfaces = Chosen::All;
    job.layers.direction = Direction::Auto;
    job.layers.spacing_mm = 2.0;
    job.beam.spot_mm = 3.0;
    let surfaces = segmented(&part, &job);
    let Ok(plan) = job::plan(&part, &surfaces, &job, &setup, &Cache::default(), &Progress::default()) else { return };
    let run = || job::dose(&part, &surfaces, &plan, &job, &setup, &Progress::default());
    let Ok(map) = run() else { return };
    let name = format!("dose, {} samples, {} pieces/100k", map.samples.len(), map.light.pieces.len());
    let mut group = c.benchmark_group("beam");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(5));
    group.bench_function(name, |b| b.iter(run));
    group.finish();
}

criterion_group!(benches, dose);
criterion_main!(benches);
