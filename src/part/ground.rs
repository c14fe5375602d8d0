//! What grinding takes off a surface, pass after pass (P4): the heights at its vertices and the level that each pass grinds
//! down to, kept with the surfaces so that whoever plans passes knows where each is needed. Which surfaces those are is told
//! by `patched`.

use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;

/// A surface that is ground. Lengths mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ground {
    /// Number of the surface.
    pub surface: u32,
    /// Number of the surface that it was cut out of: what is ground off is that again.
    pub cut_from: u32,
    /// How high it stands above that surface at each of its vertices before the first pass.
    pub height_mm: BTreeMap<u32, f64>,
    /// The height that each pass grinds down to, falling; none where nothing stands: it is ground once, as it is.
    pub levels_mm: Vec<f64>,
    /// The centre line of a bead, part frame; none where the surface is not long and narrow.
    pub centre_line: Vec<CentrePoint>,
}

/// A point of a centre line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentrePoint {
    /// On the surface that the bead stands on, mm.
    pub p: Point3<f64>,
    /// Its normal there, unit.
    pub n: Vector3<f64>,
}

super::keyed!(CentrePoint { p, n });

/// Heights within this of a level are ground by it: contours are cut through vertices there, to the digits of a height.
const GROUND_MM: f64 = 1e-9;

impl Ground {
    /// Whether anything stands on it, so that there are passes.
    pub fn is_bead(&self) -> bool {
        !self.levels_mm.is_empty()
    }

    /// How high it stands where it is highest, mm.
    pub fn highest_mm(&self) -> f64 {
        self.height_mm.values().copied().fold(0.0, f64::max)
    }

    /// How many passes it takes.
    pub fn passes(&self) -> u32 {
        self.levels_mm.len().max(1) as u32
    }

    /// How high it stands at a vertex behind so many passes; `None`: the vertex is none of its own.
    pub fn standing_mm(&self, vertex: u32, passes: u32) -> Option<f64> {
        let height_mm = *self.height_mm.get(&vertex)?;
        let level_mm = (passes as usize).checked_sub(1).and_then(|at| self.levels_mm.get(at).or(self.levels_mm.last()));
        Some(level_mm.map_or(height_mm, |level_mm| height_mm.min(*level_mm)))
    }

    /// Whether a pass, from 1, leaves a facet with these corners alone, because nothing stands above its level there.
    pub fn is_below(&self, corners: &[u32; 3], pass: u32) -> bool {
        let Some(level_mm) = (pass as usize).checked_sub(1).and_then(|at| self.levels_mm.get(at)) else { return true };
        corners.iter().all(|v| self.height_mm.get(v).is_none_or(|height_mm| *height_mm <= level_mm + GROUND_MM))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_pass_lowers_what_stands_above_its_level_and_nothing_else() {
        let height_mm: BTreeMap<u32, f64> = [(0, 0.2), (1, 1.0), (2, 2.4)].into();
        let bead = Ground { height_mm, levels_mm: vec![2.0, 1.0, 0.0], ..Ground::default() };
        let standing = |passes: u32| [0, 1, 2].map(|v| bead.standing_mm(v, passes).expect("its own"));
        assert_eq!([0, 1, 2, 3].map(standing), [[0.2, 1.0, 2.4], [0.2, 1.0, 2.0], [0.2, 1.0, 1.0], [0.0; 3]]);
        assert_eq!(standing(9), [0.0; 3]);
        assert_eq!(bead.standing_mm(7, 1), None);
        let below = |corners: [u32; 3]| [1, 2, 3].map(|pass| bead.is_below(&corners, pass));
        assert_eq!(below([0, 1, 2]), [false; 3]);
        assert_eq!(below([0, 1, 1]), [true, true, false]);
        assert!(bead.is_below(&[0, 1, 2], 0) && bead.is_below(&[0, 1, 2], 4), "no pass grinds there");
    }
}
