//! How far arm, head and part keep from everything over a program: looked at on a thread once the curves
//! are shown, and kept for one plan.

use super::App;
use crate::cell::Collision;
use crate::program::{Clearance, clearances};
use crate::progress::Activity;
use std::sync::Arc;

/// A curve of clearance.
#[derive(Debug, Default)]
pub struct ClearanceCurve {
    /// Over the time of the program.
    pub samples: Vec<Clearance>,
    /// The distance that everything has to keep, mm.
    pub margin_mm: f64,
}

impl App {
    /// The clearance of the plan that is shown; `None`: that is being looked at.
    pub(super) fn clearance(&self) -> Option<&Arc<ClearanceCurve>> {
        self.derived.clearance.of(self.derived.plan()?.key)
    }

    /// Looks at the clearance of the plan, one plan at a time: those of a drag are not waited for.
    pub(super) fn sync_clearance(&mut self) {
        self.derived.clearance.poll();
        if !self.session.show.plots || self.derived.clearance.is_running() {
            return;
        }
        let d = &mut self.derived;
        let Some(planned) = d.current_plan(&self.document).cloned() else { return };
        let Some(motion) = d.motion.of(planned.key).cloned() else { return };
        if !d.clearance.lacks(planned.key) {
            return;
        }
        let executor = d.pipeline.executor().clone();
        d.clearance.start(planned.key, Activity::MeasuringClearances, &*executor, move |_| {
            // As the plan asks for arm and head: with all that will be laid, from the first layer on.
            let whole = planned.plan.grown.last().map_or(&*planned.part, |g| &g.part);
            let collision = motion.timeline.as_ref().and_then(|t| Collision::new(t.setup(), whole));
            let curve =
                collision.map(|c| ClearanceCurve { samples: clearances(&motion.curves, &c), margin_mm: c.margin_mm() });
            Ok(curve.unwrap_or_default())
        });
    }
}
