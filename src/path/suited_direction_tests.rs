//! Directions that are known: of flat faces, of bodies of rotation and extrusion, of odd ones; and laws.

use super::*;
use crate::part::surfaces::Surface;
use proptest::prelude::*;
use std::f64::consts::TAU;

struct Skin {
    mesh: Mesh,
    surface: Surface,
}

impl Skin {
    fn new(points: Vec<[f64; 3]>, facets: Vec<[u32; 3]>) -> Skin {
        let mesh = Mesh::from_indexed(points.into_iter().map(Point3::from).collect(), facets);
        let facets = (0..mesh.facets.len() as u32).collect();
        let surface = Surface { number: 1, facets, area_mm2: mesh.areas.iter().sum() };
        Skin { mesh, surface }
    }

    /// A net of `m` by `n` quads over the unit square.
    fn net(m: usize, n: usize, at: impl Fn(f64, f64) -> [f64; 3]) -> Skin {
        let points = (0..=n).flat_map(|j| (0..=m).map(move |i| (i, j)));
        let points = points.map(|(i, j)| at(i as f64 / m as f64, j as f64 / n as f64)).collect();
        let v = |i: usize, j: usize| (j * (m + 1) + i) as u32;
        let quad = |(i, j)| [[v(i, j), v(i + 1, j), v(i + 1, j + 1)], [v(i, j), v(i + 1, j + 1), v(i, j + 1)]];
        Skin::new(points, (0..n).flat_map(|j| (0..m).map(move |i| (i, j))).flat_map(quad).collect())
    }

    /// The same, turned.
    fn turned(&self, turn: &Rotation3<f64>) -> Skin {
        let points = self.mesh.vertices.iter().map(|p| (turn * p).coords.into()).collect();
        Skin::new(points, self.mesh.facets.clone())
    }

    fn direction(&self, axes: &Rotation3<f64>) -> Vector3<f64> {
        suited_direction(&self.mesh, &self.surface, axes).expect("a direction")
    }

    fn plain(&self) -> Vector3<f64> {
        self.direction(&Rotation3::identity())
    }

    /// Share of its area that planes of a direction miss.
    fn missed(&self, m: &Vector3<f64>) -> f64 {
        shares(live(&self.mesh, &self.surface).map(|f| (self.mesh.normals[f], self.mesh.areas[f])), m, PARALLEL_DEG).0
    }
}

fn rectangle(x_mm: f64, y_mm: f64) -> Skin {
    Skin::net(4, 3, move |u, v| [x_mm * u, y_mm * v, 7.0])
}

/// A band about z, its radius and height along it given.
fn band(sides: usize, steps: usize, at: impl Fn(f64) -> [f64; 2]) -> Skin {
    Skin::net(sides, steps, move |u, v| {
        let [r, z] = at(v);
        [r * libm::cos(TAU * u), r * libm::sin(TAU * u), z]
    })
}

/// Part of a cylinder about y: so many degrees to both sides of z.
fn trough(half_deg: f64, radius: f64, length: f64) -> Skin {
    Skin::net(40, 5, move |u, v| {
        let turn = ((2.0 * u - 1.0) * half_deg).to_radians();
        [radius * libm::sin(turn), length * v, radius * libm::cos(turn)]
    })
}

/// Three faces of a cube around a corner, as one surface.
fn corner() -> Skin {
    let p = |x: u32, y: u32, z: u32| [f64::from(x), f64::from(y), f64::from(z)].map(|c| 10.0 * c);
    let points = vec![p(1, 1, 1), p(1, 0, 1), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0), p(0, 1, 1), p(0, 0, 1)];
    let quads = [[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 1]];
    Skin::new(points, quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).collect())
}

fn all() -> Vec<Skin> {
    vec![
        rectangle(40.0, 30.0),
        rectangle(20.0, 20.0),
        band(48, 4, |v| [10.0, 20.0 * v]),
        band(48, 2, |v| [20.0 - v, v]),
        band(36, 12, |v| [10.0 * libm::cos(v * TAU / 4.0), 10.0 * libm::sin(v * TAU / 4.0)]),
        band(36, 18, |v| [10.0 * libm::sin(v * TAU / 2.0), 10.0 * libm::cos(v * TAU / 2.0)]),
        band(32, 1, |v| [10.0 * v, 0.0]),
        trough(30.0, 10.0, 100.0),
        trough(90.0, 10.0, 100.0),
        corner(),
    ]
}

#[test]
fn flat_faces_get_their_long_lines() {
    assert_eq!(rectangle(40.0, 30.0).plain(), Vector3::y());
    assert_eq!(rectangle(30.0, 40.0).plain(), Vector3::x());
    assert_eq!(rectangle(20.0, 20.0).plain(), Vector3::x(), "of two alike the first");
    let disc = band(32, 1, |v| [10.0 * v, 0.0]);
    assert_eq!(disc.plain(), Vector3::x(), "no odd direction for half a per cent of width");
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), 0.3);
    let leaning = rectangle(40.0, 30.0).turned(&turn);
    assert!((leaning.plain() - turn * Vector3::y()).norm() < 1e-9, "along its own sides");
}

#[test]
fn bodies_of_rotation_get_rings_and_troughs_their_length() {
    assert_eq!(band(48, 4, |v| [10.0, 20.0 * v]).plain(), Vector3::z(), "a wall");
    assert_eq!(band(48, 2, |v| [20.0 - v, v]).plain(), Vector3::z(), "a chamfer of 45°: no comb of short pieces");
    assert_eq!(
        band(36, 18, |v| [10.0 * libm::sin(v * TAU / 2.0), 10.0 * libm::cos(v * TAU / 2.0)]).plain(),
        Vector3::z()
    );
    assert_eq!(trough(30.0, 10.0, 100.0).plain(), Vector3::x(), "ten lines of 100 mm, not 100 arcs of 10");
    assert_eq!(trough(90.0, 10.0, 100.0).plain(), Vector3::y(), "its rims would lie along planes across x");
}

#[test]
fn no_plane_lies_along_a_facet_where_that_can_be_helped() {
    let corner = corner();
    assert!([Vector3::x(), Vector3::y(), Vector3::z()].iter().all(|axis| corner.missed(axis) > 0.3));
    assert_eq!(corner.missed(&corner.plain()), 0.0);
}

#[test]
fn a_surface_without_an_area_has_none() {
    let line = Skin::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], vec![[0, 1, 2]]);
    assert_eq!(suited_direction(&line.mesh, &line.surface, &Rotation3::identity()), None);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn a_placement_turns_the_direction_with_the_part(axis in prop::array::uniform3(-1.0..1.0f64), deg in -180.0..180.0f64) {
        let axis = nalgebra::Unit::new_normalize(Vector3::from(axis) + Vector3::repeat(1e-3));
        let turn = Rotation3::from_axis_angle(&axis, deg.to_radians());
        for skin in all() {
            let (still, moved) = (skin.plain(), skin.turned(&turn).direction(&turn));
            prop_assert!((turn * still - moved).norm() < 1e-6, "{still:?} {moved:?}");
        }
    }

    #[test]
    fn the_order_of_facets_changes_nothing(seed in any::<u64>()) {
        for skin in all() {
            let mut facets = skin.mesh.facets.clone();
            let mut state = seed | 1;
            for i in (1..facets.len()).rev() {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                facets.swap(i, (state >> 33) as usize % (i + 1));
            }
            let points = skin.mesh.vertices.iter().map(|p| p.coords.into()).collect();
            let mixed = Skin::new(points, facets);
            prop_assert!((skin.plain() - mixed.plain()).norm() < 1e-6);
        }
    }
}
