//! What a program takes: trapezoids, waits, moments and curves against figures worked out by hand.

use super::*;
use crate::cell::{Collision, Timing};
use crate::part::{Part, Placement, Units};
use crate::program::neutral::steps::{Go, Station, Step};
use crate::program::{clearances, curves};
use crate::sample::{solids, stl_bytes};
use nalgebra::{Point3, Vector3};

/// The MZ04 in its shipped cell; laser and controller answer after known times.
fn setup() -> Setup {
    let mut setup = Setup::shipped().expect("valid");
    setup.robot = Some(Robot::load("mz04", None).expect("shipped"));
    setup.cell.timing = Timing { laser_on_s: 0.5, laser_off_s: 0.25, move_s: 0.125, ..Timing::default() };
    setup
}

/// Stations on a line of the part, 10 mm apart, the beam onto its side.
fn station(i: usize, spin_deg: f64) -> Station {
    let (sin, cos) = libm::sincos(spin_deg.to_radians());
    Station { x: Point3::new(30.0, 0.0, 10.0 * i as f64), a: Vector3::x(), o: Vector3::new(0.0, cos, sin) }
}

fn joints(setup: &Setup, station: &Station) -> Option<Joints> {
    setup.robot.as_ref()?.nearest_inverse(&setup.flange_for(&station.frame()), &setup.home_joints_deg())
}

fn go(i: usize, interpolation: Interpolation, timing: MoveTiming, target: Option<(usize, usize)>) -> Step {
    let setup = setup();
    // The first spin at which the arm gets to all of them.
    let spins = (0..36).map(|k| 10.0 * f64::from(k));
    let spin_deg = spins.into_iter().find(|spin| (0..4).all(|i| joints(&setup, &station(i, *spin)).is_some()));
    let to = station(i, spin_deg.expect("within reach"));
    Step::Go(Go { to, interpolation, joints_deg: joints(&setup, &to), timing, target })
}

/// Home, out to the part by joints, two lit moves of 2 s, off, back by joints.
fn program() -> Steps {
    let list = vec![
        Step::Home { percent: 10.0 },
        go(0, Interpolation::Joint, MoveTiming::Percent(10.0), None),
        go(1, Interpolation::Linear, MoveTiming::Seconds(1.0), Some((0, 0))),
        Step::Laser(true),
        go(2, Interpolation::Linear, MoveTiming::Seconds(2.0), Some((0, 1))),
        go(3, Interpolation::Linear, MoveTiming::Seconds(2.0), Some((0, 2))),
        Step::Laser(false),
        Step::Home { percent: 10.0 },
    ];
    Steps { list, ..Steps::default() }
}

#[test]
fn without_a_robot_there_is_none() {
    assert!(Timeline::new(&program(), &Setup { robot: None, ..setup() }).is_none());
    let mut poses = program();
    if let Step::Go(go) = &mut poses.list[4] {
        go.joints_deg = None;
    }
    assert!(Timeline::new(&poses, &setup()).is_none(), "a pose alone does not say how the arm stands");
}

#[test]
fn the_times_add_up() {
    let t = Timeline::new(&program(), &setup()).expect("reachable");
    let s = t.stops();
    assert_eq!(s.len(), 6);
    assert_eq!(s.iter().map(|s| s.lit).collect::<Vec<_>>(), [false, false, false, true, true, false]);
    assert_eq!((s[0].at_s, s[0].waiting_s), (0.0, 0.0));
    // The controller's answer; laser on and the controller's; blended; laser off and the controller's.
    assert_eq!(s.iter().map(|s| s.waiting_s).collect::<Vec<_>>(), [0.0, 0.125, 0.0, 0.625, 0.0, 0.375]);
    let b = t.breakdown();
    assert!((b.work_s - 4.0).abs() < 1e-12 && (b.waiting_s - 1.125).abs() < 1e-12, "{b:?}");
    let slowest =
        |a: &TimelineStop, b: &TimelineStop| Trapezoid::slowest(t.robot(), &a.joints_deg, &b.joints_deg, 10.0).total_s;
    let travel_s = slowest(&s[0], &s[1]) + 1.0 + slowest(&s[4], &s[5]);
    assert!((b.travel_s - travel_s).abs() < 1e-12);
    assert!((b.work_s + b.travel_s + b.waiting_s - t.total_s()).abs() < 1e-9);
    let lit = t.lit_stretches();
    assert_eq!(lit.len(), 1, "{lit:?}");
    assert!((lit[0][0] - (s[2].at_s + 0.625)).abs() < 1e-12 && lit[0][1] == s[4].at_s);
}

#[test]
fn a_moment_at_the_end_of_a_move_is_its_stop() {
    let t = Timeline::new(&program(), &setup()).expect("reachable");
    for (i, stop) in t.stops().iter().enumerate() {
        let end = t.moment(stop.at_s);
        assert_eq!((end.joints_deg, end.stop), (stop.joints_deg, i));
        assert_eq!(end.lit, stop.lit);
        // While it waits and as it begins, it is where the last move ended.
        if i > 0 {
            let before = t.stops()[i - 1];
            for time_s in [stop.at_s - stop.seconds, before.at_s + 0.5 * stop.waiting_s] {
                let m = t.moment(time_s);
                let off = (0..6).map(|k| (m.joints_deg[k] - before.joints_deg[k]).abs()).fold(0.0, f64::max);
                assert!(off < 1e-9, "stop {i}: {off}");
            }
        }
    }
    let (start, end) = (t.moment(-1.0), t.moment(1e9));
    assert_eq!((start.stop, end.stop, start.lit, end.lit), (0, 5, false, false));
    assert_eq!(end.joints_deg, t.setup().home_joints_deg());
}

#[test]
fn straight_moves_carry_the_spot_evenly_and_joint_moves_the_joints() {
    let t = Timeline::new(&program(), &setup()).expect("reachable");
    let s = t.stops();
    // The part does not turn here, so the focus goes straight with the flange.
    for share in [0.1, 0.25, 0.5, 0.8] {
        let m = t.moment(s[3].at_s - s[3].seconds + share * s[3].seconds);
        assert!(m.lit);
        let x = m.part_from_focus.translation.vector;
        assert!((x - Vector3::new(30.0, 0.0, 10.0 + 10.0 * share)).norm() < 1e-6, "{x}");
        let at = t.robot().forward(&m.joints_deg);
        assert!((at.translation.vector - m.base_from_flange.translation.vector).norm() < 1e-6);
        assert!(at.rotation.angle_to(&m.base_from_flange.rotation) < 1e-8);
    }
    // Half the time of a trapezoid is half the way, for every joint.
    let m = t.moment(s[1].at_s - 0.5 * s[1].seconds);
    for k in 0..6 {
        assert!((m.joints_deg[k] - 0.5 * (s[0].joints_deg[k] + s[1].joints_deg[k])).abs() < 1e-9);
    }
}

#[test]
fn clearance_is_looked_at_from_the_first_moment_to_the_last() {
    let setup = setup();
    let t = Timeline::new(&program(), &setup).expect("reachable");
    let curve = curves(&t);
    let ball = Part::from_bytes(&stl_bytes(&solids::sphere(10.0, 12, 6)), Units::Mm, &Placement::default(), &[]);
    let ball = ball.expect("a part");
    let collision = Collision::new(&setup, &ball).expect("a robot");
    for samples in [&curve[..], &curve[..1], &[]] {
        let looked = clearances(samples, &collision, &crate::progress::Progress::default()).expect("nobody cancels");
        assert!(looked.len() <= 2000 && looked.is_empty() == samples.is_empty());
        let ends = [looked.first(), looked.last()].map(|c| c.map(|c| c.time_s));
        assert_eq!(ends, [samples.first(), samples.last()].map(|s| s.map(|s| s.time_s)));
        for c in &looked {
            let sample = samples.iter().find(|s| s.time_s == c.time_s).expect("a moment of the curves");
            assert_eq!(c.nearest, collision.clearance(&sample.joints_deg));
        }
    }
}

#[test]
fn curves_pass_through_every_stop_and_keep_to_full_speed() {
    let t = Timeline::new(&program(), &setup()).expect("reachable");
    let curve = curves(&t);
    assert!(curve.windows(2).all(|w| w[0].time_s <= w[1].time_s));
    for stop in t.stops() {
        assert!(curve.iter().any(|s| s.time_s == stop.at_s && s.joints_deg == stop.joints_deg));
    }
    for s in curve.iter().filter(|s| s.time_s <= t.stops()[1].at_s) {
        for k in 0..6 {
            assert!(s.speeds_deg_s[k].abs() <= 0.1 * t.robot().speeds_deg_s[k] + 1e-6, "J{} at {} s", k + 1, s.time_s);
        }
    }
    let fastest = (0..6)
        .map(|k| curve.iter().map(|s| s.speeds_deg_s[k].abs()).fold(0.0, f64::max) / t.robot().speeds_deg_s[k])
        .fold(0.0, f64::max);
    assert!((fastest - 0.1).abs() < 1e-3, "a long move reaches its 10 %: {fastest}");
}
