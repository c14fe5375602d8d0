//! The shelves that recipes stand on, and what they are called.

use crate::text::say;

/// Where a recipe stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shelf {
    /// In the job.
    Job,
    /// In the user's folder.
    Mine,
    /// In the program.
    Shipped,
}

impl Shelf {
    /// Heading of its recipes.
    pub fn title(self) -> String {
        match self {
            Shelf::Job => say!(library_in_job),
            Shelf::Mine => say!(library_mine),
            Shelf::Shipped => say!(library_shipped),
        }
    }

    /// Short name, where recipes of all shelves stand in a row.
    pub fn word(self) -> String {
        match self {
            Shelf::Job => say!(library_job_word),
            Shelf::Mine => say!(library_mine_word),
            Shelf::Shipped => say!(library_shipped_word),
        }
    }
}
