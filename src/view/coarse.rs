//! A coarser mesh that stands for one of very many facets while the camera moves: all corners within one cell of a
//! grid become one of them, and facets that this leaves without area are gone.

use rayon::prelude::*;
use std::collections::HashMap;

/// A mesh with fewer facets.
pub(super) struct CoarseMesh {
    /// Three corners per facet.
    pub positions: Vec<[f32; 3]>,
    /// Which facet of the whole mesh each is: it has its colour.
    pub facets: Vec<u32>,
}

impl CoarseMesh {
    /// The mesh with about `at_most` facets, never more.
    pub fn of(positions: &[[f32; 3]], at_most: usize) -> Self {
        let mut grid = Grid::around(positions, at_most);
        let mut facets = grid.kept(positions);
        // Each cell holds as many vertices as its area has, so the count falls with the square of the side.
        while facets.len() > at_most {
            grid.side_mm *= (facets.len() as f32 / at_most.max(1) as f32).sqrt().clamp(1.05, 4.0);
            facets = grid.kept(positions);
        }
        let mut corner_of: HashMap<u64, [f32; 3]> = HashMap::new();
        let mut corner = |at: [f32; 3]| *corner_of.entry(grid.cell(at)).or_insert(at);
        let positions = facets.iter().flat_map(|&f| [0, 1, 2].map(|k| positions[3 * f as usize + k]));
        Self { positions: positions.map(&mut corner).collect(), facets }
    }
}

/// Cells of one size.
struct Grid {
    lowest: [f32; 3],
    side_mm: f32,
}

impl Grid {
    /// Cells in which a mesh without folds has that many facets: two for each cell that it crosses.
    fn around(positions: &[[f32; 3]], facets: usize) -> Self {
        let lowest = positions.iter().fold([f32::INFINITY; 3], |low, at| [0, 1, 2].map(|k| low[k].min(at[k])));
        let area_mm2: f64 = positions.par_chunks_exact(3).map(|c| area_mm2(c[0], c[1], c[2])).sum();
        let side_mm = (2.0 * area_mm2 / facets.max(1) as f64).sqrt() as f32;
        Self { lowest, side_mm: side_mm.max(f32::MIN_POSITIVE) }
    }

    /// Which cell a place is in: 21 bits an axis.
    fn cell(&self, at: [f32; 3]) -> u64 {
        let along = |k: usize| (((at[k] - self.lowest[k]) / self.side_mm) as u64).min((1 << 21) - 1);
        along(0) | along(1) << 21 | along(2) << 42
    }

    /// The facets whose corners are in three cells.
    fn kept(&self, positions: &[[f32; 3]]) -> Vec<u32> {
        let is_kept = |facet: &[[f32; 3]]| {
            let [a, b, c] = [0, 1, 2].map(|k| self.cell(facet[k]));
            a != b && b != c && c != a
        };
        let facets = positions.par_chunks_exact(3).enumerate();
        facets.filter(|(_, facet)| is_kept(facet)).map(|(index, _)| index as u32).collect()
    }
}

fn area_mm2(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|corner| nalgebra::Vector3::from(corner).cast::<f64>());
    let area_mm2 = (b - a).cross(&(c - a)).norm() / 2.0;
    if area_mm2.is_finite() { area_mm2 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::solids;

    fn flat(triangles: &[[[f64; 3]; 3]]) -> Vec<[f32; 3]> {
        triangles.as_flattened().iter().map(|at| at.map(|x| x as f32)).collect()
    }

    /// A sphere stays one: no coarse corner is off it, and no hole is seen through.
    #[test]
    fn a_coarse_sphere_is_a_sphere() {
        let fine = flat(&solids::sphere(50.0, 300, 150));
        for at_most in [2000, 20_000] {
            let coarse = CoarseMesh::of(&fine, at_most);
            assert!(coarse.facets.len() <= at_most && coarse.facets.len() > at_most / 4, "{}", coarse.facets.len());
            assert_eq!(coarse.positions.len(), 3 * coarse.facets.len());
            assert!(coarse.positions.iter().all(|at| fine.contains(at)));
            let area: f64 = coarse.positions.chunks_exact(3).map(|c| area_mm2(c[0], c[1], c[2])).sum();
            let whole = 4.0 * std::f64::consts::PI * 50.0 * 50.0;
            assert!((0.9..1.1).contains(&(area / whole)), "{at_most}: {area} of {whole} mm²");
        }
    }

    /// A cube's large facets stay what they are, beside as many fine ones as one likes.
    #[test]
    fn large_facets_stay() {
        let cube = solids::cube(100.0);
        let fine = solids::sphere(1.0, 200, 100);
        let coarse = CoarseMesh::of(&flat(&[cube.clone(), fine].concat()), 500);
        let large = coarse.facets.iter().filter(|f| (**f as usize) < cube.len()).count();
        assert_eq!(large, cube.len());
    }

    #[test]
    fn neither_nothing_nor_nonsense_is_a_fault() {
        for positions in [vec![], vec![[f32::NAN; 3]; 9], vec![[f32::MAX, f32::MIN, 0.0]; 9], vec![[1e-40; 3]; 9]] {
            assert!(CoarseMesh::of(&positions, 1).facets.len() <= 1);
        }
    }
}
