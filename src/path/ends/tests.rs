//! Rims, insets and run-overs in closed form and against brute force. No timing: that is for benches.

use super::*;
use crate::part::SurfaceRule;
use crate::part::distance::point_segment;
use crate::part::merge_tree::{MergeTree, dihedral_angles};
use crate::part::raw_part::RawFacet;
use crate::part::surfaces::{Surface, Surfaces};
use crate::part::{Mesh, angle::between_deg};
use crate::path::normals::VertexNormals;
use crate::path::section::{SectionPoint, TransversalLine, sections};
use crate::sample::{Triangles, solids};
use nalgebra::{Point3, Vector3};
use proptest::prelude::*;
use std::f64::consts::PI;

struct Cutting {
    mesh: Mesh,
    surfaces: Surfaces,
}

impl Cutting {
    fn new(triangles: &Triangles) -> Cutting {
        let raw: Vec<RawFacet> = triangles.iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect();
        let mesh = Mesh::weld(&raw, 1.0);
        let dihedral = dihedral_angles(&mesh);
        let tree = MergeTree::new(&mesh, &dihedral);
        // Creases below 15° stay within a surface.
        let rule = SurfaceRule { angle_deg: 15.0, min_area_mm2: 0.0, hysteresis_deg: 0.0 };
        let surfaces = Surfaces::new(&mesh, &tree, &dihedral, &rule, &[], &[]);
        Cutting { mesh, surfaces }
    }

    /// The surface that looks along a direction and lies highest along it.
    fn facing(&self, n: Vector3<f64>) -> &Surface {
        let lies = |s: &&Surface| self.mesh.centroid(s.facets[0] as usize).coords.dot(&n);
        let looks = |s: &&Surface| between_deg(&self.mesh.normals[s.facets[0] as usize], &n) < 1e-3;
        self.surfaces.list.iter().filter(looks).max_by(|a, b| lies(a).total_cmp(&lies(b))).expect("a surface")
    }

    fn cut(
        &self,
        surface: &Surface,
        normals: &VertexNormals,
        m: Vector3<f64>,
        heights: &[f64],
    ) -> Vec<TransversalLine> {
        sections(&self.mesh, surface, normals, &m, heights, 1e-6 * self.mesh.diagonal())
    }

    fn lines(&self, surface: &Surface, m: Vector3<f64>, heights: &[f64]) -> Vec<TransversalLine> {
        self.cut(surface, &VertexNormals::new(&self.mesh, &self.surfaces, surface), m, heights)
    }

    fn over(&self, surface: &Surface, over_mm: f64, m: Vector3<f64>, heights: &[f64]) -> (Vec<TransversalLine>, usize) {
        let extended = extended(&self.mesh, surface, over_mm);
        let normals = VertexNormals::extended(&self.mesh, &self.surfaces, surface, &extended.beyond);
        run_over(&self.mesh, surface, &extended, self.cut(&extended.surface, &normals, m, heights))
    }
}

/// Lengths of lines, from the shortest.
fn lengths(lines: &[TransversalLine]) -> Vec<f64> {
    let mut all: Vec<f64> = lines.iter().map(TransversalLine::length_mm).collect();
    all.sort_by(f64::total_cmp);
    all
}

#[track_caller]
fn near(found: &[f64], expected: &[f64]) {
    let same = found.len() == expected.len() && found.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-6);
    assert!(same, "{found:?} instead of {expected:?}");
}

/// A flat ring about the origin, or a disc where `inner` is 0.
fn ring(inner: f64, outer: f64, sides: usize) -> Triangles {
    let at = |r: f64, i: usize| {
        let a = (i % sides) as f64 / sides as f64 * 2.0 * PI;
        [r * libm::cos(a), r * libm::sin(a), 0.0]
    };
    let mut out = Vec::new();
    for i in 0..sides {
        out.push([at(inner, i), at(outer, i), at(outer, i + 1)]);
        if inner > 0.0 {
            out.push([at(inner, i), at(outer, i + 1), at(inner, i + 1)]);
        }
    }
    out
}

/// Strips along y, 10 mm long: so wide each, after a bend downwards by so many degrees.
fn roof(strips: &[(f64, f64)]) -> Triangles {
    let (mut at, mut slope_deg, mut out) = ([0.0, 0.0], 0.0f64, Vec::new());
    for (bend_deg, width) in strips {
        slope_deg += bend_deg;
        let to = [at[0] + width * libm::cos(slope_deg.to_radians()), at[1] - width * libm::sin(slope_deg.to_radians())];
        let p = |q: [f64; 2], y: f64| [q[0], y, q[1]];
        out.push([p(at, 0.0), p(to, 0.0), p(to, 10.0)]);
        out.push([p(at, 0.0), p(to, 10.0), p(at, 10.0)]);
        at = to;
    }
    out
}

#[test]
fn outlines_and_holes_are_told_apart() {
    let plate = Cutting::new(&solids::blind_hole(40.0, 5.0, 10.0, 48));
    let around = |s: &Surface| -> Vec<(f64, f64)> {
        rim(&plate.mesh, s).loops.iter().map(|l| (l.length_mm, l.turning_deg)).collect()
    };
    let top = rim(&plate.mesh, plate.facing(Vector3::z()));
    let hole_mm = 48.0 * 2.0 * 5.0 * libm::sin(PI / 48.0);
    let mut loops: Vec<(f64, f64, bool)> =
        top.loops.iter().map(|l| (l.length_mm, l.turning_deg, l.is_hole())).collect();
    loops.sort_by(|a, b| a.0.total_cmp(&b.0));
    near(&loops.iter().flat_map(|l| [l.0, l.1]).collect::<Vec<_>>(), &[hole_mm, -360.0, 160.0, 360.0].map(|x: f64| x));
    assert_eq!((loops[0].2, loops[1].2), (true, false));
    assert_eq!(top.segments(0.0).count(), 52);
    assert_eq!(top.segments(10.1).count(), 4, "the hole of 10 mm does not count");
    // The hole's wall has two rims, neither of them a hole.
    let wall = plate.surfaces.list.iter().find(|s| s.facets.len() == 96).expect("the wall");
    let rims = around(wall);
    assert_eq!(rims.len(), 2);
    assert!(rims.iter().all(|r| r.1.abs() < 1e-6), "{rims:?}");
    // A closed surface has no rim.
    let ball = Cutting::new(&solids::sphere(10.0, 48, 24));
    assert!(rim(&ball.mesh, &ball.surfaces.list[0]).loops.is_empty());
}

#[test]
fn slits_of_facets_without_area_are_no_rim() {
    // In the middle of a square one triangle beside two that meet its side half way, and a facet without area.
    let (a, b, half) = ([-2.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0; 3]);
    let [left, down, right, up] =
        [[-8.0, 0.0], [0.0, -8.0], [8.0, 0.0], [0.0, 8.0]].map(|p: [f64; 2]| [p[0], p[1], 0.0]);
    let above = [[a, b, up], [a, up, left], [b, right, up]];
    let below = [[a, down, half], [half, down, b], [a, left, down], [b, down, right], [a, half, b]];
    let square = Cutting::new(&[above.to_vec(), below.to_vec()].concat());
    let whole = Surface { number: 1, facets: (0..8).collect(), area_mm2: 128.0 };
    let found = rim(&square.mesh, &whole);
    assert_eq!(found.loops.iter().map(|l| l.edges.len()).collect::<Vec<_>>(), [4]);
    assert!((found.loops[0].turning_deg - 360.0).abs() < 1e-9);
}

#[test]
fn lines_keep_off_the_rim_of_a_plate() {
    let plate = Cutting::new(&solids::cube(20.0));
    let top = plate.facing(Vector3::z());
    let lines = plate.lines(top, Vector3::y(), &[0.5, 2.0, 10.0, 18.5]);
    let kept = inset(&plate.mesh, top, lines.clone(), 1.5, 0.0);
    // The first is nearer to the rim all along.
    near(&lengths(&kept), &[17.0, 17.0, 17.0]);
    assert!(kept.iter().all(|l| !l.closed && l.points.iter().all(|q| q.p.x > 1.5 - 1e-6 && q.p.x < 18.5 + 1e-6)));
    assert_eq!(inset(&plate.mesh, top, kept.clone(), 1.0, 0.0), kept, "what is far enough stays as it is");
    assert!(inset(&plate.mesh, top, lines, 10.5, 0.0).is_empty());
}

#[test]
fn lines_keep_off_the_rim_of_a_disc() {
    // A hexadecagon's inset is a hexadecagon with an apothem less by the inset.
    let sides = 16;
    let disc = Cutting::new(&ring(0.0, 10.0, sides));
    let surface = &disc.surfaces.list[0];
    let heights = [-7.0, -0.5, 3.0, 8.0];
    let kept = inset(&disc.mesh, surface, disc.lines(surface, Vector3::y(), &heights), 2.0, 0.0);
    let apothem = 10.0 * libm::cos(PI / sides as f64) - 2.0;
    let half = |y: f64| {
        let side = |k: usize| {
            let a = (2 * k + 1) as f64 * PI / sides as f64;
            if libm::cos(a) > 1e-9 { (apothem - y * libm::sin(a)) / libm::cos(a) } else { f64::INFINITY }
        };
        (0..sides).map(side).fold(f64::INFINITY, f64::min)
    };
    let mut expected: Vec<f64> = [-7.0, -0.5, 3.0].iter().map(|y| 2.0 * half(*y)).collect();
    expected.sort_by(f64::total_cmp);
    let found = lengths(&kept);
    assert!(
        found.iter().zip(&expected).all(|(f, e)| (f - e).abs() < 1e-5) && found.len() == 3,
        "{found:?} {expected:?}"
    );
}

#[test]
fn holes_are_kept_off_or_passed_over() {
    let plate = Cutting::new(&solids::blind_hole(40.0, 5.0, 10.0, 48));
    let top = plate.facing(Vector3::z());
    let lines = plate.lines(top, Vector3::y(), &[0.0, 12.0]);
    assert_eq!(lines.len(), 3);
    // The middle line meets the hole at corners of it.
    let kept = inset(&plate.mesh, top, lines.clone(), 1.0, 0.0);
    near(&lengths(&kept), &[13.0, 13.0, 38.0]);
    let kept = inset(&plate.mesh, top, lines.clone(), 1.0, 10.1);
    near(&lengths(&kept), &[14.0, 14.0, 38.0]);

    assert_eq!(joined(kept.clone(), 9.9), kept, "too wide a gap");
    let one = joined(kept, 10.1);
    near(&lengths(&one), &[28.0, 38.0]);
    let bridged = one.iter().find(|l| !l.dark.is_empty()).expect("a line with a gap");
    let pieces: Vec<_> = bridged.pieces().collect();
    assert_eq!(pieces.len(), 2);
    let ends = [pieces[0][pieces[0].len() - 1].p.x, pieces[1][0].p.x];
    near(&[ends[0].abs(), ends[1].abs(), (ends[1] - ends[0]).abs()], &[5.0, 5.0, 10.0]);

    let (long, short) = without_short(one, 30.0);
    near(&lengths(&long), &[38.0]);
    assert_eq!(short.count, 1);
    near(&[short.length_mm], &[28.0]);
}

#[test]
fn a_closed_line_that_is_cut_is_open() {
    // A wall of a cylinder with a line round it that comes near the rims nowhere, and one that does.
    let tube = Cutting::new(&solids::cylinder(10.0, 20.0, 64));
    let wall = tube.surfaces.list.iter().find(|s| s.facets.len() == 128).expect("the wall");
    let slanted = Vector3::new(0.6, 0.0, 0.8);
    let lines = tube.lines(wall, slanted, &[8.0]);
    assert!(lines.len() == 1 && lines[0].closed);
    let whole = inset(&tube.mesh, wall, lines.clone(), 1.0, 0.0);
    assert_eq!(whole, lines);
    // z = 10 − 0.75 x: from 2.5 at x = 10 to 17.5; an inset of 4 cuts it at z = 4 and 16, where x = ±8.
    let kept = inset(&tube.mesh, wall, lines, 4.0, 0.0);
    assert!(kept.len() == 2 && kept.iter().all(|l| !l.closed), "{kept:?}");
    for end in kept.iter().flat_map(|l| [l.points[0].p, l.points[l.points.len() - 1].p]) {
        // Beside the wall's facets the rim is no straight line: the distance of space, to 1e-6 on the rim's polygon.
        let off =
            rim(&tube.mesh, wall).segments(0.0).map(|[a, b]| point_segment(&end, &a, &b)).fold(f64::INFINITY, f64::min);
        assert!((off - 4.0).abs() < 1e-6, "{off}");
    }
    let joint = joined(kept, 50.0);
    assert_eq!(joint.len(), 2, "pieces that do not face each other stay");
}

#[test]
fn the_spot_stops_at_a_sharp_edge() {
    let cube = Cutting::new(&solids::cube(20.0));
    let top = cube.facing(Vector3::z());
    let (lines, stopped) = cube.over(top, 3.0, Vector3::y(), &[5.0, 10.0]);
    near(&lengths(&lines), &[20.0, 20.0]);
    assert_eq!(stopped, 4);
    assert!(extended(&cube.mesh, top, 3.0).beyond.is_empty());
    // And where the part ends.
    let sheet = Cutting::new(&roof(&[(0.0, 8.0)]));
    assert_eq!(sheet.over(&sheet.surfaces.list[0], 1.0, Vector3::y(), &[5.0]).1, 2);
}

#[test]
fn the_spot_runs_on_over_a_shallow_ridge() {
    // Ten strips of 1 mm behind the bend of 20°; so it goes from facet to facet.
    let mut strips = vec![(0.0, 10.0), (20.0, 1.0)];
    strips.extend([(0.0, 1.0); 9]);
    let house = Cutting::new(&roof(&strips));
    assert_eq!(house.surfaces.list.len(), 2);
    let flat = house.facing(Vector3::z());
    let own = house.lines(flat, Vector3::y(), &[4.0]);
    let (lines, stopped) = house.over(flat, 3.3, Vector3::y(), &[4.0]);
    // On by 3.3 mm on one side; on the other the part ends.
    near(&lengths(&lines), &[13.3]);
    assert_eq!(stopped, 1);
    // Along the line, on the flat all is as it was; behind the ridge the normal is the slope's from one facet on.
    assert!(own[0].points.iter().all(|q| lines[0].points.contains(q)));
    let slope = Vector3::new(libm::sin(20f64.to_radians()), 0.0, libm::cos(20f64.to_radians()));
    for q in &lines[0].points {
        let beyond_mm = (q.p.x - 10.0) / libm::cos(20f64.to_radians());
        let n = if beyond_mm > 0.99 { slope } else { Vector3::z() };
        assert!((0.01..0.99).contains(&beyond_mm) || (q.n - n).norm() < 1e-6, "{q:?}");
    }
    // A second bend of 20° is gone over as well, one of 65° ends it.
    let twice = Cutting::new(&roof(&[(0.0, 10.0), (20.0, 1.0), (20.0, 5.0)]));
    let (lines, _) = twice.over(twice.facing(Vector3::z()), 2.0, Vector3::y(), &[4.0]);
    // From the rim: 1 mm, then x at the angle of 20° to it: the law of cosines gives a distance of 2 mm in all.
    let c = libm::cos(20f64.to_radians());
    near(&lengths(&lines), &[10.0 + 1.0 - c + (c * c + 3.0).sqrt()]);
    let sharp = Cutting::new(&roof(&[(0.0, 10.0), (20.0, 1.0), (65.0, 5.0)]));
    let (lines, stopped) = sharp.over(sharp.facing(Vector3::z()), 2.0, Vector3::y(), &[4.0]);
    near(&lengths(&lines), &[11.0]);
    assert_eq!(stopped, 2);
}

#[test]
fn between_two_surfaces_the_spot_stays_near_its_own() {
    // A valley strip between two slopes: each slope's line reaches into the strip by 1.5 mm of its 4.
    let house = Cutting::new(&roof(&[(0.0, 10.0), (20.0, 4.0), (-20.0, 10.0)]));
    let (first, _) = house.over(&house.surfaces.list[0], 1.5, Vector3::y(), &[4.0]);
    near(&lengths(&first), &[11.5]);
    let (strip, stopped) = house.over(&house.surfaces.list[1], 1.5, Vector3::y(), &[4.0]);
    near(&lengths(&strip), &[7.0]);
    assert_eq!(stopped, 0);
}

#[test]
fn pieces_are_joined_in_their_sense_only() {
    let piece = |from: [f64; 2], to: [f64; 2], plane: usize| {
        let q = |p: [f64; 2]| SectionPoint { p: Point3::new(p[0], p[1], 0.0), n: Vector3::z() };
        TransversalLine { plane, points: vec![q(from), q(to)], closed: false, dark: Vec::new() }
    };
    // Three in a row, told in another order; one beside them; one of another plane; one at an angle of 11°.
    let (sine, cosine) = (libm::sin(11f64.to_radians()), libm::cos(11f64.to_radians()));
    let lines = vec![
        piece([6.0, 0.0], [9.0, 0.0], 0),
        piece([0.0, 0.0], [3.0, 0.0], 0),
        piece([4.0, 1.0], [7.0, 1.0], 0),
        piece([10.0, 0.0], [12.0, 0.0], 0),
        piece([3.5, 0.0], [5.0, 0.0], 1),
        piece([12.5, 0.0], [12.5 + cosine, sine], 0),
    ];
    let found = joined(lines.clone(), 3.5);
    let told: Vec<_> = found.iter().map(|l| (l.points.len(), l.dark.clone())).collect();
    assert_eq!(told, [(6, vec![2, 4]), (2, vec![]), (2, vec![]), (2, vec![])]);
    near(&[found[0].length_mm()], &[8.0]);
    // Joined again nothing changes; what is apart by nothing is joined by 0 mm.
    assert_eq!(joined(found.clone(), 3.5), found);
    let touching = vec![piece([0.0, 0.0], [3.0, 0.0], 0), piece([3.0, 0.0], [5.0, 0.0], 0)];
    assert_eq!(joined(touching, 0.0).len(), 1);
}

proptest! {
    /// What is kept is far enough, and what is far enough is kept.
    #[test]
    fn an_inset_keeps_what_is_far_enough(angle in 0.0..PI, height in -25.0..25.0f64, off_mm in 0.1..8.0f64, sides in 3..40usize) {
        let plate = Cutting::new(&solids::blind_hole(40.0, 7.0, 10.0, sides));
        let top = plate.facing(Vector3::z());
        let lines = plate.lines(top, Vector3::new(libm::cos(angle), libm::sin(angle), 0.0), &[height]);
        let outline: Vec<_> = rim(&plate.mesh, top).segments(0.0).collect();
        let away = |p: &Point3<f64>| outline.iter().map(|[a, b]| point_segment(p, a, b)).fold(f64::INFINITY, f64::min);
        let kept = inset(&plate.mesh, top, lines.clone(), off_mm, 0.0);
        let places = |lines: &[TransversalLine]| -> Vec<Point3<f64>> {
            let share = |(a, b): (SectionPoint, SectionPoint)| (0..=20).map(move |i| a.p + (b.p - a.p) * (f64::from(i) / 20.0));
            lines.iter().flat_map(|l| l.sides().flat_map(share).collect::<Vec<_>>()).collect()
        };
        for p in places(&kept) {
            prop_assert!(away(&p) > off_mm - 1e-6, "{p} at {}", away(&p));
        }
        let on_kept = |p: &Point3<f64>| kept.iter().flat_map(|l| l.sides()).any(|(a, b)| point_segment(p, &a.p, &b.p) < 1e-6);
        for p in places(&lines) {
            prop_assert!(away(&p) < off_mm + 1e-5 || on_kept(&p), "{p} at {}", away(&p));
        }
    }
}

#[test]
fn a_turned_surface_is_run_over_on_its_own_side() {
    let mut house = Cutting::new(&roof(&[(0.0, 10.0), (20.0, 4.0)]));
    // The flat is worked from below, the slope from above.
    for f in [0, 1] {
        house.surfaces.normals[f] = -house.surfaces.normals[f];
    }
    let flat = house.facing(Vector3::z());
    let (lines, _) = house.over(flat, 2.0, Vector3::y(), &[4.0]);
    near(&lengths(&lines), &[12.0]);
    assert!(lines[0].points.iter().all(|q| q.n.z < 0.0));
}
