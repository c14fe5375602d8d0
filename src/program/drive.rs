//! The steps of a program with a robot: joints for every move, targets put in between where the spot
//! would leave its line, and connecting moves that the arm can make.
//!
//! Asked for a straight move, a controller moves the flange straight and turns it about one axis; the
//! spot then leaves the planned line between two targets by the lever from flange to spot. What cannot
//! be driven is refused with its reason; spins and branches are not chosen here.

use super::air::Space;
use super::steps::{Go, Pace, Speeds, Station, Step, Steps, Way};
use super::{lit, round};
use crate::cell::collision::Collision;
use crate::cell::motion::{Cause, Choice, Refusal};
use crate::cell::mounting::Mounted;
use crate::cell::{Joints, Robot, Setup};
use crate::part::Part;
use crate::pose::{Beam, Pass};
use nalgebra::{Isometry3, Point3};
use rayon::prelude::*;

/// A move is cut in halves at most so often: 64 pieces.
const MOST_HALVINGS: usize = 6;

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
        let driven: Vec<Result<(Stand, Vec<Lit>), Refusal>> =
            pieces.par_iter().map(|&piece| self.piece(passes, choice, piece)).collect();
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
                let from = (i > 0).then(|| end(i - 1));
                let to = whole.get(i).map(|piece| piece.0);
                round::way(self, &space, from.as_ref(), to.as_ref())
            })
            .collect();
        if let (Some(None), false) = (ways.first(), whole.is_empty()) {
            // Nothing begins here: refuse all pieces up to the first that can be gone to.
            let reachable = |i: &usize| round::way(self, &space, None, Some(&whole[*i].0)).is_some();
            let begin = (1..whole.len()).into_par_iter().find_first(reachable).unwrap_or(whole.len());
            return Err(pieces[..begin].iter().flat_map(|&(n, a, b)| no_way(n, a..=b)).collect());
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
                refused.extend(no_way(number, first..=last));
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
            refused.extend(no_way(number, first..=last));
        }
        out.list.push(Step::Home);
        if refused.is_empty() { Ok(out) } else { Err(refused) }
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
            self.between(&here, &to, seconds, MOST_HALVINGS, &mut lit)
                .map_err(|(cause, detail)| refuse(point, cause, &detail))?;
            if let Some(l) = lit[before..].last_mut() {
                l.target = Some((number, point));
            }
            here = to;
        }
        Ok((start, lit))
    }

    /// Lit moves from one stand to the next, cut in halves until the spot keeps to its line.
    fn between(
        &self,
        from: &Stand,
        to: &Stand,
        seconds: f64,
        halvings: usize,
        out: &mut Vec<Lit>,
    ) -> Result<(), (Cause, String)> {
        let off_mm = self.deviation(&from.at, &to.at);
        let hit = if off_mm <= self.deviation_mm { self.beam_hits(&from.at, &to.at) } else { None };
        if off_mm <= self.deviation_mm && hit.is_none() {
            let touched = self.collision.and_then(|c| c.first_between(&from.joints_deg, &to.joints_deg));
            if let Some((_, contact)) = touched {
                let contact = contact.to_string();
                return Err((Cause::of_contact(&contact), contact));
            }
            let robot = self.robot;
            for j in 0..6 {
                let deg_s = (to.joints_deg[j] - from.joints_deg[j]).abs() / seconds.max(1e-9);
                // The ends were chosen by the mean speed; between them a joint may go faster.
                if deg_s > robot.speeds_deg_s[j] && deg_s * seconds > 1e-6 {
                    let can = robot.speeds_deg_s[j];
                    let detail = format!("J{} would turn at {deg_s:.0}\u{b0}/s, it can {can:.0}\u{b0}/s", j + 1);
                    return Err((Cause::Speed, detail));
                }
            }
            out.push(Lit { to: *to, seconds, target: None });
            return Ok(());
        }
        if let (0, Some((p, facet))) = (halvings, hit) {
            let at = format!("({:.2}, {:.2}, {:.2})", p.x, p.y, p.z);
            return Err((Cause::Beam, format!("as the flange goes straight the beam to {at} hits facet {facet}")));
        }
        if halvings == 0 {
            return Err((Cause::Singularity, format!("the spot would leave its line by {off_mm:.2} mm")));
        }
        let at = self.midway(&from.at, &to.at);
        let flange = self.mounted.flange_for(&at.frame());
        let between = halfway(&from.joints_deg, &to.joints_deg);
        let Some(joints_deg) = self.robot.near(&flange, &between) else {
            return Err((Cause::Limit, "between two targets a joint would leave its range".into()));
        };
        let middle = Stand { at, joints_deg };
        self.between(from, &middle, 0.5 * seconds, halvings - 1, out)?;
        self.between(&middle, to, 0.5 * seconds, halvings - 1, out)
    }

    /// Where the beam hits the part on a lit move, as the flange goes.
    fn beam_hits(&self, from: &Station, to: &Station) -> Option<(Point3<f64>, u32)> {
        let (a, b) = (self.mounted.flange_for(&from.frame()), self.mounted.flange_for(&to.frame()));
        let beam = Beam::on(self.part);
        lit::hit(&beam, self.speeds.defocus_mm, |t| self.mounted.focus_for(&a.lerp_slerp(&b, t)))
    }

    /// The spot of a station on the part (or on the chord between two targets).
    fn spot(&self, frame: &Isometry3<f64>) -> Point3<f64> {
        Point3::from(frame.translation.vector) - frame.rotation * nalgebra::Vector3::z() * self.speeds.defocus_mm
    }

    /// Halfway on the planned motion: the spot straight, the frame turned at constant rate.
    fn midway(&self, from: &Station, to: &Station) -> Station {
        let (a, b) = (from.frame(), to.frame());
        let spot = nalgebra::center(&self.spot(&a), &self.spot(&b));
        let mut middle = Station::at(&Isometry3::from_parts(a.translation, a.rotation.slerp(&b.rotation, 0.5)));
        middle.x = spot + middle.a * self.speeds.defocus_mm;
        middle
    }

    /// How far the spot leaves the straight line where the flange goes straight, mm.
    fn deviation(&self, from: &Station, to: &Station) -> f64 {
        let (a, b) = (self.mounted.flange_for(&from.frame()), self.mounted.flange_for(&to.frame()));
        let (start, end) = (self.spot(&from.frame()), self.spot(&to.frame()));
        let line = end - start;
        let length2 = line.norm_squared();
        [0.25, 0.5, 0.75]
            .into_iter()
            .map(|t| {
                let spot = self.spot(&self.mounted.focus_for(&a.lerp_slerp(&b, t)));
                let along = if length2 > 0.0 { ((spot - start).dot(&line) / length2).clamp(0.0, 1.0) } else { 0.0 };
                (spot - (start + line * along)).norm()
            })
            .fold(0.0, f64::max)
    }
}

/// All targets of a piece that nothing leads to.
fn no_way(pass: usize, points: std::ops::RangeInclusive<usize>) -> impl Iterator<Item = Refusal> {
    let detail = "no way leads here on which arm and part keep clear of everything";
    points.map(move |point| Refusal { pass, point, cause: Cause::Robot, detail: detail.into() })
}

fn halfway(a: &Joints, b: &Joints) -> Joints {
    std::array::from_fn(|j| 0.5 * (a[j] + b[j]))
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
