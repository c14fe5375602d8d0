//! Chooses the place of the access map, and the line of the strip beside it.

use super::access::Place;
use super::context::Context;
use crate::part::angle;
use crate::pose::TargetState;

/// Under the cursor the normal of the nearest target is used if it differs from the facet's by this at most, degrees:
/// it is that of the smooth surface, which the facet only approximates.
const SAME_NORMAL_DEG: f64 = 20.0;

impl Context<'_> {
    /// The place under the cursor, else the current target.
    pub fn access_place(self) -> Option<Place> {
        self.hovered_place().or_else(|| {
            let t = self.target()?;
            let surface = self.derived.plan()?.plan.passes.get(self.session.playback.at.0)?.surface;
            let chosen = (t.state != TargetState::Blocked).then(|| t.tilt());
            Some(Place { p: t.p, n: t.n, tangent: t.tangent(), surface, chosen, hovered: false })
        })
    }

    fn hovered_place(self) -> Option<Place> {
        let (facet, p) = self.session.hover_place?;
        let d = self.derived;
        let surface = *d.surfaces.of_facet.get(facet as usize)?;
        let flat = *d.surfaces.normals.get(facet as usize)?;
        let targets =
            d.plan_on_part().into_iter().flat_map(|of| &of.plan.passes).filter(|pass| pass.surface == surface);
        let nearest = targets
            .flat_map(|pass| &pass.targets)
            .map(|t| ((t.p - p).norm_squared(), t))
            .min_by(|x, y| x.0.total_cmp(&y.0))
            .map(|(_, t)| t);
        let near = nearest.filter(|t| angle::between_deg(&t.n, &flat) <= SAME_NORMAL_DEG);
        let n = near.map_or(flat, |t| t.n);
        let tangent = near.map_or_else(|| angle::any_square_to(&flat), |t| t.tangent());
        let spacing_mm = self.document.job().layers.spacing_mm;
        let on_it = near.filter(|t| (t.p - p).norm() <= spacing_mm && t.state != TargetState::Blocked);
        Some(Place { p, n, tangent, surface, chosen: on_it.map(|t| t.tilt()), hovered: true })
    }

    /// Surface of the current pass, and its number among the lines of that surface.
    pub fn current_line(self) -> Option<(u32, u32)> {
        let plan = &self.derived.plan()?.plan;
        let surface = plan.passes.get(self.session.playback.at.0)?.surface;
        let before = plan.passes.iter().take(self.session.playback.at.0).filter(|p| p.surface == surface).count();
        Some((surface, before as u32))
    }
}
