//! The order of work: surfaces into it, out of it, and within.

use super::chosen::Chosen;
use super::settings::Settings;
use crate::part::SurfaceId;

impl Settings {
    /// Puts surfaces at the end of the list to clean, also those that were put aside. `all` exist.
    pub(super) fn append(&mut self, list: &[SurfaceId], all: &[SurfaceId]) {
        let mut order = self.without(list, all);
        order.extend(list);
        self.choose(Chosen::These(order));
    }

    /// Takes surfaces out of the list to clean.
    pub(super) fn remove(&mut self, list: &[SurfaceId], all: &[SurfaceId]) {
        let order = self.without(list, all);
        self.choose(Chosen::These(order));
    }

    /// Brings back what was put aside, and cleans what was cleaned before.
    pub(super) fn take_back(&mut self, list: &[SurfaceId], all: &[SurfaceId]) {
        if self.cleans_all() {
            self.choose(Chosen::These(self.chosen(all.iter().copied())));
        }
        self.change_each(list, |s| s.later = false);
    }

    /// Moves surfaces by one place up (-1) or down (1), as a block, keeping their order.
    pub(super) fn shift(&mut self, marked: &[SurfaceId], by: i32, all: &[SurfaceId]) {
        let mut list = self.chosen(all.iter().copied());
        let count = list.len();
        let step = |i: usize| if by < 0 { i.checked_sub(1) } else { (i + 1 < count).then_some(i + 1) };
        let order: Vec<usize> = if by < 0 { (0..count).collect() } else { (0..count).rev().collect() };
        for i in order {
            if let Some(to) = step(i)
                && marked.contains(&list[i])
                && !marked.contains(&list[to])
            {
                list.swap(i, to);
            }
        }
        self.choose(Chosen::These(list));
    }

    fn without(&self, list: &[SurfaceId], all: &[SurfaceId]) -> Vec<SurfaceId> {
        let mut order = self.chosen(all.iter().copied());
        order.retain(|id| !list.contains(id));
        order
    }
}
