//! What lands on a gear of 100 k facets, on 100 k samples.
//!
//! `cargo bench --bench beam -- dose`.

use clearbeam::cell::Setup;
use clearbeam::job::plan::segmented;
use clearbeam::job::{self, Cache, Chosen, Job, Progress};
use clearbeam::part::{Part, Placement, Units};
use clearbeam::sample::{solids::helical_gear, stl_bytes};
use criterion::{Criterion, criterion_group, criterion_main};
use std::time::Duration;

/// Surfaces that are cleaned.
const SURFACES: u32 = 2;

/// Some surfaces of the gear, so many that there are about 100 k samples of a spot of 1 mm.
fn dose(c: &mut Criterion) {
    let bytes = stl_bytes(&helical_gear(40, 8, 15, 4));
    let Ok(part) = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]) else { return };
    let Ok(setup) = Setup::shipped() else { return };
    let mut job = Job::default();
    job.clean.surfaces = Chosen::These((1..=SURFACES).collect());
    let surfaces = segmented(&part, &job);
    let Ok(plan) = job::plan(&part, &surfaces, &job, &setup, &Cache::default(), &Progress::default()) else { return };
    let run = || job::dose(&part, &surfaces, &plan, &job, &setup, &Progress::default());
    let Ok(map) = run() else { return };
    let lit = map.samples.iter().filter(|s| s.fluence_j_cm2 > 0.0).count();
    let name = format!("dose, {lit} samples in the light of {} pieces/100k", map.light.pieces.len());
    let mut group = c.benchmark_group("beam");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(5));
    group.bench_function(name, |b| b.iter(run));
    group.finish();
}

criterion_group!(benches, dose);
criterion_main!(benches);
