//! From where the place under the cursor, or the current target, can be reached; and from where along its line. What
//! was looked at is kept while neither place nor job nor plan changes.

use super::App;
use crate::cell::Setup;
use crate::document::Job;
use crate::part::{Part, SurfaceId, angle};
use crate::planning::surface_plan::body;
use crate::pose::access::{AccessMap, AccessStrip, TiltPart};
use crate::pose::{Beam, Pass, TargetState, Tilt, TiltRule};
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

/// What a map or a strip was made from: its place, the job, the plan's picture key.
type MadeOf<K> = (K, Job, u64);

/// The map and the strip that were asked for last.
#[derive(Default)]
pub(super) struct AccessViews {
    map: Option<(MadeOf<Place>, AccessMap)>,
    /// Over which part of the tilt, and of which pass.
    strip: Option<(MadeOf<(TiltPart, usize)>, AccessStrip)>,
}

/// What access is looked at with.
struct Ground<'a> {
    part: &'a Part,
    job: &'a Job,
    setup: &'a Setup,
    /// Picture key of the plan.
    plan: u64,
}

impl AccessViews {
    /// The map of a place.
    fn map(&mut self, place: &Place, on: &Ground<'_>) -> &AccessMap {
        let of = (place.clone(), on.job.clone(), on.plan);
        if self.map.as_ref().is_some_and(|m| m.0 != of) {
            self.map = None;
        }
        let (_, map) = self.map.get_or_insert_with(|| {
            let body = body(on.job, on.setup);
            let beam = Beam::with(on.part, body.as_ref());
            let (rule, most) = (rule_of(on.job, place.surface), on.job.path.max_tilt_deg);
            (of, AccessMap::at(&beam, &place.p, &place.n, &place.tangent, &rule, most, STEP_DEG))
        });
        map
    }

    /// The strip along a pass.
    fn strip(&mut self, over: TiltPart, number: usize, pass: &Pass, on: &Ground<'_>) -> &AccessStrip {
        let of = ((over, number), on.job.clone(), on.plan);
        if self.strip.as_ref().is_some_and(|s| s.0 != of) {
            self.strip = None;
        }
        let (_, strip) = self.strip.get_or_insert_with(|| {
            let body = body(on.job, on.setup);
            let beam = Beam::with(on.part, body.as_ref());
            let (rule, most) = (rule_of(on.job, pass.surface), on.job.path.max_tilt_deg);
            (of, AccessStrip::along(&beam, pass, &rule, over, most, STEP_DEG, PLACES))
        });
        strip
    }
}

impl App {
    /// The place under the cursor, else the current target.
    pub(super) fn access_place(&self) -> Option<Place> {
        self.hovered_place().or_else(|| {
            let t = self.target()?;
            let surface = self.derived.plan()?.plan.passes.get(self.session.playback.at.0)?.surface;
            let chosen = (t.state != TargetState::Blocked).then(|| t.tilt());
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
        let on_it = near.filter(|t| (t.p - p).norm() <= spacing_mm && t.state != TargetState::Blocked);
        Some(Place { p, n, tangent, surface, chosen: on_it.map(|t| t.tilt()), hovered: true })
    }

    /// The map of that place.
    pub(super) fn access_map(&mut self) -> Option<(Place, &AccessMap)> {
        let place = self.access_place()?;
        let d = &self.derived;
        let (part, setup) = (d.part.as_ref()?, d.pipeline.setup()?.ok()?);
        let plan = d.plan().map_or(0, |of| of.picture_key());
        let on = Ground { part, job: self.document.job(), setup, plan };
        let map = self.access.map(&place, &on);
        Some((place, map))
    }

    /// The strip of the current pass.
    pub(super) fn access_strip(&mut self, over: TiltPart) -> Option<&AccessStrip> {
        let (planned, number) = (self.derived.plan()?, self.session.playback.at.0);
        let pass = planned.plan.passes.get(number)?;
        let setup = self.derived.pipeline.setup()?.ok()?;
        let on = Ground { part: &planned.part, job: self.document.job(), setup, plan: planned.picture_key() };
        Some(self.access.strip(over, number, pass, &on))
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
