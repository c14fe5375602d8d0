//! A program that was read, against the plan it should be: moves, outputs and times one by one, joint
//! ranges and speeds of what is written, and the beam on the way between.
//!
//! What a dialect says beside its moves (tools, zones, settings) is compared with the same plan written
//! afresh and read by the same reader, so that rounding is no deviation and a changed word is one.
//! Comments do nothing and are not looked at.

use super::model::Job;
use super::plan::{self, Plan};
use crate::beam::Work;
use crate::cell::{Joints, Setup};
use crate::part::{Part, angle};
use crate::pose::Beam;
use crate::pose::checker::Checker;

use crate::program::dialect::{Goal, Read, ReadError, ReadLine, ReadMove, Reading};
use crate::program::sweep::{LitMove, Proof, Prover};
use crate::program::{Dialect, Line, Move, Pace, Program, ProgramFile, Way, dialects, lines, lit};
use nalgebra::{Isometry3, Point3};
use rayon::prelude::*;
use serde::Serialize;

/// The spot may stand so far from where it was planned, mm.
pub const MOST_OFF_MM: f64 = 0.01;
/// And the beam with its spin may be turned by so much, degrees.
pub const MOST_TURNED_DEG: f64 = 0.01;
/// Share by which a time may differ: speeds are written with few digits.
const MOST_SLOWER: f64 = 0.02;
/// A joint further off than this stands on another turn or branch, degrees.
const OTHER_TURN_DEG: f64 = 1.0;
/// A joint may be faster than its full speed by this share: joints are written with few digits.
const SPEED_SHARE: f64 = 0.02;
/// Lines looked ahead to find where two programs meet again.
const LOOK_AHEAD: usize = 40;
/// Facets that the slow second opinion may look at.
const CHECKER_BUDGET: usize = 400_000_000;

/// What is wrong with a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// The text cannot be read on from here.
    Unreadable,
    /// A line of the plan is not there.
    Missing,
    /// A line that the plan does not have.
    Extra,
    /// The move leads elsewhere.
    Deviation,
    /// The move takes another time.
    Time,
    /// An output, a wait, a setting or a word differs.
    Setting,
    /// A joint beyond its range, or a pose out of reach.
    Limit,
    /// A joint faster than it can go.
    Speed,
    /// The beam hits the part with the laser on.
    Interference,
}

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// The file.
    pub file: String,
    /// Its line, from 1.
    pub line: usize,
    /// What kind.
    pub kind: Kind,
    /// What, with figures.
    pub text: String,
}

/// What was found.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Verdict {
    /// Moves that were read.
    pub moves: usize,
    /// Moves with the laser on.
    pub lit_moves: usize,
    /// Largest deviation of the spot from the plan among moves that were found, mm.
    pub worst_mm: f64,
    /// Largest turn from the plan, degrees.
    pub worst_deg: f64,
    /// What is proven of the moves with the laser on.
    pub proof: Proof,
    /// In the order of the program.
    pub findings: Vec<Finding>,
}

/// A part, the setup, and what the program should be.
pub struct Expected<'a> {
    /// The part.
    pub part: &'a Part,
    /// Cell and robot.
    pub setup: &'a Setup,
    /// D, mm.
    pub defocus_mm: f64,
    /// Proves its lit moves.
    pub prover: Prover<'a>,
    /// The plan's moves in order.
    pub moves: Vec<&'a Move>,
    /// The plan as it is written, and read again.
    pub written: &'a [ReadLine],
}

/// Reads a program from its first file and compares it with the plan. `open` gives the text of another
/// file in the same folder.
///
/// # Errors
/// The text is of no dialect, or the plan cannot be written in it.
pub fn check(
    part: &Part,
    planned: &Plan,
    setup: &Setup,
    job: &Job,
    first: &ProgramFile,
    open: &dyn Fn(&str) -> Option<String>,
    with_checker: bool,
) -> Result<(&'static str, Verdict), String> {
    let dialect = dialect_of(first)?;
    let lines = lines(&planned.steps, setup);
    let files = dialect.write(&Program { head: Vec::new(), lines: lines.clone(), setup }).map_err(|e| e.to_string())?;
    let own = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let Some(main) = files.first() else { return Err("the plan has no program".into()) };
    let written =
        dialect.read(main, &Reading { setup, open: &own }).map_err(|e| format!("the plan's own program: {e}"))?;
    let prover = plan::prover(part, setup, job).on_layers(&planned.grown);
    let expected =
        Expected { part, setup, defocus_mm: job.beam.defocus_mm, prover, moves: moves(&lines), written: &written };
    let verdict = match dialect.read(first, &Reading { setup, open }) {
        Ok(read) => verify(&expected, &read, with_checker),
        Err(e) => {
            let (file, line) = match &e {
                ReadError::Line { file, line, .. } | ReadError::Gone { file, line, .. } => (file.clone(), *line),
                ReadError::CutOff { file, .. } => (file.clone(), 0),
            };
            let findings = vec![Finding { file, line, kind: Kind::Unreadable, text: e.to_string() }];
            Verdict { findings, ..Verdict::default() }
        }
    };
    Ok((dialect.name(), verdict))
}

/// Reads a program that was just written, its first file first, and compares it with the plan: its words
/// are the plan's own, so it is written and read once.
///
/// # Errors
/// It cannot be read back.
pub fn check_own(
    part: &Part,
    plan: &Plan,
    setup: &Setup,
    job: &Job,
    written: &[ProgramFile],
) -> Result<Verdict, String> {
    let Some(first) = written.first() else { return Ok(Verdict::default()) };
    let open = |name: &str| written.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let read = dialect_of(first)?.read(first, &Reading { setup, open: &open }).map_err(|e| e.to_string())?;
    let lines = lines(&plan.steps, setup);
    let prover = plan::prover(part, setup, job).on_layers(&plan.grown);
    let defocus_mm = job.beam.defocus_mm;
    let expected = Expected { part, setup, defocus_mm, prover, moves: moves(&lines), written: &read };
    Ok(verify(&expected, &read, false))
}

fn dialect_of(first: &ProgramFile) -> Result<&'static dyn Dialect, String> {
    dialects::of_text(&first.text).ok_or_else(|| {
        format!(
            "{}: is no program of any dialect known here ({}); give the file that was exported",
            first.name,
            dialects::names()
        )
    })
}

pub(super) fn moves(lines: &[Line]) -> Vec<&Move> {
    lines.iter().filter_map(|l| if let Line::Move(m) = l { Some(m.as_ref()) } else { None }).collect()
}

/// A line that does something.
type Acting<'a> = &'a ReadLine;

fn acting(lines: &[ReadLine]) -> Vec<Acting<'_>> {
    lines.iter().filter(|l| !matches!(l.what, Read::Say(_))).collect()
}

/// Compares a program with the plan.
pub fn verify(expected: &Expected<'_>, read: &[ReadLine], with_checker: bool) -> Verdict {
    let mut verdict = Verdict::default();
    let poses = Poses { setup: expected.setup, defocus_mm: expected.defocus_mm };
    let planned = compare(expected, &poses, read, &mut verdict);
    let driven = driven(&poses, read, &planned, &mut verdict);
    interference(expected, &poses, &driven, with_checker, &mut verdict);
    verdict.findings.sort_by_key(|f| order_of(read, f));
    verdict
}

/// Files in the order in which they are run.
fn order_of(read: &[ReadLine], f: &Finding) -> (usize, usize) {
    (read.iter().position(|l| l.file == f.file).unwrap_or(usize::MAX), f.line)
}

/// Poses of what was read.
pub(super) struct Poses<'a> {
    pub(super) setup: &'a Setup,
    pub(super) defocus_mm: f64,
}

impl Poses<'_> {
    /// Focus in the part; `None` for joints without a robot.
    fn focus(&self, goal: &Goal) -> Option<Isometry3<f64>> {
        match goal {
            Goal::Joints(joints) => Some(self.setup.focus_for(&self.setup.robot.as_ref()?.forward(joints))),
            Goal::Flange(flange) => Some(self.setup.focus_for(flange)),
            Goal::Focus(focus) => Some(*focus),
        }
    }

    fn flange(&self, goal: &Goal) -> Option<Isometry3<f64>> {
        match goal {
            Goal::Joints(joints) => Some(self.setup.robot.as_ref()?.forward(joints)),
            Goal::Flange(flange) => Some(*flange),
            Goal::Focus(focus) => Some(self.setup.flange_for(focus)),
        }
    }

    fn spot(&self, focus: &Isometry3<f64>) -> Point3<f64> {
        lit::foot(focus, self.defocus_mm)
    }
}

fn finding(at: &ReadLine, kind: Kind, text: String) -> Finding {
    Finding { file: at.file.clone(), line: at.line, kind, text }
}

/// Line by line, finding the way back after a line that is gone or new. Gives the plan's move for
/// each line that is the plan's: a pose alone does not say how the arm stands, its configuration does,
/// and that is compared as it is written.
fn compare<'a>(
    expected: &Expected<'a>,
    poses: &Poses<'_>,
    read: &[ReadLine],
    verdict: &mut Verdict,
) -> Vec<Option<&'a Move>> {
    let (want, have) = (acting(expected.written), acting(read));
    let places: Vec<usize> = (0..read.len()).filter(|i| !matches!(read[*i].what, Read::Say(_))).collect();
    let mut found_moves = vec![None; read.len()];
    let mut planned = expected.moves.iter();
    let plans: Vec<Option<&'a Move>> =
        want.iter().map(|l| matches!(l.what, Read::Move(_)).then(|| planned.next().copied()).flatten()).collect();
    let (mut i, mut k) = (0, 0);
    while i < want.len() && k < have.len() {
        if is_same(poses, want[i], have[k]) {
            agree(poses, plans[i], want[i], have[k], verdict);
            found_moves[places[k]] = plans[i];
            (i, k) = (i + 1, k + 1);
            continue;
        }
        // The nearest place where both go on alike: one line changed, or some gone or new.
        let meets = |gone: usize, new: usize| {
            (0..2).all(|n| match (want.get(i + gone + n), have.get(k + new + n)) {
                (Some(w), Some(h)) => is_same(poses, w, h),
                (None, None) => true,
                _ => false,
            })
        };
        let found = (1..=LOOK_AHEAD).find_map(|n| {
            let ways = [(n, n), (n, n - 1), (n - 1, n), (n, 0), (0, n)];
            ways.into_iter().find(|&(gone, new)| meets(gone, new))
        });
        let (gone, new) = found.unwrap_or((1, 1));
        let both = gone.min(new);
        for n in 0..both {
            if i + n < want.len() && k + n < have.len() {
                differ(poses, plans[i + n], want[i + n], have[k + n], verdict);
            }
        }
        for n in both..gone {
            if let Some(w) = want.get(i + n) {
                let at = have.get(k + new).or(have.last()).copied().unwrap_or(w);
                verdict.findings.push(finding(
                    at,
                    Kind::Missing,
                    format!("before this line the plan has: {}", said(w)),
                ));
            }
        }
        for n in both..new {
            if let Some(h) = have.get(k + n) {
                verdict.findings.push(finding(h, Kind::Extra, format!("the plan does not have: {}", said(h))));
            }
        }
        (i, k) = (i + gone, k + new);
    }
    if i < want.len() {
        let at = have.last().copied().unwrap_or(want[i]);
        let text = format!("{} more lines of the plan are not there, the first: {}", want.len() - i, said(want[i]));
        verdict.findings.push(finding(at, Kind::Missing, text));
    }
    for h in have.iter().skip(k) {
        verdict.findings.push(finding(h, Kind::Extra, format!("behind the plan's end: {}", said(h))));
    }
    found_moves
}

/// A line in a few words.
fn said(l: &ReadLine) -> String {
    match &l.what {
        Read::Move(ReadMove { way: Way::Joint, .. }) => "a move by joints".into(),
        Read::Move(ReadMove { way: Way::Linear, .. }) => "a straight move".into(),
        Read::Output { number, on } => format!("output {number} {}", if *on { "on" } else { "off" }),
        Read::Level { number, value, .. } => format!("level {number} to {value}"),
        Read::Wait(s) => format!("a wait of {s} s"),
        Read::Say(text) | Read::Other(text) => text.clone(),
    }
}

/// Whether a line is the one of the plan, small changes of pose and time not looked at.
fn is_same(poses: &Poses<'_>, want: &ReadLine, have: &ReadLine) -> bool {
    match (&want.what, &have.what) {
        (Read::Move(w), Read::Move(h)) => {
            w.way == h.way
                && off(poses, &w.goal, &h.goal).is_none_or(|(mm, deg)| mm < MOST_OFF_MM && deg < MOST_TURNED_DEG)
        }
        (w, h) => w == h,
    }
}

/// How far the spot is off, and turned; `None` where it cannot be known.
fn off(poses: &Poses<'_>, a: &Goal, b: &Goal) -> Option<(f64, f64)> {
    if let (Goal::Joints(a), Goal::Joints(b), None) = (a, b, &poses.setup.robot) {
        // Home without a robot.
        return Some(if a == b { (0.0, 0.0) } else { (f64::INFINITY, 180.0) });
    }
    let (a, b) = (poses.focus(a)?, poses.focus(b)?);
    Some(((poses.spot(&a) - poses.spot(&b)).norm(), turn_deg(&a, &b)))
}

fn turn_deg(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
    angle::turned_deg(&a.rotation.rotation_to(&b.rotation).to_rotation_matrix())
}

/// Two lines that are the same one: what of it differs.
fn agree(poses: &Poses<'_>, plan: Option<&Move>, want: &ReadLine, have: &ReadLine, verdict: &mut Verdict) {
    let (Read::Move(w), Read::Move(h)) = (&want.what, &have.what) else { return };
    // Against the plan itself, not against its text.
    if let (Some(planned), Some(focus)) = (plan.and_then(|p| p.part_from_focus), poses.focus(&h.goal)) {
        let defocus_mm = plan.map_or(poses.defocus_mm, |p| p.work.defocus_mm);
        let mm = (lit::foot(&planned, defocus_mm) - lit::foot(&focus, defocus_mm)).norm();
        let deg = turn_deg(&planned, &focus);
        (verdict.worst_mm, verdict.worst_deg) = (verdict.worst_mm.max(mm), verdict.worst_deg.max(deg));
        if mm > MOST_OFF_MM || deg > MOST_TURNED_DEG {
            verdict.findings.push(deviation(have, mm, deg));
        }
    }
    if let (Goal::Joints(w), Goal::Joints(h)) = (&w.goal, &h.goal)
        && let Some(j) = (0..6).find(|&j| (w[j] - h[j]).abs() > OTHER_TURN_DEG)
    {
        let text = format!("J{} stands at {:.1}\u{b0}, the plan has {:.1}\u{b0}", j + 1, h[j], w[j]);
        verdict.findings.push(finding(have, Kind::Deviation, text));
    }
    if w.rest != h.rest {
        let text = format!("{} where the plan has {}", h.rest, w.rest);
        verdict.findings.push(finding(have, Kind::Setting, text));
    }
    if !same_pace(&w.pace, &h.pace) {
        verdict.findings.push(finding(
            have,
            Kind::Time,
            format!("{} where the plan has {}", pace(&h.pace), pace(&w.pace)),
        ));
    }
    if let Some(planned) = plan
        && !same_pace(&planned.pace, &h.pace)
        && same_pace(&w.pace, &h.pace)
    {
        let text = format!("the dialect's words give {} where the plan has {}", pace(&h.pace), pace(&planned.pace));
        verdict.findings.push(finding(have, Kind::Time, text));
    }
}

fn same_pace(a: &Pace, b: &Pace) -> bool {
    match (a, b) {
        // A millisecond is what controllers count in.
        (Pace::Seconds(a), Pace::Seconds(b)) => (a - b).abs() <= 0.002 + MOST_SLOWER * a.abs(),
        // A share of full speed turned into radians and back.
        (Pace::Percent(a), Pace::Percent(b)) => (a - b).abs() <= 1e-3 * a.abs(),
        _ => false,
    }
}

fn pace(p: &Pace) -> String {
    match p {
        Pace::Seconds(s) => format!("{s:.3} s"),
        Pace::Percent(p) => format!("{p} %"),
    }
}

fn deviation(at: &ReadLine, mm: f64, deg: f64) -> Finding {
    finding(at, Kind::Deviation, format!("the spot is {mm:.3} mm off and turned by {deg:.3}\u{b0}"))
}

/// Two lines at the same place of which one was changed.
fn differ(poses: &Poses<'_>, plan: Option<&Move>, want: &ReadLine, have: &ReadLine, verdict: &mut Verdict) {
    if is_same(poses, want, have) {
        return agree(poses, plan, want, have, verdict);
    }
    if let (Read::Move(w), Read::Move(h)) = (&want.what, &have.what)
        && w.way == h.way
        && let Some((mm, deg)) = off(poses, &w.goal, &h.goal)
    {
        return verdict.findings.push(deviation(have, mm, deg));
    }
    let text = format!("{} where the plan has {}", said(have), said(want));
    verdict.findings.push(finding(have, Kind::Setting, text));
}

/// A move as it is driven.
pub(super) struct Driven<'a> {
    at: &'a ReadLine,
    /// Its place among all lines.
    pub(super) place: usize,
    pub(super) lit: LitMove,
}

/// Follows the program with the robot: ranges, speeds, and where the laser is on. Gives the lit moves.
pub(super) fn driven<'a>(
    poses: &Poses<'_>,
    read: &'a [ReadLine],
    planned: &[Option<&Move>],
    verdict: &mut Verdict,
) -> Vec<Driven<'a>> {
    let laser = poses.setup.cell.outputs.laser.number;
    let (mut lit, mut joints, mut at) = (false, None::<Joints>, None::<Isometry3<f64>>);
    let mut work = planned.iter().flatten().next().map_or_else(Work::default, |m| m.work);
    let mut out = Vec::new();
    for (place, (line, planned)) in read.iter().zip(planned).enumerate() {
        work = planned.map_or(work, |m| m.work);
        let planned = planned.and_then(|m| m.joints_deg);
        let m = match &line.what {
            Read::Output { number, on } if *number == laser => {
                lit = *on;
                continue;
            }
            Read::Move(m) => m,
            _ => continue,
        };
        verdict.moves += 1;
        let flange = poses.flange(&m.goal);
        if let Some(robot) = &poses.setup.robot {
            let next = match (&m.goal, planned.as_ref().or(joints.as_ref()), &flange) {
                (Goal::Joints(j), ..) => Some(*j),
                (_, Some(before), Some(flange)) => robot.near(flange, before),
                (_, None, Some(flange)) => robot.near(flange, &poses.setup.home_joints_deg()),
                _ => None,
            };
            match &next {
                None => {
                    let text = format!("the {} cannot go there", robot.name);
                    verdict.findings.push(finding(line, Kind::Limit, text));
                }
                Some(j) => {
                    if let Some(i) = robot.beyond(j) {
                        let [low, high] = robot.limits_deg[i];
                        let text =
                            format!("J{} = {:.2}\u{b0} is beyond its range, {low:.0} to {high:.0}\u{b0}", i + 1, j[i]);
                        verdict.findings.push(finding(line, Kind::Limit, text));
                    }
                    if let (Pace::Seconds(s), Some(before)) = (&m.pace, &joints) {
                        speed(poses, line, before, j, *s, verdict);
                    }
                }
            }
            joints = next.or(joints);
        }
        let here = match m.goal {
            Goal::Focus(focus) => Some(focus),
            _ => flange,
        };
        if lit {
            verdict.lit_moves += 1;
            match (m.way, at, here) {
                (Way::Linear, Some(from), Some(to)) => {
                    let by_focus = matches!(m.goal, Goal::Focus(_));
                    out.push(Driven { at: line, place, lit: LitMove { from, to, by_focus, work } });
                }
                _ => {
                    let text = "a move by joints with the laser on".into();
                    verdict.findings.push(finding(line, Kind::Interference, text));
                }
            }
        }
        at = here;
    }
    if lit && let Some(last) = read.last() {
        verdict.findings.push(finding(last, Kind::Setting, "the program ends with the laser on".into()));
    }
    out
}

fn speed(poses: &Poses<'_>, line: &ReadLine, from: &Joints, to: &Joints, seconds: f64, verdict: &mut Verdict) {
    let Some(robot) = &poses.setup.robot else { return };
    // Joints written with four decimals may be off by 0.0001 degrees at both ends.
    let fast = (0..6)
        .find(|&j| (to[j] - from[j]).abs() > robot.speeds_deg_s[j] * (1.0 + SPEED_SHARE) * seconds.max(0.001) + 2e-4);
    if let Some(j) = fast {
        let (deg_s, can) = ((to[j] - from[j]).abs() / seconds.max(0.001), robot.speeds_deg_s[j]);
        let text = format!("J{} turns at {deg_s:.0}\u{b0}/s, it can {can:.0}\u{b0}/s", j + 1);
        verdict.findings.push(finding(line, Kind::Speed, text));
    }
}

/// Proves the lit moves as the controller makes them; what cannot be proven is a finding.
fn interference(
    expected: &Expected<'_>,
    poses: &Poses<'_>,
    driven: &[Driven<'_>],
    with_checker: bool,
    verdict: &mut Verdict,
) {
    let moves: Vec<LitMove> = driven.iter().map(|d| d.lit).collect();
    verdict.proof = expected.prover.prove(&moves);
    for (n, blocker) in &verdict.proof.refuted {
        let text = format!("{blocker} with the laser on");
        verdict.findings.push(finding(driven[*n].at, Kind::Interference, text));
    }
    if !with_checker {
        return;
    }
    let facets = expected.part.mesh.facets.len().max(1);
    let layers = driven.iter().map(|d| d.lit.work.layer).max().unwrap_or(0);
    let on = |layer: u32| {
        let mesh = &expected.prover.part_of(layer).mesh;
        Checker::new((0..mesh.facets.len()).map(|f| mesh.corners(f)))
    };
    let checkers: Vec<Checker> = (0..=layers).map(on).collect();
    let every = (driven.len() * facets).div_ceil(CHECKER_BUDGET).max(1);
    let hits: Vec<Finding> = driven
        .par_iter()
        .step_by(every)
        .filter_map(|d| {
            let end = if d.lit.by_focus { d.lit.to } else { poses.setup.focus_for(&d.lit.to) };
            let layer = d.lit.work.layer;
            let (p, a) = expected.prover.spot(&Beam::on(expected.prover.part_of(layer)), &end, &d.lit.work);
            let facet = checkers.get(layer as usize)?.hit(&p, &a, lit::FROM_MM)?;
            let text = format!("the beam to ({:.2}, {:.2}, {:.2}) hits facet {facet} with the laser on", p.x, p.y, p.z);
            Some(finding(d.at, Kind::Interference, text))
        })
        .collect();
    for hit in hits {
        if !verdict.findings.iter().any(|f| (&f.file, f.line, f.kind) == (&hit.file, hit.line, hit.kind)) {
            verdict.findings.push(hit);
        }
    }
}
