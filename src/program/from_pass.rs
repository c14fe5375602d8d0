//! What is left of a program from a pass on: from home to the first target of that pass, and on as before.

use super::connecting::lead::arc_reaches_mm;
use super::neutral::steps::{Go, Interpolation, MoveTiming, Station, Step, Steps};
use crate::pose::Pass;

/// A stop of the program's own digits, mm.
const SAME_MM: f64 = 1e-6;

/// No way leads from home to the first pass that is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoWayIn {
    /// The pass.
    pub pass: usize,
}

/// The steps from a pass on, from its first target that is worked; none where nothing is left to work. `way_in`: the moves
/// from home to where another one leads, the last of which leads there.
///
/// # Errors
/// There is no way from home to that target.
pub fn steps_from(
    steps: &Steps,
    passes: &[Pass],
    first: usize,
    way_in: &dyn Fn(&Go) -> Option<Vec<Go>>,
) -> Result<Steps, NoWayIn> {
    let list = &steps.list;
    let pass_of = |on: usize| list[on..].iter().find_map(|s| if let Step::Go(go) = s { go.target } else { None });
    let lights = (0..list.len()).filter(|i| list[*i] == Step::Laser(true));
    let left = lights.filter_map(|on| Some((on, pass_of(on)?.0))).find(|(_, pass)| *pass >= first);
    let Some((on, number)) = left else { return Ok(Steps::default()) };
    let mut before = list[..on].iter().rev().filter_map(|s| if let Step::Go(go) = s { Some(go) } else { None });
    let (Some(start), Some(pass)) = (before.next(), passes.get(number)) else { return Err(NoWayIn { pass: number }) };
    let lead_in = lead_in(pass, before, start);
    // Behind the way to its far end the lead goes on, and ends in the target.
    let with_lead = lead_in.split_last().and_then(|(far_end, nearer)| {
        let led: Vec<Go> = nearer.iter().rev().copied().chain([start]).copied().collect();
        Some((way_in(far_end)?, led))
    });
    let Some((way, led)) = with_lead.or_else(|| Some((way_in(start)?, Vec::new()))) else {
        return Err(NoWayIn { pass: number });
    };
    let home = list.iter().find(|s| matches!(s, Step::Home { .. })).cloned().ok_or(NoWayIn { pass: number })?;
    let mut out = Steps { shortfalls: steps.shortfalls.clone(), ..Steps::default() };
    out.list.push(home);
    let (down, way) = way.split_last().ok_or(NoWayIn { pass: number })?;
    out.list.extend(way.iter().map(|go| Step::Go(*go)));
    out.say_pass(number, pass);
    out.list.push(Step::Go(Go { target: start.target.filter(|_| led.is_empty()), ..*down }));
    out.list.extend(led.into_iter().map(Step::Go));
    out.list.extend(list[..on].iter().rev().find(|s| matches!(s, Step::Process(_))).cloned());
    out.list.extend_from_slice(&list[on..]);
    out.measure();
    Ok(out)
}

/// The moves of the lead-in that ends in `start`, from there backwards; none where there is no lead-in. `before`: the
/// moves before that one, the last first.
fn lead_in<'a>(pass: &Pass, mut before: impl Iterator<Item = &'a Go>, start: &Go) -> Vec<&'a Go> {
    if pass.settings.arc_mm <= 0.0 {
        return before.next().filter(|go| is_lead_in(pass, go, start)).into_iter().collect();
    }
    let reaches = arc_reaches_mm(pass.settings.arc_mm);
    let is_on_arc = |(reach_mm, go): (f64, &'a Go)| {
        let is_straight = go.interpolation == Interpolation::Linear;
        (is_straight && ((go.to.x - start.to.x).norm() - reach_mm).abs() < SAME_MM).then_some(go)
    };
    let moves: Option<Vec<&Go>> = reaches.map(|reach_mm| is_on_arc((reach_mm, before.next()?))).collect();
    moves.unwrap_or_default()
}

/// Whether a move leads to where the lead-in of a pass begins: straight on before its first target.
fn is_lead_in(pass: &Pass, go: &Go, start: &Go) -> bool {
    let point = start.target.map_or(0, |t| t.1);
    let (Some(first), Some(next)) = (pass.targets.get(point), pass.targets.get(point + 1)) else { return false };
    let length_mm = pass.settings.lead_in_mm;
    let Some(direction) = (first.p - next.p).try_normalize(1e-9).filter(|_| length_mm > 0.0) else { return false };
    go.interpolation == Interpolation::Linear && (start.to.x + direction * length_mm - go.to.x).norm() < SAME_MM
}

impl Steps {
    /// Sums up way in the air and time anew.
    fn measure(&mut self) {
        let (mut at, mut lit): (Option<Station>, bool) = (None, false);
        (self.air_mm, self.time_s) = (0.0, 0.0);
        for step in &self.list {
            match step {
                Step::Laser(on) => lit = *on,
                Step::Home { .. } => at = None,
                Step::Go(go) => {
                    if let (Some(from), false) = (at, lit) {
                        self.air_mm += (go.to.x - from.x).norm();
                    }
                    if let MoveTiming::Seconds(s) = go.timing {
                        self.time_s += s;
                    }
                    at = Some(go.to);
                }
                Step::Comment(_) | Step::Process(_) => {}
            }
        }
    }
}
