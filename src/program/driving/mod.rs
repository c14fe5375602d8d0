//! The steps of a program with a robot: joints for every move, targets put in between where the spot would leave its
//! line, and connecting moves that the arm can make.
//!
//! Asked for a straight move, a controller moves the flange straight and turns it about one axis; the spot then
//! leaves the planned line between two targets by the lever from flange to spot. What cannot be driven is refused
//! with its reason; spins and branches are not chosen here.

mod lit_pieces;
mod sequence;

use super::connecting::pieces::{Cuts, LitRange};
use super::connecting::pose_cache::{JointBits, PoseCache, bits};
use super::connecting::transfer_space::TransferSpace;
use super::connecting::with_robot::{ConnectingMoveCache, MovingArm};
use super::motion::lit::StraightFlange;
use super::neutral::steps::Go;
use crate::cell::collision::Collision;
use crate::cell::motion::{Choice, Refusal};
use crate::cell::mounting::Mounted;
use crate::cell::{Robot, Setup};
use crate::pose::Pass;
use crate::progress::Progress;
use lit_pieces::DrivenPiece;

/// What the driven program is made from.
pub struct Drive<'a> {
    /// The cell, with a robot in it.
    pub setup: &'a Setup,
    /// Its frames.
    pub mounted: Mounted,
    /// The robot of the setup.
    pub robot: &'a Robot,
    /// Speed of the focus in the air, mm/s.
    pub air_mm_s: f64,
    /// What keeps the spot to its line, and clear.
    pub straight: StraightFlange<'a>,
    /// What the arm and all it carries may touch; `None`: nothing.
    pub collision: Option<&'a Collision<'a>>,
    /// Whether to go on; the steps of a stopped drive are refused without a reason.
    pub progress: &'a Progress,
    /// Where lit pieces are cut.
    pub cuts: &'a Cuts,
    /// What was found out so far.
    pub cache: DriveCache,
}

/// Moves and pieces that were worked out.
#[derive(Default)]
pub struct DriveCache {
    moves: ConnectingMoveCache,
    ways: PoseCache<Ends, Option<Vec<Go>>>,
    pieces: PoseCache<(LitRange, Vec<JointBits>), Result<DrivenPiece, Refusal>>,
}

/// The end of a piece (or home) and the start of the next (or home).
type Ends = [Option<JointBits>; 2];

/// What could not be driven.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Undriven {
    /// Targets, and why.
    pub refused: Vec<Refusal>,
    /// Passes in branches that no way leads to: another branch may do the same targets.
    pub closed: Vec<(usize, u8)>,
}

impl<'a> Drive<'a> {
    /// The arm that makes the connecting moves.
    fn arm(&'a self, space: &'a TransferSpace<'a>) -> MovingArm<'a> {
        MovingArm {
            setup: self.setup,
            mounted: &self.mounted,
            robot: self.robot,
            air_mm_s: self.air_mm_s,
            collision: self.collision,
            space,
            cache: &self.cache.moves,
        }
    }

    fn driven_piece(
        &self,
        space: &TransferSpace<'_>,
        passes: &[Pass],
        choice: &Choice,
        of: LitRange,
    ) -> Result<DrivenPiece, Refusal> {
        let chosen = choice.rows[of.pass][of.first..=of.last].iter().flatten().map(|c| bits(&c.joints_deg)).collect();
        self.cache.pieces.get((of, chosen), || self.drive_piece(space, passes, choice, of))
    }
}
