//! From where the spot under the cursor, or the current target, can be reached; and along its line. Kept
//! while neither place nor job changes.

use super::App;
use crate::document::Job;
use crate::part::{SurfaceId, angle};
use crate::planning::surface_plan::body;
use crate::pose::access::{AccessMap, AccessStrip, Over};
use crate::pose::{Beam, State, Tilt, TiltRule};
use nalgebra::{Point3, Vector3};

/// Cells of the map and of the strip, degrees: seven hundred directions are looked at in a few
/// milliseconds.
pub const STEP_DEG: f64 = 3.0;
/// Places along a line that are looked at.
const PLACES: usize = 120;
/// Under the cursor the normal of a target is taken, if it is no farther than this from the facet's, degrees:
/// that of a smooth surface, where the facets are not.
const SAME_NORMAL_DEG: f64 = 20.0;

/// A place that is looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// On the part, mm.
    pub p: Point3<f64>,
    /// Surface normal.
    pub n: Vector3<f64>,
    /// Travel direction.
    pub tangent: Vector3<f64>,
    /// Its surface.
    pub surface: u32,
    /// The tilt that was chosen there; `None`: none, or there is no target here.
    pub chosen: Option<Tilt>,
    /// Whether it is the place under the cursor.
    pub hovered: bool,
}

/// A map or a strip, and what it was made from.
pub struct Made<K, T> {
    of: (K, Job, u64),
    /// The thing.
    pub made: T,
}

impl App {
    /// The place under the cursor, else the current target.
    pub(super) fn access_place(&self) -> Option<Place> {
        self.hovered_place().or_else(|| {
            let t = self.target()?;
            let surface = self.derived.plan()?.plan.passes.get(self.session.playback.at.0)?.surface;
            let chosen = (t.state != State::Blocked).then(|| t.tilt());
            Some(Place { p: t.p, n: t.n, tangent: t.tangent(), surface, chosen, hovered: false })
        })
    }

    fn hovered_place(&self) -> Option<Place> {
        let (facet, p) = self.session.hover_place?;
        let d = &self.derived;
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
        let on_it = near.filter(|t| (t.p - p).norm() <= spacing_mm && t.state != State::Blocked);
        Some(Place { p, n, tangent, surface, chosen: on_it.map(|t| t.tilt()), hovered: true })
    }

    fn plan_key(&self) -> u64 {
        self.derived.plan().map_or(0, |of| of.picture_key())
    }

    /// The map of that place.
    pub(super) fn access_map(&mut self) -> Option<(Place, &AccessMap)> {
        let place = self.access_place()?;
        let of = (place.clone(), self.document.job().clone(), self.plan_key());
        if self.access.as_ref().is_none_or(|a| a.of != of) {
            let (part, job) = (self.derived.part.clone()?, self.document.job());
            let setup = self.derived.pipeline.setup()?.ok()?;
            let body = body(job, setup);
            let beam = Beam::with(&part, body.as_ref());
            let (rule, most) = (rule_of(job, place.surface), job.path.max_tilt_deg);
            let made = AccessMap::at(&beam, &place.p, &place.n, &place.tangent, &rule, most, STEP_DEG);
            self.access = Some(Made { of, made });
        }
        Some((place, &self.access.as_ref()?.made))
    }

    /// The strip of the current pass.
    pub(super) fn access_strip(&mut self, over: Over) -> Option<&AccessStrip> {
        let of = ((over, self.session.playback.at.0), self.document.job().clone(), self.plan_key());
        if self.strip.as_ref().is_none_or(|s| s.of != of) {
            let (planned, job) = (self.derived.plan()?, self.document.job());
            let (part, pass) = (&planned.part, planned.plan.passes.get(self.session.playback.at.0)?);
            let setup = self.derived.pipeline.setup()?.ok()?;
            let body = body(job, setup);
            let beam = Beam::with(part, body.as_ref());
            let (rule, most) = (rule_of(job, pass.surface), job.path.max_tilt_deg);
            let made = AccessStrip::along(&beam, pass, &rule, over, most, STEP_DEG, PLACES);
            self.strip = Some(Made { of, made });
        }
        Some(&self.strip.as_ref()?.made)
    }

    /// Surface of the current pass, and its number among the lines of that surface.
    pub(super) fn current_line(&self) -> Option<(u32, u32)> {
        let plan = &self.derived.plan()?.plan;
        let surface = plan.passes.get(self.session.playback.at.0)?.surface;
        let before = plan.passes.iter().take(self.session.playback.at.0).filter(|p| p.surface == surface).count();
        Some((surface, before as u32))
    }
}

fn rule_of(job: &Job, surface: u32) -> TiltRule {
    job.settings.of(SurfaceId(surface)).tilt.clone()
}
