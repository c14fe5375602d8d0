//! Patches as surfaces: areas in closed form, numbers that stay, parts that stay watertight, layers.

use crate::part::patched::{LayersError, Lowered, PatchLayer, ScannedShape, after_layers, fills, shaped};
use crate::part::surfaces::Surface;
use crate::part::topology::FacetDefect;
use crate::part::{
    Part, PatchCut, PatchedPart, Placement, RefinedFacets, SurfaceRule, Surfaces, Units, patch_layers, with_patches,
};
use crate::progress::Progress;
use crate::sample::{Triangles, solids, stl_bytes};
use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::PI;

const THRESHOLD_MM: f64 = 0.05;

/// Depth and radius of the wear of METHODS: `h·(1 − (r/R)²)²`.
const WEAR_MM: f64 = 0.2;
const WEAR_RADIUS_MM: f64 = 3.0;

fn wear(from_centre_mm: f64) -> f64 {
    let share = 1.0 - (from_centre_mm / WEAR_RADIUS_MM).min(1.0).powi(2);
    WEAR_MM * share * share
}

/// Area of a round patch on a plane above the threshold: `π·R²·(1 − √(t/h))`.
fn worn_mm2() -> f64 {
    PI * WEAR_RADIUS_MM * WEAR_RADIUS_MM * (1.0 - (THRESHOLD_MM / WEAR_MM).sqrt())
}

/// Where the wear is as deep as the threshold: `R·√(1 − √(t/h))`.
pub(super) fn rim_mm() -> f64 {
    WEAR_RADIUS_MM * (1.0 - (THRESHOLD_MM / WEAR_MM).sqrt()).sqrt()
}

struct Refined {
    vertices: Vec<Point3<f64>>,
    triangles: Vec<[u32; 3]>,
    parent: Vec<u32>,
}

/// Bisects edges longer than a cell, the longest first, in the triangles that some point says, and in all that share
/// them; facets that stay whole are left out.
fn refined(part: &Part, cell_mm: f64, is_near: impl Fn(&[Point3<f64>; 3]) -> bool) -> Refined {
    let mesh = &part.mesh;
    let mut vertices = mesh.vertices.clone();
    let mut all: Vec<([u32; 3], u32)> = mesh.facets.iter().copied().zip(0..).collect();
    loop {
        let mut longest: Option<(f64, [u32; 2])> = None;
        for (t, _) in &all {
            let corners = t.map(|v| vertices[v as usize]);
            for k in 0..3 {
                let length = (corners[(k + 1) % 3] - corners[k]).norm();
                let edge = [t[k].min(t[(k + 1) % 3]), t[k].max(t[(k + 1) % 3])];
                let is_longer = longest.is_none_or(|(l, e)| length > l || length == l && edge < e);
                if length > cell_mm && is_longer && is_near(&corners) {
                    longest = Some((length, edge));
                }
            }
        }
        let Some((_, [a, b])) = longest else { break };
        let middle = vertices.len() as u32;
        vertices.push(nalgebra::center(&vertices[a as usize], &vertices[b as usize]));
        all = all
            .into_iter()
            .flat_map(|(t, f)| {
                let k = (0..3).find(|&k| [a, b].contains(&t[k]) && [a, b].contains(&t[(k + 1) % 3]));
                let halves = k.map_or(vec![t], |k| {
                    let [p, q, r] = [t[k], t[(k + 1) % 3], t[(k + 2) % 3]];
                    vec![[p, middle, r], [middle, q, r]]
                });
                halves.into_iter().map(move |t| (t, f))
            })
            .collect();
    }
    all.retain(|(t, f)| *t != mesh.facets[*f as usize]);
    let (triangles, parent) = all.into_iter().unzip();
    Refined { vertices, triangles, parent }
}

fn near(centre: Point3<f64>, radius_mm: f64) -> impl Fn(&[Point3<f64>; 3]) -> bool {
    move |corners| crate::part::distance::point_triangle(&centre, corners) < radius_mm
}

/// All triangles in one patch.
fn one_patch(part: &Part, surfaces: &Surfaces, r: &Refined, depth: impl Fn(&Point3<f64>) -> f64) -> PatchedPart {
    let depth_mm: Vec<f64> = r.vertices.iter().map(depth).collect();
    let refined =
        RefinedFacets { vertices: &r.vertices, triangles: &r.triangles, parent: &r.parent, depth_mm: &depth_mm };
    let cut =
        PatchCut { above_mm: THRESHOLD_MM, levels_mm: &[], triangles: &[(0..r.triangles.len() as u32).collect()] };
    with_patches(part, surfaces, &refined, &cut, &Progress::default()).expect("nobody cancels")
}

fn made(triangles: &Triangles) -> (Part, Surfaces) {
    let part = Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part");
    let rule = SurfaceRule { angle_deg: 20.0, min_area_mm2: 0.0, hysteresis_deg: 0.0 };
    let surfaces = Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &rule, &[], &[]);
    (part, surfaces)
}

fn area_mm2(list: &[Surface]) -> f64 {
    list.iter().map(|s| s.area_mm2).sum()
}

/// What holds for every part with patches.
fn check(part: &Part, surfaces: &Surfaces, patched: &PatchedPart) {
    let (mesh, made) = (&patched.part.mesh, &patched.surfaces);
    assert!(patched.part.orientation.watertight);
    assert_eq!(mesh.defects.iter().filter(|d| **d != FacetDefect::None).count(), 0);
    assert_eq!(mesh.vertices[..part.mesh.vertices.len()], part.mesh.vertices);
    let total = area_mm2(&surfaces.list);
    assert!((area_mm2(&made.list) - total).abs() < 1e-9 * total);
    assert!(patched.parent.is_sorted());
    for (f, &p) in patched.parent.iter().enumerate() {
        let off = (made.normals[f] - surfaces.normals[p as usize]).norm();
        assert!(off < 1e-6, "facet {f} lies in the plane of {p}, off by {off}");
    }
    // What a surface has lost is in the patches that were cut out of it.
    let mut cut: BTreeMap<u32, f64> = BTreeMap::new();
    for piece in patched.patches.iter().flatten() {
        *cut.entry(piece.cut_from.0).or_default() += piece.area_mm2;
        assert!(piece.surface.0 > surfaces.last_number && piece.surface.0 <= made.last_number);
        assert_eq!(made.get(piece.surface.0).map(|s| s.area_mm2), Some(piece.area_mm2));
    }
    for s in &surfaces.list {
        let left = made.get(s.number).map_or(0.0, |s| s.area_mm2);
        let gone = cut.get(&s.number).copied().unwrap_or_default();
        assert!((left + gone - s.area_mm2).abs() < 1e-9 * total, "surface {}: {left} and {gone}", s.number);
    }
}

fn facing(part: &Part, surfaces: &Surfaces, way: Vector3<f64>) -> u32 {
    let is_so = |s: &&Surface| (part.mesh.normals[s.facets[0] as usize] - way).norm() < 1e-9;
    surfaces.list.iter().find(is_so).expect("a face").number
}

#[test]
fn a_round_patch_on_a_face_has_its_area_and_leaves_the_rest() {
    let worn = Worn::new(0.4);
    let patched = worn.patched();
    let (Worn { part, surfaces, refined: r, .. }, centre) = (&worn, Worn::CENTRE);
    check(part, surfaces, &patched);
    let [piece] = patched.patches[0][..] else { panic!("{:?}", patched.patches) };
    assert_eq!((piece.surface.0, piece.cut_from.0), (7, facing(part, surfaces, Vector3::z())));
    assert!((piece.area_mm2 / worn_mm2() - 1.0).abs() < 0.01, "{} of {}", piece.area_mm2, worn_mm2());
    let outside = surfaces.get(7).is_none() && patched.surfaces.ids().count() == 7;
    assert!(outside, "one surface more");
    // Facets that were not refined are the same, in the same order.
    let whole: Vec<usize> = (0..12).filter(|&f| !r.parent.contains(&(f as u32))).collect();
    assert!(whole.len() > 4);
    for f in whole {
        let now = patched.parent.binary_search(&(f as u32)).expect("there");
        assert_eq!(patched.part.mesh.facets[now], part.mesh.facets[f]);
        assert_eq!(patched.part.mesh.normals[now], part.mesh.normals[f]);
    }
    // The rim of the patch is where the wear is as deep as the threshold.
    let rim_mm = rim_mm();
    let mesh = &patched.part.mesh;
    let mut ends = 0;
    for e in 0..mesh.edges.len() as u32 {
        let inside = mesh.edge_facets(e).iter().filter(|&&f| patched.surfaces.of_facet[f as usize] == 7).count();
        if inside == 1 {
            for v in mesh.edges[e as usize] {
                let off = (mesh.vertices[v as usize] - centre).norm() - rim_mm;
                assert!(off.abs() < 0.03, "{off}");
                ends += 1;
            }
        }
    }
    assert!(ends > 60);
}

#[test]
fn a_patch_over_an_edge_is_a_surface_on_each_side() {
    let (part, surfaces) = made(&solids::cube(10.0));
    let centre = Point3::new(5.0, 10.0, 10.0);
    let r = refined(&part, 0.4, near(centre, WEAR_RADIUS_MM));
    let patched = one_patch(&part, &surfaces, &r, |p| wear((p - centre).norm()));
    check(&part, &surfaces, &patched);
    let [one, other] = patched.patches[0][..] else { panic!("{:?}", patched.patches) };
    let mut faces = [Vector3::z(), Vector3::y()].map(|way| facing(&part, &surfaces, way));
    faces.sort_unstable();
    assert_eq!([one.cut_from.0, other.cut_from.0], faces);
    assert_eq!([one.surface.0, other.surface.0], [7, 8]);
    for piece in [one, other] {
        assert!((piece.area_mm2 / (0.5 * worn_mm2()) - 1.0).abs() < 0.01, "{piece:?}");
    }
}

#[test]
fn a_patch_that_swallows_a_face_takes_no_number_from_the_others() {
    let (part, surfaces) = made(&solids::cube(10.0));
    // 1 mm from the top down, and as much from the bottom, where the lowest facets are.
    for (way, deep) in [(Vector3::z(), (|z| z - 9.0) as fn(f64) -> f64), (-Vector3::z(), |z| 1.0 - z)] {
        let r = refined(&part, 3.0, |_| true);
        let patched = one_patch(&part, &surfaces, &r, |p| deep(p.z) + THRESHOLD_MM);
        check(&part, &surfaces, &patched);
        let swallowed = facing(&part, &surfaces, way);
        assert_eq!(patched.surfaces.get(swallowed), None);
        assert_eq!(patched.surfaces.list.len(), 5 + 5, "four sides and what was cut from them, and the face");
        for piece in &patched.patches[0] {
            let expected = if piece.cut_from.0 == swallowed { 100.0 } else { 10.0 };
            assert!((piece.area_mm2 - expected).abs() < 0.02, "{piece:?}");
        }
        for piece in patched.patches[0].iter().filter(|p| p.cut_from.0 != swallowed) {
            let left = patched.surfaces.get(piece.cut_from.0).expect("a side stays").area_mm2;
            assert!((left - 90.0).abs() < 0.02, "{left}");
        }
    }
}

#[test]
fn patches_are_numbered_in_their_order_and_others_are_left() {
    let (part, surfaces) = made(&solids::cube(20.0));
    let centres = [[4.0, 4.0, 20.0], [15.0, 4.0, 20.0], [10.0, 15.0, 20.0]].map(Point3::from);
    let r = refined(&part, 0.8, |_| false);
    assert!(r.triangles.is_empty());
    let r = refined(&part, 0.9, |c| centres.iter().any(|p| near(*p, WEAR_RADIUS_MM)(c)));
    let depth_mm: Vec<f64> = r.vertices.iter().map(|p| centres.iter().map(|c| wear((p - c).norm())).sum()).collect();
    let of = |centre: usize| -> Vec<u32> {
        let corners = |t: u32| r.triangles[t as usize].map(|v| r.vertices[v as usize]);
        (0..r.triangles.len() as u32).filter(|&t| near(centres[centre], WEAR_RADIUS_MM)(&corners(t))).collect()
    };
    let refined =
        RefinedFacets { vertices: &r.vertices, triangles: &r.triangles, parent: &r.parent, depth_mm: &depth_mm };
    let made = |triangles: &[Vec<u32>]| {
        let cut = PatchCut { above_mm: THRESHOLD_MM, levels_mm: &[], triangles };
        let patched = with_patches(&part, &surfaces, &refined, &cut, &Progress::default()).expect("not cancelled");
        check(&part, &surfaces, &patched);
        let at = |n: u32| {
            let s = patched.surfaces.get(n).expect("there");
            let sum = s.facets.iter().fold(Vector3::zeros(), |v, &f| v + patched.part.mesh.centroid(f as usize).coords);
            let middle = Point3::from(sum / s.facets.len() as f64);
            (0..3).find(|&i| (middle - centres[i]).norm() < 1.0).expect("one of them")
        };
        let found: Vec<usize> = patched.patches.iter().flatten().map(|p| at(p.surface.0)).collect();
        (found, patched.part.digest)
    };
    let (found, both) = made(&[of(2), of(0)]);
    assert_eq!(found, [2, 0]);
    let (found, other_way) = made(&[of(0), of(2)]);
    assert_eq!(found, [0, 2]);
    let (found, none) = made(&[]);
    assert!(found.is_empty());
    let digests = [both, other_way, none, part.digest];
    assert!((0..4).all(|i| digests[..i].iter().all(|d| *d != digests[i])));
}

#[test]
fn a_surface_that_is_worked_on_from_its_other_side_has_patches_there() {
    let (part, mut surfaces) = made(&solids::cube(10.0));
    surfaces.normals.iter_mut().for_each(|n| *n = -*n);
    let centre = Point3::new(5.0, 5.0, 10.0);
    let r = refined(&part, 1.0, near(centre, WEAR_RADIUS_MM));
    let patched = one_patch(&part, &surfaces, &r, |p| wear((p - centre).norm()));
    check(&part, &surfaces, &patched);
    assert!(patched.surfaces.normals.iter().zip(&patched.part.mesh.normals).all(|(a, b)| *a == -*b));
}

#[test]
fn the_beam_turns_over_pieces_as_it_did_over_their_facets() {
    // Twelve sides: their normals differ by 30°, and between two sides the normal turns evenly.
    let part = Part::from_bytes(&stl_bytes(&solids::cylinder(6.0, 8.0, 12)), Units::Mm, &Placement::default(), &[]);
    let part = part.expect("a part");
    let rule = SurfaceRule { angle_deg: 40.0, min_area_mm2: 0.0, hysteresis_deg: 0.0 };
    let surfaces = Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &rule, &[], &[]);
    assert_eq!(surfaces.list.len(), 3);
    let centre = Point3::new(6.0, 0.0, 4.0);
    let r = refined(&part, 0.7, near(centre, WEAR_RADIUS_MM));
    let patched = one_patch(&part, &surfaces, &r, |p| wear((p - centre).norm()));
    check(&part, &surfaces, &patched);
    let [patch] = patched.patches[0][..] else { panic!("{:?}", patched.patches) };
    let mut vertices: Vec<u32> = patched
        .surfaces
        .get(patch.surface.0)
        .expect("there")
        .facets
        .iter()
        .flat_map(|&f| patched.part.mesh.facets[f as usize])
        .collect();
    vertices.sort_unstable();
    vertices.dedup();
    for v in vertices {
        let p = patched.part.mesh.vertices[v as usize];
        let normal = patched.surfaces.vertex_normal(patch.surface.0, v).expect("it is on a piece");
        // Corners have radial normals, and between the corners of a chord the sum of two points in the direction of the
        // point itself: the normal is radial everywhere.
        let radial = Vector3::new(p.x, p.y, 0.0).normalize();
        assert!((normal - radial).norm() < 1e-3, "{p}: {normal}");
    }
    let untouched = part.mesh.vertices.iter().position(|v| v.x < -5.0).expect("the other side") as u32;
    assert_eq!(patched.surfaces.vertex_normal(patch.cut_from.0, untouched), None);
}

/// The round wear on a plane.
pub(super) struct Worn {
    part: Part,
    surfaces: Surfaces,
    refined: Refined,
    depth_mm: Vec<f64>,
}

impl Worn {
    pub(super) const CENTRE: Point3<f64> = Point3::new(4.3, 5.2, 10.0);

    pub(super) fn new(cell_mm: f64) -> Worn {
        let (part, surfaces) = made(&solids::cube(10.0));
        let refined = refined(&part, cell_mm, near(Worn::CENTRE, WEAR_RADIUS_MM));
        let depth_mm = refined.vertices.iter().map(|p| wear((p - Worn::CENTRE).norm())).collect();
        Worn { part, surfaces, refined, depth_mm }
    }

    /// Cut where beads of this height end as well, and to be filled with them.
    pub(super) fn filled(&self, bead_mm: f64) -> PatchedPart {
        let depth_mm: Vec<f64> = self.refined.vertices.iter().map(|p| wear((p - Worn::CENTRE).norm())).collect();
        let levels_mm: Vec<f64> = (1..).map(|k| f64::from(k) * bead_mm).take_while(|mm| *mm < WEAR_MM).collect();
        let r = &self.refined;
        let refined =
            RefinedFacets { vertices: &r.vertices, triangles: &r.triangles, parent: &r.parent, depth_mm: &depth_mm };
        let triangles = [(0..r.triangles.len() as u32).collect()];
        let cut = PatchCut { above_mm: THRESHOLD_MM, levels_mm: &levels_mm, triangles: &triangles };
        let mut made = with_patches(&self.part, &self.surfaces, &refined, &cut, &Progress::default()).expect("made");
        check(&self.part, &self.surfaces, &made);
        made.surfaces.fills = fills(&made, &[WEAR_MM], bead_mm);
        made
    }

    pub(super) fn patched(&self) -> PatchedPart {
        one_patch(&self.part, &self.surfaces, &self.refined, |p| wear((p - Worn::CENTRE).norm()))
    }

    fn layers(&self, depth_mm: f64, bead_mm: f64) -> Result<Vec<PatchLayer>, LayersError> {
        let (r, all) = (&self.refined, (0..self.refined.triangles.len() as u32).collect::<Vec<u32>>());
        let of = RefinedFacets {
            vertices: &r.vertices,
            triangles: &r.triangles,
            parent: &r.parent,
            depth_mm: &self.depth_mm,
        };
        patch_layers(&of, &all, THRESHOLD_MM, depth_mm, bead_mm, &Progress::default())
    }
}

#[test]
fn a_patch_has_as_many_layers_as_beads_fill_it_each_within_the_one_before() {
    let layers = Worn::new(0.4).layers(WEAR_MM, 0.075).expect("layers");
    let heights: Vec<f64> = layers.iter().map(|l| l.height_mm).collect();
    assert_eq!(heights.len(), 3);
    assert!((heights[0] - 0.075).abs() + (heights[1] - 0.075).abs() + (heights[2] - 0.05).abs() < 1e-12, "{heights:?}");
    for (layer, above_mm) in layers.iter().zip([THRESHOLD_MM, 0.075, 0.15]) {
        assert_eq!(layer.above_mm, above_mm);
        // A circle: its radius is where the wear is as deep as the contour.
        let radius_mm = WEAR_RADIUS_MM * (1.0 - (above_mm / WEAR_MM).sqrt()).sqrt();
        let [rim] = &layer.outlines[..] else { panic!("{} outlines", layer.outlines.len()) };
        let centre = Worn::CENTRE;
        assert!(rim.iter().all(|p| ((p - centre).norm() - radius_mm).abs() < 0.04));
        let twice_mm2: f64 =
            (0..rim.len()).map(|i| (rim[i] - centre).cross(&(rim[(i + 1) % rim.len()] - centre)).z).sum();
        assert!((0.5 * twice_mm2 - layer.area_mm2).abs() < 1e-9, "counter-clockwise, all of it within");
        assert!((layer.area_mm2 / (PI * radius_mm * radius_mm) - 1.0).abs() < 0.02);
    }
}

#[test]
fn each_layer_of_a_filled_patch_has_the_area_that_is_deeper_than_the_beads_below() {
    let patched = Worn::new(0.4).filled(0.06);
    let [fill] = &patched.surfaces.fills[..] else { panic!("{:?}", patched.surfaces.fills) };
    assert_eq!(fill.layers, 4);
    for (layers, above_mm) in [(0, THRESHOLD_MM), (1, 0.06), (2, 0.12), (3, 0.18), (4, f64::INFINITY)] {
        let left = after_layers(&patched.part.mesh, patched.surfaces.clone(), layers);
        let found_mm2 = left.get(fill.surface).map_or(0.0, |s| s.area_mm2);
        let share = (1.0 - (above_mm / WEAR_MM).min(1.0).sqrt()) * WEAR_RADIUS_MM * WEAR_RADIUS_MM;
        assert!((found_mm2 - PI * share).abs() < 0.02 * worn_mm2(), "{layers}: {found_mm2} for {}", PI * share);
        let whole = area_mm2(&left.list);
        assert!((whole - area_mm2(&patched.surfaces.list)).abs() < 1e-9 * whole, "what is filled is its surface again");
    }
}

#[test]
fn floors_go_down_by_their_depth_and_what_is_built_up_stands_out() {
    let patched = Worn::new(0.4).filled(0.06);
    let of = |raised_from_mm, lowered| {
        let shape = ScannedShape { raised_from_mm, lowered };
        shaped(&patched, &shape, &Progress::default()).expect("nobody cancels")
    };
    let (floor, surfaces) = of(THRESHOLD_MM, Lowered::Patches);
    let facets = &patched.part.mesh.facets;
    assert_eq!((floor.mesh.facets.len(), &surfaces.of_facet), (facets.len(), &patched.surfaces.of_facet));
    let patch = patched.surfaces.get(7).expect("the patch");
    let in_patch: std::collections::BTreeSet<u32> = patch.facets.iter().flat_map(|&f| facets[f as usize]).collect();
    for (v, (now, before)) in floor.mesh.vertices.iter().zip(&patched.part.mesh.vertices).enumerate() {
        let depth_mm = if in_patch.contains(&(v as u32)) { patched.depth_mm[v] } else { 0.0 };
        assert!((before - now - Vector3::z() * depth_mm).norm() < 1e-9, "{before} {now} {depth_mm}");
    }
    assert!(in_patch.len() > 50);
    assert_ne!(floor.digest, patched.part.digest);
    // Without floors nothing moves here: nothing is built up.
    let (same, _) = of(THRESHOLD_MM, Lowered::Nothing);
    assert_eq!(same.mesh.vertices, patched.part.mesh.vertices);
    // Everything: what is worn less than a patch as well.
    let (all, _) = of(THRESHOLD_MM, Lowered::All);
    for (v, (now, before)) in all.mesh.vertices.iter().zip(&patched.part.mesh.vertices).enumerate() {
        let depth_mm = if patched.depth_mm[v] > 0.0 { patched.depth_mm[v] } else { 0.0 };
        assert!((before - now - Vector3::z() * depth_mm).norm() < 1e-9, "{before} {now} {depth_mm}");
    }
    // The same depths as surplus stand out by it, from the threshold on.
    let raised = PatchedPart { depth_mm: patched.depth_mm.iter().map(|d| -d).collect(), ..patched.clone() };
    let shape = ScannedShape { raised_from_mm: THRESHOLD_MM, lowered: Lowered::Nothing };
    let (part, _) = shaped(&raised, &shape, &Progress::default()).expect("nobody cancels");
    for (v, (now, before)) in part.mesh.vertices.iter().zip(&patched.part.mesh.vertices).enumerate() {
        let height_mm = if patched.depth_mm[v] >= THRESHOLD_MM { patched.depth_mm[v] } else { 0.0 };
        assert!((now - before - Vector3::z() * height_mm).norm() < 1e-9, "{before} {now} {height_mm}");
    }
}

#[test]
fn whole_beads_are_no_bead_more_and_absurd_ones_none() {
    let worn = Worn::new(1.5);
    let count = |depth_mm: f64, bead_mm| worn.layers(depth_mm, bead_mm).map(|l| l.len());
    // 1.1 / 0.1 is 11.000000000000002 and 0.7 / 0.1 is 6.999999999999999.
    assert_eq!([count(1.1, 0.1), count(0.7, 0.1), count(0.2, 0.5), count(0.2, 0.1)], [Ok(11), Ok(7), Ok(1), Ok(2)]);
    assert_eq!(count(0.2001, 0.1), Ok(3));
    assert_eq!([count(0.0, 0.1), count(-1.0, 0.1)], [Ok(0), Ok(0)]);
    assert_eq!(count(0.2, 0.0), Err(LayersError::NoHeight { height_mm: 0.0 }));
    assert!(matches!(count(0.2, f64::NAN), Err(LayersError::NoHeight { .. })));
    assert!(matches!(count(0.2, 1e-9), Err(LayersError::TooMany { .. })));
    assert!(matches!(count(f64::NAN, 0.1), Err(LayersError::TooMany { .. })));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// Whatever the depths are, and wherever they are not known, the pieces make the same body.
    #[test]
    fn pieces_hang_together_whatever_the_depths(depths in prop::collection::vec(
        prop_oneof![4 => 0.0..0.1f64, 1 => Just(THRESHOLD_MM), 1 => Just(THRESHOLD_MM * (1.0 + 1e-9)), 1 => Just(f64::NAN)], 200)) {
        let (part, surfaces) = made(&solids::cylinder(6.0, 5.0, 7));
        let r = refined(&part, 3.0, |_| true);
        let at = |p: &Point3<f64>| depths[r.vertices.iter().position(|v| v == p).expect("a vertex") % depths.len()];
        let patched = one_patch(&part, &surfaces, &r, at);
        check(&part, &surfaces, &patched);
        // All that is deep is in the patch: as much as linear depths have it, by fine sampling of each triangle.
        let n = 40;
        let mut deep_mm2 = 0.0;
        for t in &r.triangles {
            let [a, b, c] = t.map(|v| r.vertices[v as usize]);
            let [da, db, dc] = t.map(|v| at(&r.vertices[v as usize]));
            let mut deep = 0;
            for i in 0..n {
                for j in 0..n - i {
                    let (u, v) = ((f64::from(i) + 1.0 / 3.0) / f64::from(n), (f64::from(j) + 1.0 / 3.0) / f64::from(n));
                    deep += i32::from(da + (db - da) * u + (dc - da) * v > THRESHOLD_MM);
                }
            }
            deep_mm2 += 0.5 * (b - a).cross(&(c - a)).norm() * f64::from(deep) / f64::from(n * (n + 1) / 2);
        }
        let found: f64 = patched.patches[0].iter().map(|p| p.area_mm2).sum();
        prop_assert!((found - deep_mm2).abs() < 0.01 * area_mm2(&surfaces.list), "{found} of {deep_mm2}");
    }
}
