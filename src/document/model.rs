//! The job: everything an operator decides. What can be computed is not in it. As TOML it is written by
//! `job_file`.

use super::recipe::Recipe;
use super::remembered::Remembered;
use super::settings::Settings;
use crate::beam::{Obstacle, Optics};
use crate::cell::{Cell, Frame, Mount, Spin};
use crate::part::{Part, Placement, SurfaceEdit, SurfaceRule, Surfaces, Units};
use crate::path::{Axis, Direction, Order, Strategy};
use crate::pose::Correction;
use crate::process::DoseParameters;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};

/// A job. Lengths mm, angles degrees.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Job {
    /// The part's file and how it stands.
    pub part: PartFile,
    /// How facets become feature surfaces.
    pub surfaces: SurfaceParameters,
    /// What is said of single surfaces: whether they are cleaned and in which order, names, sides, recipes, tilts.
    pub settings: Settings,
    /// The section planes.
    pub layers: Layers,
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
    pub cell: CellFile,
    /// What stands on the part, in the part frame.
    pub clamps: Vec<Obstacle>,
    /// What surfaces can be worked with in place of the job's own values.
    pub recipes: Vec<Recipe>,
}

/// The part's file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PartFile {
    /// Path, relative to the job file.
    pub file: String,
    /// SHA-256 of its bytes when the job was saved; empty: any.
    pub sha256: String,
    /// Unit of its coordinates.
    pub units: Units,
    /// Shells whose other side is to be worked on.
    pub flipped_shells: Vec<u32>,
    /// Where the part stands.
    pub placement: Placement,
    /// What its surfaces looked like when the job was saved.
    #[serde(skip_serializing_if = "Remembered::is_empty")]
    pub landmarks: Remembered,
}

impl PartFile {
    /// Whether the job was made for other bytes than those of this SHA-256.
    pub fn is_of_another_file(&self, sha256: &str) -> bool {
        !self.sha256.is_empty() && self.sha256 != sha256
    }
}

/// How facets become feature surfaces.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceParameters {
    /// Dihedral angle from which an edge is a crease (α).
    pub angle_deg: f64,
    /// Islands below this area are absorbed; 0 = off.
    pub min_area_mm2: f64,
    /// Lower angle of the hysteresis; 0 = off.
    pub hysteresis_deg: f64,
    /// Merges and splits in the order made.
    pub edits: Vec<SurfaceEdit>,
}

impl Default for SurfaceParameters {
    fn default() -> Self {
        SurfaceParameters { angle_deg: 20.0, min_area_mm2: 0.0, hysteresis_deg: 0.0, edits: Vec::new() }
    }
}

impl SurfaceParameters {
    /// The rule without the operator's edits.
    pub fn rule(&self) -> SurfaceRule {
        SurfaceRule { angle_deg: self.angle_deg, min_area_mm2: self.min_area_mm2, hysteresis_deg: self.hysteresis_deg }
    }
}

/// How lines are laid on surfaces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Layers {
    /// Planes, lines that follow the surface, or a spiral.
    pub strategy: Strategy,
    /// Normal of the planes: `x`, `y`, `z`, `auto` or `DX,DY,DZ`.
    pub direction: Direction,
    /// Distance of the planes, or of the lines on the surface.
    pub spacing_mm: f64,
    /// Where the first plane lies.
    pub offset_mm: Offset,
    /// Sense and order of the lines.
    pub order: Order,
    /// How often the surface is gone over.
    pub passes: f64,
    /// What lines keep from the rim; negative: how far they run on over it.
    pub inset_mm: f64,
    /// Holes narrower than this keep no lines off.
    pub ignore_holes_mm: f64,
    /// Pieces of a line with a gap up to this between them are one pass, the laser off over the gap.
    pub join_mm: f64,
    /// Shorter pieces are left out.
    pub shortest_mm: f64,
    /// How far a closed line begins behind where the one before does.
    pub seam_shift_mm: f64,
    /// Between the two rasters of a cross.
    pub cross_deg: f64,
    /// For offset lines: the border to start from, 0 the longest; without it the whole outline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub border: Option<u32>,
    /// For a spiral: its centre, or the nearest point of the surface to it, in the part frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre_mm: Option<[f64; 3]>,
    /// For a spiral: from the rim to the centre.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub inward: bool,
}

impl Default for Layers {
    fn default() -> Self {
        Layers {
            direction: Direction::Along([0.0, 0.0, 1.0]),
            spacing_mm: 0.5,
            offset_mm: Offset::Centred,
            order: Order::Zigzag,
            strategy: Strategy::Planes,
            passes: 1.0,
            inset_mm: 0.0,
            ignore_holes_mm: 0.0,
            join_mm: 0.0,
            shortest_mm: 0.0,
            seam_shift_mm: 0.0,
            cross_deg: 90.0,
            border: None,
            centre_mm: None,
            inward: false,
        }
    }
}

/// Where the first plane of a family lies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Offset {
    /// The family is centred on the extent.
    #[default]
    Centred,
    /// So far above the lowest point of the extent, mm.
    FromLowest(f64),
}

impl Offset {
    /// The number, where there is one.
    pub fn mm(self) -> Option<f64> {
        match self {
            Offset::Centred => None,
            Offset::FromLowest(mm) => Some(mm),
        }
    }
}

impl Serialize for Offset {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            Offset::Centred => s.serialize_str("centred"),
            Offset::FromLowest(mm) => s.serialize_f64(*mm),
        }
    }
}

impl<'de> Deserialize<'de> for Offset {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Raw {
            Number(f64),
            Word(String),
        }
        match Raw::deserialize(d)? {
            Raw::Number(mm) => Ok(Offset::FromLowest(mm)),
            Raw::Word(w) if w == "centred" => Ok(Offset::Centred),
            Raw::Word(w) => Err(D::Error::custom(format!("{w:?}: give \"centred\" or a number of mm"))),
        }
    }
}

/// The beam and its speeds (P1 Table 1).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BeamParameters {
    /// D: the focus stands at `p + D·a`.
    pub defocus_mm: f64,
    /// Laser power.
    pub power_w: f64,
    /// Diameter of the spot on the part.
    pub spot_mm: f64,
    /// Speed of the spot on the part.
    pub speed_mm_s: f64,
    /// Frequency of the laser's pulses, kHz; 0: none, or as it is set at the laser.
    pub frequency_khz: f64,
    /// Speed of the focus with the laser off.
    pub air_speed_mm_s: f64,
    /// Head: a TOML stack or an STL, relative to the job file; empty: the beam is a ray.
    pub head: String,
    /// What cone and head keep from everything, mm.
    pub margin_mm: f64,
}

impl Default for BeamParameters {
    fn default() -> Self {
        BeamParameters {
            defocus_mm: 20.0,
            power_w: 500.0,
            spot_mm: 1.0,
            speed_mm_s: 3.0,
            frequency_khz: 0.0,
            air_speed_mm_s: 100.0,
            head: String::new(),
            margin_mm: 0.5,
        }
    }
}

/// Which points of a line become targets.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PathParameters {
    /// Distance of a dropped point from the chord that spans it (dε of P2).
    pub chord_error_mm: f64,
    /// Longest chord.
    pub max_step_mm: f64,
    /// Largest turn of the normal between two targets.
    pub max_turn_deg: f64,
    /// What the beam stands along where nothing is in its way.
    pub axis: Axis,
    /// What is done about interference.
    pub correction: Correction,
    /// Greatest angle between beam and normal, degrees.
    pub max_tilt_deg: f64,
    /// How fast the search may turn the beam against the normal along the line, degrees/mm.
    pub tilt_rate_deg_mm: f64,
    /// The same over time, degrees/s.
    pub tilt_rate_deg_s: f64,
    /// How far the head may be drawn back or pushed forward on a line that is blocked otherwise, mm.
    pub standoff_mm: f64,
    /// The spot comes so far along the line with the laser off, at the speed of the work, mm.
    pub lead_in_mm: f64,
    /// And goes on so far behind its end, mm.
    pub lead_out_mm: f64,
}

impl Default for PathParameters {
    fn default() -> Self {
        PathParameters {
            chord_error_mm: 0.02,
            max_step_mm: 5.0,
            max_turn_deg: 5.0,
            axis: Axis::Mesh,
            correction: Correction::SectionPlane,
            max_tilt_deg: 45.0,
            tilt_rate_deg_mm: 5.0,
            tilt_rate_deg_s: 90.0,
            standoff_mm: 0.0,
            lead_in_mm: 0.0,
            lead_out_mm: 0.0,
        }
    }
}

/// The bead that is clad, and its layers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BeadParameters {
    /// Width at its foot (ω of P3), mm; 0: nothing is laid.
    pub width_mm: f64,
    /// Height (h of P3), mm; 0: nothing is laid. Each layer stands so high.
    pub height_mm: f64,
    /// Layers on top of each other.
    pub layers: f64,
    /// How far closed lines begin behind where they begin in the layer before, mm.
    pub start_shift_mm: f64,
    /// Every second layer runs across the others.
    pub alternate: bool,
}

impl Default for BeadParameters {
    fn default() -> Self {
        BeadParameters { width_mm: 0.0, height_mm: 0.0, layers: 1.0, start_shift_mm: 0.0, alternate: false }
    }
}

/// The robot cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct CellFile {
    /// Cell file, relative to the job file; empty: the shipped cell of the robot.
    pub file: String,
    /// Key of a shipped robot, or a robot file relative to the job file; empty: poses only.
    pub robot: String,
    /// What the robot carries; as the cell file says where it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mount: Option<Mount>,
    /// Dialect of the program.
    pub dialect: String,
    /// Rotation about the beam axis.
    pub spin: Spin,
    /// How far the spot may leave the planned line between two targets.
    pub deviation_mm: f64,
    /// Part in hand: how this part is held, in place of the cell's frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flange_from_part: Option<Frame>,
    /// Part in hand: where the laser stands for this job, in place of the cell's frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_from_laser: Option<Frame>,
    /// Tool in hand: where this part lies, in place of the cell's frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub base_from_part: Option<Frame>,
}

impl CellFile {
    /// Takes over where part and laser stand in another.
    pub(super) fn take_frames(&mut self, other: &CellFile) {
        self.flange_from_part.clone_from(&other.flange_from_part);
        self.base_from_laser.clone_from(&other.base_from_laser);
        self.base_from_part.clone_from(&other.base_from_part);
    }

    /// Puts the job's own frames in place of the cell's.
    pub fn put_frames(&self, cell: &mut Cell) {
        for (own, frame) in [
            (&self.flange_from_part, &mut cell.flange_from_part),
            (&self.base_from_laser, &mut cell.base_from_laser),
            (&self.base_from_part, &mut cell.base_from_part),
        ] {
            if let Some(own) = own {
                frame.clone_from(own);
            }
        }
    }
}

impl Default for CellFile {
    fn default() -> Self {
        CellFile {
            file: String::new(),
            robot: String::new(),
            mount: None,
            flange_from_part: None,
            base_from_laser: None,
            base_from_part: None,
            dialect: "nachi".into(),
            spin: Spin::Free,
            deviation_mm: 0.1,
        }
    }
}

/// The surfaces of a part under a job.
pub fn segmented(part: &Part, job: &Job) -> Surfaces {
    let s = &job.surfaces;
    let flipped: Vec<u32> = job.settings.having(|s| s.flipped).iter().map(|id| id.0).collect();
    Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &s.rule(), &s.edits, &flipped)
}

impl Job {
    /// Numbers of the surfaces to clean in the order of work, given all that exist: see [`Settings::chosen`].
    pub fn chosen(&self, surfaces: &Surfaces) -> Vec<u32> {
        self.settings.chosen(surfaces.ids()).into_iter().map(|id| id.0).collect()
    }
}
