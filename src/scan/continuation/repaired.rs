//! The region with its damage made good: damaged points move onto the continued surface, and sound ones around them
//! fade into it, so that no step is left at the rim.

use super::{ContinuedSurface, DamagedRegion, PointState};
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::{Neighbour, Neighbours};
use nalgebra::Point3;

/// Least width of the band of sound points that fade, in distances between points.
const BAND: f64 = 4.0;
/// Greatest width: what lies further off is no rim of the damage.
const WIDEST: f64 = 64.0;
/// Of a band so many times as long as its steps would take, no step is above two thirds of the noise.
const GENTLE: f64 = 1.5;
/// Points asked for their distance to the next one, at most.
const ASKED: usize = 2_000;

impl ContinuedSurface {
    /// The places of the region's points, mm, with damaged ones on the surface. Points of other surfaces stay, and so do
    /// damaged ones that the surface does not reach.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn repaired(&self, region: &DamagedRegion, progress: &Progress) -> Result<Vec<Point3<f64>>, Cancelled> {
        let mut places = region.points.to_vec();
        let mut holes = Vec::new();
        for (i, p) in region.points.iter().enumerate() {
            progress.check_at(i)?;
            if region.state.get(i) == Some(&PointState::Damaged)
                && let Some((foot, _)) = self.closest(p)
            {
                holes.push(*p);
                places[i] = foot;
            }
        }
        let neighbours = Neighbours::new(&Cloud::of_points(&holes), progress)?;
        let spacing_mm = spacing_mm(&holes, progress)?;
        let widest_mm = WIDEST * spacing_mm;
        // Of each sound point near the damage: how far it is from there, and how far off the surface.
        let mut rim: Vec<(usize, f64, Point3<f64>)> = Vec::new();
        for (i, p) in region.points.iter().enumerate() {
            progress.check_at(i)?;
            if region.state.get(i) == Some(&PointState::Sound)
                && let Some(near) = neighbours.nearest_one(p, widest_mm)
                && let Some((foot, _)) = self.closest(p)
            {
                rim.push((i, f64::from(near.squared).sqrt(), foot));
            }
        }
        let close = rim.iter().filter(|(_, distance_mm, _)| *distance_mm < BAND * spacing_mm);
        let worst_mm = close.fold(0.0, |most: f64, (i, _, foot)| most.max((region.points[*i] - foot).norm()));
        let steps = (GENTLE * worst_mm / self.rms_mm.max(1e-9)).clamp(BAND, WIDEST);
        for (i, distance_mm, foot) in rim {
            let share = 1.0 - distance_mm / (steps * spacing_mm);
            if share > 0.0 {
                let p = region.points[i];
                places[i] = p + (foot - p) * share;
            }
        }
        Ok(places)
    }
}

/// Median distance of points to the next one, mm; 0 for a single one or none.
fn spacing_mm(points: &[Point3<f64>], progress: &Progress) -> Result<f64, Cancelled> {
    let neighbours = Neighbours::new(&Cloud::of_points(points), progress)?;
    let asked = points.len().min(ASKED);
    let mut near: Vec<Neighbour> = Vec::new();
    let mut all: Vec<f64> = Vec::with_capacity(asked);
    for k in 0..asked {
        neighbours.nearest(&points[k * points.len() / asked], 2, &mut near);
        all.extend(near.get(1).map(|n| f64::from(n.squared).sqrt()));
    }
    if all.is_empty() {
        return Ok(0.0);
    }
    let half = all.len() / 2;
    Ok(*all.select_nth_unstable_by(half, f64::total_cmp).1)
}
