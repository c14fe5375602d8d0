//! Which surfaces are selected, hidden, and moved between the two lists.

use super::App;
use super::command::More;
use crate::document::Edit;
use crate::part::{Shape, SurfaceId, angle};
use nalgebra::Vector3;

impl App {
    /// Moves the selection to the list to clean or back; focus stays on the neighbour.
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
        self.session.selected = neighbour.into_iter().collect();
        self.session.anchor = neighbour;
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
