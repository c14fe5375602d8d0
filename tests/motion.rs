//! The chain of joints: as cheap as the search over all pairs, within the rules, on the path, and the
//! reasons where there is none.

#[path = "common/all_pairs.rs"]
mod all_pairs;
#[path = "common/parts.rs"]
mod parts;

use clearbeam::cell::motion::{Arm, RefusalCause, RefusalReason, SearchHooks, TargetStateCache, choose, choose_again};
use clearbeam::cell::{BodyId, Contact, Link, Mount, Robot, Setup, Spin};
use clearbeam::part::angle;
use clearbeam::planning::{PlanCache, advice};
use clearbeam::pose::{Pass, TargetState};
use clearbeam::program::{Interpolation, Step};
use clearbeam::progress::Progress;
use nalgebra::Vector3;
use parts::{job, on, part, planned, planned_in, sample};

fn setup(robot: &str, mount: Mount) -> Setup {
    Setup {
        tool: clearbeam::beam::Tool::default(),
        robot: Some(Robot::load(robot, None).expect("shipped")),
        mount,
        ..Setup::shipped().expect("the shipped cell")
    }
}

/// A pass of its own, as many targets as asked for.
fn first(pass: &Pass, count: usize) -> Pass {
    let mut pass = pass.clone();
    pass.targets.truncate(count);
    pass
}

#[test]
fn the_chain_is_as_cheap_as_over_all_pairs() {
    let p = planned(part(&sample("workpiece")), on(job("z", 6.0), &[1, 2, 3]));
    let setup = setup("mz04", Mount::PartInHand);
    for spin in [Spin::Free, Spin::Travel] {
        let arm = Arm::new(&setup, spin).expect("a robot");
        for pass in p.plan.passes.iter().filter(|p| p.targets.iter().all(|t| t.state != TargetState::Blocked)).take(3) {
            let pass = first(pass, 14);
            let choice = choose(&arm, std::slice::from_ref(&pass), &SearchHooks::default()).expect("goes on");
            let seconds = all_pairs::seconds(&pass, 3.0);
            let chosen = all_pairs::cost_of(&arm, &choice, 0, &seconds);
            let least = all_pairs::cheapest(&arm, &pass, 20.0, 3.0);
            assert!((chosen - least).abs() < 1e-6 || chosen == least, "{spin:?}: {chosen} for {least}");
        }
    }
}

/// Joints of every row lead back to the focus and the beam of the target, inside the limits, and no
/// lit move breaks a rule.
fn holds(robot: &str, mount: Mount, spin: Spin, name: &str, spacing_mm: f64) {
    let setup = setup(robot, mount);
    let mut job = job("z", spacing_mm);
    job.cell.spin = spin;
    let p = planned_in(part(&sample(name)), job, &setup);
    let choice = p.plan.choice.as_ref().expect("a robot");
    let robot = setup.robot.as_ref().expect("a robot");
    let mut rows = 0;
    for (number, pass) in p.plan.passes.iter().enumerate() {
        for (point, t) in pass.targets.iter().enumerate() {
            let row = &choice.rows[number][point];
            assert_eq!(row.is_some(), t.state != TargetState::Blocked, "pass {number}, point {point}");
            let Some(c) = row else { continue };
            rows += 1;
            assert!(robot.beyond(&c.joints_deg).is_none());
            let focus = setup.focus_for(&robot.forward(&c.joints_deg));
            let wanted = t.frame(p.job.beam.defocus_mm);
            assert!((focus.translation.vector - wanted.translation.vector).norm() < 1e-6);
            assert!(angle::between_deg(&(focus.rotation * Vector3::z()), &t.a) < 1e-6);
            let o = angle::turned(&t.o, &t.a, c.spin_deg);
            assert!(angle::between_deg(&(focus.rotation * Vector3::y()), &o) < 1e-6);
            if spin == Spin::Travel {
                assert!(c.spin_deg == 0.0 || c.spin_deg == 180.0);
            }
            if t.laser {
                let before = choice.rows[number][point - 1].as_ref().expect("a lit move comes from somewhere");
                let seconds = (t.p - pass.targets[point - 1].p).norm() / p.job.beam.speed_mm_s;
                for j in 0..6 {
                    let moved = (c.joints_deg[j] - before.joints_deg[j]).abs();
                    assert!(moved <= 30.0 && moved <= robot.speeds_deg_s[j] * seconds + 1e-9);
                }
                assert_eq!(c.branch, before.branch, "no flip inside a pass");
            }
        }
    }
    assert!(rows > 100, "{rows} rows");
}

#[test]
fn joints_lead_to_the_targets_part_in_hand() {
    holds("mz04", Mount::PartInHand, Spin::Free, "workpiece", 4.0);
    holds("mz04", Mount::PartInHand, Spin::Travel, "workpiece", 4.0);
}

#[test]
fn joints_lead_to_the_targets_tool_in_hand() {
    holds("mz04", Mount::ToolInHand, Spin::Free, "workpiece", 4.0);
}

#[test]
fn joints_lead_to_the_targets_of_a_worm_gear() {
    holds("mz04", Mount::PartInHand, Spin::Free, "worm_gear", 3.0);
}

/// With the flange straight between two stops the spot stays within the deviation of its line.
#[test]
fn the_spot_keeps_to_its_line_where_the_flange_goes_straight() {
    let setup = setup("mz04", Mount::PartInHand);
    let mut job = on(job("z", 2.0), &[1, 2]);
    job.cell.deviation_mm = 0.01;
    let p = planned_in(part(&sample("worm_gear")), job, &setup);
    let defocus_mm = p.job.beam.defocus_mm;
    let (mut lit, mut between, mut worst) = (false, 0, 0.0_f64);
    let mut at = None;
    let mut line = None;
    for step in &p.plan.steps.list {
        match step {
            Step::Laser(on) => lit = *on,
            Step::Go(go) => {
                if lit {
                    assert_eq!(go.interpolation, Interpolation::Linear);
                    between += usize::from(go.target.is_none());
                    let (from, to) = (at.expect("comes from somewhere"), setup.flange_for(&go.to.frame()));
                    let spot =
                        |f: &nalgebra::Isometry3<f64>| f.translation.vector - f.rotation * Vector3::z() * defocus_mm;
                    let start: nalgebra::Isometry3<f64> = setup.focus_for(&from);
                    let (a, b) = (spot(&start), spot(&go.to.frame()));
                    line = Some((a, b));
                    for k in 1..16 {
                        let s = spot(&setup.focus_for(&from.lerp_slerp(&to, f64::from(k) / 16.0)));
                        let along = ((s - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
                        worst = worst.max((s - a - (b - a) * along).norm());
                    }
                }
                at = Some(setup.flange_for(&go.to.frame()));
            }
            Step::Comment(_) | Step::Home { .. } | Step::Process(_) => {}
        }
    }
    assert!(line.is_some() && between > 0, "{between} targets put in between");
    assert!(worst <= 0.01 * 1.01, "{worst} mm");
}

#[test]
fn what_cannot_be_done_says_why() {
    let mut far = setup("mz04", Mount::PartInHand);
    far.cell.base_from_laser.position_mm = [2000.0, 0.0, 300.0];
    let reach = planned_in(part(&sample("workpiece")), on(job("z", 8.0), &[1]), &far);
    assert!(!reach.plan.refusals.is_empty() && reach.plan.refusals.iter().all(|r| r.cause == RefusalCause::Reach));
    assert!(reach.plan.passes.iter().flat_map(|p| &p.targets).all(|t| t.state == TargetState::Blocked && !t.laser));

    let mut narrow = setup("mz04", Mount::PartInHand);
    narrow.robot.as_mut().expect("a robot").limits_deg[4] = [-20.0, 20.0];
    let limit = planned_in(part(&sample("workpiece")), on(job("z", 8.0), &[1]), &narrow);
    let refusals = limit.plan.refusals;
    assert!(
        refusals
            .iter()
            .any(|r| r.cause == RefusalCause::Limit && matches!(r.why, RefusalReason::JointLimit { joint: 5, .. })),
        "{refusals:?}"
    );

    let mut fast = on(job("z", 8.0), &[1]);
    fast.beam.speed_mm_s = 9000.0;
    let speed = planned_in(part(&sample("worm_gear")), fast, &setup("mz04", Mount::PartInHand));
    let refusals = speed.plan.refusals;
    assert!(
        refusals.iter().any(|r| r.cause == RefusalCause::Speed && matches!(r.why, RefusalReason::JointSpeed { .. })),
        "{refusals:?}"
    );
}

/// A contact is avoided where another spin avoids it, and named where none does.
#[test]
fn what_touches_is_avoided_or_named() {
    let setup = setup("mz04", Mount::PartInHand);
    let p = planned(part(&sample("workpiece")), on(job("z", 8.0), &[1]));
    let arm = Arm::new(&setup, Spin::Free).expect("a robot");
    let free = choose(&arm, &p.plan.passes, &SearchHooks::default()).expect("goes on");
    // A whole turn of J6 is the same pose, and touches the same.
    let is_left = |joints: &[f64; 6]| (joints[5] - 360.0 * (joints[5] / 360.0).floor()) < 180.0;
    let used: Vec<bool> = free.rows.iter().flatten().flatten().map(|c| is_left(&c.joints_deg)).collect();
    let mostly = used.iter().filter(|left| **left).count() * 2 > used.len();
    let half = move |joints: &[f64; 6]| {
        (is_left(joints) == mostly).then_some(Contact { a: BodyId::Link(Link::Forearm), b: BodyId::Part })
    };
    let avoided =
        choose(&arm, &p.plan.passes, &SearchHooks { touches: &half, ..SearchHooks::default() }).expect("goes on");
    assert!(avoided.rows.iter().flatten().flatten().all(|c| half(&c.joints_deg).is_none()));
    assert!(avoided.rows.iter().flatten().flatten().count() > used.len() / 2);
    let contact = Contact { a: BodyId::Part, b: BodyId::Head };
    let touching = SearchHooks { touches: &|_| Some(contact.clone()), ..SearchHooks::default() };
    let named = choose(&arm, &p.plan.passes, &touching).expect("goes on");
    let why = RefusalReason::Contact(contact.clone());
    assert!(named.refusals.iter().all(|r| r.cause == RefusalCause::Head && r.why == why));
    assert_eq!(named.rows.iter().flatten().flatten().count(), 0);
}

/// Branches are closed and targets blocked one after another: a search that goes on from the one before finds what one that
/// begins anew finds.
#[test]
fn a_search_goes_on_from_the_one_before() {
    let setup = setup("mz04", Mount::PartInHand);
    let p = planned(part(&sample("workpiece")), on(job("z", 1.5), &[1, 2, 3]));
    let arm = Arm::new(&setup, Spin::Free).expect("a robot");
    let mut passes = p.plan.passes.clone();
    let targets: usize = passes.iter().map(|p| p.targets.len()).sum();
    assert!(targets > 300, "{targets}: many chunks");
    let (mut known, mut closed) = (TargetStateCache::default(), std::collections::BTreeSet::new());
    let mut last = choose_again(&arm, &passes, &SearchHooks::default(), &mut known).expect("goes on");
    let count = passes.len();
    for (turn, pass) in [count / 2, 1, count - 1, count / 3, count / 2].into_iter().enumerate() {
        if turn == 3 {
            passes[pass].targets[1].state = TargetState::Blocked;
        }
        closed.extend(last.rows[pass].iter().flatten().map(|c| (pass, c.branch)));
        let is_open = |pass: usize, branch: u8| !closed.contains(&(pass, branch));
        let hooks = SearchHooks { is_open: &is_open, ..SearchHooks::default() };
        last = choose_again(&arm, &passes, &hooks, &mut known).expect("goes on");
        assert_eq!(last, choose(&arm, &passes, &hooks).expect("goes on"), "{turn}");
    }
}

/// What is offered as a better set-up has been planned, and is what a plan with it gives.
#[test]
fn a_better_setup_refuses_as_few_as_it_says() {
    let mut far = setup("mz04", Mount::PartInHand);
    far.cell.base_from_laser = clearbeam::cell::Frame::new([700.0, 0.0, 300.0], [0.0; 3]);
    let p = planned_in(part(&sample("workpiece")), on(job("z", 10.0), &[1, 2, 3]), &far);
    let before = p.plan.refusals.len();
    assert!(before > 10, "{before} refused");
    let progress = Progress::default();
    assert!(!advice::suggestions(&p.part, &p.plan, &p.job, &far, &progress).expect("goes on").is_empty());
    let found = advice::better_setup(&p.part, &p.surfaces, &p.plan, &p.job, &far, &PlanCache::default(), &progress);
    let (better, left) = found.expect("goes on").expect("something better");
    assert!(left < before / 10, "{left} of {before}");
    let mut moved = far.clone();
    advice::applied(&p.job.cell, Mount::PartInHand, &better).put_frames(&mut moved.cell);
    let again = planned_in(part(&sample("workpiece")), p.job.clone(), &moved);
    assert_eq!(again.plan.refusals.len(), left);
}

#[test]
fn any_number_of_threads_gives_the_same() {
    let setup = setup("mz04", Mount::PartInHand);
    let plan = || planned_in(part(&sample("workpiece")), on(job("z", 5.0), &[1, 2]), &setup).plan;
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().expect("threads");
    let (one, three) = (pool(1).install(plan), pool(3).install(plan));
    assert_eq!(one.choice, three.choice);
    assert_eq!(one.steps, three.steps);
}
