//! Patches cut along several contours: first the one that tells the patch, then every depth at which a bead ends. What a
//! bead fills is not told here.

use super::contour::{NO_PATCH, Pieces};
use super::{PatchCut, RefinedFacets};
use nalgebra::Point3;

/// Refined triangles in pieces, each on one side of every contour.
#[derive(Clone, Debug, Default)]
pub(super) struct Levelled {
    /// The pieces, and the points where contours cross edges, in the order in which they were found.
    pub pieces: Pieces,
    /// Depth at each refined vertex and, behind them, at each of those points, mm; NaN where it is not known.
    pub depth_mm: Vec<f64>,
}

impl Levelled {
    /// Cuts triangles at the contours of `cut`, from the shallowest on.
    pub fn new(refined: &RefinedFacets<'_>, cut: &PatchCut<'_>) -> Levelled {
        let mut pieces = Pieces::new(refined, cut);
        let mut depth_mm = refined.depth_mm.to_vec();
        depth_mm.resize(depth_mm.len() + pieces.cut_points.len(), cut.above_mm);
        for &level_mm in cut.levels_mm {
            let vertices: Vec<Point3<f64>> = refined.vertices.iter().chain(&pieces.cut_points).copied().collect();
            let triangles: Vec<[u32; 3]> = pieces.pieces.iter().map(|p| p.corners).collect();
            let parent: Vec<u32> = pieces.pieces.iter().map(|p| p.parent).collect();
            let mut of_patch = vec![Vec::new(); cut.triangles.len()];
            for (number, piece) in (0..).zip(&pieces.pieces) {
                if let Some(of_patch) = of_patch.get_mut(piece.patch as usize) {
                    of_patch.push(number);
                }
            }
            let before =
                RefinedFacets { vertices: &vertices, triangles: &triangles, parent: &parent, depth_mm: &depth_mm };
            let next = Pieces::new(&before, &PatchCut { above_mm: level_mm, levels_mm: &[], triangles: &of_patch });
            depth_mm.resize(depth_mm.len() + next.cut_points.len(), level_mm);
            let of = |p: &super::Piece| super::Piece { patch: pieces.pieces[p.triangle as usize].patch, ..*p };
            let cut_again = next.pieces.iter().map(of).collect();
            pieces.cut_points.extend(next.cut_points);
            pieces.pieces = cut_again;
        }
        debug_assert!(pieces.pieces.iter().all(|p| p.patch == NO_PATCH || (p.patch as usize) < cut.triangles.len()));
        Levelled { pieces, depth_mm }
    }
}
