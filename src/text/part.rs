//! What is wrong with a part's file.

use super::{Sentence, id, say};
use crate::part::LoadError;
use crate::part::stl::StlError;

impl Sentence for LoadError {
    fn sentence(&self) -> String {
        match self {
            LoadError::Io { file, source } => say!(file_not_read, file, reason = source.to_string()),
            LoadError::Stl { file, source } => say!(in_file, file, what = source.sentence()),
        }
    }
}

impl Sentence for StlError {
    fn sentence(&self) -> String {
        match *self {
            StlError::Empty => say!(stl_empty),
            StlError::CutOff { promised, needed, present } => say!(stl_cut_off, promised, needed, present),
            StlError::TextCutOff { facets, byte } => say!(stl_text_cut_off, facets, byte = id(byte)),
            StlError::NotStl => say!(stl_not_stl),
            StlError::NoFacet { dropped, first } => say!(stl_no_facet, dropped, first),
        }
    }
}
