//! What stands in the cell beside robot and part: the head, the table, fixtures.
//!
//! Read from the cell file; what may touch what is told in `collision`.

use super::cell_error::CellError;
use super::check::{FigureError, ranges};
use crate::beam::Obstacle;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The `[bodies]` table of a cell file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Bodies {
    /// The laser head, from the nozzle up.
    pub head: Vec<HeadCapsule>,
    /// Everything below this height in the robot's base is table or floor, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub table_z_mm: Option<f64>,
    /// Fixtures, fences, pedestals.
    pub obstacles: Vec<Obstacle>,
    /// Distance that everything keeps, mm.
    pub margin_mm: f64,
}

impl Default for Bodies {
    fn default() -> Self {
        Bodies { head: Vec::new(), table_z_mm: None, obstacles: Vec::new(), margin_mm: 5.0 }
    }
}

/// A piece of the head: all within a radius of a stretch of the beam's axis, round ends included.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeadCapsule {
    /// Where the stretch begins, mm from the focus against the light.
    pub from_mm: f64,
    /// Where the stretch ends, mm.
    pub to_mm: f64,
    /// Radius, mm.
    pub radius_mm: f64,
}

impl Bodies {
    /// Reads the obstacles' files, which are named relative to `folder`.
    ///
    /// # Errors
    /// A file cannot be read or holds no facets; the file is named.
    pub fn load(&mut self, folder: Option<&Path>) -> Result<(), CellError> {
        self.obstacles.iter_mut().try_for_each(|o| o.load(folder)).map_err(CellError::Obstacle)
    }

    /// Whether each body can stand where it is.
    ///
    /// # Errors
    /// The first figure that makes no sense.
    pub fn check(&self) -> Result<(), FigureError> {
        for h in &self.head {
            let HeadCapsule { from_mm, to_mm, radius_mm } = *h;
            if !(from_mm <= to_mm && from_mm >= -1000.0 && to_mm <= 10_000.0) {
                return Err(FigureError::HeadPiece { from_mm, to_mm });
            }
            if !(radius_mm > 0.0 && radius_mm <= 2000.0) {
                return Err(FigureError::NotPositive { key: "bodies.head.radius_mm", value: radius_mm, high: 2000.0 });
            }
        }
        ranges(&[("bodies.table_z_mm", self.table_z_mm.unwrap_or(0.0), -10_000.0, 10_000.0)])?;
        if let Some(o) =
            self.obstacles.iter().find(|o| !o.position_mm.iter().chain(&o.rz_ry_rx_deg).all(|x| x.is_finite()))
        {
            return Err(FigureError::Obstacle { file: o.file.clone() });
        }
        ranges(&[("bodies.margin_mm", self.margin_mm, 0.5, 200.0)])
    }
}
