//! P1's correction in the section plane (3.2, Algorithm 3), with the cases that the paper leaves
//! open decided: no common point O, runs at a line's end, closed lines, and the test of the result.

use super::interference::{BeamInterference, Obstruction};
use super::{Pose, motion};
use crate::part::{Part, angle};
use crate::path::DensePoint;
use nalgebra::{Point3, Vector3};

/// Greatest tilt from the normal that a search may reach, degrees: beyond it a round spot is drawn
/// out to 1.4 times its length. P1's own rule (towards O) has a limit of its own.
pub const MAX_TILT_DEG: f64 = 45.0;
/// Greatest tilt of a beam towards O, degrees: a round spot is 5.8 times as long as wide there. On
/// every V-groove narrow enough to interfere the beam at its root is tilted more than 45°.
const MAX_TILT_TO_O_DEG: f64 = 80.0;
/// Angle that a turned beam keeps from the nearest blocked direction, degrees.
const SPARE_DEG: f64 = 1.0;
/// Length below which the projection of a normal into the section plane gives no direction.
const IN_PLANE: f64 = 0.1;
/// A run whose corrected beams still interfere is tried again from wider ends, up to so many dense
/// points on each side. Between gear teeth the end beams graze the same tip, so O lies beside it
/// and the beams of the first try pass at less than the allowed 0.02 mm; 0.05 mm wider they clear
/// it by 0.07 mm.
const MAX_GROWTH: usize = 24;

/// Corrects one line. `free[i]`: the beam along the normal is free. Returns the axis of each point;
/// `None` where there is no free one. `m`: the normal of the line's plane; a line in no plane is taken in that of
/// travel and normal in the middle of each run. `closed`: the last point is the first again. `limit_deg`: the greatest
/// tilt of all, in place of this method's own two.
pub fn correct(
    part: &Part,
    beam: &BeamInterference<'_>,
    points: &[DensePoint],
    free: &[bool],
    closed: bool,
    m: Option<Vector3<f64>>,
    limit_deg: Option<f64>,
) -> Vec<Option<Vector3<f64>>> {
    let limits_deg = limit_deg.map_or((MAX_TILT_DEG, MAX_TILT_TO_O_DEG), |limit| (limit, limit));
    if free.iter().all(|f| *f) {
        return points.iter().map(|q| Some(q.n)).collect();
    }
    if !closed {
        return LineCorrection { part, beam, points, free, m: Vector3::zeros(), limits_deg }.corrected(m);
    }
    // A closed line is opened in the middle of its longest free stretch, so that every run has two
    // free ends.
    let count = points.len() - 1;
    let Some(seam) = middle_of_longest_free(&free[..count]) else {
        return vec![None; points.len()];
    };
    let turned: Vec<usize> = (0..=count).map(|i| (i + seam) % count).collect();
    let opened: Vec<DensePoint> = turned.iter().map(|&i| points[i]).collect();
    let opened_free: Vec<bool> = turned.iter().map(|&i| free[i]).collect();
    let line = LineCorrection { part, beam, points: &opened, free: &opened_free, m: Vector3::zeros(), limits_deg };
    let axes = line.corrected(m);
    let mut out: Vec<Option<Vector3<f64>>> = (0..count).map(|i| axes[(i + count - seam) % count]).collect();
    out.push(out[0]);
    out
}

/// Normal of the plane of travel and surface normal at a point, unit.
pub fn local_plane(before: &DensePoint, at: &DensePoint, behind: &DensePoint) -> Vector3<f64> {
    angle::unit((behind.p - before.p).cross(&at.n)).unwrap_or_else(|| angle::any_square_to(&at.n))
}

fn middle_of_longest_free(free: &[bool]) -> Option<usize> {
    let count = free.len();
    let (mut best, mut length) = (None, 0);
    // Twice round, so that a stretch over the seam is seen whole.
    let mut run = 0;
    for i in 0..2 * count {
        run = if free[i % count] { (run + 1).min(count) } else { 0 };
        if run > length {
            (length, best) = (run, Some((i + count - (run - 1) / 2) % count));
        }
    }
    best
}

/// Length of vectors in the section plane.
fn in_plane(v: &Vector3<f64>, m: &Vector3<f64>) -> Vector3<f64> {
    v - m * v.dot(m)
}

#[derive(Clone, Copy)]
struct LineCorrection<'a> {
    part: &'a Part,
    beam: &'a BeamInterference<'a>,
    points: &'a [DensePoint],
    free: &'a [bool],
    /// Normal of the plane of the run that is worked on.
    m: Vector3<f64>,
    /// Greatest tilt of a beam that is turned by itself, and of one towards O, degrees.
    limits_deg: (f64, f64),
}

/// The corrected points from `first` on, with their axes.
struct Attempt {
    first: usize,
    axes: Vec<Option<Vector3<f64>>>,
    /// Points without an axis, and moves between neighbours on which the beam hits something, before
    /// single points were turned.
    faults: usize,
}

impl LineCorrection<'_> {
    fn corrected(&self, m: Option<Vector3<f64>>) -> Vec<Option<Vector3<f64>>> {
        let mut out: Vec<Option<Vector3<f64>>> =
            self.points.iter().zip(self.free).map(|(q, f)| f.then_some(q.n)).collect();
        let mut at = 0;
        while let Some(first) = (at..self.points.len()).find(|&i| !self.free[i]) {
            let line = LineCorrection { m: m.unwrap_or_else(|| self.local_plane(first)), ..*self };
            let attempt = line.run_from(first);
            at = attempt.first + attempt.axes.len();
            let place = attempt.first;
            for (k, axis) in attempt.axes.into_iter().enumerate() {
                // A wider run may reach back to a point that was free: it stays so.
                out[place + k] = axis.or(out[place + k]);
            }
        }
        out
    }

    /// Normal of the plane of travel and surface normal in the middle of the run that begins at `first`.
    fn local_plane(&self, first: usize) -> Vector3<f64> {
        let middle = (first + self.stretch_end(first)) / 2;
        let last = self.points.len() - 1;
        local_plane(&self.points[middle.saturating_sub(1)], &self.points[middle], &self.points[(middle + 1).min(last)])
    }

    /// Last point of the stretch of interfering points that begins at `i`.
    fn stretch_end(&self, i: usize) -> usize {
        (i..self.points.len()).take_while(|&k| !self.free[k]).last().unwrap_or(i)
    }

    fn stretch_start(&self, i: usize) -> usize {
        (0..=i).rev().take_while(|&k| !self.free[k]).last().unwrap_or(i)
    }

    /// Corrects the run that begins at `first`, growing it while that helps; points that still hit
    /// something are turned one by one.
    fn run_from(&self, first: usize) -> Attempt {
        let (mut first, mut last) = (first, self.stretch_end(first));
        let mut best: Option<Attempt> = None;
        for _ in 0..=MAX_GROWTH {
            // Ends that are not free with their projected axes belong to the run.
            while first > 0 && !self.is_end(first - 1) {
                first = self.stretch_start(first - 1);
            }
            while last + 1 < self.points.len() && !self.is_end(last + 1) {
                last = self.stretch_end(last + 1);
            }
            let (before, behind) = (first.checked_sub(1), (last + 1 < self.points.len()).then_some(last + 1));
            let (Some(start), Some(end)) = (before, behind) else {
                // A run that has grown over a line's end would lose that end's beam.
                return best.map_or_else(|| self.one_ended(first, last, before.or(behind)), |b| self.completed(b));
            };
            let wanted = self.between(start, end);
            let free = |i: usize, axis: &Vector3<f64>| {
                angle::between_deg(axis, &self.points[i].n) <= self.limits_deg.1
                    && self.beam.is_free(&self.points[i].p, axis)
            };
            let axes: Vec<_> = (first..=last).map(|i| Some(wanted(i)).filter(|a| free(i, a))).collect();
            let faults = self.faults(first, &axes);
            if best.as_ref().is_none_or(|b| faults < b.faults) {
                best = Some(Attempt { first, axes, faults });
            }
            if faults == 0 {
                break;
            }
            first = self.stretch_start(start);
            last = self.stretch_end(end);
        }
        best.map_or_else(|| Attempt { first, axes: vec![None; last + 1 - first], faults: 0 }, |b| self.completed(b))
    }

    /// A run at a line's end, or one that is the whole line.
    fn one_ended(&self, first: usize, last: usize, end: Option<usize>) -> Attempt {
        let axes = (first..=last).map(|i| self.turned_away(i, &self.points[end?].n)).collect();
        Attempt { first, axes, faults: 0 }
    }

    /// Turns single points by themselves where the axes of the run still hit something.
    fn completed(&self, mut attempt: Attempt) -> Attempt {
        let last = attempt.first + attempt.axes.len() - 1;
        if attempt.axes.iter().any(Option::is_none) {
            let wanted = self.between(attempt.first - 1, last + 1);
            for (k, axis) in attempt.axes.iter_mut().enumerate().filter(|(_, a)| a.is_none()) {
                let i = attempt.first + k;
                *axis = self.turned_away(i, &wanted(i));
            }
        }
        attempt
    }

    fn faults(&self, first: usize, axes: &[Option<Vector3<f64>>]) -> usize {
        let last = first + axes.len() - 1;
        let pose = |i: usize| {
            let axis = if (first..=last).contains(&i) { axes[i - first] } else { Some(self.points[i].n) };
            axis.map(|a| Pose { p: self.points[i].p, a })
        };
        let moves = first.saturating_sub(1)..(last + 1).min(self.points.len() - 1);
        let hits = |i: &usize| match (pose(*i), pose(i + 1)) {
            (Some(from), Some(to)) => !motion::is_free(self.beam, &from, &to, 0.0),
            _ => false,
        };
        axes.iter().filter(|a| a.is_none()).count() + moves.filter(hits).count()
    }

    /// Whether a point can be the end p0 or pn of a run: free, with its projected axis too.
    fn is_end(&self, i: usize) -> bool {
        self.free[i]
            && angle::unit(in_plane(&self.points[i].n, &self.m)).is_some_and(|projected| {
                in_plane(&self.points[i].n, &self.m).norm() < IN_PLANE
                    || self.beam.is_free(&self.points[i].p, &projected)
            })
    }

    /// P1 Eqs 8–10: the axes towards O; where there is no O, the end axes interpolated.
    fn between(&self, start: usize, end: usize) -> Box<dyn Fn(usize) -> Vector3<f64> + '_> {
        let arc: Vec<f64> = self.points[start..=end]
            .windows(2)
            .scan(0.0, |s, w| {
                *s += (w[1].p - w[0].p).norm();
                Some(*s)
            })
            .collect();
        let whole = arc.last().copied().unwrap_or(1.0).max(1e-12);
        let share = move |i: usize| arc[i - start - 1] / whole;
        let (q0, qn) = (self.points[start], self.points[end]);
        let Some(o) = common_point(&q0, &qn, &self.m) else {
            return Box::new(move |i| angle::slerp(&q0.n, &qn.n, share(i)));
        };
        let out_of_plane = |q: &DensePoint| libm::asin(q.n.dot(&self.m).clamp(-1.0, 1.0));
        let (lean0, lean_n) = (out_of_plane(&q0), out_of_plane(&qn));
        Box::new(move |i| {
            let q = &self.points[i];
            let Some(d) = angle::unit(in_plane(&(o - q.p), &self.m)) else { return q.n };
            let lean = lean0 + (lean_n - lean0) * share(i);
            d * libm::cos(lean) + self.m * libm::sin(lean)
        })
    }

    /// Turns `start` in the section plane away from what blocks it, by the least angle that is free
    /// with a degree to spare.
    fn turned_away(&self, i: usize, start: &Vector3<f64>) -> Option<Vector3<f64>> {
        let q = &self.points[i];
        let away = self.beam.blocker(&q.p, start).or_else(|| self.beam.blocker(&q.p, &q.n)).map_or(1.0, |b| {
            let mesh = &self.part.mesh;
            // A positive turn about m moves the axis along m × a.
            let turn = self.m.cross(start);
            let Obstruction::Facet(facet) = b.obstruction else { return 1.0 };
            let by_face = mesh.normals[facet as usize].dot(&turn);
            let by_place = (q.p - mesh.centroid(facet as usize)).dot(&turn);
            if (if by_face.abs() > 0.05 { by_face } else { by_place }) < 0.0 { -1.0 } else { 1.0 }
        });
        self.least_turn(q, start, away).or_else(|| self.least_turn(q, start, -away))
    }

    fn least_turn(&self, q: &DensePoint, start: &Vector3<f64>, side: f64) -> Option<Vector3<f64>> {
        let axis = |by: f64| angle::turned(start, &self.m, side * by);
        let good = |by: f64| {
            let a = axis(by);
            angle::between_deg(&a, &q.n) <= self.limits_deg.0
                && self.beam.is_free(&q.p, &a)
                && self.beam.is_free(&q.p, &axis(by - SPARE_DEG))
        };
        // A beam that is found keeps a degree to spare, so steps of a degree miss nothing usable.
        const STEP_DEG: f64 = 1.0;
        let steps = (2.0 * self.limits_deg.0 / STEP_DEG) as usize;
        let found = (0..=steps).map(|k| k as f64 * STEP_DEG).find(|&by| good(by))?;
        let (mut low, mut high) = (found - STEP_DEG, found);
        if found > 0.0 {
            while high - low > 0.02 {
                let middle = 0.5 * (low + high);
                if good(middle) { high = middle } else { low = middle }
            }
        }
        Some(axis(high.max(0.0)))
    }
}

/// O of P1 Eqs 8 and 9: where the projected beams of both ends meet, in front of both.
pub fn common_point(q0: &DensePoint, qn: &DensePoint, m: &Vector3<f64>) -> Option<Point3<f64>> {
    let (f0, fn_) = (in_plane(&q0.n, m), in_plane(&qn.n, m));
    if f0.norm() < IN_PLANE || fn_.norm() < IN_PLANE {
        return None;
    }
    let (a0, an) = (f0.normalize(), fn_.normalize());
    let cross = a0.cross(&an);
    // Less than 0.06° between them: O is as good as infinitely far.
    if cross.norm() < 1e-3 {
        return None;
    }
    let w = in_plane(&(qn.p - q0.p), m);
    let k0 = w.cross(&an).dot(&cross) / cross.norm_squared();
    let kn = w.cross(&a0).dot(&cross) / cross.norm_squared();
    (k0 > 0.0 && kn > 0.0).then(|| q0.p + a0 * k0)
}
