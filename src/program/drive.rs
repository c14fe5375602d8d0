//! The steps of a program with a robot: joints for every move, targets put in between where the spot
//! would leave its line, and connecting moves that the arm can make.
//!
//! Asked for a straight move, a controller moves the flange straight and turns it about one axis; the
//! spot then leaves the planned line between two targets by the lever from flange to spot. What cannot
//! be driven is refused with its reason; spins and branches are not chosen here.

use super::air::Space;
use super::lit::Straight;
use super::round;
use super::steps::{Go, Pace, Speeds, Station, Step, Steps, Way};
use crate::cell::collision::Collision;
use crate::cell::motion::{Cause, Choice, Refusal};
use crate::cell::mounting::Mounted;
use crate::cell::{Joints, Robot, Setup};
use crate::part::Part;
use crate::pose::Pass;
use rayon::prelude::*;

/// What the driven program is made from.
pub struct Drive<'a> {
    /// The part.
    pub part: &'a Part,
    /// The cell, with a robot in it.
    pub setup: &'a Setup,
    /// Its frames.
    pub mounted: Mounted,
    /// The robot of the setup.
    pub robot: &'a Robot,
    /// Speeds of the spot.
    pub speeds: Speeds,
    /// How far the spot may leave its line, mm.
    pub deviation_mm: f64,
    /// What the arm and all it carries may touch; `None`: nothing.
    pub collision: Option<&'a Collision<'a>>,
    /// Whether to go on; the steps of a stopped drive are refused without a reason.
    pub go_on: &'a (dyn Fn() -> bool + Sync),
}

/// Where the arm stands: the focus in the part, and the joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// Focus, beam and spin in the part.
    pub at: Station,
    /// Degrees.
    pub joints_deg: Joints,
}

/// A lit move.
struct Lit {
    to: Stand,
    seconds: f64,
    target: Option<(usize, usize)>,
}

impl Drive<'_> {
    /// The steps of what was chosen.
    ///
    /// # Errors
    /// Targets that cannot be driven after all; the rest has to be tried again without them.
    pub fn steps(&self, passes: &[Pass], choice: &Choice) -> Result<Steps, Vec<Refusal>> {
        let pieces: Vec<(usize, usize, usize)> = passes
            .iter()
            .enumerate()
            .flat_map(|(number, pass)| pass.lit_pieces().into_iter().map(move |(a, b)| (number, a, b)))
            .collect();
        let driven: Vec<Result<(Stand, Vec<Lit>), Refusal>> = pieces
            .par_iter()
            .take_any_while(|_| (self.go_on)())
            .map(|&piece| self.piece(passes, choice, piece))
            .collect();
        if !(self.go_on)() {
            return Err(Vec::new());
        }
        let mut refused = Vec::new();
        let mut whole = Vec::new();
        for piece in driven {
            match piece {
                Ok(piece) => whole.push(piece),
                Err(refusal) => refused.push(refusal),
            }
        }
        if !refused.is_empty() {
            return Err(refused);
        }
        let space = Space::new(self.part, &self.setup.cell.air, self.speeds.defocus_mm);
        let end = |i: usize| whole[i].1.last().map_or(whole[i].0, |lit| lit.to);
        let ways: Vec<Option<Vec<Go>>> = (0..=whole.len())
            .into_par_iter()
            .map(|i| {
                if !(self.go_on)() {
                    return None;
                }
                let from = (i > 0).then(|| end(i - 1));
                let to = whole.get(i).map(|piece| piece.0);
                round::way(self, &space, from.as_ref(), to.as_ref())
            })
            .collect();
        if !(self.go_on)() {
            return Err(Vec::new());
        }
        if let (Some(None), false) = (ways.first(), whole.is_empty()) {
            // Nothing begins here: refuse all pieces up to the first that can be gone to.
            let reachable = |i: &usize| round::way(self, &space, None, Some(&whole[*i].0)).is_some();
            let begin = (1..whole.len()).into_par_iter().find_first(reachable).unwrap_or(whole.len());
            return Err(pieces[..begin].iter().flat_map(|&(n, a, b)| self.no_way(n, a..=b)).collect());
        }
        let mut out = Steps::default();
        out.list.push(Step::Home);
        let mut said = None;
        let mut at: Option<Station> = None;
        for (i, (way, &(number, first, last))) in ways.iter().zip(&pieces).enumerate() {
            let Some(way) = way else {
                // Home is on every way that is tried last: the piece that has none to it is in a pocket.
                let stuck = i > 0 && round::way(self, &space, Some(&end(i - 1)), None).is_none();
                let (number, first, last) = if stuck { pieces[i - 1] } else { (number, first, last) };
                refused.extend(self.no_way(number, first..=last));
                continue;
            };
            let (down, way) = match way.split_last() {
                Some((down, way)) => (Go { target: Some((number, first)), ..*down }, way),
                None => continue,
            };
            for go in way {
                out.driven(go, at.as_ref());
                at = Some(go.to);
            }
            if said != Some(number) {
                out.list.push(Step::Say(format!("pass {number}, surface {}", passes[number].surface)));
                said = Some(number);
            }
            out.driven(&down, at.as_ref());
            out.list.push(Step::Laser(true));
            for l in &whole[i].1 {
                out.time_s += l.seconds;
                out.list.push(Step::Go(Go {
                    to: l.to.at,
                    way: Way::Linear,
                    joints_deg: Some(l.to.joints_deg),
                    pace: Pace::Seconds(l.seconds),
                    target: l.target,
                }));
            }
            out.list.push(Step::Laser(false));
            at = Some(end(i).at);
        }
        if let (Some(Some(way)), true) = (ways.last(), !whole.is_empty()) {
            for go in way {
                out.driven(go, at.as_ref());
                at = Some(go.to);
            }
        }
        if let (Some(None), Some(&(number, first, last))) = (ways.last(), pieces.last()) {
            refused.extend(self.no_way(number, first..=last));
        }
        out.list.push(Step::Home);
        if refused.is_empty() { Ok(out) } else { Err(refused) }
    }

    /// All targets of a piece that nothing leads to.
    fn no_way(&self, pass: usize, points: std::ops::RangeInclusive<usize>) -> Vec<Refusal> {
        let at_home = self.collision.and_then(|c| c.first(&self.setup.home_joints_deg()));
        let detail = match at_home {
            Some(contact) => {
                format!("{contact} already at home: hold the part elsewhere, or change air.home_joints_deg")
            }
            None => "no way leads here on which arm and part keep clear of everything".to_owned(),
        };
        let refuse = |point| Refusal { pass, point, cause: Cause::Robot, detail: detail.clone() };
        points.map(refuse).collect()
    }

    fn piece(
        &self,
        passes: &[Pass],
        choice: &Choice,
        (number, first, last): (usize, usize, usize),
    ) -> Result<(Stand, Vec<Lit>), Refusal> {
        let pass = &passes[number];
        let refuse = |point, cause, detail: &str| Refusal { pass: number, point, cause, detail: detail.into() };
        let stand = |point: usize| {
            let chosen = choice.rows[number][point].as_ref();
            chosen
                .map(|c| Stand {
                    at: Station::spun(&pass.targets[point], self.speeds.defocus_mm, c.spin_deg),
                    joints_deg: c.joints_deg,
                })
                .ok_or_else(|| refuse(point, Cause::Reach, "was not chosen"))
        };
        let start = stand(first)?;
        let mut here = start;
        let mut lit = Vec::new();
        for point in first + 1..=last {
            let to = stand(point)?;
            let seconds = (pass.targets[point].p - pass.targets[point - 1].p).norm() / self.speeds.work_mm_s;
            let before = lit.len();
            self.between(&here, &to, seconds, &mut lit).map_err(|(cause, detail)| refuse(point, cause, &detail))?;
            if let Some(l) = lit[before..].last_mut() {
                l.target = Some((number, point));
            }
            here = to;
        }
        Ok((start, lit))
    }

    /// Lit moves from one stand to the next, with stations in between where the spot needs them.
    fn between(&self, from: &Stand, to: &Stand, seconds: f64, out: &mut Vec<Lit>) -> Result<(), (Cause, String)> {
        let straight = Straight {
            part: self.part,
            mounted: self.mounted,
            defocus_mm: self.speeds.defocus_mm,
            deviation_mm: self.deviation_mm,
        };
        let (mut here, mut done) = (*from, 0.0);
        for (share, at) in straight.between(&from.at, &to.at)? {
            let guess = std::array::from_fn(|j| from.joints_deg[j] + (to.joints_deg[j] - from.joints_deg[j]) * share);
            let Some(joints_deg) = self.robot.near(&self.mounted.flange_for(&at.frame()), &guess) else {
                return Err((Cause::Limit, "between two targets a joint would leave its range".into()));
            };
            let next = Stand { at, joints_deg };
            self.lit(&here, &next, seconds * (share - done), out)?;
            (here, done) = (next, share);
        }
        self.lit(&here, to, seconds * (1.0 - done), out)
    }

    /// One lit move, if arm and part keep clear and no joint is too fast.
    fn lit(&self, from: &Stand, to: &Stand, seconds: f64, out: &mut Vec<Lit>) -> Result<(), (Cause, String)> {
        let touched = self.collision.and_then(|c| c.first_between(&from.joints_deg, &to.joints_deg));
        if let Some((_, contact)) = touched {
            let contact = contact.to_string();
            return Err((Cause::of_contact(&contact), contact));
        }
        for j in 0..6 {
            let moved = (to.joints_deg[j] - from.joints_deg[j]).abs();
            let can = self.robot.speeds_deg_s[j];
            // The ends were chosen by the mean speed; between them a joint may go faster.
            if moved > can * seconds + 1e-6 {
                let deg_s = moved / seconds.max(1e-9);
                let detail = format!("J{} would turn at {deg_s:.0}\u{b0}/s, it can {can:.0}\u{b0}/s", j + 1);
                return Err((Cause::Speed, detail));
            }
        }
        out.push(Lit { to: *to, seconds, target: None });
        Ok(())
    }
}

impl Steps {
    /// A connecting move.
    fn driven(&mut self, go: &Go, from: Option<&Station>) {
        if let Some(from) = from {
            self.air_mm += (go.to.x - from.x).norm();
        }
        if let Pace::Seconds(s) = go.pace {
            self.time_s += s;
        }
        self.list.push(Step::Go(*go));
    }
}
