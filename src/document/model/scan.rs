//! The `[scan]` table of a job: the scan of the part as it is, what is done to it and where it lies on the model. A job
//! without files has no scan. What it decides of it stands in `scan_choices`; what the points say is `scan`'s.

use super::declare::parameters;
use super::scan_choices::{ContinuedDamage, PatchChoice, ScanLines, ScanRegion, ScanTogether, ScanWork};
use crate::cell::{Frame, Mount};
use crate::part::{Units, keyed};
use crate::scan::cleaning::Step;
use crate::scan::transform_file::{MatrixFault, rigid};
use nalgebra::Isometry3;
use serde::{Deserialize, Serialize};

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
        /// How they come together, where there are several.
        pub together: ScanTogether = ScanTogether::Shared,
        /// What is done to the points, in order.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub steps: Vec<Step> = Vec::new(),
        /// Points of the scan and where they are on the model, picked by the operator.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub pairs: Vec<PickedPair> = Vec::new(),
        /// Damage across which the part's own sound regions are continued: the model is the part without it (P3's third
        /// case).
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub continued: Vec<ContinuedDamage> = Vec::new(),
        /// What does not count when the scan is laid on the model.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub left_out: Vec<ScanRegion> = Vec::new(),
        /// Where the scanner's frame stands in the robot's base: given, or fitted to markers. It counts where the robot
        /// carries the laser.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub base_from_scan: Option<Frame> = None,
        /// Where the scanner's frame stands on the flange, where the robot carries the part.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub flange_from_scan: Option<Frame> = None,
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

impl JobScan {
    /// Whether the job has a scan.
    pub fn is_there(&self) -> bool {
        !self.files.is_empty()
    }

    /// Where the scanner's frame stands, in the frame of what carries the part: the robot's base, or its flange.
    pub fn scanner(&self, mount: Mount) -> Option<&Frame> {
        match mount {
            Mount::ToolInHand => self.base_from_scan.as_ref(),
            Mount::PartInHand => self.flange_from_scan.as_ref(),
        }
    }

    /// The transform that is given; `None`: it is to be looked for.
    ///
    /// # Errors
    /// The numbers are no motion.
    pub fn model_from_scan(&self) -> Result<Option<Isometry3<f64>>, MatrixFault> {
        self.transform.as_ref().map(rigid).transpose()
    }
}

keyed!(ScanFile { file, sha256 });
keyed!(PickedPair { model_mm, scan_mm });

#[cfg(test)]
mod tests {
    use crate::document::JobFileError;
    use crate::document::job_file::parse;

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
