//! How lines and program differ from what was wanted. The sentences follow the surface's name.

use super::{Sentence, exact, fixed, say};
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
            ToolpathRemark::Lines(finding) => finding.sentence(),
        }
    }
}
