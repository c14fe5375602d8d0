//! Which surfaces are selected, hidden, and moved between the two lists.

use super::App;
use super::command::{More, RowStep};
use crate::document::Edit;
use crate::part::{Shape, SurfaceId, angle};
use nalgebra::Vector3;

impl App {
    /// Moves the selection to the list to clean or back. It stays selected, so that the same key does nothing more;
    /// the arrow keys go on from the neighbour that it had.
    pub(super) fn move_selected(&mut self, to_clean: bool) {
        let clean = self.context().clean_list();
        let list: Vec<u32> = self.session.selected.iter().copied().filter(|n| clean.contains(n) != to_clean).collect();
        let from: Vec<u32> = if to_clean { self.context().rows_left() } else { clean };
        let neighbour = from
            .iter()
            .position(|n| list.contains(n))
            .and_then(|at| from[at..].iter().chain(from[..at].iter().rev()).find(|n| !list.contains(n)).copied());
        let list = list.into_iter().map(SurfaceId).collect();
        self.edit(if to_clean { Edit::Clean(list) } else { Edit::Unclean(list) });
        self.session.anchor = neighbour;
    }

    /// Selects the row below or above, in the list that the last one stands in.
    pub(super) fn select_row(&mut self, step: RowStep) {
        let context = self.context();
        let (left, clean) = (context.rows_left(), context.rows_to_clean());
        let anchor = self.session.anchor.or(self.session.selected.first().copied());
        let rows = if anchor.is_some_and(|n| clean.contains(&n)) { clean } else { left };
        let Some(last) = rows.len().checked_sub(1) else { return };
        let at = anchor.and_then(|n| rows.iter().position(|&r| r == n));
        let at = match (at, step) {
            // Beside a surface that was moved the neighbour comes first.
            (Some(at), _) if !self.session.selected.contains(&rows[at]) => at,
            (Some(at), RowStep::Below) => (at + 1).min(last),
            (Some(at), RowStep::Above) => at.saturating_sub(1),
            (None, RowStep::Below) => 0,
            (None, RowStep::Above) => last,
        };
        let n = rows[at];
        self.session.selected = [n].into();
        (self.session.anchor, self.session.scroll_to) = (Some(n), Some(n));
    }

    /// Selects more surfaces.
    pub(super) fn select_more(&mut self, which: More) {
        let d = &self.derived;
        let selected = self.session.selected.clone();
        let normal = |n: u32| match d.shape(n) {
            Some(Shape::Plane { normal }) => Some(*normal),
            _ => None,
        };
        let same_shape = |a: u32, b: u32| match (d.shape(a), d.shape(b)) {
            (Some(x), Some(y)) => x.is_like(y),
            _ => false,
        };
        let near = |a: Vector3<f64>, b: u32| normal(b).is_some_and(|v| angle::between_deg(&a, &v) < 1.0);
        let more: Vec<u32> = match which {
            More::Listed => self.context().rows_left(),
            More::SameShape => {
                d.numbers().into_iter().filter(|&n| selected.iter().any(|&s| same_shape(s, n))).collect()
            }
            More::SameNormal => {
                let normals: Vec<Vector3<f64>> = selected.iter().filter_map(|&s| normal(s)).collect();
                d.numbers().into_iter().filter(|&n| normals.iter().any(|&a| near(a, n))).collect()
            }
            More::Larger => {
                let area = |n: u32| d.surfaces.get(n).map_or(0.0, |s| s.area_mm2);
                let least = selected.iter().map(|&n| area(n)).fold(f64::INFINITY, f64::min);
                d.numbers().into_iter().filter(|&n| area(n) >= least).collect()
            }
            More::Neighbours => match &d.part {
                Some(part) => selected.iter().flat_map(|&s| d.surfaces.neighbours(&part.mesh, s)).collect(),
                None => Vec::new(),
            },
        };
        self.session.selected.extend(more);
    }

    /// Hides all surfaces that are not selected.
    pub(super) fn isolate(&mut self) {
        let all = self.derived.numbers();
        self.session.hidden = all.into_iter().filter(|n| !self.session.selected.contains(n)).collect();
    }
}
