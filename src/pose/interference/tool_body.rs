//! Queries of the tool's bodies: cone and head, or a contact tool, against all facets of part and clamps.
//!
//! Cut cones are asked what `ray` asks of the ray: is a pose free, what is in its way, may a motion touch
//! anything. The margin is kept from everything; what the spot stands on is told from a wall by direction (see
//! [`crate::beam::tool_geometry`]).

use super::beam_interference::{BeamInterference, RISE_MM, into_frame, motion_into_frame};
use super::blocker::{Blocker, Obstruction, ToolBody};
use super::skin;
use crate::beam::frustum::PlacedFrustum;
use crate::beam::tool_geometry::OWN_SINE;
use crate::beam::{ContactBody, Frustum, ToolGeometry};
use crate::part::angle;
use crate::pose::Pose;
use nalgebra::{Point3, Vector3};
use std::cell::RefCell;

/// Clearances are measured up to here, mm: farther away nothing depends on them.
pub const FAR_MM: f64 = 100.0;

/// What can be said of cone and head on a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::pose) enum Conflict {
    /// Cone and head are clear by more than they can move.
    None,
    /// Something may be touched, but the tool moves so little that the middle of the motion decides.
    Short,
    /// Undecided: bisect the motion.
    Wide,
}

/// One of the tool's bodies at a pose.
#[derive(Clone, Copy)]
struct ToolShape<'f> {
    tool_body: ToolBody,
    frustum: &'f Frustum,
    /// Clearance it keeps, mm; the beam's margin is in its frustum.
    keeps_mm: f64,
    /// What a contact tool's body keeps from skin that it rests on, mm: its core, and guard and spindle over it. `None`: as
    /// much as from anything.
    skin_mm: Option<f64>,
}

impl ToolShape<'_> {
    /// Which body it counts as where a facet is nearer than it keeps, and by `more_mm` more; `None`: it keeps clear.
    /// `own`: the spot stands on the facet; `of_part`: a contact tool may rest on it.
    fn met(
        &self,
        (placed, a): (&PlacedFrustum, &Vector3<f64>),
        corners: &[Point3<f64>; 3],
        (own, of_part): (bool, bool),
        more_mm: f64,
    ) -> Option<ToolBody> {
        if self.tool_body == ToolBody::Beam && own || !placed.is_near(corners, self.keeps_mm + more_mm) {
            return None;
        }
        let on_skin = self.skin_mm.filter(|_| of_part);
        let is_mounted = self.tool_body == ToolBody::Head;
        let stands = |corners| if is_mounted { skin::over(placed, a, corners) } else { skin::rest(placed, a, corners) };
        let rests = on_skin.and_then(|skin_mm| Some((stands(corners)?, skin_mm)));
        let Some((rest_mm, skin_mm)) = rests else { return Some(self.tool_body) };
        let into_skin = if self.tool_body == ToolBody::Abrasive { ToolBody::Gouge } else { self.tool_body };
        (rest_mm <= skin_mm + more_mm).then_some(into_skin)
    }

    /// The most that it keeps from anything, mm.
    fn most_mm(&self) -> f64 {
        self.keeps_mm.max(self.skin_mm.unwrap_or(0.0))
    }
}

impl<'a> BeamInterference<'a> {
    /// The tool's bodies, the head's first.
    fn shapes<'f>(body: &'f ToolGeometry<'a>) -> impl Iterator<Item = ToolShape<'f>> {
        let shape = |tool_body, keeps_mm, skin_mm| move |frustum| ToolShape { tool_body, frustum, keeps_mm, skin_mm };
        let over_skin_mm = body.contact.as_ref().map(|_| (body.margin_mm - body.slack_mm).max(0.0));
        let head = body.head.iter().map(shape(ToolBody::Head, body.margin_mm, over_skin_mm));
        let abrasive = body.contact.iter().flat_map(move |c| {
            let (keeps_mm, skin_mm) = (c.round_mm + body.margin_mm, Some(c.skin_mm));
            c.core.iter().map(shape(ToolBody::Abrasive, keeps_mm, skin_mm))
        });
        head.chain(abrasive).chain(body.beam.iter().map(shape(ToolBody::Beam, 0.0, None)))
    }

    /// Whether cone and head keep their margin.
    pub(super) fn is_body_free(&self, p: &Point3<f64>, a: &Vector3<f64>) -> bool {
        let Some(body) = self.geometry else { return true };
        let shapes: Vec<ToolShape<'_>> = Self::shapes(body).collect();
        shapes.chunks(32).all(|shapes| self.are_free(shapes, p, a))
    }

    /// Whether up to 32 of the tool's bodies keep their margin, all in one traversal.
    fn are_free(&self, shapes: &[ToolShape<'_>], p: &Point3<f64>, a: &Vector3<f64>) -> bool {
        let all = (1u64 << shapes.len()) - 1;
        self.obstacles().all(|(clamp, bvh, at)| {
            let (p, a) = into_frame(at.as_ref(), p, a);
            let placed: Vec<PlacedFrustum> = shapes.iter().map(|shape| shape.frustum.placed(&p, &a)).collect();
            let among = |of: u32| (0..shapes.len()).filter(move |i| of >> i & 1 == 1);
            let hits = |corners: &[Point3<f64>; 3], of: u32| {
                let own = clamp.is_none() && leaves(&p, &a, corners);
                let facet = (own, clamp.is_none());
                among(of).any(|i| shapes[i].met((&placed[i], &a), corners, facet, 0.0).is_some())
            };
            // The facet that was hit last is likely to be hit again.
            if self.last_body_facet.get().is_some_and(|corners| clamp.is_none() && hits(&corners, all as u32)) {
                return false;
            }
            let mut free = true;
            bvh.visit_near_boxes_of(
                all as u32,
                |lo, hi, of| {
                    let near =
                        |near: u32, i: usize| near | u32::from(placed[i].near_box(lo, hi, shapes[i].most_mm())) << i;
                    among(of).fold(0, near)
                },
                |corners, of| {
                    if hits(corners, of) {
                        free = false;
                        if clamp.is_none() {
                            self.last_body_facet.set(Some(*corners));
                        }
                    }
                    free
                },
            );
            free
        })
    }

    /// The first of the tool's bodies that does not keep its margin, and what it is too close to.
    pub fn body_blocker(&self, p: &Point3<f64>, a: &Vector3<f64>) -> Option<Blocker> {
        Self::shapes(self.geometry?).find_map(|shape| {
            let (tool_body, obstruction) = self.first_obstruction(&shape, p, a)?;
            Some(Blocker { tool_body, obstruction, t_mm: shape.frustum.t0_mm })
        })
    }

    fn first_obstruction(
        &self,
        shape: &ToolShape<'_>,
        p: &Point3<f64>,
        a: &Vector3<f64>,
    ) -> Option<(ToolBody, Obstruction)> {
        self.obstacles().find_map(|(clamp, bvh, at)| {
            let (p, a) = into_frame(at.as_ref(), p, a);
            let placed = shape.frustum.placed(&p, &a);
            let mut hit = None;
            bvh.visit_near_boxes(
                |lo, hi| placed.near_box(lo, hi, shape.most_mm()),
                |facet, corners| {
                    let own = clamp.is_none() && leaves(&p, &a, corners);
                    let met = shape.met((&placed, &a), corners, (own, clamp.is_none()), 0.0);
                    let found = met.map(|tool_body| (tool_body, clamp.unwrap_or(Obstruction::Facet(facet))));
                    // A disc that stands in the skin has skin beside it as well: that it cuts in is what is told.
                    let is_gouge = found.is_some_and(|(tool_body, _)| tool_body == ToolBody::Gouge);
                    hit = if is_gouge { found } else { hit.or(found) };
                    hit.is_none() || shape.tool_body == ToolBody::Abrasive && clamp.is_none() && !is_gouge
                },
            );
            hit
        })
    }

    /// Clearance of beam and head, mm, at most [`FAR_MM`]: the head's distance, or the widest
    /// margin with which the beam would still be free, whichever is less; `None` without a head.
    pub fn clearance_mm(&self, p: &Point3<f64>, a: &Vector3<f64>) -> Option<f64> {
        self.clearance_within_mm(p, a, FAR_MM)
    }

    /// Clearance of beam and head, mm, at most `most_mm`; `None` without a head. The less `most_mm` is, the fewer
    /// facets are visited.
    pub(in crate::pose) fn clearance_within_mm(&self, p: &Point3<f64>, a: &Vector3<f64>, most_mm: f64) -> Option<f64> {
        let body = self.geometry.filter(|b| b.has_head)?;
        if self.check().is_err() {
            return Some(0.0);
        }
        let mut least = most_mm;
        if let Some(contact) = &body.contact {
            least = self.abrasive_clearance_mm(contact, p, a, least);
        }
        for shape in &body.head {
            for (_, bvh, at) in self.obstacles() {
                let (p, a) = into_frame(at.as_ref(), p, a);
                let placed = shape.placed(&p, &a);
                if at.is_none() && body.contact.is_none() {
                    // The spot itself is a facet corner at that distance: it bounds the search.
                    least = least.min(placed.distance_mm(&[p, p, p]) + 1e-6);
                }
                let nearest = std::cell::Cell::new(least);
                bvh.visit_near_boxes(
                    |lo, hi| placed.near_box(lo, hi, nearest.get()),
                    |_, corners| {
                        if placed.is_near(corners, nearest.get()) {
                            nearest.set(nearest.get().min(placed.distance_mm(corners)));
                        }
                        nearest.get() > 0.0
                    },
                );
                least = nearest.get();
            }
        }
        Some(self.widest_mm(body, p, a, least.max(0.0)))
    }

    /// Clearance of disc or belt from walls and clamps, mm, at most `most_mm`: what it touches is no wall.
    fn abrasive_clearance_mm(&self, contact: &ContactBody, p: &Point3<f64>, a: &Vector3<f64>, most_mm: f64) -> f64 {
        let mut least = most_mm;
        for shape in &contact.core {
            for (clamp, bvh, at) in self.obstacles() {
                let (p, a) = into_frame(at.as_ref(), p, a);
                let placed = shape.placed(&p, &a);
                let nearest = std::cell::Cell::new(least + contact.round_mm);
                bvh.visit_near_boxes(
                    |lo, hi| placed.near_box(lo, hi, nearest.get()),
                    |_, corners| {
                        let is_wall = || clamp.is_some() || skin::rest(&placed, &a, corners).is_none();
                        if placed.is_near(corners, nearest.get()) && is_wall() {
                            nearest.set(nearest.get().min(placed.distance_mm(corners)));
                        }
                        nearest.get() > 0.0
                    },
                );
                least = (nearest.get() - contact.round_mm).max(0.0);
            }
        }
        least
    }

    /// The widest margin below `most_mm` with which the beam would still be free, to within
    /// [`MARGIN_STEP_MM`]; 0 if it would be free with none.
    fn widest_mm(&self, body: &ToolGeometry<'_>, p: &Point3<f64>, a: &Vector3<f64>, most_mm: f64) -> f64 {
        let mut widest = most_mm;
        for (clamp, bvh, at) in self.obstacles() {
            let (p, a) = into_frame(at.as_ref(), p, a);
            let beam_with = |mm: f64| body.beam_with(mm).into_iter().map(move |f| f.placed(&p, &a));
            let beam: RefCell<Vec<PlacedFrustum>> = RefCell::new(beam_with(widest).collect());
            let mut hit = |corners: &[Point3<f64>; 3]| {
                let counts = clamp.is_some() || !leaves(&p, &a, corners);
                if !counts || !beam.borrow().iter().any(|f| f.is_near(corners, 0.0)) {
                    return true;
                }
                // Narrowed for this facet alone; the remaining ones are tested with the narrower beam.
                let mut low = 0.0;
                while widest - low > MARGIN_STEP_MM {
                    let middle = 0.5 * (low + widest);
                    if beam_with(middle).any(|f| f.is_near(corners, 0.0)) { widest = middle } else { low = middle }
                }
                // What keeps its margin has that clearance, however coarse the steps are.
                let kept_mm = body.margin_mm;
                let keeps = || !beam_with(kept_mm).any(|f| f.is_near(corners, 0.0));
                widest = if low < kept_mm && kept_mm <= widest && keeps() { kept_mm } else { low };
                beam.replace(beam_with(widest).collect());
                widest > 0.0
            };
            bvh.visit_near_boxes(
                |lo, hi| beam.borrow().iter().any(|f| f.near_box(lo, hi, 0.0)),
                |_, corners| hit(corners),
            );
        }
        widest
    }

    /// Whether cone or head may touch anything on the motion between two poses; see
    /// [`BeamInterference::ray_conflict`]. `stray_mm`: how far a point of the tool at this distance from the spot may
    /// stray from the motion with a straight spot and a constant turn.
    pub(in crate::pose) fn body_conflict(
        &self,
        motion: [&Pose; 3],
        sag_mm: f64,
        stray_mm: impl Fn(f64) -> f64,
    ) -> Conflict {
        let Some(body) = self.geometry else { return Conflict::None };
        let [from, _, to] = motion;
        let half_mm = 0.5 * (to.p - from.p).norm();
        let half_turn = libm::sin(0.25 * angle::between_deg(&from.a, &to.a).to_radians()) * 2.0;
        let mut worst = Conflict::None;
        for shape in Self::shapes(body) {
            let reach_mm = shape.frustum.reach_mm();
            let moved_mm = half_mm + half_turn * reach_mm + stray_mm(reach_mm);
            let meets = self.obstacles().any(|(clamp, bvh, at)| {
                let [from, middle, to] = motion_into_frame(at.as_ref(), motion);
                let placed = shape.frustum.placed(&middle.p, &middle.a);
                let mut met = false;
                bvh.visit_near_boxes(
                    |lo, hi| placed.near_box(lo, hi, shape.most_mm() + moved_mm),
                    |_, corners| {
                        let own = shape.tool_body == ToolBody::Beam && clamp.is_none();
                        let harmless = own
                            && (leaves(&from.p, &from.a, corners) && leaves(&to.p, &to.a, corners)
                                || !rises(&from, corners, sag_mm) && !rises(&to, corners, sag_mm));
                        // In front of a facet's plane at both ends is in front of it on the way.
                        let stays_before = || {
                            let before_mm = shape.skin_mm.unwrap_or(0.0) + moved_mm - half_mm;
                            let is_before =
                                |q: &Pose| skin::is_before(&shape.frustum.placed(&q.p, &q.a), &q.a, corners, before_mm);
                            shape.tool_body == ToolBody::Abrasive
                                && clamp.is_none()
                                && is_before(&from)
                                && is_before(&to)
                        };
                        let meets = || shape.met((&placed, &middle.a), corners, (false, clamp.is_none()), moved_mm);
                        met = met || !harmless && !stays_before() && meets().is_some();
                        !met
                    },
                );
                met
            });
            if meets && moved_mm > body.short_mm {
                return Conflict::Wide;
            }
            if meets {
                worst = Conflict::Short;
            }
        }
        worst
    }
}

/// Whether the whole cone of the spot's own neighbourhood stays in front of a facet that the spot is on
/// or in front of.
fn leaves(p: &Point3<f64>, a: &Vector3<f64>, corners: &[Point3<f64>; 3]) -> bool {
    let n = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
    let (rise, height, length) = (n.dot(a), n.dot(&(p - corners[0])), n.norm());
    rise.abs() > OWN_SINE * length && (height * rise > 0.0 || height.abs() <= 1e-7 * length)
}

/// Whether a facet rises above the spot at all.
fn rises(q: &Pose, corners: &[Point3<f64>; 3], sag_mm: f64) -> bool {
    corners.iter().any(|c| (c - q.p).dot(&q.a) > RISE_MM + 2.0 * sag_mm)
}

/// Precision of the widest margin, mm.
const MARGIN_STEP_MM: f64 = 0.002;
