//! Shapes that may touch: capsules, facets with a place, and all that lies below a height. Whether two
//! are near each other, and how far apart they are.

use super::contact::BodyId;
use crate::cell::bodies::HeadCapsule;
use crate::cell::robot::LinkCapsule;
use crate::part::distance::{point_segment, segments};
use crate::part::{Bvh, Part};
use nalgebra::{Isometry3, Point3, Vector3};

#[derive(Clone, Copy, Debug)]
pub(super) struct Capsule {
    pub from: Point3<f64>,
    pub to: Point3<f64>,
    pub radius_mm: f64,
}

/// Facets with a place, and a sphere around them.
#[derive(Clone, Debug)]
pub(super) struct CollisionSolid<'a> {
    pub id: BodyId,
    bvh: &'a Bvh,
    /// Whether it has an inside.
    closed: bool,
    at: Isometry3<f64>,
    pub centre: Point3<f64>,
    pub radius_mm: f64,
}

/// What may touch.
pub(super) enum CollisionBody<'s, 'a> {
    Capsule(Capsule),
    Solid(&'s CollisionSolid<'a>),
    /// Everything below this height in the base, mm: it stands, and is always the second of a pair.
    Below(f64),
}

impl CollisionBody<'_, '_> {
    /// Whether it touches another body, or comes nearer than a margin.
    pub fn is_near(&self, o: &CollisionBody<'_, '_>, margin_mm: f64) -> bool {
        match (self, o) {
            (CollisionBody::Capsule(a), CollisionBody::Capsule(b)) => a.distance_mm(b) <= margin_mm,
            (CollisionBody::Capsule(c), CollisionBody::Solid(s))
            | (CollisionBody::Solid(s), CollisionBody::Capsule(c)) => s.is_near(c, margin_mm),
            (CollisionBody::Solid(a), CollisionBody::Solid(b)) => b.is_near_solid(a, margin_mm),
            (CollisionBody::Capsule(c), CollisionBody::Below(z_mm)) => c.lowest_mm() < z_mm + margin_mm,
            (CollisionBody::Solid(s), CollisionBody::Below(z_mm)) => s.reaches_below(z_mm + margin_mm),
            (CollisionBody::Below(_), _) => false,
        }
    }

    /// How far apart the two are, mm, 0 where they touch; `None`: at least `within_mm`.
    pub fn distance_mm(&self, o: &CollisionBody<'_, '_>, within_mm: f64) -> Option<f64> {
        let mm = match (self, o) {
            (CollisionBody::Capsule(a), CollisionBody::Capsule(b)) => a.distance_mm(b),
            (CollisionBody::Capsule(c), CollisionBody::Solid(s))
            | (CollisionBody::Solid(s), CollisionBody::Capsule(c)) => s.distance_mm(c, within_mm)?,
            (CollisionBody::Solid(a), CollisionBody::Solid(b)) => b.distance_of_solid_mm(a, within_mm)?,
            (CollisionBody::Capsule(c), CollisionBody::Below(z_mm)) => c.lowest_mm() - z_mm,
            (CollisionBody::Solid(s), CollisionBody::Below(z_mm)) => s.height_above_mm(*z_mm, within_mm)?,
            (CollisionBody::Below(_), _) => return None,
        };
        let mm = mm.max(0.0);
        (mm < within_mm).then_some(mm)
    }
}

impl Capsule {
    pub fn of(h: &HeadCapsule, focus: &Isometry3<f64>) -> Capsule {
        let at = |mm: f64| focus * Point3::new(0.0, 0.0, mm);
        Capsule { from: at(h.from_mm), to: at(h.to_mm), radius_mm: h.radius_mm }
    }

    pub fn of_link(l: &LinkCapsule) -> Capsule {
        Capsule { from: l.from, to: l.to, radius_mm: l.radius_mm }
    }

    pub fn moved(&self, by: &Isometry3<f64>) -> Capsule {
        Capsule { from: by * self.from, to: by * self.to, ..*self }
    }

    fn lowest_mm(&self) -> f64 {
        self.from.z.min(self.to.z) - self.radius_mm
    }

    /// Below 0 where they touch.
    fn distance_mm(&self, o: &Capsule) -> f64 {
        segments(&self.from, &self.to, &o.from, &o.to) - (self.radius_mm + o.radius_mm)
    }
}

impl<'a> CollisionSolid<'a> {
    pub fn new(id: BodyId, part: &'a Part, at: Isometry3<f64>) -> Option<CollisionSolid<'a>> {
        let (centre, radius_mm) = part.bvh.sphere()?;
        Some(CollisionSolid {
            id,
            bvh: &part.bvh,
            closed: part.orientation.watertight,
            at,
            centre: at * centre,
            radius_mm,
        })
    }

    pub fn moved(&self, by: &Isometry3<f64>) -> CollisionSolid<'a> {
        CollisionSolid { id: self.id.clone(), at: by * self.at, centre: by * self.centre, ..*self }
    }

    /// Whether the spheres around solid and capsule keep farther apart than this.
    fn is_clear_of(&self, c: &Capsule, mm: f64) -> bool {
        point_segment(&self.centre, &c.from, &c.to) > self.radius_mm + c.radius_mm + mm
    }

    fn is_near(&self, c: &Capsule, margin_mm: f64) -> bool {
        if self.is_clear_of(c, margin_mm) {
            return false;
        }
        let [from, to] = [c.from, c.to].map(|p| self.at.inverse_transform_point(&p));
        self.bvh.near_segment(&from, &to, c.radius_mm + margin_mm) || self.holds(&c.from)
    }

    /// Below 0 where they touch.
    fn distance_mm(&self, c: &Capsule, within_mm: f64) -> Option<f64> {
        if self.is_clear_of(c, within_mm) {
            return None;
        }
        if self.holds(&c.from) {
            return Some(0.0);
        }
        let [from, to] = [c.from, c.to].map(|p| self.at.inverse_transform_point(&p));
        Some(self.bvh.distance_to_segment(&from, &to, within_mm + c.radius_mm)? - c.radius_mm)
    }

    fn is_near_solid(&self, o: &CollisionSolid<'_>, margin_mm: f64) -> bool {
        if (self.centre - o.centre).norm() > self.radius_mm + o.radius_mm + margin_mm {
            return false;
        }
        let self_from_other = self.at.inv_mul(&o.at);
        self.bvh.near_mesh(o.bvh, &self_from_other, margin_mm) || self.is_around_or_in(o)
    }

    fn distance_of_solid_mm(&self, o: &CollisionSolid<'_>, within_mm: f64) -> Option<f64> {
        if (self.centre - o.centre).norm() > self.radius_mm + o.radius_mm + within_mm {
            return None;
        }
        if self.is_around_or_in(o) {
            return Some(0.0);
        }
        self.bvh.distance_to_mesh(o.bvh, &self.at.inv_mul(&o.at), within_mm)
    }

    /// Whether one of two solids whose facets do not meet is inside the other.
    fn is_around_or_in(&self, o: &CollisionSolid<'_>) -> bool {
        self.holds_corner_of(o) || o.holds_corner_of(self)
    }

    fn holds_corner_of(&self, o: &CollisionSolid<'_>) -> bool {
        self.closed && o.bvh.corner().is_some_and(|p| self.holds(&(o.at * p)))
    }

    /// Whether a point in the base is inside. Rays are dear, and most points are outside the sphere.
    fn holds(&self, p: &Point3<f64>) -> bool {
        self.closed && (p - self.centre).norm() <= self.radius_mm && self.bvh.holds(&self.at.inverse_transform_point(p))
    }

    /// The base's upward direction in the solid's own frame.
    fn up(&self) -> Vector3<f64> {
        self.at.rotation.inverse() * Vector3::z()
    }

    fn reaches_below(&self, z_mm: f64) -> bool {
        self.centre.z - self.radius_mm < z_mm && self.bvh.reaches_below(&self.up(), z_mm - self.at.translation.z)
    }

    /// Below 0 where it reaches below.
    fn height_above_mm(&self, z_mm: f64, within_mm: f64) -> Option<f64> {
        if self.centre.z - self.radius_mm >= z_mm + within_mm {
            return None;
        }
        Some(self.bvh.lowest_mm(&self.up())? + self.at.translation.z - z_mm)
    }
}
