//! Meshes of surfaces whose truth is known: how near they are, how they hang together, which way they face.

use super::*;
use crate::scan::made_up::Sequence;
use nalgebra::{Isometry3, Vector3};
use proptest::prelude::*;
use std::f64::consts::TAU;

const NOISE_MM: f64 = 0.03;

fn meshed(points: &[Point3<f64>]) -> ScanMesh {
    mesh_of(&Cloud::of_points(points), &Progress::default()).expect("a surface")
}

fn noisy(s: &mut Sequence, p: Vector3<f64>, noise_mm: f64) -> Point3<f64> {
    Point3::from(p + Vector3::from_fn(|_, _| s.normal()) * noise_mm)
}

fn direction(s: &mut Sequence) -> Vector3<f64> {
    let z = 2.0 * s.uniform() - 1.0;
    let (r, turn) = ((1.0 - z * z).sqrt(), TAU * s.uniform());
    Vector3::new(r * libm::cos(turn), r * libm::sin(turn), z)
}

fn sphere(count: usize, radius: f64, noise_mm: f64, seed: u64) -> Vec<Point3<f64>> {
    let mut s = Sequence::new(seed);
    let mut point = || {
        let p = direction(&mut s) * radius;
        noisy(&mut s, p, noise_mm)
    };
    (0..count).map(|_| point()).collect()
}

/// Points on the six faces of a cube about the origin.
fn cube(count: usize, half: f64, noise_mm: f64) -> Vec<Point3<f64>> {
    let mut s = Sequence::new(11);
    (0..count)
        .map(|i| {
            let mut p = Vector3::from_fn(|_, _| half * (2.0 * s.uniform() - 1.0));
            p[i % 3] = if i % 6 < 3 { half } else { -half };
            noisy(&mut s, p, noise_mm)
        })
        .collect()
}

/// A square sheet across z, where `takes` says so.
fn sheet(count: usize, half: f64, z: f64, seed: u64, takes: impl Fn(f64, f64) -> bool) -> Vec<Point3<f64>> {
    let mut s = Sequence::new(seed);
    let mut flat = || [half * (2.0 * s.uniform() - 1.0), half * (2.0 * s.uniform() - 1.0)];
    let flat: Vec<[f64; 2]> = (0..count).map(|_| flat()).filter(|[x, y]| takes(*x, *y)).collect();
    flat.into_iter().map(|[x, y]| noisy(&mut s, Vector3::new(x, y, z), NOISE_MM)).collect()
}

fn rms(all: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = all.fold((0.0, 0.0), |(sum, count), d| (sum + d * d, count + 1.0));
    (sum / f64::max(count, 1.0)).sqrt()
}

fn normal(mesh: &ScanMesh, facet: usize) -> Vector3<f64> {
    let [a, b, c] = mesh.facets[facet].map(|v| mesh.vertices[v as usize]);
    (b - a).cross(&(c - a))
}

/// Every edge has two facets at most, which run along it in opposite directions; rims are those with one. No facet is
/// without area, no vertex without a facet. Returns V − E + F.
fn proper(mesh: &ScanMesh) -> i64 {
    let sides = mesh.facets.iter().flat_map(|f| (0..3).map(|k| [f[k], f[(k + 1) % 3]]));
    let mut sides: Vec<[u32; 2]> = sides.collect();
    sides.sort_unstable();
    assert!(sides.windows(2).all(|w| w[0] != w[1]), "two facets run along an edge the same way");
    let alone: Vec<[u32; 2]> = sides.iter().copied().filter(|s| sides.binary_search(&[s[1], s[0]]).is_err()).collect();
    let mut rim = mesh.rim_edges.clone();
    rim.sort_unstable();
    assert_eq!(rim, alone);
    for (f, corners) in mesh.facets.iter().enumerate() {
        let [a, b, c] = corners.map(|v| mesh.vertices[v as usize]);
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        let height = normal(mesh, f).norm() / longest;
        assert!(height > 0.01 * mesh.cell_mm, "facet {f} is {height} mm high");
    }
    let mut used: Vec<u32> = mesh.facets.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    assert_eq!(used.len(), mesh.vertices.len());
    let edges = (sides.len() + alone.len()) / 2;
    mesh.vertices.len() as i64 - edges as i64 + mesh.facets.len() as i64
}

/// Share of facets that face away from the origin.
fn outward(mesh: &ScanMesh) -> f64 {
    let faces = |f: &usize| normal(mesh, *f).dot(&mesh.vertices[mesh.facets[*f][0] as usize].coords) > 0.0;
    (0..mesh.facets.len()).filter(faces).count() as f64 / mesh.facets.len() as f64
}

#[test]
fn a_sphere_is_closed_faces_outward_and_lies_well_within_the_noise() {
    let mut points = sphere(20_000, 20.0, NOISE_MM, 1);
    let mut s = Sequence::new(2);
    points.extend((0..200).map(|_| Point3::from(Vector3::from_fn(|_, _| 60.0 * s.uniform() - 30.0))));
    let mesh = meshed(&points);
    assert_eq!(proper(&mesh), 2);
    assert!(mesh.rim_edges.is_empty());
    assert_eq!((outward(&mesh), mesh.oriented), (1.0, Oriented::Propagated));
    let off = rms(mesh.vertices.iter().map(|v| v.coords.norm() - 20.0));
    assert!(off < 0.6 * NOISE_MM, "{off}");
    assert!((mesh.rms_mm / NOISE_MM - 1.0).abs() < 0.2, "{}", mesh.rms_mm);
    assert!(mesh.dropped_points.abs_diff(200) < 40, "{}", mesh.dropped_points);
    assert_eq!(mesh.used_points + mesh.dropped_points, points.len());
}

/// Points denser than they scatter: the cells follow the noise.
#[test]
fn a_sphere_of_dense_and_noisy_points_is_one() {
    let mesh = meshed(&sphere(60_000, 5.0, 0.1, 3));
    assert_eq!(proper(&mesh), 2);
    assert!((mesh.noise_mm - 0.1).abs() < 0.02, "{}", mesh.noise_mm);
    let off = rms(mesh.vertices.iter().map(|v| v.coords.norm() - 5.0));
    assert!(off < 0.03, "{off}");
}

#[test]
fn a_cylinder_without_lids_has_two_rims_where_the_points_end() {
    let mut s = Sequence::new(4);
    let points: Vec<Point3<f64>> = (0..20_000)
        .map(|_| {
            let turn = TAU * s.uniform();
            let p = Vector3::new(8.0 * libm::cos(turn), 8.0 * libm::sin(turn), 40.0 * s.uniform() - 20.0);
            noisy(&mut s, p, NOISE_MM)
        })
        .collect();
    let mesh = meshed(&points);
    assert_eq!(proper(&mesh), 0);
    let off = rms(mesh.vertices.iter().map(|v| v.xy().coords.norm() - 8.0));
    assert!(off < 0.6 * NOISE_MM, "{off}");
    let ends: Vec<f64> = mesh.rim_edges.iter().map(|e| mesh.vertices[e[0] as usize].z.abs()).collect();
    assert!(ends.iter().all(|z| (z - 20.0).abs() < 1.5 * mesh.cell_mm), "{ends:?}");
}

#[test]
fn a_cube_keeps_its_faces_and_rounds_its_edges_over_a_cell() {
    let mesh = meshed(&cube(30_000, 10.0, NOISE_MM));
    assert_eq!(proper(&mesh), 2);
    assert_eq!(outward(&mesh), 1.0);
    let off = |v: &Point3<f64>| v.coords.amax() - 10.0;
    let from_edge = |v: &Point3<f64>| {
        let mut side = v.coords.abs();
        let most = side.imax();
        side[most] = 0.0;
        10.0 - side.amax()
    };
    let flat = rms(mesh.vertices.iter().filter(|v| from_edge(v) > 1.0 * mesh.cell_mm).map(off));
    let worst = mesh.vertices.iter().map(|v| off(v).abs()).fold(0.0, f64::max);
    assert!(flat < 0.6 * NOISE_MM, "{flat}");
    assert!(worst < 0.5 * mesh.cell_mm, "{worst}");
}

/// A hole of four and a half cells stays open, about as large as it is; one of a cell closes.
#[test]
fn a_plane_keeps_its_hole_and_its_rim() {
    let cells = |radius: f64| meshed(&sheet(16_000, 15.0, 2.0, 5, |x, y| x * x + y * y > radius * radius));
    let mesh = cells(1.1);
    assert_eq!(proper(&mesh), 0);
    let off = rms(mesh.vertices.iter().map(|v| v.z - 2.0));
    assert!(off < 0.6 * NOISE_MM, "{off}");
    let area = 0.5 * (0..mesh.facets.len()).map(|f| normal(&mesh, f).norm()).sum::<f64>();
    let truth = 900.0 - 0.5 * TAU * 1.1 * 1.1;
    assert!((area / truth - 1.0).abs() < 0.1, "{area}, not {truth}");
    assert!((0..mesh.facets.len()).all(|f| normal(&mesh, f).z > 0.0));
    assert_eq!(proper(&cells(0.2)), 1);
}

/// Two sheets four and a half cells apart, the lower one four times as dense: two pieces that face away from each other.
#[test]
fn both_sides_of_a_thin_sheet_are_kept_apart() {
    let mut points = sheet(20_000, 15.0, 0.0, 6, |_, _| true);
    points.extend(sheet(5_000, 15.0, 2.4, 7, |_, _| true));
    let mesh = meshed(&points);
    assert_eq!(proper(&mesh), 2);
    for v in &mesh.vertices {
        assert!(v.z.abs() < 0.15 || (v.z - 2.4).abs() < 0.15, "{v}");
    }
    for f in 0..mesh.facets.len() {
        let up = mesh.vertices[mesh.facets[f][0] as usize].z > 1.2;
        assert_eq!(normal(&mesh, f).z > 0.0, up);
    }
}

/// Half-way between sheets that both face up the distance changes its sign as well, and nothing is there.
#[test]
fn between_sheets_that_face_the_same_way_there_is_nothing() {
    let mut points = sheet(6_000, 10.0, 0.0, 16, |_, _| true);
    points.extend(sheet(6_000, 10.0, 2.2, 17, |_, _| true));
    let cloud = Cloud { normals: Some(vec![[0.0, 0.0, 1.0]; points.len()]), ..Cloud::of_points(&points) };
    let mesh = mesh_of(&cloud, &Progress::default()).expect("a surface");
    assert!((4.0..4.5).contains(&(2.2 / mesh.cell_mm)), "{}", mesh.cell_mm);
    assert_eq!(proper(&mesh), 2);
    assert!(mesh.vertices.iter().all(|v| v.z.abs() < 0.15 || (v.z - 2.2).abs() < 0.15));
}

#[test]
fn own_normals_decide_on_the_side() {
    let points = sphere(8_000, 10.0, 0.0, 8);
    let inward: Vec<[f32; 3]> = points.iter().map(|p| p.coords.normalize().map(|c| -c as f32).into()).collect();
    let cloud = Cloud { normals: Some(inward), ..Cloud::of_points(&points) };
    let mesh = mesh_of(&cloud, &Progress::default()).expect("a surface");
    assert_eq!((outward(&mesh), mesh.oriented), (0.0, Oriented::OwnNormals));
    assert_eq!(proper(&mesh), 2);
}

#[test]
fn the_mesh_is_the_same_on_any_number_of_threads() {
    let cloud = Cloud::of_points(&cube(9_000, 6.0, NOISE_MM));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| mesh_of(&cloud, &Progress::default()).expect("a surface"))
    };
    assert_eq!(on(1), on(4));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]
    /// The lattice stands otherwise on a part that was moved; the surface does not.
    #[test]
    fn a_motion_of_the_cloud_moves_the_mesh(turn in prop::array::uniform3(-3.0..3.0f64), shift in prop::array::uniform3(-90.0..90.0f64)) {
        let points = sphere(6_000, 10.0, 0.02, 9);
        let motion = Isometry3::new(Vector3::from(shift), Vector3::from(turn));
        let moved: Vec<Point3<f64>> = points.iter().map(|p| motion * p).collect();
        let (one, other) = (meshed(&points), meshed(&moved));
        prop_assert_eq!(proper(&other), 2);
        let bvh = crate::part::Bvh::new(&Mesh::from_indexed(one.vertices, one.facets));
        for v in &other.vertices {
            let back = motion.inverse() * v;
            let off = bvh.closest(&back, 1.0).map_or(1.0, |c| c.distance_mm);
            prop_assert!(off < 0.1 * one.cell_mm, "{off} of {}", one.cell_mm);
        }
    }
}

#[test]
fn what_tells_no_surface_is_refused() {
    let of = |points: &[Point3<f64>]| mesh_of(&Cloud::of_points(points), &Progress::default());
    let none = |finite: usize| Err(MeshingError::NoSurface { finite });
    assert_eq!(of(&[]), none(0));
    assert_eq!(of(&[Point3::new(1.0, 2.0, 3.0)]), none(1));
    let line: Vec<Point3<f64>> = (0..500).map(|i| Point3::new(0.1 * f64::from(i), 0.0, 0.0)).collect();
    assert_eq!(of(&line), none(500));
    assert_eq!(of(&[Point3::new(1.0, 2.0, 3.0); 500]), none(500));
    let nan = Cloud { offsets: vec![[f32::NAN, 1.0, f32::INFINITY]; 100], ..Cloud::default() };
    assert_eq!(mesh_of(&nan, &Progress::default()), none(0));
    let mut s = Sequence::new(12);
    let huge: Vec<[f32; 3]> = (0..500).map(|_| [0; 3].map(|_| (s.uniform() * 3e38) as f32)).collect();
    assert!(mesh_of(&Cloud { offsets: huge, ..Cloud::default() }, &Progress::default()).is_err());
}

#[test]
fn points_that_are_no_numbers_are_counted_and_do_no_harm() {
    let mut cloud = Cloud::of_points(&sphere(5_000, 10.0, 0.0, 13));
    cloud.offsets.extend([[f32::NAN; 3], [f32::INFINITY, 0.0, 0.0]]);
    let mesh = mesh_of(&cloud, &Progress::default()).expect("a surface");
    assert_eq!(proper(&mesh), 2);
    assert_eq!((mesh.used_points, mesh.dropped_points), (5_000, 2));
}

#[test]
fn the_work_ends_when_it_is_cancelled() {
    let cloud = Cloud::of_points(&sphere(5_000, 10.0, 0.0, 14));
    for looks in [1, 20, 100, 200] {
        let found = mesh_of(&cloud, &Progress::ending_after(looks));
        assert_eq!(found, Err(MeshingError::Cancelled), "after {looks}");
    }
}

/// A plate 3 mm thick with its rim, one half of it four times as dense as the other: closed, and no hole where it is thin.
#[test]
fn a_plate_of_uneven_density_is_closed() {
    let mut s = Sequence::new(15);
    let mut points = Vec::new();
    while points.len() < 24_000 {
        let (x, y, z) = (30.0 * s.uniform() - 15.0, 20.0 * s.uniform() - 10.0, 3.0 * s.uniform() - 1.5);
        let edge = s.uniform() * 1500.0;
        let p = match edge {
            e if e < 600.0 => Vector3::new(x, y, 1.5),
            e if e < 1200.0 => Vector3::new(x, y, -1.5),
            e if e < 1260.0 => Vector3::new(15.0, y, z),
            e if e < 1320.0 => Vector3::new(-15.0, y, z),
            e if e < 1410.0 => Vector3::new(x, 10.0, z),
            _ => Vector3::new(x, -10.0, z),
        };
        if p.x > 0.0 || s.uniform() < 0.25 {
            points.push(noisy(&mut s, p, NOISE_MM));
        }
    }
    let mesh = meshed(&points);
    assert_eq!(proper(&mesh), 2);
    let volume: f64 = (0..mesh.facets.len())
        .map(|f| normal(&mesh, f).dot(&mesh.vertices[mesh.facets[f][0] as usize].coords) / 6.0)
        .sum();
    assert!((volume / 1800.0 - 1.0).abs() < 0.02, "{volume}");
}
