//! Why lines are not as they were wanted, and what is no direction.

use super::{Sentence, fixed, id, say};
use crate::path::{DirectionError, LinesFinding};

impl Sentence for LinesFinding {
    fn sentence(&self) -> String {
        match *self {
            LinesFinding::SpacingNotPositive { spacing_mm } => {
                say!(lines_spacing_not_positive, mm = spacing_mm.to_string())
            }
            LinesFinding::NoProperFacet { surface } => say!(lines_no_proper_facet, surface = id(surface)),
            LinesFinding::NoPlaneCrosses { surface } => say!(lines_no_plane_crosses, surface = id(surface)),
            LinesFinding::NoBorder { surface } => say!(lines_no_border, surface = id(surface)),
            LinesFinding::NoSuchBorder { surface, border, borders } => {
                say!(lines_no_such_border, surface = id(surface), border = id(border + 1), borders)
            }
            LinesFinding::NoLineFits { surface } => say!(lines_none_fits, surface = id(surface)),
            LinesFinding::NoTurnFits { surface, spacing_mm } => {
                say!(lines_no_turn_fits, surface = id(surface), mm = spacing_mm.to_string())
            }
            LinesFinding::NoMeanNormal { surface } => say!(lines_no_mean_normal, surface = id(surface)),
            LinesFinding::ApartFromBorder { surface, area_mm2 } => {
                say!(lines_apart_from_border, surface = id(surface), area = fixed(area_mm2, 1))
            }
            LinesFinding::BeyondSpiral { surface, area_mm2 } => {
                say!(lines_beyond_spiral, surface = id(surface), area = fixed(area_mm2, 1))
            }
        }
    }
}

impl Sentence for DirectionError {
    fn sentence(&self) -> String {
        match self {
            DirectionError::Unknown { text } => say!(direction_unknown, text),
            DirectionError::NoLength { text } => say!(direction_no_length, text),
        }
    }
}
