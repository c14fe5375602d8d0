//! Parts found again, by parts made for it: what they share.

mod changed;
mod edits;
mod moved;
mod order;

use super::{FoundAgain, Landmarks, LoadedAs, LostEdit, LostReason, find};
use crate::part::{Part, Placement, SurfaceEdit, SurfaceRule, Surfaces, Units};
use crate::progress::Progress;
use crate::sample::solids::{PlateFeature, plate};
use crate::sample::{Triangles, stl_bytes};
use nalgebra::{Isometry3, Point3};
use std::collections::{BTreeMap, BTreeSet};

const RULE: SurfaceRule = SurfaceRule { angle_deg: 20.0, min_area_mm2: 0.0, hysteresis_deg: 0.0 };
const NOWHERE: Placement = Placement { scale: 1.0, rotation_deg: [0.0; 3], translation_mm: [0.0; 3] };
const AS_IS: LoadedAs = LoadedAs { units: Units::Mm, placement: &NOWHERE, flipped_shells: &[] };

fn loaded(triangles: &Triangles, how: &LoadedAs) -> Part {
    Part::from_bytes(&stl_bytes(triangles), how.units, how.placement, how.flipped_shells).expect("a part")
}

fn surfaces(part: &Part, edits: &[SurfaceEdit]) -> Surfaces {
    Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &RULE, edits, &[])
}

/// The numbers of all surfaces.
fn all(part: &Part, edits: &[SurfaceEdit]) -> BTreeSet<u32> {
    surfaces(part, edits).list.iter().map(|s| s.number).collect()
}

/// Looks for what is remembered, to the end.
fn look_for(
    landmarks: &Landmarks,
    part: &Part,
    how: &LoadedAs,
    rule: &SurfaceRule,
    edits: &[SurfaceEdit],
    needed: &BTreeSet<u32>,
) -> FoundAgain {
    find(landmarks, part, how, rule, (edits, needed), &Progress::default()).expect("nobody ends it")
}

/// Remembers `old` and looks for these surfaces in `new`, both as they stand in the file.
fn sought(old: &Triangles, new: &Triangles, edits: &[SurfaceEdit], needed: &BTreeSet<u32>) -> FoundAgain {
    let landmarks = Landmarks::new(&loaded(old, &AS_IS), &AS_IS, &RULE, edits, needed);
    look_for(&landmarks, &loaded(new, &AS_IS), &AS_IS, &RULE, edits, needed)
}

/// Looks for all surfaces of one part on another.
fn sought_all(old: &Triangles, new: &Triangles, edits: &[SurfaceEdit]) -> FoundAgain {
    sought(old, new, edits, &all(&loaded(old, &AS_IS), edits))
}

/// The facets of each surface as triangles of the file, whichever corner comes first.
fn facet_sets(part: &Part, edits: &[SurfaceEdit]) -> BTreeMap<u32, BTreeSet<[[u32; 3]; 3]>> {
    let bits = |p: Point3<f64>| [p.x, p.y, p.z].map(|x| (x as f32 + 0.0).to_bits());
    let triangle = |f: u32| {
        let mut corners = part.mesh.corners(f as usize).map(bits);
        corners.sort_unstable();
        corners
    };
    let list = surfaces(part, edits).list;
    list.iter().map(|s| (s.number, s.facets.iter().map(|&f| triangle(f)).collect())).collect()
}

/// Another order of facets, and other corners first: the same from the same seed.
fn shuffled(triangles: &Triangles, seed: u64) -> Triangles {
    let mut state = seed.wrapping_mul(2).wrapping_add(1);
    let mut below = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % n
    };
    let mut new = triangles.clone();
    for i in (1..new.len()).rev() {
        new.swap(i, below(i + 1));
    }
    for t in &mut new {
        t.rotate_left(below(3));
    }
    new
}

/// The file with all its corners moved.
fn moved(triangles: &Triangles, motion: &Isometry3<f64>) -> Triangles {
    triangles.iter().map(|t| t.map(|p| (motion * Point3::from(p)).into())).collect()
}

const fn hole(centre: [f64; 2], diameter: f64, sides: usize) -> PlateFeature {
    PlateFeature { centre, diameter, sides, height: 0.0 }
}

const fn boss(centre: [f64; 2], diameter: f64, sides: usize, height: f64) -> PlateFeature {
    PlateFeature { centre, diameter, sides, height }
}

/// A plate with two equal holes, two others and a boss, nothing of it symmetric. Surfaces: 1 bottom,
/// 2 top, 3 to 6 sides, 7 and 8 the equal holes, 9 and 10 the others, 11 and 12 the boss.
fn bracket(sides: usize) -> Triangles {
    plate([100.0, 80.0, 12.0], &bracket_features(sides))
}

fn bracket_features(sides: usize) -> [PlateFeature; 5] {
    [
        hole([15.0, 12.0], 8.0, sides),
        hole([82.0, 14.0], 8.0, sides),
        hole([22.0, 61.0], 11.0, sides),
        hole([48.0, 37.0], 20.0, sides),
        boss([78.0, 58.0], 17.0, sides, 9.0),
    ]
}
