//! The facets of a leaf as planes in f32, side by side: lower bounds of their distances from a point, at a fraction of
//! the time that the distances take. It rules out, and never tells a distance.

use nalgebra::{Point3, Vector3};

/// Facets looked at together: those of a leaf.
pub(super) const LANES: usize = super::build::LEAF;

/// A point is no nearer to a facet than it stands beyond the facet's plane, and beyond the planes square to that one
/// through its edges: a bound that is the distance itself but beside corners.
#[derive(Clone, Copy, Default)]
pub(super) struct FacetBlock {
    /// Unit: square to the facet, then out of each of its edges.
    dir: [[[f32; LANES]; 3]; 4],
    /// How far the facet reaches along each.
    far: [[f32; LANES]; 4],
    /// Where it begins along the first.
    near: [f32; LANES],
}

impl FacetBlock {
    /// The facets, as many as there are lanes at most. `middle`: what points are told from.
    pub(super) fn of(facets: &[[Point3<f64>; 3]], middle: &Point3<f64>) -> FacetBlock {
        let mut block = FacetBlock::default();
        for (lane, corners) in facets.iter().enumerate().take(LANES) {
            block.put(lane, corners, middle);
        }
        block
    }

    fn put(&mut self, lane: usize, corners: &[Point3<f64>; 3], middle: &Point3<f64>) {
        let d = corners.map(|c| c - middle);
        let normal = unit((d[1] - d[0]).cross(&(d[2] - d[0])));
        let out = |k: usize| unit((d[(k + 1) % 3] - d[k]).cross(&normal));
        for (i, dir) in [normal, out(0), out(1), out(2)].into_iter().enumerate() {
            let along = d.map(|d| dir.dot(&d));
            self.far[i][lane] = along[0].max(along[1]).max(along[2]) as f32;
            if i == 0 {
                self.near[lane] = along[0].min(along[1]).min(along[2]) as f32;
            }
            for k in 0..3 {
                self.dir[i][k][lane] = dir[k] as f32;
            }
        }
    }

    /// Lower bounds of the squared distances from a point, told from the middle; `slack`: see [`shortened`].
    #[inline]
    pub(super) fn squared_gaps(&self, p: [f32; 3], slack: f32) -> [f32; LANES] {
        std::array::from_fn(|j| {
            let along = |i: usize| self.dir[i][0][j] * p[0] + self.dir[i][1][j] * p[1] + self.dir[i][2][j] * p[2];
            let across = along(0);
            let above = larger(across - self.far[0][j], self.near[j] - across);
            let beside = larger(along(1) - self.far[1][j], along(2) - self.far[2][j]);
            let beside = larger(beside, along(3) - self.far[3][j]);
            let (above, beside) = (shortened(above, slack), shortened(beside, slack));
            above * above + beside * beside
        })
    }
}

/// A gap that is certainly not too large, 0 at least: less by `slack`, which is more than the rounding of what is near
/// the mesh, and by a share of itself, for what is far from it.
#[inline]
pub(super) fn shortened(gap: f32, slack: f32) -> f32 {
    larger(gap * 0.99999 - slack, 0.0)
}

/// `f32::max` for numbers: one instruction, where that one looks for NaN as well.
#[inline]
pub(super) fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

fn unit(v: Vector3<f64>) -> Vector3<f64> {
    let length = v.norm();
    if length > 0.0 { v / length } else { Vector3::zeros() }
}
