//! What of a job's tables a result can depend on. A field that is added to one of them does not compile
//! until it is said here whether it counts.

use super::model::{BeadParameters, BeamParameters, CellFile, Layers, Offset, PathParameters};
use super::recipe::Recipe;
use super::start_from::StartFrom;
use crate::part::{Hasher, Keyed, keyed};

keyed!(Layers {
    strategy,
    direction,
    spacing_mm,
    offset_mm,
    order,
    passes,
    inset_mm,
    ignore_holes_mm,
    join_mm,
    shortest_mm,
    seam_shift_mm,
    cross_deg,
    border,
    centre_mm,
    inward,
});

keyed!(BeamParameters { defocus_mm, power_w, spot_mm, speed_mm_s, frequency_khz, air_speed_mm_s, head, margin_mm });

keyed!(PathParameters {
    chord_error_mm,
    max_step_mm,
    max_turn_deg,
    axis,
    correction,
    max_tilt_deg,
    tilt_rate_deg_mm,
    tilt_rate_deg_s,
    standoff_mm,
    lead_in_mm,
    lead_out_mm,
});

keyed!(BeadParameters { width_mm, height_mm, layers, start_shift_mm, alternate });

keyed!(CellFile { file, robot, mount, dialect, spin, deviation_mm, flange_from_part, base_from_laser, base_from_part });

// What a recipe is good for changes nothing.
keyed!(Recipe { name, strategy, direction, order, border, centre_mm, inward, values; note });

impl Keyed for Offset {
    fn feed(&self, into: &mut Hasher) {
        match self {
            Offset::Centred => "centred".feed(into),
            Offset::FromLowest(mm) => mm.feed(into),
        }
    }
}

impl Keyed for StartFrom {
    fn feed(&self, into: &mut Hasher) {
        match self {
            StartFrom::Whole => "whole".feed(into),
            StartFrom::Border(border) => border.feed(into),
        }
    }
}
