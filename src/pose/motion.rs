//! The motion between two targets: the point goes straight, the axis turns at constant rate, and
//! the spot is where that axis meets the part.
//!
//! Conservative advancement: a motion is bisected until a piece is clear by more than anything on it can move, or
//! so short that its middle decides. So a fin between two free targets is found however thin it is, whether the
//! beam or only the head hits it.

use super::Pose;
use super::interference::{BeamInterference, Blocker, Conflict};
use crate::progress::Cancelled;

/// Length of a piece, mm, from which on its middle decides: no point of the beam moves further on it, so the
/// beam's own margin (0.02 mm) covers it from end to end.
const PIECE_MM: f64 = 0.02;

/// A motion over t from 0 to 1.
pub trait Motion {
    /// The pose at t, half way between two others.
    fn between(&self, from: (&Pose, f64), to: (&Pose, f64)) -> Pose;

    /// How far the part may lie from the chord between two poses, mm.
    fn sag_mm(&self) -> f64;

    /// How far a point of the tool at `reach_mm` from the spot may stray, over a share of the motion, from the motion
    /// with a straight spot and a constant turn, mm.
    fn stray_mm(&self, share: f64, reach_mm: f64) -> f64;

    /// What is in the way in the middle of a short piece.
    fn blocker(&self, beam: &BeamInterference<'_>, middle: &Pose) -> Option<Blocker>;
}

/// The spot goes straight, and the axis turns at constant rate.
struct Straight {
    sag_mm: f64,
}

impl Motion for Straight {
    fn between(&self, from: (&Pose, f64), to: (&Pose, f64)) -> Pose {
        from.0.midway(to.0, 0.5)
    }

    fn sag_mm(&self) -> f64 {
        self.sag_mm
    }

    fn stray_mm(&self, _share: f64, _reach_mm: f64) -> f64 {
        0.0
    }

    fn blocker(&self, beam: &BeamInterference<'_>, middle: &Pose) -> Option<Blocker> {
        let sag_mm = self.sag_mm;
        let spot = if sag_mm > 1e-9 { beam.spot(&middle.p, &middle.a, 2.0 * sag_mm + 1e-3) } else { middle.p };
        if beam.is_free(&spot, &middle.a) { None } else { beam.blocker(&spot, &middle.a) }
    }
}

/// Whether the beam meets nothing between two targets. `sag_mm`: how far the part may lie from the
/// chord between them.
pub fn is_free(beam: &BeamInterference<'_>, from: &Pose, to: &Pose, sag_mm: f64) -> bool {
    hit(beam, from, to, sag_mm).is_none()
}

/// A share of the way at which the beam hits something, if it does.
pub fn hit(beam: &BeamInterference<'_>, from: &Pose, to: &Pose, sag_mm: f64) -> Option<f64> {
    // Cancelled work proves nothing.
    swept(beam, &Straight { sag_mm }, (from, 0.0), (to, 1.0)).map_or(Some(0.0), |found| found.map(|h| h.t))
}

/// Where a motion hits something.
#[derive(Clone, Copy, Debug)]
pub struct Swept {
    /// Share of the way.
    pub t: f64,
    /// The pose there.
    pub pose: Pose,
    /// What is in the way.
    pub blocker: Blocker,
}

/// Sweeps a motion between two poses at their shares of the way: `None` is a proof that beam and head
/// keep clear of everything, but for what `ToolGeometry::short_mm` allows of the margin.
///
/// # Errors
/// [`Cancelled`] when the work that asks should end.
pub fn swept(
    beam: &BeamInterference<'_>,
    motion: &impl Motion,
    from: (&Pose, f64),
    to: (&Pose, f64),
) -> Result<Option<Swept>, Cancelled> {
    beam.check()?;
    let middle = motion.between(from, to);
    let share = to.1 - from.1;
    let stray = |reach_mm: f64| motion.stray_mm(share, reach_mm);
    let reach_mm = beam.ray_conflict([from.0, &middle, to.0], motion.sag_mm(), stray);
    let body = beam.body_conflict([from.0, &middle, to.0], motion.sag_mm(), stray);
    if reach_mm.is_none() && body == Conflict::None {
        return Ok(None);
    }
    let half_turn = from.0.sine_of_half_turn(to.0);
    let is_short = reach_mm.is_none_or(|reach_mm| (to.0.p - from.0.p).norm() + 2.0 * reach_mm * half_turn <= PIECE_MM);
    let t = 0.5 * (from.1 + to.1);
    // A piece with a jump in it never gets short.
    if is_short && body != Conflict::Wide || share < LEAST_SHARE {
        return Ok(motion.blocker(beam, &middle).map(|blocker| Swept { t, pose: middle, blocker }));
    }
    match swept(beam, motion, from, (&middle, t))? {
        None => swept(beam, motion, (&middle, t), to),
        found => Ok(found),
    }
}

/// What the head hits on a motion of the focus. `head` has a geometry without a beam (`ToolGeometry::head_alone`);
/// `None` is a proof that it keeps its margin.
pub fn head_hit(
    head: &BeamInterference<'_>,
    motion: &impl Motion,
    from: (&Pose, f64),
    to: (&Pose, f64),
) -> Option<Blocker> {
    let (middle, share) = (motion.between(from, to), to.1 - from.1);
    match head.body_conflict([from.0, &middle, to.0], 0.0, |reach_mm| motion.stray_mm(share, reach_mm)) {
        Conflict::None => None,
        Conflict::Wide if share >= LEAST_SHARE => {
            let t = 0.5 * (from.1 + to.1);
            head_hit(head, motion, from, (&middle, t)).or_else(|| head_hit(head, motion, (&middle, t), to))
        }
        _ => head.body_blocker(&middle.p, &middle.a),
    }
}

/// Least share of a motion that is bisected further: of a metre, a micrometre.
const LEAST_SHARE: f64 = 1e-6;
