//! What stands in the cell beside robot and part: the head, the table, fixtures.
//!
//! Read from the cell file; what may touch what is told in `collision`.

use super::frame::Frame;
use super::mounting::CellError;
use crate::part::{self, Part, Placement, Units};
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::sync::Arc;

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
    /// Where it ends.
    pub to_mm: f64,
    /// Radius, mm.
    pub radius_mm: f64,
}

/// A body of facets that stands in the robot's base frame.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Obstacle {
    /// STL file, relative to the cell file.
    pub file: String,
    /// Origin of the file in the base, mm.
    #[serde(default)]
    pub position_mm: [f64; 3],
    /// Rotation about Z, Y and X, degrees.
    #[serde(default)]
    pub rz_ry_rx_deg: [f64; 3],
    /// Unit of the file.
    #[serde(default)]
    pub units: Units,
    /// What the file held.
    #[serde(skip)]
    solid: Arc<Part>,
}

impl PartialEq for Obstacle {
    fn eq(&self, other: &Obstacle) -> bool {
        let told = |o: &Obstacle| (o.position_mm, o.rz_ry_rx_deg, o.units, o.solid.digest);
        self.file == other.file && told(self) == told(other)
    }
}

impl Obstacle {
    /// Its facets in the frame of its file, mm; none until they are read.
    pub fn solid(&self) -> &Part {
        &self.solid
    }

    /// Where it stands in the robot's base.
    pub fn frame(&self) -> Frame {
        Frame::new(self.position_mm, self.rz_ry_rx_deg)
    }
}

impl Bodies {
    /// Reads the obstacles' files, which are named relative to `folder`.
    ///
    /// # Errors
    /// A file cannot be read or is no STL; the file is named.
    pub fn load(&mut self, folder: Option<&Path>) -> Result<(), CellError> {
        for o in &mut self.obstacles {
            let file = folder.map_or_else(|| o.file.clone().into(), |f| f.join(&o.file));
            let solid = part::load(&file, o.units, &Placement::default(), &[]).map_err(CellError::Obstacle)?;
            o.solid = Arc::new(solid);
        }
        Ok(())
    }

    /// # Errors
    /// Which figure makes no sense, and what it may be.
    pub fn check(&self) -> Result<(), String> {
        for h in &self.head {
            let HeadCapsule { from_mm, to_mm, radius_mm } = *h;
            if !(from_mm <= to_mm && from_mm >= -1000.0 && to_mm <= 10_000.0) {
                return Err(format!(
                    "bodies.head from_mm = {from_mm}, to_mm = {to_mm}: give mm from the focus against the light, \
                     the lower first"
                ));
            }
            if !(radius_mm > 0.0 && radius_mm <= 2000.0) {
                return Err(format!("bodies.head radius_mm = {radius_mm}: give more than 0, up to 2000"));
            }
        }
        if let Some(z) = self.table_z_mm.filter(|z| !(-10_000.0..=10_000.0).contains(z)) {
            return Err(format!("bodies.table_z_mm = {z}: give mm in the robot's base, within ±10000"));
        }
        if let Some(o) =
            self.obstacles.iter().find(|o| !o.position_mm.iter().chain(&o.rz_ry_rx_deg).all(|x| x.is_finite()))
        {
            return Err(format!("bodies.obstacles: {} stands at no number", o.file));
        }
        if !(0.5..=200.0).contains(&self.margin_mm) {
            return Err(format!("bodies.margin_mm = {}: give 0.5 to 200", self.margin_mm));
        }
        Ok(())
    }
}
