//! How far arm, head and part keep from everything over a program: looked at on a thread once the curves
//! are shown, and kept for one plan.

use super::App;
use super::worker::Outcome;
use crate::cell::Collision;
use crate::program::{Clearance, clearances};
use std::sync::Arc;

/// A curve of clearance.
#[derive(Debug, Default)]
pub struct ClearanceCurve {
    /// Over the time of the program.
    pub samples: Vec<Clearance>,
    /// The distance that everything has to keep, mm.
    pub margin_mm: f64,
}

/// What is known of it, and the number of the plan that it is for.
#[derive(Default)]
pub struct Clearances {
    curve: Option<(u64, Arc<ClearanceCurve>)>,
    is_looking: bool,
}

impl App {
    /// The clearance of the plan that is shown; `None`: that is being looked at.
    pub(super) fn clearance(&self) -> Option<&Arc<ClearanceCurve>> {
        let known = self.derived.clearances.curve.as_ref().filter(|(of, _)| *of == self.derived.plan_count);
        known.map(|(_, curve)| curve)
    }

    /// Looks at the clearance of the plan, one plan at a time: those of a drag are not waited for.
    pub(super) fn sync_clearance(&mut self) {
        if !self.session.show.plots || self.derived.clearances.is_looking || self.clearance().is_some() {
            return;
        }
        // Motion and part belong together only while the plan is of the job as it is.
        if !self.has_current_plan() {
            return;
        }
        let (Some(motion), Some(part)) = (self.derived.motion.clone(), self.derived.part.clone()) else { return };
        let Some((plan, _)) = self.derived.plan.clone() else { return };
        let of = self.derived.plan_count;
        self.derived.clearances.is_looking = true;
        self.worker.spawn(move || {
            let timeline = motion.timeline.as_ref();
            // As the plan asks for arm and head: with all that will be laid, from the first layer on.
            let whole = plan.grown.last().map_or(&*part, |g| &g.part);
            let collision = timeline.and_then(|t| Collision::new(t.setup(), whole));
            let curve =
                collision.map(|c| ClearanceCurve { samples: clearances(&motion.curves, &c), margin_mm: c.margin_mm() });
            Outcome::Cleared(of, Arc::new(curve.unwrap_or_default()))
        });
    }

    pub(super) fn cleared(&mut self, of: u64, curve: Arc<ClearanceCurve>) {
        self.derived.clearances.is_looking = false;
        if of == self.derived.plan_count {
            self.derived.clearances.curve = Some((of, curve));
        }
    }
}
