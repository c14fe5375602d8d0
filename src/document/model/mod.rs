//! The job: everything an operator decides. What can be computed is not in it. As TOML it is written by
//! `job_file`.

mod bead;
mod beam;
mod by_key;
mod cleaning_steps;
mod declare;
mod job_cell;
mod job_part;
mod lines;
mod path;
mod scan;
mod scan_choices;
mod surfaces;
mod weld;
mod weld_choices;

pub use bead::BeadParameters;
pub use beam::BeamParameters;
pub use job_cell::JobCell;
pub use job_part::JobPart;
pub use lines::{FirstPlane, LineParameters};
pub use path::PathParameters;
pub use scan::{JobScan, PickedPair, ScanFile};
pub use scan_choices::{ContinuedDamage, ContinuedKind, PatchChoice, ScanLines, ScanRegion, ScanTogether, ScanWork};
pub use surfaces::SurfaceParameters;
pub(super) use surfaces::SurfaceTable;
pub use weld::JobWeld;
pub use weld_choices::{AreaChoice, GrindingStrategy, GroundPass, NamedImage, RoughnessReading, WeldFiles};

use super::recipe::Recipe;
use super::settings::Settings;
use crate::beam::{Obstacle, Optics};
use crate::cell::Mount;
use crate::part::{Part, Surfaces};
use crate::pose::Correction;
use crate::process::DoseParameters;

/// A job. Lengths mm, angles degrees.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Job {
    /// The part's file and how it stands.
    pub part: JobPart,
    /// The scan of the part as it is.
    pub scan: JobScan,
    /// The weld that is ground: its images, and what is made of them.
    pub weld: JobWeld,
    /// How facets become feature surfaces.
    pub surfaces: SurfaceParameters,
    /// What is said of single surfaces: whether they are cleaned and in which order, names, sides, recipes, tilts.
    pub settings: Settings,
    /// The section planes.
    pub layers: LineParameters,
    /// The beam, its speeds and its head.
    pub beam: BeamParameters,
    /// How wide the beam is.
    pub optics: Optics,
    /// Which points of a line become targets, and what is done about interference.
    pub path: PathParameters,
    /// What the beam lays on the part.
    pub bead: BeadParameters,
    /// Energy on the surface.
    pub dose: DoseParameters,
    /// The robot cell.
    pub cell: JobCell,
    /// What stands on the part, in the part frame.
    pub clamps: Vec<Obstacle>,
    /// What surfaces can be worked with in place of the job's own values.
    pub recipes: Vec<Recipe>,
}

impl Job {
    /// A new job that grinds a weld: on the part of its depth image, with lines and speed as grinding has them.
    pub fn grinding(weld: JobWeld) -> Job {
        let mut job = Job { weld, ..Job::default() };
        job.part.file.clone_from(&job.weld.images.depth.file);
        job.layers.spacing_mm = GRINDING_SPACING_MM;
        job.beam.speed_mm_s = GRINDING_SPEED_MM_S;
        job.beam.defocus_mm = 0.0;
        job.path.correction = Correction::None;
        job.path.chord_error_mm = GRINDING_CHORD_ERROR_MM;
        // What is ground is large, and stands still.
        job.cell.mount = Some(Mount::ToolInHand);
        job
    }
}

/// Lines of a disc of 30 mm that leans by 10° leave ridges of 0.018 mm between them at this distance: `s² sin τ / 8r`.
const GRINDING_SPACING_MM: f64 = 5.0;
/// Abrasives give way by more; a fifth of it would make four times the targets on a curved skin.
const GRINDING_CHORD_ERROR_MM: f64 = 0.05;
/// The slowest of the four feeds that P4 compares.
const GRINDING_SPEED_MM_S: f64 = 50.0;

/// The surfaces of a part under a job.
pub fn segmented(part: &Part, job: &Job) -> Surfaces {
    let s = &job.surfaces;
    let flipped: Vec<u32> = job.settings.having(|s| s.flipped).iter().map(|id| id.0).collect();
    Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &s.rule(), &s.edits, &flipped)
}

impl Job {
    /// Numbers of the surfaces to clean in the order of work, given all that exist: see [`Settings::chosen`]. Where a
    /// scan tells them, those.
    pub fn chosen(&self, surfaces: &Surfaces) -> Vec<u32> {
        if let Some(worked) = &surfaces.worked {
            return worked.iter().map(|id| id.0).collect();
        }
        self.settings.chosen(surfaces.ids()).into_iter().map(|id| id.0).collect()
    }
}
