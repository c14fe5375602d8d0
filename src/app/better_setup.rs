//! What is done about a better set-up: it is looked for, taken into the job, or forgotten. The searches themselves
//! stand in `suggestion_search`.

use super::App;
use crate::document::Edit;
use crate::planning::advice;

impl App {
    /// Looks for a better set-up.
    pub(super) fn find_better_setup(&mut self) {
        let Some(planned) = self.context().refusing_plan().cloned() else { return };
        let (cache, executor) = (self.derived.pipeline.cache.clone(), self.derived.pipeline.executor().clone());
        self.derived.suggestions.find_better_setup(planned, cache, &*executor);
    }

    /// Takes the better set-up into the job.
    pub(super) fn apply_better_setup(&mut self) {
        let Some(better) = self.context().better_setup() else { return };
        let cell = advice::applied(&self.document.job().cell, better.setup.mount, &better.found);
        self.derived.suggestions.forget_better_setup();
        self.edit(Edit::Frames(Box::new(cell)));
    }

    /// Forgets the better set-up; whether there was one, or word that there is none.
    pub(super) fn dismiss_better_setup(&mut self) -> bool {
        let there = self.context().better_setup().is_some() || self.context().has_no_better_setup();
        self.derived.suggestions.forget_better_setup();
        there
    }
}
