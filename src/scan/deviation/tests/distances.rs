//! Distances of single points.

use super::*;

/// A mesh's own samples lie on it, whatever its facets look like, and samples put off it lie off by that much: the
/// cube's beside its edges, the needles of a cone's and a cylinder's ends, the knife edges of a fin.
#[test]
fn samples_off_a_mesh_are_off_by_as_much() {
    let shapes = [
        solids::cube(30.0),
        solids::cone(10.0, 40.0, 200),
        solids::cylinder(20.0, 100.0, 300),
        solids::sphere(15.0, 40, 30),
        solids::v_groove(15.0, 20.0, 0.5, 40.0),
    ];
    for (i, shape) in shapes.iter().enumerate() {
        let part = part_of(shape);
        let (up_to, mut draw) = (sums(&part.mesh), Draw(i as u64));
        let drawn: Vec<_> = (0..4000).map(|_| draw.on(&part.mesh, &up_to)).collect();
        let points: Vec<_> = drawn.iter().map(|d| d.0).collect();
        let (_, own) = measured(&part, &points);
        // Places of a cloud are f32 offsets from the middle of its box: 4 µm at 50 mm.
        let largest = own.signed_mm.iter().fold(0f32, |m, d| m.max(d.abs()));
        assert!(largest < 5e-6, "shape {i}: {largest}");
        for h in [0.01, -0.01] {
            let moved: Vec<_> = drawn.iter().map(|(p, f)| p + part.mesh.normals[*f] * h).collect();
            let (cloud, off) = measured(&part, &moved);
            let mut counted = 0;
            for (k, (_, f)) in drawn.iter().enumerate() {
                // Near an edge another facet may be nearer, and the point even beyond it: the foot is told on another
                // plane.
                let foot = off.foot(&part, &cloud, k as u32).expect("near");
                let [a, ..] = part.mesh.corners(*f);
                if ((foot - a).dot(&part.mesh.normals[*f])).abs() < 1e-6 {
                    counted += 1;
                    assert!((f64::from(off.signed_mm[k]) - h).abs() < 5e-6, "shape {i}: {} for {h}", off.signed_mm[k]);
                } else {
                    assert!(f64::from(off.signed_mm[k]).abs() < h.abs() + 5e-6);
                }
            }
            assert!(counted > 3900, "shape {i}: {counted}");
        }
    }
}

/// Outside and inside of rounds, where the distance is known: to the mesh it is less by the sagitta at most.
#[test]
fn distances_from_rounds_are_those_of_the_formula() {
    let (sphere, cylinder, cone) = (
        part_of(&solids::sphere(15.0, 180, 90)),
        part_of(&solids::cylinder(20.0, 60.0, 360)),
        part_of(&solids::cone(10.0, 24.0, 360)),
    );
    let mut draw = Draw(11);
    let slope = 26.0; // Of the cone: legs 10 and 24.
    let mut sets: [Vec<(Point3<f64>, f64)>; 3] = Default::default();
    for _ in 0..3000 {
        let (angle, off) = (std::f64::consts::TAU * draw.even(), 4.0 * draw.even() - 2.0);
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let z = 2.0 * draw.even() - 1.0;
        let level = (1.0f64 - z * z).sqrt();
        sets[0].push((Point3::from(Vector3::new(level * cos, level * sin, z) * (15.0 + off)), off));
        sets[1].push((Point3::new((20.0 + off) * cos, (20.0 + off) * sin, 10.0 + 40.0 * draw.even()), off));
        // Of the cone's skin at a share of its height, off along its normal.
        let up = 0.3 + 0.4 * draw.even();
        let (r, n) = (10.0 * (1.0 - up), [24.0 / slope, 10.0 / slope]);
        let out = r + off * n[0];
        sets[2].push((Point3::new(out * cos, out * sin, 24.0 * up + off * n[1]), off));
    }
    for (part, (set, sagitta)) in [sphere, cylinder, cone].iter().zip(sets.iter().zip([0.0095, 0.0008, 0.0004])) {
        let points: Vec<_> = set.iter().map(|s| s.0).collect();
        let (_, deviation) = measured(part, &points);
        for (found, (p, off)) in deviation.signed_mm.iter().zip(set) {
            let excess = f64::from(*found) - off;
            assert!((-1e-5..sagitta + 1e-5).contains(&excess), "{p}: {found} for {off}");
        }
    }
}

#[test]
fn beside_a_sheet_there_is_no_model_and_far_from_it_nothing() {
    let part = part_of(&sheet(20.0));
    let points =
        [[1.0, 2.0, 0.3], [1.0, 2.0, -0.3], [12.0, 0.0, 0.3], [11.0, 11.0, 0.0], [0.0, 0.0, 5.5], [9.999, 0.0, -0.2]];
    let (cloud, deviation) = measured(&part, &points.map(Point3::from));
    use Footing::{Far, NoModel, OnModel};
    assert_eq!(deviation.footing, [OnModel, OnModel, NoModel, NoModel, Far, OnModel]);
    assert!((deviation.signed_mm[0] - 0.3).abs() < 1e-6 && (deviation.signed_mm[1] + 0.3).abs() < 1e-6);
    assert!(deviation.signed_mm[2].is_nan() && deviation.signed_mm[4].is_nan());
    assert_eq!(deviation.foot(&part, &cloud, 4), None);
    let plane = Plane { through: Point3::new(1.0, 0.0, 0.0), normal: Vector3::x_axis() };
    let section = deviation.section(&cloud, &plane, 0.5);
    assert_eq!(section.iter().map(|s| s.index).collect::<Vec<_>>(), [0, 1]);
    assert!((section[1].at - Point3::new(1.0, 2.0, -0.3)).norm() < 1e-6);
    let statistics = DeviationStatistics::of(&deviation);
    assert_eq!((statistics.count(), statistics.no_model, statistics.far), (3, 2, 1));
}

#[test]
fn threads_and_the_order_of_points_change_nothing() {
    let part = part_of(&solids::sphere(15.0, 60, 40));
    let (up_to, mut draw) = (sums(&part.mesh), Draw(5));
    let mut points: Vec<_> = (0..5000).map(|_| draw.on(&part.mesh, &up_to).0 * (1.0 + 0.01 * draw.normal())).collect();
    let (_, one) = measured(&part, &points);
    points.reverse();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(5).build().expect("threads");
    let (_, other) = pool.install(|| measured(&part, &points));
    assert!(one.signed_mm.iter().eq(other.signed_mm.iter().rev()) && one.facet.iter().eq(other.facet.iter().rev()));
}

#[test]
fn cancelled_work_ends() {
    let part = part_of(&solids::cube(10.0));
    let progress = Progress::default();
    progress.cancel();
    let cloud = Cloud::of_points(&[Point3::origin()]);
    assert_eq!(Deviation::new(&part, &cloud, &DeviationRules { within_mm: 1.0 }, &progress), Err(Cancelled));
}
