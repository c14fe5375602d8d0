//! What the interference queries of beam and head, or of a contact tool, against a part are asked of. The queries stand
//! in `ray` and `tool_body`.

use super::blocker::Obstruction;
use crate::beam::ToolGeometry;
use crate::part::{Bvh, Part};
use crate::pose::Pose;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Isometry3, Point3, Vector3};
use std::cell::Cell;

/// A facet that rises less than this above the spot stands in no beam's way, mm: the start of the
/// ray's test, `STRETCHES_MM`. The moving cone is held to it as well.
pub(super) const RISE_MM: f64 = 0.01;

/// Interference of the beam with a part: of a ray without end, and of cone and head with part and clamps where the tool
/// is known.
#[derive(Clone, Debug)]
pub struct BeamInterference<'a> {
    pub(super) bvh: &'a Bvh,
    /// Cone and head, and the clamps they must miss; `None`: the ray alone.
    pub(super) geometry: Option<&'a ToolGeometry<'a>>,
    /// The facet of the part that cone or head hit last; it is tested first.
    pub(super) last_body_facet: Cell<Option<[Point3<f64>; 3]>>,
    /// The facet that the ray hit last. It is tested first: the next ray is likely to hit it as well.
    pub(super) last_ray_facet: Cell<Option<[Point3<f64>; 3]>>,
    /// The work that asks.
    progress: Option<&'a Progress>,
}

impl<'a> BeamInterference<'a> {
    /// A beam without width on this part.
    pub fn on(part: &'a Part) -> BeamInterference<'a> {
        BeamInterference::with(part, None)
    }

    /// A beam with cone, head and clamps on this part; without them a ray.
    pub fn with(part: &'a Part, geometry: Option<&'a ToolGeometry<'a>>) -> BeamInterference<'a> {
        BeamInterference {
            bvh: &part.bvh,
            geometry,
            last_ray_facet: Cell::new(None),
            last_body_facet: Cell::new(None),
            progress: None,
        }
    }

    /// Asked by work that may be cancelled. From then on no pose is free, so that whatever searches ends soon; who
    /// takes the result asks [`BeamInterference::check`] first.
    pub fn under(self, progress: Option<&'a Progress>) -> BeamInterference<'a> {
        BeamInterference { progress, ..self }
    }

    /// Whether there is a ray: with a contact tool there is none, and poses are those of the foot of its axis.
    pub(super) fn has_ray(&self) -> bool {
        self.geometry.is_none_or(|g| g.contact.is_none())
    }

    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn check(&self) -> Result<(), Cancelled> {
        self.progress.map_or(Ok(()), Progress::check)
    }

    /// All that can be hit, the part first: what it is (`None`: each facet is told), its facets, and where it stands in
    /// the part frame.
    pub(super) fn obstacles(&self) -> impl Iterator<Item = (Option<Obstruction>, &'a Bvh, Option<Isometry3<f64>>)> {
        let clamps = self.geometry.map_or(&[][..], |b| &b.clamps);
        let clamps = clamps.iter().enumerate();
        let clamps = clamps.map(|(i, c)| (Some(Obstruction::of_clamp(i, c.is_unscanned)), &c.solid.bvh, Some(c.at)));
        std::iter::once((None, self.bvh, None)).chain(clamps)
    }
}

/// The pose in the frame of something that stands at `at`.
#[inline]
pub(super) fn into_frame(
    at: Option<&Isometry3<f64>>,
    p: &Point3<f64>,
    a: &Vector3<f64>,
) -> (Point3<f64>, Vector3<f64>) {
    at.map_or((*p, *a), |at| (at.inverse_transform_point(p), at.inverse_transform_vector(a)))
}

/// Beginning, middle and end of a motion in the frame of something that stands at `at`.
pub(super) fn motion_into_frame(at: Option<&Isometry3<f64>>, motion: [&Pose; 3]) -> [Pose; 3] {
    motion.map(|q| {
        let (p, a) = into_frame(at, &q.p, &q.a);
        Pose { p, a }
    })
}
