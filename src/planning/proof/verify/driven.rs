//! A program as the robot drives it: ranges, speeds, and what its beam meets on the way.

use super::expected::{Expected, Poses};
use super::verdict::{Difference, Finding, Verdict};
use crate::beam::ProcessSettings;
use crate::cell::{Joints, Robot};
use crate::pose::BeamInterference;
use crate::pose::checker::Checker;
use crate::program::dialect::{Goal, ReadLine, ReadMove, Statement};
use crate::program::sweep::LitMove;
use crate::program::{Interpolation, Move, MoveTiming, spot};
use crate::progress::Cancelled;
use nalgebra::{Isometry3, Vector3};
use rayon::prelude::*;

/// A joint may be faster than its full speed by this share: joints are written with few digits.
const SPEED_SHARE: f64 = 0.02;
/// Facets that the slow second opinion may look at.
const CHECKER_BUDGET: usize = 400_000_000;

/// A lit move as the robot drives it.
pub(in super::super) struct Driven<'a> {
    at: &'a ReadLine,
    /// Its index among all lines that were read.
    pub(in super::super) place: usize,
    pub(in super::super) lit: LitMove,
}

/// Follows the program with the robot: ranges, speeds, and where the laser is on. Gives the lit moves.
pub(in super::super) fn drive_program<'a>(
    poses: &Poses<'_>,
    read: &'a [ReadLine],
    planned: &[Option<&Move>],
    verdict: &mut Verdict,
) -> Vec<Driven<'a>> {
    let laser = poses.setup.cell.outputs.laser.number;
    let (mut lit, mut joints, mut at) = (false, None::<Joints>, None::<Isometry3<f64>>);
    let mut settings = planned.iter().flatten().next().map_or_else(ProcessSettings::default, |m| m.settings);
    let mut out = Vec::new();
    for (place, (line, planned)) in read.iter().zip(planned).enumerate() {
        settings = planned.map_or(settings, |m| m.settings);
        let planned = planned.and_then(|m| m.joints_deg);
        let m = match &line.what {
            Statement::Output { number, on } if *number == laser => {
                lit = *on;
                continue;
            }
            Statement::Move(m) => m,
            _ => continue,
        };
        verdict.moves += 1;
        let flange = poses.flange(&m.goal);
        if let Some(robot) = &poses.setup.robot {
            let near = planned.or(joints).unwrap_or_else(|| poses.setup.home_joints_deg());
            let next = match (&m.goal, &flange) {
                (Goal::Joints(j), _) => Some(*j),
                (_, Some(flange)) => robot.nearest_inverse(flange, &near),
                _ => None,
            };
            check_joints(robot, line, m, joints.as_ref(), next.as_ref(), verdict);
            joints = next.or(joints);
        }
        let here = match m.goal {
            Goal::Focus(focus) => Some(focus),
            _ => flange,
        };
        if lit {
            verdict.lit_moves += 1;
            match (m.interpolation, at, here) {
                (Interpolation::Linear, Some(from), Some(to)) => {
                    let by_focus = matches!(m.goal, Goal::Focus(_));
                    out.push(Driven { at: line, place, lit: LitMove { from, to, by_focus, settings } });
                }
                (way, ..) => {
                    let difference = match way {
                        Interpolation::Joint => Difference::LitByJoints,
                        Interpolation::Linear => Difference::LitToUnknown,
                    };
                    verdict.findings.push(difference.at(line));
                }
            }
        }
        at = here;
    }
    if lit && let Some(last) = read.last() {
        verdict.findings.push(Difference::EndsLit.at(last));
    }
    out
}

/// Whether the robot can stand where a move ends, and its joints turn as fast as it asks.
fn check_joints(
    robot: &Robot,
    line: &ReadLine,
    m: &ReadMove,
    before: Option<&Joints>,
    next: Option<&Joints>,
    verdict: &mut Verdict,
) {
    let Some(next) = next else {
        verdict.findings.push(Difference::OutOfReach { robot: robot.name.clone() }.at(line));
        return;
    };
    if let Some(i) = robot.beyond(next) {
        let beyond = Difference::BeyondRange { joint: i, at_deg: next[i], range_deg: robot.limits_deg[i] };
        verdict.findings.push(beyond.at(line));
    }
    if let (MoveTiming::Seconds(s), Some(before)) = (&m.timing, before) {
        check_speeds(robot, line, before, next, *s, verdict);
    }
}

fn check_speeds(robot: &Robot, line: &ReadLine, from: &Joints, to: &Joints, seconds: f64, verdict: &mut Verdict) {
    // Joints written with four decimals may be off by 0.0001 degrees at both ends.
    let fast = (0..6)
        .find(|&j| (to[j] - from[j]).abs() > robot.speeds_deg_s[j] * (1.0 + SPEED_SHARE) * seconds.max(0.001) + 2e-4);
    if let Some(j) = fast {
        let (deg_s, most_deg_s) = ((to[j] - from[j]).abs() / seconds.max(0.001), robot.speeds_deg_s[j]);
        verdict.findings.push(Difference::TooFast { joint: j, deg_s, most_deg_s }.at(line));
    }
}

/// Proves the lit moves as the controller makes them; what cannot be proven is a finding.
///
/// # Errors
/// [`Cancelled`] when the work that the prover is asked by should end.
pub(super) fn interference(
    expected: &Expected<'_>,
    poses: &Poses<'_>,
    driven: &[Driven<'_>],
    with_checker: bool,
    verdict: &mut Verdict,
) -> Result<(), Cancelled> {
    let moves: Vec<LitMove> = driven.iter().map(|d| d.lit).collect();
    verdict.proof = match expected.known.filter(|known| *known.moves == moves) {
        Some(known) => known.clone(),
        None => expected.prover.prove(moves)?,
    };
    for (n, blocker) in &verdict.proof.refuted {
        verdict.findings.push(Difference::Touches(*blocker).at(driven[*n].at));
    }
    if !with_checker {
        return Ok(());
    }
    let facets = expected.part.mesh.facets.len().max(1);
    let layers = driven.iter().map(|d| d.lit.settings.layer).max().unwrap_or(0);
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
            let layer = d.lit.settings.layer;
            if let Some(kept) = expected.prover.kept_by_contact(&d.lit.settings) {
                let (p, a) = (spot::planned_spot(&end, d.lit.settings.defocus_mm), end.rotation * Vector3::z());
                let facet = checkers.get(layer as usize)?.touched(&p, &a, &kept)?;
                return Some(Difference::HitsFacet { spot: p, facet }.at(d.at));
            }
            let (p, a) =
                expected.prover.spot(&BeamInterference::on(expected.prover.part_of(layer)), &end, &d.lit.settings);
            let facet = checkers.get(layer as usize)?.hit(&p, &a, spot::FROM_MM)?;
            Some(Difference::HitsFacet { spot: p, facet }.at(d.at))
        })
        .collect();
    for hit in hits {
        if !verdict.findings.iter().any(|f| (&f.file, f.line, f.kind) == (&hit.file, hit.line, hit.kind)) {
            verdict.findings.push(hit);
        }
    }
    Ok(())
}
