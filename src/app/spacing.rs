//! The achieved spacing of the plan that is shown: made once for each plan, when it is asked for.

use super::App;
use crate::picture::spacing::{SpacingScale, items, scale};
use crate::view::PointItem;

/// Dots and scale, and the number of the plan they are for.
pub(super) struct SpacingView {
    of: u64,
    scale: Option<SpacingScale>,
    items: Vec<PointItem>,
}

impl App {
    /// Brings dots and scale up to date, if they are shown.
    pub(super) fn sync_spacing(&mut self) {
        let Some(planned) = self.derived.plan_on_part().filter(|_| self.session.show.spacing) else { return };
        let (plan, job, of) = (&planned.plan, &planned.job, planned.picture_key());
        if self.spacing.as_ref().is_some_and(|s| s.of == of) {
            return;
        }
        let scale = scale(plan, job);
        let items = scale.as_ref().map_or_else(Vec::new, |scale| items(plan, job, scale, of));
        self.spacing = Some(SpacingView { of, scale, items });
    }

    fn spacing_view(&self) -> Option<&SpacingView> {
        let of = self.derived.plan_on_part()?.picture_key();
        self.spacing.as_ref().filter(|s| self.session.show.spacing && s.of == of)
    }

    /// The scale; `None`: no two lines are neighbours.
    pub(super) fn spacing_scale(&self) -> Option<&SpacingScale> {
        self.spacing_view()?.scale.as_ref()
    }

    /// The dots that are shown.
    pub(super) fn spacing_points(&self) -> &[PointItem] {
        self.spacing_view().map_or(&[], |s| &s.items)
    }
}
