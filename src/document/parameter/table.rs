//! The rows, in the order of the reference and of the options; those of a group are in the order of the panel. A row
//! more is a parameter more: beside it there is only its field in the model, and its words in
//! `assets/text/*/parameters.ftl`.

use super::kind::NumberKind::{
    self, Acceleration, Angle, Area, Count, Factor, Fluence, Force, Frequency, Length, Pixels, Power, Share, Speed,
    TurnPerLength, TurnRate, Wavelength,
};
use super::place::{Affects, Group, Scope};
use super::{Limits, Parameter};
use crate::beam::Optics;
use crate::part::Placement;
use crate::process::DoseParameters;

/// All parameters.
pub const PARAMETERS: &[Parameter] = &[
    surfaces("surfaces.angle_deg", Angle, above(0.0, 180.0), 20.0, Group::Crease).option("angle").symbol("α (P1)"),
    surfaces("surfaces.min_area_mm2", Area, from(0.0, 1e6), 0.0, Group::Islands),
    surfaces("surfaces.hysteresis_deg", Angle, from(0.0, 180.0), 0.0, Group::Islands),
    plan("layers.spacing_mm", Length, above(0.0, 1000.0), 0.5, Group::Spacing)
        .first_in_recipes()
        .option("spacing")
        .symbol("d (P2)"),
    plan("layers.cross_deg", Angle, from(1.0, 179.0), 90.0, Group::Cross).first_in_recipes(),
    plan("layers.inset_mm", Length, from(-100.0, 1000.0), 0.0, Group::Rim).in_recipes().option("inset"),
    plan("layers.ignore_holes_mm", Length, from(0.0, 10000.0), 0.0, Group::Rim).in_recipes(),
    plan("layers.join_mm", Length, from(0.0, 10000.0), 0.0, Group::Rim).in_recipes(),
    plan("layers.shortest_mm", Length, from(0.0, 10000.0), 0.0, Group::Rim).in_recipes(),
    plan("layers.seam_shift_mm", Length, from(0.0, 10000.0), 0.0, Group::Rim).in_recipes(),
    plan("layers.passes", Count, from(1.0, 1000.0), 1.0, Group::Rim).in_recipes().option("passes"),
    plan("bead.width_mm", Length, from(0.0, 100.0), 0.0, Group::BeadSize).in_recipes().symbol("ω (P3)"),
    plan("bead.height_mm", Length, from(0.0, 100.0), 0.0, Group::BeadSize).in_recipes().symbol("h (P3)"),
    plan("bead.layers", Count, from(1.0, 1000.0), 1.0, Group::BeadLayers).in_recipes(),
    plan("bead.start_shift_mm", Length, from(0.0, 10000.0), 0.0, Group::BeadLayers).in_recipes(),
    setup("beam.defocus_mm", Length, from(-500.0, 500.0), 20.0, Group::Beam)
        .first_in_recipes()
        .option("defocus")
        .symbol("D (P1)"),
    plan("path.chord_error_mm", Length, above(0.0, 10.0), 0.02, Group::Targets)
        .in_recipes()
        .option("chord-error")
        .symbol("dε (P2)"),
    plan("path.max_step_mm", Length, above(0.0, 100_000.0), 5.0, Group::Targets).in_recipes().option("max-step"),
    plan("path.max_turn_deg", Angle, from(0.1, 180.0), 5.0, Group::Targets).in_recipes().option("max-turn"),
    setup("beam.speed_mm_s", Speed, above(0.0, 10000.0), 3.0, Group::Beam)
        .first_in_recipes()
        .option("speed")
        .symbol("v (P1)"),
    setup("beam.air_speed_mm_s", Speed, above(0.0, 10000.0), 100.0, Group::Beam).option("air-speed"),
    setup("beam.power_w", Power, from(0.0, 100_000.0), 500.0, Group::Beam)
        .first_in_recipes()
        .option("power")
        .symbol("P (P1)"),
    setup("beam.frequency_khz", Frequency, from(0.0, 100_000.0), 0.0, Group::Beam).in_recipes(),
    setup("beam.spot_mm", Length, above(0.0, 100.0), 1.0, Group::Beam).first_in_recipes().option("spot"),
    plan("path.max_tilt_deg", Angle, from(0.0, 75.0), 45.0, Group::Tilt).in_recipes().option("max-tilt"),
    setup("beam.margin_mm", Length, from(0.0, 50.0), 0.5, Group::Head).option("margin"),
    plan("path.standoff_mm", Length, from(0.0, 100.0), 0.0, Group::Head).in_recipes(),
    plan("path.tilt_rate_deg_mm", TurnPerLength, above(0.0, 1000.0), 5.0, Group::TiltRates).in_recipes(),
    plan("path.tilt_rate_deg_s", TurnRate, above(0.0, 10000.0), 90.0, Group::TiltRates),
    optics("optics.lens_to_focus_mm", Length, from(1.0, 5000.0), Optics::DEFAULT.lens_to_focus_mm),
    optics("optics.aperture_mm", Length, from(0.1, 500.0), Optics::DEFAULT.aperture_mm),
    optics("optics.focus_spot_mm", Length, from(0.001, 50.0), Optics::DEFAULT.focus_spot_mm).symbol("d0"),
    optics("optics.rayleigh_mm", Length, from(0.001, 10000.0), Optics::DEFAULT.rayleigh_mm).symbol("zR"),
    optics("optics.wavelength_nm", Wavelength, from(100.0, 20000.0), Optics::DEFAULT.wavelength_nm).symbol("λ"),
    plan("path.lead_in_mm", Length, from(0.0, 1000.0), 0.0, Group::Targets).in_recipes(),
    plan("path.lead_out_mm", Length, from(0.0, 1000.0), 0.0, Group::Targets).in_recipes(),
    scan("scan.min_depth_mm", above(0.0, 100.0), 0.05).option("min-depth"),
    scan("scan.tolerance_mm", above(0.0, 100.0), 0.1),
    scan("scan.gate_mm", from(0.0, 1000.0), 5.0).option("gate"),
    weld("weld.even_light_px", Pixels, from(0.0, 10_000.0), 248.0, Group::WeldMask),
    weld("weld.smoothing_px", Pixels, from(0.0, 100.0), 1.2, Group::WeldMask),
    weld("weld.sigmas", Factor, from(0.0, 1000.0), 4.0, Group::WeldMask).symbol("k"),
    weld("weld.opening_px", Pixels, from(0.0, 1000.0), 5.0, Group::WeldMask),
    weld("weld.closing_px", Pixels, from(0.0, 1000.0), 9.0, Group::WeldMask),
    weld("weld.least_area_px", Pixels, from(0.0, 1e9), 200.0, Group::WeldMask),
    weld("weld.pass_depth_mm", Length, above(0.0, 100.0), 0.5, Group::WeldPasses),
    weld("weld.at_once", Count, from(1.0, 1000.0), 1.0, Group::WeldPasses),
    weld("weld.residual_mm", Length, from(0.0, 100.0), 0.0, Group::WeldPasses),
    weld("weld.below_mm", Length, above(0.0, 10.0), 0.2, Group::WeldPasses),
    weld("weld.removal_share", Share, above(0.0, 1000.0), 30.0, Group::WeldPasses),
    setup("weld.lead_deg", Angle, above(0.0, 30.0), 10.0, Group::Grinding).symbol("τ"),
    setup("weld.arc_mm", Length, from(0.0, 1000.0), 10.0, Group::Grinding),
    setup("weld.force_n", Force, from(0.0, 10_000.0), 15.0, Group::Grinding),
    setup("weld.gouge_mm", Length, above(0.0, 10.0), 0.05, Group::Grinding),
    plan("weld.acceleration_mm_s2", Acceleration, above(0.0, 1e6), 500.0, Group::Grinding),
    part("part.placement.scale", Factor, above(0.0, 100_000.0), Placement::DEFAULT.scale),
    dose("dose.line_mm", Length, above(0.0, 500.0), DoseParameters::DEFAULT.line_mm, Group::ScannedLine),
    dose("dose.low_j_cm2", Fluence, from(0.0, 1e9), DoseParameters::DEFAULT.low_j_cm2, Group::Dose),
    dose("dose.high_j_cm2", Fluence, from(0.0, 1e9), DoseParameters::DEFAULT.high_j_cm2, Group::Dose),
    dose("dose.collateral_j_cm2", Fluence, from(0.0, 1e9), DoseParameters::DEFAULT.collateral_j_cm2, Group::Dose),
    setup("cell.deviation_mm", Length, above(0.0, 10.0), 0.1, Group::Cell),
];

const fn row(
    key: &'static str,
    kind: NumberKind,
    limits: Limits,
    default: f64,
    group: Group,
    affects: Affects,
) -> Parameter {
    Parameter { key, kind, limits, default, group, scope: Scope::Program, affects, option: None, symbol: "" }
}

const fn part(key: &'static str, kind: NumberKind, limits: Limits, default: f64) -> Parameter {
    row(key, kind, limits, default, Group::Part, Affects::Part)
}

const fn scan(key: &'static str, limits: Limits, default: f64) -> Parameter {
    row(key, Length, limits, default, Group::Scan, Affects::Scan)
}

const fn weld(key: &'static str, kind: NumberKind, limits: Limits, default: f64, group: Group) -> Parameter {
    row(key, kind, limits, default, group, Affects::Weld)
}

const fn surfaces(key: &'static str, kind: NumberKind, limits: Limits, default: f64, group: Group) -> Parameter {
    row(key, kind, limits, default, group, Affects::Surfaces)
}

const fn setup(key: &'static str, kind: NumberKind, limits: Limits, default: f64, group: Group) -> Parameter {
    row(key, kind, limits, default, group, Affects::Setup)
}

const fn optics(key: &'static str, kind: NumberKind, limits: Limits, default: f64) -> Parameter {
    setup(key, kind, limits, default, Group::Optics)
}

const fn plan(key: &'static str, kind: NumberKind, limits: Limits, default: f64, group: Group) -> Parameter {
    row(key, kind, limits, default, group, Affects::Plan)
}

const fn dose(key: &'static str, kind: NumberKind, limits: Limits, default: f64, group: Group) -> Parameter {
    row(key, kind, limits, default, group, Affects::Dose)
}

impl Parameter {
    const fn in_recipes(self) -> Parameter {
        Parameter { scope: Scope::Surface, ..self }
    }

    const fn first_in_recipes(self) -> Parameter {
        Parameter { scope: Scope::SurfaceFirst, ..self }
    }

    const fn option(self, option: &'static str) -> Parameter {
        Parameter { option: Some(option), ..self }
    }

    const fn symbol(self, symbol: &'static str) -> Parameter {
        Parameter { symbol, ..self }
    }
}

const fn from(least: f64, greatest: f64) -> Limits {
    Limits { least, greatest, is_above_least: false }
}

const fn above(least: f64, greatest: f64) -> Limits {
    Limits { least, greatest, is_above_least: true }
}
