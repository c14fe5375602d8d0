//! What is wrong with the files of a cell: cell, robot, head.

use super::Sentence;
use crate::beam::HeadError;
use crate::cell::{CellError, RobotError};

impl Sentence for HeadError {
    fn sentence(&self) -> String {
        match self {
            HeadError::Solid(e) => e.sentence(),
            other => other.to_string(),
        }
    }
}

impl Sentence for RobotError {
    fn sentence(&self) -> String {
        self.to_string()
    }
}

impl Sentence for CellError {
    fn sentence(&self) -> String {
        self.to_string()
    }
}
