//! What a job decides of its scan: what is worked, on what its lines lie, which regions of the model count for what, and
//! which surfaces go on across a damage.

use crate::part::{Hasher, Keyed, keyed, keyed_words};
use nalgebra::Point3;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

/// A region of the model, part frame, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "shape", rename_all = "kebab-case", deny_unknown_fields)]
pub enum ScanRegion {
    /// A ball.
    Sphere {
        /// Its middle.
        centre_mm: [f64; 3],
        /// Its radius.
        radius_mm: f64,
    },
    /// A box along the axes.
    Box {
        /// Its lowest corner.
        min_mm: [f64; 3],
        /// Its highest corner.
        max_mm: [f64; 3],
    },
}

/// A damage, and the surface around it that goes on across it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ContinuedDamage {
    /// Which kind of surface it is.
    pub by: ContinuedKind,
    /// Where the damage is.
    pub damaged: Vec<ScanRegion>,
    /// Where the surface is as it was made, the damage left out.
    pub sound: Vec<ScanRegion>,
}

/// Which kind of surface is continued across a damage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ContinuedKind {
    /// A plane.
    Plane,
    /// A circular cylinder.
    Cylinder,
    /// A curve turned about an axis.
    Revolved,
    /// A curve drawn along a direction.
    Extruded,
    /// A height over a plane, as smooth as the points around allow.
    Smooth,
}

/// How several files of a scan come together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ScanTogether {
    /// They share a frame, as scanners export them.
    #[default]
    Shared,
    /// Each is brought to those before it by the area that they share.
    Overlap,
}

/// What a scan makes of a job.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ScanWork {
    /// What is missing is worked, in place of the surfaces that the job chooses.
    #[default]
    Patches,
    /// The job's surfaces are worked, where the scan found the part, and clear of what is built up on it.
    Surfaces,
}

/// What the lines of a scanned part are laid on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ScanLines {
    /// On the facets of the model.
    #[default]
    Facets,
    /// Through the points of the scan (P3 4.1), where planes tell the lines.
    Points,
}

/// Which patches are worked. They have no numbers that last from one scan to the next, so those that are chosen are told
/// by places in them.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum PatchChoice {
    /// All.
    #[default]
    All,
    /// Those in which one of these places of the model lies, part frame, mm.
    At(Vec<[f64; 3]>),
}

impl ScanRegion {
    /// Whether a point of the model lies in it; its rim belongs to it.
    pub fn contains(&self, point: &Point3<f64>) -> bool {
        match self {
            ScanRegion::Sphere { centre_mm, radius_mm } => {
                (point - Point3::from(*centre_mm)).norm_squared() <= radius_mm * radius_mm
            }
            ScanRegion::Box { min_mm, max_mm } => (0..3).all(|k| (min_mm[k]..=max_mm[k]).contains(&point[k])),
        }
    }
}

impl PatchChoice {
    pub(super) fn is_all(&self) -> bool {
        *self == PatchChoice::All
    }
}

keyed!(ContinuedDamage { by, damaged, sound });
keyed_words!(ContinuedKind: Plane, Cylinder, Revolved, Extruded, Smooth);
keyed_words!(ScanTogether: Shared, Overlap);
keyed_words!(ScanWork: Patches, Surfaces);
keyed_words!(ScanLines: Facets, Points);

impl Keyed for ScanRegion {
    fn feed(&self, into: &mut Hasher) {
        match self {
            ScanRegion::Sphere { centre_mm, radius_mm } => {
                "sphere".feed(into);
                centre_mm.feed(into);
                radius_mm.feed(into);
            }
            ScanRegion::Box { min_mm, max_mm } => {
                "box".feed(into);
                min_mm.feed(into);
                max_mm.feed(into);
            }
        }
    }
}

impl Keyed for PatchChoice {
    fn feed(&self, into: &mut Hasher) {
        let places = match self {
            PatchChoice::All => None,
            PatchChoice::At(places) => Some(places),
        };
        places.feed(into);
    }
}

impl Serialize for PatchChoice {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            PatchChoice::All => s.serialize_str("all"),
            PatchChoice::At(places) => places.serialize(s),
        }
    }
}

impl<'de> Deserialize<'de> for PatchChoice {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "give \"all\" or a list of places on the model, [x, y, z] in mm")]
        enum RawChoice {
            Word(String),
            Places(Vec<[f64; 3]>),
        }
        match RawChoice::deserialize(d)? {
            RawChoice::Word(w) if w == "all" => Ok(PatchChoice::All),
            RawChoice::Word(w) => {
                Err(D::Error::custom(format!("{w:?}: give \"all\" or a list of places on the model, [x, y, z] in mm")))
            }
            RawChoice::Places(places) => Ok(PatchChoice::At(places)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_region_has_its_rim_and_nothing_beyond() {
        let ball = ScanRegion::Sphere { centre_mm: [1.0, 2.0, 3.0], radius_mm: 5.0 };
        let cuboid = ScanRegion::Box { min_mm: [0.0; 3], max_mm: [1.0, 2.0, 3.0] };
        for (region, point, is_in) in [
            (ball, [4.0, 6.0, 3.0], true),
            (ball, [4.0, 6.0, 3.1], false),
            (cuboid, [1.0, 0.0, 3.0], true),
            (cuboid, [1.0, 2.1, 3.0], false),
        ] {
            assert_eq!(region.contains(&Point3::from(point)), is_in, "{region:?} {point:?}");
        }
    }

    #[test]
    fn all_and_none_are_two_choices_with_keys_of_their_own() {
        let key = |choice: &PatchChoice| Hasher::default().of(choice).finish();
        let choices = [PatchChoice::All, PatchChoice::At(Vec::new()), PatchChoice::At(vec![[0.0; 3]])];
        assert!((0..3).all(|i| choices[..i].iter().all(|c| key(c) != key(&choices[i]))));
    }
}
