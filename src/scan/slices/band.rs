//! The points near a plane, carried onto it along the surface.
//!
//! Dropped square to the plane, points of a band of half width w would smear by w·tan of the slope. Here each goes along
//! its tangent plane the steepest way to the plane. On what is round the tangent leaves the surface by κs²/2; the chord to
//! where it arrives is square to the mean of the normals at both ends, so once the curve's normals are known
//! (`curve_points`) the way is taken anew along that.

use super::rules::SlicePlane;
use super::scale::ScaledPiece;
use crate::scan::cloud::Cloud;
use nalgebra::{Point3, Unit, Vector2, Vector3};

/// Half width of the band in spacings, along the surface: three points a spacing of the curve, so that each step of the
/// ordering has four or five.
const HALF_WIDTH: f64 = 1.5;
/// Least sine of the angle between surface and plane, 15°: nearer to it the way along the surface is four times as
/// far as the band is high, and a plane that lies in a face has no curve there.
const LEAST_SINE: f64 = 0.26;

/// Coordinates in a plane: two in it, the third along its normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlaneFrame {
    origin: Point3<f64>,
    axes: [Vector3<f64>; 3],
}

impl PlaneFrame {
    /// Its origin is the point of the plane nearest to `near`.
    pub(super) fn new(plane: &SlicePlane, near: &Point3<f64>) -> PlaneFrame {
        let m = plane.normal.into_inner();
        let first = if m.x.abs() < 0.6 { Vector3::x() } else { Vector3::y() };
        let first = Unit::try_new(first - m * m.dot(&first), 0.0).map_or_else(Vector3::x, Unit::into_inner);
        let origin = near - m * (m.dot(&near.coords) - plane.offset_mm);
        PlaneFrame { origin, axes: [first, m.cross(&first), m] }
    }

    fn turned(&self, v: &Vector3<f64>) -> Vector3<f64> {
        Vector3::from(self.axes.map(|a| a.dot(v)))
    }

    /// A direction of the frame, in the cloud's.
    pub(super) fn direction(&self, v: &Vector3<f64>) -> Vector3<f64> {
        self.axes[0] * v.x + self.axes[1] * v.y + self.axes[2] * v.z
    }

    /// A place in the plane, in the cloud's frame.
    pub(super) fn place(&self, at: &Vector2<f64>) -> Point3<f64> {
        self.origin + self.axes[0] * at.x + self.axes[1] * at.y
    }
}

/// A point of the band, in the plane's frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct BandPoint {
    index: u32,
    /// Where it was measured.
    measured: Vector3<f64>,
    /// Unit normal of the surface.
    pub(super) normal: Vector3<f64>,
    /// Where it is carried to.
    pub(super) at: Vector2<f64>,
    /// Unit length there, mm.
    pub(super) scale_mm: f64,
}

impl BandPoint {
    /// Where it arrives if the surface goes on square to a normal, not of unit length; `None` along the plane.
    pub(super) fn carried(&self, normal: &Vector3<f64>) -> Option<Vector2<f64>> {
        let squared = normal.norm_squared();
        let sine2 = normal.xy().norm_squared() / squared;
        let along = normal.xy() * (normal.z * self.measured.z / squared / sine2);
        (sine2 >= LEAST_SINE * LEAST_SINE).then(|| self.measured.xy() + along)
    }
}

/// The points of a cloud whose way to a plane is within the half width of the band, in the cloud's order.
pub(super) fn band(
    cloud: &Cloud,
    normals: &[[f32; 3]],
    pieces: &[ScaledPiece<'_>],
    plane: &SlicePlane,
    frame: &PlaneFrame,
) -> Vec<BandPoint> {
    let m = plane.normal.into_inner();
    let mut out = Vec::new();
    for ScaledPiece { piece, scale_mm } in pieces {
        let reach_mm = HALF_WIDTH * scale_mm;
        let half = (piece.hi - piece.lo) * 0.5;
        let middle_mm = m.dot(&(piece.lo + half).coords) - plane.offset_mm;
        let half_mm = (0..3).map(|k| m[k].abs() * half[k]).sum::<f64>();
        // NaN, of pieces without a number, is not within.
        if !(middle_mm.abs() <= half_mm + reach_mm && *scale_mm > 0.0) {
            continue;
        }
        for &i in piece.indices {
            let place = cloud.point(i as usize);
            let height_mm = m.dot(&place.coords) - plane.offset_mm;
            let Some(normal) = normals.get(i as usize).filter(|_| height_mm.abs() <= reach_mm) else { continue };
            let normal = frame.turned(&Vector3::from(normal.map(f64::from)));
            let measured = frame.turned(&(place - frame.origin));
            let Some(normal) = normal.try_normalize(0.0) else { continue };
            let point = BandPoint { index: i, measured, normal, at: measured.xy(), scale_mm: *scale_mm };
            let Some(at) = point.carried(&normal) else { continue };
            // Within the reach along the surface; a place that is no number is not.
            if height_mm.abs() <= reach_mm * normal.xy().norm() && at.iter().all(|x| x.is_finite()) {
                out.push(BandPoint { at, ..point });
            }
        }
    }
    out.sort_unstable_by_key(|p| p.index);
    out
}
