//! The direction in which points of a plane lie closest together: square to a side of their convex hull.

/// Widths within this share are alike.
const ALIKE: f64 = 1e-6;

/// The unit direction of the least width of points, with its first component positive. Of several, as a square has, the
/// one that is turned least from the first axis. `None`: all points lie on one line.
pub(super) fn narrowest(points: Vec<[f64; 2]>) -> Option<[f64; 2]> {
    let hull = hull(points);
    if hull.len() < 3 {
        return None;
    }
    let mut sides: Vec<(f64, [f64; 2])> = Vec::new();
    let mut far = 1;
    for (i, a) in hull.iter().enumerate() {
        let b = hull[(i + 1) % hull.len()];
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = f64::sqrt(along[0] * along[0] + along[1] * along[1]);
        let inwards = [-along[1] / length, along[0] / length];
        let off =
            |k: usize| (hull[k % hull.len()][0] - a[0]) * inwards[0] + (hull[k % hull.len()][1] - a[1]) * inwards[1];
        // The farthest corner runs ahead around the hull as the side does.
        far = far.max(i + 1);
        while far < 2 * hull.len() && off(far + 1) > off(far) {
            far += 1;
        }
        sides.push((off(far), signed(inwards)));
    }
    let least = sides.iter().map(|s| s.0).fold(f64::INFINITY, f64::min);
    let steps = |d: &[f64; 2]| d.map(|c| (c / ALIKE).round() as i64);
    let alike = sides.into_iter().filter(|s| s.0 <= least * (1.0 + ALIKE));
    alike.map(|s| s.1).max_by_key(steps)
}

fn signed([x, y]: [f64; 2]) -> [f64; 2] {
    if x < -ALIKE || x.abs() <= ALIKE && y < 0.0 { [-x, -y] } else { [x, y] }
}

/// The convex hull, counter-clockwise, without points on its sides (Andrew's chain).
fn hull(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    let turns_left =
        |a: &[f64; 2], b: &[f64; 2], c: &[f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0;
    let chain = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for p in points {
            while chain.len() >= 2 && !turns_left(&chain[chain.len() - 2], &chain[chain.len() - 1], &p) {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut all = chain(&mut points.iter().copied());
    all.extend(chain(&mut points.iter().rev().copied()));
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn turned(points: &[[f64; 2]], deg: f64) -> Vec<[f64; 2]> {
        let (s, c) = (libm::sin(deg.to_radians()), libm::cos(deg.to_radians()));
        points.iter().map(|[x, y]| [x * c - y * s, x * s + y * c]).collect()
    }

    #[test]
    fn a_rectangle_is_narrowest_square_to_its_long_sides() {
        let plate = [[0.0, 0.0], [40.0, 0.0], [40.0, 30.0], [0.0, 30.0], [20.0, 15.0], [20.0, 0.0]];
        for deg in [0.0, 1.0, 33.0, 90.0] {
            let [x, y] = narrowest(turned(&plate, deg)).expect("a direction");
            let wanted = turned(&[[0.0, 1.0]], deg)[0];
            assert!((x * wanted[1] - y * wanted[0]).abs() < 1e-12, "{deg}: {x} {y}");
        }
        assert_eq!(narrowest(vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), None);
        assert_eq!(narrowest(turned(&[[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]], 0.0)), Some([1.0, 0.0]));
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]
        #[test]
        fn no_other_direction_is_narrower(points in prop::collection::vec(prop::array::uniform2(-9.0..9.0f64), 3..30)) {
            let width = |[x, y]: [f64; 2]| {
                let along = || points.iter().map(|p| p[0] * x + p[1] * y);
                along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
            };
            let found = narrowest(points.clone()).expect("points of an area");
            for k in 0..360 {
                let turn = f64::from(k).to_radians() / 2.0;
                prop_assert!(width(found) <= width([libm::cos(turn), libm::sin(turn)]) + 1e-9);
            }
        }
    }
}
