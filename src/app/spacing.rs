//! The achieved spacing of the plan that is shown: made once for each plan, when it is asked for.

use crate::picture::spacing::{SpacingScale, items, scale};
use crate::planning::PlannedJob;
use crate::view::PointItem;

/// What is shown of the spacing, kept for one plan.
#[derive(Default)]
pub(super) struct SpacingView(Option<SpacingPicture>);

/// Dots and scale of a plan.
pub(super) struct SpacingPicture {
    /// The picture key of the plan.
    of: u64,
    /// The scale; `None`: no two lines are neighbours.
    pub scale: Option<SpacingScale>,
    /// The dots on the lines, in the part's frame.
    pub dots: Vec<PointItem>,
}

impl SpacingView {
    /// Makes dots and scale of a plan, unless they are there.
    pub fn sync(&mut self, planned: &PlannedJob) {
        if self.of(planned).is_none() {
            let (plan, job, of) = (&planned.plan, &planned.job, planned.picture_key());
            let scale = scale(plan, job);
            let dots = scale.as_ref().map_or_else(Vec::new, |scale| items(plan, job, scale, of));
            self.0 = Some(SpacingPicture { of, scale, dots });
        }
    }

    /// Dots and scale of a plan, once they are made.
    pub fn of(&self, planned: &PlannedJob) -> Option<&SpacingPicture> {
        self.0.as_ref().filter(|made| made.of == planned.picture_key())
    }
}
