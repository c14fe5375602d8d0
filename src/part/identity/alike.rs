//! How unlike two fingerprints are: 0 for the same, 1 at the edge of what another tessellation can do.
//!
//! Each difference is taken in units of its tolerance and they are summed as squares; only what a
//! tessellation may change has a tolerance of any width. Neighbours tell equals apart, but never
//! rule out: a slot milled elsewhere changes them, and not the surface itself.

use super::fingerprint::{Fingerprint, FormWord};

/// Relative difference of areas. Within: a disc of 19 sides (the fewest below a crease of 20°) beside
/// a fine one, 1.8 %; a plate of 100 × 80 that got a boss of Ø26, 6.6 %. Beyond: a bore of Ø8 made Ø9.
const AREA: f64 = 0.1;
/// Difference of mean normals. They follow from the rim of a surface, so its facets hardly matter.
/// Within: a half pipe of 9 facets beside a fine one, 0.003. Beyond: a face tilted by 3°.
const NORMAL: f64 = 0.05;
/// Relative difference of diameters. Within: facets that lie half outside the true cylinder of 19
/// sides, 0.7 %. Beyond: a bore of Ø8.0 made Ø8.2.
const DIAMETER: f64 = 0.02;
/// Difference of half cone angles, degrees. Within: fits of one cone in many facets and few, 0.1°.
/// Beyond: a countersink of 82° made one of 90°, 4°.
const CONE_DEG: f64 = 2.0;
/// Distance of centroids, share of the square root of the area. Within: half a pipe as long as wide,
/// in 9 facets and many, 0.3 %. Beyond: a bore Ø20 of depth 50 moved by 2 mm, 3.6 %.
const PLACE: f64 = 0.03;
/// Distance of the centroids of planes within their own plane, share of the square root of the area. Within:
/// that plate with its boss 40 mm from the middle, 2.9 %. Beyond: a pad of 20 × 20 moved by 2 mm.
const PLACE_IN_PLANE: f64 = 0.05;
/// Distance of planes along their normal, share of the part's diagonal: no tessellation changes it.
/// Within: a face of a 128 mm part ground by 0.1 mm. Beyond: milled by 0.3 mm.
const PLANE_OFFSET: f64 = 0.002;
/// Added to every distance, share of the part's diagonal: f32 coordinates a hundred diagonals from the
/// origin have a grain of 1e-5.
const GRAIN: f64 = 2e-4;
/// A surface of few facets may fit a named shape by chance: a fillet of one row is a cone.
const CHANCE_SHAPE: f64 = 0.5;
/// The volume of a shell, as the edge of a cube, share of the square root of its area.
const SHELL_EDGE: f64 = 0.03;

/// Unlikeness of two surfaces, place and turn aside; `None`: not alike.
pub(super) fn unlikeness_anywhere(a: &Fingerprint, b: &Fingerprint) -> Option<f64> {
    let flatness = (a.mean_normal.norm() - b.mean_normal.norm()) / NORMAL;
    total(form(a, b) + flatness * flatness, a, b)
}

/// Unlikeness, place aside.
pub(super) fn unturned(a: &Fingerprint, b: &Fingerprint) -> Option<f64> {
    total(form(a, b) + normal(a, b), a, b)
}

/// Unlikeness of two surfaces that ought to be in one place. `diagonal` is that of the part.
pub(super) fn unlikeness_in_place(a: &Fingerprint, b: &Fingerprint, diagonal: f64) -> Option<f64> {
    total(form(a, b) + normal(a, b) + unlikeness_of_place(a, b, diagonal), a, b)
}

/// The greatest distance of centroids that [`unlikeness_in_place`] can allow.
pub(super) fn reach(a: &Fingerprint, diagonal: f64) -> f64 {
    PLACE_IN_PLANE * a.area.sqrt() + (PLANE_OFFSET + GRAIN) * diagonal
}

/// Whether the nearest is clearly nearer than the next: three times, and by a twentieth of the
/// tolerance, below which two surfaces lie on top of each other.
pub(super) fn clearly_nearer(nearest: f64, next: f64) -> bool {
    next >= 3.0 * nearest + 0.05
}

fn total(squares: f64, a: &Fingerprint, b: &Fingerprint) -> Option<f64> {
    let around = 0.25 * relative(a.neighbour_area, b.neighbour_area)
        + 0.25 * relative(f64::from(a.neighbours), f64::from(b.neighbours));
    // Also refuses what is no number.
    (squares <= 1.0).then(|| (squares + around * around).sqrt())
}

fn relative(a: f64, b: f64) -> f64 {
    let larger = a.abs().max(b.abs());
    if larger > 0.0 { (a - b).abs() / larger } else { 0.0 }
}

fn form(a: &Fingerprint, b: &Fingerprint) -> f64 {
    use FormWord::{Cone, Cylinder, Freeform, Plane, Shell, Sphere};
    let area = relative(a.area, b.area) / AREA;
    let shape = match (a.form, b.form) {
        (Plane, Plane) | (Freeform, Freeform) => 0.0,
        (Cylinder, Cylinder) | (Sphere, Sphere) => relative(a.size, b.size) / DIAMETER,
        (Cone, Cone) => (a.size - b.size).abs() / CONE_DEG,
        (Shell, Shell) => (a.size - b.size).abs() / (SHELL_EDGE * a.area.max(b.area).sqrt()).max(f64::MIN_POSITIVE),
        (Freeform, Cylinder | Cone | Sphere) | (Cylinder | Cone | Sphere, Freeform) => CHANCE_SHAPE,
        _ => f64::INFINITY,
    };
    area * area + shape * shape
}

fn normal(a: &Fingerprint, b: &Fingerprint) -> f64 {
    (a.mean_normal - b.mean_normal).norm_squared() / (NORMAL * NORMAL)
}

fn unlikeness_of_place(a: &Fingerprint, b: &Fingerprint, diagonal: f64) -> f64 {
    let (between, size) = (b.centroid - a.centroid, a.area.max(b.area).sqrt());
    if a.form != FormWord::Plane {
        return between.norm_squared() / (PLACE * size + GRAIN * diagonal).powi(2);
    }
    let along = between.dot(&a.mean_normal);
    let beside = (between - a.mean_normal * along).norm();
    (along / ((PLANE_OFFSET + GRAIN) * diagonal)).powi(2)
        + (beside / (PLACE_IN_PLANE * size + GRAIN * diagonal)).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Point3, Vector3};

    const DIAGONAL: f64 = 128.0;

    fn plane(area: f64) -> Fingerprint {
        Fingerprint {
            area,
            centroid: Point3::new(50.0, 40.0, 12.0),
            mean_normal: Vector3::z(),
            form: FormWord::Plane,
            size: 0.0,
            neighbours: 5,
            neighbour_area: 4000.0,
        }
    }

    fn bore(diameter: f64, depth: f64) -> Fingerprint {
        let area = std::f64::consts::PI * diameter * depth;
        Fingerprint { mean_normal: Vector3::zeros(), form: FormWord::Cylinder, size: diameter, ..plane(area) }
    }

    fn shifted(p: &Fingerprint, by: [f64; 3]) -> Fingerprint {
        Fingerprint { centroid: p.centroid + Vector3::from(by), ..*p }
    }

    fn alike(a: &Fingerprint, b: &Fingerprint) -> bool {
        unlikeness_in_place(a, b, DIAGONAL).is_some()
    }

    /// The cases that the constants are said to lie between.
    #[test]
    fn tolerances_part_what_they_are_said_to_part() {
        let disc = |sides: f64| plane(100.0 * sides / 2.0 * libm::sin(std::f64::consts::TAU / sides));
        assert!(alike(&disc(19.0), &disc(1e6)));
        let face = plane(8000.0);
        let boss = std::f64::consts::PI * 13.0 * 13.0;
        let with_boss = shifted(&plane(8000.0 - boss), [40.0 * boss / (8000.0 - boss), 0.0, 0.0]);
        assert!(alike(&face, &with_boss));
        assert!(!alike(&bore(8.0, 12.0), &bore(9.0, 12.0)));
        assert!(!alike(&bore(8.0, 12.0), &bore(8.2, 12.0)));
        let by_middles = 2.0 / (1.0 + libm::cos(std::f64::consts::PI / 19.0));
        assert!(alike(&bore(8.0, 12.0), &bore(8.0 * by_middles, 12.0)));
        assert!(!alike(&bore(20.0, 50.0), &shifted(&bore(20.0, 50.0), [2.0, 0.0, 0.0])));
        let pad = plane(400.0);
        assert!(!alike(&pad, &shifted(&pad, [0.0, 2.0, 0.0])));
        assert!(alike(&face, &shifted(&face, [0.0, 0.0, -0.1])));
        assert!(!alike(&face, &shifted(&face, [0.0, 0.0, -0.3])));
        let tilt = 3.0f64.to_radians();
        let tilted = Fingerprint { mean_normal: Vector3::new(libm::sin(tilt), 0.0, libm::cos(tilt)), ..face };
        assert!(!alike(&face, &tilted));
        let sink = |deg: f64| Fingerprint { form: FormWord::Cone, size: deg / 2.0, ..bore(8.0, 2.0) };
        assert!(alike(&sink(82.0), &sink(82.2)) && !alike(&sink(82.0), &sink(90.0)));
    }

    #[test]
    fn neighbours_tell_apart_and_do_not_rule_out() {
        let face = plane(8000.0);
        let other = Fingerprint { neighbours: 9, neighbour_area: 9000.0, ..face };
        let unlike = unlikeness_in_place(&face, &other, DIAGONAL).expect("the same face");
        assert!(clearly_nearer(0.0, unlike));
        let nothing = Fingerprint { area: f64::NAN, ..face };
        assert!(!alike(&face, &nothing), "what is no number is like nothing");
    }
}
