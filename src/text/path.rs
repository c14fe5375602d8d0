//! Why lines are not as they were wanted, and why a direction is refused.

use super::{Sentence, exact, fixed, id, say};
use crate::path::{DirectionError, LinesFinding};

impl Sentence for LinesFinding {
    fn sentence(&self) -> String {
        match *self {
            LinesFinding::SpacingNotPositive => say!(lines_spacing_not_positive),
            LinesFinding::NoProperFacet { .. } => say!(lines_no_proper_facet),
            LinesFinding::NoPlaneCrosses { .. } => say!(lines_no_plane_crosses),
            LinesFinding::NoBorder { .. } => say!(lines_no_border),
            LinesFinding::NoSuchBorder { border, borders, .. } => {
                say!(lines_no_such_border, border = id(border + 1), borders)
            }
            LinesFinding::NoLineFits { .. } => say!(lines_none_fits),
            LinesFinding::NoTurnFits { spacing_mm, .. } => {
                say!(lines_no_turn_fits, mm = exact(spacing_mm))
            }
            LinesFinding::NoMeanNormal { .. } => say!(lines_no_mean_normal),
            LinesFinding::ApartFromBorder { area_mm2, .. } => {
                say!(lines_apart_from_border, area = fixed(area_mm2, 1))
            }
            LinesFinding::BeyondSpiral { area_mm2, .. } => {
                say!(lines_beyond_spiral, area = fixed(area_mm2, 1))
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
