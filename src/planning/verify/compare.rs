//! A program's lines against those of the plan, one by one: what is gone, new, or otherwise.

use super::{Expected, Finding, Kind, MOST_OFF_MM, MOST_TURNED_DEG, Poses, Verdict, finding};
use crate::part::angle;
use crate::program::dialect::{Goal, Read, ReadLine, ReadMove};
use crate::program::{Move, Pace, Way, lit};
use nalgebra::Isometry3;

/// Share by which a time may differ: speeds are written with few digits.
const MOST_SLOWER: f64 = 0.02;
/// A joint further off than this stands on another turn or branch, degrees.
const OTHER_TURN_DEG: f64 = 1.0;
/// Lines looked ahead to find where two programs meet again.
const LOOK_AHEAD: usize = 40;

/// A line that does something.
type Acting<'a> = &'a ReadLine;

fn acting(lines: &[ReadLine]) -> Vec<Acting<'_>> {
    lines.iter().filter(|l| !matches!(l.what, Read::Say(_))).collect()
}

/// Line by line, finding the way back after a line that is gone or new. Gives the plan's move for
/// each line that is the plan's: a pose alone does not say how the arm stands, its configuration does,
/// and that is compared as it is written.
pub(super) fn compare<'a>(
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
