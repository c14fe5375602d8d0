//! Spins and branches of 10 000 targets, all 72 spins, beside the search over all pairs (what descartes
//! does) on fewer of the same targets, and the closed inverse beside `rs-opw-kinematics`.
//!
//! `cargo bench --bench motion`. Compare figures of one sitting only.

#[path = "../tests/common/all_pairs.rs"]
mod all_pairs;

use clearbeam::beam::ProcessSettings;
use clearbeam::cell::motion::{Arm, ArmState, SearchHooks, choose};
use clearbeam::cell::{Robot, Setup, Spin};
use clearbeam::part::{Part, Placement, Units};
use clearbeam::pose::{self, Pass, Target};
use clearbeam::sample::{SAMPLES, stl_bytes};
use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Point3, Vector3};
use rs_opw_kinematics::glam::{DQuat, DVec3};
use rs_opw_kinematics::kinematic_traits::Kinematics as _;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use rs_opw_kinematics::pose::Pose;
use std::hint::black_box;
use std::time::Duration;

const TARGETS: usize = 10_000;
/// Targets of the search over all pairs: it takes minutes for all of them.
const PAIRED: usize = 100;
const DEFOCUS_MM: f64 = 20.0;
const SPEED_MM_S: f64 = 3.0;

/// Lines over a shallow dome that looks along −y, 100 targets each.
fn passes(count: usize) -> Vec<Pass> {
    let target = |i: usize| {
        let (line, along) = (i / 100, i % 100);
        let (x, z) = (along as f64 * 0.8 - 40.0, (line % 100) as f64 * 0.5);
        let n = Vector3::new(x / 120.0, -1.0, (z - 25.0) / 120.0).normalize();
        let p = Point3::new(x, 120.0 * n.y + 110.0, z);
        let o = pose::target::travel(&Vector3::x(), &n);
        Target {
            p,
            n,
            foot: p,
            a: n,
            o,
            state: pose::TargetState::Free,
            laser: along > 0,
            normal_hits: None,
            clearance_mm: None,
        }
    };
    let line = |k: usize| Pass {
        surface: 1,
        settings: ProcessSettings::default(),
        plane_normal: Vector3::z(),
        closed: false,
        targets: (k * 100..(k + 1) * 100).map(target).collect(),
        line_points: 100,
        dense_points: 100,
        chord_error_mm: 0.0,
        splits: Vec::new(),
    };
    (0..count / 100).map(line).collect()
}

fn motion(c: &mut Criterion) {
    let Ok(mut setup) = Setup::shipped() else { return };
    let Ok(robot) = Robot::load("mz04", None) else { return };
    setup.robot = Some(robot.clone());
    let Some(arm) = Arm::new(&setup, Spin::Free) else { return };
    let mut group = c.benchmark_group("motion");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(3));
    let all = passes(TARGETS);
    let Some(choice) = choose(&arm, &all, &SearchHooks::default()) else { return };
    let states = |t: &Target| arm.states(&t.frame(DEFOCUS_MM)).map_or(0, |s| s.len());
    let count: usize = all.iter().flat_map(|p| &p.targets).map(states).sum();
    println!("{} targets refused, {} states a target", choice.refusals.len(), count / TARGETS);
    group.bench_function("chain, 10 000 targets x 72 spins", |b| {
        b.iter(|| choose(&arm, &all, &SearchHooks::default()));
    });
    let few = passes(PAIRED);
    group.bench_function("chain, 100 targets x 72 spins", |b| {
        b.iter(|| choose(&arm, &few, &SearchHooks::default()));
    });
    group.bench_function("all pairs, 100 targets x 72 spins", |b| {
        b.iter(|| all_pairs::cheapest(&arm, &few[0], DEFOCUS_MM, SPEED_MM_S));
    });
    let states: Vec<Vec<ArmState>> =
        few[0].targets.iter().map(|t| arm.states(&t.frame(DEFOCUS_MM)).unwrap_or_default()).collect();
    let seconds = all_pairs::seconds(&few[0], SPEED_MM_S);
    group.bench_function("all pairs, states given", |b| {
        b.iter(|| all_pairs::cheapest_of(&arm, black_box(&states), &seconds));
    });
    let poses: Vec<_> = all.iter().flat_map(|p| &p.targets).map(|t| setup.flange_for(&t.frame(DEFOCUS_MM))).collect();
    group.bench_function("inverse, 10 000 poses", |b| {
        b.iter(|| poses.iter().filter(|p| robot.inverse(p)[0].is_some()).count());
    });
    let peer = OPWKinematics::new(Parameters {
        a1: 0.0,
        a2: -0.025,
        b: 0.0,
        c1: 0.340,
        c2: 0.260,
        c3: 0.280,
        c4: 0.072,
        offsets: [0.0, -90.0, -90.0, 0.0, 0.0, 180.0].map(f64::to_radians),
        sign_corrections: [1, -1, -1, 1, -1, 1],
        dof: 6,
    });
    let poses: Vec<Pose> = poses
        .iter()
        .map(|p| {
            let (at, q) = (p.translation.vector / 1000.0, p.rotation);
            Pose { translation: DVec3::new(at.x, at.y, at.z), rotation: DQuat::from_xyzw(q.i, q.j, q.k, q.w) }
        })
        .collect();
    group.bench_function("inverse of rs-opw-kinematics, 10 000 poses", |b| {
        b.iter(|| poses.iter().filter(|p| !peer.inverse(p).is_empty()).count());
    });
    group.finish();
    whole(c, &setup);
}

/// The worm gear sample from its passes to the driven program.
fn whole(c: &mut Criterion, setup: &Setup) {
    use clearbeam::document::{Chosen, Job, segmented};
    use clearbeam::planning::{PlanCache, plan};
    use clearbeam::progress::Progress;
    let Some(gear) = SAMPLES.iter().find(|s| s.name == "worm_gear") else { return };
    let bytes = stl_bytes(&(gear.triangles)());
    let Ok(part) = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]) else { return };
    let mut job = Job::default();
    job.layers.direction = clearbeam::path::Direction::AXES[2].1;
    job.settings.choose(Chosen::All);
    job.layers.spacing_mm = 2.0;
    let surfaces = segmented(&part, &job);
    let mut group = c.benchmark_group("motion");
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    group.bench_function("plan of the worm gear with a robot", |b| {
        b.iter(|| plan(&part, &surfaces, &job, setup, &PlanCache::default(), &Progress::default()));
    });
    group.finish();
}

criterion_group!(benches, motion);
criterion_main!(benches);
