//! What comes out of slicing a cloud: curves of points with their frames and what the points scatter by.

use nalgebra::{Point3, Vector3};

/// Where a plane meets what was scanned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CloudSlice {
    /// In the order of the first of their points in the cloud.
    pub curves: Vec<SliceCurve>,
    /// Points of the band about the plane that lie on no curve: too few together, or beside one.
    pub left_over: usize,
}

/// One curve of a slice, in the cloud's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct SliceCurve {
    /// In order, along (outward normal) × (plane's normal). A closed curve does not repeat its first.
    pub points: Vec<SlicePoint>,
    /// Whether the last point joins the first.
    pub closed: bool,
    /// How many points of the cloud it was fitted to.
    pub fitted_points: usize,
    /// The greatest distance in the plane of one of those from it, mm; outliers, which count for nothing, left out.
    pub max_residual_mm: f64,
    /// The root of their mean square, mm.
    pub rms_mm: f64,
}

/// A point of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlicePoint {
    /// Where it is, mm; in the plane.
    pub place: Point3<f64>,
    /// Unit direction of the curve; in the plane.
    pub tangent: Vector3<f64>,
    /// Unit normal of the surface, outward, square to the tangent.
    pub outward: Vector3<f64>,
    /// What the points near it scatter by about the curve, in the plane: the root of their mean square, mm.
    pub noise_mm: f64,
}
