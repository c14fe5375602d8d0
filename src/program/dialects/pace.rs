//! Times and speeds that a controller's words can say: a program is planned with these, so that nothing is rounded when
//! it is written. A move is never made faster by that; where the words end before, it is slower.

use super::flange::{SHORTEST_S, Speeds, Travel, as_read, printed_flange_at};
use crate::cell::Setup;
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use nalgebra::Isometry3;

/// So much of the last digit is rounding: what was on the grid before stays there.
const ROUNDING: f64 = 1e-5;

/// The least number of so many decimals that is not below `value`.
pub fn at_least(value: f64, decimals: usize) -> f64 {
    (value * scale(decimals) - ROUNDING).ceil() / scale(decimals)
}

/// The greatest number of so many decimals that is not above `value`.
pub fn at_most(value: f64, decimals: usize) -> f64 {
    (value * scale(decimals) + ROUNDING).floor() / scale(decimals)
}

fn scale(decimals: usize) -> f64 {
    (0..decimals).fold(1.0, |scale, _| scale * 10.0)
}

/// The paces of all moves, each by itself.
pub fn each(lines: &[ProgramLine], pace: impl FnMut(&Move) -> MoveTiming) -> Vec<MoveTiming> {
    let moves = lines.iter().filter_map(|l| if let ProgramLine::Move(m) = l { Some(&**m) } else { None });
    moves.map(pace).collect()
}

/// A time of so many decimals in seconds, for controllers that are told times.
pub fn seconds(s: f64, decimals: usize) -> MoveTiming {
    MoveTiming::Seconds(at_least(s.max(SHORTEST_S), decimals))
}

/// Per cent of so many decimals, the last of them at least.
pub fn percent(p: f64, decimals: usize) -> MoveTiming {
    MoveTiming::Percent(at_most(p.min(100.0), decimals).max(1.0 / scale(decimals)))
}

/// The words of a controller that is told speeds of the flange.
#[derive(Clone, Copy, Debug)]
pub struct FlangeWords {
    /// The greatest speeds.
    pub most: Speeds,
    /// Decimals of speeds, in mm/s and degrees per second.
    pub decimals: usize,
    /// Decimals of per cents.
    pub percent_decimals: usize,
}

impl FlangeWords {
    /// The paces of all moves, from where each one begins as the controller will know it.
    pub fn paces(&self, lines: &[ProgramLine], setup: &Setup) -> Vec<MoveTiming> {
        let mut at = None;
        each(lines, |m| {
            let from = std::mem::replace(&mut at, read_at(setup, m));
            match (m.timing, from, at) {
                (MoveTiming::Percent(p), ..) => percent(p, self.percent_decimals),
                (MoveTiming::Seconds(s), Some(from), Some(to)) => {
                    MoveTiming::Seconds(self.seconds(&Travel::between(&from, &to), s))
                }
                (timing, ..) => timing,
            }
        })
    }

    fn seconds(&self, travel: &Travel, seconds: f64) -> f64 {
        // What the greatest speeds need comes first: the digits are those of the speed that is left.
        let Speeds { mm_s, deg_s } = travel.speeds(seconds.max(travel.seconds(self.most)), self.most);
        travel.seconds(Speeds { mm_s: at_most(mm_s, self.decimals), deg_s: at_most(deg_s, self.decimals) })
    }
}

/// Where a reader will know the flange to be behind a move: angles and poses as they are printed.
pub fn read_at(setup: &Setup, m: &Move) -> Option<Isometry3<f64>> {
    match (m.interpolation, &m.joints_deg, &m.base_from_flange) {
        (Interpolation::Joint, Some(joints), _) => printed_flange_at(setup, joints),
        (_, _, flange) => flange.as_ref().map(as_read),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_on_the_grid_stays(value in 0.0..40.0f64, decimals in 0..6usize, way in 0.001..50.0f64) {
            let (slow, fast) = (at_least(value, decimals), at_most(value, decimals));
            let step = 1.0 / scale(decimals);
            prop_assert!(slow >= value - 1e-4 * step && slow < value + step);
            prop_assert!(fast <= value + 1e-4 * step && fast > value - step);
            prop_assert_eq!((at_least(slow, decimals), at_most(fast, decimals)), (slow, fast));
            // A speed of the grid makes a time, and that time the same speed.
            if fast > 0.0 {
                prop_assert_eq!(at_most(way / (way / fast), decimals), fast);
            }
        }

        /// Slower at most by a digit or by the greatest speed; and a move that has its pace keeps it.
        #[test]
        fn a_move_is_never_faster(mm in 0.0..40.0f64, deg in 0.0..40.0f64, seconds in 0.002..10.0f64) {
            let words = FlangeWords { most: Speeds { mm_s: 2000.0, deg_s: 200.0 }, decimals: 5, percent_decimals: 0 };
            let travel = Travel { mm, deg };
            let paced = words.seconds(&travel, seconds);
            prop_assert!(paced >= seconds * (1.0 - 1e-9) || mm < 1e-4 * seconds && deg < 1e-4 * seconds);
            prop_assert!(paced >= deg / 200.0 - 1e-9 && paced >= mm / 2000.0 - 1e-9);
            prop_assert!(paced <= seconds.max(deg / 200.0 + 1e-9).max(mm / 2000.0) * 1.001 || mm.max(deg) < 0.1);
            prop_assert!((words.seconds(&travel, paced) - paced).abs() <= 1e-9 * paced);
        }
    }
}
