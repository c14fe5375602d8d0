//! Each kind recovers itself; wear is measured against it; what is of another kind, or tells nothing, is refused.

use super::*;
use crate::part::angle::between_deg;
use crate::scan::made_up::Sequence;
use nalgebra::Isometry3;
use proptest::prelude::*;

const NOISE_MM: f64 = 0.03;
/// Wear of METHODS' closed form: h(1 − (r/R)²)², 0.2 mm deep, 10 mm in radius.
const DEPTH_MM: f64 = 0.2;
const RADIUS_MM: f64 = 10.0;

fn worn_mm(r: f64) -> f64 {
    let share = 1.0 - (r / RADIUS_MM) * (r / RADIUS_MM);
    if r < RADIUS_MM { DEPTH_MM * share * share } else { 0.0 }
}

/// Points of a surface with their true places, normals, and wear.
#[derive(Clone, Default)]
struct Made {
    points: Vec<Point3<f64>>,
    truth: Vec<Point3<f64>>,
    normals: Vec<Vector3<f64>>,
    state: Vec<PointState>,
    worn_mm: Vec<f64>,
    noise_mm: f64,
}

impl Made {
    /// `of` makes of two numbers in 0..1 a place, its normal, and how far it is from the middle of the wear along the
    /// surface. Where wear is deeper than `marked_mm` it is marked as damage.
    fn new(
        count: usize,
        noise_mm: f64,
        marked_mm: f64,
        of: impl Fn(f64, f64) -> (Point3<f64>, Vector3<f64>, f64),
    ) -> Made {
        let mut s = Sequence::new(7);
        let mut made = Made { noise_mm: noise_mm.max(1e-3), ..Made::default() };
        for _ in 0..count {
            let (place, normal, r) = of(s.uniform(), s.uniform());
            let worn_mm = worn_mm(r);
            made.points.push(place + normal * (s.normal() * noise_mm - worn_mm));
            made.truth.push(place);
            let tilt = Vector3::from_fn(|_, _| s.normal()) * 0.02;
            made.normals.push((normal + tilt).normalize());
            made.state.push(if worn_mm > marked_mm { PointState::Damaged } else { PointState::Sound });
            made.worn_mm.push(worn_mm);
        }
        made
    }

    fn region(&self) -> DamagedRegion<'_> {
        DamagedRegion { points: &self.points, normals: &self.normals, state: &self.state, noise_mm: self.noise_mm }
    }

    fn continued(&self, kind: SurfaceKind) -> Result<ContinuedSurface, ContinuationError> {
        continued(&self.region(), kind, &Progress::default())
    }

    /// How far the continued surface lies off the truth at the worst point, mm.
    fn worst_mm(&self, found: &ContinuedSurface) -> f64 {
        let off = |p: &Point3<f64>| found.closest(p).map_or(f64::INFINITY, |(foot, _)| (foot - p).norm());
        self.truth.iter().map(off).fold(0.0, f64::max)
    }

    /// Mean depth of the wear's deeper half by the continued surface less the true one, mm.
    fn depth_error_mm(&self, found: &ContinuedSurface) -> f64 {
        let deep: Vec<usize> = (0..self.points.len()).filter(|i| self.worn_mm[*i] > 0.5 * DEPTH_MM).collect();
        let error = |&i: &usize| {
            let (foot, normal) = found.closest(&self.points[i]).expect("a foot");
            (foot - self.points[i]).dot(&normal) - self.worn_mm[i]
        };
        assert!(deep.len() > 60);
        deep.iter().map(error).sum::<f64>() / deep.len() as f64
    }
}

fn plane(noise_mm: f64, marked_mm: f64) -> Made {
    Made::new(6_000, noise_mm, marked_mm, |a, b| {
        let (x, y) = (50.0 * a - 25.0, 40.0 * b - 20.0);
        (Point3::new(x, y, 0.2 * x), Vector3::new(-0.2, 0.0, 1.0).normalize(), (1.04 * x * x + y * y).sqrt())
    })
}

/// A part of a cylinder of radius 20 mm about z; `side` −1: a bore.
fn cylinder(noise_mm: f64, marked_mm: f64, arc_deg: f64, side: f64) -> Made {
    Made::new(6_000, noise_mm, marked_mm, |a, b| {
        let (turn, z) = (arc_deg.to_radians() * (a - 0.5), 50.0 * b - 25.0);
        let out = Vector3::new(libm::cos(turn), libm::sin(turn), 0.0);
        let r = (400.0 * turn * turn + z * z).sqrt();
        (Point3::from(out * 20.0 + Vector3::z() * z), out * side, r)
    })
}

/// Half a vase: r = 15 + 3 sin(z/10), z from −30 to 30, about an axis through (5, −3, 0) along z.
fn vase(noise_mm: f64) -> Made {
    Made::new(6_000, noise_mm, 0.02, |a, b| {
        let (turn, z) = (3.2 * (a - 0.5), 60.0 * b - 30.0);
        let (r, slope) = (15.0 + 3.0 * libm::sin(0.1 * z), 0.3 * libm::cos(0.1 * z));
        let out = Vector3::new(libm::cos(turn), libm::sin(turn), 0.0);
        let normal = (out - Vector3::z() * slope).normalize();
        (Point3::from(out * r + Vector3::new(5.0, -3.0, z)), normal, (225.0 * turn * turn + z * z).sqrt())
    })
}

/// A wave drawn along y: z = 2 cos(x/8).
fn wave(noise_mm: f64) -> Made {
    Made::new(6_000, noise_mm, 0.02, |a, b| {
        let (x, y) = (50.0 * a - 25.0, 50.0 * b - 25.0);
        let slope = -0.25 * libm::sin(0.125 * x);
        let place = Point3::new(x, y, 2.0 * libm::cos(0.125 * x));
        (place, Vector3::new(-slope, 0.0, 1.0).normalize(), (x * x + y * y).sqrt())
    })
}

/// A saddle: z = (x² − y²)/200 + x³/20000.
fn saddle(noise_mm: f64) -> Made {
    Made::new(6_000, noise_mm, 0.02, |a, b| {
        let (x, y) = (50.0 * a - 25.0, 50.0 * b - 25.0);
        let normal = Vector3::new(-0.01 * x - 1.5e-4 * x * x, 0.01 * y, 1.0).normalize();
        (Point3::new(x, y, (x * x - y * y) / 200.0 + x * x * x / 20_000.0), normal, (x * x + y * y).sqrt())
    })
}

#[test]
fn a_plane_and_the_depth_of_its_wear_are_told() {
    for noise_mm in [0.0, NOISE_MM] {
        let made = plane(noise_mm, 0.02);
        let found = made.continued(SurfaceKind::Plane).expect("a plane");
        let SurfaceFigures::Plane { normal, .. } = found.figures() else { panic!("no plane") };
        assert!(between_deg(&normal, &Vector3::new(-0.2, 0.0, 1.0)) < 0.05);
        assert!(made.depth_error_mm(&found).abs() < 0.01, "{}", made.depth_error_mm(&found));
        assert!((found.gap_mm - 2.0 * 8.2).abs() < 1.0, "{}", found.gap_mm);
    }
}

#[test]
fn a_cylinder_its_bore_and_the_depth_of_the_wear_are_told() {
    for (noise_mm, arc_deg, side) in
        [(0.0, 120.0, 1.0), (NOISE_MM, 120.0, 1.0), (NOISE_MM, 360.0, 1.0), (NOISE_MM, 90.0, -1.0)]
    {
        let made = cylinder(noise_mm, 0.02, arc_deg, side);
        let found = made.continued(SurfaceKind::Cylinder).expect("a cylinder");
        let SurfaceFigures::Cylinder { axis, radius_mm, .. } = found.figures() else { panic!("no cylinder") };
        let off_deg = between_deg(&axis, &Vector3::z());
        assert!(off_deg.min(180.0 - off_deg) < 0.05, "{off_deg}");
        assert!((radius_mm - 20.0).abs() < 0.02, "{radius_mm}");
        assert!(made.depth_error_mm(&found).abs() < 0.01);
        let (_, normal) = found.closest(&Point3::new(20.0, 0.0, 0.0)).expect("a foot");
        assert!(normal.x * side > 0.99);
    }
}

#[test]
fn what_is_revolved_finds_its_axis_and_its_curve() {
    let made = vase(NOISE_MM);
    let found = made.continued(SurfaceKind::Revolved).expect("revolved");
    let SurfaceFigures::Revolved { axis, point } = found.figures() else { panic!("not revolved") };
    let off_deg = between_deg(&axis, &Vector3::z());
    let off_mm = (point - Point3::new(5.0, -3.0, 0.0)).cross(&axis).norm();
    assert!(off_deg.min(180.0 - off_deg) < 0.05 && off_mm < 0.02, "{off_deg}, {off_mm}");
    assert!(made.worst_mm(&found) < 0.02, "{}", made.worst_mm(&found));
    assert!(made.depth_error_mm(&found).abs() < 0.01);
}

#[test]
fn what_is_extruded_finds_its_direction_and_its_curve() {
    let made = wave(NOISE_MM);
    let found = made.continued(SurfaceKind::Extruded).expect("extruded");
    let SurfaceFigures::Extruded { direction } = found.figures() else { panic!("not extruded") };
    let off_deg = between_deg(&direction, &Vector3::y());
    assert!(off_deg.min(180.0 - off_deg) < 0.05, "{off_deg}");
    assert!(made.worst_mm(&found) < 0.02);
    assert!(made.depth_error_mm(&found).abs() < 0.01);
}

#[test]
fn a_smooth_surface_takes_the_degree_that_it_has() {
    let made = saddle(NOISE_MM);
    let found = made.continued(SurfaceKind::Smooth).expect("smooth");
    assert_eq!(found.figures(), SurfaceFigures::Smooth { degree: 3 });
    assert!(made.worst_mm(&found) < 0.02);
    assert!(made.depth_error_mm(&found).abs() < 0.01);
}

/// Only what is deeper than half of the wear is marked: the rest loses its say.
#[test]
fn worn_points_marked_sound_do_not_pull() {
    for (made, kind) in
        [(plane(NOISE_MM, 0.1), SurfaceKind::Plane), (cylinder(NOISE_MM, 0.1, 150.0, 1.0), SurfaceKind::Cylinder)]
    {
        let found = made.continued(kind).expect("a surface");
        assert!(made.depth_error_mm(&found).abs() < 0.01, "{}", made.depth_error_mm(&found));
    }
}

#[test]
fn another_kind_is_refused() {
    let other =
        |made: &Made, kind: SurfaceKind| matches!(made.continued(kind), Err(ContinuationError::OtherKind { .. }));
    assert!(other(&cylinder(NOISE_MM, 0.02, 120.0, 1.0), SurfaceKind::Plane));
    assert!(other(&vase(NOISE_MM), SurfaceKind::Cylinder));
    assert!(other(&vase(NOISE_MM), SurfaceKind::Extruded));
    assert!(other(&saddle(NOISE_MM), SurfaceKind::Extruded));
    assert!(other(&wave(NOISE_MM), SurfaceKind::Cylinder));
    // Two planes at 20°, one twice as large.
    let wedge = Made::new(9_000, NOISE_MM, 1.0, |a, b| {
        let x = 60.0 * a - 24.0;
        let (z, n) = if x < 0.0 { (0.0, Vector3::z()) } else { (0.36 * x, Vector3::new(-0.36, 0.0, 1.0).normalize()) };
        (Point3::new(x, 40.0 * b, z), n, 100.0)
    });
    assert!(other(&wedge, SurfaceKind::Plane));
}

#[test]
fn what_the_points_do_not_tell_is_refused() {
    let strip = cylinder(NOISE_MM, 0.02, 5.0, 1.0).continued(SurfaceKind::Cylinder);
    assert!(matches!(strip, Err(ContinuationError::ArcTooShort { .. })), "{strip:?}");
    let flat = plane(NOISE_MM, 0.02).continued(SurfaceKind::Extruded);
    assert!(matches!(flat, Err(ContinuationError::AxisOpen { .. })), "{flat:?}");
    let flat = plane(NOISE_MM, 0.02).continued(SurfaceKind::Cylinder);
    assert!(flat.is_err(), "{flat:?}");
    // A strip of sound points beside a damage ten times as wide.
    let mut made = saddle(NOISE_MM);
    for (state, p) in made.state.iter_mut().zip(&made.points) {
        *state = if p.x < -20.0 { PointState::Sound } else { PointState::Damaged };
    }
    let far = made.continued(SurfaceKind::Smooth);
    assert!(matches!(far, Err(ContinuationError::GapTooWide { .. })), "{far:?}");
    let none = Made { noise_mm: 0.1, ..Made::default() }.continued(SurfaceKind::Plane);
    assert_eq!(none, Err(ContinuationError::TooFewPoints { sound: 0 }));
    let one = Made { points: vec![Point3::origin()], ..Made::default() }.continued(SurfaceKind::Plane);
    assert_eq!(one, Err(ContinuationError::NoRegion));
}

/// All kinds on points that are no numbers, in one place, or on a line: refused, and no panic.
#[test]
fn points_that_are_no_surface_are_refused() {
    let line = |k: f64| Point3::new(k, 2.0 * k, -k);
    let places: [&dyn Fn(f64) -> Point3<f64>; 4] =
        [&|_| Point3::new(f64::NAN, 0.0, 0.0), &|_| Point3::new(1.0, 2.0, 3.0), &line, &|k| line(1e300 * k)];
    for place in places {
        for kind in [
            SurfaceKind::Plane,
            SurfaceKind::Cylinder,
            SurfaceKind::Revolved,
            SurfaceKind::Extruded,
            SurfaceKind::Smooth,
        ] {
            let made = Made {
                points: (0..90).map(|k| place(f64::from(k))).collect(),
                normals: vec![Vector3::z(); 90],
                state: vec![PointState::Sound; 90],
                noise_mm: 0.1,
                ..Made::default()
            };
            let found = made.continued(kind);
            assert!(found.is_err(), "{kind:?}: {found:?}");
        }
    }
}

#[test]
fn the_work_ends_when_it_is_cancelled() {
    let made = vase(NOISE_MM);
    for looks in [1, 10, 30] {
        let found = continued(&made.region(), SurfaceKind::Revolved, &Progress::ending_after(looks));
        assert_eq!(found, Err(ContinuationError::Cancelled), "{looks}");
    }
}

/// A grid without noise, marked at a fifth of its depth: after the repair no neighbours differ by more than the noise.
#[test]
fn the_rim_of_a_repair_has_no_step() {
    let mut made = Made { noise_mm: 0.03, ..Made::default() };
    for i in 0..14_641 {
        let (x, y) = (0.5 * f64::from(i % 121) - 30.0, 0.5 * f64::from(i / 121) - 30.0);
        let worn = worn_mm((x * x + y * y).sqrt());
        made.points.push(Point3::new(x, y, -worn));
        made.normals.push(Vector3::z());
        made.state.push(if worn > 0.04 { PointState::Damaged } else { PointState::Sound });
    }
    let found = made.continued(SurfaceKind::Plane).expect("a plane");
    let repaired = found.repaired(&made.region(), &Progress::default()).expect("nobody cancels");
    let step = |i: usize, j: usize| (repaired[i].z - repaired[j].z).abs();
    let steps = (0..14_640).filter(|i| i % 121 < 120).map(|i| step(i, i + 1));
    let steepest = steps.fold(0.0, f64::max);
    assert!(steepest < found.rms_mm.max(1e-3), "{steepest}, {}", found.rms_mm);
    let deepest = made.state.iter().zip(&repaired).filter(|(s, _)| **s == PointState::Damaged);
    assert!(deepest.fold(0.0, |most: f64, (_, p)| most.max(p.z.abs())) < 0.002);
    assert_eq!(repaired[0], made.points[0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5))]
    /// A region that is moved continues where it was moved to.
    #[test]
    fn a_motion_of_the_region_moves_the_surface(turn in prop::array::uniform3(-3.0..3.0f64), shift in prop::array::uniform3(-200.0..200.0f64), which in 0..5usize) {
        let motion = Isometry3::new(Vector3::from(shift), Vector3::from(turn));
        let (made, kind) = match which {
            0 => (plane(NOISE_MM, 0.02), SurfaceKind::Plane),
            1 => (cylinder(NOISE_MM, 0.02, 120.0, 1.0), SurfaceKind::Cylinder),
            2 => (vase(NOISE_MM), SurfaceKind::Revolved),
            3 => (wave(NOISE_MM), SurfaceKind::Extruded),
            _ => (saddle(NOISE_MM), SurfaceKind::Smooth),
        };
        let moved = Made {
            points: made.points.iter().map(|p| motion * p).collect(),
            normals: made.normals.iter().map(|n| motion * n).collect(),
            ..made.clone()
        };
        let (one, other) = (made.continued(kind).expect("a surface"), moved.continued(kind).expect("a surface"));
        for p in made.truth.iter().step_by(97) {
            let (foot, normal) = one.closest(p).expect("a foot");
            let (foot_moved, normal_moved) = other.closest(&(motion * p)).expect("a foot");
            prop_assert!((motion * foot - foot_moved).norm() < 2e-3, "{}", (motion * foot - foot_moved).norm());
            prop_assert!((motion * normal - normal_moved).norm() < 1e-3);
        }
    }
}
