//! Where on the model a place's nearest point is, looked up in cells: good to a cell, and a hundred times quicker than
//! asking the mesh. Only the first steps from all turns use it.
//!
//! Cells that the skin passes are exact at their middles. From there the feet are carried from cell to cell, so off the
//! skin a foot may lie a little further than the nearest one: less than a cell on the parts tried.

use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// Cells along the longest side of the field: of 3 mm on a camshaft of 140 mm, whose lobes stand out by 7 mm.
const CELLS: f64 = 64.0;
/// How far the field reaches beyond the box, as a share of its longest side: half a scan laid middle on middle sticks
/// out by so much. What lies further is looked up at the border.
const MARGIN: f64 = 0.2;
/// Half the diagonal of a cell, in cells: cells that the skin passes are no further from it.
const HALF_DIAGONAL: f64 = 0.867;

/// Walks through all cells, each forward and back. The first may leave cells unknown, the second none.
const ROUNDS: usize = 2;
/// The thirteen neighbours that come before a cell.
const BEFORE: [[isize; 3]; 13] = [
    [-1, -1, -1],
    [-1, -1, 0],
    [-1, -1, 1],
    [-1, 0, -1],
    [-1, 0, 0],
    [-1, 0, 1],
    [-1, 1, -1],
    [-1, 1, 0],
    [-1, 1, 1],
    [0, -1, -1],
    [0, -1, 0],
    [0, -1, 1],
    [0, 0, -1],
];

/// The nearest point of the model for each cell, from the corner `lo`.
#[derive(Clone, Debug)]
pub(in crate::scan) struct Field {
    /// The middle of the first cell, part frame; places asked and feet given count from it.
    pub(in crate::scan) lo: Point3<f64>,
    cell_mm: f64,
    dims: [usize; 3],
    feet: Vec<[f32; 3]>,
}

impl Field {
    /// Lays the field around what lies in a box, whose point nearest to a place, within a distance, is told by `closest`.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub(in crate::scan) fn new(
        (lo, hi): (Point3<f64>, Point3<f64>),
        closest: impl Fn(&Point3<f64>, f64) -> Option<Point3<f64>> + Sync,
        progress: &Progress,
    ) -> Result<Field, Cancelled> {
        let longest = (hi - lo).max();
        let margin = Vector3::repeat(MARGIN * longest);
        let (lo, hi) = (lo - margin, hi + margin);
        let cell_mm = (hi - lo).max() / CELLS;
        let dims = [0, 1, 2].map(|k| ((hi[k] - lo[k]) / cell_mm).ceil() as usize + 1);
        let mut field = Field { lo, cell_mm, dims, feet: Vec::new() };
        field.feet = field.near_skin(closest, progress)?;
        field.spread(progress)?;
        Ok(field)
    }

    /// The foot for a place; both from `lo`.
    pub(in crate::scan) fn foot(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let cell = |k: usize| ((place[k] / self.cell_mm + 0.5).max(0.0) as usize).min(self.dims[k] - 1);
        Vector3::from(self.feet[self.index([cell(0), cell(1), cell(2)])].map(f64::from))
    }

    fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        (x * self.dims[1] + y) * self.dims[2] + z
    }

    fn cell(&self, index: usize) -> [usize; 3] {
        let across = self.dims[2];
        [index / across / self.dims[1], index / across % self.dims[1], index % across]
    }

    fn middle(&self, cell: [usize; 3]) -> Vector3<f64> {
        Vector3::from(cell.map(|c| c as f64)) * self.cell_mm
    }

    fn near_skin(
        &self,
        closest: impl Fn(&Point3<f64>, f64) -> Option<Point3<f64>> + Sync,
        progress: &Progress,
    ) -> Result<Vec<[f32; 3]>, Cancelled> {
        let row = self.dims[2];
        let mut feet = vec![[f32::NAN; 3]; self.dims.iter().product()];
        feet.par_chunks_mut(row).enumerate().try_for_each(|(r, feet)| {
            for (z, foot) in feet.iter_mut().enumerate() {
                let at = self.lo + self.middle(self.cell(r * row + z));
                if let Some(found) = closest(&at, HALF_DIAGONAL * self.cell_mm) {
                    let from_lo = found - self.lo;
                    *foot = [from_lo.x as f32, from_lo.y as f32, from_lo.z as f32];
                }
            }
            progress.check()
        })?;
        Ok(feet)
    }

    /// Carries feet through all cells, forward and back (Danielsson 1980, with all neighbours): each cell takes the
    /// nearest of those that its neighbours have.
    fn spread(&mut self, progress: &Progress) -> Result<(), Cancelled> {
        for _ in 0..ROUNDS {
            for x in 0..self.dims[0] {
                progress.check()?;
                self.layer(x, false);
            }
            for x in (0..self.dims[0]).rev() {
                progress.check()?;
                self.layer(x, true);
            }
        }
        Ok(())
    }

    /// One layer of cells, from the neighbours that come before in the order of the walk.
    fn layer(&mut self, x: usize, backward: bool) {
        let [_, ny, nz] = self.dims;
        for i in 0..ny * nz {
            let i = if backward { ny * nz - 1 - i } else { i };
            let cell = [x, i / nz, i % nz];
            let (at, here) = (self.middle(cell), self.index(cell));
            // NaN, where nothing is known, is nearer than nothing.
            let far = |foot: &[f32; 3]| (Vector3::from(foot.map(f64::from)) - at).norm_squared();
            let (mut best, mut best_far) = (self.feet[here], far(&self.feet[here]));
            for [dx, dy, dz] in BEFORE {
                let side = if backward { [-dx, -dy, -dz] } else { [dx, dy, dz] };
                let Some(j) = self.beside(cell, side) else { continue };
                let there = far(&self.feet[j]);
                if there < best_far || best_far.is_nan() {
                    (best, best_far) = (self.feet[j], there);
                }
            }
            self.feet[here] = best;
        }
    }

    fn beside(&self, cell: [usize; 3], side: [isize; 3]) -> Option<usize> {
        let mut at = cell;
        for k in 0..3 {
            at[k] = cell[k].checked_add_signed(side[k]).filter(|c| *c < self.dims[k])?;
        }
        Some(self.index(at))
    }
}

#[cfg(test)]
mod tests {
    use super::super::parts_for_tests::{field_of, part_of};
    use super::*;
    use crate::sample::solids;

    #[test]
    fn a_looked_up_foot_is_on_the_skin_and_hardly_further_than_the_nearest() {
        let part = part_of(&solids::helical_gear(9, 3, 3, 1));
        let field = field_of(&part);
        for i in (0..field.feet.len()).step_by(37) {
            let at = field.middle(field.cell(i));
            let foot = field.foot(&at);
            let place = field.lo + at;
            let exact = part.bvh.closest(&place, f64::INFINITY).expect("facets").distance_mm;
            let off_skin = part.bvh.closest(&(field.lo + foot), f64::INFINITY).expect("facets").distance_mm;
            assert!(off_skin < 1e-4, "{off_skin}");
            let found = (foot - at).norm();
            assert!(found > exact - 1e-4 && found < exact + field.cell_mm, "{found} {exact} {}", field.cell_mm);
        }
        let far = field.foot(&Vector3::repeat(-1e9));
        assert!(far.iter().all(|x| x.is_finite()));
    }
}
