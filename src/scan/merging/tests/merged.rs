//! One cloud of several.

use super::super::*;
use nalgebra::Point3;
use proptest::prelude::*;

const PLACES: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [0.0, 80.0, 0.0], [40.0, 30.0, 60.0]];

proptest! {
    #[test]
    fn points_and_normals_come_into_the_common_frame(turn in prop::array::uniform3(-3.0..3.0f64),
                                                     shift in prop::array::uniform3(-500.0..500.0f64)) {
        let motion = Isometry3::new(Vector3::from(shift), Vector3::from(turn));
        let scan = Cloud::of_points(&PLACES.map(Point3::from));
        let scan = Cloud { normals: Some(vec![[0.0, 0.0, 1.0]; 4]), ..scan };
        let other = scan.clone().moved(&motion);
        let both = merged(&[(&other, Isometry3::identity()), (&scan, motion)], &Progress::default());
        let both = both.expect("nobody cancels");
        for (i, place) in PLACES.into_iter().enumerate() {
            prop_assert!((both.point(i) - both.point(i + 4)).norm() < 1e-3);
            prop_assert!((both.point(i) - motion * Point3::from(place)).norm() < 1e-3);
            let normals = both.normal(i).zip(both.normal(i + 4)).expect("both have them");
            prop_assert!((normals.0 - normals.1).norm() < 1e-6);
        }
    }
}

#[test]
fn what_not_all_scans_have_is_left_out() {
    let plain = Cloud::of_points(&[Point3::origin()]);
    let coloured = Cloud { colours: Some(vec![[1, 2, 3]]), intensities: Some(vec![0.5]), ..plain.clone() };
    let still = Isometry3::identity();
    let of = |scans: &[(&Cloud, Isometry3<f64>)]| merged(scans, &Progress::default()).expect("nobody cancels");
    assert_eq!(of(&[(&plain, still), (&coloured, still)]).colours, None);
    let both = of(&[(&coloured, still), (&Cloud::default(), still), (&coloured, still)]);
    assert_eq!((both.colours, both.intensities), (Some(vec![[1, 2, 3]; 2]), Some(vec![0.5; 2])));
    assert_eq!(of(&[]), Cloud::default());
}
