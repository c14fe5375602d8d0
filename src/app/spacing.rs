//! The achieved spacing of the plan that is shown: made once for each plan, when it is asked for.

use super::App;
use super::command::Toggle;
use super::context::Context;
use crate::picture::spacing::{SpacingScale, items, scale};
use crate::planning::PlannedJob;
use crate::view::PointItem;

/// Dots and scale of one plan.
#[derive(Default)]
pub(super) struct SpacingView(Option<Made>);

struct Made {
    /// The picture key of the plan.
    of: u64,
    scale: Option<SpacingScale>,
    items: Vec<PointItem>,
}

impl SpacingView {
    /// Makes dots and scale of a plan, unless they are there.
    fn sync(&mut self, planned: &PlannedJob) {
        let (plan, job, of) = (&planned.plan, &planned.job, planned.picture_key());
        if self.of(of).is_none() {
            let scale = scale(plan, job);
            let items = scale.as_ref().map_or_else(Vec::new, |scale| items(plan, job, scale, of));
            self.0 = Some(Made { of, scale, items });
        }
    }

    fn of(&self, plan: u64) -> Option<&Made> {
        self.0.as_ref().filter(|made| made.of == plan)
    }
}

impl App {
    /// Brings dots and scale up to date, if they are shown.
    pub(super) fn sync_spacing(&mut self) {
        if let Some(planned) = self.derived.plan_on_part().filter(|_| self.session.show.is_on(Toggle::Spacing)) {
            self.spacing.sync(planned);
        }
    }
}

impl<'a> Context<'a> {
    fn spacing_shown(self) -> Option<&'a Made> {
        let planned = self.derived.plan_on_part().filter(|_| self.session.show.is_on(Toggle::Spacing))?;
        self.spacing.of(planned.picture_key())
    }

    /// The scale; `None`: no two lines are neighbours.
    pub fn spacing_scale(self) -> Option<&'a SpacingScale> {
        self.spacing_shown()?.scale.as_ref()
    }

    /// The dots that are shown.
    pub fn spacing_points(self) -> &'a [PointItem] {
        self.spacing_shown().map_or(&[], |made| &made.items)
    }
}
