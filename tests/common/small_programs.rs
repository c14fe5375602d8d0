//! One small program of each dialect, with a robot and without: outputs, dwells, moves in the air, leads, and sub-programs
//! where the dialect has them; and whether a changed one is found.
#![allow(dead_code, reason = "each test file uses its own share")]

#[path = "parts.rs"]
mod parts;

use clearbeam::cell::{Robot, Setup};
use clearbeam::planning::verify::{AsWritten, Finding};
use clearbeam::program::{Comment, Dialect, Program, ProgramFile, ProgramLine, ReadError, dialects, lines};
use clearbeam::sample::solids;
use clearbeam::text::program_comment;
use parts::{job, on, part, planned_in};

const OUTPUTS: &str = "laser = { number = 3 }\n\
    shielding_gas = { number = 5, on_wait_s = 0.5, off_wait_s = 1.0, during = \"piece\" }\n\
    power = { as = \"group\", number = 2, scale = 0.255 }\n";

pub struct Case {
    pub dialect: &'static dyn Dialect,
    pub setup: Setup,
    pub lines: Vec<ProgramLine>,
    pub files: Vec<ProgramFile>,
    defocus_mm: f64,
}

/// The cell, with words of every signal in every dialect and programs that are cut early.
fn setup(robot: bool) -> Setup {
    let mut setup = Setup::shipped().expect("shipped");
    setup.robot = robot.then(|| Robot::load("mz04", None).expect("shipped"));
    let c = &mut setup.cell;
    c.outputs = toml::from_str(OUTPUTS).expect("outputs");
    c.nachi.group = "GOUT {n},{v}".into();
    c.yaskawa.pulses_per_deg = Some([1000.0; 6]);
    (c.nachi.max_moves, c.ur.max_moves, c.abb.max_moves) = (8, 8, 8);
    (c.kuka.max_lines, c.yaskawa.max_lines, c.fanuc.max_lines) = (30, 20, 20);
    setup
}

/// All programs: every dialect, with the robot and without.
pub fn cases() -> Vec<Case> {
    let mut out = Vec::new();
    for robot in [false, true] {
        let setup = setup(robot);
        let mut job = on(job("auto", 4.0), &[1]);
        job.path.lead_in_mm = 2.0;
        let planned = planned_in(part(&solids::cube(8.0)), job, &setup);
        let lines = lines(&planned.plan.steps, &setup);
        for &dialect in dialects::DIALECTS {
            let head = vec![Comment::Part("a part".into())];
            let program = Program { head, lines: lines.clone(), setup: &setup, wording: program_comment };
            let files = dialect.write(&program).unwrap_or_else(|e| panic!("{}: {e}", dialect.name()));
            let defocus_mm = planned.job.beam.defocus_mm;
            out.push(Case { dialect, setup: setup.clone(), lines: lines.clone(), files, defocus_mm });
        }
    }
    out
}

impl Case {
    pub fn name(&self) -> String {
        format!("{}{}", self.dialect.name(), if self.setup.robot.is_some() { " with a robot" } else { "" })
    }

    /// The plan to compare with.
    pub fn as_written(&self) -> AsWritten<'_> {
        AsWritten::new(self.dialect, self.lines.clone(), &self.setup).expect("reads its own")
    }

    pub fn differences(&self, plan: &AsWritten<'_>, files: &[ProgramFile]) -> Result<Vec<Finding>, ReadError> {
        let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
        plan.differences(&files[0], &open, self.defocus_mm)
    }

    /// Whether the text is still known as one of its dialect.
    pub fn is_known(&self, files: &[ProgramFile]) -> bool {
        dialects::of_text(&files[0].text).is_some_and(|d| d.name() == self.dialect.name())
    }

    /// Whether anybody who verifies these files is told of something.
    pub fn is_found(&self, plan: &AsWritten<'_>, files: &[ProgramFile]) -> bool {
        !self.is_known(files) || self.differences(plan, files).map_or(true, |found| !found.is_empty())
    }
}
