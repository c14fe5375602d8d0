//! Why the lines of a surface differ from what was asked for, or why there are none. Sentences stand in `text`.

use serde::Serialize;

/// How a surface's lines differ from what was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum LinesFinding {
    /// There are no lines: the spacing is not greater than 0.
    SpacingNotPositive,
    /// There are no lines: no facet of the surface has an area.
    NoProperFacet {
        /// Surface number.
        surface: u32,
    },
    /// There are no lines: the planes pass beside the surface.
    NoPlaneCrosses {
        /// Surface number.
        surface: u32,
    },
    /// There are no lines: the surface is closed, and lines at equal distance need a border.
    NoBorder {
        /// Surface number.
        surface: u32,
    },
    /// There are no lines: the surface has fewer borders.
    NoSuchBorder {
        /// Surface number.
        surface: u32,
        /// The border that was chosen, from 0.
        border: usize,
        /// How many there are.
        borders: usize,
    },
    /// There are no lines: not even one fits within the border.
    NoLineFits {
        /// Surface number.
        surface: u32,
    },
    /// There are no lines: not even one turn of a spiral fits.
    NoTurnFits {
        /// Surface number.
        surface: u32,
        /// Wanted distance of its turns, mm.
        spacing_mm: f64,
    },
    /// The second raster of a cross is left out: the surface has no mean normal to turn it about.
    NoMeanNormal {
        /// Surface number.
        surface: u32,
    },
    /// A part of the surface hangs together with no facet of the chosen border, and has no lines.
    ApartFromBorder {
        /// Surface number.
        surface: u32,
        /// Its area, mm².
        area_mm2: f64,
    },
    /// A part of the surface is not reached by its spiral.
    BeyondSpiral {
        /// Surface number.
        surface: u32,
        /// Its area, mm².
        area_mm2: f64,
    },
}
