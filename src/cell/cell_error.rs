//! Why a cell file cannot be used, as data. Sentences of it stand in `text`.

use super::check::FigureError;
use crate::file::FileError;
use crate::part::LoadError;
use thiserror::Error;

/// Why a cell file cannot be used.
#[derive(Debug, Error)]
pub enum CellError {
    /// A robot of the operator's own has no cell here.
    #[error("no shipped cell for {robot:?}")]
    NoneFor {
        /// The robot.
        robot: String,
    },
    /// It cannot be read, or is not a cell file.
    #[error(transparent)]
    File(#[from] FileError),
    /// A body of the cell cannot be read.
    #[error("obstacle: {0}")]
    Obstacle(LoadError),
    /// A figure makes no sense.
    #[error("{file}: {what}")]
    Figure {
        /// The file.
        file: String,
        /// Its line, from 1; that of the table, where the key is not there.
        line: Option<usize>,
        /// The figure, and what is wrong with it.
        what: Box<FigureError>,
    },
    /// The robot cannot stand in it.
    #[error("{cell}: {what}")]
    Place {
        /// Name of the cell.
        cell: String,
        /// Why.
        what: PlaceError,
    },
}

/// Why a robot cannot stand in a cell.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PlaceError {
    /// A stand of the program is beyond the robot's joints.
    #[error("{key}: J{joint} = {deg}, range {range_deg:?}")]
    BeyondJoint {
        /// The stand's key in the cell file.
        key: &'static str,
        /// The joint; the first is 1.
        joint: usize,
        /// Its angle there, degrees.
        deg: f64,
        /// Least and greatest angle, degrees.
        range_deg: [f64; 2],
        /// The robot's name for people.
        robot: String,
    },
    /// The table is as high as the robot's shoulder.
    #[error("table at {table_z_mm} mm")]
    HighTable {
        /// Its height in the base, mm.
        table_z_mm: f64,
    },
    /// The laser stands inside the robot's base.
    #[error("laser inside the base")]
    LaserInBase {
        /// Width of the base about axis 1, mm.
        base_mm: f64,
    },
}
