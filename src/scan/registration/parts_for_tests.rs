//! Parts for the tests of registration, and points measured on them.

use super::field::Field;
use crate::part::{Part, Placement, Units};
use crate::progress::Progress;
use crate::sample::scan_maker::{ScanRecipe, made_scan};
use crate::sample::{Triangles, stl_bytes};
use crate::scan::Cloud;
use nalgebra::{Isometry3, Point3};

pub(super) fn part_of(triangles: &Triangles) -> Part {
    Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part")
}

/// The field around a part.
pub(super) fn field_of(part: &Part) -> Field {
    let closest = |at: &Point3<f64>, within: f64| part.bvh.closest(at, within).map(|c| c.foot);
    Field::new(part.mesh.bounds(), closest, &Progress::default()).expect("not cancelled")
}

/// A scan of a part, and where it truly lies.
pub(super) fn scan(part: &Part, recipe: &ScanRecipe<'_>) -> (Cloud, Isometry3<f64>) {
    let facets: Triangles =
        (0..part.mesh.facets.len()).map(|f| part.mesh.corners(f).map(|p| [p.x, p.y, p.z])).collect();
    let made = made_scan(&facets, recipe);
    (Cloud::of_points(&made.points), made.model_from_scan)
}

/// The greatest way that a corner of the part's box goes from one pose to the other, mm.
pub(super) fn off_mm(part: &Part, found: &Isometry3<f64>, truth: &Isometry3<f64>) -> f64 {
    let (lo, hi) = part.mesh.bounds();
    let corner = |i: usize| Point3::from([0, 1, 2].map(|k| if i >> k & 1 == 0 { lo[k] } else { hi[k] }));
    let between = found * truth.inverse();
    (0..8).map(|i| (between * corner(i) - corner(i)).norm()).fold(0.0, f64::max)
}
