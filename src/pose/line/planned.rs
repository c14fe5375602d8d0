//! A dense line with an axis at each of its points: tested between the points, reduced to places by the arch height,
//! and made into the targets of a pass.

use super::super::clearance;
use super::super::interference::{BeamInterference, Blocker};
use super::super::target::{Pass, Split, Target, TargetState, against_normal_deg, travel};
use super::super::{Pose, motion};
use super::contact_stand::{ContactStand, headings};
use crate::beam::ContactPlace;
use crate::part::angle;
use crate::path::chord::{self, ChordLimits, LinePlace};
use crate::path::dense::{self, DensePoint};
use crate::path::reduce::simplify;
use nalgebra::Vector3;

/// Greatest difference between a dropped corrected axis and the motion that replaces it, degrees.
const AXIS_ERROR_DEG: f64 = 1.0;

/// A move beside something that the beam was tilted away from turns the axis by no more than this,
/// degrees. Controllers move the flange straight, not the spot: at a lever of 100 mm from flange to
/// spot the spot then strays 0.02 mm, the beam's own margin; with 5° it strays 0.1 mm.
const CORRECTED_TURN_DEG: f64 = 2.5;

/// How far behind a split the wall that the beam would run into is looked for, mm.
const WALL_MM: f64 = 20.0;

/// A dense line with its axes.
pub(super) struct Planned {
    points: Vec<DensePoint>,
    /// `None` where the beam is blocked.
    axes: Vec<Option<Vector3<f64>>>,
    /// What the axes would be if nothing were in the way.
    aims: Vec<Vector3<f64>>,
    /// Whether a point lies where the one before it does, with another beam; the laser is off between the two.
    splits: Vec<bool>,
    /// Whether the beam is known to meet nothing on the way to a point from the one before, along the normals; empty: of
    /// none.
    is_clear: Vec<bool>,
    /// How fast a corrected beam may turn against the normal, degrees/mm.
    rate_deg_mm: f64,
    /// How a contact tool stands on the line; `None`: a beam, whose axis begins in the point.
    contact: Option<ContactPlace>,
}

/// The foot of a contact tool may go so far beside its way, mm: the contact shifts by as much within the surface, a
/// twenty-fifth of the 5 mm between lines, and what that is in depth the sweep looks at.
const FOOT_ERROR_MM: f64 = 0.2;

impl Planned {
    /// Along the normals, or corrected away from them; `None`: blocked. `is_clear`: whether the way to each point from the
    /// one before is known to be free along the normals.
    pub(super) fn along_normals(
        points: Vec<DensePoint>,
        axes: Vec<Option<Vector3<f64>>>,
        is_clear: Vec<bool>,
    ) -> Planned {
        // An axis within rounding of the normal is the normal.
        let snapped =
            |(q, a): (&DensePoint, Option<Vector3<f64>>)| a.map(|a| if (a - q.n).norm() < 1e-9 { q.n } else { a });
        let axes = points.iter().zip(axes).map(snapped).collect();
        let (aims, splits) = (points.iter().map(|q| q.n).collect(), vec![false; points.len()]);
        Planned { points, axes, aims, splits, is_clear, rate_deg_mm: f64::INFINITY, contact: None }
    }

    /// From the corrected points that the search for tilts found.
    pub(super) fn of_rows(rows: &[clearance::CorrectedPoint], rate_deg_mm: f64) -> Planned {
        Planned {
            points: rows.iter().map(|r| r.q).collect(),
            axes: rows.iter().map(|r| r.axis).collect(),
            aims: rows.iter().map(|r| r.aim).collect(),
            splits: rows.iter().map(|r| r.is_split).collect(),
            is_clear: Vec::new(),
            rate_deg_mm,
            contact: None,
        }
    }

    /// Of a contact tool: at each point its axis, and whether it may stand so.
    pub(super) fn of_contact(contact: ContactPlace, stands: &[ContactStand]) -> Planned {
        Planned {
            points: stands.iter().map(|s| s.q).collect(),
            axes: stands.iter().map(|s| s.is_free.then_some(s.a)).collect(),
            aims: stands.iter().map(|s| s.a).collect(),
            splits: vec![false; stands.len()],
            is_clear: Vec::new(),
            rate_deg_mm: f64::INFINITY,
            contact: Some(contact),
        }
    }

    fn pose(&self, i: usize) -> Option<Pose> {
        self.axes[i].map(|a| self.stand(&self.points[i], a))
    }

    /// The pose of the tool with its axis along `a` at a point of the line.
    fn stand(&self, q: &DensePoint, a: Vector3<f64>) -> Pose {
        Pose { p: self.contact.map_or(q.p, |place| place.foot(&q.p, &q.n, &a)), a }
    }

    fn state(&self, i: usize) -> TargetState {
        match self.axes[i] {
            None => TargetState::Blocked,
            Some(a) if a == self.aims[i] => TargetState::Free,
            Some(_) => TargetState::Corrected,
        }
    }

    /// Inserts a blocked point where the beam hits something between two free neighbours, and points in between where
    /// it turns more than a move may.
    pub(super) fn test_motion(&mut self, beam: &BeamInterference<'_>, max_turn_deg: f64) {
        let max_turn_deg = max_turn_deg.min(CORRECTED_TURN_DEG);
        let old = std::mem::replace(self, Planned::along_normals(Vec::new(), Vec::new(), Vec::new()));
        (self.rate_deg_mm, self.contact) = (old.rate_deg_mm, old.contact);
        for i in 0..old.points.len() {
            self.push(old.points[i], old.axes[i], old.aims[i], old.splits[i]);
            let Some(next) = (i + 1 < old.points.len() && !old.splits[i + 1]).then_some(i + 1) else { continue };
            let Some((from, to)) = old.pose(i).zip(old.pose(next)) else { continue };
            let between = |t: f64| dense::midway(&old.points[i], &old.points[next], t);
            let is_along = |i: usize| old.axes[i] == Some(old.points[i].n);
            let is_known = old.is_clear.get(next) == Some(&true) && is_along(i) && is_along(next);
            if let Some(t) = if is_known { None } else { motion::hit(beam, &from, &to, 0.0) } {
                let aim = match old.contact {
                    Some(_) => angle::slerp(&old.aims[i], &old.aims[next], t),
                    None => between(t).n,
                };
                self.push(between(t), None, aim, false);
                continue;
            }
            // A hair of tolerance: turns are found in whole fractions of a degree.
            let steps = (angle::between_deg(&from.a, &to.a) / max_turn_deg - 1e-6).ceil().max(1.0);
            let tilted = old.aims[i] != old.points[i].n || old.aims[next] != old.points[next].n;
            for k in 1..steps as usize {
                let t = k as f64 / steps;
                let q = between(t);
                let aim = if tilted { angle::slerp(&old.aims[i], &old.aims[next], t) } else { q.n };
                self.push(q, Some(from.midway(&to, t).a), aim, false);
            }
        }
    }

    fn push(&mut self, q: DensePoint, axis: Option<Vector3<f64>>, aim: Vector3<f64>, is_split: bool) {
        self.points.push(q);
        self.axes.push(axis);
        self.aims.push(aim);
        self.splits.push(is_split);
    }

    /// The places that become targets.
    pub(super) fn reduce(&self, beam: &BeamInterference<'_>, limits: &ChordLimits) -> Vec<LinePlace> {
        let last = self.points.len() - 1;
        // Points at which the state changes stay, on both sides; and those of a split.
        let fixed: Vec<bool> = (0..=last)
            .map(|i| {
                let state = self.state(i);
                i > 0 && (self.state(i - 1) != state || self.splits[i])
                    || i < last && (self.state(i + 1) != state || self.splits[i + 1])
            })
            .collect();
        simplify(&self.points, &fixed, limits, |from, to| {
            self.may_span(beam, from, to, limits.max_turn_deg) && self.feet_keep_to_chord(from, to)
        })
    }

    /// Whether the feet of a contact tool between two places lie near the straight line that its foot goes: where a line
    /// bends within the surface they go a wider way than the contact.
    fn feet_keep_to_chord(&self, i: LinePlace, j: LinePlace) -> bool {
        let Some(place) = self.contact.filter(|place| place.behind_mm != 0.0) else { return true };
        let at = |p: LinePlace| self.axis(p).map(|a| self.stand(&p.point_on(&self.points), a).p);
        let (Some(from), Some(to)) = (at(i), at(j)) else { return true };
        let line = to - from;
        let length2 = line.norm_squared().max(1e-24);
        (i.index + 1..j.index + usize::from(j.share > 0.0)).all(|k| {
            let Some(a) = self.axes[k] else { return true };
            let foot = place.foot(&self.points[k].p, &self.points[k].n, &a);
            let along = ((foot - from).dot(&line) / length2).clamp(0.0, 1.0);
            (foot - (from + line * along)).norm() <= FOOT_ERROR_MM
        })
    }

    /// What the axis would be at a place if nothing were in the way.
    fn aim(&self, place: LinePlace) -> Vector3<f64> {
        if self.contact.is_none() {
            return place.point_on(&self.points).n;
        }
        let aim = self.aims[place.index];
        self.aims.get(place.index + 1).filter(|_| place.share > 0.0).map_or(aim, |b| angle::slerp(&aim, b, place.share))
    }

    /// Axis at a place; between two points of one state.
    fn axis(&self, place: LinePlace) -> Option<Vector3<f64>> {
        let a = self.axes[place.index]?;
        if place.share == 0.0 {
            return Some(a);
        }
        if a == self.points[place.index].n && self.state(place.index) == TargetState::Free {
            return Some(place.point_on(&self.points).n);
        }
        Some(angle::slerp(&a, &self.axes[place.index + 1]?, place.share))
    }

    /// Whether the straight motion between two places can stand for the points between.
    fn may_span(&self, beam: &BeamInterference<'_>, i: LinePlace, j: LinePlace, max_turn_deg: f64) -> bool {
        let pose = |place: LinePlace| self.axis(place).map(|a| self.stand(&place.point_on(&self.points), a));
        let (Some(from), Some(to)) = (pose(i), pose(j)) else {
            // Blocked points only mark the place; nothing moves along them with the laser on.
            return self.axes[i.index].is_none() && self.axes[j.index].is_none();
        };
        let whole = (to.p - from.p).norm().max(1e-12);
        let between = i.index + 1..j.index + usize::from(j.share > 0.0);
        let same_axis = from.a == to.a && between.clone().all(|k| self.axes[k] == Some(from.a));
        let sag = chord::chord_error_mm(&self.points, i, j);
        if same_axis && sag < 1e-7 {
            return true; // flat: the detection has tested this motion
        }
        let arc = angle::GreatCircle::new(&from.a, &to.a);
        let on_axis = |k: usize| {
            let share = ((self.points[k].p - from.p).dot(&(to.p - from.p)) / (whole * whole)).clamp(0.0, 1.0);
            self.axes[k].is_some_and(|a| angle::between_deg(&arc.at(share), &a) <= AXIS_ERROR_DEG)
        };
        let corrected = self.state(i.index) == TargetState::Corrected || self.state(j.index) == TargetState::Corrected;
        let max_turn_deg = if corrected { max_turn_deg.min(CORRECTED_TURN_DEG) } else { max_turn_deg };
        let (n, to_n) = (i.point_on(&self.points).n, j.point_on(&self.points).n);
        angle::between_deg(&from.a, &to.a) <= max_turn_deg + 1e-6
            && (!corrected || against_normal_deg((&n, &from.a), (&to_n, &to.a)) <= self.rate_deg_mm * whole)
            && between.clone().all(on_axis)
            && motion::is_free(beam, &from, &to, sag)
    }

    /// Fills a pass with targets at the places that were kept.
    pub(super) fn fill(&self, beam: &BeamInterference<'_>, pass: Pass, kept: &[LinePlace]) -> Pass {
        let tangents = match self.contact {
            Some(_) => headings(&self.points, pass.closed),
            None => dense::tangents(&self.points, pass.closed),
        };
        let mut targets: Vec<Target> = Vec::with_capacity(kept.len());
        let mut splits = Vec::new();
        for &place in kept {
            let q = place.point_on(&self.points);
            let axis = self.axis(place);
            let (state, a) = (self.state(place.index), axis.unwrap_or_else(|| self.aim(place)));
            let foot = self.stand(&q, a).p;
            let is_split = place.share == 0.0 && self.splits[place.index];
            let laser = !is_split
                && state != TargetState::Blocked
                && targets.last().is_some_and(|t| t.state != TargetState::Blocked);
            if is_split {
                splits.push(Split { point: targets.len(), wall: self.wall(beam, place.index) });
            }
            // A contact tool has one way to stand.
            let normal_hits = match self.contact {
                Some(_) => beam.blocker(&foot, &a),
                None => beam.blocker(&q.p, &q.n),
            };
            let clearance_mm = beam.clearance_mm(&foot, &a);
            let tangent = match place.share {
                0.0 => tangents[place.index],
                _ => self.points[place.index + 1].p - self.points[place.index].p,
            };
            targets.push(Target {
                p: q.p,
                n: q.n,
                foot,
                a,
                o: self.travel(&tangent, &q.n, &a),
                state,
                laser,
                normal_hits,
                clearance_mm,
            });
        }
        let chord_error_mm =
            kept.windows(2).map(|w| chord::chord_error_mm(&self.points, w[0], w[1])).fold(0.0, f64::max);
        Pass { targets, chord_error_mm, splits, ..pass }
    }

    /// Travel square to the axis; that of a contact tool lies in the plane of travel and normal.
    fn travel(&self, tangent: &Vector3<f64>, n: &Vector3<f64>, a: &Vector3<f64>) -> Vector3<f64> {
        let ahead = if self.contact.is_some() { travel(tangent, n) } else { *tangent };
        travel(&ahead, a)
    }

    /// What keeps the beam from turning at the split `i`: something on the turn from one beam to the other, or ahead
    /// on the line if the beam kept the tilt it has before the split.
    fn wall(&self, beam: &BeamInterference<'_>, i: usize) -> Option<Blocker> {
        let (q, from, to) = (self.points[i], self.axes[i.checked_sub(1)?]?, self.axes[i]?);
        let arc = angle::GreatCircle::new(&from, &to);
        let steps = angle::between_deg(&from, &to).ceil().max(2.0);
        let across = (1..steps as usize).find_map(|k| beam.blocker(&q.p, &arc.at(k as f64 / steps)));
        let kept_on = || {
            let ahead = self.points[i..].iter().take_while(|s| (s.p - q.p).norm() <= WALL_MM);
            let mut there = ahead.map(|s| (s.p, angle::rotation_between(&q.n, &s.n) * from));
            there.find_map(|(p, a)| beam.blocker(&p, &a))
        };
        across.or_else(kept_on).or_else(|| beam.blocker(&q.p, &q.n))
    }
}
