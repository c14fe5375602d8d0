//! The files of a finished plan: job, program, report and path. Each appears whole or not at all,
//! and the same job gives the same bytes.

use super::dose::{self, DoseReport, dose};
use super::plan::Plan;
use super::report::Report;
use super::verify;
use crate::cell::Setup;
use crate::cell::motion::Choice;
use crate::document::{
    files::{self, JobError},
    model::Job,
};
use crate::part::{Part, Surfaces};
use crate::program::{Program, ProgramFile, Step, Steps, Timeline, dialects, lines};
use crate::progress::Progress;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// What a file of a plan is called, and its bytes.
pub struct OutputFile {
    /// Name within the folder.
    pub name: String,
    /// Contents.
    pub bytes: Vec<u8>,
}

/// The files of a plan, and what they report; the program is read back and compared with the plan, and
/// the dose is computed. `job` names its part and cell relative to the folder they will stand in.
pub fn files(
    job: &Job,
    part_name: &str,
    part: &Part,
    setup: &Setup,
    plan: &Plan,
    surfaces: &Surfaces,
) -> Result<(Vec<OutputFile>, Report), JobError> {
    let mut report = Report::new(plan, surfaces);
    let dose = dose(part, surfaces, plan, job, setup, &Progress::default())
        .map_err(|e| JobError::Write { what: format!("the dose: {e}") })?;
    let patches = dose::not_cleanable(part, surfaces, plan, job, &dose);
    report.dose = Some(DoseReport::new(&dose, &patches, surfaces));
    let mut json = serde_json::to_string_pretty(&report).map_err(|e| JobError::Write { what: e.to_string() })?;
    json.push('\n');
    let written = program(job, part_name, setup, plan, &report)?;
    read_back(part, job, setup, plan, &written)?;
    let file = |name: String, bytes: Vec<u8>| OutputFile { name, bytes };
    let mut out = vec![file("job.toml".into(), files::to_toml(job)?.into_bytes())];
    out.extend(written.into_iter().map(|f| file(f.name, f.text.into_bytes())));
    out.push(file("report.json".into(), json.into_bytes()));
    out.push(file("path.csv".into(), path_csv(plan).into_bytes()));
    if let Some(choice) = &plan.choice {
        out.push(file("joints.csv".into(), joints_csv(plan, choice).into_bytes()));
    }
    out.push(file("dose.ply".into(), dose::ply(&dose, surfaces)));
    Ok((out, report))
}

/// The program's files as they would be written, the one to start first.
///
/// # Errors
/// What the controller could not take.
pub fn program(
    job: &Job,
    part_name: &str,
    setup: &Setup,
    plan: &Plan,
    report: &Report,
) -> Result<Vec<ProgramFile>, JobError> {
    let lines = lines(&plan.steps, setup);
    let program = Program { head: head(job, part_name, setup, (&plan.steps, report)), lines, setup };
    let refused = |what: String| JobError::Write { what: format!("the program cannot be written: {what}") };
    let dialect = dialects::known(&job.cell.dialect).map_err(refused)?;
    dialect.write(&program).map_err(|e| refused(e.to_string()))
}

/// Reads the program's own text, and refuses to hand out one that would not do what was planned.
fn read_back(part: &Part, job: &Job, setup: &Setup, plan: &Plan, written: &[ProgramFile]) -> Result<(), JobError> {
    let verdict = verify::check_own(part, plan, setup, job, written)
        .map_err(|what| JobError::Write { what: format!("the program cannot be read back: {what}") })?;
    match verdict.findings.as_slice() {
        [] => Ok(()),
        [first, ..] => Err(JobError::Write {
            what: format!(
                "the program, read back, is not the plan: {}:{}: {} ({} findings); nothing was written",
                first.file,
                first.line,
                first.text,
                verdict.findings.len()
            ),
        }),
    }
}

/// Writes a plan into a folder, made if it is not there; the files, and what they report.
///
/// # Errors
/// What could not be written, and why.
pub fn write(
    dir: &Path,
    job: &Job,
    job_file: Option<&Path>,
    part: &Part,
    setup: &Setup,
    plan: &Plan,
    surfaces: &Surfaces,
) -> Result<(Vec<PathBuf>, Report), JobError> {
    std::fs::create_dir_all(dir).map_err(|e| JobError::write(dir, &e))?;
    let part_name =
        files::beside(job_file, &job.part.file).file_name().map_or(String::new(), |n| n.to_string_lossy().into());
    let moved = files::rebased(job, job_file, &dir.join("job.toml"))?;
    let mut written = Vec::new();
    let (files, report) = files(&moved, &part_name, part, setup, plan, surfaces)?;
    for f in files {
        let path = dir.join(&f.name);
        files::write_atomic(&path, &f.bytes)?;
        written.push(path);
    }
    Ok((written, report))
}

/// Comments at the head of a program.
fn head(job: &Job, part_name: &str, setup: &Setup, (steps, report): (&Steps, &Report)) -> Vec<String> {
    let list: Vec<String> = report.surfaces.iter().map(|s| s.surface.to_string()).collect();
    let shown =
        if list.len() > 20 { format!("{} and {} more", list[..20].join(" "), list.len() - 20) } else { list.join(" ") };
    let mut out =
        vec![format!("clearbeam {}, part {part_name}", env!("CARGO_PKG_VERSION")), format!("surfaces {shown}")];
    out.extend(worked_with(steps));
    out.extend([
        format!(
            "direction {}, spacing {} mm, {}",
            job.layers.direction,
            job.layers.spacing_mm,
            job.layers.order.word()
        ),
        format!("{} targets, {} corrected, {} blocked and left out", report.points, report.corrected, report.blocked),
    ]);
    match &setup.robot {
        None => out.push(format!("Flange poses, {}; reach and limits are NOT checked", setup.mount.word())),
        Some(robot) => {
            out.push(format!("{}, {}", robot.name, setup.mount.word()));
            if !robot.unverified.is_empty() {
                out.push(format!("Figures of the robot that nobody has checked: {}", robot.unverified.join(", ")));
            }
        }
    }
    out.push(format!("Not verified on a {} controller: run it with the laser off first", job.cell.dialect));
    out
}

/// What the lit pieces are worked with, each once, in the order of work.
fn worked_with(steps: &Steps) -> Vec<String> {
    // A head that is drawn back widens the spot by any number of digits.
    let short = |mm: f64| (mm * 1e4).round() / 1e4;
    let mut out: Vec<String> = Vec::new();
    for step in &steps.list {
        let Step::Work(w) = step else { continue };
        let pulses = if w.frequency_khz > 0.0 { format!(" at {} kHz", w.frequency_khz) } else { String::new() };
        let said = format!(
            "power {} W{pulses}, spot {} mm, defocus {} mm, speed {} mm/s",
            w.power_w,
            short(w.spot_mm),
            short(w.defocus_mm),
            w.speed_mm_s
        );
        if !out.contains(&said) {
            out.push(said);
        }
    }
    out
}

/// `path.csv`: one row a target.
pub fn path_csv(plan: &Plan) -> String {
    let mut out = String::from(
        "pass,point,surface,laser,state,px,py,pz,nx,ny,nz,ax,ay,az,ox,oy,oz,x,y,z,tilt_deg,clearance_mm\n",
    );
    for (number, pass) in plan.passes.iter().enumerate() {
        for (point, t) in pass.targets.iter().enumerate() {
            let _ = write!(out, "{number},{point},{},{},{}", pass.surface, u8::from(t.laser), t.state.word());
            let focus = t.focus(pass.work.defocus_mm);
            let vectors = [&t.p.coords, &t.n, &t.a, &t.o, &focus.coords];
            for value in vectors.into_iter().flat_map(|v| v.iter()).chain([&t.tilt_deg()]) {
                out.push(',');
                push_number(&mut out, *value);
            }
            out.push(',');
            if let Some(mm) = t.clearance_mm {
                push_number(&mut out, mm);
            }
            out.push('\n');
        }
    }
    out
}

/// `joints.csv`: one row for each target that the robot does.
fn joints_csv(plan: &Plan, choice: &Choice) -> String {
    let mut out = String::from("pass,point,laser,j1,j2,j3,j4,j5,j6,spin_deg,time_s,singularity,min_limit_margin_deg\n");
    let stops = plan.timeline.iter().flat_map(Timeline::stops);
    let times: BTreeMap<(usize, usize), f64> = stops.filter_map(|s| s.target.map(|t| (t, s.at_s))).collect();
    let mut at_s = 0.0;
    for (number, pass) in plan.passes.iter().enumerate() {
        for (point, t) in pass.targets.iter().enumerate() {
            let Some(c) = &choice.rows[number][point] else { continue };
            // A target between two blocked ones is reachable, but no lit move goes there.
            at_s = times.get(&(number, point)).copied().unwrap_or(at_s);
            let _ = write!(out, "{number},{point},{}", u8::from(t.laser));
            for value in c.joints_deg.iter().chain([&c.spin_deg]) {
                out.push(',');
                push_number(&mut out, *value);
            }
            for value in [at_s, c.singularity, c.limit_margin_deg] {
                out.push(',');
                push_number(&mut out, value);
            }
            out.push('\n');
        }
    }
    out
}

/// Eleven decimals without the zeros at the end: at least nine significant digits for every
/// number that is not below a hundredth.
fn push_number(out: &mut String, value: f64) {
    let start = out.len();
    let _ = write!(out, "{value:.11}");
    while out.ends_with('0') {
        out.pop();
    }
    if out.ends_with('.') {
        out.pop();
    }
    if &out[start..] == "-0" {
        out.replace_range(start.., "0");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_nine_digits_and_no_minus_zero() {
        let text = |v: f64| {
            let mut s = String::from("x,");
            push_number(&mut s, v);
            s
        };
        assert_eq!(text(35.2), "x,35.2");
        assert_eq!(text(-1e-14), "x,0");
        assert_eq!(text(1.0 / 3.0), "x,0.33333333333");
        assert_eq!(text(100.0), "x,100");
    }
}
