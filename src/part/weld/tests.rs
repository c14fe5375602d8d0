//! Cracks a rounding wide close and gaps stay, whatever the order of facets; nothing folds.

use super::{Weld, Welded};
use crate::part::Mesh;
use crate::part::orient::orient;
use crate::part::raw_part::RawFacet;
use crate::part::topology::FacetDefect;
use crate::sample::{SAMPLES, Triangles, solids};
use proptest::prelude::*;
use std::collections::BTreeSet;

fn raw(triangles: &Triangles) -> Vec<RawFacet> {
    triangles.iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect()
}

/// Every coordinate of every corner by itself one step of f32 up or down, or left alone.
fn shaken(facets: &[RawFacet], mut seed: u64) -> Vec<RawFacet> {
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        seed >> 33
    };
    let mut step = |x: f32| match next() % 3 {
        0 => x.next_up(),
        1 => x.next_down(),
        _ => x,
    };
    facets.iter().map(|f| f.map(|p| p.map(&mut step))).collect()
}

fn open_edges(welded: &Welded) -> usize {
    (0..welded.edges.ends.len() as u32).filter(|&e| welded.edges.facets.of(e).len() == 1).count()
}

fn auto(facets: &[RawFacet]) -> Welded {
    Welded::new(facets, Weld::Auto)
}

/// A square sheet of half the width `half`, with a slot of 40 % of that along x, `width` wide. Its lips have their
/// vertices face to face, or, where they are `staggered`, between each other; at its ends it has an edge across, or,
/// where it is `pointed`, one vertex.
fn slotted(half: f64, width: f64, pointed: bool, staggered: bool) -> Vec<RawFacet> {
    let lip = |y: f64, shift: f64| -> Vec<[f64; 2]> {
        let end = if pointed { 0.0 } else { y };
        let inner = (1..8).map(|i| [half * (0.1 * f64::from(i) - 0.4 + shift), y]);
        std::iter::once([-0.4 * half, end]).chain(inner).chain([[0.4 * half, end]]).collect()
    };
    let mut flat: Vec<[[f64; 2]; 3]> = Vec::new();
    for (side, shift) in [(1.0, 0.0), (-1.0, if staggered { 0.04 } else { 0.0 })] {
        let mut line = vec![[-half, 0.0]];
        line.extend(lip(0.5 * width * side, shift));
        line.push([half, 0.0]);
        let top = [0.0, side * half];
        flat.extend(line.windows(2).map(|w| if side > 0.0 { [w[0], w[1], top] } else { [w[1], w[0], top] }));
        flat.extend([-half, half].map(|x| {
            let corner = [x, side * half];
            if x * side > 0.0 { [[x, 0.0], corner, top] } else { [[x, 0.0], top, corner] }
        }));
    }
    if !pointed {
        for x in [-1.0, 1.0] {
            let [low, high] = [-0.5, 0.5].map(|y| [0.4 * half * x, y * width]);
            let end = [half * x, 0.0];
            flat.push(if x > 0.0 { [low, end, high] } else { [high, end, low] });
        }
    }
    flat.iter().map(|f| f.map(|[x, y]| [x as f32, y as f32, 0.0])).collect()
}

#[test]
fn a_slot_wider_than_a_rounding_stays() {
    for (pointed, staggered) in [(false, false), (true, false), (false, true), (true, true)] {
        let facets = slotted(500.0, 0.01, pointed, staggered);
        let exact = Welded::new(&facets, Weld::Exact);
        let welded = auto(&facets);
        assert_eq!((welded.joined.corners, &welded.facets), (0, &exact.facets), "{pointed} {staggered}");
    }
}

#[test]
fn a_slot_narrower_than_a_rounding_of_its_part_stays_where_an_edge_tells_it() {
    // 20 m: the tolerance is 0.028 mm.
    for (pointed, staggered) in [(false, false), (false, true), (true, true)] {
        assert_eq!(auto(&slotted(1e4, 0.01, pointed, staggered)).joined.corners, 0, "{pointed} {staggered}");
    }
    // A crack: the lips are edge on edge, and one vertex at either end.
    let crack = auto(&slotted(1e4, 0.01, true, false));
    assert_eq!((crack.joined.corners, open_edges(&crack)), (7, 8));
    assert!((crack.joined.within - 0.01).abs() < 1e-6);
}

#[test]
fn corners_half_a_millimetre_apart_stay() {
    let mut facets = raw(&solids::cube(1000.0));
    facets[3][1][0] += 0.5;
    assert_eq!(auto(&facets).joined.corners, 0);
    // Four steps of f32 at 1000 mm are less than a millionth of the diagonal, 0.0017 mm.
    let mut near = raw(&solids::cube(1000.0));
    near[3][1][0] += 0.0015;
    let welded = auto(&near);
    assert_eq!((welded.joined.corners, open_edges(&welded)), (1, 0));
}

#[test]
fn what_equal_coordinates_close_stays_as_it_is() {
    for sample in SAMPLES {
        let facets = raw(&(sample.triangles)());
        let (one, other) = (auto(&facets), Welded::new(&facets, Weld::Exact));
        assert_eq!((one.points, one.facets, one.joined.corners), (other.points, other.facets, 0), "{}", sample.name);
    }
}

#[test]
fn zeros_with_noise_are_one_corner() {
    let mut facets = raw(&solids::cylinder(20.0, 50.0, 48));
    let noisy = |(i, x): (usize, f32)| if x.abs() < 1e-12 { [1e-17, -1e-17, 0.0][i % 3] } else { x };
    for f in &mut facets {
        let noise: Vec<f32> = f.as_flattened().iter().copied().enumerate().map(noisy).collect();
        f.as_flattened_mut().copy_from_slice(&noise);
    }
    let welded = auto(&facets);
    assert_eq!((welded.points.len(), open_edges(&welded)), (96, 0));
    assert!(welded.joined.within < 1e-16);
}

#[test]
fn the_sides_of_a_sheet_are_not_joined_at_its_rim() {
    let front: Vec<RawFacet> = slotted(50.0, 20.0, true, false);
    // 50 nm apart, where 140 nm are a rounding.
    let back = front.iter().map(|f| f.map(|[x, y, z]| [x, y, z - 5e-5])).map(|[a, b, c]| [b, a, c]);
    let facets: Vec<RawFacet> = front.iter().copied().chain(back).collect();
    let mut mesh = Mesh::from_welded(auto(&facets), 1.0);
    let orientation = orient(&mut mesh);
    assert_eq!((orientation.shells, orientation.flipped_facets), (2, 0));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Corners whose last digits differ by facet make the same mesh as equal ones, whichever facet comes first and
    /// whichever is wound wrongly.
    #[test]
    fn last_digits_do_not_matter(seed in any::<u64>(), first in 0..500usize, turned in 0..500usize, which in 0..4usize) {
        let solid = [solids::cylinder(20.0, 50.0, 48), solids::sphere(25.0, 16, 9), solids::torus(30.0, 9.0, 14, 8),
                     solids::helical_gear(8, 1, 2, 2)];
        let mut facets = raw(&solid[which]);
        let count = facets.len();
        facets.rotate_left(first % count);
        facets[turned % count].swap(1, 2);
        let clean = Welded::new(&facets, Weld::Exact);
        let welded = auto(&shaken(&facets, seed));
        prop_assert_eq!(&welded.facets, &clean.facets);
        prop_assert_eq!(welded.points.len(), clean.points.len());
        let mut mesh = Mesh::from_welded(welded, 1.0);
        let orientation = orient(&mut mesh);
        prop_assert!(orientation.watertight && orientation.flipped_facets == 1);
    }

    /// However corners lie, nothing that had an area loses it or looks elsewhere, and what is open becomes less.
    #[test]
    fn nothing_folds(at in prop::collection::vec(prop::array::uniform3(0..5i32), 12..60), seed in any::<u64>()) {
        // Corners on a grid of little more than the tolerance, in a part of 1 m.
        let corner = |p: &[i32; 3]| p.map(|k| 500.0 + 0.0008 * k as f32);
        let mut facets: Vec<RawFacet> = at.chunks_exact(3).map(|c| [corner(&c[0]), corner(&c[1]), corner(&c[2])]).collect();
        facets.extend(at.chunks_exact(2).map(|c| [corner(&c[0]), corner(&c[1]), [0.0, (seed % 1000) as f32, 1000.0]]));
        facets.extend(at.chunks_exact(2).map(|c| [corner(&c[0]), [0.0, (seed % 1000) as f32, 1000.0], [1000.0, 0.0, 0.0]]));
        let (exact, welded) = (Welded::new(&facets, Weld::Exact), auto(&facets));
        prop_assert!(open_edges(&welded) <= open_edges(&exact));
        let (before, after) = (Mesh::from_welded(exact, 1.0), Mesh::from_welded(welded, 1.0));
        let different = |mesh: &Mesh| {
            let sorted = mesh.facets.iter().map(|f| {
                let mut corners = *f;
                corners.sort_unstable();
                corners
            });
            sorted.filter(|c| c[0] != c[1] && c[1] != c[2]).collect::<BTreeSet<_>>().len()
        };
        prop_assert_eq!(different(&before), different(&after));
        for f in (0..facets.len()).filter(|&f| before.defects[f] != FacetDefect::Degenerate) {
            prop_assert!(after.defects[f] != FacetDefect::Degenerate);
            prop_assert!(before.normals[f].dot(&after.normals[f]) >= 0.5);
        }
    }
}
