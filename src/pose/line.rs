//! From a transversal line to the targets of a pass: dense line, detection, correction, the test of
//! the result and of the motion between, and the arch height reduction.

use super::correction::Correction;
use super::interference::Beam;
use super::motion::{self, Pose};
use super::section_plane;
use super::target::{Pass, State, Target, travel};
use crate::part::{Part, angle};
use crate::path::TransversalLine;
use crate::path::chord::{self, ChordLimits};
use crate::path::dense::{self, DensePoint};
use nalgebra::Vector3;

/// What a line is planned by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineRules {
    /// Largest gap of the dense line, mm.
    pub max_gap_mm: f64,
    /// What a chord may span.
    pub chord: ChordLimits,
    /// What is done about interference.
    pub correction: Correction,
}

/// Ends of an interfering run are found to this, mm.
const RUN_END_MM: f64 = 0.05;
/// A corrected axis that was dropped lies within this of the motion that replaces it, degrees.
const AXIS_ERROR_DEG: f64 = 1.0;

/// Plans one line of one surface; `m` is its section plane's normal.
pub fn plan_line(part: &Part, surface: u32, line: &TransversalLine, m: &Vector3<f64>, rules: &LineRules) -> Pass {
    let beam = Beam::on(part);
    let (points, free) = detected(&beam, dense::dense(line, rules.max_gap_mm));
    let axes = match rules.correction {
        Correction::None => points.iter().zip(&free).map(|(q, f)| f.then_some(q.n)).collect(),
        Correction::SectionPlane => section_plane::correct(part, &beam, &points, &free, line.closed, m),
    };
    let mut planned = Planned { points, axes };
    planned.test_motion(&beam);
    let kept = planned.reduce(&beam, &rules.chord);
    planned.pass(&beam, surface, m, line.closed, &kept)
}

/// Finds out which points are free, and adds those at which that changes.
fn detected(beam: &Beam<'_>, points: Vec<DensePoint>) -> (Vec<DensePoint>, Vec<bool>) {
    let is_free = |q: &DensePoint| beam.is_free(&q.p, &q.n);
    let (mut out, mut free): (Vec<DensePoint>, Vec<bool>) = (Vec::with_capacity(points.len()), Vec::new());
    for q in points {
        let q_free = is_free(&q);
        if let (Some(last), Some(&last_free)) = (out.last().copied(), free.last()) {
            // Something thin may stand between two free points.
            let pose = |q: &DensePoint| Pose { p: q.p, a: q.n };
            let between: Vec<f64> = motion::shares(&pose(&last), &pose(&q)).collect();
            let mut stops: Vec<(DensePoint, bool)> = vec![(last, last_free)];
            if last_free || q_free {
                stops.extend(between.iter().map(|&t| {
                    let mid = dense::midway(&last, &q, t);
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

/// A dense line with its axes; `None` where the beam is blocked.
struct Planned {
    points: Vec<DensePoint>,
    axes: Vec<Option<Vector3<f64>>>,
}

impl Planned {
    fn pose(&self, i: usize) -> Option<Pose> {
        self.axes[i].map(|a| Pose { p: self.points[i].p, a })
    }

    fn state(&self, i: usize) -> State {
        match self.axes[i] {
            None => State::Blocked,
            Some(a) if a == self.points[i].n => State::Free,
            Some(_) => State::Corrected,
        }
    }

    /// Where the beam hits something between two neighbours that are free, a blocked point is put.
    fn test_motion(&mut self, beam: &Beam<'_>) {
        let (mut points, mut axes) = (Vec::with_capacity(self.points.len()), Vec::with_capacity(self.points.len()));
        for i in 0..self.points.len() {
            points.push(self.points[i]);
            axes.push(self.axes[i]);
            let Some((from, to)) = self.pose(i).zip((i + 1 < self.points.len()).then(|| self.pose(i + 1)).flatten())
            else {
                continue;
            };
            // Along the normals the detection has looked already.
            let detected = self.state(i) == State::Free && self.state(i + 1) == State::Free;
            if !detected && let Some(t) = motion::first_hit(beam, &from, &to, 0.0) {
                points.push(dense::midway(&self.points[i], &self.points[i + 1], t));
                axes.push(None);
            }
        }
        (self.points, self.axes) = (points, axes);
    }

    /// Indices of the points that become targets.
    fn reduce(&self, beam: &Beam<'_>, limits: &ChordLimits) -> Vec<usize> {
        let last = self.points.len() - 1;
        // Points at which the state changes stay, on both sides.
        let fixed: Vec<bool> = (0..=last)
            .map(|i| {
                let state = self.state(i);
                i > 0 && self.state(i - 1) != state || i < last && self.state(i + 1) != state
            })
            .collect();
        chord::simplify(&self.points, &fixed, limits, |i, j| self.may_span(beam, i, j))
    }

    /// Whether the straight motion from i to j can stand for the points between.
    fn may_span(&self, beam: &Beam<'_>, i: usize, j: usize) -> bool {
        let (Some(from), Some(to)) = (self.pose(i), self.pose(j)) else {
            // Blocked rows only say where; nothing moves along them with the laser on.
            return self.axes[i].is_none() && self.axes[j].is_none();
        };
        let whole = (to.p - from.p).norm().max(1e-12);
        let same_axis = (i..=j).all(|k| self.axes[k] == Some(from.a));
        let sag = chord::chord_error_mm(&self.points, i, j);
        if same_axis && sag < 1e-7 {
            return true; // a flat: the detection has looked at these very poses
        }
        let arc = angle::Arc::new(&from.a, &to.a);
        let on_axis = |k: usize| {
            let share = ((self.points[k].p - from.p).dot(&(to.p - from.p)) / (whole * whole)).clamp(0.0, 1.0);
            self.axes[k].is_some_and(|a| angle::between_deg(&arc.at(share), &a) <= AXIS_ERROR_DEG)
        };
        (i + 1..j).all(on_axis) && motion::is_free(beam, &from, &to, sag)
    }

    fn pass(&self, beam: &Beam<'_>, surface: u32, m: &Vector3<f64>, closed: bool, kept: &[usize]) -> Pass {
        let tangents = dense::tangents(&self.points, closed);
        let mut targets: Vec<Target> = Vec::with_capacity(kept.len());
        for &i in kept {
            let q = self.points[i];
            let (state, a) = (self.state(i), self.axes[i].unwrap_or(q.n));
            let laser = state != State::Blocked && targets.last().is_some_and(|t| t.state != State::Blocked);
            let normal_hits = beam.blocker(&q.p, &q.n).map(|b| b.facet);
            targets.push(Target { p: q.p, n: q.n, a, o: travel(&tangents[i], &a), state, laser, normal_hits });
        }
        let chord_error_mm =
            kept.windows(2).map(|w| chord::chord_error_mm(&self.points, w[0], w[1])).fold(0.0, f64::max);
        Pass { surface, plane_normal: *m, closed, targets, chord_error_mm }
    }
}
