//! From the part frame back to the file's own coordinates, in the file's unit.

use crate::part::{Placement, Units};
use nalgebra::{Isometry3, Point3, Vector3};

/// How a part was read from its file: what [`crate::part::Part::from_bytes`] was given beside the bytes.
#[derive(Clone, Copy, Debug)]
pub struct LoadedAs<'a> {
    /// Unit of the file's coordinates.
    pub units: Units,
    /// Where the part stands.
    pub placement: &'a Placement,
    /// Shells that were turned inside out, by number.
    pub flipped_shells: &'a [u32],
}

/// The map back to the file. Rounding aside it undoes unit and placement.
#[derive(Clone, Debug)]
pub(super) struct FileFrame {
    unplaced: Isometry3<f64>,
    mm_per_unit: f64,
}

impl FileFrame {
    pub(super) fn new(loaded: &LoadedAs) -> FileFrame {
        let p = loaded.placement;
        FileFrame { unplaced: p.isometry().inverse(), mm_per_unit: loaded.units.mm() * p.scale }
    }

    /// A point of the part frame, mm, in the file.
    pub(super) fn point(&self, p: &Point3<f64>) -> Point3<f64> {
        (self.unplaced * p) / self.mm_per_unit
    }

    /// A direction, or a sum of such.
    pub(super) fn direction(&self, v: &Vector3<f64>) -> Vector3<f64> {
        self.unplaced.rotation * v
    }

    /// A length in the file's unit.
    pub(super) fn length(&self, mm: f64) -> f64 {
        mm / self.mm_per_unit
    }

    /// An area in the file's unit squared.
    pub(super) fn area(&self, mm2: f64) -> f64 {
        mm2 / (self.mm_per_unit * self.mm_per_unit)
    }
}
