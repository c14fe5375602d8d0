//! Families of section planes (P2 4.2.1).
//!
//! Surfaces with the same direction, spacing and offset share one family, centred on their joint
//! extent, so that their lines meet at creases; P2's start at `min + d` would leave a strip of
//! width d at one rim. A surface that falls between two planes gets one of its own.

use crate::part::{Hasher, Keyed, Mesh, Surfaces, angle, surfaces::Surface, topology::FacetDefect};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Normal of the section planes, as the operator chooses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// A direction in the part frame, of any length but 0.
    Along([f64; 3]),
    /// Per surface the one that keeps the spacing on it truest.
    Auto,
}

impl Keyed for Direction {
    fn feed(&self, into: &mut Hasher) {
        match self {
            Direction::Along(d) => d.feed(into),
            Direction::Auto => "auto".feed(into),
        }
    }
}

impl Direction {
    /// The three axes, as shown in lists.
    pub const AXES: [(&'static str, Direction); 3] = [
        ("x", Direction::Along([1.0, 0.0, 0.0])),
        ("y", Direction::Along([0.0, 1.0, 0.0])),
        ("z", Direction::Along([0.0, 0.0, 1.0])),
    ];
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((name, _)) = Direction::AXES.iter().find(|(_, d)| d == self) {
            return f.write_str(name);
        }
        match self {
            Direction::Auto => f.write_str("auto"),
            Direction::Along([x, y, z]) => write!(f, "{x},{y},{z}"),
        }
    }
}

/// Why a text names no direction.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum DirectionError {
    /// It is neither an axis, nor `auto`, nor three numbers.
    #[error("{text:?} is not x, y, z, auto or DX,DY,DZ")]
    Unknown {
        /// The text.
        text: String,
    },
    /// All three numbers are zero, or one is not finite.
    #[error("direction {text} has no length")]
    NoLength {
        /// The text.
        text: String,
    },
}

impl FromStr for Direction {
    type Err = DirectionError;

    fn from_str(text: &str) -> Result<Self, DirectionError> {
        let text = text.trim();
        if let Some((_, d)) = Direction::AXES.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)) {
            return Ok(*d);
        }
        if text.eq_ignore_ascii_case("auto") {
            return Ok(Direction::Auto);
        }
        let wrong = || DirectionError::Unknown { text: text.to_owned() };
        let numbers: Vec<f64> =
            text.split(',').map(|n| n.trim().parse()).collect::<Result<_, _>>().map_err(|_| wrong())?;
        let v: [f64; 3] = numbers.try_into().map_err(|_| wrong())?;
        if angle::unit(Vector3::from(v)).is_none() {
            return Err(DirectionError::NoLength { text: text.to_owned() });
        }
        Ok(Direction::Along(v))
    }
}

/// In files a direction is its text.
impl Serialize for Direction {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Direction, D::Error> {
        String::deserialize(from)?.parse().map_err(D::Error::custom)
    }
}

/// The planes of one surface: `normal · p = height`, heights ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfacePlanes {
    /// Surface number.
    pub surface: u32,
    /// Unit normal of the planes (m).
    pub normal: Vector3<f64>,
    /// Heights along it, mm.
    pub heights_mm: Vec<f64>,
}

crate::part::keyed!(SurfacePlanes { surface, normal, heights_mm });

/// What planes a surface is to get.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Raster {
    /// Surface number.
    pub surface: u32,
    /// Normal of the planes.
    pub direction: Direction,
    /// Their distance.
    pub spacing_mm: f64,
    /// The first plane's height above the lowest point of its family's extent; `None` centres the family.
    pub offset_mm: Option<f64>,
}

/// The planes of surfaces, in their order. Surfaces without any proper facet get none.
pub fn planes(mesh: &Mesh, surfaces: &Surfaces, layouts: &[Raster]) -> Vec<SurfacePlanes> {
    let mut all: Vec<(SurfacePlanes, (f64, f64), &Raster)> = layouts
        .iter()
        .filter_map(|layout| Some((surfaces.get(layout.surface)?, layout)))
        .filter_map(|(s, layout)| {
            let normal = match layout.direction {
                Direction::Along(v) => angle::unit(Vector3::from(v))?,
                Direction::Auto => truest_direction(mesh, s)?,
            };
            let extent = extent(mesh, s, &normal)?;
            Some((SurfacePlanes { surface: s.number, normal, heights_mm: Vec::new() }, extent, layout))
        })
        .collect();
    for i in 0..all.len() {
        let (normal, own, layout) = (all[i].0.normal, all[i].1, *all[i].2);
        let is_same =
            |(p, _, l): &&(SurfacePlanes, (f64, f64), &Raster)| p.normal == normal && l.family() == layout.family();
        let joint = all.iter().filter(is_same).fold(own, |j, (_, e, _)| (j.0.min(e.0), j.1.max(e.1)));
        let family = family(joint, layout.spacing_mm, layout.offset_mm);
        let touched = family.partition_point(|&h| h <= own.0)..family.partition_point(|&h| h <= own.1);
        all[i].0.heights_mm = if touched.is_empty() { vec![0.5 * (own.0 + own.1)] } else { family[touched].to_vec() };
    }
    all.into_iter().map(|(p, ..)| p).collect()
}

impl Raster {
    /// Surfaces of one family agree in this, and in their planes' normal.
    fn family(&self) -> (f64, Option<f64>) {
        (self.spacing_mm, self.offset_mm)
    }
}

/// Heights of a family over an extent.
pub(super) fn family((lo, hi): (f64, f64), spacing_mm: f64, offset_mm: Option<f64>) -> Vec<f64> {
    // A hair less: an extent of n spacings that f32 coordinates have made a little longer must not
    // get n + 1 planes, the outer ones on its rims.
    let steps = (hi - lo) / spacing_mm - 1e-4;
    let (first, count) = match offset_mm {
        Some(offset) => (lo + offset, ((hi - lo - offset) / spacing_mm).floor().max(0.0) as usize + 1),
        None => {
            let count = steps.ceil().max(1.0);
            (lo + 0.5 * ((hi - lo) - (count - 1.0) * spacing_mm), count as usize)
        }
    };
    (0..count).map(|i| first + i as f64 * spacing_mm).collect()
}

/// The proper facets of a surface.
pub(super) fn live<'a>(mesh: &'a Mesh, s: &'a Surface) -> impl Iterator<Item = usize> + 'a {
    s.facets.iter().map(|&f| f as usize).filter(|&f| mesh.defects[f] == FacetDefect::None)
}

/// Least and greatest height of a surface along a direction, mm.
pub(super) fn extent(mesh: &Mesh, s: &Surface, normal: &Vector3<f64>) -> Option<(f64, f64)> {
    live(mesh, s)
        .flat_map(|f| mesh.corners(f))
        .map(|p| p.coords.dot(normal))
        .map(|h| (h, h))
        .reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// The direction m with the least mean of 1/sin∠(n, m), the factor by which spacing on the surface
/// exceeds the plane spacing. Axes are preferred where they are as good; on a plane, where every
/// direction in it is perfect, the one with the fewest lines.
fn truest_direction(mesh: &Mesh, s: &Surface) -> Option<Vector3<f64>> {
    let mut spread: Matrix3<f64> = Matrix3::zeros();
    let mut sum = Vector3::zeros();
    for f in live(mesh, s) {
        spread += mesh.normals[f] * mesh.normals[f].transpose() * mesh.areas[f];
        sum += mesh.normals[f] * mesh.areas[f];
    }
    let eigen = SymmetricEigen::new(spread);
    let mut candidates = vec![Vector3::z(), Vector3::x(), Vector3::y()];
    let mut own: Vec<(f64, Vector3<f64>)> =
        (0..3).map(|k| (eigen.eigenvalues[k], eigen.eigenvectors.column(k).into_owned())).collect();
    own.sort_by(|a, b| a.0.total_cmp(&b.0));
    candidates.extend(own.into_iter().filter_map(|(_, v)| angle::unit(signed(v))));
    if let Some(n) = angle::unit(sum) {
        candidates.extend(principal_in_plane(mesh, s, &n));
    }
    candidates
        .into_iter()
        .filter_map(|m| {
            let (mut cost, mut area) = (0.0, 0.0);
            for f in live(mesh, s) {
                let sine = mesh.normals[f].cross(&m).norm();
                cost += mesh.areas[f] / sine.max(1e-3);
                area += mesh.areas[f];
            }
            let (lo, hi) = extent(mesh, s, &m)?;
            // Steps of 1e-6: axis against eigenvector is decided by preference, not by rounding.
            Some(((cost / area.max(1e-300) * 1e6).round(), ((hi - lo) * 1e3).round(), m))
        })
        .reduce(|a, b| if (b.0, b.1) < (a.0, a.1) { b } else { a })
        .map(|(_, _, m)| m)
}

/// The two principal axes of a surface's corners within the plane square to `n`.
fn principal_in_plane(mesh: &Mesh, s: &Surface, n: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let u = angle::any_square_to(n);
    let v = n.cross(&u);
    let (mut weight, mut mean) = (0.0, Vector3::zeros());
    for f in live(mesh, s) {
        mean += mesh.centroid(f).coords * mesh.areas[f];
        weight += mesh.areas[f];
    }
    mean /= f64::max(weight, 1e-300);
    let (mut uu, mut uv, mut vv) = (0.0, 0.0, 0.0);
    for f in live(mesh, s) {
        let d = mesh.centroid(f).coords - mean;
        let (x, y) = (d.dot(&u), d.dot(&v));
        (uu, uv, vv) = (uu + x * x * mesh.areas[f], uv + x * y * mesh.areas[f], vv + y * y * mesh.areas[f]);
    }
    let half_turn = 0.5 * libm::atan2(2.0 * uv, uu - vv);
    let main = u * libm::cos(half_turn) + v * libm::sin(half_turn);
    [n.cross(&main), main].into_iter().filter_map(|d| angle::unit(signed(d))).collect()
}

/// Of the two opposite directions the one whose largest component is positive.
fn signed(v: Vector3<f64>) -> Vector3<f64> {
    if v[v.iamax()] < 0.0 { -v } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_cup_of_p2_gets_five_planes() {
        let heights = family((0.0, 28.0), 6.0, None);
        assert_eq!(heights, [2.0, 8.0, 14.0, 20.0, 26.0]);
        assert_eq!(family((0.0, 28.0), 6.0, Some(6.0)), [6.0, 12.0, 18.0, 24.0]);
        assert_eq!(family((3.0, 3.1), 6.0, None), [3.05]);
        assert_eq!(family((0.0, 3.0), 1.0, None), [0.5, 1.5, 2.5]);
    }

    proptest! {
        #[test]
        fn no_gap_exceeds_the_spacing(lo in -50.0..50.0f64, size in 0.01..80.0f64, d in 0.05..10.0f64, share in 0.0..1.0f64) {
            for offset in [None, Some(share * d)] {
                let hi = lo + size;
                let heights = family((lo, hi), d, offset);
                let inside = |h: &&f64| **h >= lo && **h <= hi;
                let mut at: Vec<f64> = heights.iter().filter(inside).copied().collect();
                if at.is_empty() {
                    prop_assert!(size <= d);
                    continue;
                }
                at.insert(0, lo);
                at.push(hi);
                prop_assert!(at.windows(2).all(|w| w[1] - w[0] <= d * (1.0 + 1e-4)), "{at:?}");
            }
        }
    }

    #[test]
    fn directions_read_and_print() {
        for text in ["x", "auto", "1,0.5,-2"] {
            assert_eq!(text.parse::<Direction>().expect("reads").to_string(), text);
        }
        let refused = |text: &str| text.parse::<Direction>().expect_err("no direction");
        assert_eq!(refused("0,0,0"), DirectionError::NoLength { text: "0,0,0".into() });
        assert_eq!(refused("up"), DirectionError::Unknown { text: "up".into() });
    }
}
