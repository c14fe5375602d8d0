//! Depths without their noise: at any place of the model what the scan's points around it say together.
//!
//! Only points whose facets look the same way (within 60°) count, so that neither the other side of a thin wall nor the
//! surface beyond an edge does. Distances between places are taken between feet on the model, so that a deep pit keeps
//! its place. Nothing is left out before: dropping small depths first would cost 8 % of a patch.
//!
//! At a place of the model the level is that of a robust fit (`local_fit`) through the 60 nearest points, those
//! far off weighing less; at a point of the scan, of which there are a thousand times as many, the mean of the middle
//! half of the 40 nearest. Both leave noise of some σ/√37 (the median of 40 has 1.25 σ/√40), and both lower a depth by
//! r²/8 × the sum of its second derivatives, where the 40 nearest lie within r, [`SmoothedDepths::radius_mm`]: at 10
//! points/mm² r = 1.1 mm, and of wear 0.2 mm deep and 20 mm wide that is 0.003 mm.

use super::local_fit::{Sample, level};
use super::{Deviation, Footing, order};
use crate::part::angle::any_square_to;
use crate::part::{Mesh, Part};
use crate::progress::{Cancelled, Progress};
use crate::scan::Cloud;
use crate::scan::neighbours::{Neighbour, Neighbours};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::f64::consts::PI;

/// Points that the depth at a point of the scan is the middle of.
const NEIGHBOURS: usize = 40;
/// Points that the depth at a place is fitted through. Weighed by distance they say as much as 45. With half of them
/// the area above a threshold scatters 1.4 times as much, with twice as many a depth is lowered twice as much.
const FITTED: usize = 60;
/// Fewer than this of them facing the same way tell nothing.
const FEWEST: usize = 10;
/// Cosine of the angle up to which facets look the same way.
const SAME_SIDE: f64 = 0.5;
/// How far the nearest point may be, in distances r that the 40 nearest lie within where the scan is thin: 2.5 times
/// the points' spacing. Of points thrown at random, one place in 10⁸ has none within.
const NEAREST: f64 = 0.7;
/// How far the last one may be, in the same measure: √1.5 for 60 in place of 40, and twice as far at the corner of a
/// plate, where a quarter of the disc is there.
const FARTHEST: f64 = 2.7;
/// Where the scan is thin: of 100 points these have the others nearer.
const THIN_PERCENT: usize = 95;

/// Depths of a scan, smoothed, on the model. Above 0 where material is missing.
pub struct SmoothedDepths<'a> {
    mesh: &'a Mesh,
    /// The points on the model, by index in the cloud, in spatial order.
    index: Vec<u32>,
    feet: Cloud,
    neighbours: Neighbours,
    facet: Vec<u32>,
    depth_mm: Vec<f32>,
    smooth_mm: Vec<f32>,
    /// Middle radius that the neighbours lie within, mm; and where the scan is thin.
    radius_mm: f64,
    thin_radius_mm: f64,
}

/// Room to work in.
#[derive(Default)]
pub(super) struct Room {
    near: Vec<Neighbour>,
    samples: Vec<Sample>,
    numbers: Vec<f64>,
}

impl<'a> SmoothedDepths<'a> {
    /// Smooths a deviation: some 50 bytes for each point on the model.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(
        part: &'a Part,
        cloud_in_part: &Cloud,
        deviation: &Deviation,
        progress: &Progress,
    ) -> Result<SmoothedDepths<'a>, Cancelled> {
        // Side by side in memory what lies side by side: a third of the time.
        let mut index = order::spatial(cloud_in_part);
        index.retain(|&i| deviation.footing[i as usize] == Footing::OnModel);
        let foot = |&i: &u32| {
            let place = deviation.foot(part, cloud_in_part, i).unwrap_or(cloud_in_part.point(i as usize));
            let d = place - cloud_in_part.origin;
            [d.x as f32, d.y as f32, d.z as f32]
        };
        let feet =
            Cloud { origin: cloud_in_part.origin, offsets: index.par_iter().map(foot).collect(), ..Cloud::default() };
        progress.check()?;
        let neighbours = Neighbours::new(&feet, progress)?;
        let facet: Vec<u32> = index.iter().map(|&i| deviation.facet[i as usize]).collect();
        let depth_mm: Vec<f32> = index.iter().map(|&i| -deviation.signed_mm[i as usize]).collect();
        let normals = &part.mesh.normals;
        let smooth = |i: u32, near: &[Neighbour]| {
            let own = &normals[facet[i as usize] as usize];
            let same = |n: &&Neighbour| normals[facet[n.index as usize] as usize].dot(own) > SAME_SIDE;
            let mut depths = Vec::with_capacity(NEIGHBOURS);
            depths.push(depth_mm[i as usize]);
            depths.extend(near.iter().filter(same).map(|n| depth_mm[n.index as usize]));
            let farthest = near.iter().fold(0f32, |far, n| far.max(n.squared));
            (middle(&mut depths) as f32, farthest)
        };
        let smoothed = neighbours.map_nearest(NEIGHBOURS - 1, progress, smooth)?;
        let mut farthest: Vec<f32> = smoothed.iter().map(|s| s.1).collect();
        let mut radius = |percent: usize| {
            let at = farthest.len() * percent / 100;
            if at < farthest.len() {
                f64::from(*farthest.select_nth_unstable_by(at, f32::total_cmp).1).sqrt()
            } else {
                0.0
            }
        };
        let (radius_mm, thin_radius_mm) = (radius(50), radius(THIN_PERCENT));
        let smooth_mm = smoothed.into_iter().map(|s| s.0).collect();
        Ok(SmoothedDepths {
            mesh: &part.mesh,
            index,
            feet,
            neighbours,
            facet,
            depth_mm,
            smooth_mm,
            radius_mm,
            thin_radius_mm,
        })
    }

    /// Radius of the disc that a depth is taken from, mm; 0 without points.
    pub fn radius_mm(&self) -> f64 {
        self.radius_mm
    }

    /// Points per mm² of the model where it was scanned.
    pub fn density_per_mm2(&self) -> f64 {
        // In a disc that reaches to the n-th there are n − 1/3 at the median (gamma distribution).
        let count = (NEIGHBOURS - 1) as f64 - 1.0 / 3.0;
        if self.radius_mm > 0.0 { count / (PI * self.radius_mm * self.radius_mm) } else { 0.0 }
    }

    /// How far from a scanned place the model still counts as scanned, mm.
    pub fn reach_mm(&self) -> f64 {
        NEAREST * self.thin_radius_mm
    }

    /// The depth at a place of the model with these normals (one; several on an edge), mm; `None` where nothing was
    /// scanned.
    pub fn depth_mm(&self, place: &Point3<f64>, normals: &[Vector3<f64>]) -> Option<f64> {
        self.depth_with(place, normals, &mut Room::default())
    }

    /// The smoothed depth at a place, worked out in `room`, which the caller hands on from place to place.
    pub(super) fn depth_with(&self, place: &Point3<f64>, normals: &[Vector3<f64>], room: &mut Room) -> Option<f64> {
        // Where the other side of a wall is as near, it takes more to find as many of this one.
        let near = &mut room.near;
        for looked in [FITTED, 3 * FITTED] {
            self.neighbours.nearest(place, looked, near);
            let exhausted = near.len() < looked;
            near.retain(|n| self.is_same_side(n.index, normals));
            near.truncate(FITTED);
            if near.len() == FITTED || exhausted {
                break;
            }
        }
        let (nearest, last) = (near.first()?, near.last()?);
        let within = |n: &Neighbour, share: f64| f64::from(n.squared).sqrt() <= share * self.thin_radius_mm;
        if near.len() < FEWEST || !within(nearest, NEAREST) || !within(last, FARTHEST) {
            return None;
        }
        let across = normals.iter().sum::<Vector3<f64>>();
        let along = any_square_to(&across);
        let aside = across.cross(&along).try_normalize(0.0).unwrap_or_else(Vector3::zeros);
        room.samples.clear();
        room.samples.extend(near.iter().map(|n| {
            let to = self.feet.point(n.index as usize) - place;
            Sample { at: [to.dot(&along), to.dot(&aside)], depth: f64::from(self.depth_mm[n.index as usize]) }
        }));
        Some(level(&room.samples, &mut room.numbers))
    }

    /// Whether a place of the model with this normal was scanned.
    pub(super) fn is_scanned(&self, place: &Point3<f64>, normal: &Vector3<f64>, room: &mut Room) -> bool {
        match self.neighbours.nearest_one(place, self.reach_mm()) {
            None => false,
            Some(n) if self.is_same_side(n.index, std::slice::from_ref(normal)) => true,
            Some(_) => {
                self.neighbours.within(place, self.reach_mm(), &mut room.near);
                room.near.iter().any(|n| self.is_same_side(n.index, std::slice::from_ref(normal)))
            }
        }
    }

    fn is_same_side(&self, foot: u32, normals: &[Vector3<f64>]) -> bool {
        let own = &self.mesh.normals[self.facet[foot as usize] as usize];
        normals.iter().any(|n| n.dot(own) > SAME_SIDE)
    }

    /// Places on the model that belong to points with a smoothed depth, or surplus, of at least this, mm.
    pub(super) fn places_beyond(&self, amount_mm: f64) -> Cloud {
        let beyond = |i: &u32| f64::from(self.smooth_mm[*i as usize].abs()) >= amount_mm;
        let picked: Vec<u32> = (0..self.smooth_mm.len() as u32).filter(beyond).collect();
        self.feet.picked(&picked)
    }

    /// Smoothed depth of each of the cloud's `count` points, mm; NaN where there is no model.
    pub fn of_points_mm(&self, count: usize) -> Vec<f32> {
        let mut all = vec![f32::NAN; count];
        for (&i, &depth) in self.index.iter().zip(&self.smooth_mm) {
            if let Some(slot) = all.get_mut(i as usize) {
                *slot = depth;
            }
        }
        all
    }

    /// Which of the cloud's `count` points lie where the part is worn or built up by more than this, mm: a fit of the
    /// scan does better without them. Three standard deviations of the single points are a good limit.
    pub fn worn_points(&self, count: usize, limit_mm: f64) -> Vec<bool> {
        self.of_points_mm(count).iter().map(|depth| f64::from(depth.abs()) > limit_mm).collect()
    }
}

/// The mean of the middle half; 0 without numbers.
fn middle(all: &mut [f32]) -> f64 {
    let quarter = all.len() / 4;
    if quarter > 0 {
        all.select_nth_unstable_by(quarter, f32::total_cmp);
        let upper = all.len() - 2 * quarter;
        all[quarter..].select_nth_unstable_by(upper, f32::total_cmp);
    }
    let half = &all[quarter..all.len() - quarter];
    half.iter().map(|d| f64::from(*d)).sum::<f64>() / half.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::middle;

    #[test]
    fn a_quarter_on_either_side_does_not_count() {
        assert_eq!(middle(&mut [9e9, 1.0, -5e7, 2.0, 3.0, 4.0, 7e5, -8.0]), 2.5);
        assert_eq!(middle(&mut [7.0, 1.0, 4.0]), 4.0);
        assert_eq!(middle(&mut []), 0.0);
        let mut many: Vec<f32> = (0u16..41).map(|i| f32::from(i * 17 % 41)).collect();
        assert_eq!(middle(&mut many), 20.0);
    }
}
