//! The occluder height of a run of light: the height at which facets stop all of it.

use nalgebra::Point3;

/// Number of places sampled along travel and across. An opening narrower than the spacing between them, a
/// twelfth of the light's reach to either side, may be taken for closed.
const PLACES: [usize; 2] = [32, 24];

/// The lowest height at which light is stopped within a rectangle about the axis, if all of it is:
/// `corners` are those of facets, as (along, across, height).
pub fn occluder_height_mm<'a>(half: [f64; 2], facets: impl Iterator<Item = &'a [[f64; 3]; 3]>) -> Option<f64> {
    let mut lids = [f64::NEG_INFINITY; PLACES[0] * PLACES[1]];
    let step = [0, 1].map(|k| 2.0 * half[k] / PLACES[k] as f64);
    for [a, b, c] in facets {
        let range = |k: usize| {
            let (low, high) = (a[k].min(b[k]).min(c[k]), a[k].max(b[k]).max(c[k]));
            let place = |x: f64| ((x + half[k]) / step[k] - 0.5).clamp(-1.0, PLACES[k] as f64);
            (place(low).ceil().max(0.0) as usize)..((place(high).floor() + 1.0).max(0.0) as usize).min(PLACES[k])
        };
        let (e, f) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let det = e[0] * f[1] - e[1] * f[0];
        if det == 0.0 {
            continue;
        }
        for i in range(0) {
            for j in range(1) {
                let d = [(i as f64 + 0.5) * step[0] - half[0] - a[0], (j as f64 + 0.5) * step[1] - half[1] - a[1]];
                let (s, t) = ((d[0] * f[1] - d[1] * f[0]) / det, (e[0] * d[1] - e[1] * d[0]) / det);
                if s >= -1e-9 && t >= -1e-9 && s + t <= 1.0 + 1e-9 {
                    let lid = &mut lids[i * PLACES[1] + j];
                    *lid = lid.max(a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]));
                }
            }
        }
    }
    let lowest = lids.into_iter().fold(f64::INFINITY, f64::min);
    lowest.is_finite().then_some(lowest)
}

/// A point as (along, across, height) in a frame given by origin and axes.
pub fn in_frame(q: &Point3<f64>, p: &Point3<f64>, axes: &[nalgebra::Vector3<f64>; 3]) -> [f64; 3] {
    let d = q - p;
    [0, 1, 2].map(|k| d.dot(&axes[k]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hole_lets_light_through_and_a_lid_does_not() {
        let square = |x: [f64; 2], z: f64| {
            let at = |u: f64, v: f64| [u, v, z];
            [[at(x[0], -5.0), at(x[1], -5.0), at(x[1], 5.0)], [at(x[0], -5.0), at(x[1], 5.0), at(x[0], 5.0)]]
        };
        let low = square([-5.0, 5.0], -7.0);
        let (left, right) = (square([-5.0, -0.2], 1.0), square([0.2, 5.0], 2.0));
        let height_mm = |list: &[[[f64; 3]; 3]]| occluder_height_mm([2.0, 1.0], list.iter());
        assert_eq!(height_mm(&low), Some(-7.0));
        assert_eq!(height_mm(&[left[0], left[1], right[0], right[1]]), None, "a slot");
        assert_eq!(height_mm(&[&low[..], &left, &right].concat()), Some(-7.0));
        let closed = square([-0.2, 0.2], 0.5);
        assert_eq!(height_mm(&[&low[..], &left, &right, &closed].concat()), Some(0.5));
    }
}
