//! A rectangular plate with round holes and bosses, wherever they are wanted: for tests of what must
//! tell one feature from another.

use super::outline::{at_z, circle, rectangle};
use super::shell::{Facing, Point, Shell, Triangles};

/// A hole through a plate, or a boss on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlateFeature {
    /// Its axis, mm from the plate's corner.
    pub centre: [f64; 2],
    /// Diameter, mm.
    pub diameter: f64,
    /// Corners of the polygon that stands for the circle.
    pub sides: usize,
    /// Height of a boss, mm; 0: a hole through the plate.
    pub height: f64,
}

/// A plate from the origin to `size`, mm. Surfaces at 20°, in this order: bottom, top, the sides
/// y = 0, x = size, y = size and x = 0, then of each feature its wall and, of a boss, its top.
/// Features must not touch each other or the rim.
pub fn plate(size: [f64; 3], features: &[PlateFeature]) -> Triangles {
    let outline = rectangle([0.0, 0.0], [size[0], size[1]]);
    let (low, high) = (at_z(&outline, 0.0), at_z(&outline, size[2]));
    let ring = |f: &PlateFeature, z: f64| at_z(&circle(f.centre, f.diameter / 2.0, f.sides), z);
    let tops: Vec<Vec<Point>> = features.iter().map(|f| ring(f, size[2])).collect();
    let bottoms: Vec<Vec<Point>> = features.iter().filter(|f| f.height <= 0.0).map(|f| ring(f, 0.0)).collect();
    let mut shell = Shell::new();
    shell.face(Facing::MinusZ, &low, &bottoms.iter().map(Vec::as_slice).collect::<Vec<_>>());
    shell.face(Facing::PlusZ, &high, &tops.iter().map(Vec::as_slice).collect::<Vec<_>>());
    shell.strip(&low, &high);
    for (feature, top) in features.iter().zip(&tops) {
        if feature.height > 0.0 {
            let end = ring(feature, size[2] + feature.height);
            shell.strip(top, &end);
            shell.face(Facing::PlusZ, &end, &[]);
        } else {
            shell.strip(top, &ring(feature, 0.0));
        }
    }
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{closed, surfaces};
    use super::*;

    #[test]
    fn a_plate_is_closed_and_has_its_volume_and_surfaces() {
        let feature =
            |x: f64, diameter: f64, height: f64| PlateFeature { centre: [x, 20.0], diameter, sides: 48, height };
        let part = plate([80.0, 40.0, 10.0], &[feature(20.0, 8.0, 0.0), feature(60.0, 12.0, 5.0)]);
        let skin = closed("plate", &part);
        let disc = |d: f64| 48.0 * d * d / 8.0 * libm::sin(std::f64::consts::TAU / 48.0);
        let volume = 80.0 * 40.0 * 10.0 - disc(8.0) * 10.0 + disc(12.0) * 5.0;
        assert!((skin.volume - volume).abs() < 1e-3, "{} instead of {volume}", skin.volume);
        let found = surfaces(&part, 20.0);
        assert_eq!(found.len(), 9);
        // Each surface's facets stand together, in the order told.
        assert!(found.iter().all(|s| s.windows(2).all(|w| w[1] == w[0] + 1)));
    }
}
