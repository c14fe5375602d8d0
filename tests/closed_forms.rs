//! Solids whose numbers are known in closed form: counts, areas, volumes, shapes, section lengths,
//! normals. Planes and targets are in `path_closed_forms.rs`.
//!
//! Round solids are inscribed polyhedra, so the forms are those of regular polygons, not of circles:
//! a ring of `m` flat sides between radii r1 and r2 is made of m trapezoids, its volume is a
//! frustum's. One sum over the profile gives cylinder, cone, sphere and torus.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::document::segmented;
use clearbeam::part::{Shape, orient};
use clearbeam::sample::{Triangles, solids};
use nalgebra::{Point3, Vector3};
use parts::{angle_deg, cut, job, length, near, part, planned, polygon};
use std::f64::consts::PI;

/// Coordinates of a file are f32.
const F32: f64 = 1e-6;

/// Area of the skin and volume of a profile (r, z), counter-clockwise seen from +y, turned about z.
fn revolved(profile: &[[f64; 2]], sides: usize) -> (f64, f64) {
    let half = PI / sides as f64;
    profile.windows(2).fold((0.0, 0.0), |(area, volume), w| {
        let ([r, z], [s, t]) = (w[0], w[1]);
        let slant = libm::hypot((s - r) * libm::cos(half), t - z);
        let (a, b) = (polygon(r, sides).1, polygon(s, sides).1);
        (
            area + 0.5 * (polygon(r, sides).0 + polygon(s, sides).0) * slant,
            volume + (t - z) * (a + b + (a * b).sqrt()) / 3.0,
        )
    })
}

fn circle(centre: [f64; 2], radius: f64, from_deg: f64, to_deg: f64, steps: usize) -> Vec<[f64; 2]> {
    let at = |k: usize| (from_deg + (to_deg - from_deg) * k as f64 / steps as f64).to_radians();
    (0..=steps).map(|k| [centre[0] + radius * libm::cos(at(k)), centre[1] + radius * libm::sin(at(k))]).collect()
}

/// Facets, vertices, surfaces at 20°, area and volume; a solid of genus g has 3F/2 edges, and
/// V − E + F = 2 − 2g.
fn is(name: &str, triangles: &Triangles, counts: (usize, usize, usize), genus: i64, size: (f64, f64)) {
    let part = part(triangles);
    let surfaces = segmented(&part, &job("z", 1.0));
    let (mesh, (facets, vertices, number)) = (&part.mesh, counts);
    assert_eq!((mesh.facets.len(), mesh.vertices.len(), surfaces.list.len()), (facets, vertices, number), "{name}");
    assert_eq!(mesh.edges.len() * 2, mesh.facets.len() * 3, "{name}");
    assert_eq!(mesh.vertices.len() as i64 - mesh.edges.len() as i64 + facets as i64, 2 - 2 * genus, "{name}");
    assert!(part.orientation.watertight && part.orientation.flipped_facets == 0, "{name}");
    near(name, surfaces.list.iter().map(|s| s.area_mm2).sum(), size.0, F32);
    near(name, orient::volume(mesh), size.1, F32);
}

#[test]
fn counts_areas_and_volumes() {
    is("cube", &solids::cube(10.0), (12, 8, 6), 0, (600.0, 1000.0));
    let profile = [[0.0, 0.0], [5.0, 0.0], [5.0, 12.0], [0.0, 12.0]];
    is("cylinder", &solids::cylinder(5.0, 12.0, 48), (4 * 48 - 4, 96, 3), 0, revolved(&profile, 48));
    let profile = [[0.0, 0.0], [6.0, 0.0], [0.0, 8.0]];
    is("cone", &solids::cone(6.0, 8.0, 90), (2 * 90 - 2, 91, 2), 0, revolved(&profile, 90));
    let profile = circle([0.0, 0.0], 10.0, -90.0, 90.0, 32);
    is("sphere", &solids::sphere(10.0, 64, 32), (2 * 64 * 31, 64 * 31 + 2, 1), 0, revolved(&profile, 64));
    let profile = circle([20.0, 0.0], 5.0, 0.0, 360.0, 40);
    is("torus", &solids::torus(20.0, 5.0, 80, 40), (2 * 80 * 40, 80 * 40, 1), 1, revolved(&profile, 80));

    let (depth, land, length) = (8.0, 6.0, 40.0);
    let (half, flank) = (depth * libm::tan(PI / 6.0), depth / libm::cos(PI / 6.0));
    let (width, height) = (2.0 * (half + land), depth + 5.0);
    let section = width * height - half * depth;
    let girth = width + 2.0 * height + 2.0 * land + 2.0 * flank;
    let size = (2.0 * section + girth * length, section * length);
    is("groove", &solids::v_groove(30.0, depth, land, length), (24, 14, 9), 0, size);

    let (round, hole) = polygon(5.0, 64);
    let size = (6.0 * 900.0 + round * 12.0, 27_000.0 - hole * 12.0);
    is("hole", &solids::blind_hole(30.0, 5.0, 12.0, 64), (4 * 64 + 12, 8 + 2 * 64, 8), 0, size);

    let (n, thick, gap, height, length, base) = (3.0, 2.0, 4.0, 15.0, 50.0, 7.0);
    let width = n * thick + (n - 1.0) * gap;
    let section = width * base + n * thick * height;
    let girth = 2.0 * width + 2.0 * base + 2.0 * n * height;
    let size = (2.0 * section + girth * length, section * length);
    is("fins", &solids::fin_row(3, thick, gap, height, length, base), (16 * 3 - 4, 8 * 3, 4 * 3 + 2), 0, size);
}

fn shape(triangles: &Triangles, at: [f64; 3]) -> Shape {
    let part = part(triangles);
    let surfaces = segmented(&part, &job("z", 1.0));
    Shape::of(&part.mesh, surfaces.get(parts::surface_at(&part, &surfaces, at)).expect("there"))
}

fn is_on_axis(p: &Point3<f64>, axis: &Vector3<f64>) -> bool {
    p.coords.cross(&Vector3::z()).norm() < 1e-4 && axis.cross(&Vector3::z()).norm() < 1e-5
}

#[test]
fn shapes_have_their_names_and_sizes() {
    for (triangles, radius, z) in
        [(solids::cylinder(5.0, 12.0, 48), 5.0, 6.0), (solids::blind_hole(30.0, 7.0, 12.0, 64), 7.0, -6.0)]
    {
        let Shape::Cylinder { diameter_mm, centre, axis } = shape(&triangles, [radius, 0.0, z]) else {
            panic!("a cylinder")
        };
        assert!((diameter_mm - 2.0 * radius).abs() < 1e-4 && is_on_axis(&centre, &axis), "{diameter_mm} {centre}");
    }
    let Shape::Sphere { diameter_mm, centre } = shape(&solids::sphere(10.0, 64, 32), [0.0, 0.0, 10.0]) else {
        panic!("a sphere")
    };
    assert!((diameter_mm - 20.0).abs() < 1e-4 && centre.coords.norm() < 1e-4);
    assert_eq!(shape(&solids::torus(20.0, 5.0, 80, 40), [25.0, 0.0, 0.0]), Shape::Freeform);
    for (at, normal) in [([5.0, 5.0, 10.0], Vector3::z()), ([0.0, 5.0, 5.0], -Vector3::x())] {
        let Shape::Plane { normal: found } = shape(&solids::cube(10.0), at) else { panic!("a plane") };
        assert!((found - normal).norm() < 1e-12);
    }
}

/// A ring and a tip, and two rings (every chamfer), lie on a sphere too; the facets do not.
#[test]
fn a_cone_is_no_sphere() {
    let chamfer: Triangles = (0..90)
        .flat_map(|k| {
            let at = |k: usize, r: f64, z: f64| {
                let a = (4.0 * (k % 90) as f64).to_radians();
                [r * libm::cos(a), r * libm::sin(a), z]
            };
            let [a, b, c, d] = [at(k, 6.0, 0.0), at(k + 1, 6.0, 0.0), at(k + 1, 5.25, 1.0), at(k, 5.25, 1.0)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    for triangles in [solids::cone(6.0, 8.0, 90), chamfer] {
        let found = shape(&triangles, [6.0, 0.0, 0.0]);
        let Shape::Cone { half_angle_deg, apex, axis } = found else { panic!("a cone, not {found:?}") };
        assert!((half_angle_deg - libm::atan2(6.0, 8.0).to_degrees()).abs() < 0.01 && is_on_axis(&apex, &axis));
        assert!((apex.z - 8.0).abs() < 1e-3 && axis.z < 0.0, "the axis goes from the tip into the cone");
    }
}

/// Radii, on the corners' meridian, at which a plane z = h cuts a profile (r, z).
fn radii_at(profile: &[[f64; 2]], h: f64) -> Vec<f64> {
    profile
        .windows(2)
        .filter(|w| (w[0][1] < h) != (w[1][1] < h))
        .map(|w| w[0][0] + (w[1][0] - w[0][0]) * (h - w[0][1]) / (w[1][1] - w[0][1]))
        .collect()
}

#[test]
fn sections_of_round_solids_are_closed_polygons() {
    let sphere = circle([0.0, 0.0], 10.0, -90.0, 90.0, 32);
    let torus = circle([20.0, 0.0], 5.0, 0.0, 360.0, 40);
    let cases = [
        (solids::sphere(10.0, 64, 32), sphere, 64, [10.0, 0.0, 0.0], 1),
        (solids::torus(20.0, 5.0, 80, 40), torus, 80, [25.0, 0.0, 0.0], 2),
        (solids::cone(6.0, 8.0, 90), vec![[6.0, 0.0], [0.0, 8.0]], 90, [3.0, 0.0, 4.0], 1),
        (solids::cylinder(5.0, 12.0, 48), vec![[5.0, 0.0], [5.0, 12.0]], 48, [5.0, 0.0, 6.0], 1),
        (solids::blind_hole(30.0, 5.0, 12.0, 64), vec![[5.0, -12.0], [5.0, 0.0]], 64, [5.0, 0.0, -6.0], 1),
    ];
    for (triangles, profile, sides, at, per_plane) in cases {
        let (family, lines) = cut(&triangles, at, "z", 0.65);
        assert_eq!(lines.len(), per_plane * family.heights_mm.len());
        for (plane, h) in family.heights_mm.iter().enumerate() {
            let mut found: Vec<f64> = lines.iter().filter(|l| l.plane == plane).map(length).collect();
            let mut expected: Vec<f64> = radii_at(&profile, *h).iter().map(|r| polygon(*r, sides).0).collect();
            found.sort_by(f64::total_cmp);
            expected.sort_by(f64::total_cmp);
            assert_eq!(found.len(), expected.len());
            found.iter().zip(&expected).for_each(|(f, e)| near("perimeter", *f, *e, 3e-6));
        }
        assert!(
            lines
                .iter()
                .all(|l| l.closed && l.points.iter().all(|q| (q.p.z - family.heights_mm[l.plane]).abs() < 1e-9))
        );
    }
    // Across the torus: two closed lines where the plane misses the hole's circle, else one.
    let (family, lines) = cut(&solids::torus(20.0, 5.0, 80, 40), [25.0, 0.0, 0.0], "x", 1.1);
    for (plane, h) in family.heights_mm.iter().enumerate() {
        let expected = if h.abs() < 15.0 * libm::cos(PI / 80.0) { 2 } else { 1 };
        assert_eq!(lines.iter().filter(|l| l.plane == plane).count(), expected, "x = {h}");
    }
}

#[test]
fn sections_of_flat_faces_are_open_and_meet_at_creases() {
    let groove = solids::v_groove(30.0, 8.0, 6.0, 40.0);
    for (at, expected) in [([-2.0, 20.0, -2.0 * 3f64.sqrt()], 8.0 / libm::cos(PI / 6.0)), ([-8.0, 20.0, 0.0], 6.0)] {
        let (family, lines) = cut(&groove, at, "y", 0.9);
        assert_eq!(lines.len(), family.heights_mm.len());
        lines.iter().for_each(|l| assert!(!l.closed && (length(l) - expected).abs() < 1e-5));
    }
    // One family for all faces of a cube: round each of its planes, four lines end to end.
    let cube = planned(part(&solids::cube(10.0)), job("z", 0.8));
    let ends: Vec<Point3<f64>> =
        cube.plan.passes.iter().flat_map(|p| [p.targets[0].p, p.targets[p.targets.len() - 1].p]).collect();
    assert_eq!(ends.len(), 8 * 13);
    for p in &ends {
        assert_eq!(ends.iter().filter(|q| (*q - p).norm() < 1e-9).count(), 2, "two lines meet at {p}");
    }
}

#[test]
fn normals_of_cylinder_and_sphere_are_radial() {
    let (_, lines) = cut(&solids::cylinder(5.0, 12.0, 48), [5.0, 0.0, 6.0], "z", 0.7);
    for q in lines.iter().flat_map(|l| &l.points) {
        // Between two corners both position and normal are means of the corners': radial throughout.
        assert!(angle_deg(&q.n, &Vector3::new(q.p.x, q.p.y, 0.0)) < 1e-3, "{q:?}");
    }
    let chord_deg = 360.0 / 64.0;
    let (_, lines) = cut(&solids::sphere(10.0, 64, 32), [10.0, 0.0, 0.0], "x", 0.7);
    for q in lines.iter().flat_map(|l| &l.points) {
        assert!(angle_deg(&q.n, &q.p.coords) < 0.5 * chord_deg, "{q:?}");
    }
    // A cube's lines keep the face's normal up to the crease.
    for pass in &planned(part(&solids::cube(10.0)), job("z", 0.8)).plan.passes {
        assert!(
            pass.targets.iter().all(|t| t.n == pass.targets[0].n && t.n.iter().filter(|c| **c != 0.0).count() == 1)
        );
    }
}
