//! One table of all numeric parameters: it makes the panel, the command line's options and help,
//! the validation, and the README's table.

use super::model::Job;
use crate::program::dialects;

/// One number that an operator sets.
pub struct Parameter {
    /// Its option without the dashes; `None` for what only jobs and the window set.
    pub option: Option<&'static str>,
    /// Key in the job file, `table.key`.
    pub key: &'static str,
    /// Label in the window.
    pub label: &'static str,
    /// Unit, as printed.
    pub unit: &'static str,
    /// Least and greatest value.
    pub range: (f64, f64),
    /// Whether the least value itself is allowed.
    pub least_allowed: bool,
    /// Whether another value cuts the surfaces of the part anew, so that their numbers mean other ones.
    pub recuts: bool,
    /// What it means, and what it does.
    pub meaning: &'static str,
    /// Symbol in the papers, where it has one.
    pub symbol: &'static str,
    /// Reads it.
    pub get: fn(&Job) -> f64,
    /// Writes it.
    pub set: fn(&mut Job, f64),
}

macro_rules! parameter {
    ($option:expr, $key:literal, $label:literal, $unit:literal, $from:literal $open:tt $to:literal,
     $symbol:literal, $meaning:literal, $($field:ident).+) => {
        Parameter {
            option: $option,
            key: $key,
            label: $label,
            unit: $unit,
            range: ($from, $to),
            least_allowed: parameter!(@ $open),
            recuts: parameter!(? $($field).+),
            meaning: $meaning,
            symbol: $symbol,
            get: |job| job.$($field).+,
            set: |job, value| job.$($field).+ = value,
        }
    };
    // All numbers of this table are about how facets become surfaces.
    (? surfaces.$field:ident) => { true };
    (? $($field:ident).+) => { false };
    (@ <) => { false };
    (@ ..) => { true };
}

/// The table, in the order of the panel. `a .. b`: from a to b; `a < b`: above a, to b.
pub const PARAMETERS: [Parameter; 42] = [
    parameter!(
        Some("angle"),
        "surfaces.angle_deg",
        "Crease angle",
        "°",
        0.0 < 180.0,
        "α (P1)",
        "Edges with at least this angle between their facets divide feature surfaces",
        surfaces.angle_deg
    ),
    parameter!(
        None,
        "surfaces.min_area_mm2",
        "Absorb islands below",
        "mm²",
        0.0..1e6,
        "",
        "Smaller surfaces join the neighbour with the smoothest border; 0 = off",
        surfaces.min_area_mm2
    ),
    parameter!(
        None,
        "surfaces.hysteresis_deg",
        "Hysteresis",
        "°",
        0.0..180.0,
        "",
        "Edges from this angle on are creases too where they continue one; 0 = off",
        surfaces.hysteresis_deg
    ),
    parameter!(
        Some("spacing"),
        "layers.spacing_mm",
        "Spacing",
        "mm",
        0.0 < 1000.0,
        "d (P2)",
        "Distance between section planes; on a slope the lines lie further apart",
        layers.spacing_mm
    ),
    parameter!(
        Some("passes"),
        "layers.passes",
        "Passes",
        "",
        1.0..1000.0,
        "",
        "How often a surface is gone over; a whole number",
        layers.passes
    ),
    parameter!(
        Some("inset"),
        "layers.inset_mm",
        "Inset",
        "mm",
        -100.0..1000.0,
        "",
        "What lines keep from the rim of the surface; negative: how far they run on over it, as long as the part goes on",
        layers.inset_mm
    ),
    parameter!(
        None,
        "layers.ignore_holes_mm",
        "Holes that count",
        "mm",
        0.0..10000.0,
        "",
        "Narrower holes keep no lines off, whatever the inset",
        layers.ignore_holes_mm
    ),
    parameter!(
        None,
        "layers.join_mm",
        "Bridge gaps up to",
        "mm",
        0.0..10000.0,
        "",
        "Pieces of a line with no more than this between them are one pass, the laser off over the gap; 0 = off",
        layers.join_mm
    ),
    parameter!(
        None,
        "layers.shortest_mm",
        "Leave out below",
        "mm",
        0.0..10000.0,
        "",
        "Shorter pieces of lines are left out; 0 = none",
        layers.shortest_mm
    ),
    parameter!(
        None,
        "layers.seam_shift_mm",
        "Shift starts by",
        "mm",
        0.0..10000.0,
        "",
        "How far each closed line begins behind the start of the one before; 0 = begin where the way is shortest",
        layers.seam_shift_mm
    ),
    parameter!(
        None,
        "layers.cross_deg",
        "Cross angle",
        "°",
        1.0..179.0,
        "",
        "Angle between the two rasters of the strategy cross",
        layers.cross_deg
    ),
    parameter!(
        Some("defocus"),
        "beam.defocus_mm",
        "Defocus distance",
        "mm",
        -500.0..500.0,
        "D (P1)",
        "How far the focus stands above the surface, along the beam",
        beam.defocus_mm
    ),
    parameter!(
        Some("chord-error"),
        "path.chord_error_mm",
        "Chord error",
        "mm",
        0.0 < 10.0,
        "dε (P2)",
        "How far the surface may lie from the straight move between two targets",
        path.chord_error_mm
    ),
    parameter!(
        Some("max-step"),
        "path.max_step_mm",
        "Longest step",
        "mm",
        0.0 < 100000.0,
        "",
        "Longest move between two targets",
        path.max_step_mm
    ),
    parameter!(
        Some("max-turn"),
        "path.max_turn_deg",
        "Largest turn",
        "°",
        0.1..180.0,
        "",
        "Largest turn of the surface normal between two targets",
        path.max_turn_deg
    ),
    parameter!(
        Some("speed"),
        "beam.speed_mm_s",
        "Speed",
        "mm/s",
        0.0 < 10000.0,
        "v (P1)",
        "Speed of the spot on the part",
        beam.speed_mm_s
    ),
    parameter!(
        Some("air-speed"),
        "beam.air_speed_mm_s",
        "Air speed",
        "mm/s",
        0.0 < 10000.0,
        "",
        "Speed of the focus with the laser off",
        beam.air_speed_mm_s
    ),
    parameter!(
        Some("power"),
        "beam.power_w",
        "Power",
        "W",
        0.0..100000.0,
        "P (P1)",
        "Laser power; stated in the program's head, and set by an output if the cell has one for it",
        beam.power_w
    ),
    parameter!(
        None,
        "beam.frequency_khz",
        "Pulse frequency",
        "kHz",
        0.0..100000.0,
        "",
        "Frequency of the laser's pulses, stated and set as the power is; 0 = none, or as it is set at the laser",
        beam.frequency_khz
    ),
    parameter!(
        Some("spot"),
        "beam.spot_mm",
        "Spot diameter",
        "mm",
        0.0 < 100.0,
        "",
        "Diameter of the spot on the part",
        beam.spot_mm
    ),
    parameter!(
        Some("margin"),
        "beam.margin_mm",
        "Margin",
        "mm",
        0.0..50.0,
        "",
        "What cone and head keep from everything; it counts once a head is given",
        beam.margin_mm
    ),
    parameter!(
        Some("max-tilt"),
        "path.max_tilt_deg",
        "Greatest tilt",
        "°",
        0.0..75.0,
        "",
        "Greatest angle between beam and normal that the search for clearance may take, and that is planned with a head",
        path.max_tilt_deg
    ),
    parameter!(
        None,
        "path.tilt_rate_deg_mm",
        "Tilt rate",
        "°/mm",
        0.0 < 1000.0,
        "",
        "How fast the search for clearance may turn the beam against the normal along the line",
        path.tilt_rate_deg_mm
    ),
    parameter!(
        None,
        "path.tilt_rate_deg_s",
        "Tilt speed",
        "°/s",
        0.0 < 10000.0,
        "",
        "The same over time, at the spot's speed",
        path.tilt_rate_deg_s
    ),
    parameter!(
        None,
        "path.standoff_mm",
        "Standoff window",
        "mm",
        0.0..100.0,
        "",
        "How far the head may be drawn back or pushed forward on lines that are blocked otherwise; 0 = not at all",
        path.standoff_mm
    ),
    parameter!(
        None,
        "path.lead_in_mm",
        "Lead-in",
        "mm",
        0.0..1000.0,
        "",
        "The spot comes so far along the line with the laser off, so that it has its speed when the laser goes on",
        path.lead_in_mm
    ),
    parameter!(
        None,
        "path.lead_out_mm",
        "Lead-out",
        "mm",
        0.0..1000.0,
        "",
        "The spot goes on so far behind the end with the laser off, at the speed of the work",
        path.lead_out_mm
    ),
    parameter!(
        None,
        "optics.lens_to_focus_mm",
        "Lens to focus",
        "mm",
        1.0..5000.0,
        "",
        "From the last glass to the focus; the beam's cone ends there",
        optics.lens_to_focus_mm
    ),
    parameter!(
        None,
        "optics.aperture_mm",
        "Aperture",
        "mm",
        0.1..500.0,
        "",
        "Diameter of the beam at the last glass",
        optics.aperture_mm
    ),
    parameter!(
        None,
        "optics.focus_spot_mm",
        "Spot at the focus",
        "mm",
        0.001..50.0,
        "d0",
        "Diameter of the beam at its focus",
        optics.focus_spot_mm
    ),
    parameter!(
        None,
        "optics.rayleigh_mm",
        "Rayleigh length",
        "mm",
        0.001..10000.0,
        "zR",
        "Distance from the focus at which the spot is 1.41 times as wide",
        optics.rayleigh_mm
    ),
    parameter!(
        None,
        "optics.wavelength_nm",
        "Wavelength",
        "nm",
        100.0..20000.0,
        "λ",
        "Of the laser; it enters the beam quality M² alone",
        optics.wavelength_nm
    ),
    parameter!(
        None,
        "bead.width_mm",
        "Bead width",
        "mm",
        0.0..100.0,
        "ω (P3)",
        "Width of a clad bead at its foot; 0 = nothing is laid",
        bead.width_mm
    ),
    parameter!(
        None,
        "bead.height_mm",
        "Bead height",
        "mm",
        0.0..100.0,
        "h (P3)",
        "Height of a clad bead, and of a layer; 0 = nothing is laid",
        bead.height_mm
    ),
    parameter!(
        None,
        "bead.layers",
        "Layers",
        "",
        1.0..1000.0,
        "",
        "Layers on top of each other, each planned on the part as it has grown; a whole number",
        bead.layers
    ),
    parameter!(
        None,
        "bead.start_shift_mm",
        "Shift layers by",
        "mm",
        0.0..10000.0,
        "",
        "How far closed lines begin behind their start in the layer before",
        bead.start_shift_mm
    ),
    parameter!(
        None,
        "dose.line_mm",
        "Scanned width",
        "mm",
        0.0 < 500.0,
        "",
        "Width of a scanned line across the travel direction; it counts with the profile line",
        dose.line_mm
    ),
    parameter!(
        None,
        "dose.low_j_cm2",
        "Least dose",
        "J/cm²",
        0.0..1e9,
        "",
        "Less leaves the surface unclean; 0 = half of P/(v·d)",
        dose.low_j_cm2
    ),
    parameter!(
        None,
        "dose.high_j_cm2",
        "Greatest dose",
        "J/cm²",
        0.0..1e9,
        "",
        "More harms the surface; 0 = twice P/(v·d)",
        dose.high_j_cm2
    ),
    parameter!(
        None,
        "dose.collateral_j_cm2",
        "Collateral dose",
        "J/cm²",
        0.0..1e9,
        "",
        "Surfaces that were not chosen may get so much; 0 = a tenth of P/(v·d)",
        dose.collateral_j_cm2
    ),
    parameter!(
        None,
        "cell.deviation_mm",
        "Deviation of the spot",
        "mm",
        0.0 < 10.0,
        "",
        "How far the spot may leave its line where the flange moves straight; targets are put in between",
        cell.deviation_mm
    ),
    parameter!(
        None,
        "part.placement.scale",
        "Scale",
        "",
        0.0 < 100000.0,
        "",
        "Factor on the part, on top of its unit",
        part.placement.scale
    ),
];

impl Parameter {
    /// The parameter of that option.
    pub fn by_option(option: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|p| p.option == Some(option))
    }

    /// The parameter of that key in the job file.
    pub fn by_key(key: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|p| p.key == key)
    }

    /// Its default.
    pub fn default(&self) -> f64 {
        (self.get)(&Job::default())
    }

    /// Why a value cannot be taken, as a sentence.
    ///
    /// # Errors
    /// What the value may be.
    pub fn check(&self, value: f64) -> Result<(), String> {
        let (low, high) = self.range;
        let good = value <= high && if self.least_allowed { value >= low } else { value > low };
        if good {
            return Ok(());
        }
        let from = if self.least_allowed { "from" } else { "above" };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        Err(format!("{} = {value}: give a number {from} {low} to {high}{unit}", self.option.unwrap_or(self.key)))
    }
}

/// Checks every number of a job.
///
/// # Errors
/// The first that is out of range.
pub fn check_all(job: &Job) -> Result<(), String> {
    PARAMETERS.iter().try_for_each(|p| p.check((p.get)(job)))?;
    job.check_recipes()?;
    super::bead::check(job)?;
    if job.layers.passes.fract() != 0.0 {
        return Err(format!("passes = {}: give a whole number", job.layers.passes));
    }
    dialects::known(&job.cell.dialect)
        .map_err(|e| format!("dialect = {:?}: give one of {}", e.0, dialects::names()))?;
    if let Some(offset) = job.layers.offset_mm.mm()
        && !(0.0..=job.layers.spacing_mm).contains(&offset)
    {
        return Err(format!(
            "offset = {offset}: give a number from 0 to the spacing ({} mm), or centred; a wider strip at the rim would stay uncleaned",
            job.layers.spacing_mm
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_sound() {
        for p in &PARAMETERS {
            assert!(p.check(p.default()).is_ok(), "{}", p.key);
            assert!(p.check(f64::NAN).is_err() && p.check(p.range.1 * 2.0 + 1.0).is_err(), "{}", p.key);
            let mut job = Job::default();
            (p.set)(&mut job, p.range.1);
            assert_eq!((p.get)(&job), p.range.1, "{} reads what was written", p.key);
            let text = toml::to_string(&job).expect("writes");
            let value: toml::Table = text.parse().expect("reads");
            let found = p.key.split('.').try_fold(toml::Value::Table(value), |v, k| v.get(k).cloned());
            assert_eq!(found.and_then(|v| v.as_float()), Some(p.range.1), "{} is its place in the file", p.key);
        }
    }

    #[test]
    fn zero_and_negative_spacing_are_refused_with_a_reason() {
        let p = Parameter::by_option("spacing").expect("there");
        assert_eq!(p.check(0.0), Err("spacing = 0: give a number above 0 to 1000 mm".into()));
        assert!(p.check(-1.0).is_err());
    }
}
