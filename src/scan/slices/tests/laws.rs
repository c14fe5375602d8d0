//! What holds of all slices: gaps stay gaps, motions move them, threads change nothing, nothing panics.

use super::*;
use nalgebra::Isometry3;
use proptest::prelude::*;

#[test]
fn nothing_is_bridged_where_nothing_was_scanned() {
    // Spacing 0.32 mm: a gap of 4 mm is one, lines along the other way go on beside it, and a hole of 0.9 mm is none.
    let is_missing = |x: f64, y: f64| (x > 12.0 && x < 16.0 && y < 20.0) || (x - 22.0).abs() < 0.45;
    let mut points = made(9_000, [30.0, 30.0], |x, y| (Point3::new(x, y, 0.0), Vector3::z()));
    points.retain(|p| !is_missing(p.0.x, p.0.y));
    let found = cut(&cloud(&points, 0.01), &[plane([0.0, 1.0, 0.0], 10.0), plane([0.0, 1.0, 0.0], 25.0)], &RULES);
    let ends = |c: &SliceCurve| {
        let all = c.points.iter().map(|p| p.place.x);
        [all.clone().fold(f64::INFINITY, f64::min), all.fold(f64::NEG_INFINITY, f64::max)]
    };
    let mut cut_ends: Vec<[f64; 2]> = found[0].curves.iter().map(ends).collect();
    cut_ends.sort_by(|a, b| a[0].total_cmp(&b[0]));
    assert_eq!(cut_ends.len(), 2, "{cut_ends:?}");
    assert!(cut_ends[0][0] < 0.5 && (cut_ends[0][1] - 12.0).abs() < 0.5, "{cut_ends:?}");
    assert!((cut_ends[1][0] - 16.0).abs() < 0.5 && cut_ends[1][1] > 29.5, "{cut_ends:?}");
    assert_eq!(found[1].curves.len(), 1);
}

/// A ring with a gap is an open curve from one side of it to the other.
#[test]
fn a_ring_with_a_gap_is_open_there() {
    let mut points = cylinder(8.0, 10.0);
    points.retain(|p| !(p.0.x > 0.0 && p.0.y.abs() < 2.0));
    let found = cut(&cloud(&points, 0.01), &[plane([0.0, 0.0, 1.0], 20.0)], &RULES);
    let [curve] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    let ends = [curve.points[0].place, curve.points[curve.points.len() - 1].place];
    assert!(!curve.closed && ends.iter().all(|p| p.x > 7.0 && (p.y.abs() - 2.0).abs() < 0.5), "{ends:?}");
}

/// Points in the air, one to forty of the part's, make no curves.
#[test]
fn stray_points_make_no_curves() {
    let mut points = sphere(10.0, 5.0);
    let stray = made(150, [40.0, 40.0], |x, y| (Point3::new(x - 20.0, y - 20.0, 0.0), Vector3::z()));
    let mut numbers = Sequence::new(9);
    points.extend(stray.into_iter().map(|(p, n)| (p + Vector3::z() * (40.0 * numbers.uniform() - 20.0), n)));
    let planes: Vec<SlicePlane> = (0..9).map(|i| plane([0.0, 0.0, 1.0], 1.5 * f64::from(i) - 6.0)).collect();
    for slice in cut(&cloud(&points, 0.02), &planes, &RULES) {
        let [curve] = slice.curves.as_slice() else { panic!("{}", slice.curves.len()) };
        assert!(
            rms(curve, |p| p.place.coords.norm() - 10.0) < 0.04,
            "{}",
            rms(curve, |p| p.place.coords.norm() - 10.0)
        );
    }
}

/// Half of a face has a sixteenth of the other's points: bands are as wide as each needs, and the curve goes on.
#[test]
fn uneven_density_is_one_curve() {
    let mut points = made(16_000, [20.0, 20.0], |x, y| (Point3::new(x, y, 0.0), Vector3::z()));
    points.extend(made(1_000, [20.0, 20.0], |x, y| (Point3::new(x + 20.0, y, 0.0), Vector3::z())));
    let found = cut(&cloud(&points, 0.02), &[plane([0.0, 1.0, 0.0], 10.0)], &RULES);
    let [curve] = found[0].curves.as_slice() else { panic!("{}", found[0].curves.len()) };
    assert!(rms(curve, |p| p.place.z) < 0.012, "{}", rms(curve, |p| p.place.z));
    let (first, last) = (curve.points[0].place.x, curve.points[curve.points.len() - 1].place.x);
    assert!(first.min(last) < 0.5 && first.max(last) > 39.0, "{first} {last}");
}

/// Without trusted sides curves of a closed bowl's inside are turned to where they are seen from.
#[test]
fn curves_are_turned_to_the_side_that_they_are_seen_from() {
    let mut points = sphere(15.0, 6.0);
    points.retain(|p| p.0.z < -3.0);
    let cloud = Cloud { normals: None, ..cloud(&points, 0.02) };
    let rules = SliceRules { outward: OutwardSide::Towards(Vector3::z()), ..RULES };
    let found = cut(&cloud, &[plane([1.0, 0.2, 0.0], 3.0), plane([0.0, 0.0, 1.0], -7.0)], &rules);
    for slice in &found {
        let [curve] = slice.curves.as_slice() else { panic!("{}", slice.curves.len()) };
        assert!(curve.points.iter().all(|p| p.outward.dot(&p.place.coords) < -14.0), "{curve:?}");
    }
    assert!(found[1].curves[0].closed);
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let cloud = cloud(&sphere(8.0, 10.0), 0.03);
    let planes: Vec<SlicePlane> = (0..15).map(|i| plane([0.1, 0.2, 0.9], f64::from(i) - 7.0)).collect();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| format!("{:?}", cut(&cloud, &planes, &RULES)))
    };
    assert_eq!(on(1), on(4));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]
    /// A moved cloud is cut by moved planes in moved curves. Densities are told in boxes that do not turn with it, so curves
    /// are the same within a fraction of the noise and not to the last digit.
    #[test]
    fn moved_clouds_have_moved_slices(turn in prop::array::uniform3(-3.0..3.0f64),
                                      shift in prop::array::uniform3(-300.0..300.0f64)) {
        let motion = Isometry3::new(Vector3::from(shift), Vector3::from(turn));
        let cloud = cloud(&cylinder(6.0, 4.0), 0.02);
        let still = plane([0.1, 0.2, 0.9], 18.0);
        let normal = Unit::new_normalize(motion * still.normal.into_inner());
        let offset_mm = still.offset_mm + normal.dot(&motion.translation.vector);
        let moved = cut(&cloud.clone().moved(&motion), &[SlicePlane { normal, offset_mm }], &RULES);
        let axis = |p: &SlicePoint| {
            let back = motion.inverse() * p.place;
            libm::hypot(back.x, back.y) - 6.0
        };
        let [curve] = moved[0].curves.as_slice() else { panic!("{}", moved[0].curves.len()) };
        prop_assert!(curve.closed && rms(curve, axis) < 0.015, "{}", rms(curve, axis));
        let first = &cut(&cloud, &[still], &RULES)[0].curves[0];
        let round = |c: &SliceCurve| (0..c.points.len())
            .map(|i| (c.points[(i + 1) % c.points.len()].place - c.points[i].place).norm()).sum::<f64>();
        prop_assert!((round(first) / round(curve) - 1.0).abs() < 1e-3);
    }

    /// Whatever the cloud and the rules are, it ends and tells numbers.
    #[test]
    fn nothing_panics(places in prop::collection::vec(prop::array::uniform3(prop_oneof![
                          8 => -3.0..3.0f64, 1 => Just(f64::NAN), 1 => Just(f64::INFINITY), 1 => Just(1e30), 1 => Just(0.0)]), 0..300),
                      numbers in prop::array::uniform4(prop_oneof![4 => 0.01..2.0f64, 1 => Just(f64::NAN), 1 => Just(0.0), 1 => Just(f64::INFINITY)])) {
        let points: Vec<Point3<f64>> = places.into_iter().map(Point3::from).collect();
        let [step_mm, chord_mm, tolerance_mm, offset_mm] = numbers;
        let rules = SliceRules { step_mm, chord_mm, tolerance_mm, outward: OutwardSide::Towards(Vector3::z()) };
        let origin = Point3::origin();
        let offsets = points.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect();
        let cloud = Cloud { origin, offsets, ..Cloud::default() };
        for slice in cut(&cloud, &[plane([0.2, 0.3, 0.8], offset_mm), plane([1.0, 0.0, 0.0], 0.0)], &rules) {
            for p in slice.curves.iter().flat_map(|c| &c.points) {
                prop_assert!(p.place.iter().chain(&p.tangent).chain(&p.outward).all(|x| x.is_finite()));
            }
        }
    }
}

#[test]
fn no_points_or_one_make_no_curve_and_a_wish_to_end_is_heard() {
    for points in [vec![], vec![Point3::new(1.0, 2.0, 3.0)], vec![Point3::new(1.0, 2.0, 3.0); 50]] {
        let found = cut(&Cloud::of_points(&points), &[plane([0.0, 0.0, 1.0], 3.0)], &RULES);
        assert_eq!(found, [CloudSlice::default()]);
    }
    let cloud = cloud(&sphere(5.0, 5.0), 0.0);
    let neighbours = Neighbours::new(&cloud, &Progress::default()).expect("nobody cancels");
    let normals = cloud.normals.clone().expect("they were made with it");
    let ended = |looks| {
        let planes = [plane([0.0, 0.0, 1.0], 0.0)];
        slices(&cloud, &neighbours, &normals, &planes, &RULES, &Progress::ending_after(looks))
    };
    assert_eq!((ended(1), ended(14)), (Err(Cancelled), Err(Cancelled)));
}
