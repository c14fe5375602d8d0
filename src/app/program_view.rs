//! Which file and lines of the program's text are in sight, and how they follow the simulation.

use std::ops::Range;

/// The part of the program's text that is in sight.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProgramView {
    /// The file that is shown, by its place in the program.
    pub file: usize,
    /// File and line that were last scrolled to.
    pub line: Option<(usize, usize)>,
    /// Rows of the file that are in sight.
    pub rows: Range<usize>,
}

impl ProgramView {
    /// Shows the file of the current line whenever that line changes; until then another file can be looked at. Returns
    /// whether the line has changed.
    pub fn follow(&mut self, current: Option<(usize, usize)>, files: usize) -> bool {
        let moved = current.filter(|_| current != self.line);
        if let Some((file, _)) = moved {
            self.file = file;
        }
        self.file = self.file.min(files.saturating_sub(1));
        moved.is_some()
    }

    /// Whether a row is in sight with some rows around it.
    pub fn shows(&self, row: usize) -> bool {
        (self.rows.start + 2..self.rows.end.saturating_sub(2)).contains(&row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_follows_the_line_until_another_is_looked_at() {
        let mut view = ProgramView::default();
        assert!(view.follow(Some((2, 7)), 5), "the line has changed");
        assert_eq!(view.file, 2);
        view.line = Some((2, 7));
        view.file = 4;
        assert!(!view.follow(Some((2, 7)), 5));
        assert_eq!(view.file, 4, "the line is still the same: the other file stays");
        assert!(!view.follow(None, 3));
        assert_eq!(view.file, 2, "a program of fewer files");
    }

    #[test]
    fn rows_at_the_edge_are_not_well_in_sight() {
        let view = ProgramView { rows: 10..20, ..ProgramView::default() };
        assert_eq!([11, 12, 17, 18].map(|row| view.shows(row)), [false, true, true, false]);
    }
}
