//! Neighbours beside brute force: the same arithmetic over all points, sorted.

use super::*;
use proptest::prelude::*;

fn brute(cloud: &Cloud, point: &Point3<f64>) -> Vec<Neighbour> {
    let d = point - cloud.origin;
    let from = [d.x as f32, d.y as f32, d.z as f32];
    let squared = |o: &[f32; 3]| {
        let [x, y, z]: [f32; 3] = std::array::from_fn(|k| o[k] - from[k]);
        x * x + y * y + z * z
    };
    let mut all: Vec<Neighbour> =
        cloud.offsets.iter().zip(0..).map(|(o, index)| Neighbour { index, squared: squared(o) }).collect();
    all.sort_by(|a, b| a.squared.total_cmp(&b.squared).then(a.index.cmp(&b.index)));
    all
}

fn by_distance(mut found: Vec<Neighbour>) -> Vec<Neighbour> {
    found.sort_by(|a, b| a.squared.total_cmp(&b.squared).then(a.index.cmp(&b.index)));
    found
}

fn tree(cloud: &Cloud) -> Neighbours {
    Neighbours::new(cloud, &Progress::default()).expect("nobody cancels")
}

/// Points on a coarse grid, so that there are duplicates and ties; flat or on a line where a side is 1.
fn lattice() -> impl Strategy<Value = Vec<Point3<f64>>> {
    let sides = prop::sample::select(vec![[12, 12, 12], [40, 40, 1], [300, 1, 1], [1, 1, 1], [4000, 5, 3]]);
    (sides, 0..300usize).prop_flat_map(|(sides, count)| {
        let place = (0..sides[0], 0..sides[1], 0..sides[2]);
        prop::collection::vec(place.prop_map(|(x, y, z)| Point3::new(x, y, z).map(|c| f64::from(c) * 0.37)), count)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    #[test]
    fn one_by_one_as_brute_force(points in lattice(), at in prop::array::uniform3(-2.0..14.0f64), k in 0..40usize,
                                 radius in 0.0..6.0f64) {
        let cloud = Cloud::of_points(&points);
        let tree = tree(&cloud);
        let mut found = Vec::new();
        let on_one = points.first().copied().unwrap_or_default();
        for p in [Point3::from(at), on_one] {
            let all = brute(&cloud, &p);
            tree.nearest(&p, k, &mut found);
            prop_assert_eq!(&found[..], &all[..k.min(all.len())]);
            prop_assert_eq!(tree.nearest_one(&p, f64::INFINITY), all.first().copied());
            tree.within(&p, radius, &mut found);
            let inside: Vec<Neighbour> =
                all.iter().copied().filter(|n| n.squared <= (radius * radius) as f32).collect();
            prop_assert_eq!(tree.nearest_one(&p, radius), inside.first().copied());
            prop_assert_eq!(by_distance(found.clone()), inside);
        }
    }

    #[test]
    fn all_at_once_as_brute_force(points in lattice(), k in 0..40usize, radius in 0.0..3.0f64) {
        let cloud = Cloud::of_points(&points);
        let tree = tree(&cloud);
        let progress = Progress::default();
        let nearest = tree.map_nearest(k, &progress, |i, near| (i, near.to_vec())).expect("nobody cancels");
        let within = tree.map_within(radius, &progress, |i, near| (i, near.to_vec())).expect("nobody cancels");
        prop_assert_eq!(nearest.len(), points.len());
        for (i, (nearest, within)) in nearest.into_iter().zip(within).enumerate() {
            let mut all = brute(&cloud, &cloud.point(i));
            all.retain(|n| n.index as usize != i);
            prop_assert_eq!((nearest.0 as usize, within.0 as usize), (i, i));
            prop_assert_eq!(by_distance(nearest.1), &all[..k.min(all.len())]);
            all.retain(|n| n.squared <= (radius * radius) as f32);
            prop_assert_eq!(by_distance(within.1), all);
        }
    }
}

#[test]
fn what_is_no_number_is_never_found_and_finds_nothing() {
    let nan = [f32::NAN, 0.0, 0.0];
    let offsets = (0..100).map(|i| if i % 3 == 0 { nan } else { [i as f32, 0.0, 0.0] }).collect();
    let tree = tree(&Cloud { offsets, ..Cloud::default() });
    let mut found = Vec::new();
    tree.nearest(&Point3::origin(), 100, &mut found);
    assert_eq!(found.len(), 66);
    assert_eq!(found[0].index, 1);
    tree.nearest(&Point3::new(f64::NAN, 0.0, 0.0), 3, &mut found);
    assert_eq!(found, []);
    assert_eq!(tree.nearest_one(&Point3::origin(), f64::NAN), None);
    let counts = tree.map_nearest(5, &Progress::default(), |_, near| near.len()).expect("nobody cancels");
    assert!(counts.iter().enumerate().all(|(i, &n)| n == if i % 3 == 0 { 0 } else { 5 }));
}

#[test]
fn an_empty_cloud_has_no_nearest_point() {
    let tree = tree(&Cloud::default());
    let mut found = vec![Neighbour::default()];
    tree.nearest(&Point3::origin(), 3, &mut found);
    assert_eq!(found, []);
    assert_eq!(tree.nearest_one(&Point3::origin(), f64::INFINITY), None);
    assert_eq!(tree.map_nearest(3, &Progress::default(), |_, near| near.len()), Ok(vec![]));
}

#[test]
fn the_work_ends_when_it_should() {
    let points: Vec<Point3<f64>> = (0..50_000).map(|i| Point3::new(f64::from(i), 0.0, 0.0)).collect();
    let cloud = Cloud::of_points(&points);
    assert_eq!(Neighbours::new(&cloud, &Progress::ending_after(2)).err(), Some(Cancelled));
    assert_eq!(tree(&cloud).map_nearest(3, &Progress::ending_after(9), |_, _| ()), Err(Cancelled));
}
