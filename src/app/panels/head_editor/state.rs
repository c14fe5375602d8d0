//! A head that is being put together.

use crate::beam::{Head, HeadPart, StackError};

/// The pieces so far, from the focus on.
#[derive(Clone, Debug, PartialEq)]
pub struct HeadDraft {
    /// Cylinders and cones.
    pub parts: Vec<HeadPart>,
}

/// Length of a piece that is added, mm.
const ADDED_MM: f64 = 50.0;

impl HeadDraft {
    /// What a head counts as, to be changed.
    pub fn of(head: Option<&Head>) -> HeadDraft {
        HeadDraft { parts: head.map(|h| h.stack().to_vec()).unwrap_or_default() }
    }

    /// Adds a piece behind the last one, as wide as that ends.
    pub fn add(&mut self) {
        let (from_mm, radius_mm) = self.parts.last().map_or((ADDED_MM, 0.5 * ADDED_MM), |p| (p.to_mm, p.r1_mm));
        self.parts.push(HeadPart { from_mm, to_mm: from_mm + ADDED_MM, r0_mm: radius_mm, r1_mm: radius_mm });
    }

    /// The text of its file.
    ///
    /// # Errors
    /// It is no head yet.
    pub fn text(&self) -> Result<String, StackError> {
        let text = Head::to_toml(&self.parts);
        Head::from_toml(&text).map(|_| text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_piece_is_added_on_top_and_what_is_no_head_is_not_written() {
        let mut draft = HeadDraft::of(None);
        assert_eq!(draft.text(), Err(StackError::Empty));
        draft.add();
        draft.add();
        let spans: Vec<(f64, f64)> = draft.parts.iter().map(|p| (p.from_mm, p.to_mm)).collect();
        assert_eq!(spans, [(50.0, 100.0), (100.0, 150.0)]);
        let text = draft.text().expect("a head");
        assert_eq!(Head::from_toml(&text), Ok(Head::Stack(draft.parts.clone())));
        draft.parts[1].to_mm = 90.0;
        assert!(matches!(draft.text(), Err(StackError::Span { part: 2, .. })));
    }
}
