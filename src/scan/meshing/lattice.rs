//! The cells near the points and the surface's signed distance at their corners: where it crosses a cell.
//!
//! Cells are those with a piece of the surface in them, and those up to two cells beside: what lies further from all
//! points is not even looked at. Keys hold three places of 21 bits, so that sorted cells come plane by plane, row by row.

use super::surfels::{Room, Surfels};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

const BITS: u32 = 21;
/// Steps of a key along x, y and z.
pub(super) const STEP: [u64; 3] = [1, 1 << BITS, 1 << (2 * BITS)];
/// Cells along a side at most.
const WIDEST: f64 = 2_000_000.0;
/// A corner further off the pieces, in cells, belongs to no crossed cell: a diagonal, and two cells on.
const FAR: f64 = 4.0;
/// Both ends of a crossed edge together are off the surface by the edge's length at most, and some more where the
/// nearest pieces differ: 1.8 at the sharp edge of a plate that is thin of points. Half-way between two sheets that face
/// the same way, four cells apart, it is 3: no surface.
const CROSSED: f32 = 2.4;
/// Pieces of work.
const PIECE: usize = 1024;

/// A cell that the surface crosses.
#[derive(Clone, Copy, Debug)]
pub(super) struct CrossedCell {
    pub key: u64,
    /// Bit k: corner k lies inside.
    pub inside: u8,
    /// Signed distances of the corners, in cells, above 0 outside.
    off: [f32; 8],
}

/// All crossed cells, by key.
pub(super) struct Lattice {
    pub cells: Vec<CrossedCell>,
    pub cell_mm: f64,
    origin: Point3<f64>,
}

impl Lattice {
    /// Looks at all cells near the pieces. `None` where they are too many along a side.
    pub fn new(surfels: &Surfels, cell_mm: f64, progress: &Progress) -> Result<Option<Lattice>, Cancelled> {
        let feet = || surfels.all.iter().map(|s| s.foot());
        let Some(first) = feet().next() else { return Ok(None) };
        let (lo, hi) = feet().fold((first, first), |(lo, hi), p| (lo.inf(&p), hi.sup(&p)));
        let origin = lo - Vector3::repeat(3.0 * cell_mm);
        let widest = (hi - origin).amax() / cell_mm + 6.0;
        if widest.is_nan() || widest >= WIDEST {
            return Ok(None);
        }
        let key = |p: Point3<f64>| {
            let at = (p - origin) / cell_mm;
            (0..3).map(|k| at[k] as u64 * STEP[k]).sum()
        };
        let mut cells: Vec<u64> = feet().map(key).collect();
        sort(&mut cells, progress)?;
        for step in STEP {
            spread(&mut cells, &[step.wrapping_neg(), step, (2 * step).wrapping_neg(), 2 * step], progress)?;
        }
        let mut corners = cells.clone();
        for step in STEP {
            spread(&mut corners, &[step], progress)?;
        }
        let mut lattice = Lattice { cells: Vec::new(), cell_mm, origin };
        let off = lattice.distances(&corners, surfels, progress)?;
        let crossed: Vec<Vec<CrossedCell>> = cells
            .par_chunks(PIECE)
            .map(|piece| {
                progress.check()?;
                Ok(piece.iter().filter_map(|&key| crossed(key, &corners, &off)).collect())
            })
            .collect::<Result<_, Cancelled>>()?;
        lattice.cells = crossed.concat();
        Ok(Some(lattice))
    }

    /// Signed distances of corners, in cells; NaN where no piece is near.
    fn distances(&self, corners: &[u64], surfels: &Surfels, progress: &Progress) -> Result<Vec<f32>, Cancelled> {
        let off = |key: u64, room: &mut Room| {
            let seen = surfels.seen(&self.place(key, &Vector3::zeros()), FAR * self.cell_mm, room);
            seen.map_or(f32::NAN, |seen| (seen.off_mm / self.cell_mm) as f32)
        };
        let pieces: Vec<Vec<f32>> = corners
            .par_chunks(PIECE)
            .map_init(Room::default, |room, piece| {
                progress.check()?;
                Ok(piece.iter().map(|key| off(*key, room)).collect())
            })
            .collect::<Result<_, Cancelled>>()?;
        Ok(pieces.concat())
    }

    /// Cells of 1 mm from the origin with so many corners to a side, as far as they are crossed.
    #[cfg(test)]
    pub fn of_corners(side: usize, off: impl Fn([usize; 3]) -> f32) -> Lattice {
        let key = |[x, y, z]: [usize; 3]| x as u64 * STEP[0] + y as u64 * STEP[1] + z as u64 * STEP[2];
        let all = |side: usize| (0..side * side * side).map(move |i| [i % side, i / side % side, i / side / side]);
        let (corners, off): (Vec<u64>, Vec<f32>) = all(side).map(|at| (key(at), off(at))).unzip();
        let cells = all(side - 1).filter_map(|at| crossed(key(at), &corners, &off)).collect();
        Lattice { cells, cell_mm: 1.0, origin: Point3::origin() }
    }

    /// A place within a cell, 0 to 1 along each side, mm.
    pub fn place(&self, key: u64, within: &Vector3<f64>) -> Point3<f64> {
        let mask = STEP[1] - 1;
        let at = Vector3::from_fn(|k, _| (key >> (BITS * k as u32) & mask) as f64);
        self.origin + (at + within) * self.cell_mm
    }

    /// Where a cell stands in the list, if the surface crosses it.
    pub fn find(&self, key: u64) -> Option<usize> {
        self.cells.binary_search_by_key(&key, |c| c.key).ok()
    }
}

impl CrossedCell {
    /// Where an edge is crossed, in cells from the lowest corner; `None` in the middle between two sheets. A tenth of
    /// the edge away from its ends, so that no two patches around a corner become one.
    pub fn crossing(&self, corner: usize, axis: usize) -> Option<Vector3<f64>> {
        let (a, b) = (self.off[corner], self.off[corner | 1 << axis]);
        if a.abs() + b.abs() > CROSSED {
            return None;
        }
        let share = f64::from(a) / (f64::from(a) - f64::from(b));
        let mut at = Vector3::from_fn(|k, _| (corner >> k & 1) as f64);
        at[axis] = if share.is_finite() { share.clamp(0.1, 0.9) } else { 0.5 };
        Some(at)
    }
}

fn crossed(key: u64, corners: &[u64], off: &[f32]) -> Option<CrossedCell> {
    let mut found = CrossedCell { key, inside: 0, off: [0.0; 8] };
    for row in 0..4 {
        let start = key + STEP[1] * (row & 1) + STEP[2] * (row >> 1);
        // The corner beside it along x is the next one.
        let at = corners.binary_search(&start).ok()?;
        found.off[2 * row as usize..][..2].copy_from_slice(off.get(at..at + 2)?);
    }
    if found.off.iter().any(|d| d.is_nan()) {
        return None;
    }
    found.inside = (0..8).filter(|k| found.off[*k] < 0.0).map(|k| 1 << k).sum();
    (found.inside != 0 && found.inside != u8::MAX).then_some(found)
}

/// Adds to each key those so many steps away.
fn spread(keys: &mut Vec<u64>, steps: &[u64], progress: &Progress) -> Result<(), Cancelled> {
    let count = keys.len();
    for step in steps {
        keys.extend_from_within(..count);
        let from = keys.len() - count;
        keys[from..].iter_mut().for_each(|k| *k = k.wrapping_add(*step));
    }
    sort(keys, progress)
}

fn sort(keys: &mut Vec<u64>, progress: &Progress) -> Result<(), Cancelled> {
    progress.check()?;
    keys.par_sort_unstable();
    keys.dedup();
    progress.check()
}
