//! Comments of a program as data. Their words are handed in by whoever has a program written, so that this room
//! knows none; they are English on every controller.

use super::shortfall::ByHand;
use crate::beam::{ProcessSettings, WorkingMedium};
use crate::cell::Mount;
use crate::part::Units;
use crate::part::units::StatedUnit;
use crate::path::{Direction, Order};

/// The words of a comment. Lines of a text with several stay lines.
pub type Wording = fn(&Comment) -> String;

/// Empty comments, for a program that nobody reads but its own reader: comments do nothing.
pub const WITHOUT_WORDS: Wording = |_| String::new();

/// What a comment of a program says.
#[derive(Clone, Debug, PartialEq)]
pub enum Comment {
    /// Which part the program is for.
    Part(String),
    /// Which surfaces it cleans.
    Surfaces {
        /// Numbers of the first ones.
        shown: Vec<u32>,
        /// How many there are beside those.
        more: usize,
    },
    /// What some of its lit pieces are worked with.
    WorkedWith(ProcessFigures),
    /// What some of its pieces are ground with.
    GroundWith(GrindingFigures),
    /// How the lines are laid on the surfaces.
    LineLayout {
        /// Direction of the planes.
        direction: Direction,
        /// Distance of lines, mm.
        spacing_mm: f64,
        /// Order of lines.
        order: Order,
    },
    /// Counts of targets.
    Targets {
        /// All of them.
        all: usize,
        /// Targets whose beam was turned.
        corrected: usize,
        /// Targets that are left out.
        blocked: usize,
    },
    /// It was planned without a robot.
    WithoutRobot(Mount),
    /// It was planned with this robot.
    Robot {
        /// Its name.
        name: String,
        /// What the robot carries.
        mount: Mount,
    },
    /// Figures of the robot's file that nobody has checked.
    Unchecked(Vec<String>),
    /// The part's file is not read as it was meant.
    PartFile(FileNote),
    /// No program was ever run on such a controller.
    NeverRun {
        /// Its dialect.
        dialect: String,
        /// The file of the program's dry run.
        dry_run: String,
    },
    /// The program is a dry run.
    DryRun {
        /// Its speed, per cent of the program's.
        percent: f64,
    },
    /// The program begins with this pass, from 0; those before it are done.
    FromPass(usize),
    /// What of a dialect is not verified.
    Caveat(Caveat),
    /// A pass begins.
    Pass {
        /// Its number in the program, from 0.
        number: usize,
        /// Number of its surface.
        surface: u32,
        /// Number of its layer, from 0.
        layer: u32,
    },
    /// A contact tool presses with so many newtons from here on; 0: no more. For controllers without words for it.
    Force(f64),
    /// The operator has to set a figure before the program goes on.
    Set(ByHand),
}

/// What is to be known of a part's file before a program for it is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileNote {
    /// It states one unit, and was read in another.
    UnitOverridden {
        /// The unit that it states.
        stated: StatedUnit,
        /// The unit that was taken.
        units: Units,
    },
    /// So many facets cannot be used.
    FacetsDropped(usize),
    /// It holds other facets than its header says.
    CountDiffers {
        /// Facets by its header.
        promised: usize,
        /// Facets that were read.
        read: usize,
    },
    /// So many things that are no facets were left out.
    NotRead(usize),
    /// Bytes belong to nothing that is known.
    BytesPassedOver {
        /// How many.
        count: usize,
        /// Where the first of them stands.
        at: usize,
    },
    /// So many solids became one part.
    SolidsJoined(usize),
}

/// Dialects that say at the head of a program what of them is not verified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Caveat {
    /// ABB RAPID.
    Rapid,
    /// ESTUN.
    Erp,
    /// KUKA KRL.
    Krl,
    /// Yaskawa INFORM.
    Inform,
}

/// What a lit piece is worked with, as far as programs say it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProcessFigures {
    /// Power, W.
    pub power_w: f64,
    /// Frequency of pulses, kHz; 0 for a laser without.
    pub frequency_khz: f64,
    /// Diameter of the spot, mm.
    pub spot_mm: f64,
    /// Defocus, mm.
    pub defocus_mm: f64,
    /// Speed of the spot, mm/s.
    pub speed_mm_s: f64,
}

/// What a piece is ground with, as far as programs say it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrindingFigures {
    /// Whether by a belt rather than a disc.
    pub is_belt: bool,
    /// Force, N; 0: none is kept.
    pub force_n: f64,
    /// Speed of the contact, mm/s.
    pub speed_mm_s: f64,
}

impl Comment {
    /// What pieces of these settings are worked with.
    pub fn of_settings(settings: &ProcessSettings) -> Comment {
        match settings.medium {
            WorkingMedium::Light => Comment::WorkedWith(ProcessFigures::of(settings)),
            medium => Comment::GroundWith(GrindingFigures {
                is_belt: medium == WorkingMedium::Belt,
                force_n: settings.force_n,
                speed_mm_s: settings.speed_mm_s,
            }),
        }
    }
}

impl ProcessFigures {
    /// The figures of process settings. A head that is drawn back widens the spot by any number of digits: lengths
    /// are given to a ten-thousandth of a millimetre.
    pub fn of(settings: &ProcessSettings) -> ProcessFigures {
        let short = |mm: f64| (mm * 1e4).round() / 1e4;
        ProcessFigures {
            power_w: settings.power_w,
            frequency_khz: settings.frequency_khz,
            spot_mm: short(settings.spot_mm),
            defocus_mm: short(settings.defocus_mm),
            speed_mm_s: settings.speed_mm_s,
        }
    }
}
