//! The report in a few lines for people.

use super::{OrderReport, Report};
use crate::text::Sentence as _;

impl Report {
    /// What the robot refuses: cause, how many targets, and the first of them in words.
    pub fn refused(&self) -> Vec<(&'static str, usize, String)> {
        let mut out: Vec<(&'static str, usize, String)> = Vec::new();
        for p in &self.problems {
            let (Some(why), Some(pass), Some(point)) = (&p.why, p.pass, p.point) else { continue };
            match out.iter_mut().find(|(cause, ..)| *cause == p.cause) {
                Some((_, count, _)) => *count += 1,
                None => out.push((p.cause, 1, format!("pass {pass}, point {point}: {}", why.sentence()))),
            }
        }
        out
    }

    /// A few lines for people.
    pub fn text(&self) -> String {
        use std::fmt::Write as _;
        let mut out = String::new();
        for finding in &self.findings {
            let _ = writeln!(out, "{}", finding.text());
        }
        let _ = writeln!(
            out,
            "{} passes, {} targets: {} free, {} corrected, {} blocked",
            self.passes,
            self.points,
            self.points - self.corrected - self.blocked,
            self.corrected,
            self.blocked
        );
        let _ = writeln!(
            out,
            "{:.1} mm with the laser on, {:.1} mm blocked, {:.1} mm in the air, {}",
            self.work_mm,
            self.blocked_mm,
            self.air_mm,
            hours(self.time_s)
        );
        let _ = writeln!(
            out,
            "largest tilt {:.1}°, chord error {:.4} mm, spacing on the surface up to {:.3} mm",
            self.max_tilt_deg, self.max_chord_error_mm, self.max_surface_spacing_mm
        );
        if self.layers > 1 {
            let _ =
                writeln!(out, "{} layers, each planned and proven on the part as those before make it", self.layers);
        }
        if !self.splits.is_empty() {
            let _ = writeln!(out, "{} splits: laser off while the beam turns, a wall between", self.splits.len());
        }
        if self.order.way_mm < self.order.zigzag_way_mm {
            let OrderReport { zigzag_way_mm, way_mm } = self.order;
            let _ = writeln!(out, "{way_mm:.1} mm of way between the lines, {zigzag_way_mm:.1} mm in a zigzag");
        }
        for (s, remark) in self.surfaces.iter().flat_map(|s| s.remarks.iter().map(move |r| (s, r))) {
            let _ = writeln!(out, "surface {}: {remark}", s.surface);
        }
        for s in self.surfaces.iter().filter(|s| s.missed_area_mm2 > 0.0) {
            let _ = writeln!(
                out,
                "surface {}: {:.2} of {:.2} mm² missed by the planes; another direction would reach it",
                s.surface, s.missed_area_mm2, s.area_mm2
            );
        }
        for (cause, count, example) in self.refused() {
            let _ = writeln!(out, "{count} targets refused ({cause}), such as {example}");
        }
        if let Some(dose) = &self.dose {
            out.push_str(&dose.text());
        }
        for s in self.surfaces.iter().filter(|s| s.blocked_mm > 0.0) {
            let _ = writeln!(
                out,
                "surface {}: {:.1} mm of {:.1} mm blocked",
                s.surface,
                s.blocked_mm,
                s.blocked_mm + s.work_mm
            );
        }
        out
    }
}

/// A time as hours, minutes and seconds.
pub fn hours(s: f64) -> String {
    format!("{}:{:02}:{:02}", s as u64 / 3600, s as u64 / 60 % 60, s as u64 % 60)
}
