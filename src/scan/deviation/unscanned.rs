//! How much of the model was not scanned: its facets are looked at in pieces not larger than the scan resolves.

use super::SmoothedDepths;
use super::smoothing::Room;
use crate::part::Part;
use crate::part::topology::FacetDefect;
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;

/// Pieces of all facets together, about: beyond it they are made larger.
const MOST: f64 = 2e6;
/// Halvings of a facet at most: a square metre in pieces of a millimetre takes 20.
const HALVINGS: u32 = 24;

/// Area of the model without points, mm². Exact to the size of a piece along the rims of what was scanned.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn unscanned_mm2(part: &Part, depths: &SmoothedDepths, progress: &Progress) -> Result<f64, Cancelled> {
    let mesh = &part.mesh;
    let proper: Vec<usize> = (0..mesh.facets.len()).filter(|&f| mesh.defects[f] == FacetDefect::None).collect();
    let whole: f64 = proper.iter().map(|&f| mesh.areas[f]).sum();
    let side_mm = depths.reach_mm().max((2.0 * whole / MOST).sqrt());
    let of_facet = |room: &mut Room, &f: &usize| {
        let mut open_mm2 = 0.0;
        let mut waiting = vec![(mesh.corners(f), 0)];
        let mut looks = 0u32;
        while let Some((corners, halvings)) = waiting.pop() {
            let length2 = |k: usize| (corners[(k + 1) % 3] - corners[k]).norm_squared();
            let k = (1..3).fold(0, |longest, k| if length2(k) > length2(longest) { k } else { longest });
            if length2(k) > side_mm * side_mm && halvings < HALVINGS {
                let [a, b, c] = [0, 1, 2].map(|i| corners[(k + i) % 3]);
                let middle = a + (b - a) * 0.5;
                waiting.extend([([a, middle, c], halvings + 1), ([middle, b, c], halvings + 1)]);
                continue;
            }
            if looks.is_multiple_of(256) {
                progress.check()?;
            }
            looks += 1;
            let centre = Point3::from((corners[0].coords + corners[1].coords + corners[2].coords) / 3.0);
            if !depths.is_scanned(&centre, &mesh.normals[f], room) {
                open_mm2 += mesh.areas[f] / f64::from(1u32 << halvings);
            }
        }
        Ok(open_mm2)
    };
    let areas: Vec<f64> = proper.par_iter().map_init(Room::default, of_facet).collect::<Result<_, Cancelled>>()?;
    Ok(areas.iter().sum())
}
