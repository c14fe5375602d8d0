//! Key `cell` of the report: the frames that a plan was made for.

use crate::cell::{Frame, Mount, Setup};
use serde::Serialize;

/// The frames of a plan, row by row, mm; those of its mount.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CellReport {
    /// Key or file of the robot; null: poses only.
    pub robot: Option<String>,
    /// `part-in-hand` or `tool-in-hand`.
    pub mount: &'static str,
    /// Part in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_from_laser: Option<[[f64; 4]; 4]>,
    /// Part in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flange_from_part: Option<[[f64; 4]; 4]>,
    /// Tool in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_from_part: Option<[[f64; 4]; 4]>,
    /// Tool in hand.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flange_from_tool: Option<[[f64; 4]; 4]>,
}

impl CellReport {
    /// The frames of a setup; `robot` as the job names it.
    pub fn new(setup: &Setup, robot: &str) -> CellReport {
        let rows = |frame: &Frame| {
            let m = frame.isometry().to_homogeneous();
            std::array::from_fn(|r| std::array::from_fn(|c| m[(r, c)] + 0.0))
        };
        let cell = &setup.cell;
        let in_hand = setup.mount == Mount::PartInHand;
        let of = |mine: bool, frame: &Frame| mine.then(|| rows(frame));
        CellReport {
            robot: (!robot.is_empty()).then(|| robot.to_owned()),
            mount: setup.mount.word(),
            base_from_laser: of(in_hand, &cell.base_from_laser),
            flange_from_part: of(in_hand, &cell.flange_from_part),
            base_from_part: of(!in_hand, &cell.base_from_part),
            flange_from_tool: of(!in_hand, &cell.flange_from_tool),
        }
    }
}
