//! The proof that nothing is in the way of a lit move as the controller makes it: between two poses the
//! flange goes straight (or the path frame, where the controller moves that), and the spot a little
//! beside its line.
//!
//! Planner and verification both prove by [`swept`]. What is proven is a little less than
//! the margin that was planned with: the spot may leave its line by the allowed deviation, and short
//! pieces are told by their middle.

use super::spot::{self, FROM_MM};
use crate::beam::{ProcessSettings, ToolConfiguration, ToolGeometry};
use crate::cell::mounting::Mounted;
use crate::part::{GrownPart, Part, angle};
use crate::pose::Pose;
use crate::pose::checker::KeptByContact;
use crate::pose::motion::{Motion, Swept, swept};
use crate::pose::{BeamInterference, Blocker, ToolBody};
use crate::program::neutral::steps::{Step, Steps};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Isometry3, Point3, Vector3};
use rayon::prelude::*;
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// A move with the laser on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LitMove {
    /// Where it begins: flange in the base, or path frame in the part.
    pub from: Isometry3<f64>,
    /// Where it ends.
    pub to: Isometry3<f64>,
    /// Whether it is the path frame that goes straight.
    pub by_focus: bool,
    /// What it is worked with.
    pub settings: ProcessSettings,
}

impl Steps {
    /// The moves with the laser on, as the flange makes them.
    pub fn lit_moves(&self, mounted: &Mounted) -> Vec<LitMove> {
        let (mut lit, mut at, mut settings) = (false, None, ProcessSettings::default());
        let mut out = Vec::new();
        for step in &self.list {
            match step {
                Step::Laser(on) => lit = *on,
                Step::Process(with) => settings = *with,
                Step::Go(go) => {
                    let to = mounted.flange_for(&go.to.frame());
                    out.extend(at.filter(|_| lit).map(|from| LitMove { from, to, by_focus: false, settings }));
                    at = Some(to);
                }
                Step::Comment(_) | Step::Home { .. } => {}
            }
        }
        out
    }
}

/// What was proven of lit moves.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Proof {
    /// Lit moves.
    #[serde(rename = "intervals")]
    pub lit_moves: usize,
    /// How many moves cannot touch anything.
    pub proven: usize,
    /// Moves that touch something: their index in the list, and what they touch.
    #[serde(serialize_with = "count")]
    pub refuted: Vec<(usize, Blocker)>,
    /// What cone and head are proven to keep from everything, mm; 0 for a ray.
    pub margin_mm: f64,
    /// The moves themselves: who has the same ones again need not prove them again.
    #[serde(skip)]
    pub moves: Arc<Vec<LitMove>>,
}

/// In reports: how many.
fn count<S: Serializer>(list: &[(usize, Blocker)], s: S) -> Result<S::Ok, S::Error> {
    s.serialize_u64(list.len() as u64)
}

/// Sweeps lit moves.
#[derive(Clone, Debug)]
pub struct Prover<'a> {
    part: &'a Part,
    /// The part as it has grown behind each layer.
    grown: &'a [Arc<GrownPart>],
    /// What stands around the beam, for all that is worked with.
    bodies: Vec<(ProcessSettings, Option<ToolGeometry<'a>>)>,
    /// How the flange carries the focus.
    pub mounted: Mounted,
    sag_mm: f64,
    window_mm: f64,
    /// The bodies that a plan is held to.
    spare: Vec<(ProcessSettings, Option<ToolGeometry<'a>>)>,
    /// The share of what a ray keeps at a target that it has to keep here.
    ray_share: f64,
    /// The work that it is asked by.
    pub progress: Option<&'a Progress>,
}

/// A plan keeps this much more clear than is asked of its program, mm: numbers are written with three or four
/// digits, and what just passes a facet must not just hit it when it is read back.
pub const SPARE_MM: f64 = 0.01;

impl<'a> Prover<'a> {
    /// A prover for a part and the configurations that its lit moves are made in. `deviation_mm`: how far the spot may
    /// leave its line; `sag_mm`: how far the part may lie from a chord.
    pub fn new(
        part: &'a Part,
        configurations: &[ToolConfiguration<'a>],
        mounted: Mounted,
        deviation_mm: f64,
        sag_mm: f64,
    ) -> Prover<'a> {
        // A plan may lose the length of a short piece, and what is read back is not held to that again.
        let eased = |b: &ToolGeometry<'a>| b.eased(deviation_mm + b.short_mm + SPARE_MM, 2);
        let spare = |b: &ToolGeometry<'a>| b.eased(deviation_mm, 1);
        Prover {
            part,
            grown: &[],
            bodies: configurations.iter().map(|s| (s.settings, s.geometry.as_ref().map(eased))).collect(),
            spare: configurations.iter().map(|s| (s.settings, s.geometry.as_ref().map(spare))).collect(),
            mounted,
            sag_mm,
            window_mm: deviation_mm + 2.0 * sag_mm,
            ray_share: 0.0,
            progress: None,
        }
    }

    /// Asked by work that may be cancelled.
    pub fn under(self, progress: &'a Progress) -> Prover<'a> {
        Prover { progress: Some(progress), ..self }
    }

    /// With the part as it has grown behind each layer: a move is proven on the part for which its own layer
    /// begins.
    pub fn on_layers(self, grown: &'a [Arc<GrownPart>]) -> Prover<'a> {
        Prover { grown, ..self }
    }

    /// The part when a layer begins.
    pub fn part_of(&self, layer: u32) -> &'a Part {
        let before = (layer as usize).checked_sub(1);
        before.and_then(|n| self.grown.get(n)).map_or(self.part, |g| &g.part)
    }

    /// The part at its largest.
    pub fn whole(&self) -> &'a Part {
        GrownPart::largest(self.part, self.grown)
    }

    /// Where the beam of a path frame stands on the part, and its axis: no farther from where it should be
    /// than it may deviate, and than the part may lie from a chord.
    pub fn spot(
        &self,
        beam: &BeamInterference<'_>,
        part_from_focus: &Isometry3<f64>,
        settings: &ProcessSettings,
    ) -> (Point3<f64>, Vector3<f64>) {
        spot::on_part(beam, part_from_focus, settings.defocus_mm, self.window_mm)
    }

    /// A prover with a little more margin, for plans.
    pub fn with_spare(&self) -> Prover<'a> {
        Prover { bodies: self.spare.clone(), ray_share: 0.5, ..self.clone() }
    }

    /// What a contact tool keeps clear of on moves of these settings; `None`: there is none.
    pub fn kept_by_contact(&self, settings: &ProcessSettings) -> Option<KeptByContact> {
        let geometry = self.tool_geometry(settings)?;
        let contact = geometry.contact.as_ref()?;
        Some(KeptByContact {
            cones: contact.core.iter().map(|f| [f.t0_mm, f.t1_mm, f.r0_mm, f.r1_mm]).collect(),
            skin_mm: contact.skin_mm,
            wall_mm: contact.round_mm + geometry.margin_mm,
        })
    }

    /// The tool geometry of a move. Falls back to the nearest settings that a plan has used.
    fn tool_geometry(&self, settings: &ProcessSettings) -> Option<&ToolGeometry<'a>> {
        let off =
            |w: &ProcessSettings| (w.defocus_mm - settings.defocus_mm).abs() + (w.spot_mm - settings.spot_mm).abs();
        self.bodies.iter().min_by(|a, b| off(&a.0).total_cmp(&off(&b.0)))?.1.as_ref()
    }

    /// What is in the way of a move, if anything is.
    ///
    /// # Errors
    /// [`Cancelled`] when the work that it is asked by should end.
    pub fn hit(&self, m: &LitMove) -> Result<Option<Swept>, Cancelled> {
        let beam = BeamInterference::with(self.part_of(m.settings.layer), self.tool_geometry(&m.settings))
            .under(self.progress);
        let lever_mm = |pose: &Isometry3<f64>| {
            if m.by_focus {
                return m.settings.defocus_mm.abs();
            }
            (self.mounted.focus_at(pose).translation.vector - pose.translation.vector).norm()
                + m.settings.defocus_mm.abs()
        };
        let turn_deg = angle::turned_deg(&m.from.rotation.rotation_to(&m.to.rotation).to_rotation_matrix());
        let going = Going {
            prover: self,
            beam: &beam,
            m,
            turn: turn_deg.to_radians(),
            lever_mm: lever_mm(&m.from).max(lever_mm(&m.to)),
        };
        swept(&beam, &going, (&going.at(0.0), 0.0), (&going.at(1.0), 1.0))
    }

    /// Proves what can be proven.
    ///
    /// # Errors
    /// [`Cancelled`] when the work that it is asked by should end.
    pub fn prove(&self, moves: Vec<LitMove>) -> Result<Proof, Cancelled> {
        let found: Vec<Option<Blocker>> =
            moves.par_iter().map(|m| Ok(self.hit(m)?.map(|h| h.blocker))).collect::<Result<_, Cancelled>>()?;
        let refuted: Vec<(usize, Blocker)> = found.iter().enumerate().filter_map(|(i, b)| Some((i, (*b)?))).collect();
        let margin_mm = self.margin_mm();
        let (lit_moves, proven) = (moves.len(), moves.len() - refuted.len());
        Ok(Proof { lit_moves, proven, refuted, margin_mm, moves: Arc::new(moves) })
    }

    /// What cone and head are proven to keep from everything, mm; 0 for a ray.
    pub fn margin_mm(&self) -> f64 {
        let bodies = self.bodies.iter().filter_map(|b| b.1.as_ref());
        let margins = bodies.filter(|b| b.has_head).map(|b| b.margin_mm - b.short_mm);
        margins.reduce(f64::min).unwrap_or(0.0).max(0.0)
    }
}

/// How far a point that turns about a straight line, so far from it, may lie from where a straight way puts it:
/// it lies off its chord by `(1 − cos(θ/2))·r ≤ θ²r/8`; twice that, for the point and for the line that it is
/// compared with. `turn` in radians.
pub fn stray_mm(turn: f64, radius_mm: f64) -> f64 {
    0.25 * turn * turn * radius_mm
}

/// A lit move on its way.
struct Going<'a> {
    prover: &'a Prover<'a>,
    beam: &'a BeamInterference<'a>,
    m: &'a LitMove,
    /// Angle that it turns by, radians.
    turn: f64,
    /// From what goes straight to the spot, mm.
    lever_mm: f64,
}

impl Going<'_> {
    /// The spot on the part, and the axis.
    fn at(&self, t: f64) -> Pose {
        let pose = self.m.from.lerp_slerp(&self.m.to, t);
        let focus = if self.m.by_focus { pose } else { self.prover.mounted.focus_for(&pose) };
        let (p, a) = self.prover.spot(self.beam, &focus, &self.m.settings);
        Pose { p, a }
    }
}

impl Motion for Going<'_> {
    fn between(&self, from: (&Pose, f64), to: (&Pose, f64)) -> Pose {
        self.at(0.5 * (from.1 + to.1))
    }

    fn sag_mm(&self) -> f64 {
        self.prover.sag_mm
    }

    fn stray_mm(&self, share: f64, reach_mm: f64) -> f64 {
        stray_mm(self.turn * share, self.lever_mm + reach_mm)
    }

    /// Beside its planned point the ray may start a little inside a rounding: it is looked at from
    /// [`FROM_MM`] on.
    fn blocker(&self, beam: &BeamInterference<'_>, middle: &Pose) -> Option<Blocker> {
        if let Some(obstruction) = beam.passes_near(&middle.p, &middle.a, FROM_MM, self.prover.ray_share) {
            return Some(Blocker { tool_body: ToolBody::Beam, obstruction, t_mm: FROM_MM });
        }
        beam.body_blocker(&middle.p, &middle.a)
    }
}
