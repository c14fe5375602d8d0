//! Robot files: those that are shipped and those of the operator's own, read and checked.

use super::{Robot, SHIPPED};
use crate::cell::check::{FigureError, ranges};
use crate::file::{self, FileError, Step, line_of, way_of};
use crate::part::LoadError;
use std::path::Path;
use thiserror::Error;

/// Why a robot cannot be used.
#[derive(Debug, Error)]
pub enum RobotError {
    /// Neither a shipped robot nor a file.
    #[error("{name:?} unknown")]
    Unknown {
        /// The name that was asked for.
        name: String,
        /// Keys of those there are.
        shipped: Vec<&'static str>,
    },
    /// It cannot be read, is no robot file, or a figure is missing.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file of one of the arm's bodies cannot be read, or is no STL.
    #[error("{file}: {key}: {what}")]
    Mesh {
        /// The robot file.
        file: String,
        /// The key that names the body's file.
        key: &'static str,
        /// Which file, and why not.
        what: LoadError,
    },
    /// A figure makes no sense.
    #[error("{file}: {what}")]
    Figure {
        /// The file.
        file: String,
        /// Its line, from 1; that of the table, where the key is not there.
        line: Option<usize>,
        /// The figure, and what is wrong with it.
        what: Box<RobotFigureError>,
    },
}

/// What makes no sense in a robot file.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RobotFigureError {
    /// A figure is out of its range.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// The kinematics are not given once, as `[opw]` or as `[ur]`.
    #[error("kinematics not given once")]
    Kinematics,
    /// A length of the arm is shorter than any arm's.
    #[error("{key} = {value_mm}, at least {least_mm}")]
    Short {
        /// The key.
        key: &'static str,
        /// How long it is, mm.
        value_mm: f64,
        /// How long an arm's is at least, mm.
        least_mm: f64,
    },
    /// The sense of a joint is neither 1 nor -1.
    #[error("signs has {value}")]
    Sign {
        /// What stands there.
        value: f64,
    },
    /// The least and the greatest angle of a joint are no range.
    #[error("limits_deg of J{joint}: {range_deg:?}")]
    Limits {
        /// The joint; the first is 1.
        joint: usize,
        /// What stands there.
        range_deg: [f64; 2],
    },
    /// The full speed of a joint is out of its range.
    #[error("speeds_deg_s of J{joint} = {value}")]
    Speed {
        /// The joint; the first is 1.
        joint: usize,
        /// What stands there, degrees per second.
        value: f64,
        /// The least that may.
        low: f64,
        /// The most that may.
        high: f64,
    },
    /// The files of the arm's bodies have more facets than can be looked at.
    #[error("links.meshes: {facets} facets, at most {most}")]
    MeshFacets {
        /// How many they have together.
        facets: usize,
        /// How many they may have.
        most: usize,
    },
    /// The body in a file lies far from the joint that moves it.
    #[error("{key}: {file} is {off_mm} mm off its joint")]
    MeshOff {
        /// The key that names the file.
        key: &'static str,
        /// The file.
        file: String,
        /// How far the sphere around it is from the joint, mm.
        off_mm: f64,
    },
    /// There is no dialect of that name.
    #[error("dialect {dialect:?} unknown")]
    Dialect {
        /// What stands there.
        dialect: String,
        /// Names of those there are.
        known: Vec<&'static str>,
    },
}

impl RobotFigureError {
    /// The key that it is about; that of the arm's lengths without its table.
    fn key(&self) -> &str {
        match self {
            RobotFigureError::Figure(e) => e.key(),
            RobotFigureError::Kinematics => "opw",
            RobotFigureError::Short { key, .. } => key,
            RobotFigureError::Sign { .. } => "signs",
            RobotFigureError::Limits { .. } => "limits_deg",
            RobotFigureError::Speed { .. } => "speeds_deg_s",
            RobotFigureError::MeshFacets { .. } => "links.meshes",
            RobotFigureError::MeshOff { key, .. } => key,
            RobotFigureError::Dialect { .. } => "dialect",
        }
    }
}

/// Lengths are within so many mm, to either side.
const MOST_MM: f64 = 5000.0;

impl Robot {
    /// Keys of the shipped robots.
    pub fn shipped() -> impl Iterator<Item = &'static str> {
        SHIPPED.iter().map(|(key, _)| *key)
    }

    /// Whether a name is the key of a shipped robot, and not a file.
    pub fn is_shipped(name: &str) -> bool {
        Robot::shipped().any(|key| key == name)
    }

    /// Text of the file of a shipped robot.
    pub fn shipped_text(name: &str) -> Option<&'static str> {
        SHIPPED.iter().find(|(key, _)| *key == name).map(|(_, text)| *text)
    }

    /// A shipped robot by its key, or a robot file by its path, with the files of its bodies.
    ///
    /// # Errors
    /// It is neither, or has missing or absurd figures, or one of its files cannot be read.
    pub fn load(name: &str, beside: Option<&Path>) -> Result<Robot, RobotError> {
        if let Some((key, text)) = SHIPPED.iter().find(|(key, _)| *key == name) {
            return Robot::parse(text, &format!("assets/robots/{key}.toml"), None);
        }
        let path = beside.map_or_else(|| name.into(), |folder| folder.join(name));
        if !path.is_file() {
            return Err(RobotError::Unknown { name: name.into(), shipped: Robot::shipped().collect() });
        }
        let (file, bytes) = (path.display().to_string(), file::bytes(&path)?);
        Robot::parse(file::text(&bytes, &file)?, &file, path.parent())
    }

    /// Reads a robot file's text, and the files of its bodies, which are named relative to `folder`.
    fn parse(text: &str, file: &str, folder: Option<&Path>) -> Result<Robot, RobotError> {
        let mut robot: Robot = file::toml(text, file)?;
        robot.links.meshes.load(folder, file)?;
        robot.check().map_err(|what| {
            let (table, key) = (if robot.opw.is_some() { "opw" } else { "ur" }, what.key());
            // Keys of the arm are told without their table, which is the only one of its kind.
            let found = line_of(text, &way_of(key)).or_else(|| line_of(text, &[Step::Key(table), Step::Key(key)]));
            RobotError::Figure { file: file.into(), line: found, what: Box::new(what) }
        })?;
        Ok(robot)
    }

    fn check(&self) -> Result<(), RobotFigureError> {
        self.check_lengths()?;
        self.check_joints()?;
        let l = &self.links;
        ranges(&[
            ("acceleration_s", self.acceleration_s, 0.01, 10.0),
            ("links.base_mm", l.base_mm, 0.0, 1000.0),
            ("links.shoulder_mm", l.shoulder_mm, 0.0, 1000.0),
            ("links.upper_arm_mm", l.upper_arm_mm, 0.0, 1000.0),
            ("links.forearm_mm", l.forearm_mm, 0.0, 1000.0),
            ("links.wrist_mm", l.wrist_mm, 0.0, 1000.0),
        ])?;
        self.check_meshes()
    }

    /// The lengths, and how the joints of a model are counted.
    fn check_lengths(&self) -> Result<(), RobotFigureError> {
        let lengths: Vec<(&str, f64)> = match (&self.opw, &self.ur) {
            (Some(opw), None) => opw.lengths().to_vec(),
            (None, Some(ur)) => ur.lengths().to_vec(),
            _ => return Err(RobotFigureError::Kinematics),
        };
        let bounded: Vec<_> = lengths.iter().map(|&(key, mm)| (key, mm, -MOST_MM, MOST_MM)).collect();
        ranges(&bounded)?;
        // Lengths of a `[ur]` are negative where the maker prints them so.
        let arm = match (&self.opw, &self.ur) {
            (Some(opw), _) => vec![("c2_mm", opw.c2_mm, 10.0), ("c3_mm", opw.c3_mm, 10.0)],
            (None, Some(ur)) => {
                vec![("a2_mm", ur.a2_mm.abs(), 10.0), ("a3_mm", ur.a3_mm.abs(), 10.0), ("d6_mm", ur.d6_mm.abs(), 1.0)]
            }
            (None, None) => Vec::new(),
        };
        if let Some(&(key, value_mm, least_mm)) = arm.iter().find(|(_, mm, least_mm)| mm < least_mm) {
            return Err(RobotFigureError::Short { key, value_mm, least_mm });
        }
        if let Some(opw) = &self.opw {
            if let Some(&value) = opw.signs.iter().find(|s| s.abs() != 1.0) {
                return Err(RobotFigureError::Sign { value });
            }
            let offsets: Vec<_> = opw.offsets_deg.iter().map(|&deg| ("offsets_deg", deg, -360.0, 360.0)).collect();
            ranges(&offsets)?;
        }
        Ok(())
    }

    /// Range and full speed of each joint.
    fn check_joints(&self) -> Result<(), RobotFigureError> {
        let (low, high) = (1.0, 5000.0);
        for (i, (&range_deg, &value)) in self.limits_deg.iter().zip(&self.speeds_deg_s).enumerate() {
            let joint = i + 1;
            let [least, most] = range_deg;
            if !(least < most && least >= -3600.0 && most <= 3600.0) {
                return Err(RobotFigureError::Limits { joint, range_deg });
            }
            if !(low..=high).contains(&value) {
                return Err(RobotFigureError::Speed { joint, value, low, high });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn absurd_and_missing_figures_are_named() {
        let (_, text) = SHIPPED[0];
        let refused =
            |from: &str, to: &str| Robot::parse(&text.replace(from, to), "my.toml", None).expect_err("refused");
        let figure = |from: &str, to: &str| match refused(from, to) {
            RobotError::Figure { file, what, .. } if file == "my.toml" => *what,
            other => panic!("{other}"),
        };
        let RobotError::File(FileError::Toml { source, .. }) = refused("c2_mm = 260.0\n", "") else { panic!("read") };
        assert!(source.to_string().contains("c2_mm"), "{source}");
        let short = RobotFigureError::Short { key: "c2_mm", value_mm: 0.26, least_mm: 10.0 };
        assert_eq!(figure("c2_mm = 260.0", "c2_mm = 0.26"), short);
        let range_deg = [170.0, -170.0];
        assert_eq!(figure("[-170.0, 170.0]", "[170.0, -170.0]"), RobotFigureError::Limits { joint: 1, range_deg });
        let still = RobotFigureError::Speed { joint: 6, value: 0.0, low: 1.0, high: 5000.0 };
        assert_eq!(figure("900.0]", "0.0]"), still);
        let RobotFigureError::Figure(FigureError::Range { key, .. }) = figure("wrist_mm = ", "wrist_mm = -") else {
            panic!("a range")
        };
        assert_eq!(key, "links.wrist_mm");
        let RobotError::Unknown { name, shipped } = Robot::load("puma560", None).expect_err("none") else {
            panic!("there is none")
        };
        assert!(name == "puma560" && shipped.contains(&"mz04"), "{shipped:?}");
    }
}
