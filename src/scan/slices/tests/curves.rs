//! Curves beside the closed forms of their sections.

use super::*;

/// A face at 30° to the plane: points of the band, dropped square to it, would smear by 0.8 mm. Carried along the face
/// they are on the line, to the rounding of single floats.
#[test]
fn a_sloping_face_does_not_smear() {
    let slope = libm::tan(30f64.to_radians());
    let normal = Vector3::new(-slope, 0.0, 1.0).normalize();
    let points = made(9_000, [30.0, 30.0], |x, y| (Point3::new(x, y, slope * x), normal));
    let found = cut(&cloud(&points, 0.0), &[plane([0.0, 0.0, 1.0], 15.0 * slope)], &RULES);
    let [curve] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    for p in &curve.points {
        assert!((p.place.x - 15.0).abs() < 1e-4 && (p.outward - normal).norm() < 1e-4, "{p:?}");
        // Along (outward) × (plane's normal).
        assert!((p.tangent - Vector3::new(0.0, 1.0, 0.0)).norm() < 1e-4, "{}", p.tangent);
    }
    let ends = [curve.points[0].place.y, curve.points[curve.points.len() - 1].place.y];
    assert!(!curve.closed && ends[0] < 0.5 && ends[1] > 29.5, "{ends:?}");
}

/// The curve of ten points a mm² with 0.03 mm of noise is within half of that, and the noise is told.
#[test]
fn noise_is_smoothed_and_told() {
    let points = made(9_000, [30.0, 30.0], |x, y| (Point3::new(x, y, 0.0), Vector3::z()));
    let found = cut(&cloud(&points, 0.03), &[plane([1.0, 0.3, 0.0], 14.0), plane([1.0, 0.0, 1.0], 9.0)], &RULES);
    // In a plane at 45° to the face noise is √2 as large.
    for (slice, times) in found.iter().zip([1.0, 1.414]) {
        let [curve] = slice.curves.as_slice() else { panic!("{}", slice.curves.len()) };
        assert!(rms(curve, |p| p.place.z) < 0.015 && curve.max_residual_mm < 0.15, "{}", rms(curve, |p| p.place.z));
        assert!((curve.rms_mm / (0.03 * times) - 1.0).abs() < 0.15, "{}", curve.rms_mm);
        assert!(rms(curve, |p| p.noise_mm / 0.03 / times - 1.0) < 0.3);
        assert!(curve.points.iter().all(|p| p.outward.z > 0.99), "{curve:?}");
    }
}

#[test]
fn a_sphere_is_cut_in_circles_all_the_way_round() {
    let cloud = cloud(&sphere(15.0, 10.0), 0.03);
    let tilted = Vector3::new(0.3, -0.5, 0.8).normalize();
    let planes = [-12.0, -6.0, 0.0, 5.0, 11.0].map(|h| plane(tilted.into(), h));
    for (slice, plane) in cut(&cloud, &planes, &RULES).iter().zip(planes) {
        let [curve] = slice.curves.as_slice() else { panic!("{}", slice.curves.len()) };
        let middle = Point3::from(tilted * plane.offset_mm);
        let radius = (225.0 - plane.offset_mm * plane.offset_mm).sqrt();
        let off = |p: &SlicePoint| (p.place - middle).norm() - radius;
        assert!(curve.closed && rms(curve, off) < 0.015, "{} {}", plane.offset_mm, rms(curve, off));
        let mean = curve.points.iter().map(off).sum::<f64>() / curve.points.len() as f64;
        // No side: what is round across the band is not counted as outside. n points of the band leave σ/√n.
        let standard_error = 0.03 * 15.0 / radius / (curve.fitted_points as f64).sqrt();
        assert!(mean.abs() < 4.0 * standard_error, "{mean} {standard_error}");
        for p in &curve.points {
            assert!((tilted.dot(&p.place.coords) - plane.offset_mm).abs() < 1e-9);
            assert!((p.outward - p.place.coords / 15.0).norm() < 0.05, "{}", p.outward);
            assert!(p.tangent.dot(&p.outward).abs() < 1e-9 && p.tangent.dot(&tilted).abs() < 1e-9);
        }
        assert!(slice.left_over < 20, "{}", slice.left_over);
    }
}

#[test]
fn a_cylinder_across_is_a_circle_and_along_two_lines() {
    let cloud = cloud(&cylinder(8.0, 10.0), 0.03);
    let found = cut(&cloud, &[plane([0.0, 0.0, 1.0], 17.3), plane([1.0, 0.0, 0.0], 2.0)], &RULES);
    let [circle] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    let off = |p: &SlicePoint| libm::hypot(p.place.x, p.place.y) - 8.0;
    assert!(circle.closed && rms(circle, off) < 0.012, "{}", rms(circle, off));
    let [a, b] = found[1].curves.as_slice() else { panic!("{}", found[1].curves.len()) };
    for line in [a, b] {
        let off = |p: &SlicePoint| p.place.y.abs() - 60f64.sqrt();
        assert!(!line.closed && rms(line, off) < 0.015 && line.points[0].outward.x > 0.2, "{}", rms(line, off));
    }
    // Outward × plane's normal: on the side of +y that is −z.
    assert!([a, b].iter().all(|l| l.points[0].tangent.z * l.points[0].place.y < 0.0));
}

#[test]
fn a_torus_is_cut_in_two_circles_either_way() {
    let (ring, tube) = (12.0, 4.0);
    // As many points as the outermost ring is long; those of shorter ones too many are left out.
    let mut numbers = Sequence::new(5);
    let all = made(30_000, [TAU, TAU], |turn, about| {
        let out = Vector3::new(libm::cos(turn), libm::sin(turn), 0.0);
        let normal = out * libm::cos(about) + Vector3::z() * libm::sin(about);
        (Point3::from(out * ring + normal * tube), normal)
    });
    let share = |p: &Point3<f64>| libm::hypot(p.x, p.y) / (ring + tube);
    let points: Vec<_> = all.into_iter().filter(|p| numbers.uniform() < share(&p.0)).collect();
    let found = cut(&cloud(&points, 0.02), &[plane([0.0, 0.0, 1.0], 1.0), plane([0.0, 1.0, 0.0], 0.0)], &RULES);
    let across = (tube * tube - 1.0f64).sqrt();
    let [a, b] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    let radii =
        [a, b].map(|c| c.points.iter().map(|p| libm::hypot(p.place.x, p.place.y)).sum::<f64>() / c.points.len() as f64);
    let (outer, inner) = (radii[0].max(radii[1]), radii[0].min(radii[1]));
    assert!(
        a.closed && b.closed && (outer - ring - across).abs() < 0.005 && (inner - ring + across).abs() < 0.005,
        "{radii:?}"
    );
    let [a, b] = found[1].curves.as_slice() else { panic!("{}", found[1].curves.len()) };
    for curve in [a, b] {
        let off = |p: &SlicePoint| libm::hypot(p.place.x.abs() - ring, p.place.z) - tube;
        assert!(curve.closed && rms(curve, off) < 0.015, "{}", rms(curve, off));
    }
}

/// A square bar: round all corners in one, no further off than a spacing there and within the noise elsewhere.
#[test]
fn corners_are_gone_round() {
    let mut points = Vec::new();
    for (out, along) in [(Vector3::x(), Vector3::y()), (Vector3::y(), -Vector3::x())] {
        for sign in [1.0, -1.0] {
            points.extend(made(4_000, [20.0, 20.0], |u, z| {
                (Point3::from((out * 10.0 + along * (u - 10.0)) * sign + Vector3::z() * z), out * sign)
            }));
        }
    }
    let found = cut(&cloud(&points, 0.02), &[plane([0.0, 0.0, 1.0], 9.0)], &RULES);
    let [curve] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    assert!(curve.closed);
    for p in &curve.points {
        let (x, y) = (p.place.x.abs(), p.place.y.abs());
        let off = x.max(y) - 10.0;
        let limit = if x.min(y) > 8.5 { 0.35 } else { 0.03 };
        assert!(off.abs() < limit, "{off} {}", p.place);
    }
}

/// Both faces of a wall thinner than two spacings are curves of their own where the normals have sides.
#[test]
fn faces_of_a_thin_wall_are_told_apart_by_their_normals() {
    let face =
        |y: f64| move |x: f64, z: f64| (Point3::new(x, y, z), Vector3::new(0.0, if y > 0.0 { 1.0 } else { -1.0 }, 0.0));
    let mut points = made(4_000, [20.0, 20.0], face(0.3));
    points.extend(made(4_000, [20.0, 20.0], face(-0.3)));
    let cloud = cloud(&points, 0.01);
    let progress = Progress::default();
    let neighbours = Neighbours::new(&cloud, &progress).expect("nobody cancels");
    // Those of the faces: planes through 20 neighbours would lie across the wall.
    let normals = cloud.normals.clone().expect("they were made with it");
    let found = slices(&cloud, &neighbours, &normals, &[plane([0.0, 0.0, 1.0], 9.0)], &RULES, &progress);
    let found = found.expect("nobody cancels");
    let [a, b] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    for curve in [a, b] {
        assert!(rms(curve, |p| p.place.y - 0.3 * p.outward.y) < 0.01, "{curve:?}");
    }
    assert!(a.points[0].outward.y * b.points[0].outward.y < 0.0);
}

/// A wave cut across its crests: points close where it bends, no chord further off than allowed, no step too long.
#[test]
fn points_stand_closer_where_the_curve_bends() {
    let wave = |x: f64| 2.0 * libm::sin(x);
    let points = made(40_000, [25.0, 20.0], |x, y| {
        (Point3::new(x, y, wave(x)), Vector3::new(-2.0 * libm::cos(x), 0.0, 1.0).normalize())
    });
    let rules = SliceRules { step_mm: 2.0, chord_mm: 0.02, ..RULES };
    let found = cut(&cloud(&points, 0.005), &[plane([0.0, 1.0, 0.0], 9.0)], &rules);
    let [curve] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    assert!(rms(curve, |p| p.place.z - wave(p.place.x)) < 0.01, "{}", rms(curve, |p| p.place.z - wave(p.place.x)));
    let mut steps: Vec<f64> = Vec::new();
    for pair in curve.points.windows(2) {
        let (a, b) = (pair[0].place, pair[1].place);
        let chord = (b - a).normalize();
        let off = |k: u32| {
            let x = a.x + (b.x - a.x) * f64::from(k) / 20.0;
            let d = Point3::new(x, 9.0, wave(x)) - a;
            (d - chord * d.dot(&chord)).norm()
        };
        // The noise of the curve beside what the chord may be off.
        assert!((0..=20).map(off).fold(0.0, f64::max) < 0.02 + 0.015);
        steps.push((b - a).norm());
    }
    steps.sort_by(f64::total_cmp);
    assert!(steps[steps.len() - 1] <= 2.0 && steps[0] < 0.5 && steps.len() < 80, "{steps:?}");
}
