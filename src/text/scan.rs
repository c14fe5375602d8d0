//! Where a scan lies on the model: why it lies nowhere, and how well it lies.

use super::number::percent;
use super::{Sentence, exact, fixed, id, say};
use crate::planning::scanned::{
    BroughtTogether, DeviationReport, RegistrationReport, RivalReport, ScanError, ScanReport, SlidingReport, WornPatch,
};
use crate::scan::continuation::ContinuationError;
use crate::scan::deviation::PatchKind;
use crate::scan::file::{UnitDoubt, UnitFit};
use crate::scan::merging::{MarkerError, OverlapError};
use crate::scan::registration::RegistrationError;
use crate::scan::transform_file::{MatrixFault, TransformError};

impl Sentence for TransformError {
    fn sentence(&self) -> String {
        match self {
            TransformError::File(e) => e.sentence(),
            TransformError::Json { file, line, reason } => say!(transform_json, file, line = id(*line), reason),
            TransformError::Matrix { file, fault } => say!(transform_matrix, file, fault = fault.sentence()),
        }
    }
}

impl Sentence for MatrixFault {
    fn sentence(&self) -> String {
        match self {
            MatrixFault::NotFinite => say!(matrix_not_finite),
            MatrixFault::LastRow => say!(matrix_last_row),
            MatrixFault::Scales(factor) => say!(matrix_scales, factor = exact(*factor)),
            MatrixFault::Shears => say!(matrix_shears),
            MatrixFault::Mirrors => say!(matrix_mirrors),
        }
    }
}

impl Sentence for ScanError {
    fn sentence(&self) -> String {
        match self {
            ScanError::File { file, source } => say!(in_file, file, what = source.sentence()),
            ScanError::Changed { file, .. } => say!(scan_changed, file),
            ScanError::Overlap { file, source } => say!(in_file, file, what = source.sentence()),
            ScanError::Units { doubt, diagonals_mm } => unit_doubt_sentence(doubt, *diagonals_mm),
            ScanError::Matrix(fault) => say!(scan_matrix, fault = fault.sentence()),
            ScanError::Registration(e) => e.sentence(),
            ScanError::Gate { patch, gate_mm } => {
                let (depth, gate, [x, y, z]) =
                    (fixed(patch.depth_mm, 2), exact(*gate_mm), place(&patch.at.coords.into()));
                match patch.kind {
                    PatchKind::Missing => say!(scan_gate_missing, depth, gate, x, y, z),
                    PatchKind::Surplus => say!(scan_gate_surplus, depth, gate, x, y, z),
                }
            }
            ScanError::Continued { number, source } => {
                say!(scan_damage, number = id(number + 1), what = source.sentence())
            }
            ScanError::BeadTooLow { layers } => say!(scan_layers, layers = fixed(*layers, 0)),
        }
    }
}

impl Sentence for ContinuationError {
    fn sentence(&self) -> String {
        match self {
            ContinuationError::NoRegion => say!(continue_no_region),
            ContinuationError::TooFewPoints { sound } => say!(continue_too_few, points = *sound),
            ContinuationError::OtherKind { rms_mm: Some(rms) } => say!(continue_other_kind, rms = fixed(*rms, 3)),
            ContinuationError::OtherKind { rms_mm: None } => say!(continue_no_such_kind),
            ContinuationError::ArcTooShort { rise_mm } => say!(continue_arc_too_short, rise = fixed(*rise_mm, 3)),
            ContinuationError::AxisOpen { spread_deg } => say!(continue_axis_open, spread = fixed(*spread_deg, 2)),
            ContinuationError::GapTooWide { spread_mm } => say!(continue_gap, spread = fixed(*spread_mm, 3)),
            ContinuationError::Cancelled => say!(text_cancelled),
        }
    }
}

impl Sentence for OverlapError {
    fn sentence(&self) -> String {
        match self {
            OverlapError::TooFewPoints { found, needed } => say!(overlap_too_few, found = *found, needed = *needed),
            OverlapError::NoOverlap { overlap_share, .. } => say!(overlap_none, overlap = percent(*overlap_share, 0)),
            OverlapError::FarFromStart { moved_mm, turned_deg } => {
                say!(overlap_far, moved = fixed(*moved_mm, 1), turned = fixed(*turned_deg, 1))
            }
            OverlapError::Ambiguous { poses } => say!(overlap_ambiguous, poses = poses.len()),
            OverlapError::Cancelled => say!(text_cancelled),
        }
    }
}

impl Sentence for BroughtTogether {
    fn sentence(&self) -> String {
        let overlap = percent(self.overlap, 0);
        say!(overlap_found, file = &*self.file, rms = fixed(self.rms_mm, 3), overlap)
    }
}

impl Sentence for MarkerError {
    fn sentence(&self) -> String {
        match self {
            MarkerError::TooFew { count } => say!(markers_too_few, count = *count),
            MarkerError::OnALine => say!(markers_on_a_line),
            MarkerError::NoNumber { marker } => say!(marker_no_number, marker = id(marker + 1)),
        }
    }
}

impl Sentence for RegistrationError {
    fn sentence(&self) -> String {
        match self {
            RegistrationError::NoModel => say!(register_no_model),
            RegistrationError::TooFewPoints { found, needed } => {
                say!(register_too_few_points, found = *found, needed = *needed)
            }
            RegistrationError::PairsTellNoMotion { pairs } => say!(register_pairs, pairs = *pairs),
            RegistrationError::NotSamePart { sigma_mm, limit_mm, overlap, .. } => {
                let [sigma, limit] = [*sigma_mm, *limit_mm].map(|x| fixed(x, 3));
                say!(register_not_same_part, sigma, limit, overlap = percent(*overlap, 1))
            }
            RegistrationError::Cancelled => say!(text_cancelled),
        }
    }
}

/// What is in doubt of the unit of a scan or a part, whose diagonals are these, mm.
pub fn unit_doubt_sentence(doubt: &UnitDoubt, [cloud_mm, part_mm]: [f64; 2]) -> String {
    let advice = match doubt.fits {
        UnitFit::Either { cloud, part } => say!(scan_unit_both, cloud_units = cloud.word(), part_units = part.word()),
        UnitFit::Cloud(units) => say!(scan_unit_cloud, units = units.word()),
        UnitFit::Part(units) => say!(scan_unit_part, units = units.word()),
    };
    let [cloud, part] = [cloud_mm, part_mm].map(|x| fixed(x, 1));
    say!(scan_unit_doubt, cloud, part, advice)
}

/// How a scan lies, and where that puts the part, a line each.
pub fn registration_lines(report: &RegistrationReport) -> Vec<String> {
    let mut lines = how_it_lies(report);
    lines.push(match &report.base_from_scan {
        None => scan_not_placed(),
        Some(placed) => {
            let worst = placed.residuals_mm.iter().map(|r| r.residual_mm).fold(0.0, f64::max);
            say!(register_placed, markers = placed.residuals_mm.len(), worst = fixed(worst, 3))
        }
    });
    lines
}

/// That nobody has said where the scanner stands in the cell.
pub fn scan_not_placed() -> String {
    say!(scan_not_placed)
}

/// How a scan lies, a line each.
pub fn how_it_lies(report: &RegistrationReport) -> Vec<String> {
    let [rms, noise] = [report.rms_mm, report.noise_mm].map(|x| fixed(x, 3));
    let (overlap, coverage) = (percent(report.overlap, 1), percent(report.coverage, 1));
    let mut lines = vec![say!(register_found, rms, noise, overlap, coverage)];
    lines.extend(report.sliding.iter().map(Sentence::sentence));
    let (same, other): (Vec<_>, Vec<_>) = report.rivals.iter().partition(|r| r.same_by_symmetry);
    if !same.is_empty() {
        lines.push(say!(register_rivals_same, rivals = same.len()));
    }
    lines.extend(other.into_iter().map(Sentence::sentence));
    if let Some(moved) = report.moved_by_wear_mm {
        lines.push(say!(register_wear, moved = fixed(moved, 3)));
    }
    lines
}

impl Sentence for SlidingReport {
    fn sentence(&self) -> String {
        let motion = match self.motion {
            "turn" => say!(motion_turn),
            "shift" => say!(motion_shift),
            _ => say!(motion_screw),
        };
        let ([x, y, z], [px, py, pz]) =
            (self.axis.direction.map(|c| fixed(c, 3)), self.axis.point_mm.map(|c| fixed(c, 1)));
        let axis = say!(scan_axis, x, y, z, px, py, pz);
        match self.slack_mm {
            None => say!(register_slides, motion, axis),
            Some(slack) => say!(register_weak, motion, axis, slack = fixed(slack, 2)),
        }
    }
}

impl Sentence for RivalReport {
    fn sentence(&self) -> String {
        let rms = fixed(self.rms_mm, 3);
        let Some(telling) = &self.telling else { return say!(register_rival, rms) };
        let [x, y, z] = telling.centre_mm.map(|c| fixed(c, 1));
        say!(register_rival_telling, rms, x, y, z, difference = fixed(telling.difference_mm, 2))
    }
}

fn place(of: &[f64; 3]) -> [String; 3] {
    of.map(|c| fixed(c, 1))
}

/// What a scan says of a planned part, a line each.
pub(super) fn scan_lines(scan: &ScanReport) -> Vec<String> {
    let mut lines: Vec<String> =
        scan.findings.iter().map(|f| say!(in_file, file = &*f.file, what = f.finding.sentence())).collect();
    lines.extend(scan.together.iter().map(Sentence::sentence));
    let placed = if scan.is_placed { None } else { Some(scan_not_placed()) };
    if let Some(registration) = &scan.registration {
        lines.extend(how_it_lies(registration));
    }
    lines.extend(scan.patches.iter().map(Sentence::sentence));
    if scan.slack_mm > 0.0 {
        lines.push(say!(scan_slack, slack = fixed(scan.slack_mm, 2)));
    }
    lines.extend(placed);
    lines
}

/// How far a part is off its model, a line each; each patch is one.
pub fn deviation_lines(report: &DeviationReport) -> Vec<String> {
    let mut lines = deviation_summary(report);
    lines.extend(report.patches.iter().map(Sentence::sentence));
    lines
}

/// How far a part is off its model, a line each, without its patches.
pub fn deviation_summary(report: &DeviationReport) -> Vec<String> {
    let [rms, mean] = [report.rms_mm, report.mean_mm].map(|x| fixed(x, 3));
    let mut lines = vec![say!(deviation_points, points = report.points, rms, mean, off = report.points_off_model)];
    if report.unscanned_mm2 > 0.0 {
        lines.push(say!(deviation_unscanned, area = fixed(0.01 * report.unscanned_mm2, 1)));
    }
    if report.patches.is_empty() {
        lines.push(say!(deviation_none, threshold = exact(report.threshold_mm)));
    }
    if report.too_small > 0 {
        lines.push(say!(deviation_too_small, patches = report.too_small));
    }
    lines
}

impl Sentence for WornPatch {
    fn sentence(&self) -> String {
        let [x, y, z] = place(&self.deepest_at);
        let (depth, area, volume) = (fixed(self.depth_mm, 2), fixed(self.area_mm2, 1), fixed(self.volume_mm3, 2));
        let patch = match self.kind {
            "missing" => say!(deviation_missing, depth, x, y, z, area, volume),
            _ => say!(deviation_surplus, depth, x, y, z, area, volume),
        };
        let Some(last) = self.layers.last() else { return patch };
        format!("{patch}; {}", say!(deviation_layers, layers = self.layers.len(), last = fixed(last.height_mm, 3)))
    }
}
