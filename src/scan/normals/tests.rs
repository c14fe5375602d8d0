//! Normals beside the eigenvectors of nalgebra, and on surfaces whose normals are known.

use super::*;
use nalgebra::SymmetricEigen;
use proptest::prelude::*;

proptest! {
    /// The vector's Rayleigh quotient is the smallest eigenvalue; also of nearly flat, long and round clouds.
    #[test]
    fn the_plane_is_that_of_the_least_squares(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 4..30),
        sides in prop::array::uniform3(-5.0..0.0f64), turn in prop::array::uniform3(-3.0..3.0f64),
    ) {
        let rotation = nalgebra::Rotation3::new(Vector3::from(turn));
        let at = |p: &[f64; 3]| {
            let sized = Vector3::from_fn(|k, _| p[k] * libm::pow(10.0, if k == 0 { 0.0 } else { sides[k] }));
            Point3::new(50.0, -20.0, 7.0) + rotation * sized
        };
        let points: Vec<Point3<f64>> = points.iter().map(at).collect();
        let count = points.len() as f64;
        let middle = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / count;
        let scatter = points.iter().fold(Matrix3::zeros(), |s, p| {
            let d = p.coords - middle;
            s + d * d.transpose() / count
        });
        let mut eigen: Vec<f64> = SymmetricEigen::new(scatter).eigenvalues.iter().copied().collect();
        eigen.sort_by(f64::total_cmp);
        match plane_through(points.iter().copied()) {
            None => prop_assert!(eigen[1] < 2.0 * ON_A_LINE * eigen[2]),
            Some(plane) => {
                let along = plane.normal.dot(&(scatter * plane.normal));
                prop_assert!((plane.normal.norm() - 1.0).abs() < 1e-12);
                prop_assert!((along - eigen[0]).abs() < 1e-10 * eigen[2], "{along} {eigen:?}");
                prop_assert!((plane.variance_mm2 - eigen[0]).abs() < 1e-10 * eigen[2]);
                prop_assert!((plane.middle.coords - middle).norm() < 1e-9);
            }
        }
    }
}

fn normals(cloud: &Cloud) -> Vec<[f32; 3]> {
    let progress = Progress::default();
    let neighbours = Neighbours::new(cloud, &progress).expect("nobody cancels");
    fitted_normals(cloud, &neighbours, 12, &progress).expect("nobody cancels")
}

#[test]
fn a_balls_normals_are_radial_and_outward_or_as_the_scanner_said() {
    // Spiral of Fibonacci: 2 000 points evenly on a ball of 10 mm; the planes' points lie within 1 mm, so the normals
    // are off by less than a few hundredths.
    let points: Vec<Point3<f64>> = (0..2000)
        .map(|i| {
            let z = 1.0 - (f64::from(i) + 0.5) / 1000.0;
            let (sin, cos) = libm::sincos(2.399_963_229_728_653 * f64::from(i));
            let r = (1.0 - z * z).sqrt();
            Point3::new(10.0 * r * cos, 10.0 * r * sin, 10.0 * z)
        })
        .collect();
    let mut cloud = Cloud::of_points(&points);
    for inward in [false, true] {
        for (n, p) in normals(&cloud).iter().zip(&points) {
            let radial = Vector3::from(n.map(f64::from)).dot(&p.coords) / 10.0;
            let radial = if inward { -radial } else { radial };
            assert!(radial > 0.999, "{p}: {n:?}");
        }
        cloud.normals = Some(points.iter().map(|p| (p.coords * -0.1).map(|c| c as f32).into()).collect());
    }
}

#[test]
fn points_on_a_line_and_too_few_have_no_normal() {
    let line: Vec<Point3<f64>> = (0..40).map(|i| Point3::new(0.3, 0.1, 0.7) * f64::from(i)).collect();
    assert!(normals(&Cloud::of_points(&line)).iter().all(|n| *n == [0.0; 3]));
    assert_eq!(normals(&Cloud::of_points(&line[..2])), [[0.0; 3]; 2]);
    assert!(normals(&Cloud::default()).is_empty());
    let alike = vec![Point3::new(1.0, 2.0, 3.0); 30];
    assert_eq!(normals(&Cloud::of_points(&alike)), [[0.0; 3]; 30]);
}
