//! The commands about a better set-up: look for one, take it into the job, or dismiss it. The searches themselves are
//! in `remedy`.

use super::App;
use crate::document::Edit;
use crate::planning::advice;

impl App {
    /// Looks for a better set-up.
    pub(super) fn propose(&mut self) {
        let Some(planned) = self.context().refusing_plan().cloned() else { return };
        let (cache, executor) = (self.derived.pipeline.cache.clone(), self.derived.pipeline.executor().clone());
        self.derived.remedy.propose(planned, cache, &*executor);
    }

    /// Takes the proposed set-up into the job.
    pub(super) fn apply_proposal(&mut self) {
        let Some(proposal) = self.context().proposal() else { return };
        let cell = advice::applied(&self.document.job().cell, proposal.setup.mount, &proposal.found);
        self.derived.remedy.forget_proposal();
        self.edit(Edit::Frames(Box::new(cell)));
    }

    /// Dismisses the proposed set-up, or the word that none was found; whether there was anything to dismiss.
    pub(super) fn dismiss_proposal(&mut self) -> bool {
        let there = self.context().proposal().is_some() || self.context().has_no_proposal();
        self.derived.remedy.forget_proposal();
        there
    }
}
