//! How lines and program differ from what was wanted. The sentences follow the surface's name.

use super::{Sentence, exact, fixed, id, say};
use crate::planning::TakenBy;
use crate::planning::remark::{Remark, ToolpathRemark};

impl Sentence for Remark {
    fn sentence(&self) -> String {
        match self {
            Remark::Toolpath(remark) => remark.sentence(),
            Remark::Program(shortfall) => shortfall.sentence(),
        }
    }
}

impl Sentence for ToolpathRemark {
    fn sentence(&self) -> String {
        match self {
            ToolpathRemark::LayersAlike => say!(remark_layers_alike),
            ToolpathRemark::StopsAtRim { ends } => say!(remark_stops_at_rim, ends = *ends),
            ToolpathRemark::TooShort { pieces, length_mm, shortest_mm } => {
                let (length, shortest) = (fixed(*length_mm, 1), exact(*shortest_mm));
                say!(remark_too_short, pieces = *pieces, length, shortest)
            }
            ToolpathRemark::NoLines { taken_by, area_mm2, layer } => {
                let (area, why) = (fixed(*area_mm2, 2), taken_by.sentence());
                say!(remark_no_lines, layer = id(layer + 1), area, why)
            }
            ToolpathRemark::Lines(finding) => finding.sentence(),
        }
    }
}

impl Sentence for TakenBy {
    fn sentence(&self) -> String {
        match *self {
            TakenBy::Direction => say!(taken_by_direction),
            TakenBy::Spacing { spacing_mm } => say!(taken_by_spacing, mm = exact(spacing_mm)),
            TakenBy::Turn { spacing_mm } => say!(taken_by_turn, mm = exact(spacing_mm)),
            TakenBy::Border { border: None, .. } => say!(taken_by_no_border),
            TakenBy::Border { borders, border: Some(border) } => {
                say!(taken_by_border, border = id(border + 1), borders)
            }
            TakenBy::Facets => say!(taken_by_facets),
            TakenBy::Inset { inset_mm } => say!(taken_by_inset, mm = exact(inset_mm)),
            TakenBy::Holes { inset_mm } => say!(taken_by_holes, mm = exact(inset_mm)),
            TakenBy::Shortest { shortest_mm } => say!(taken_by_shortest, mm = exact(shortest_mm)),
        }
    }
}
