//! The access map of a place and the access strip along a line: from which directions the beam can reach them. They are
//! kept while place, job and plan stay the same. Which place and line are shown is decided in `access_place`.

use crate::cell::Setup;
use crate::document::Job;
use crate::part::{Part, SurfaceId};
use crate::planning::surface_plan::tool_geometry;
use crate::pose::access::{AccessMap, AccessStrip, TiltPart};
use crate::pose::{BeamInterference, Pass, Tilt, TiltRule};
use nalgebra::{Point3, Vector3};

/// Cells of the map and of the strip, degrees: seven hundred directions are looked at in a few
/// milliseconds.
pub const STEP_DEG: f64 = 3.0;
/// Places along a line that are looked at.
const PLACES: usize = 120;

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

/// What a map or a strip was made from: its place, the job, and the plan's picture key.
type MadeOf<K> = (K, Job, u64);

/// The map and the strip that were asked for last.
#[derive(Default)]
pub(super) struct AccessViews {
    map: Option<(MadeOf<Place>, AccessMap)>,
    /// The strip, of which pass and of which part of the tilt.
    strip: Option<(MadeOf<(TiltPart, usize)>, AccessStrip)>,
}

/// What access depends on.
pub(super) struct Ground<'a> {
    /// The part, which may be in the way.
    pub part: &'a Part,
    /// Its tilt rules and limits.
    pub job: &'a Job,
    /// Head and clamps, which may be in the way as well.
    pub setup: &'a Setup,
    /// Picture key of the plan.
    pub plan: u64,
}

impl AccessViews {
    /// Makes the map of a place; without a place there is none.
    pub fn look_at(&mut self, place: Option<Place>, on: Option<&Ground<'_>>) {
        let (Some(place), Some(on)) = (place, on) else {
            self.map = None;
            return;
        };
        let of = (place, on.job.clone(), on.plan);
        if self.map.as_ref().is_some_and(|m| m.0 == of) {
            return;
        }
        let body = tool_geometry(on.job, on.setup);
        let beam = BeamInterference::with(on.part, body.as_ref());
        let place = &of.0;
        let (rule, most) = (rule_of(on.job, place.surface), on.job.path.max_tilt_deg);
        let map = AccessMap::at(&beam, &place.p, &place.n, &place.tangent, &rule, most, STEP_DEG);
        self.map = Some((of, map));
    }

    /// Makes the strip along a pass, which is given with its number; without a pass there is none.
    pub fn look_along(&mut self, pass: Option<(usize, &Pass)>, over: TiltPart, on: Option<&Ground<'_>>) {
        let (Some((number, pass)), Some(on)) = (pass, on) else {
            self.strip = None;
            return;
        };
        let of = ((over, number), on.job.clone(), on.plan);
        if self.strip.as_ref().is_some_and(|s| s.0 == of) {
            return;
        }
        let body = tool_geometry(on.job, on.setup);
        let beam = BeamInterference::with(on.part, body.as_ref());
        let (rule, most) = (rule_of(on.job, pass.surface), on.job.path.max_tilt_deg);
        self.strip = Some((of, AccessStrip::along(&beam, pass, &rule, over, most, STEP_DEG, PLACES)));
    }

    /// The map that was made last.
    pub fn map(&self) -> Option<(&Place, &AccessMap)> {
        self.map.as_ref().map(|((place, ..), map)| (place, map))
    }

    /// The strip that was made last.
    pub fn strip(&self) -> Option<&AccessStrip> {
        self.strip.as_ref().map(|(_, strip)| strip)
    }
}

fn rule_of(job: &Job, surface: u32) -> TiltRule {
    job.settings.of(SurfaceId(surface)).tilt.clone()
}
