//! Connecting moves with the laser off: over the part, never through it.
//!
//! The focus is drawn back along the beam. Short hops go straight, if every pose on the way keeps
//! clear of the part. All others go out to a sphere around the part, along the great circle over
//! it, and back in along the next beam, which is free to infinity.

use super::steps::Station;
use crate::cell::mounting::Air;
use crate::part::{Part, angle, distance};
use nalgebra::{Isometry3, Point3, Vector3};

/// Farther apart than this the way round is taken without looking at the straight one, mm.
const HOP_MM: f64 = 40.0;
/// Poses looked at on a straight hop, mm and degrees apart.
const LOOK_MM: f64 = 0.5;
const LOOK_DEG: f64 = 2.0;
/// Stations on the great circle stand this far apart, degrees.
const ARC_DEG: f64 = 30.0;

/// The space around a part.
#[derive(Clone, Copy, Debug)]
pub struct Space<'a> {
    part: &'a Part,
    air: &'a Air,
    defocus_mm: f64,
    centre: Point3<f64>,
    radius_mm: f64,
}

impl<'a> Space<'a> {
    /// The sphere lies `air.clearance_mm` outside everything that the focus reaches.
    pub fn new(part: &'a Part, air: &'a Air, defocus_mm: f64) -> Space<'a> {
        let (lo, hi) = part.mesh.bounds();
        let radius_mm = 0.5 * (hi - lo).norm() + defocus_mm.max(0.0) + air.retreat_mm + air.clearance_mm;
        Space { part, air, defocus_mm, centre: lo + (hi - lo) * 0.5, radius_mm }
    }

    /// Whether the way from the end of one piece to the start of the next may go straight.
    pub fn is_hop(&self, from: &Station, to: &Station) -> bool {
        let (up, down) = (self.drawn_back(from), self.drawn_back(to));
        (up.x - down.x).norm() <= HOP_MM && self.is_clear(&up, &down)
    }

    /// Stations between the end of one piece and the start of the next, both excluded.
    pub fn between(&self, from: &Station, to: &Station, hop: bool) -> Vec<Station> {
        if hop {
            return vec![self.drawn_back(from), self.drawn_back(to)];
        }
        let (out, back) = (self.on_sphere(from), self.on_sphere(to));
        let mut way = vec![out];
        let (u, v) = (angle::unit(out.x - self.centre), angle::unit(back.x - self.centre));
        if let (Some(u), Some(v)) = (u, v) {
            let steps = (angle::between_deg(&u, &v) / ARC_DEG).ceil().max(1.0) as usize;
            for i in 1..steps {
                let t = i as f64 / steps as f64;
                let radial = angle::slerp(&u, &v, t);
                // Travel turns as well, so that the part does not spin at one station.
                let o = crate::pose::target::travel(&angle::slerp(&from.o, &to.o, t), &radial);
                way.push(Station { x: self.centre + radial * self.radius_mm, a: radial, o });
            }
        }
        way.push(back);
        way
    }

    /// A station on the sphere in that direction from its centre, looking outwards; `o` as near as
    /// possible to the direction given.
    pub fn on_top(&self, radial: &Vector3<f64>, o: &Vector3<f64>) -> Station {
        let o = crate::pose::target::travel(o, radial);
        Station { x: self.centre + radial * self.radius_mm, a: *radial, o }
    }

    /// Direction of a station from the sphere's centre, unit.
    pub fn radial(&self, at: &Station) -> Option<Vector3<f64>> {
        angle::unit(at.x - self.centre)
    }

    /// Entry (before the first piece) or exit (behind the last).
    pub fn outside(&self, at: &Station) -> Station {
        self.on_sphere(at)
    }

    /// The focus drawn back along the beam, the first of a way round.
    pub fn drawn_back(&self, s: &Station) -> Station {
        Station { x: s.x + s.a * self.air.retreat_mm, ..*s }
    }

    /// Whether focus and beam keep clear of the part at a path frame.
    pub fn is_clear_at(&self, part_from_focus: &Isometry3<f64>) -> bool {
        let x = Point3::from(part_from_focus.translation.vector);
        self.clears(&x, &(part_from_focus.rotation * Vector3::z()))
    }

    fn clear_mm(&self) -> f64 {
        // Half of what lies between focus and part at the ends, at most 2 mm.
        (0.5 * (self.defocus_mm + self.air.retreat_mm)).clamp(0.1, 2.0)
    }

    fn clears(&self, x: &Point3<f64>, a: &Vector3<f64>) -> bool {
        let clear_mm = self.clear_mm();
        let ray = distance::WideRay::new(x, a, clear_mm);
        let mut clear = true;
        self.part.bvh.visit_ray(x, a, 0.0, f64::INFINITY, clear_mm, |_, corners| {
            clear &= ray.surely_misses(corners) || distance::ray_triangle(x, a, 0.0, corners) > clear_mm;
            if clear { f64::INFINITY } else { -1.0 }
        });
        clear
    }

    /// Where the beam of a station leaves the sphere.
    fn on_sphere(&self, s: &Station) -> Station {
        let w = s.x - self.centre;
        let along = w.dot(&s.a);
        let t = -along + (along * along - w.norm_squared() + self.radius_mm * self.radius_mm).max(0.0).sqrt();
        Station { x: s.x + s.a * t.max(0.0), ..*s }
    }

    /// Whether focus and beam keep clear of the part on the straight move.
    fn is_clear(&self, from: &Station, to: &Station) -> bool {
        let turn = angle::between_deg(&from.a, &to.a);
        let steps = ((to.x - from.x).norm() / LOOK_MM).max(turn / LOOK_DEG).ceil().max(1.0);
        let steps = (steps as usize).next_power_of_two();
        // Both ends, the middle, the quarters, and so on: what stands between is met early.
        let order = (0..=steps.ilog2()).rev().flat_map(|level| {
            let stride = 1usize << level;
            let odd = stride < steps;
            (usize::from(odd)..=steps / stride).step_by(1 + usize::from(odd)).map(move |i| i * stride)
        });
        order.into_iter().all(|i| {
            let t = i as f64 / steps as f64;
            self.clears(&(from.x + (to.x - from.x) * t), &angle::slerp(&from.a, &to.a, t))
        })
    }

    /// Duration of a move in the air, s: by its length or by its turn, whichever takes longer.
    pub fn seconds(&self, from: &Station, to: &Station, air_speed_mm_s: f64) -> f64 {
        let turn = from.turn_deg(to);
        ((to.x - from.x).norm() / air_speed_mm_s).max(turn / self.air.turn_deg_s)
    }
}
