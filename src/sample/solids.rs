//! Closed-form solids for tests and benches, sizes in mm: their areas, volumes and sections are known.
//!
//! All but the folded sheet are closed skins that weld exactly. Round ones are inscribed polyhedra: corners lie on the
//! true surface. Rows and sides that make no solid (fewer than three sides) are the caller's error.

use super::outline::{at_z, circle, radians, rectangle, revolved, ring};
use super::shell::{Facing, Point, Shell, Triangles};

pub use super::folds::folded_sheet;
pub use super::gear_solid::helical_gear;
pub use super::grooves::{blind_hole, fin_row, v_groove};
pub use super::plate::{PlateFeature, plate};

/// A cube from the origin to (edge, edge, edge): 12 facets.
pub fn cube(edge: f64) -> Triangles {
    let square = rectangle([0.0, 0.0], [edge, edge]);
    let (low, high) = (at_z(&square, 0.0), at_z(&square, edge));
    let mut shell = Shell::new();
    shell.face(Facing::MinusZ, &low, &[]);
    shell.face(Facing::PlusZ, &high, &[]);
    shell.strip(&low, &high);
    shell.into_triangles()
}

/// A cylinder about the z axis from z = 0 to `height`: 4·sides − 4 facets.
pub fn cylinder(radius: f64, height: f64, sides: usize) -> Triangles {
    let (low, high) = (ring(radius, 0.0, sides), ring(radius, height, sides));
    let mut shell = Shell::new();
    shell.strip(&low, &high);
    shell.face(Facing::MinusZ, &low, &[]);
    shell.face(Facing::PlusZ, &high, &[]);
    shell.into_triangles()
}

/// A cone about the z axis, base at z = 0, point at z = `height`: 2·sides − 2 facets.
pub fn cone(radius: f64, height: f64, sides: usize) -> Triangles {
    let base = ring(radius, 0.0, sides);
    let mut shell = Shell::new();
    shell.fan(&base, [0.0, 0.0, height]);
    shell.face(Facing::MinusZ, &base, &[]);
    shell.into_triangles()
}

/// A sphere about the origin with its poles on the z axis, `parallels` bands of latitude from pole
/// to pole (two at least): 2·meridians·(parallels − 1) facets.
pub fn sphere(radius: f64, meridians: usize, parallels: usize) -> Triangles {
    let latitude = |k: usize| radians(180.0 * k as f64 / parallels as f64 - 90.0);
    let profile: Vec<[f64; 2]> =
        (1..parallels).map(|k| [radius * libm::cos(latitude(k)), radius * libm::sin(latitude(k))]).collect();
    let rings = revolved(&profile, meridians);
    let mut shell = Shell::new();
    if let (Some(first), Some(last)) = (rings.first(), rings.last()) {
        shell.fan_from([0.0, 0.0, -radius], first);
        shell.tube(&rings);
        shell.fan(last, [0.0, 0.0, radius]);
    }
    shell.into_triangles()
}

/// A torus about the z axis: `m` sections, each a circle of radius `minor` with `n` corners at the
/// distance `major` from the axis: 2·m·n facets.
pub fn torus(major: f64, minor: f64, m: usize, n: usize) -> Triangles {
    let section = circle([major, 0.0], minor, n);
    let mut rings: Vec<Vec<Point>> = revolved(&section, m);
    // The last ring is the first again, from the same numbers.
    rings.extend(rings.first().cloned());
    let mut shell = Shell::new();
    shell.tube(&rings);
    shell.into_triangles()
}

#[cfg(test)]
mod tests {
    use super::super::check::{closed, surfaces};
    use super::*;
    use std::f64::consts::PI;

    fn near(value: f64, expected: f64, share: f64) {
        assert!((value / expected - 1.0).abs() < share, "{value} instead of {expected}");
    }

    #[test]
    fn cube_is_exact() {
        let part = cube(10.0);
        let skin = closed("cube", &part);
        assert_eq!((skin.facets, skin.vertices, skin.edges), (12, 8, 18));
        assert_eq!(skin.area, 600.0);
        near(skin.volume, 1000.0, 1e-12);
        assert_eq!(surfaces(&part, 20.0).len(), 6);
    }

    #[test]
    fn cylinder_is_the_prism_it_claims() {
        let part = cylinder(5.0, 12.0, 48);
        let skin = closed("cylinder", &part);
        let base = 0.5 * 48.0 * 25.0 * libm::sin(2.0 * PI / 48.0);
        let side = 2.0 * 48.0 * 5.0 * libm::sin(PI / 48.0) * 12.0;
        assert_eq!(skin.facets, 4 * 48 - 4);
        near(skin.volume, base * 12.0, 1e-6);
        near(skin.area, 2.0 * base + side, 1e-6);
        assert_eq!(surfaces(&part, 20.0).len(), 3);
    }

    #[test]
    fn cone_and_sphere_and_torus() {
        let part = cone(6.0, 8.0, 90);
        let skin = closed("cone", &part);
        assert_eq!(skin.facets, 2 * 90 - 2);
        near(skin.volume, 0.5 * 90.0 * 36.0 * libm::sin(2.0 * PI / 90.0) * 8.0 / 3.0, 1e-6);
        assert_eq!(surfaces(&part, 20.0).len(), 2);

        let part = sphere(10.0, 64, 32);
        let skin = closed("sphere", &part);
        assert_eq!((skin.facets, skin.euler()), (2 * 64 * 31, 2));
        near(skin.volume, 4.0 / 3.0 * PI * 1000.0, 6e-3);
        near(skin.area, 4.0 * PI * 100.0, 4e-3);
        assert_eq!(surfaces(&part, 20.0).len(), 1);

        let part = torus(20.0, 5.0, 80, 40);
        let skin = closed("torus", &part);
        assert_eq!((skin.facets, skin.euler()), (2 * 80 * 40, 0));
        near(skin.volume, 2.0 * PI * PI * 20.0 * 25.0, 6e-3);
        near(skin.area, 4.0 * PI * PI * 20.0 * 5.0, 3e-3);
        assert_eq!(surfaces(&part, 20.0).len(), 1);
    }
}
