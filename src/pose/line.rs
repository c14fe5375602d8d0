//! From a transversal line to the targets of a pass: dense line, detection, correction, or how a contact tool stands;
//! then, in `planned`, the test of the result and of the motion between, and the arch height reduction.

mod contact_stand;
mod planned;

use super::correction::Correction;
use super::interference::BeamInterference;
use super::line_rules::LineRules;
use super::motion;
use super::target::{Pass, Split};
use super::tilt::Pin;
use super::{Pose, clearance, section_plane};
use crate::beam::{ProcessSettings, ToolConfiguration};
use crate::part::Part;
use crate::path::dense::{self, DensePoint};
use crate::path::{SectionPoint, TransversalLine};
use crate::progress::{Cancelled, Progress};
use contact_stand::contact_stands;
use nalgebra::Vector3;
use planned::Planned;

/// Precision of the ends of an interfering run, mm.
const RUN_END_MM: f64 = 0.05;

/// A line to be planned.
#[derive(Clone, Copy, Debug)]
pub struct LineOnSurface<'a> {
    /// Its points.
    pub line: &'a TransversalLine,
    /// Surface number.
    pub surface: u32,
    /// Its place in the working order of the surface.
    pub number: u32,
    /// Normal of its section plane; `None`: it lies in no plane.
    pub m: Option<Vector3<f64>>,
}

/// Plans one line of one surface. The first configuration is preferred; a later one is taken if it leaves less of
/// the line blocked. The laser is off over the line's dark gaps.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn plan_line(
    part: &Part,
    configurations: &[ToolConfiguration<'_>],
    line: &LineOnSurface<'_>,
    rules: &LineRules,
    progress: &Progress,
) -> Result<Pass, Cancelled> {
    let on = |configuration: &ToolConfiguration<'_>, correction: Correction, limit_deg: Option<f64>| {
        planned(part, configuration, line, (rules, correction, limit_deg), progress)
    };
    let mut best: Option<(f64, Pass)> = None;
    for configuration in configurations {
        // Without a head the section plane keeps limits of its own.
        let limit_deg = configuration.geometry.as_ref().filter(|g| g.has_head).map(|_| rules.max_tilt_deg);
        let pass = on(configuration, rules.correction, limit_deg)?;
        let blocked_mm = pass.length_mm(|from, to| !to.laser && !Pass::is_gap(from, to));
        if best.as_ref().is_none_or(|(least_mm, _)| blocked_mm < least_mm - 1e-6) {
            best = Some((blocked_mm, pass));
        }
        if blocked_mm == 0.0 {
            break;
        }
    }
    match best {
        Some((_, pass)) => Ok(pass),
        None => on(&ToolConfiguration::ray(ProcessSettings::default()), Correction::None, None),
    }
}

/// Plans a line by the section plane within the greatest tilt of `rules`, for comparison with the search.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn plan_line_by_section_plane(
    part: &Part,
    configuration: &ToolConfiguration<'_>,
    line: &LineOnSurface<'_>,
    rules: &LineRules,
    progress: &Progress,
) -> Result<Pass, Cancelled> {
    planned(part, configuration, line, (rules, Correction::SectionPlane, Some(rules.max_tilt_deg)), progress)
}

fn planned(
    part: &Part,
    configuration: &ToolConfiguration<'_>,
    whole_line: &LineOnSurface<'_>,
    (rules, correction, limit_deg): (&LineRules, Correction, Option<f64>),
    progress: &Progress,
) -> Result<Pass, Cancelled> {
    if whole_line.line.dark.is_empty() {
        return planned_piece(part, configuration, whole_line, (rules, correction, limit_deg), progress);
    }
    let LineOnSurface { line, surface, m, .. } = whole_line;
    // Obstacles on one side of a gap do not matter on the other, so each piece is planned by itself; its first
    // target is reached with the laser off, as in any pass.
    let mut whole = Pass {
        surface: *surface,
        settings: configuration.settings,
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
        // Pins are placed on the whole line.
        let moved = |pin: &Pin| Pin { at_mm: pin.at_mm - start_mm, ..*pin };
        let rules = LineRules { pins: rules.pins.iter().map(moved).collect(), ..rules.clone() };
        start_mm += points.windows(2).map(way_mm).fold(0.0, |a, b| a + b);
        let piece = TransversalLine { plane: line.plane, points: points.to_vec(), closed: false, dark: Vec::new() };
        let pass = planned_piece(
            part,
            configuration,
            &LineOnSurface { line: &piece, ..*whole_line },
            (&rules, correction, limit_deg),
            progress,
        )?;
        let before = whole.targets.len();
        whole.splits.extend(pass.splits.iter().map(|s| Split { point: s.point + before, wall: s.wall }));
        whole.targets.extend(pass.targets);
        whole.dense_points += pass.dense_points;
        whole.chord_error_mm = whole.chord_error_mm.max(pass.chord_error_mm);
    }
    Ok(whole)
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

/// Plans a line without gaps.
fn planned_piece(
    part: &Part,
    configuration: &ToolConfiguration<'_>,
    LineOnSurface { line, surface, number, m }: &LineOnSurface<'_>,
    (rules, correction, limit_deg): (&LineRules, Correction, Option<f64>),
    progress: &Progress,
) -> Result<Pass, Cancelled> {
    let beam = BeamInterference::with(part, configuration.geometry.as_ref()).under(Some(progress));
    let dense = dense::dense(line, rules.max_gap_mm, rules.max_dense_turn_deg);
    let dense_points = dense.len();
    let contact = configuration.geometry.as_ref().and_then(|g| g.contact.as_ref());
    let found = if contact.is_some() { Detected::default() } else { detected(&beam, &dense) };
    let Detected { points, free, is_clear } = found;
    let mut planned = match (contact, correction) {
        (Some(contact), _) => {
            let stands = contact_stands(&beam, &contact.place, &dense, line.closed);
            Planned::of_contact(contact.place, &stands)
        }
        (None, Correction::None) => {
            let axes = points.iter().zip(&free).map(|(q, f)| f.then_some(q.n)).collect();
            Planned::along_normals(points, axes, is_clear)
        }
        (None, Correction::SectionPlane) => {
            let axes = section_plane::correct(part, &beam, &points, &free, line.closed, *m, limit_deg);
            Planned::along_normals(points, axes, is_clear)
        }
        (None, Correction::Clearance) => {
            let rows = clearance::correct(part, &beam, &points, &free, line.closed, *number, rules);
            Planned::of_rows(&rows, rules.tilt_rate_deg_mm)
        }
    };
    planned.test_motion(&beam, rules.chord.max_turn_deg);
    let kept = planned.reduce(&beam, &rules.chord);
    beam.check()?;
    let pass = Pass {
        surface: *surface,
        settings: configuration.settings,
        plane_normal: plane_normal(line, *m),
        closed: line.closed,
        targets: Vec::new(),
        line_points: line.points.len(),
        dense_points,
        chord_error_mm: 0.0,
        splits: Vec::new(),
    };
    let pass = planned.fill(&beam, pass, &kept);
    // What was asked of a beam that was cancelled meanwhile is not true.
    beam.check().map(|()| pass)
}

/// The points of a line as the beam finds them along their normals.
#[derive(Default)]
struct Detected {
    points: Vec<DensePoint>,
    free: Vec<bool>,
    /// Whether the beam meets nothing on the way to each point from the one before.
    is_clear: Vec<bool>,
}

/// Finds which points are free, and adds points where a run of interference begins or ends.
fn detected(beam: &BeamInterference<'_>, points: &[DensePoint]) -> Detected {
    let is_free = |q: &DensePoint| beam.is_free(&q.p, &q.n);
    let (mut out, mut free): (Vec<DensePoint>, Vec<bool>) = (Vec::with_capacity(points.len()), Vec::new());
    let mut is_clear: Vec<bool> = Vec::with_capacity(points.len());
    for &q in points {
        let q_free = is_free(&q);
        let mut is_way_clear = false;
        if let (Some(last), Some(&last_free)) = (out.last().copied(), free.last()) {
            let mut stops: Vec<(DensePoint, bool)> = vec![(last, last_free)];
            // Something thin may stand between two free points.
            let pose = |q: &DensePoint| Pose { p: q.p, a: q.n };
            is_way_clear = last_free && q_free && motion::is_free(beam, &pose(&last), &pose(&q), 0.0);
            if last_free && q_free && !is_way_clear {
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
                        is_clear.push(false);
                    }
                }
            }
        }
        out.push(q);
        free.push(q_free);
        is_clear.push(is_way_clear);
    }
    Detected { points: out, free, is_clear }
}
