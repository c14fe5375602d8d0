//! Points that were measured on a part: where surfaces have them, lines are laid through them and not on the facets.
//! What a scanner gave, and how it was laid on the part, is told elsewhere.

use super::{Digest, Hasher};
use nalgebra::Point3;

/// Points on a part with the normals there, part frame.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredPoints {
    /// What the offsets count from, mm.
    pub origin: Point3<f64>,
    /// Places from the origin, mm.
    pub offsets: Vec<[f32; 3]>,
    /// Unit normals, outward; zero where the points around tell none.
    pub normals: Vec<[f32; 3]>,
    /// Digest of all of it.
    pub digest: Digest,
}

impl MeasuredPoints {
    /// Points with as many normals.
    pub fn new(origin: Point3<f64>, offsets: Vec<[f32; 3]>, normals: Vec<[f32; 3]>) -> MeasuredPoints {
        let bits = |of: &[[f32; 3]]| -> Vec<u32> { of.as_flattened().iter().map(|c| c.to_bits()).collect() };
        let digest = Hasher::default().of(&origin).u32s(&bits(&offsets)).u32s(&bits(&normals)).finish();
        MeasuredPoints { origin, offsets, normals, digest }
    }
}
