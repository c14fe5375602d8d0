//! A program's lines against those of the plan, one by one: what is gone, new, or otherwise.

use super::expected::Poses;
use super::likeness::{
    is_pace_as_written, is_same, is_same_kind, is_same_pace, off_joint, position_difference, turn_deg,
};
use super::verdict::{Difference, JointOff, SpotOff, Verdict};
use crate::program::dialect::{Goal, ReadLine, ReadMove, Statement};
use crate::program::dialects::spelling::is_same_code;
use crate::program::{Move, spot};

/// Lines looked ahead to find where two programs meet again.
const LOOK_AHEAD: usize = 40;
/// The joints of home may be written so coarsely, degrees: pulses of an axis may be ten to the degree.
const HOME_JOINTS_COARSEST_DEG: f64 = 0.06;

/// The lines that do something, of both sides.
struct ComparedLines<'a, 'r> {
    poses: &'r Poses<'r>,
    want: Vec<&'r ReadLine>,
    /// The plan's moves, beside its lines.
    plans: Vec<Option<&'a Move>>,
    have: Vec<&'r ReadLine>,
    /// Where those stand among all lines.
    places: Vec<usize>,
}

/// Line by line, finding the way back after a line that is gone or new. Gives the plan's move for
/// each line that is the plan's: a pose alone does not say how the arm stands, its configuration does,
/// and that is compared as it is written.
pub(super) fn compare<'a>(
    planned: &[&'a Move],
    written: &[ReadLine],
    poses: &Poses<'_>,
    read: &[ReadLine],
    verdict: &mut Verdict,
) -> Vec<Option<&'a Move>> {
    let sides = ComparedLines::new(planned, written, poses, read);
    let (want, have) = (&sides.want, &sides.have);
    let mut found_moves = vec![None; read.len()];
    let (mut i, mut k) = (0, 0);
    while i < want.len() && k < have.len() {
        let (gone, new) = if sides.is_same(i, k) { (1, 1) } else { sides.way_back(i, k) };
        for n in 0..gone.min(new) {
            if i + n < want.len() && k + n < have.len() && sides.compare_pair(i + n, k + n, verdict) {
                found_moves[sides.places[k + n]] = sides.plans[i + n];
            }
        }
        for w in want.iter().skip(i + new).take(gone.saturating_sub(new)) {
            let at = have.get(k + new).or(have.last()).copied().unwrap_or(w);
            verdict.findings.push(Difference::Missing { planned: w.what.clone() }.at(at));
        }
        for h in have.iter().skip(k + gone).take(new.saturating_sub(gone)) {
            verdict.findings.push(Difference::Extra { found: h.what.clone() }.at(h));
        }
        (i, k) = (i + gone, k + new);
    }
    if let Some(first) = want.get(i) {
        let at = have.last().unwrap_or(first);
        let missing = Difference::EndMissing { lines: want.len() - i, first: first.what.clone() };
        verdict.findings.push(missing.at(at));
    }
    for h in have.iter().skip(k) {
        verdict.findings.push(Difference::BehindEnd { found: h.what.clone() }.at(h));
    }
    found_moves
}

impl<'a, 'r> ComparedLines<'a, 'r> {
    fn new(
        planned: &[&'a Move],
        written: &'r [ReadLine],
        poses: &'r Poses<'r>,
        read: &'r [ReadLine],
    ) -> ComparedLines<'a, 'r> {
        let acts = |l: &&ReadLine| !matches!(l.what, Statement::Comment(_));
        let want: Vec<&ReadLine> = written.iter().filter(acts).collect();
        let mut planned = planned.iter();
        let plans = want
            .iter()
            .map(|l| matches!(l.what, Statement::Move(_)).then(|| planned.next().copied()).flatten())
            .collect();
        let places: Vec<usize> = (0..read.len()).filter(|i| acts(&&read[*i])).collect();
        ComparedLines { poses, want, plans, have: places.iter().map(|i| &read[*i]).collect(), places }
    }

    fn is_same(&self, i: usize, k: usize) -> bool {
        match (self.want.get(i), self.have.get(k)) {
            (Some(w), Some(h)) => is_same(self.poses, w, h),
            (None, None) => true,
            _ => false,
        }
    }

    /// How many lines are gone and new until both go on alike for two: one line changed, or some gone or new.
    fn way_back(&self, i: usize, k: usize) -> (usize, usize) {
        let meets = |gone: usize, new: usize| (0..2).all(|n| self.is_same(i + gone + n, k + new + n));
        let found = (1..=LOOK_AHEAD).find_map(|n| {
            let ways = [(n, n), (n, n - 1), (n - 1, n), (n, 0), (0, n)];
            ways.into_iter().find(|&(gone, new)| meets(gone, new))
        });
        found.unwrap_or((1, 1))
    }

    /// Compares two lines at the same place. Gives whether they are the same line.
    fn compare_pair(&self, i: usize, k: usize, verdict: &mut Verdict) -> bool {
        let (want, have) = (self.want[i], self.have[k]);
        let is_same = self.is_same(i, k);
        match (&want.what, &have.what) {
            (Statement::Move(w), Statement::Move(h)) if is_same => {
                if let Some(plan) = self.plans[i] {
                    self.compare_with_plan(plan, have, h, verdict);
                    compare_timing(plan, have, w, h, verdict);
                }
                compare_settings(w, have, h, verdict);
            }
            _ if is_same => {}
            (Statement::Move(w), Statement::Move(h)) if is_same_kind(w, h) => {
                if let Some(difference) = position_difference(self.poses, &w.goal, &h.goal) {
                    verdict.findings.push(difference.at(have));
                }
                compare_settings(w, have, h, verdict);
            }
            _ => {
                let (found, planned) = (have.what.clone(), want.what.clone());
                verdict.findings.push(Difference::OtherLine { found, planned }.at(have));
            }
        }
        is_same
    }

    /// Compares a move with the plan itself, not with the plan's text: an error of the dialect's own writer shows here.
    fn compare_with_plan(&self, plan: &Move, at: &ReadLine, have: &ReadMove, verdict: &mut Verdict) {
        let poses = self.poses;
        // Home is told by its joints, or where they are.
        let home = plan.part_from_focus.is_none().then_some(plan.joints_deg).flatten();
        let planned = match (&have.goal, home) {
            (Goal::Joints(joints), Some(home)) => {
                if let Some(j) = off_joint(&Goal::Joints(home), &have.goal, HOME_JOINTS_COARSEST_DEG) {
                    let joint = Some(JointOff::new(j, &home, joints));
                    let goals = Some([have.goal, Goal::Joints(home)]);
                    verdict.findings.push(Difference::Elsewhere { spot: None, joint, goals }.at(at));
                }
                None
            }
            _ => plan.part_from_focus.or(plan.base_from_flange.map(|flange| poses.setup.focus_for(&flange))),
        };
        if let (Some(planned), Some(focus)) = (planned, poses.focus(&have.goal)) {
            let defocus_mm = plan.settings.defocus_mm;
            let mm = (spot::planned_spot(&planned, defocus_mm) - spot::planned_spot(&focus, defocus_mm)).norm();
            let deg = turn_deg(&planned, &focus);
            (verdict.worst_mm, verdict.worst_deg) = (verdict.worst_mm.max(mm), verdict.worst_deg.max(deg));
            let off = SpotOff { mm, deg };
            if !off.is_near() {
                let goals = Some([Goal::Focus(focus), Goal::Focus(planned)]);
                verdict.findings.push(Difference::Elsewhere { spot: Some(off), joint: None, goals }.at(at));
            }
        }
        if plan.interpolation != have.interpolation {
            verdict
                .findings
                .push(Difference::OtherWay { found: have.interpolation, planned: plan.interpolation }.at(at));
        }
    }
}

/// Compares a move's timing with the plan. A timing that was changed in the text is [`compare_settings`]'s finding.
fn compare_timing(plan: &Move, at: &ReadLine, want: &ReadMove, have: &ReadMove, verdict: &mut Verdict) {
    if !is_same_pace(&plan.timing, &have.timing) && is_pace_as_written(&want.timing, &have.timing) {
        verdict.findings.push(Difference::OtherPace { found: have.timing, planned: plan.timing }.at(at));
    }
}

/// Compares what a move says beside its target with the plan as it is written.
fn compare_settings(want: &ReadMove, at: &ReadLine, have: &ReadMove, verdict: &mut Verdict) {
    if !is_same_code(&want.rest, &have.rest) {
        let [found, planned] = where_they_differ(&have.rest, &want.rest);
        verdict.findings.push(Difference::OtherWords { found, planned }.at(at));
    }
    if !is_pace_as_written(&want.timing, &have.timing) {
        verdict.findings.push(Difference::OtherTime { found: have.timing, planned: want.timing }.at(at));
    }
}

/// The words of both that the other does not have in the same place, without those before and behind that both have; all
/// of them where one has no others.
fn where_they_differ(a: &str, b: &str) -> [String; 2] {
    let words = |t: &str| t.split_inclusive([',', ' ']).map(str::to_owned).collect::<Vec<_>>();
    let (of_a, of_b) = (words(a), words(b));
    let bare = |w: &str| w.trim_end_matches([',', ' ']).to_owned();
    let is_same = |(x, y): &(&String, &String)| is_same_code(&bare(x), &bare(y));
    let before = of_a.iter().zip(&of_b).take_while(is_same).count();
    let behind = of_a[before..].iter().rev().zip(of_b[before..].iter().rev()).take_while(is_same).count();
    let own = |all: &[String]| bare(&all[before..all.len() - behind].concat());
    match [own(&of_a), own(&of_b)] {
        [x, y] if x.is_empty() || y.is_empty() => [a.to_owned(), b.to_owned()],
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_that_differ_are_told() {
        for (a, b, differ) in [
            ("FINE UF0 UT1", "FINE UF0 UT0", ["UT1", "UT0"]),
            ("A=1,AC=0,SM=0,H=2,MS", "A=1,AC=0,SM=0,H=1,MS", ["H=2", "H=1"]),
            ("A=1,H=1,CONF=1,MS", "A=1,H=1,MS", ["A=1,H=1,CONF=1,MS", "A=1,H=1,MS"]),
            ("C_DIS", "", ["C_DIS", ""]),
            ("a=1.0,v=2,r=3", "a=1,v=3,r=4", ["v=2,r=3", "v=3,r=4"]),
        ] {
            assert_eq!(where_they_differ(a, b), differ);
        }
    }
}
