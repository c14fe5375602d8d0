//! The tilt of a beam against the surface normal, in two degrees of freedom, and what an operator
//! asks of it.
//!
//! A tilt is a turn from the normal: *lead* towards the travel direction (negative: lag), *lean* to
//! the right of it. Its length is the angle between beam and normal; its parts are those of an
//! azimuthal equidistant map, so that equal steps are equal angles near the normal.

use crate::part::{angle, keyed, keyed_words};
use nalgebra::{Vector2, Vector3};
use serde::{Deserialize, Serialize};

/// Lead and lean, degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Tilt {
    /// Towards the travel direction.
    pub lead_deg: f64,
    /// To the right of it.
    pub lean_deg: f64,
}

impl Tilt {
    /// As a vector (lead, lean), degrees.
    pub fn vector(self) -> Vector2<f64> {
        Vector2::new(self.lead_deg, self.lean_deg)
    }

    /// The angle between beam and normal, degrees.
    pub fn angle_deg(self) -> f64 {
        self.vector().norm()
    }

    /// The beam axis at a point with the unit normal `n`, travelling along `tangent`.
    pub fn axis(self, n: &Vector3<f64>, tangent: &Vector3<f64>) -> Vector3<f64> {
        let whole = self.angle_deg();
        if whole == 0.0 {
            return *n;
        }
        let (ahead, right) = frame(n, tangent);
        let way = (ahead * self.lead_deg + right * self.lean_deg) / whole;
        let (sin, cos) = (libm::sin(whole.to_radians()), libm::cos(whole.to_radians()));
        angle::unit(n * cos + way * sin).unwrap_or(*n)
    }

    /// The tilt of a beam axis `a`.
    pub fn of(a: &Vector3<f64>, n: &Vector3<f64>, tangent: &Vector3<f64>) -> Tilt {
        let whole = angle::between_deg(a, n);
        let (ahead, right) = frame(n, tangent);
        let (x, y) = (a.dot(&ahead), a.dot(&right));
        let flat = libm::hypot(x, y);
        if flat == 0.0 {
            return Tilt::default();
        }
        Tilt { lead_deg: whole * x / flat, lean_deg: whole * y / flat }
    }
}

/// Ahead and to the right on the surface, unit.
fn frame(n: &Vector3<f64>, tangent: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let ahead = angle::unit(tangent - n * n.dot(tangent)).unwrap_or_else(|| angle::any_square_to(n));
    (ahead, ahead.cross(n))
}

/// A side of the normal as seen along the travel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TiltSide {
    /// Ahead.
    Lead,
    /// Behind.
    Lag,
    /// To the left.
    Left,
    /// To the right.
    Right,
}

/// What a surface asks of the tilt.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TiltRule {
    /// The tilt to prefer to none; P3 asks for a small one against back reflection.
    pub preferred: Tilt,
    /// Least angle between beam and normal, degrees.
    pub least_deg: f64,
    /// Sides to which the beam must not be tilted by more than a degree.
    pub forbidden: Vec<TiltSide>,
}

/// Tilt to a side up to which a beam does not count as tilted to it, degrees.
const TO_A_SIDE_DEG: f64 = 1.0;

impl TiltRule {
    /// Whether the rule allows a tilt.
    pub fn allows(&self, tilt: Tilt) -> bool {
        let to = |side: &TiltSide| match side {
            TiltSide::Lead => tilt.lead_deg,
            TiltSide::Lag => -tilt.lead_deg,
            TiltSide::Left => -tilt.lean_deg,
            TiltSide::Right => tilt.lean_deg,
        };
        // A small tolerance: the tilt that was asked for is allowed, whatever the rounding.
        tilt.angle_deg() >= self.least_deg - 1e-6 && self.forbidden.iter().all(|side| to(side) <= TO_A_SIDE_DEG + 1e-6)
    }

    /// The tilt that is best where nothing is in the way: the preferred one, as steep as the rule asks;
    /// with no direction of its own the first of lead, lag, right and left that is allowed.
    pub fn aim(&self, max_tilt_deg: f64) -> Tilt {
        let whole = self.preferred.angle_deg();
        let wanted = whole.max(self.least_deg).min(max_tilt_deg);
        let scaled = |(lead, lean): (f64, f64)| Tilt { lead_deg: wanted * lead, lean_deg: wanted * lean };
        if wanted == whole && self.allows(self.preferred) {
            return self.preferred;
        }
        let own = (whole > 0.0).then(|| (self.preferred.lead_deg / whole, self.preferred.lean_deg / whole));
        let sides = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)];
        own.into_iter().chain(sides).map(scaled).find(|t| self.allows(*t)).unwrap_or(self.preferred)
    }
}

/// A tilt that the operator has set at a place of one line; the search keeps to it where it can.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pin {
    /// Line of the surface, from 0 in working order.
    pub line: u32,
    /// Place on the line, mm from its start.
    pub at_mm: f64,
    /// The tilt.
    pub tilt: Tilt,
}

keyed!(Tilt { lead_deg, lean_deg });
keyed_words!(TiltSide: Lead, Lag, Left, Right);
keyed!(TiltRule { preferred, least_deg, forbidden });
keyed!(Pin { line, at_mm, tilt });

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn there_and_back(lead in -80.0..80.0f64, lean in -80.0..80.0f64, v in prop::array::uniform6(-1.0..1.0f64)) {
            let (n, t) = (Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]));
            prop_assume!(n.norm() > 0.1 && n.cross(&t).norm() > 0.1);
            let n = n.normalize();
            let tilt = Tilt { lead_deg: lead, lean_deg: lean };
            prop_assume!(tilt.angle_deg() < 120.0);
            let a = tilt.axis(&n, &t);
            prop_assert!((angle::between_deg(&a, &n) - tilt.angle_deg()).abs() < 1e-6);
            prop_assert!((Tilt::of(&a, &n, &t).vector() - tilt.vector()).norm() < 1e-6);
        }
    }

    #[test]
    fn lead_is_ahead_and_lean_is_right() {
        let (n, o) = (Vector3::z(), Vector3::y());
        assert!(Tilt { lead_deg: 30.0, lean_deg: 0.0 }.axis(&n, &o).y > 0.4);
        assert!(Tilt { lead_deg: 0.0, lean_deg: 30.0 }.axis(&n, &o).x > 0.4);
    }
}
