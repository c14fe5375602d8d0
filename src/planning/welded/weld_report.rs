//! What is known of a weld and its grinding: what `weld --json` prints, and key `weld` of `report.json`.

use super::{GroundWeld, MeasuredWeld, UnmeasuredArea, WeldPart, WeldProgress, area_times};
use crate::cell::hand_eye::HandEye;
use crate::cell::hand_eye::file::CameraStand;
use crate::document::Job;
use crate::document::model::RoughnessReading;
use crate::progress::{Cancelled, Progress};
use crate::scan::transform_file;
use crate::weld::bead::{AreaKind, WeldSection};
use serde::Serialize;

/// What the images say of a weld, and what its grinding comes to. Lengths mm, part frame.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
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
    pub schedule: Vec<PassReport>,
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
    /// How well the poses of the camera's calibration fit; `None`: it was not calibrated here.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hand_eye: Option<HandEyeReport>,
    /// Roughness; `None`: nobody has measured it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roughness: Option<RoughnessReport>,
}

/// An area that is to be ground.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AreaReport {
    /// What it is.
    pub area: AreaKind,
    /// The surfaces that it is ground as; none where it was not chosen.
    pub surfaces: Vec<u32>,
    /// Its area on the surface.
    pub area_mm2: f64,
    /// Length by width of the ellipse with the same spread.
    pub aspect: f64,
    /// Height where it is highest.
    pub max_height_mm: f64,
    /// Column and row of its middle in the image.
    pub centre_px: [f64; 2],
}

/// How long each strategy takes for an area at a speed, s.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AreaTimes {
    /// The area.
    pub area: AreaKind,
    /// Speed on the surface, mm/s.
    pub speed_mm_s: f64,
    /// Lines all in one sense.
    pub one_way_s: f64,
    /// Lines back and forth.
    pub zigzag_s: f64,
    /// A spiral.
    pub spiral_s: f64,
    /// How often each of the three leaves the surface on the way, in that order.
    pub lifts: [u32; 3],
}

/// One pass over a bead.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PassReport {
    /// The height that it grinds down to.
    pub level_mm: f64,
    /// What it takes off where the bead is highest.
    pub infeed_mm: f64,
    /// The area that it grinds: where the bead stands above that height, mm².
    pub area_mm2: f64,
}

/// A pass that was ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct GroundPassReport {
    /// Height before it.
    pub before_mm: f64,
    /// Height that it should have left.
    pub planned_mm: f64,
    /// Height that it left, as measured.
    pub left_mm: f64,
}

/// Why the next pass waits for the operator's word.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "cause", rename_all = "snake_case")]
pub enum HeldReason {
    /// The last pass took off more or less than it should.
    Removal {
        /// What it took off.
        removed_mm: f64,
        /// What it should have.
        planned_mm: f64,
    },
    /// Something was ground below the surface around the bead.
    Below {
        /// By how much.
        below_mm: f64,
    },
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
    /// What there is to report of a measured weld on its part.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(
        measured: &MeasuredWeld,
        (on, ground): (&WeldPart, &GroundWeld),
        (passes, camera): (&WeldProgress, Option<&CameraStand>),
        job: &Job,
        progress: &Progress,
    ) -> Result<WeldReport, Cancelled> {
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
            hand_eye: camera.and_then(|camera| camera.calibration.as_ref()).map(HandEyeReport::of),
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

impl AreaTimes {
    /// The quickest: 0 one-way, 1 zigzag, 2 spiral; of equals the last.
    pub fn quickest(&self) -> usize {
        let all = [self.one_way_s, self.zigzag_s, self.spiral_s];
        (0..3).fold(2, |best, i| if all[i] < all[best] { i } else { best })
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

    #[test]
    fn the_quickest_of_equals_is_the_spiral() {
        let times = |one_way_s, zigzag_s, spiral_s| AreaTimes {
            area: AreaKind::Flat,
            speed_mm_s: 50.0,
            one_way_s,
            zigzag_s,
            spiral_s,
            lifts: [0; 3],
        };
        assert_eq!(times(9.0, 5.0, 4.0).quickest(), 2);
        assert_eq!(times(9.0, 3.0, 4.0).quickest(), 1);
        assert_eq!(times(4.0, 4.0, 4.0).quickest(), 2);
    }
}
