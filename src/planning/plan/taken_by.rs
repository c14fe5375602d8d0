//! What takes the last line of a surface: the first step of its toolpath that leaves none. Sentences stand in `text`.

use crate::document::model::LineParameters;
use crate::part::{Mesh, surfaces::Surface};
use crate::path::live_facets::lies_along;
use crate::path::strategy::SurfaceLines;
use crate::path::{LinesFinding, SurfacePlanes};
use serde::Serialize;

/// What takes the last line of a surface. In `report.json` by its word, key `cause`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "cause", rename_all = "snake_case")]
pub enum TakenBy {
    /// The direction: the planes lie along all of the surface.
    Direction,
    /// The spacing: no line fits.
    Spacing {
        /// The spacing that was asked for, mm.
        spacing_mm: f64,
    },
    /// The spacing of a spiral: not one turn fits.
    Turn {
        /// The spacing that was asked for, mm.
        spacing_mm: f64,
    },
    /// The border that lines are to follow is not there.
    Border {
        /// How many borders the surface has; 0: it is closed.
        borders: usize,
        /// The border that was chosen, from 0; `None`: the whole outline.
        border: Option<usize>,
    },
    /// No facet has an area.
    Facets,
    /// The inset from the outline; running on over it, where that leaves nothing.
    Inset {
        /// The inset that was asked for, mm.
        inset_mm: f64,
    },
    /// The same inset from the holes: from the outline alone it would leave lines.
    Holes {
        /// The inset that was asked for, mm.
        inset_mm: f64,
    },
    /// All pieces are shorter than the shortest that are kept.
    Shortest {
        /// The least length that was asked for, mm.
        shortest_mm: f64,
    },
}

impl TakenBy {
    /// Why a strategy laid no line; `None`: it laid some.
    pub(super) fn strategy(
        found: &SurfaceLines,
        mesh: &Mesh,
        surface: &Surface,
        family: &SurfacePlanes,
        layers: &LineParameters,
    ) -> Option<TakenBy> {
        let spacing_mm = layers.spacing_mm;
        let along = || lies_along(mesh, surface, &family.normal);
        let finding = if found.lines.is_empty() { found.finding? } else { return None };
        Some(match finding {
            LinesFinding::NoProperFacet { .. } => TakenBy::Facets,
            LinesFinding::NoBorder { .. } => TakenBy::Border { borders: 0, border: None },
            LinesFinding::NoSuchBorder { border, borders, .. } => TakenBy::Border { borders, border: Some(border) },
            LinesFinding::NoTurnFits { .. } => TakenBy::Turn { spacing_mm },
            LinesFinding::NoPlaneCrosses { .. } | LinesFinding::NoMeanNormal { .. } if along() => TakenBy::Direction,
            LinesFinding::SpacingNotPositive
            | LinesFinding::NoPlaneCrosses { .. }
            | LinesFinding::NoMeanNormal { .. }
            | LinesFinding::NoLineFits { .. }
            | LinesFinding::ApartFromBorder { .. }
            | LinesFinding::BeyondSpiral { .. } => TakenBy::Spacing { spacing_mm },
        })
    }
}
