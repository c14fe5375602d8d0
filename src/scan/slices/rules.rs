//! What slices of a cloud are asked for: planes, steps, bounds, and which side is outward.

use nalgebra::{Unit, Vector3};

/// A plane: the places p with normal · p = offset, in the frame of the cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlicePlane {
    /// Unit normal m. Curves run along (outward normal) × m, as sections of a mesh do.
    pub normal: Unit<Vector3<f64>>,
    /// Along the normal from the frame's origin, mm.
    pub offset_mm: f64,
}

/// Which side of the surface is outward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutwardSide {
    /// The side of the normals that are given; both faces of a thin wall are told apart by them.
    OfNormals,
    /// The side towards which a curve's normals point in the main, as towards the scanner. Their signs are not trusted,
    /// but carried on along each curve; walls thinner than three spacings come out as one.
    Towards(Vector3<f64>),
}

/// How curves are fitted and sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceRules {
    /// Greatest distance of two points of a curve, along it, mm.
    pub step_mm: f64,
    /// Greatest distance of a curve from the chord between two of its points, mm.
    pub chord_mm: f64,
    /// How far the curve may lie beside the middle of the points, mm: knots are added until it does not, or the
    /// difference is less than three standard errors of the noise, or two knots would be a spacing apart.
    pub tolerance_mm: f64,
    /// Which side is outward.
    pub outward: OutwardSide,
}
