//! Samples of the surface: facets cut into pieces no wider than a quarter of the spot where light
//! comes; a facet, or a piece of one, that no light comes near stays large.

use super::facet_polygon::{FacetPolygon, Plane};
use super::light::Light;
use super::lit_facets::NearPiece;
use crate::pose::Obstruction;
use nalgebra::Point3;
use std::ops::Range;

/// Greatest number of samples, some 400 MB; beyond it they are cut more coarsely.
pub const MOST_SAMPLES: usize = 4_000_000;

/// A piece of the surface and what lands on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DoseSample {
    /// Its middle, mm, part frame.
    pub centre: [f32; 3],
    /// Its area, mm².
    pub area_mm2: f32,
    /// The facet that it is cut from.
    pub facet: u32,
    /// Where its corners begin in [`DoseMap::corners`](super::DoseMap::corners).
    pub first_corner: u32,
    /// How many it has.
    pub corner_count: u8,
    /// How many passes went over it with their spot.
    pub passes: u16,
    /// Energy per area, J/cm².
    pub fluence_j_cm2: f32,
    /// What it would be if nothing shaded it.
    pub unshaded_j_cm2: f32,
    /// Angle between light and normal, degrees, weighed by energy; −1 where nothing lands.
    pub incidence_deg: f32,
    /// What keeps the most energy off.
    pub shaded_by: Option<Obstruction>,
}

/// A piece of a facet that is to be cut, and the light that comes near it.
pub struct FacetPiece {
    /// Its facet.
    pub facet: u32,
    /// The facet's plane.
    pub plane: Plane,
    /// The piece.
    pub cell: FacetPolygon,
    /// In the order of the program.
    pub near: Vec<NearPiece>,
    /// Where no light comes, pieces are no wider than this, mm.
    pub dark_mm: f64,
}

impl FacetPiece {
    /// A whole facet.
    pub fn of(facet: u32, corners: &[Point3<f64>; 3], near: Vec<NearPiece>, dark_mm: f64) -> FacetPiece {
        let (plane, cell) = Plane::of(corners);
        FacetPiece { facet, plane, cell, near, dark_mm }
    }
}

/// Cuts a piece of a facet until what it falls into is no wider than a square of `pitch_mm`, or no light comes near,
/// and hands every piece on with the light that does.
pub fn cut_facet_piece(
    light: &Light,
    pitch_mm: f64,
    facet_piece: &FacetPiece,
    mut leaf: impl FnMut(&FacetPolygon, &[NearPiece]),
) {
    let mut lists = facet_piece.near.clone();
    let whole = lists.len();
    Cutter { light, pitch_mm, facet_piece }.halve(&facet_piece.cell, &mut lists, 0..whole, &mut leaf);
}

/// A piece of a facet that is being cut.
struct Cutter<'a> {
    light: &'a Light,
    pitch_mm: f64,
    facet_piece: &'a FacetPiece,
}

impl Cutter<'_> {
    /// Cuts a cell. `lists`: the light near all cells that this one is a piece of, one behind the other; `of` is the
    /// range of the last one's.
    fn halve(
        &self,
        cell: &FacetPolygon,
        lists: &mut Vec<NearPiece>,
        of: Range<usize>,
        leaf: &mut impl FnMut(&FacetPolygon, &[NearPiece]),
    ) {
        let (middle, radius) = cell.disc();
        let centre = self.facet_piece.plane.place(middle);
        let end = of.end;
        for i in of {
            let near = lists[i];
            if self.light.reaches(&self.light.pieces[near.piece as usize], &centre, radius) {
                lists.push(near);
            }
        }
        let all = lists.len();
        let is_dark = all == end && cell.size_mm() <= self.facet_piece.dark_mm;
        match cell.halves(self.pitch_mm).filter(|_| !is_dark) {
            None => leaf(cell, &lists[end..]),
            Some(halves) => {
                for half in halves {
                    self.halve(&half, lists, end..all, leaf);
                }
            }
        }
        lists.truncate(end);
    }
}

/// Divides a piece of a facet into smaller ones for parallel work.
pub fn split_facet_piece(light: &Light, pitch_mm: f64, facet_piece: FacetPiece) -> Vec<FacetPiece> {
    if facet_piece.cell.size_mm() <= pitch_mm {
        return vec![facet_piece];
    }
    let mut out = Vec::new();
    cut_facet_piece(light, pitch_mm, &facet_piece, |cell, near| {
        out.push(FacetPiece { cell: *cell, near: near.to_vec(), ..facet_piece });
    });
    out
}
