//! Remarks: how lines or program differ from what the job asks for, though they are there. Sentences stand in `text`.

use super::taken_by::TakenBy;
use crate::path::LinesFinding;
use crate::program::Shortfall;
use serde::Serialize;

/// A remark on a surface's lines, or on its share of the program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Remark {
    /// On its lines.
    Toolpath(ToolpathRemark),
    /// On the program that works on it.
    Program(Shortfall),
}

/// What of a surface's lines is not as it was wanted. In `report.json` by its code.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum ToolpathRemark {
    /// Every second layer was to run across the others, and all run alike: the planes lie across the mean normal,
    /// or the surface has none.
    LayersAlike,
    /// Ends that were to run on over the rim, and stop there: at a sharp edge, or the part's end.
    StopsAtRim {
        /// How many.
        ends: usize,
    },
    /// Pieces of lines that are left out as too short.
    TooShort {
        /// How many.
        pieces: usize,
        /// Their length together, mm.
        length_mm: f64,
        /// The least length that was asked for, mm.
        shortest_mm: f64,
    },
    /// There is no line at all.
    NoLines {
        /// What takes the last one.
        #[serde(flatten)]
        taken_by: TakenBy,
        /// The area of the surface, mm².
        area_mm2: f64,
        /// Layer of a build-up, from 0.
        layer: u32,
    },
    /// What the strategy could not do as it was asked.
    #[serde(untagged)]
    Lines(LinesFinding),
}
