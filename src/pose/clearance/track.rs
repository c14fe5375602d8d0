//! A line as the search sees it: at every point the normal with two directions that are carried along
//! without turning about it, so that a tilt that stays the same is a beam that turns only as the
//! normal does.
//!
//! Tilts are vectors in that frame, degrees, azimuthal equidistant: the angle between two beams is at
//! most the length of their difference.

use crate::part::angle;
use crate::path::DensePoint;
use crate::pose::tilt::{Pin, Tilt, TiltRule};
use crate::pose::{LineRules, Pose};
use nalgebra::{Vector2, Vector3};

/// A tilt in the carried frame, degrees.
pub type TiltVector = Vector2<f64>;

/// A pin draws the beam this far to either side of its place, mm, and farther where the beam cannot
/// turn back in less.
const PIN_MM: f64 = 2.0;
/// Share of the allowed rate that pins and the search use; the rest is for rounding.
pub const RATE_SHARE: f64 = 0.98;
/// Weight of a degree away from the aim at a pin; elsewhere it is 1.
const PIN_PULL: f64 = 20.0;

/// A point of the line.
#[derive(Clone, Copy, Debug)]
pub struct Site {
    /// Point and normal.
    pub q: DensePoint,
    /// First direction of the frame, unit, square to the normal.
    e1: Vector3<f64>,
    /// Second.
    e2: Vector3<f64>,
    /// From the frame's first direction to the travel: cosine and sine.
    travel: (f64, f64),
    /// Along the line, mm.
    pub arc_mm: f64,
    /// What the surface's rule prefers.
    pub base: TiltVector,
    /// What rule and pins together prefer.
    pub aim: TiltVector,
    /// How much a degree away from the aim weighs.
    pub pull: f64,
}

impl Site {
    /// The beam axis of a tilt.
    pub fn axis(&self, tilt: &TiltVector) -> Vector3<f64> {
        let whole = tilt.norm();
        if whole == 0.0 {
            return self.q.n;
        }
        let (sin, cos) = (libm::sin(whole.to_radians()), libm::cos(whole.to_radians()));
        angle::unit(self.q.n * cos + (self.e1 * tilt.x + self.e2 * tilt.y) * (sin / whole)).unwrap_or(self.q.n)
    }

    /// The pose of the beam with a tilt.
    pub fn pose(&self, tilt: &TiltVector) -> Pose {
        Pose { p: self.q.p, a: self.axis(tilt) }
    }

    /// The tilt of a beam axis.
    pub fn tilt_of(&self, axis: &Vector3<f64>) -> TiltVector {
        let flat = TiltVector::new(axis.dot(&self.e1), axis.dot(&self.e2));
        flat.try_normalize(1e-12).map_or_else(TiltVector::zeros, |d| d * angle::between_deg(axis, &self.q.n))
    }

    /// As lead and lean.
    fn seen(&self, tilt: &TiltVector) -> Tilt {
        let (cos, sin) = self.travel;
        Tilt { lead_deg: tilt.x * cos + tilt.y * sin, lean_deg: tilt.y * cos - tilt.x * sin }
    }

    fn carried(&self, tilt: Tilt) -> TiltVector {
        let (cos, sin) = self.travel;
        TiltVector::new(tilt.lead_deg * cos - tilt.lean_deg * sin, tilt.lead_deg * sin + tilt.lean_deg * cos)
    }

    /// The place at a share of the way to the next.
    pub fn midway(&self, next: &Site, t: f64) -> Site {
        let q = crate::path::dense::midway(&self.q, &next.q, t);
        let (e1, e2) = carried_frame(self, &q.n);
        let mix = |a: f64, b: f64| a + (b - a) * t;
        Site {
            q,
            e1,
            e2,
            arc_mm: mix(self.arc_mm, next.arc_mm),
            base: self.base.lerp(&next.base, t),
            aim: self.aim.lerp(&next.aim, t),
            pull: mix(self.pull, next.pull),
            ..*self
        }
    }
}

fn carried_frame(from: &Site, n: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let turned = if from.q.n == *n { from.e1 } else { angle::rotation_between(&from.q.n, n) * from.e1 };
    let e1 = angle::unit(turned - n * n.dot(&turned)).unwrap_or_else(|| angle::any_square_to(n));
    (e1, e1.cross(n))
}

/// The line.
#[derive(Clone, Debug)]
pub struct Track<'a> {
    /// Its points.
    pub sites: Vec<Site>,
    /// What the surface asks.
    pub rule: &'a TiltRule,
    /// Greatest tilt, degrees.
    pub max_tilt_deg: f64,
    /// How fast the tilt may change, degrees/mm.
    pub rate_deg_mm: f64,
}

impl<'a> Track<'a> {
    /// The track of points with their tangents, under the rules of a line, of which `pins` are those that concern it.
    /// `places_mm`: where the points lie on the line as the operator knows it, for the pins; `round_mm`: the line's
    /// length if it is closed.
    pub fn new(
        points: &[DensePoint],
        tangents: &[Vector3<f64>],
        places_mm: &[f64],
        round_mm: Option<f64>,
        rules: &'a LineRules,
        pins: &[Pin],
    ) -> Track<'a> {
        let (rule, max_tilt_deg) = (&rules.tilt, rules.max_tilt_deg);
        let rate_deg_mm = RATE_SHARE * rules.tilt_rate_deg_mm;
        let aim = rule.aim(max_tilt_deg);
        let mut sites: Vec<Site> = Vec::with_capacity(points.len());
        for ((q, tangent), place_mm) in points.iter().zip(tangents).zip(places_mm) {
            let ahead = angle::unit(tangent - q.n * q.n.dot(tangent)).unwrap_or_else(|| angle::any_square_to(&q.n));
            let (e1, e2, arc_mm) = match sites.last() {
                None => (ahead, ahead.cross(&q.n), 0.0),
                Some(before) => {
                    let (e1, e2) = carried_frame(before, &q.n);
                    (e1, e2, before.arc_mm + (q.p - before.q.p).norm())
                }
            };
            let travel = TiltVector::new(ahead.dot(&e1), ahead.dot(&e2));
            let travel = travel.try_normalize(1e-9).unwrap_or_else(TiltVector::x);
            let mut site = Site {
                q: *q,
                e1,
                e2,
                travel: (travel.x, travel.y),
                arc_mm,
                base: TiltVector::zeros(),
                aim: TiltVector::zeros(),
                pull: 1.0,
            };
            site.base = site.carried(aim);
            site.aim = site.base;
            let (mut sum, mut weights) = (TiltVector::zeros(), 0.0);
            for pin in pins {
                let tilt = site.carried(pin.tilt);
                let tilt = tilt * (max_tilt_deg / tilt.norm().max(max_tilt_deg));
                let off = (place_mm - pin.at_mm).abs();
                let off = round_mm.map_or(off, |round| off.min((round - off).abs()));
                let wide_mm = PIN_MM.max((tilt - site.base).norm() / rate_deg_mm);
                let weight = (1.0 - off / wide_mm).max(0.0);
                sum += (tilt - site.base) * weight;
                weights += weight;
            }
            site.aim += sum / f64::max(weights, 1.0);
            site.pull += (PIN_PULL - 1.0) * weights.min(1.0);
            sites.push(site);
        }
        Track { sites, rule, max_tilt_deg, rate_deg_mm }
    }

    /// Whether a tilt is within the process limit and the surface's rule.
    pub fn allows(&self, site: &Site, tilt: &TiltVector) -> bool {
        tilt.norm() <= self.max_tilt_deg + 1e-6 && self.rule.allows(site.seen(tilt))
    }

    /// Whether the tilt may change so between two places.
    pub fn may_turn(&self, from: (&Site, &TiltVector), to: (&Site, &TiltVector)) -> bool {
        (to.1 - from.1).norm() <= self.rate_deg_mm * (to.0.arc_mm - from.0.arc_mm) + 1e-9
    }
}
