//! What is known of a weld and its grinding: what `weld --json` prints, and key `weld` of `report.json`.

use crate::weld::bead::AreaKind;
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
    /// The passes of the bead.
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
impl WeldReport {
    pub fn new(
        _: &super::MeasuredWeld,
        _: (&super::WeldPart, &super::GroundWeld),
        _: &super::WeldProgress,
        _: &crate::document::Job,
        _: &crate::progress::Progress,
    ) -> Result<WeldReport, super::WeldError> {
        Ok(WeldReport::default())
    }
}
