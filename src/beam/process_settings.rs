//! The process settings of a pass: where the focus stands, how wide, how fast and how strong the spot is; or how a
//! contact tool stands and how hard it presses.
//!
//! Values alone; the job says which surface is made with which.

use super::Optics;

/// What works on the part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WorkingMedium {
    /// The light of a laser.
    #[default]
    Light,
    /// A grinding disc.
    Disc,
    /// A grinding belt.
    Belt,
}

/// The settings that a pass is made with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProcessSettings {
    /// D: the focus stands at `p + D·a`, mm. Of a contact tool: from the foot of its axis to its reference point.
    pub defocus_mm: f64,
    /// Diameter of the spot on the part, mm.
    pub spot_mm: f64,
    /// Speed of the spot on the part, mm/s.
    pub speed_mm_s: f64,
    /// Power, W.
    pub power_w: f64,
    /// Frequency of its pulses, kHz; 0: without pulses, or as it is set at the laser.
    pub frequency_khz: f64,
    /// Length of the run-up along the line, at that speed, before the laser is switched on, mm.
    pub lead_in_mm: f64,
    /// Length by which the spot runs on beyond the line's end, mm.
    pub lead_out_mm: f64,
    /// Radius of the quarter arcs by which a contact tool comes to a line and leaves it, mm; 0: none.
    pub arc_mm: f64,
    /// How fast the foot of a contact tool's axis may go, mm/s: where a line bends tightly it swings around the contact, which
    /// goes slower there. 0: no bound, as with light.
    pub axis_speed_mm_s: f64,
    /// Force of a contact tool against the part, N; 0: none is kept.
    pub force_n: f64,
    /// What works: light, or what grinds.
    pub medium: WorkingMedium,
    /// Layer of a build-up, from 0: the part has grown by those before.
    pub layer: u32,
}

impl Default for ProcessSettings {
    /// P1 Table 1.
    fn default() -> Self {
        ProcessSettings {
            defocus_mm: 20.0,
            spot_mm: 1.0,
            speed_mm_s: 3.0,
            power_w: 500.0,
            frequency_khz: 0.0,
            lead_in_mm: 0.0,
            lead_out_mm: 0.0,
            arc_mm: 0.0,
            axis_speed_mm_s: 0.0,
            force_n: 0.0,
            medium: WorkingMedium::Light,
            layer: 0,
        }
    }
}

impl ProcessSettings {
    /// The settings with the head drawn back along the beam by `lift_mm` (pushed forward where negative): the
    /// spot gets as wide as the optics make it, in proportion.
    pub fn lifted(&self, optics: &Optics, lift_mm: f64) -> ProcessSettings {
        let defocus_mm = self.defocus_mm + lift_mm;
        let wider = optics.spot_mm(defocus_mm) / optics.spot_mm(self.defocus_mm);
        ProcessSettings { defocus_mm, spot_mm: self.spot_mm * wider, ..*self }
    }
}
