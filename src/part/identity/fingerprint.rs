//! The fingerprint of a surface or a shell, and how a job file writes it: one array each.
//!
//! All in the file's coordinates and unit. Nothing here depends on the order of facets, but for
//! rounding.

use nalgebra::{Point3, Similarity3, Vector3};
use serde::{Deserialize, Serialize};

/// The kind of a surface; a shell is one of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum FormWord {
    Plane,
    Cylinder,
    Cone,
    Sphere,
    Freeform,
    Shell,
}

/// The fingerprint of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fingerprint {
    pub area: f64,
    pub centroid: Point3<f64>,
    /// Sum of the facets' normals by area, over the area: of length 1 only for a plane.
    pub mean_normal: Vector3<f64>,
    pub form: FormWord,
    /// Diameter; of a cone half its angle in degrees; of a shell the edge of the cube of its volume,
    /// below 0 for a void; else 0.
    pub size: f64,
    /// How many surfaces share an edge with it, and their area.
    pub neighbours: u32,
    pub neighbour_area: f64,
}

impl Fingerprint {
    /// The fingerprint after a motion with a scale.
    pub(super) fn moved(&self, new_from_old: &Similarity3<f64>) -> Fingerprint {
        let scale = new_from_old.scaling();
        Fingerprint {
            area: self.area * scale * scale,
            centroid: new_from_old.transform_point(&self.centroid),
            mean_normal: new_from_old.isometry.rotation * self.mean_normal,
            size: if self.form == FormWord::Cone { self.size } else { self.size * scale },
            neighbour_area: self.neighbour_area * scale * scale,
            ..*self
        }
    }
}

/// A numbered surface or shell.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "LandmarkRow", into = "LandmarkRow")]
pub(super) struct Landmark {
    pub number: u32,
    pub print: Fingerprint,
}

/// Number, area, centroid, mean normal, word, size, neighbours, their area.
type LandmarkRow = (u32, f64, [f64; 3], [f64; 3], FormWord, f64, u32, f64);

impl From<LandmarkRow> for Landmark {
    fn from((number, area, centroid, normal, form, size, neighbours, neighbour_area): LandmarkRow) -> Landmark {
        let (centroid, mean_normal) = (Point3::from(centroid), Vector3::from(normal));
        let print = Fingerprint { area, centroid, mean_normal, form, size, neighbours, neighbour_area };
        Landmark { number, print }
    }
}

impl From<Landmark> for LandmarkRow {
    fn from(Landmark { number, print: p }: Landmark) -> LandmarkRow {
        let centroid = p.centroid.coords.map(short).into();
        // Of a unit: what lies below is noise.
        let normal = p.mean_normal.map(|x| (x * 1e9).round() / 1e9 + 0.0).into();
        (number, short(p.area), centroid, normal, p.form, short(p.size), p.neighbours, short(p.neighbour_area))
    }
}

/// Ten digits: a thousand times finer than f32, and finer than any tolerance here.
pub(super) fn short(x: f64) -> f64 {
    format!("{x:.9e}").parse().unwrap_or(x)
}
