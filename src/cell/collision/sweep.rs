//! Contacts on the way from one pose of the robot to another: looked at so often that nothing moves farther than the
//! margin between two looks, so that what is free at both cannot touch between them.
//!
//! The way of a point against another body, standing or moving, is that of the joints between the two alone, each by no
//! more than its lever: so the sum over all joints bounds two links of the arm as well.

use super::{Collision, Contact, MOST_OWN_MARGIN_MM};
use crate::cell::Joints;

/// A joint move is looked at this often at most; two turns of all joints of a large arm need a tenth.
const MOST_LOOKS: f64 = 1e6;

/// A sixteenth of a path is halved so often at most: a jump in the joints never gets short.
const HALVINGS: u32 = 10;

impl Collision<'_> {
    /// The first contact on a joint move, and where it is: 0 at `from`, 1 at `to`.
    pub fn first_contact_between(&self, from: &Joints, to: &Joints) -> Option<(f64, Contact)> {
        let pieces = (self.travel_mm(from, to) / self.look_mm()).ceil().clamp(1.0, MOST_LOOKS) as u32;
        (0..=pieces).find_map(|i| {
            let t = f64::from(i) / f64::from(pieces);
            let joints: Joints = std::array::from_fn(|k| from[k] + (to[k] - from[k]) * t);
            Some((t, self.first_contact(&joints)?))
        })
    }

    /// The first contact on a motion of the joints given over 0 to 1, and where on it; they may not turn back within a
    /// sixteenth of it.
    pub fn first_contact_along(&self, at: impl Fn(f64) -> Joints) -> Option<(f64, Contact)> {
        let start = at(0.0);
        if let Some(contact) = self.first_contact(&start) {
            return Some((0.0, contact));
        }
        let piece = |i: u32| f64::from(i) / 16.0;
        let mut here = start;
        (0..16).find_map(|i| {
            let ends = [(piece(i), here), (piece(i + 1), at(piece(i + 1)))];
            here = ends[1].1;
            self.first_contact_within(&at, ends, HALVINGS)
        })
    }

    /// The first contact on a piece of the motion whose start is free.
    fn first_contact_within(
        &self,
        at: &impl Fn(f64) -> Joints,
        [from, to]: [(f64, Joints); 2],
        halvings: u32,
    ) -> Option<(f64, Contact)> {
        if halvings == 0 || self.travel_mm(&from.1, &to.1) <= self.look_mm() {
            return Some((to.0, self.first_contact(&to.1)?));
        }
        let t = 0.5 * (from.0 + to.0);
        let middle = (t, at(t));
        self.first_contact_within(at, [from, middle], halvings - 1)
            .or_else(|| self.first_contact_within(at, [middle, to], halvings - 1))
    }

    /// How far any point of arm and load moves between two poses, at most, mm.
    pub fn travel_mm(&self, from: &Joints, to: &Joints) -> f64 {
        (0..6).map(|i| (to[i] - from[i]).abs().to_radians() * self.levers_mm[i]).sum()
    }

    /// How far anything may move between two looks, mm. The nearer look is half of that away, which links that keep
    /// less than the margin from each other must not lose either.
    fn look_mm(&self) -> f64 {
        self.margin_mm.min(2.0 * MOST_OWN_MARGIN_MM)
    }
}
