//! One line of a text as numbers.

use crate::scan::file::decimal::{Comma, cell, ends_cell};

/// So many columns of a line are read; those behind them are counted.
pub(in super::super) const MOST: usize = 32;

/// The cells of a line.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Row {
    /// Its numbers; NaN where a cell is none.
    pub values: [f64; MOST],
    /// Cells.
    pub width: usize,
    /// A bit for each of the first cells that is a word, or empty.
    pub words: u64,
}

/// Whether a line is a comment.
#[inline]
pub(in super::super) fn is_comment(line: &[u8]) -> bool {
    let begin = line.trim_ascii_start();
    matches!(begin.first(), Some(b'#' | b'%' | b'!')) || begin.starts_with(b"//")
}

impl Row {
    /// Takes a line apart. Blanks divide cells; so does a semicolon or comma, and two of these have an empty cell
    /// between them.
    #[inline]
    pub fn of(line: &[u8], comma: Comma) -> Row {
        let mut row = Row { values: [f64::NAN; MOST], width: 0, words: 0 };
        let mut at = 0;
        loop {
            while matches!(line.get(at), Some(b' ' | b'\t')) {
                at += 1;
            }
            let Some(byte) = line.get(at) else { return row };
            let (value, len) = if ends_cell(*byte, comma) { (None, 0) } else { cell(&line[at..], comma) };
            match (row.values.get_mut(row.width), value) {
                (Some(place), Some(value)) => *place = value,
                (Some(_), None) => row.words |= 1 << row.width,
                (None, _) => {}
            }
            row.width += 1;
            at += len;
            while matches!(line.get(at), Some(b' ' | b'\t')) {
                at += 1;
            }
            if line.get(at).is_some_and(|b| ends_cell(*b, comma)) {
                at += 1;
            }
        }
    }

    /// Whether a cell is there and a number.
    #[inline]
    pub fn is_number(&self, column: usize) -> bool {
        column < self.width.min(MOST) && self.words & (1 << column) == 0
    }

    /// The number of a line that has one whole number alone.
    pub fn count(&self) -> Option<u64> {
        let value = self.values[0];
        (self.width == 1 && value >= 0.0 && value.fract() == 0.0 && value < 1e15).then_some(value as u64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(line: &str, comma: Comma) -> (Vec<f64>, u64) {
        let row = Row::of(line.as_bytes(), comma);
        (row.values[..row.width].to_vec(), row.words)
    }

    #[test]
    fn cells_are_divided_by_blanks_commas_and_semicolons() {
        let expected = (vec![1.0, -2.5, 3e4], 0);
        for line in ["1 -2.5 3e4", "\t1,-2.5, 3e4 ", "1;-2.5;3e4;", "1 , -2.5 ; 3e4", "1,-2.5,3e4,"] {
            assert_eq!(row(line, Comma::Delimits), expected, "{line}");
        }
        assert_eq!(row("1;-2,5;3e4", Comma::IsPoint), expected);
        let (values, words) = row("1,,x,4", Comma::Delimits);
        assert_eq!((values.len(), words, values[3]), (4, 0b110, 4.0));
    }

    #[test]
    fn a_count_stands_alone() {
        assert_eq!(Row::of(b"120000\r", Comma::Delimits).count(), Some(120_000));
        for none in ["1 2", "1.5", "-3", "x", ""] {
            assert_eq!(Row::of(none.as_bytes(), Comma::Delimits).count(), None, "{none}");
        }
    }
}
