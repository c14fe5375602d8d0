//! Why a program cannot be written or read.

use super::Sentence;
use crate::program::dialect::{ReadError, WriteError};

impl Sentence for WriteError {
    fn sentence(&self) -> String {
        match self {
            WriteError::Template(e) => e.sentence(),
            other => other.to_string(),
        }
    }
}

impl Sentence for ReadError {
    fn sentence(&self) -> String {
        self.to_string()
    }
}
