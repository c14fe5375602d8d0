//! The cell file, and the pose of the flange for a pose of the beam on the part.
//!
//! Part in hand (P1 4, P2 4.3): the laser is fixed and points down, the robot carries the part.

use super::Timing;
use super::bodies::Bodies;
use super::calibration::CalibrationNote;
use super::controllers::{Abb, Estun, Fanuc, Kuka, Nachi, Ur, Yaskawa};
use super::frame::Frame;
use super::outputs::Outputs;
use crate::part::LoadError;
use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use serde::{Deserialize, Serialize};
use std::path::Path;
use thiserror::Error;

/// Moves with the laser off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Air {
    /// How far the focus is drawn back along the beam before a move, mm.
    #[serde(default = "ten")]
    pub retreat_mm: f64,
    /// How far outside the part's sphere long moves go, mm.
    #[serde(default = "twenty")]
    pub clearance_mm: f64,
    /// How fast the part may be turned, degrees per second.
    #[serde(default = "ninety")]
    pub turn_deg_s: f64,
    /// Where the program begins and ends, joint angles in degrees.
    pub home_joints_deg: [f64; 6],
    /// Where the arm goes first from home, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry_joints_deg: Option<[f64; 6]>,
    /// Where it goes last before home, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exit_joints_deg: Option<[f64; 6]>,
    /// Tool in hand: height in the base on which the focus crosses the part, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub safe_plane_mm: Option<f64>,
    /// Speed from and to home, per cent.
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

/// What the robot carries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mount {
    /// The part, under a fixed laser (P1, P2).
    #[default]
    PartInHand,
    /// The head, over a fixed part (P3, P4).
    ToolInHand,
}

impl Mount {
    /// The word on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Mount::PartInHand => "part-in-hand",
            Mount::ToolInHand => "tool-in-hand",
        }
    }

    /// The mount of that word.
    pub fn from_word(word: &str) -> Option<Mount> {
        [Mount::PartInHand, Mount::ToolInHand].into_iter().find(|m| m.word() == word)
    }
}

/// Rotation of the part, or the tool, about the beam axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Spin {
    /// Chosen for the arm's sake: the spot is round.
    #[default]
    Free,
    /// Fixed to the travel direction: a line scanner needs that.
    Travel,
}

impl Spin {
    /// The word on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Spin::Free => "free",
            Spin::Travel => "travel",
        }
    }

    /// The spin of that word.
    pub fn from_word(word: &str) -> Option<Spin> {
        [Spin::Free, Spin::Travel].into_iter().find(|s| s.word() == word)
    }
}

crate::part::keyed_words!(Mount: PartInHand, ToolInHand);
crate::part::keyed_words!(Spin: Free, Travel);

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
}

/// Why a cell file cannot be used.
#[derive(Debug, Error)]
pub enum CellError {
    /// A robot of the operator's own has no cell here.
    #[error("there is no shipped cell for robot {robot:?}; give --cell")]
    NoneFor {
        /// The robot.
        robot: String,
    },
    /// It cannot be read.
    #[error("{file}: cannot be read: {source}")]
    Io {
        /// The file.
        file: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// It is not a cell file.
    #[error("{file}: {message}")]
    Toml {
        /// The file.
        file: String,
        /// Where and what.
        message: String,
    },
    /// A body of the cell cannot be read.
    #[error("an obstacle of the cell: {0}")]
    Obstacle(LoadError),
    /// A figure makes no sense.
    #[error("{file}: {what}")]
    Figure {
        /// The file.
        file: String,
        /// Which, and what it may be.
        what: String,
    },
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

    /// Reads a cell file.
    pub fn load(file: &Path) -> Result<Cell, CellError> {
        let name = file.display().to_string();
        let text = std::fs::read_to_string(file).map_err(|source| CellError::Io { file: name.clone(), source })?;
        let mut cell = Cell::parse(&text, &name)?;
        cell.bodies.load(file.parent())?;
        Ok(cell)
    }

    fn parse(text: &str, file: &str) -> Result<Cell, CellError> {
        let cell: Cell = toml::from_str(text)
            .map_err(|e| CellError::Toml { file: file.into(), message: e.to_string().trim_end().replace('\n', " ") })?;
        cell.check().map_err(|what| CellError::Figure { file: file.into(), what })?;
        Ok(cell)
    }

    fn check(&self) -> Result<(), String> {
        let (air, nachi) = (&self.air, &self.nachi);
        let frames = self.frames();
        if let Some((name, _)) = frames.iter().find(|(name, f)| f.is_of_a_tip() && *name != "flange_from_tool") {
            return Err(format!("{name}: tip_poses tell where a tool's tip is; give three_points or points here"));
        }
        let mut numbers = frames
            .iter()
            .map(|(_, f)| f)
            .flat_map(|f| f.position_mm.iter().chain(&f.rz_ry_rx_deg))
            .chain(&air.home_joints_deg);
        if let Some(bad) = numbers.find(|x| !x.is_finite()) {
            return Err(format!("{bad} is not a number that a frame can have"));
        }
        let ranges = [
            ("air.retreat_mm", air.retreat_mm, 0.0, 1000.0),
            ("air.clearance_mm", air.clearance_mm, 1.0, 1000.0),
            ("air.turn_deg_s", air.turn_deg_s, 1.0, 1000.0),
            ("air.home_percent", air.home_percent, 0.1, 100.0),
            ("air.safe_plane_mm", air.safe_plane_mm.unwrap_or(0.0), -10_000.0, 10_000.0),
        ];
        if let Some((name, value, low, high)) = ranges.into_iter().find(|(_, v, lo, hi)| !(lo..=hi).contains(&v)) {
            return Err(format!("{name} = {value}: give {low} to {high}"));
        }
        self.outputs.check()?;
        self.timing.check()?;
        nachi.check()?;
        self.kuka.check()?;
        self.abb.check()?;
        self.yaskawa.check()?;
        self.estun.check()?;
        self.fanuc.check()?;
        self.ur.check()?;
        self.bodies.check()
    }

    /// The frames by their keys.
    pub fn frames(&self) -> [(&'static str, &Frame); 4] {
        [
            ("base_from_laser", &self.base_from_laser),
            ("flange_from_part", &self.flange_from_part),
            ("base_from_part", &self.base_from_part),
            ("flange_from_tool", &self.flange_from_tool),
        ]
    }

    /// How well each frame fits what was measured; those given by figures are left out.
    pub fn calibrations(&self) -> Vec<CalibrationNote> {
        self.frames().iter().filter_map(|(name, frame)| frame.calibration(name)).collect()
    }

    /// The frames of a mount, ready to be asked for many poses.
    pub fn mounted(&self, mount: Mount) -> Mounted {
        match mount {
            Mount::PartInHand => {
                Mounted { mount, fixed: self.base_from_laser.isometry(), carried: self.flange_from_part.isometry() }
            }
            Mount::ToolInHand => {
                Mounted { mount, fixed: self.base_from_part.isometry(), carried: self.flange_from_focus() }
            }
        }
    }

    /// Tool in hand: the laser frame on the flange, its origin in the focus, z against the light.
    pub fn flange_from_focus(&self) -> Isometry3<f64> {
        self.flange_from_tool.isometry() * half_turn()
    }
}

/// The frames of a mount: what stands in the base, and what hangs on the flange.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounted {
    mount: Mount,
    /// Laser in the base, or part in the base.
    fixed: Isometry3<f64>,
    /// Part on the flange, or laser frame on the flange.
    carried: Isometry3<f64>,
}

impl Mounted {
    /// Pose of the flange in the base that brings focus and beam to a path frame of the part.
    ///
    /// Part in hand `T = L·(G·F)⁻¹`, tool in hand `T = B·F·Rot_o(180°)·H⁻¹`.
    pub fn flange_for(&self, part_from_focus: &Isometry3<f64>) -> Isometry3<f64> {
        match self.mount {
            Mount::PartInHand => self.fixed * (self.carried * part_from_focus).inverse(),
            Mount::ToolInHand => self.fixed * part_from_focus * self.carried.inverse(),
        }
    }

    /// Part in the base at a pose of the flange.
    pub fn part_at(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        match self.mount {
            Mount::PartInHand => base_from_flange * self.carried,
            Mount::ToolInHand => self.fixed,
        }
    }

    /// Focus in the base at a pose of the flange, z against the light.
    pub fn focus_at(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        match self.mount {
            Mount::PartInHand => self.fixed,
            Mount::ToolInHand => base_from_flange * self.carried,
        }
    }

    /// The path frame at a pose of the flange: the inverse of [`Mounted::flange_for`].
    pub fn focus_for(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        self.part_at(base_from_flange).inverse() * self.focus_at(base_from_flange)
    }
}

/// Half a turn about y: a tool's z points with the light, a path frame's against it.
pub fn half_turn() -> Isometry3<f64> {
    let half = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(0.0, 0.0, 1.0, 0.0));
    Isometry3::from_parts(Translation3::identity(), half)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::target::frame;
    use nalgebra::{Point3, Vector3};

    /// P2 Eqs 4–6: with G = 1, `P = L − D − V'`, `V' = [n o a]ᵀ·v`.
    #[test]
    fn the_flange_stands_where_p2_says() {
        let mut cell = Cell::shipped("mz04").expect("the shipped cell is valid");
        cell.flange_from_part.position_mm = [0.0; 3];
        let a = Vector3::new(0.6, 0.0, 0.8);
        let o = Vector3::new(0.0, 1.0, 0.0);
        let (v, d) = (Point3::new(10.0, -4.0, 7.0), 15.0);
        let t = cell.mounted(Mount::PartInHand).flange_for(&frame(&(v + a * d), &a, &o));
        let n = o.cross(&a);
        let v_prime = Vector3::new(n.dot(&v.coords), o.dot(&v.coords), a.dot(&v.coords));
        let expected = Vector3::from(cell.base_from_laser.position_mm) - Vector3::new(0.0, 0.0, d) - v_prime;
        assert!((t.translation.vector - expected).norm() < 1e-12);
        assert!((t.rotation * a - Vector3::z()).norm() < 1e-12, "the beam axis points up at the laser");
    }

    #[test]
    fn bad_figures_are_named() {
        let bad = SHIPPED[0].1.replace("clearance_mm = 20.0", "clearance_mm = -3.0");
        let said = Cell::parse(&bad, "cell.toml").expect_err("refused").to_string();
        assert!(said.contains("cell.toml") && said.contains("air.clearance_mm"), "{said}");
        let slow = SHIPPED[0].1.replace("laser_on_s = 0.0", "laser_on_s = -1.0");
        let said = Cell::parse(&slow, "cell.toml").expect_err("refused").to_string();
        assert!(said.contains("timing.laser_on_s = -1") && said.contains("0 to 60"), "{said}");
        assert!(Cell::parse("name = 3", "cell.toml").is_err());
    }
}
