//! A file of markers: places that several scans show, or that the tip of the robot's tool has touched.
//!
//! ```toml
//! [[marker]]
//! name = "A"                       # the same name: the same marker
//! scan = "left.ply"                # in which scan; may be left out where there is one
//! scan_mm = [12.5, 40.0, -3.1]     # where it is, in the frame of that scan
//! base_mm = [812.4, -120.0, 310.2] # where the robot touched it; may be left out
//! ```
//!
//! What follows from them (scans in one frame, the scan in the robot's base) is for others; here they are read.

use super::merging::Marker;
use crate::file::{self, FileError};
use nalgebra::Point3;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A marker as one scan shows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SeenMarker {
    /// Its name.
    pub name: String,
    /// The scan's file; empty: of the only one.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub scan: String,
    /// Where it is in the frame of the scan, mm.
    pub scan_mm: [f64; 3],
    /// Where the robot touched it in its base, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base_mm: Option<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MarkerText {
    marker: Vec<SeenMarker>,
}

/// Reads the markers of a file.
///
/// # Errors
/// It cannot be read, or a marker is not as above; with file, line and key.
pub fn read(path: &Path) -> Result<Vec<SeenMarker>, FileError> {
    let name = path.display().to_string();
    let bytes = file::bytes(path)?;
    Ok(file::toml::<MarkerText>(file::text(&bytes, &name)?, &name)?.marker)
}

/// The markers of one scan, by the file that it came in. A marker that names no scan is of the only one.
pub fn of_scan<'a>(markers: &'a [SeenMarker], scan: &Path, is_only: bool) -> impl Iterator<Item = &'a SeenMarker> {
    let name = scan.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    markers.iter().filter(move |m| {
        if m.scan.is_empty() { is_only } else { Path::new(&m.scan).file_name().is_some_and(|n| *n == *name) }
    })
}

/// The markers that a scan shares with another one, by their names.
pub fn shared(markers: &[SeenMarker], scan: &Path, common: &Path) -> Vec<Marker> {
    let in_common: Vec<&SeenMarker> = of_scan(markers, common, false).collect();
    let pair = |m: &SeenMarker| {
        let other = in_common.iter().find(|o| o.name == m.name)?;
        Some(Marker { in_scan: Point3::from(m.scan_mm), in_common: Point3::from(other.scan_mm) })
    };
    of_scan(markers, scan, false).filter_map(pair).collect()
}

/// The markers of a scan that the robot has touched, with their names: its base is the common frame.
pub fn touched(markers: &[SeenMarker], scan: &Path, is_only: bool) -> Vec<(String, Marker)> {
    let touched = |m: &SeenMarker| {
        let in_common = Point3::from(m.base_mm?);
        Some((m.name.clone(), Marker { in_scan: Point3::from(m.scan_mm), in_common }))
    };
    of_scan(markers, scan, is_only).filter_map(touched).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markers_are_those_of_their_scan() {
        let text = "[[marker]]\nname = \"A\"\nscan = \"in/left.ply\"\nscan_mm = [1, 2, 3]\nbase_mm = [4, 5, 6]\n\
                    [[marker]]\nname = \"B\"\nscan_mm = [7, 8, 9]\n";
        let markers = file::toml::<MarkerText>(text, "markers.toml").expect("reads").marker;
        let names = |scan: &str, is_only| -> Vec<&str> {
            of_scan(&markers, Path::new(scan), is_only).map(|m| m.name.as_str()).collect()
        };
        assert_eq!(names("left.ply", true), ["A", "B"]);
        assert_eq!(names("left.ply", false), ["A"]);
        assert_eq!(names("right.ply", true), ["B"]);
        let touched = touched(&markers, Path::new("left.ply"), true);
        assert_eq!(touched.len(), 1, "B was not touched");
        assert_eq!((touched[0].0.as_str(), touched[0].1.in_common), ("A", Point3::new(4.0, 5.0, 6.0)));
    }
}
