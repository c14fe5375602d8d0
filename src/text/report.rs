//! The report in a few lines for people, the most important first.

use super::dose::dose_lines;
use super::notice::notice_line;
use super::scan::scan_lines;
use super::{Naming, Sentence, clock, fixed, say};
use crate::document::Job;
use crate::part::SurfaceId;
use crate::planning::report::{Report, notices_worst_first};

/// The state of a plan, its findings with what helps, then figures; without what was found in the part's file. `job`:
/// what was planned. Every line ends with a line break.
pub fn report_lines(report: &Report, job: &Job) -> String {
    let naming = Naming::of(job);
    let mut lines: Vec<String> = report.status().iter().map(Sentence::sentence).collect();
    lines.extend(notices_worst_first(report, job, &[]).iter().map(|notice| notice_line(notice, &naming)));
    lines.extend(figures(report));
    if let Some(scan) = &report.scan {
        lines.extend(scan_lines(scan));
    }
    match &report.dose {
        Some(dose) => lines.extend(dose_lines(dose, &naming)),
        None => lines.push(say!(report_no_dose)),
    }
    for s in report.surfaces.iter().filter(|s| s.blocked_mm > 0.0) {
        let (blocked, whole) = (fixed(s.blocked_mm, 1), fixed(s.blocked_mm + s.work_mm, 1));
        lines.push(say!(report_surface_blocked, surface = naming.surface(SurfaceId(s.surface)), blocked, whole));
    }
    lines.into_iter().map(|line| line + "\n").collect()
}

/// Figures of the path, in lines.
pub(super) fn figures(r: &Report) -> Vec<String> {
    let free = r.points.saturating_sub(r.corrected + r.blocked);
    let [work, blocked, air] = [r.work_mm, r.blocked_mm, r.air_mm].map(|mm| fixed(mm, 1));
    let tilt = fixed(r.max_tilt_deg, 1);
    let (chord, spacing) = (fixed(r.max_chord_error_mm, 4), fixed(r.max_surface_spacing_mm, 3));
    let (passes, targets, corrected) = (r.passes, r.points, r.corrected);
    let time = clock(r.time_s);
    let lengths = if r.weld.is_some() {
        say!(report_lengths_ground, work, blocked, air, time)
    } else {
        say!(report_lengths, work, blocked, air, time)
    };
    let mut lines = vec![
        say!(report_targets, passes, targets, free, corrected, blocked = r.blocked),
        lengths,
        say!(report_extremes, tilt, chord, spacing),
    ];
    if r.layers > 1 {
        lines.push(say!(report_layers, layers = r.layers));
    }
    if !r.splits.is_empty() {
        lines.push(say!(report_splits, splits = r.splits.len()));
    }
    if r.order.way_mm < r.order.zigzag_way_mm {
        lines.push(say!(report_order, way = fixed(r.order.way_mm, 1), zigzag = fixed(r.order.zigzag_way_mm, 1)));
    }
    lines
}
