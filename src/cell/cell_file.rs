//! The cell file: what stands in it, reading and checking it.
//!
//! Each table is checked by its own type.

use super::bodies::Bodies;
use super::calibration::CalibrationNote;
use super::cell_error::CellError;
use super::check::{FigureError, ranges};
use super::controllers::{Abb, Csv, Estun, Fanuc, Kuka, Nachi, Ur, Yaskawa};
use super::frame::{self, Frame};
use super::mount::Mount;
use super::outputs::Outputs;
use super::timing::Timing;
use crate::file::{self, line_of, way_of};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Connecting moves: how far they keep away, how fast they turn, and home.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Air {
    /// How far the focus is drawn back along the beam before a move, mm.
    #[serde(default = "ten")]
    pub retreat_mm: f64,
    /// How far outside the sphere around the part long moves go, mm.
    #[serde(default = "twenty")]
    pub clearance_mm: f64,
    /// How fast what the robot carries may be turned on a straight move with the laser off, degrees per second.
    #[serde(default = "ninety")]
    pub turn_deg_s: f64,
    /// Where the program begins and ends, joint angles in degrees.
    pub home_joints_deg: [f64; 6],
    /// Where the arm goes first from home, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry_joints_deg: Option<[f64; 6]>,
    /// Where the arm goes last before home, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exit_joints_deg: Option<[f64; 6]>,
    /// Tool in hand: height in the base on which the focus crosses the part, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub safe_plane_mm: Option<f64>,
    /// Speed from and to home, per cent of the joints' full speed.
    #[serde(default = "ten")]
    pub home_percent: f64,
}

fn ten() -> f64 {
    10.0
}

fn twenty() -> f64 {
    20.0
}

fn ninety() -> f64 {
    90.0
}

/// A robot cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cell {
    /// Name for people.
    pub name: String,
    /// What the robot carries, unless the job says otherwise.
    #[serde(default)]
    pub mount: Mount,
    /// Part in hand: laser frame in the base, z against the light (L of P2).
    pub base_from_laser: Frame,
    /// Part in hand: part frame on the flange (G).
    pub flange_from_part: Frame,
    /// Tool in hand: part frame in the base (B).
    pub base_from_part: Frame,
    /// Tool in hand: tool frame on the flange (H), its origin in the focus, z with the light.
    pub flange_from_tool: Frame,
    /// Moves with the laser off.
    pub air: Air,
    /// What is switched and set beside the moves.
    #[serde(default)]
    pub outputs: Outputs,
    /// What stands in the cell.
    #[serde(default)]
    pub bodies: Bodies,
    /// How long laser and controller take to answer.
    #[serde(default)]
    pub timing: Timing,
    /// The NACHI program.
    #[serde(default)]
    pub nachi: Nachi,
    /// The KUKA program.
    #[serde(default)]
    pub kuka: Kuka,
    /// The ABB program.
    #[serde(default)]
    pub abb: Abb,
    /// The FANUC program.
    #[serde(default)]
    pub fanuc: Fanuc,
    /// The program for Universal Robots.
    #[serde(default)]
    pub ur: Ur,
    /// The Yaskawa program.
    #[serde(default)]
    pub yaskawa: Yaskawa,
    /// The ESTUN program.
    #[serde(default)]
    pub estun: Estun,
    /// The program as a table.
    #[serde(default)]
    pub csv: Csv,
}

/// Keys of the robots with a shipped cell, and the cells.
const SHIPPED: &[(&str, &str)] = super::shipped_files!("cells");

impl Cell {
    /// The cell that is taken when none is named, by the key of its robot.
    ///
    /// # Errors
    /// There is none for that robot.
    pub fn shipped(robot: &str) -> Result<Cell, CellError> {
        let Some((key, text)) = SHIPPED.iter().find(|(key, _)| *key == robot) else {
            return Err(CellError::NoneFor { robot: robot.into() });
        };
        Cell::parse(text, &format!("assets/cells/{key}.toml"))
    }

    /// Text of the file of a shipped cell, by the key of its robot.
    pub fn shipped_text(robot: &str) -> Option<&'static str> {
        SHIPPED.iter().find(|(key, _)| *key == robot).map(|(_, text)| *text)
    }

    /// Reads a cell file, and the files of its obstacles.
    ///
    /// # Errors
    /// One of the files cannot be read, or a figure makes no sense.
    pub fn load(file: &Path) -> Result<Cell, CellError> {
        let (name, bytes) = (file.display().to_string(), file::bytes(file)?);
        let mut cell = Cell::parse(file::text(&bytes, &name)?, &name)?;
        cell.bodies.load(file.parent())?;
        Ok(cell)
    }

    fn parse(text: &str, file: &str) -> Result<Cell, CellError> {
        let refused = |what: FigureError| {
            let line = line_of(text, &way_of(what.key()));
            CellError::Figure { file: file.into(), line, what: Box::new(what) }
        };
        // What is wrong with a frame is told by its type; the reader of the whole would make words of it.
        let table: toml::Table = file::toml(text, file)?;
        frame::check(&table).map_err(|e| refused(e.into()))?;
        let cell: Cell = file::toml(text, file)?;
        cell.check().map_err(refused)?;
        Ok(cell)
    }

    fn check(&self) -> Result<(), FigureError> {
        let air = &self.air;
        let frames = self.frames();
        if let Some((frame, _)) = frames.iter().find(|(name, f)| f.is_of_a_tip() && *name != "flange_from_tool") {
            return Err(FigureError::TipPoses { frame });
        }
        let home = air.home_joints_deg.iter().map(|x| ("air.home_joints_deg", *x));
        let mut figures = frames
            .iter()
            .flat_map(|(name, f)| f.position_mm.iter().chain(&f.rz_ry_rx_deg).map(|x| (*name, *x)))
            .chain(home);
        if let Some((key, value)) = figures.find(|(_, x)| !x.is_finite()) {
            return Err(FigureError::NotFinite { key, value });
        }
        ranges(&[
            ("air.retreat_mm", air.retreat_mm, 0.0, 1000.0),
            ("air.clearance_mm", air.clearance_mm, 1.0, 1000.0),
            ("air.turn_deg_s", air.turn_deg_s, 1.0, 1000.0),
            ("air.home_percent", air.home_percent, 0.1, 100.0),
            ("air.safe_plane_mm", air.safe_plane_mm.unwrap_or(0.0), -10_000.0, 10_000.0),
        ])?;
        self.outputs.check()?;
        self.timing.check()?;
        self.nachi.check()?;
        self.kuka.check()?;
        self.abb.check()?;
        self.yaskawa.check()?;
        self.estun.check()?;
        self.csv.check()?;
        self.fanuc.check()?;
        self.ur.check()?;
        self.bodies.check()
    }

    /// The frames by their keys.
    pub fn frames(&self) -> [(&'static str, &Frame); 4] {
        let [laser, held, lying, tool] = frame::KEYS;
        [
            (laser, &self.base_from_laser),
            (held, &self.flange_from_part),
            (lying, &self.base_from_part),
            (tool, &self.flange_from_tool),
        ]
    }

    /// How well each frame fits what was measured; those given by figures are left out.
    pub fn calibrations(&self) -> Vec<CalibrationNote> {
        self.frames().iter().filter_map(|(name, frame)| frame.calibration(name)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::FileError;

    #[test]
    fn bad_figures_are_named() {
        let bad = SHIPPED[0].1.replace("clearance_mm = 20.0", "clearance_mm = -3.0");
        let refused = |text: &str| match Cell::parse(text, "cell.toml").expect_err("refused") {
            CellError::Figure { file, what, .. } if file == "cell.toml" => *what,
            other => panic!("{other}"),
        };
        let range = |key: &str, value, low, high| FigureError::Range { key: key.into(), value, low, high };
        assert_eq!(refused(&bad), range("air.clearance_mm", -3.0, 1.0, 1000.0));
        let slow = SHIPPED[0].1.replace("laser_on_s = 0.0", "laser_on_s = -1.0");
        assert_eq!(refused(&slow), range("timing.laser_on_s", -1.0, 0.0, 60.0));
        assert!(matches!(Cell::parse("name = 3", "cell.toml"), Err(CellError::File(FileError::Toml { .. }))));
    }
}
