//! What is known of a weld and its grinding: what `weld --json` prints, and key `weld` of `report.json`.

use super::report_rows::{AreaReport, AreaTimes, GroundPassReport, HeldReason};
use super::{UnmeasuredArea, WeldOnPart, area_times};
use crate::cell::hand_eye::HandEye;
use crate::document::Job;
use crate::document::model::RoughnessReading;
use crate::planning::scanned::RegistrationReport;
use crate::progress::{Cancelled, Progress};
use crate::scan::transform_file;
use crate::weld::bead::{AreaKind, WeldSection};
use crate::weld::passes::GrindingPass;
use serde::Serialize;

/// What the images say of a weld, and what its grinding comes to. Lengths mm, part frame.
#[derive(Clone, Debug, Default, Serialize)]
pub struct WeldReport {
    /// Height of the bead above the surface around it where it is highest; 0 where no area has any.
    pub max_height_mm: f64,
    /// Its mean width.
    pub width_mm: f64,
    /// Length of its centre line.
    pub length_mm: f64,
    /// Passes that are left to grind it.
    pub passes: u32,
    /// Its centre line, on the surface that it stands on.
    pub centre_line_mm: Vec<[f64; 3]>,
    /// Times of the strategies, by area and speed (P4 Table 1).
    pub times: Vec<AreaTimes>,
    /// The areas that were found, the greatest first.
    pub areas: Vec<AreaReport>,
    /// Areas of the grey image that could not be measured, and are left alone.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unmeasured: Vec<UnmeasuredArea>,
    /// The passes of the bead that are left.
    pub schedule: Vec<GrindingPass>,
    /// The passes that were ground, with what they took off.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub history: Vec<GroundPassReport>,
    /// Why the next pass is not given out; `None`: it is, or there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub held: Option<HeldReason>,
    /// Standard deviation of the depths around the bead.
    pub noise_mm: f64,
    /// How far the surface around the bead lies off its points, root of the mean square.
    pub parent_rms_mm: f64,
    /// From the camera's frame to the part's, row by row.
    pub part_from_camera: [f64; 16],
    /// How well the skin lies on the part; `None`: the part is what the camera sees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub registration: Option<RegistrationReport>,
    /// How much wider than their margins everything keeps clear, since the part may lie so far off where it was seen.
    pub slack_mm: f64,
    /// Whether it is known where the camera stood, so that the part stands in the cell where it was seen.
    pub is_placed: bool,
    /// How well the poses of the camera's calibration fit; `None`: it was not calibrated here.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hand_eye: Option<HandEyeReport>,
    /// Roughness; `None`: nobody has measured it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness: Option<RoughnessReport>,
}

/// Roughness before and after grinding (P4 Fig. 28), µm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RoughnessReport {
    /// Points that were measured both times.
    pub points: usize,
    /// Mean before.
    pub before_um: f64,
    /// Mean after.
    pub after_um: f64,
    /// By how much it fell, per cent of what it was.
    pub fell_percent: f64,
    /// The roughest point after grinding.
    pub roughest_um: f64,
}

impl WeldReport {
    /// What there is to report of a weld on its part.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(weld: &WeldOnPart, job: &Job, progress: &Progress) -> Result<WeldReport, Cancelled> {
        let WeldOnPart { measured, on, ground, passes, seen_from } = weld;
        let (part, surfaces) = &ground.bare;
        let times = area_times(measured, (part, surfaces), &ground.patches, job, progress)?;
        let areas = measured.areas.iter().zip(&ground.patches).map(|(area, pieces)| AreaReport {
            area: area.kind(),
            surfaces: pieces.iter().map(|piece| piece.surface.0).collect(),
            area_mm2: pieces.iter().map(|piece| piece.area_mm2).sum(),
            aspect: area.seen.aspect,
            max_height_mm: area.bead.as_ref().map_or(0.0, |bead| bead.max_height_mm),
            centre_px: area.seen.centroid_px,
        });
        let report = WeldReport {
            times,
            areas: areas.collect(),
            unmeasured: measured.unmeasured.clone(),
            passes: passes.left.len() as u32,
            schedule: passes.left.clone(),
            history: passes.done.clone(),
            held: passes.held,
            part_from_camera: transform_file::rows(&on.part_from_camera),
            registration: on.registration.as_ref().map(RegistrationReport::new),
            slack_mm: on.slack_mm(),
            is_placed: weld.is_placed(job),
            hand_eye: seen_from.as_ref().and_then(|seen| seen.calibration.as_ref()).map(HandEyeReport::of),
            roughness: RoughnessReport::of(&job.weld.roughness),
            ..WeldReport::default()
        };
        let Some(bead) = measured.bead() else { return Ok(report) };
        let centre = |s: &WeldSection| (on.part_from_camera * s.centre).coords.into();
        Ok(WeldReport {
            max_height_mm: bead.max_height_mm,
            width_mm: bead.width_mm,
            length_mm: bead.length_mm,
            centre_line_mm: bead.sections.iter().map(centre).collect(),
            noise_mm: bead.parent.noise_mm,
            parent_rms_mm: bead.parent.rms_mm,
            ..report
        })
    }

    /// Whether an area stands above the surface around it.
    pub fn has_bead(&self) -> bool {
        self.areas.iter().any(|a| a.area == AreaKind::Bead)
    }
}

/// How well the poses of a hand-eye calibration fit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HandEyeReport {
    /// Distance of the target from where it ought to be, of each pose, mm.
    pub off_mm: Vec<f64>,
    /// Angle between the two, of each pose, degrees.
    pub turned_deg: Vec<f64>,
    /// Whether there are fewer poses than there should be.
    pub few_poses: bool,
}

impl HandEyeReport {
    fn of(found: &HandEye) -> HandEyeReport {
        HandEyeReport {
            off_mm: found.residuals.iter().map(|r| r.off_mm).collect(),
            turned_deg: found.residuals.iter().map(|r| r.turned_deg).collect(),
            few_poses: found.is_of_few_poses(),
        }
    }
}

impl RoughnessReport {
    /// Of the points that were measured before and after; `None`: there are none.
    pub fn of(readings: &[RoughnessReading]) -> Option<RoughnessReport> {
        let both: Vec<(f64, f64)> = readings.iter().filter_map(|r| Some((r.before_um, r.after_um?))).collect();
        let count = both.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| both.iter().map(of).fold(0.0, |a, b| a + b) / count;
        let (before_um, after_um) = (mean(|r| r.0), mean(|r| r.1));
        (!both.is_empty()).then(|| RoughnessReport {
            points: both.len(),
            before_um,
            after_um,
            fell_percent: 100.0 * (before_um - after_um) / before_um.max(f64::MIN_POSITIVE),
            roughest_um: both.iter().map(|r| r.1).fold(0.0, f64::max),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roughness_is_told_of_points_that_were_measured_both_times() {
        let reading = |point, before_um, after_um| RoughnessReading { point, before_um, after_um };
        assert_eq!(RoughnessReport::of(&[reading(1, 3.0, None)]), None);
        let told =
            RoughnessReport::of(&[reading(1, 3.0, Some(0.6)), reading(2, 2.0, Some(0.4)), reading(3, 9.0, None)]);
        let told = told.expect("two points");
        assert_eq!((told.points, told.before_um, told.after_um, told.roughest_um), (2, 2.5, 0.5, 0.6));
        assert!((told.fell_percent - 80.0).abs() < 1e-12);
    }
}
