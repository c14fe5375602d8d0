//! From a transversal line to the targets of a pass: dense line, detection, correction, the test of
//! the result and of the motion between, and the arch height reduction.

use super::correction::Correction;
use super::interference::{Beam, Blocker};
use super::motion::{self, Pose};
use super::target::{Pass, Split, State, Target, against_normal_deg, travel};
use super::tilt::{Pin, TiltRule};
use super::{clearance, section_plane};
use crate::beam::{Stance, Work};
use crate::part::{Part, angle};
use crate::path::chord::{self, ChordLimits, Place};
use crate::path::dense::{self, DensePoint};
use crate::path::{SectionPoint, TransversalLine};
use nalgebra::Vector3;

/// What a line is planned by.
#[derive(Clone, Debug, PartialEq)]
pub struct LineRules {
    /// Largest gap of the dense line, mm.
    pub max_gap_mm: f64,
    /// Largest turn of the normal on it, degrees.
    pub max_dense_turn_deg: f64,
    /// What a chord may span.
    pub chord: ChordLimits,
    /// What is done about interference.
    pub correction: Correction,
    /// Greatest angle between beam and normal, degrees.
    pub max_tilt_deg: f64,
    /// How fast the search may turn the beam against the normal along the line, degrees/mm.
    pub tilt_rate_deg_mm: f64,
    /// What the surface asks of the tilt.
    pub tilt: TiltRule,
    /// What the operator has set on lines of the surface.
    pub pins: Vec<Pin>,
}

crate::part::keyed!(LineRules {
    max_gap_mm,
    max_dense_turn_deg,
    chord,
    correction,
    max_tilt_deg,
    tilt_rate_deg_mm,
    tilt,
    pins
});

/// Ends of an interfering run are found to this, mm.
const RUN_END_MM: f64 = 0.05;
/// A corrected axis that was dropped lies within this of the motion that replaces it, degrees.
const AXIS_ERROR_DEG: f64 = 1.0;

/// A move beside something that the beam was tilted away from turns the axis by no more than this,
/// degrees. Controllers move the flange straight, not the spot: at a lever of 100 mm from flange to
/// spot the spot then strays 0.02 mm, the beam's own margin; with 5° it strays 0.1 mm.
const CORRECTED_TURN_DEG: f64 = 2.5;

/// The wall that a beam would run into behind a split is looked for this far, mm.
const WALL_MM: f64 = 20.0;

/// A line to be planned.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a> {
    /// Its points.
    pub line: &'a TransversalLine,
    /// Surface number.
    pub surface: u32,
    /// Its place in the working order of the surface.
    pub number: u32,
    /// Normal of its section plane; `None`: it lies in no plane.
    pub m: Option<Vector3<f64>>,
}

/// Plans one line of one surface. Of several stances the first is what is wanted; another one is taken
/// where it leaves less of the line blocked. Over the line's dark gaps the laser is off.
pub fn plan_line(part: &Part, stances: &[Stance<'_>], line: &Line<'_>, rules: &LineRules) -> Pass {
    let mut best: Option<(f64, Pass)> = None;
    for stance in stances {
        // Without a head the section plane keeps limits of its own.
        let limit_deg = stance.body.as_ref().map(|_| rules.max_tilt_deg);
        let pass = planned(part, stance, line, rules, (rules.correction, limit_deg));
        let blocked_mm = pass.length_mm(|from, to| !to.laser && !Pass::is_gap(from, to));
        if best.as_ref().is_none_or(|(least_mm, _)| blocked_mm < least_mm - 1e-6) {
            best = Some((blocked_mm, pass));
        }
        if blocked_mm == 0.0 {
            break;
        }
    }
    best.map_or_else(|| planned(part, &Stance::ray(Work::default()), line, rules, (Correction::None, None)), |b| b.1)
}

/// The same line by the section plane within the greatest tilt of `rules`: what the search is compared
/// with.
pub fn plan_line_by_section_plane(part: &Part, stance: &Stance<'_>, line: &Line<'_>, rules: &LineRules) -> Pass {
    planned(part, stance, line, rules, (Correction::SectionPlane, Some(rules.max_tilt_deg)))
}

fn planned(
    part: &Part,
    stance: &Stance<'_>,
    whole_line: &Line<'_>,
    rules: &LineRules,
    correction: (Correction, Option<f64>),
) -> Pass {
    if whole_line.line.dark.is_empty() {
        return planned_piece(part, stance, whole_line, rules, correction);
    }
    let Line { line, surface, m, .. } = whole_line;
    // What a beam keeps clear of on one side of a gap says nothing of the other side: each piece is planned
    // by itself, and its first target is reached with the laser off, as any pass's.
    let mut whole = Pass {
        surface: *surface,
        work: stance.work,
        plane_normal: plane_normal(line, *m),
        closed: false,
        targets: Vec::new(),
        line_points: line.points.len(),
        dense_points: 0,
        chord_error_mm: 0.0,
        splits: Vec::new(),
    };
    let (mut start_mm, mut last) = (0.0, None);
    for points in line.pieces().filter(|p| p.len() > 1) {
        let way_mm = |w: &[SectionPoint]| (w[1].p - w[0].p).norm();
        start_mm += last.map_or(0.0, |last: SectionPoint| (points[0].p - last.p).norm());
        last = points.last().copied();
        // Pins are told by their place on the whole line.
        let moved = |pin: &Pin| Pin { at_mm: pin.at_mm - start_mm, ..*pin };
        let rules = LineRules { pins: rules.pins.iter().map(moved).collect(), ..rules.clone() };
        start_mm += points.windows(2).map(way_mm).fold(0.0, |a, b| a + b);
        let piece = TransversalLine { plane: line.plane, points: points.to_vec(), closed: false, dark: Vec::new() };
        let pass = planned_piece(part, stance, &Line { line: &piece, ..*whole_line }, &rules, correction);
        let before = whole.targets.len();
        whole.splits.extend(pass.splits.iter().map(|s| Split { point: s.point + before, wall: s.wall }));
        whole.targets.extend(pass.targets);
        whole.dense_points += pass.dense_points;
        whole.chord_error_mm = whole.chord_error_mm.max(pass.chord_error_mm);
    }
    whole
}

/// A line's own plane, or that of travel and normal in its middle.
fn plane_normal(line: &TransversalLine, m: Option<Vector3<f64>>) -> Vector3<f64> {
    let middle = line.points.len() / 2;
    let at = |i: usize| line.points.get(i).or(line.points.last()).map(|q| DensePoint { p: q.p, n: q.n });
    let local = || {
        let (before, behind) = (at(middle.saturating_sub(1))?, at(middle + 1)?);
        Some(section_plane::local_plane(&before, &at(middle)?, &behind))
    };
    m.or_else(local).unwrap_or_else(Vector3::z)
}

/// The same for a line without gaps.
fn planned_piece(
    part: &Part,
    stance: &Stance<'_>,
    Line { line, surface, number, m }: &Line<'_>,
    rules: &LineRules,
    (correction, limit_deg): (Correction, Option<f64>),
) -> Pass {
    let beam = Beam::with(part, stance.body.as_ref());
    let dense = dense::dense(line, rules.max_gap_mm, rules.max_dense_turn_deg);
    let dense_points = dense.len();
    let (points, free) = detected(&beam, dense);
    let mut planned = match correction {
        Correction::None => {
            let axes = points.iter().zip(&free).map(|(q, f)| f.then_some(q.n)).collect();
            Planned::along_normals(points, axes)
        }
        Correction::SectionPlane => {
            let axes = section_plane::correct(part, &beam, &points, &free, line.closed, *m, limit_deg);
            Planned::along_normals(points, axes)
        }
        Correction::Clearance => {
            let rows = clearance::correct(part, &beam, &points, &free, line.closed, *number, rules);
            Planned::of_rows(&rows, rules.tilt_rate_deg_mm)
        }
    };
    planned.test_motion(&beam, rules.chord.max_turn_deg.min(CORRECTED_TURN_DEG));
    let kept = planned.reduce(&beam, &rules.chord);
    let pass = Pass {
        surface: *surface,
        work: stance.work,
        plane_normal: plane_normal(line, *m),
        closed: line.closed,
        targets: Vec::new(),
        line_points: line.points.len(),
        dense_points,
        chord_error_mm: 0.0,
        splits: Vec::new(),
    };
    planned.fill(&beam, pass, &kept)
}

/// Finds out which points are free, and adds those at which that changes.
fn detected(beam: &Beam<'_>, points: Vec<DensePoint>) -> (Vec<DensePoint>, Vec<bool>) {
    let is_free = |q: &DensePoint| beam.is_free(&q.p, &q.n);
    let (mut out, mut free): (Vec<DensePoint>, Vec<bool>) = (Vec::with_capacity(points.len()), Vec::new());
    for q in points {
        let q_free = is_free(&q);
        if let (Some(last), Some(&last_free)) = (out.last().copied(), free.last()) {
            let mut stops: Vec<(DensePoint, bool)> = vec![(last, last_free)];
            // Something thin may stand between two free points.
            let pose = |q: &DensePoint| Pose { p: q.p, a: q.n };
            if last_free && q_free && motion::hit(beam, &pose(&last), &pose(&q), 0.0).is_some() {
                let steps = ((q.p - last.p).norm() / RUN_END_MM).ceil().max(2.0) * 4.0;
                stops.extend((1..steps as usize).map(|i| {
                    let mid = dense::midway(&last, &q, i as f64 / steps);
                    (mid, is_free(&mid))
                }));
            }
            stops.push((q, q_free));
            for w in stops.windows(2).filter(|w| w[0].1 != w[1].1) {
                let (mut a, mut b) = (w[0].0, w[1].0);
                while (b.p - a.p).norm() > RUN_END_MM {
                    let mid = dense::midway(&a, &b, 0.5);
                    if is_free(&mid) == w[0].1 { a = mid } else { b = mid }
                }
                for (end, is) in [(a, w[0].1), (b, w[1].1)] {
                    if out.last().is_some_and(|l| l.p != end.p) && end.p != q.p {
                        out.push(end);
                        free.push(is);
                    }
                }
            }
        }
        out.push(q);
        free.push(q_free);
    }
    (out, free)
}

/// A dense line with its axes.
struct Planned {
    points: Vec<DensePoint>,
    /// `None` where the beam is blocked.
    axes: Vec<Option<Vector3<f64>>>,
    /// What the axes would be if nothing were in the way.
    aims: Vec<Vector3<f64>>,
    /// The same point as the one before; the laser is off between the two.
    splits: Vec<bool>,
    /// How fast a corrected beam may turn against the normal, degrees/mm.
    rate_deg_mm: f64,
}

impl Planned {
    fn along_normals(points: Vec<DensePoint>, axes: Vec<Option<Vector3<f64>>>) -> Planned {
        // What a correction leaves within rounding of the normal is the normal.
        let snapped =
            |(q, a): (&DensePoint, Option<Vector3<f64>>)| a.map(|a| if (a - q.n).norm() < 1e-9 { q.n } else { a });
        let axes = points.iter().zip(axes).map(snapped).collect();
        let (aims, splits) = (points.iter().map(|q| q.n).collect(), vec![false; points.len()]);
        Planned { points, axes, aims, splits, rate_deg_mm: f64::INFINITY }
    }

    fn of_rows(rows: &[clearance::Row], rate_deg_mm: f64) -> Planned {
        Planned {
            points: rows.iter().map(|r| r.q).collect(),
            axes: rows.iter().map(|r| r.axis).collect(),
            aims: rows.iter().map(|r| r.aim).collect(),
            splits: rows.iter().map(|r| r.is_split).collect(),
            rate_deg_mm,
        }
    }

    fn pose(&self, i: usize) -> Option<Pose> {
        self.axes[i].map(|a| Pose { p: self.points[i].p, a })
    }

    fn state(&self, i: usize) -> State {
        match self.axes[i] {
            None => State::Blocked,
            Some(a) if a == self.aims[i] => State::Free,
            Some(_) => State::Corrected,
        }
    }

    /// Where the beam hits something between two neighbours that are free, a blocked point is put;
    /// where it turns more than a move may, points between.
    fn test_motion(&mut self, beam: &Beam<'_>, max_turn_deg: f64) {
        let old = std::mem::replace(self, Planned::along_normals(Vec::new(), Vec::new()));
        self.rate_deg_mm = old.rate_deg_mm;
        for i in 0..old.points.len() {
            self.push(old.points[i], old.axes[i], old.aims[i], old.splits[i]);
            let Some(next) = (i + 1 < old.points.len() && !old.splits[i + 1]).then_some(i + 1) else { continue };
            let Some((from, to)) = old.pose(i).zip(old.pose(next)) else { continue };
            let between = |t: f64| dense::midway(&old.points[i], &old.points[next], t);
            if let Some(t) = motion::hit(beam, &from, &to, 0.0) {
                self.push(between(t), None, between(t).n, false);
                continue;
            }
            // A hair of tolerance: turns are found in whole fractions of a degree.
            let steps = (angle::between_deg(&from.a, &to.a) / max_turn_deg - 1e-6).ceil().max(1.0);
            let tilted = old.aims[i] != old.points[i].n || old.aims[next] != old.points[next].n;
            for k in 1..steps as usize {
                let t = k as f64 / steps;
                let q = between(t);
                let aim = if tilted { angle::slerp(&old.aims[i], &old.aims[next], t) } else { q.n };
                self.push(q, Some(motion::midway(&from, &to, t).a), aim, false);
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
    fn reduce(&self, beam: &Beam<'_>, limits: &ChordLimits) -> Vec<Place> {
        let last = self.points.len() - 1;
        // Points at which the state changes stay, on both sides; and those of a split.
        let fixed: Vec<bool> = (0..=last)
            .map(|i| {
                let state = self.state(i);
                i > 0 && (self.state(i - 1) != state || self.splits[i])
                    || i < last && (self.state(i + 1) != state || self.splits[i + 1])
            })
            .collect();
        chord::simplify(&self.points, &fixed, limits, |from, to| self.may_span(beam, from, to, limits.max_turn_deg))
    }

    /// Axis at a place; between two points of one state.
    fn axis(&self, place: Place) -> Option<Vector3<f64>> {
        let a = self.axes[place.index]?;
        if place.share == 0.0 {
            return Some(a);
        }
        if a == self.points[place.index].n && self.state(place.index) == State::Free {
            return Some(place.on(&self.points).n);
        }
        Some(angle::slerp(&a, &self.axes[place.index + 1]?, place.share))
    }

    /// Whether the straight motion between two places can stand for the points between.
    fn may_span(&self, beam: &Beam<'_>, i: Place, j: Place, max_turn_deg: f64) -> bool {
        let pose = |place: Place| self.axis(place).map(|a| Pose { p: place.on(&self.points).p, a });
        let (Some(from), Some(to)) = (pose(i), pose(j)) else {
            // Blocked rows only say where; nothing moves along them with the laser on.
            return self.axes[i.index].is_none() && self.axes[j.index].is_none();
        };
        let whole = (to.p - from.p).norm().max(1e-12);
        let between = i.index + 1..j.index + usize::from(j.share > 0.0);
        let same_axis = from.a == to.a && between.clone().all(|k| self.axes[k] == Some(from.a));
        let sag = chord::chord_error_mm(&self.points, i, j);
        if same_axis && sag < 1e-7 {
            return true; // a flat: the detection has looked at this very motion
        }
        let arc = angle::Arc::new(&from.a, &to.a);
        let on_axis = |k: usize| {
            let share = ((self.points[k].p - from.p).dot(&(to.p - from.p)) / (whole * whole)).clamp(0.0, 1.0);
            self.axes[k].is_some_and(|a| angle::between_deg(&arc.at(share), &a) <= AXIS_ERROR_DEG)
        };
        let corrected = self.state(i.index) == State::Corrected || self.state(j.index) == State::Corrected;
        let max_turn_deg = if corrected { max_turn_deg.min(CORRECTED_TURN_DEG) } else { max_turn_deg };
        let (n, to_n) = (i.on(&self.points).n, j.on(&self.points).n);
        angle::between_deg(&from.a, &to.a) <= max_turn_deg + 1e-6
            && (!corrected || against_normal_deg((&n, &from.a), (&to_n, &to.a)) <= self.rate_deg_mm * whole)
            && between.clone().all(on_axis)
            && motion::is_free(beam, &from, &to, sag)
    }

    fn fill(&self, beam: &Beam<'_>, pass: Pass, kept: &[Place]) -> Pass {
        let tangents = dense::tangents(&self.points, pass.closed);
        let mut targets: Vec<Target> = Vec::with_capacity(kept.len());
        let mut splits = Vec::new();
        for &place in kept {
            let q = place.on(&self.points);
            let axis = self.axis(place);
            let (state, a) = (self.state(place.index), axis.unwrap_or(q.n));
            let is_split = place.share == 0.0 && self.splits[place.index];
            let laser =
                !is_split && state != State::Blocked && targets.last().is_some_and(|t| t.state != State::Blocked);
            if is_split {
                splits.push(Split { point: targets.len(), wall: self.wall(beam, place.index) });
            }
            let normal_hits = beam.blocker(&q.p, &q.n);
            let clearance_mm = beam.clearance_mm(&q.p, &a);
            let tangent = match place.share {
                0.0 => tangents[place.index],
                _ => self.points[place.index + 1].p - self.points[place.index].p,
            };
            targets.push(Target {
                p: q.p,
                n: q.n,
                a,
                o: travel(&tangent, &a),
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

    /// What keeps the beam from turning at the split `i`: on the way from one beam to the other, or where
    /// the one before would come to if it were kept on.
    fn wall(&self, beam: &Beam<'_>, i: usize) -> Option<Blocker> {
        let (q, from, to) = (self.points[i], self.axes[i.checked_sub(1)?]?, self.axes[i]?);
        let arc = angle::Arc::new(&from, &to);
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
