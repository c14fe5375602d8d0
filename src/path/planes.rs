//! Families of section planes (P2 4.2.1).
//!
//! Surfaces with the same direction, spacing and offset share one family, centred on their joint
//! extent, so that their lines meet at creases; P2's start at `min + d` would leave a strip of
//! width d at one rim. A surface that falls between two planes gets one of its own.

use super::live_facets::extent;
use super::suited_direction::suited_direction;
use crate::part::{Hasher, Keyed, Mesh, Surfaces, angle};
use nalgebra::{Rotation3, Vector3};
use rayon::prelude::*;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// Normal of the section planes, as the operator chooses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// A direction in the part frame, of any length but 0.
    Along([f64; 3]),
    /// Per surface the one that suits it: no facet is missed where that can be helped, and lines are few and long.
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
pub struct PlaneRaster {
    /// Surface number.
    pub surface: u32,
    /// Normal of the planes.
    pub direction: Direction,
    /// Their distance.
    pub spacing_mm: f64,
    /// The first plane's height above the lowest point of its family's extent; `None` centres the family.
    pub offset_mm: Option<f64>,
}

/// The planes of surfaces, in their order. Surfaces without any proper facet get none. `axes`: those of the part's
/// file in the frame of the mesh, from which `Auto` starts.
pub fn planes(mesh: &Mesh, surfaces: &Surfaces, layouts: &[PlaneRaster], axes: &Rotation3<f64>) -> Vec<SurfacePlanes> {
    let mut all: Vec<(SurfacePlanes, (f64, f64), &PlaneRaster)> = directions(mesh, surfaces, layouts, axes)
        .into_iter()
        .filter_map(|(normal, layout)| {
            let extent = extent(mesh, surfaces.get(layout.surface)?, &normal)?;
            Some((SurfacePlanes { surface: layout.surface, normal, heights_mm: Vec::new() }, extent, layout))
        })
        .collect();
    for i in 0..all.len() {
        let (normal, own, layout) = (all[i].0.normal, all[i].1, *all[i].2);
        let is_same = |(p, _, l): &&(SurfacePlanes, (f64, f64), &PlaneRaster)| {
            p.normal == normal && l.family() == layout.family()
        };
        let joint = all.iter().filter(is_same).fold(own, |j, (_, e, _)| (j.0.min(e.0), j.1.max(e.1)));
        let family = family(joint, layout.spacing_mm, layout.offset_mm);
        let touched = family.partition_point(|&h| h <= own.0)..family.partition_point(|&h| h <= own.1);
        all[i].0.heights_mm = if touched.is_empty() { vec![0.5 * (own.0 + own.1)] } else { family[touched].to_vec() };
    }
    all.into_iter().map(|(p, ..)| p).collect()
}

/// Directions nearer than this, rad, are one: what suits two faces of a plane differs by rounding, and they are to
/// share a family.
const SAME_RAD: f64 = 1e-6;

/// The unit normal of each surface's planes.
fn directions<'a>(
    mesh: &Mesh,
    surfaces: &Surfaces,
    layouts: &'a [PlaneRaster],
    axes: &Rotation3<f64>,
) -> Vec<(Vector3<f64>, &'a PlaneRaster)> {
    let own = |layout: &'a PlaneRaster| {
        let normal = match layout.direction {
            Direction::Along(v) => angle::unit(Vector3::from(v))?,
            Direction::Auto => suited_direction(mesh, surfaces.get(layout.surface)?, axes)?,
        };
        Some((normal, layout))
    };
    let mut all: Vec<(Vector3<f64>, &PlaneRaster)> = layouts.par_iter().filter_map(own).collect();
    for i in 0..all.len() {
        let (before, rest) = all.split_at_mut(i);
        if let Some((normal, PlaneRaster { direction: Direction::Auto, .. })) = rest.first_mut()
            && let Some((same, _)) = before.iter().find(|(other, _)| (other - *normal).norm() < SAME_RAD)
        {
            *normal = *same;
        }
    }
    all
}

impl PlaneRaster {
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
