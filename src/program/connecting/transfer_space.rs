//! The space around a part that connecting moves lead through: over the part, never through it.
//!
//! The focus is drawn back along the beam. Short hops go straight, if every pose on the way keeps
//! clear of the part. All others go out to a sphere around the part, along the great circle over
//! it, and back in along the next beam, which is free to infinity. Where the head is known it is swept on
//! all of these but those outside the sphere, which is wider by it.

use crate::beam::{ContactBody, ToolGeometry};
use crate::cell::mounting::Mounted;
use crate::cell::{Air, Setup};
use crate::part::{Part, angle, distance};
use crate::pose::Pose;
use crate::pose::motion::{Motion, head_hit, is_free};
use crate::pose::{BeamInterference, Blocker, Pass};
use crate::program::motion::lit::StraightFlange;
use crate::program::motion::spot::FROM_MM;
use crate::program::motion::sweep::stray_mm;
use crate::program::neutral::steps::Station;
use crate::progress::Progress;
use nalgebra::{Isometry3, Point3, Vector3};

/// Farther apart than this the way round is taken without looking at the straight one, mm.
const HOP_MM: f64 = 40.0;
/// Poses looked at on a straight hop, mm and degrees apart.
const LOOK_MM: f64 = 0.5;
const LOOK_DEG: f64 = 2.0;
/// Stations on the great circle stand this far apart, degrees.
const ARC_DEG: f64 = 30.0;

/// The space around a part.
#[derive(Clone, Debug)]
pub struct TransferSpace<'a> {
    part: &'a Part,
    /// The head alone, where it is known; a contact tool may touch the skin that it comes from.
    head: Option<ToolGeometry<'a>>,
    /// A contact tool as it has to keep clear of the skin between two pieces.
    lifted: Option<ToolGeometry<'a>>,
    /// How the flange carries the focus.
    mounted: Mounted,
    air: &'a Air,
    defocus_mm: f64,
    centre: Point3<f64>,
    radius_mm: f64,
    /// The work that it is asked by.
    progress: Option<&'a Progress>,
}

impl<'a> TransferSpace<'a> {
    /// The space for what is carried in the air between passes: `straight` knows part and margin.
    pub fn of(straight: &StraightFlange<'a>, setup: &'a Setup, passes: &[Pass]) -> TransferSpace<'a> {
        let head = ToolGeometry::head_alone(&setup.tool, straight.prover.margin_mm());
        let farthest_focus_mm = passes.iter().map(|p| p.settings.defocus_mm).fold(0.0, f64::max);
        let (air, progress) = (&setup.cell.air, straight.prover.progress);
        let space =
            TransferSpace::new(straight.prover.whole(), (head, straight.prover.mounted), air, farthest_focus_mm);
        TransferSpace { progress, ..space }
    }

    /// Whether the work that it is asked by was not cancelled; else nobody needs an answer.
    pub fn goes_on(&self) -> bool {
        self.progress.is_none_or(Progress::goes_on)
    }

    /// The sphere lies `air.clearance_mm` outside everything that the focus reaches, and the head beside it.
    /// `head`: its body without the beam.
    fn new(
        part: &'a Part,
        (head, mounted): (Option<ToolGeometry<'a>>, Mounted),
        air: &'a Air,
        defocus_mm: f64,
    ) -> TransferSpace<'a> {
        let (mut lo, mut hi) = part.mesh.bounds();
        for clamp in head.iter().flat_map(|h| &h.clamps).filter(|c| !c.is_unscanned) {
            for p in &clamp.solid.mesh.vertices {
                let p = clamp.at * p;
                (lo, hi) = (lo.inf(&p), hi.sup(&p));
            }
        }
        let abrasive_mm = head.iter().filter_map(|h| h.contact.as_ref()).map(ContactBody::radius_mm);
        let head_mm = head.iter().flat_map(|h| &h.head).map(|f| f.r0_mm.max(f.r1_mm)).chain(abrasive_mm);
        let head_mm = head_mm.fold(0.0, f64::max);
        let radius_mm = 0.5 * (hi - lo).norm() + defocus_mm.max(0.0) + air.retreat_mm + air.clearance_mm + head_mm;
        let centre = lo + (hi - lo) * 0.5;
        let lifted = head.as_ref().and_then(ToolGeometry::lifted_off);
        TransferSpace { part, head, lifted, mounted, air, defocus_mm, centre, radius_mm, progress: None }
    }

    /// The space around the part as it was at another time.
    pub fn with_part(&self, part: &'a Part) -> TransferSpace<'a> {
        TransferSpace { part, ..self.clone() }
    }

    /// Whether the head is known.
    pub fn knows_head(&self) -> bool {
        self.head.is_some()
    }

    /// What the head hits on a straight move of the flange, if anything.
    pub fn head_hit(&self, from: &Station, to: &Station) -> Option<Blocker> {
        self.tool_hit(self.head.as_ref()?, from, to)
    }

    /// What the head hits on a straight move between two pieces, where a contact tool may not touch the skin either.
    fn lifted_hit(&self, from: &Station, to: &Station) -> Option<Blocker> {
        self.tool_hit(self.lifted.as_ref().or(self.head.as_ref())?, from, to)
    }

    fn tool_hit(&self, tool: &ToolGeometry<'a>, from: &Station, to: &Station) -> Option<Blocker> {
        let head = BeamInterference::with(self.part, Some(tool));
        let carried = CarriedFocus::new(&self.mounted, from, to);
        head_hit(&head, &carried, (&carried.at(0.0), 0.0), (&carried.at(1.0), 1.0))
    }

    /// Whether the spot may go on straight with the laser off: the beam from focus or surface outwards, and the
    /// head.
    pub fn is_lead_free(&self, from: &Station, to: &Station, defocus_mm: f64) -> bool {
        if self.lifted.is_some() {
            return self.head_hit(from, to).is_none();
        }
        // From the surface on the beam would lie in it wherever it is bent.
        let up_mm = (FROM_MM - defocus_mm).max(0.0);
        let pose = |s: &Station| Pose { p: s.x + s.a * up_mm, a: s.a };
        is_free(&BeamInterference::on(self.part), &pose(from), &pose(to), 0.0) && self.head_hit(from, to).is_none()
    }

    /// Whether the way from the end of one piece to the start of the next may go straight.
    pub fn can_go_straight(&self, from: &Station, to: &Station) -> bool {
        let (up, down) = (self.drawn_back(from), self.drawn_back(to));
        self.goes_on()
            && (up.x - down.x).norm() <= HOP_MM
            && self.is_clear(&up, &down)
            && [(from, &up), (&down, to)].iter().all(|(a, b)| self.head_hit(a, b).is_none())
            && self.lifted_hit(&up, &down).is_none()
    }

    /// Stations between the end of one piece and the start of the next, both excluded.
    pub fn between(&self, from: &Station, to: &Station, hop: bool) -> Vec<Station> {
        if hop {
            return vec![self.drawn_back(from), self.drawn_back(to)];
        }
        let (out, back) = (self.on_sphere(from), self.on_sphere(to));
        let mut way = vec![out];
        let (u, v) = (angle::unit(out.x - self.centre), angle::unit(back.x - self.centre));
        if let (Some(u), Some(v)) = (u, v) {
            let steps = (angle::between_deg(&u, &v) / ARC_DEG).ceil().max(1.0) as usize;
            for i in 1..steps {
                let t = i as f64 / steps as f64;
                let radial = angle::slerp(&u, &v, t);
                // Travel turns as well, so that the part does not spin at one station.
                let o = crate::pose::target::travel(&angle::slerp(&from.o, &to.o, t), &radial);
                way.push(Station { x: self.centre + radial * self.radius_mm, a: radial, o });
            }
        }
        way.push(back);
        way
    }

    /// A station on the sphere in that direction from its centre, looking outwards; `o` as near as
    /// possible to the direction given.
    pub fn on_top(&self, radial: &Vector3<f64>, o: &Vector3<f64>) -> Station {
        let o = crate::pose::target::travel(o, radial);
        Station { x: self.centre + radial * self.radius_mm, a: *radial, o }
    }

    /// Direction of a station from the sphere's centre, unit.
    pub fn radial(&self, at: &Station) -> Option<Vector3<f64>> {
        angle::unit(at.x - self.centre)
    }

    /// The focus drawn back along the beam, the first of a way round.
    pub fn drawn_back(&self, s: &Station) -> Station {
        Station { x: s.x + s.a * self.air.retreat_mm, ..*s }
    }

    /// Whether focus, beam and head keep clear of the part at a path frame.
    pub fn is_clear_at(&self, part_from_focus: &Isometry3<f64>) -> bool {
        let at = Station::at(part_from_focus);
        self.clears(&at.x, &at.a) && self.is_head_clear_at(part_from_focus)
    }

    /// Whether the head alone keeps clear of the part at a path frame.
    pub fn is_head_clear_at(&self, part_from_focus: &Isometry3<f64>) -> bool {
        let at = Station::at(part_from_focus);
        self.lifted_hit(&at, &at).is_none()
    }

    fn clear_mm(&self) -> f64 {
        // Half of what lies between focus and part at the ends, at most 2 mm.
        (0.5 * (self.defocus_mm + self.air.retreat_mm)).clamp(0.1, 2.0)
    }

    fn clears(&self, x: &Point3<f64>, a: &Vector3<f64>) -> bool {
        let clear_mm = self.clear_mm();
        let ray = distance::WideRay::new(x, a, clear_mm);
        let mut clear = true;
        self.part.bvh.visit_ray(x, a, 0.0, f64::INFINITY, clear_mm, |_, corners| {
            clear &= ray.surely_misses(corners) || distance::ray_triangle(x, a, 0.0, corners) > clear_mm;
            if clear { f64::INFINITY } else { -1.0 }
        });
        clear
    }

    /// Where the beam of a station leaves the sphere around the part.
    pub fn on_sphere(&self, s: &Station) -> Station {
        let w = s.x - self.centre;
        let along = w.dot(&s.a);
        let t = -along + (along * along - w.norm_squared() + self.radius_mm * self.radius_mm).max(0.0).sqrt();
        Station { x: s.x + s.a * t.max(0.0), ..*s }
    }

    /// Whether focus and beam keep clear of the part on the straight move.
    fn is_clear(&self, from: &Station, to: &Station) -> bool {
        let turn = angle::between_deg(&from.a, &to.a);
        let steps = ((to.x - from.x).norm() / LOOK_MM).max(turn / LOOK_DEG).ceil().max(1.0);
        let steps = (steps as usize).next_power_of_two();
        // Both ends, the middle, the quarters, and so on: what stands between is met early.
        let order = (0..=steps.ilog2()).rev().flat_map(|level| {
            let stride = 1usize << level;
            let odd = stride < steps;
            (usize::from(odd)..=steps / stride).step_by(1 + usize::from(odd)).map(move |i| i * stride)
        });
        order.into_iter().all(|i| {
            let t = i as f64 / steps as f64;
            self.clears(&(from.x + (to.x - from.x) * t), &angle::slerp(&from.a, &to.a, t))
        })
    }

    /// Duration of a connecting move, s: by its length or by its turn, whichever takes longer.
    pub fn seconds(&self, from: &Station, to: &Station, air_speed_mm_s: f64) -> f64 {
        let turn = from.turn_deg(to);
        ((to.x - from.x).norm() / air_speed_mm_s).max(turn / self.air.turn_deg_s)
    }
}

/// The focus as the flange carries it on a straight move with the laser off.
struct CarriedFocus<'a> {
    mounted: &'a Mounted,
    from: Isometry3<f64>,
    to: Isometry3<f64>,
    /// Angle that the flange turns by, radians.
    turn: f64,
    /// From flange to focus, mm.
    lever_mm: f64,
}

impl<'a> CarriedFocus<'a> {
    fn new(mounted: &'a Mounted, from: &Station, to: &Station) -> CarriedFocus<'a> {
        let [from, to] = [from, to].map(|s| mounted.flange_for(&s.frame()));
        let turn_deg = angle::turned_deg(&from.rotation.rotation_to(&to.rotation).to_rotation_matrix());
        let lever_mm =
            |flange: &Isometry3<f64>| (mounted.focus_at(flange).translation.vector - flange.translation.vector).norm();
        let lever_mm = lever_mm(&from).max(lever_mm(&to));
        CarriedFocus { mounted, from, to, turn: turn_deg.to_radians(), lever_mm }
    }

    fn at(&self, t: f64) -> Pose {
        let focus = Station::at(&self.mounted.focus_for(&self.from.lerp_slerp(&self.to, t)));
        Pose { p: focus.x, a: focus.a }
    }
}

impl Motion for CarriedFocus<'_> {
    fn between(&self, from: (&Pose, f64), to: (&Pose, f64)) -> Pose {
        self.at(0.5 * (from.1 + to.1))
    }

    fn sag_mm(&self) -> f64 {
        0.0
    }

    fn stray_mm(&self, share: f64, reach_mm: f64) -> f64 {
        stray_mm(self.turn * share, self.lever_mm + reach_mm)
    }

    fn blocker(&self, beam: &BeamInterference<'_>, middle: &Pose) -> Option<Blocker> {
        beam.body_blocker(&middle.p, &middle.a)
    }
}
