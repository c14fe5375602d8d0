//! What the pipeline itself costs an edit, and when the first picture of one is there, on one helical gear of
//! 100 k facets with all of its surfaces chosen.
//!
//! `own cost`: from an edit of the job until all work is on its way, with an executor that does none of it.
//! `at rest`: a frame in which nothing has changed. `first lines`: from an edit until the lines are there to be
//! drawn, beside the stage that lays them, called by itself.

use clearbeam::document::{Chosen, Job, segmented};
use clearbeam::part::{Part, Placement, Source, Units};
use clearbeam::planning::{AtOnce, Executor, Pipeline, PlanCache, Task, preview};
use clearbeam::progress::{Activity, Progress};
use clearbeam::sample::solids::helical_gear;
use clearbeam::sample::stl_bytes;
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Does the work at once until it is told to do none.
#[derive(Default)]
struct Once {
    is_over: AtomicBool,
}

impl Executor for Once {
    fn start(&self, task: Task) {
        if !self.is_over.load(Ordering::Relaxed) {
            task.run();
        }
    }
}

fn pipeline(c: &mut Criterion) {
    let bytes = stl_bytes(&helical_gear(40, 8, 15, 4));
    let Ok(source) = Source::from_bytes(&bytes) else { return };
    let source = Arc::new(source);
    let mut job = Job::default();
    job.layers.direction = clearbeam::path::Direction::AXES[2].1;
    job.settings.choose(Chosen::All);
    job.layers.spacing_mm = 8.0;
    let mut group = c.benchmark_group("pipeline");
    let once = Arc::new(Once::default());
    let mut pipeline = Pipeline::new(once.clone(), true);
    pipeline.open(source.clone(), None);
    pipeline.sync(&job, None);
    group.bench_function("at rest", |b| b.iter(|| black_box(pipeline.sync(&job, None))));
    once.is_over.store(true, Ordering::Relaxed);
    group.bench_function("own cost", |b| {
        b.iter(|| {
            job.beam.power_w = if job.beam.power_w > 450.0 { 400.0 } else { 500.0 };
            black_box(pipeline.sync(&job, None))
        });
    });
    let Ok(part) = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]) else { return };
    let (surfaces, progress) = (segmented(&part, &job), Progress::default());
    group.sample_size(20);
    let other = |job: &mut Job| job.layers.spacing_mm = if job.layers.spacing_mm > 8.0 { 8.0 } else { 9.0 };
    group.bench_function("lines by themselves", |b| {
        b.iter(|| {
            other(&mut job);
            // Lines that were laid are kept until there is a plan: each edit is to lay its own.
            black_box(preview(&part, &surfaces, &job, &PlanCache::default(), &progress).is_ok())
        });
    });
    let laying = Arc::new(LinesAlone);
    let mut pipeline = Pipeline::new(laying, true);
    pipeline.open(source, None);
    pipeline.sync(&job, None);
    group.bench_function("first lines", |b| {
        b.iter(|| {
            other(&mut job);
            pipeline.cache = Arc::default();
            pipeline.sync(&job, None);
            black_box(pipeline.lines().is_some())
        });
    });
    group.finish();
}

/// Does all work but the plan.
struct LinesAlone;

impl Executor for LinesAlone {
    fn start(&self, task: Task) {
        if task.stage() != Activity::Planning {
            AtOnce.start(task);
        }
    }
}

criterion_group!(benches, pipeline);
criterion_main!(benches);
