//! A joint that starts at rest, runs up to its speed, and comes to rest again.

use crate::cell::Robot;

/// A way with a trapezoid of speed over time; a triangle where the way is too short for full speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trapezoid {
    /// Running up, and again slowing down, s.
    pub ramp_s: f64,
    /// From rest to rest, s.
    pub total_s: f64,
}

impl Trapezoid {
    /// Over `way` at most `speed`, with `acceleration`: all of one unit and positive.
    pub fn new(way: f64, speed: f64, acceleration: f64) -> Trapezoid {
        let way = way.abs();
        if way >= speed * speed / acceleration {
            let ramp_s = speed / acceleration;
            Trapezoid { ramp_s, total_s: way / speed + ramp_s }
        } else {
            let ramp_s = (way / acceleration).sqrt();
            Trapezoid { ramp_s, total_s: 2.0 * ramp_s }
        }
    }

    /// The slowest joint's, at so many per cent of full speed: it decides for all.
    pub fn slowest(robot: &Robot, from_deg: &[f64; 6], to_deg: &[f64; 6], percent: f64) -> Trapezoid {
        let rest = Trapezoid { ramp_s: 0.0, total_s: 0.0 };
        (0..6)
            .map(|i| {
                let full = robot.speeds_deg_s[i];
                Trapezoid::new(to_deg[i] - from_deg[i], full * percent / 100.0, full / robot.acceleration_s)
            })
            .fold(rest, |slowest, t| if t.total_s > slowest.total_s { t } else { slowest })
    }

    /// Share of the way that is done at a share of the time.
    pub fn share(&self, time_share: f64) -> f64 {
        let (t, end, ramp) = (time_share.clamp(0.0, 1.0) * self.total_s, self.total_s, self.ramp_s);
        // The area under the trapezoid, of height 1.
        let whole = end - ramp;
        if ramp <= 0.0 || whole <= 0.0 {
            return time_share.clamp(0.0, 1.0);
        }
        let done = if t < ramp {
            0.5 * t * t / ramp
        } else if t > end - ramp {
            whole - 0.5 * (end - t) * (end - t) / ramp
        } else {
            t - 0.5 * ramp
        };
        (done / whole).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn long_and_short_ways() {
        // 100° at 50°/s with 200°/s²: a quarter second up, 1.75 s even, a quarter down.
        let long = Trapezoid::new(-100.0, 50.0, 200.0);
        assert_eq!((long.ramp_s, long.total_s), (0.25, 2.25));
        // 8° at 200°/s²: up for 0.2 s to 40°/s, and down again.
        let short = Trapezoid::new(8.0, 50.0, 200.0);
        assert!((short.ramp_s - 0.2).abs() < 1e-12 && (short.total_s - 0.4).abs() < 1e-12);
        // Just reaching full speed is both.
        let edge = Trapezoid::new(12.5, 50.0, 200.0);
        assert!((edge.total_s - 2.0 * edge.ramp_s).abs() < 1e-12);
        assert_eq!(Trapezoid::new(0.0, 50.0, 200.0).total_s, 0.0);
        // While it runs up, s = a·t²/2: at 0.1 s one degree of the hundred.
        assert!((long.share(0.1 / 2.25) - 0.01).abs() < 1e-12);
        assert!((long.share(0.5) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn the_slowest_joint_decides() {
        let robot = Robot::load("mz04", None).expect("shipped");
        let (from, mut to) = ([0.0; 6], [0.0; 6]);
        (to[0], to[5]) = (96.0, 96.0);
        // J1: 48°/s at 10 %, 1920°/s²: 96/48 + 48/1920.
        let t = Trapezoid::slowest(&robot, &from, &to, 10.0);
        assert!((t.total_s - 2.025).abs() < 1e-12, "{t:?}");
    }

    proptest! {
        #[test]
        fn shares_grow_from_nothing_to_all(way in 0.0..400.0f64, a in 0.0..1.0f64, b in 0.0..1.0f64) {
            let t = Trapezoid::new(way, 90.0, 360.0);
            prop_assert!(t.share(0.0) == 0.0 && (t.share(1.0) - 1.0).abs() < 1e-12);
            prop_assert!(t.share(a.min(b)) <= t.share(a.max(b)) + 1e-12);
            prop_assert!((t.share(a) + t.share(1.0 - a) - 1.0).abs() < 1e-9, "the same backwards");
        }
    }
}
