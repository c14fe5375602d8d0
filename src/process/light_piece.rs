//! A piece of the light: on it the spot goes straight and the axis turns evenly. Seen from a point, the axis then
//! goes by in a straight line.

use crate::part::angle;
use crate::pose::target;
use nalgebra::{Point3, Vector3};

/// The path frame at the spot: spot, axis a, travel direction o and n = o × a, in the part frame.
#[derive(Clone, Copy, Debug)]
pub struct BeamFrame {
    /// The spot, mm.
    pub p: Point3<f64>,
    /// Axis towards the laser.
    pub a: Vector3<f64>,
    /// Travel direction.
    pub o: Vector3<f64>,
    /// Across it.
    pub n: Vector3<f64>,
}

impl BeamFrame {
    /// At a spot, with axis and travel direction (unit, square to it).
    pub fn new(p: Point3<f64>, a: Vector3<f64>, o: Vector3<f64>) -> BeamFrame {
        BeamFrame { p, a, o, n: o.cross(&a) }
    }

    /// The frame at the share `t` of the way from one to another.
    pub(super) fn between(from: &BeamFrame, to: &BeamFrame, t: f64) -> BeamFrame {
        let a = angle::slerp(&from.a, &to.a, t);
        BeamFrame::new(from.p + (to.p - from.p) * t, a, target::travel(&angle::slerp(&from.o, &to.o, t), &a))
    }
}

/// A piece of a lit move.
#[derive(Clone, Copy, Debug)]
pub struct LightPiece {
    /// Number of its pass.
    pub pass: u32,
    /// Its spot and power, an index into [`Light::spots`](super::light::Light::spots).
    pub spot_and_power: u32,
    /// Where it begins.
    pub from: BeamFrame,
    /// Where it ends.
    pub to: BeamFrame,
    /// How long it takes, s.
    pub seconds: f64,
    /// When it ends, s.
    pub ends_s: f64,
}

/// A point as seen from a piece: its places (x, y) about the axis at both ends, and how high it stands
/// above the spot, mm.
#[derive(Clone, Copy, Debug)]
pub struct SeenPoint {
    /// From the axis, at the start.
    pub from: [f64; 2],
    /// At the end.
    pub to: [f64; 2],
    /// Share of the way at which it is nearest to the axis.
    pub nearest: f64,
    /// How deep below the focus it lies then, mm.
    pub z_mm: f64,
}

impl SeenPoint {
    /// Its place at a share of the way.
    pub fn at(&self, t: f64) -> [f64; 2] {
        [0, 1].map(|k| self.from[k] + (self.to[k] - self.from[k]) * t)
    }
}

impl LightPiece {
    /// The axis at a share of the way; the turn is small enough for the chord.
    #[inline]
    pub fn axis(&self, t: f64) -> Vector3<f64> {
        (self.from.a * (1.0 - t) + self.to.a * t).normalize()
    }

    /// A point in the frames of both ends.
    #[inline]
    pub fn sees(&self, q: &Point3<f64>, defocus_mm: f64) -> SeenPoint {
        let (u, v) = (q - self.from.p, q - self.to.p);
        let from = [u.dot(&self.from.o), u.dot(&self.from.n)];
        let to = [v.dot(&self.to.o), v.dot(&self.to.n)];
        let d = [to[0] - from[0], to[1] - from[1]];
        let dd = d[0] * d[0] + d[1] * d[1];
        let nearest = if dd > 0.0 { (-(from[0] * d[0] + from[1] * d[1]) / dd).clamp(0.0, 1.0) } else { 0.5 };
        let height = u.dot(&self.from.a) * (1.0 - nearest) + v.dot(&self.to.a) * nearest;
        SeenPoint { from, to, nearest, z_mm: defocus_mm - height }
    }
}
