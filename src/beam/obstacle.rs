//! A body of facets that stands somewhere: a clamp on the part, a fixture or a fence in the cell.
//!
//! The frame that its place refers to is that of the list it stands in.

use crate::part::{Hasher, Keyed, LoadError, Part, Placement, Source, Units, Weld, rpy};
use crate::progress::Progress;
use nalgebra::{Isometry3, Translation3, UnitQuaternion};
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::sync::Arc;

/// The facets of an obstacle where they stand, prepared for queries at many poses.
#[derive(Clone, Copy, Debug)]
pub struct Standing<'a> {
    /// Its facets, in the frame of its file.
    pub solid: &'a Part,
    /// Where that frame stands, in the frame of the list that the obstacle is in.
    pub at: Isometry3<f64>,
    /// Whether it is space that was not scanned, and no body that is known.
    pub is_unscanned: bool,
}

/// A file of facets, as a part's is, and where it stands.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Obstacle {
    /// The file (STL, OBJ, PLY or 3MF), relative to the file that names it.
    pub file: String,
    /// Origin of the file, mm.
    #[serde(default)]
    pub position_mm: [f64; 3],
    /// Rotation about Z, Y and X, degrees.
    #[serde(default)]
    pub rz_ry_rx_deg: [f64; 3],
    /// Unit of the file.
    #[serde(default)]
    pub units: Units,
    /// Whether it is one of the cell that is seen in the part's frame.
    #[serde(skip)]
    is_of_cell: bool,
    /// Whether it is space that was not scanned, which has no file.
    #[serde(skip)]
    is_unscanned: bool,
    /// What the file held.
    #[serde(skip)]
    solid: Arc<Part>,
}

impl PartialEq for Obstacle {
    fn eq(&self, other: &Obstacle) -> bool {
        let told = |o: &Obstacle| (o.position_mm, o.rz_ry_rx_deg, o.units, o.is_of_cell, o.solid.digest);
        self.file == other.file && told(self) == told(other)
    }
}

impl Keyed for Obstacle {
    fn feed(&self, into: &mut Hasher) {
        let Obstacle { file, position_mm, rz_ry_rx_deg, units, is_of_cell: _, is_unscanned: _, solid } = self;
        file.feed(into);
        position_mm.feed(into);
        rz_ry_rx_deg.feed(into);
        units.feed(into);
        solid.digest.feed(into);
    }
}

impl Obstacle {
    /// An obstacle at the origin whose file is still to be read.
    pub fn named(file: String) -> Obstacle {
        Obstacle {
            file,
            position_mm: [0.0; 3],
            rz_ry_rx_deg: [0.0; 3],
            units: Units::default(),
            is_of_cell: false,
            is_unscanned: false,
            solid: Arc::default(),
        }
    }

    /// Space beside a part that was not scanned, within these facets of the part frame: nobody knows what is there.
    pub fn unscanned(solid: Part) -> Obstacle {
        Obstacle { is_unscanned: true, solid: Arc::new(solid), ..Obstacle::named(String::new()) }
    }

    /// An obstacle at the origin, in the unit that its file states; the file is still to be read where it is named.
    pub fn of_file(named: String, file: &Path) -> Obstacle {
        let units = Source::read(file).map_or_else(|_| Units::default(), |source| source.units());
        Obstacle { units, ..Obstacle::named(named) }
    }

    /// Its facets in the frame of its file, mm; none until they are read.
    pub fn solid(&self) -> &Part {
        &self.solid
    }

    /// Where it stands.
    pub fn at(&self) -> Isometry3<f64> {
        let turn = UnitQuaternion::from_rotation_matrix(&rpy::to_rotation(self.rz_ry_rx_deg));
        Isometry3::from_parts(Translation3::from(self.position_mm), turn)
    }

    /// Its facets where they stand.
    pub fn standing(&self) -> Standing<'_> {
        Standing { solid: &self.solid, at: self.at(), is_unscanned: self.is_unscanned }
    }

    /// Whether it is space that was not scanned.
    pub fn is_unscanned(&self) -> bool {
        self.is_unscanned
    }

    /// Whether it is an obstacle of the cell that stands among a job's clamps: see [`Self::seen_in`].
    pub fn is_of_cell(&self) -> bool {
        self.is_of_cell
    }

    /// An obstacle of the cell expressed in another frame; `frame_from_its` maps its present frame to that one.
    pub fn seen_in(&self, frame_from_its: &Isometry3<f64>) -> Obstacle {
        let at = frame_from_its * self.at();
        let rz_ry_rx_deg = rpy::from_rotation(&at.rotation.to_rotation_matrix());
        Obstacle { position_mm: at.translation.vector.into(), rz_ry_rx_deg, is_of_cell: true, ..self.clone() }
    }

    /// Reads its file, which is named relative to `folder`.
    ///
    /// # Errors
    /// The file cannot be read, holds no facets, or states another unit; it is named.
    pub fn load(&mut self, folder: Option<&Path>) -> Result<(), LoadError> {
        let file = folder.map_or_else(|| self.file.clone().into(), |f| f.join(&self.file));
        let name = || file.display().to_string();
        let source = Source::read(&file)?;
        if let Some(stated) = source.raw.stated_unit.filter(|s| s.taken() != self.units) {
            return Err(LoadError::OtherUnit { file: name(), stated, units: self.units });
        }
        let made = source.part(self.units, Weld::Exact, &Placement::default(), &[], &Progress::default());
        let part = made.map_err(|source| LoadError::Unusable { file: name(), source })?;
        // It cannot have been cancelled: nobody else holds this progress.
        self.solid = Arc::new(part.unwrap_or_default());
        Ok(())
    }
}
