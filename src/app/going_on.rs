//! Going on after a stop: which passes count as done, and which pass lies where the view was right clicked. It is no part of
//! the job, and another plan has other passes.

use super::App;
use super::context::Context;
use super::dialogs::Purpose;
use super::session::GoingOn;

impl Context<'_> {
    /// The pass that the plan goes on from; those before it are done.
    pub fn going_on_from(self) -> Option<usize> {
        let key = self.derived.plan()?.key;
        self.session.going_on.filter(|g| g.plan == key).map(|g| g.pass)
    }

    /// The target nearest to the place that was right clicked, on the surface there.
    pub fn target_at_menu_place(self) -> Option<(usize, usize)> {
        let (facet, at) = self.session.menu_place?;
        let surface = self.surface_of(facet)?;
        let passes = &self.derived.plan_on_part()?.plan.passes;
        let on_surface = passes.iter().enumerate().filter(|(_, p)| p.surface == surface);
        let targets = on_surface
            .flat_map(|(n, p)| p.targets.iter().enumerate().map(move |(k, t)| ((n, k), (t.p - at).norm_squared())));
        targets.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(target, _)| target)
    }
}

impl App {
    /// Counts the passes before the current one as done, and asks for the folder of what is left.
    pub(super) fn go_on_from_pass(&mut self) {
        let pass = self.session.playback.at.0;
        self.session.going_on = self.derived.plan().map(|of| GoingOn { plan: of.key, pass });
        self.ask(Purpose::Export);
    }
}
