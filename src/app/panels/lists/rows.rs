//! Which surfaces stand in which list, filtered and sorted.

use super::super::super::context::Context;
use super::super::super::session::Column;
use std::collections::BTreeSet;

/// One of the two lists, as it is drawn.
#[derive(Clone, Copy)]
pub(super) struct List<'a> {
    /// Surfaces, from top to bottom.
    pub rows: &'a [u32],
    /// Whether it is the list to clean.
    pub is_clean: bool,
    /// What it is drawn from.
    pub context: Context<'a>,
}

impl Context<'_> {
    /// Rows of the left list as they stand: filtered and sorted.
    pub fn rows_left(self) -> Vec<u32> {
        let (d, job) = (self.derived, self.document.job());
        let mut rows: Vec<u32> = self.not_to_clean().into_iter().filter(|n| self.passes_filter(*n, 0)).collect();
        let area = |n: u32| d.surfaces.get(n).map_or(0.0, |s| s.area_mm2);
        let (column, turned) = self.session.sort;
        match column {
            Column::Number => {}
            Column::Shape => rows.sort_by_key(|&n| d.label(job, n)),
            Column::Area => rows.sort_by(|&a, &b| area(b).total_cmp(&area(a))),
        }
        if turned {
            rows.reverse();
        }
        rows
    }

    /// Rows of the list to clean as they stand: filtered, in the order of work.
    pub fn rows_to_clean(self) -> Vec<u32> {
        self.clean_list().into_iter().filter(|&n| self.passes_filter(n, 1)).collect()
    }

    /// Surfaces that are neither to be cleaned nor put aside.
    pub fn not_to_clean(self) -> Vec<u32> {
        let listed: BTreeSet<u32> = self.clean_list().into_iter().chain(self.later_list()).collect();
        let mut rest = self.derived.numbers();
        rest.retain(|n| !listed.contains(n));
        rest
    }

    fn passes_filter(self, n: u32, list: usize) -> bool {
        let filter = self.session.filter[list].trim().to_lowercase();
        filter.is_empty()
            || format!("{n} {}", self.derived.label(self.document.job(), n)).to_lowercase().contains(&filter)
    }
}
