//! The `[scan]` table of a job: the scan of the part as it is, what is done to it, where it lies on the model, and which
//! patches are worked. A job without files has no scan. What the scan's points say is `scan`'s.

use super::declare::parameters;
use crate::cell::Frame;
use crate::part::{Hasher, Keyed, Units, keyed};
use crate::scan::cleaning::Step;
use crate::scan::transform_file::{MatrixFault, rigid};
use nalgebra::{Isometry3, Point3};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

parameters! {
    /// The scan of a job.
    ///
    /// The frame of the scan is that of its first file, in mm; the model's is the part frame.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default, deny_unknown_fields)]
    pub struct JobScan in "scan" {
        /// Unit of the coordinates in the files.
        pub units: Units = Units::Mm,
        /// What is missing by more than this, or too much by more, is a patch, mm.
        pub min_depth_mm: f64,
        /// Half the width of the band within which the part is as it ought to be, mm.
        pub tolerance_mm: f64,
        /// A part that is off its model by more than this, where the scan was compared, is refused: it may be another one,
        /// mm; 0: none is.
        pub gate_mm: f64,
        /// What is worked.
        pub work: ScanWork = ScanWork::Patches,
        /// `model_from_scan`, 16 numbers row by row, where it is given or was taken over; else it is looked for.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub transform: Option<[f64; 16]> = None,
        /// What lines are laid on.
        pub lines: ScanLines = ScanLines::Facets,
        /// Which patches are worked.
        #[serde(skip_serializing_if = "PatchChoice::is_all")]
        pub patches: PatchChoice = PatchChoice::All,
        /// The files, in the order in which they were added.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub files: Vec<ScanFile> = Vec::new(),
        /// What is done to the points, in order.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub steps: Vec<Step> = Vec::new(),
        /// Points of the scan and where they are on the model, picked by the operator.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub pairs: Vec<PickedPair> = Vec::new(),
        /// What does not count when the scan is laid on the model.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub left_out: Vec<LeftOutRegion> = Vec::new(),
        /// Where the scanner's frame stands in the robot's base: given, or fitted to markers.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub base_from_scan: Option<Frame> = None,
    }
}

/// A file of a scan.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ScanFile {
    /// Path, relative to the job file.
    pub file: String,
    /// SHA-256 of its bytes when it was read, hexadecimal; empty: any.
    pub sha256: String,
}

/// A point of the scan and where it is on the model, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PickedPair {
    /// In the part frame.
    pub model_mm: [f64; 3],
    /// In the frame of the scan.
    pub scan_mm: [f64; 3],
}

/// A region of the model, part frame, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "shape", rename_all = "kebab-case", deny_unknown_fields)]
pub enum LeftOutRegion {
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

impl JobScan {
    /// Whether the job has a scan.
    pub fn is_there(&self) -> bool {
        !self.files.is_empty()
    }

    /// The transform that is given; `None`: it is to be looked for.
    ///
    /// # Errors
    /// The numbers are no motion.
    pub fn model_from_scan(&self) -> Result<Option<Isometry3<f64>>, MatrixFault> {
        self.transform.as_ref().map(rigid).transpose()
    }
}

impl LeftOutRegion {
    /// Whether a point of the model lies in it; its rim belongs to it.
    pub fn contains(&self, point: &Point3<f64>) -> bool {
        match self {
            LeftOutRegion::Sphere { centre_mm, radius_mm } => {
                (point - Point3::from(*centre_mm)).norm_squared() <= radius_mm * radius_mm
            }
            LeftOutRegion::Box { min_mm, max_mm } => (0..3).all(|k| (min_mm[k]..=max_mm[k]).contains(&point[k])),
        }
    }
}

impl PatchChoice {
    fn is_all(&self) -> bool {
        *self == PatchChoice::All
    }
}

keyed!(ScanFile { file, sha256 });
keyed!(PickedPair { model_mm, scan_mm });

impl Keyed for LeftOutRegion {
    fn feed(&self, into: &mut Hasher) {
        match self {
            LeftOutRegion::Sphere { centre_mm, radius_mm } => {
                "sphere".feed(into);
                centre_mm.feed(into);
                radius_mm.feed(into);
            }
            LeftOutRegion::Box { min_mm, max_mm } => {
                "box".feed(into);
                min_mm.feed(into);
                max_mm.feed(into);
            }
        }
    }
}

impl Keyed for ScanWork {
    fn feed(&self, into: &mut Hasher) {
        match self {
            ScanWork::Patches => "patches".feed(into),
            ScanWork::Surfaces => "surfaces".feed(into),
        }
    }
}

impl Keyed for ScanLines {
    fn feed(&self, into: &mut Hasher) {
        match self {
            ScanLines::Facets => "facets".feed(into),
            ScanLines::Points => "points".feed(into),
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
    use crate::document::JobFileError;
    use crate::document::job_file::parse;

    #[test]
    fn a_region_has_its_rim_and_nothing_beyond() {
        let ball = LeftOutRegion::Sphere { centre_mm: [1.0, 2.0, 3.0], radius_mm: 5.0 };
        let cuboid = LeftOutRegion::Box { min_mm: [0.0; 3], max_mm: [1.0, 2.0, 3.0] };
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

    #[test]
    fn what_is_no_motion_or_no_choice_is_told_in_its_line() {
        let line = |text: &str| match parse(text).expect_err(text) {
            JobFileError::InLine { line, what } => (line, what.to_string()),
            other => panic!("{text}: {other}"),
        };
        let (at, why) = line("[scan]\n\ntransform = [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1]");
        assert!(at == 3 && why.contains("Scales"), "{at}: {why}");
        let (at, _) = line("[scan]\ntransform = [1, 0, 0, 1e11, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]");
        assert_eq!(at, 2);
        let (at, why) = line("[scan]\nbase_from_scan = { points = [] }");
        assert!(at == 2 && why.contains("0 pairs"), "{at}: {why}");
        for (text, word) in [
            ("[scan]\npatches = \"deep\"", "all"),
            ("[[scan.files]]\nname = \"a.ply\"", "name"),
            ("[[scan.left_out]]\nshape = \"cone\"", "sphere"),
            ("[[scan.steps]]\nstep = \"wash\"", "outliers"),
        ] {
            let why = parse(text).expect_err(text).to_string();
            assert!(why.contains(word), "{text}: {why}");
        }
    }
}
