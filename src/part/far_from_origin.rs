//! Parts that lie so far from the origin of their file that the coordinates, which have 24 binary digits, are coarse.

use super::raw_part::RawFacet;
use serde::Serialize;

/// A part that lies far out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FarFromOrigin {
    /// From the origin to the middle of the part, mm.
    pub distance_mm: f64,
    /// From one coordinate to the next that the file can hold there, mm.
    pub resolution_mm: f64,
}

/// Coordinates as coarse as this show in lines, whose chords may be 0.02 mm off by default: half of that, mm. The
/// brackets: 0.0078 mm at 130 m from the origin, 0.0156 mm from 131.072 m on.
const COARSE_MM: f64 = 0.01;
/// A move to the origin must be worth it: coordinates would be so many times as fine there. A long part has coarse ones
/// wherever it lies.
const WORTH: f64 = 4.0;

impl FarFromOrigin {
    /// Looks at the coordinates as they are stored; `mm_per_unit` are millimetres in one of their units.
    pub fn of(facets: &[RawFacet], mm_per_unit: f64) -> Option<FarFromOrigin> {
        let (mut lo, mut hi) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for corner in facets.iter().flatten() {
            for axis in 0..3 {
                (lo[axis], hi[axis]) = (lo[axis].min(corner[axis]), hi[axis].max(corner[axis]));
            }
        }
        let farthest = lo.iter().chain(&hi).fold(0.0, |far: f32, x| far.max(x.abs()));
        let half_side = (0..3).fold(0.0, |half: f32, axis| half.max(0.5 * hi[axis] - 0.5 * lo[axis]));
        let resolution_mm = step(farthest) * mm_per_unit;
        if !resolution_mm.is_finite() || resolution_mm < COARSE_MM || step(farthest) < WORTH * step(half_side) {
            return None;
        }
        let middle = [0, 1, 2].map(|axis| 0.5 * f64::from(lo[axis]) + 0.5 * f64::from(hi[axis]));
        let distance_mm = libm::hypot(libm::hypot(middle[0], middle[1]), middle[2]) * mm_per_unit;
        Some(FarFromOrigin { distance_mm, resolution_mm })
    }
}

/// From a coordinate to the next greater one, both as they are stored.
fn step(at: f32) -> f64 {
    f64::from(at.next_up()) - f64::from(at)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A facet of 40 mm at a place.
    fn at(place: [f32; 3]) -> Vec<RawFacet> {
        let corner = |x: f32, y: f32| [place[0] + x, place[1] + y, place[2]];
        vec![[corner(0.0, 0.0), corner(40.0, 0.0), corner(0.0, 40.0)]]
    }

    #[test]
    fn coordinates_of_a_plant_are_coarse_and_those_of_a_hall_are_not() {
        let far = FarFromOrigin::of(&at([512_345.0, 5_412_345.0, 120.0]), 1.0).expect("far");
        assert_eq!(far.resolution_mm, 0.5);
        assert!((far.distance_mm - libm::hypot(512_365.0, 5_412_365.0)).abs() < 0.01, "{far:?}");
        // From 2^17 = 131 072 on the steps are 1/64.
        assert_eq!(FarFromOrigin::of(&at([131_000.0, 0.0, 0.0]), 1.0), None);
        assert_eq!(FarFromOrigin::of(&at([-131_200.0, 0.0, 0.0]), 1.0).expect("far").resolution_mm, 1.0 / 64.0);
        // The same place in metres.
        let metres = [[[131.2, 0.0, 0.0], [131.24, 0.0, 0.0], [131.2, 0.04, 0.0]]];
        assert!(FarFromOrigin::of(&metres, 1000.0).is_some_and(|far| far.resolution_mm > 0.015));
    }

    #[test]
    fn what_is_only_large_is_not_far() {
        for side in [4e5, 4e21, 1e38] {
            let large = vec![[[0.0, 0.0, 0.0], [side, 0.0, 0.0], [0.0, side, 0.0]]];
            assert_eq!(FarFromOrigin::of(&large, 1.0), None, "{side}");
        }
        assert_eq!(FarFromOrigin::of(&[], 1.0), None);
    }
}
