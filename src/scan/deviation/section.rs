//! The points of a scan beside a plane, laid on it: the outline of the part as it is, to be drawn over the model's own
//! section. The model's section lines are cut elsewhere, where planes cut surfaces.

use super::{Deviation, Footing};
use crate::scan::Cloud;
use nalgebra::{Point3, Unit, Vector3};

/// A plane in the part frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of it, mm.
    pub through: Point3<f64>,
    /// Its normal.
    pub normal: Unit<Vector3<f64>>,
}

/// A point of a scan, laid on a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionPoint {
    /// Which one of the cloud.
    pub index: u32,
    /// Its place on the plane, part frame, mm.
    pub at: Point3<f64>,
    /// How far it lies off the model, mm, above 0 outside; `None` where there is no model, or none near.
    pub signed_mm: Option<f64>,
}

impl Deviation {
    /// The points not farther than `band_mm` from a plane, on either side, in the cloud's order.
    pub fn section(&self, cloud_in_part: &Cloud, plane: &Plane, band_mm: f64) -> Vec<SectionPoint> {
        let mut found = Vec::new();
        for ((index, point), (signed_mm, footing)) in
            (0u32..).zip(cloud_in_part.points()).zip(self.signed_mm.iter().zip(&self.footing))
        {
            let off = (point - plane.through).dot(&plane.normal);
            if off.abs() <= band_mm {
                let signed_mm = (*footing == Footing::OnModel).then_some(f64::from(*signed_mm));
                found.push(SectionPoint { index, at: point - plane.normal.into_inner() * off, signed_mm });
            }
        }
        found
    }
}
