//! The `[ur]` table of a cell file.

use super::templates::check_force;
use crate::cell::check::{FigureError, Letters, name, ranges};
use serde::{Deserialize, Serialize};

/// What the program needs; words that sources disagree on are templates.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Ur {
    /// Name of the program's function and of its file.
    pub program: String,
    /// Moves in one function; longer programs call several.
    pub max_moves: u32,
    /// Full speed of the joints: 100 %.
    pub full_speed_deg_s: f64,
    /// Full speed of a straight move: 100 %.
    pub full_speed_mm_s: f64,
    /// Acceleration of joint moves.
    pub acceleration_deg_s2: f64,
    /// Acceleration of straight moves.
    pub acceleration_mm_s2: f64,
    /// Targets between two lit moves are rounded by this much at most; 0: the arm stops at each.
    pub blend_mm: f64,
    /// Statement that switches output `{n}` on.
    pub output_on: String,
    /// Statement that switches it off.
    pub output_off: String,
    /// Statement that sets analogue output `{n}` to `{v}`.
    pub analogue: String,
    /// Statement that sets the whole number `{n}` to `{v}`.
    pub group: String,
    /// Statement that makes a contact tool press with `{f}` newtons from there on; empty: that is a comment.
    pub force_on: String,
    /// Statement that ends it.
    pub force_off: String,
    /// Ends lines with CR LF.
    pub crlf: bool,
}

impl Default for Ur {
    fn default() -> Self {
        Ur {
            program: "Clean".into(),
            max_moves: 1000,
            full_speed_deg_s: 180.0,
            full_speed_mm_s: 1000.0,
            acceleration_deg_s2: 80.0,
            acceleration_mm_s2: 1200.0,
            blend_mm: 0.5,
            output_on: "set_standard_digital_out({n}, True)".into(),
            output_off: "set_standard_digital_out({n}, False)".into(),
            analogue: "set_standard_analog_out({n}, {v})".into(),
            group: "write_output_integer_register({n}, {v})".into(),
            force_on:
                "force_mode(tool_pose(), [0, 0, 1, 0, 0, 0], [0, 0, {f}, 0, 0, 0], 2, [0.1, 0.1, 0.05, 0.2, 0.2, 0.2])"
                    .into(),
            force_off: "end_force_mode()".into(),
            crlf: false,
        }
    }
}

impl Ur {
    /// Whether the controller can take all of it.
    ///
    /// # Errors
    /// The first that it cannot.
    pub fn check(&self) -> Result<(), FigureError> {
        ranges(&[
            ("ur.max_moves", f64::from(self.max_moves), 10.0, 1e6),
            ("ur.full_speed_deg_s", self.full_speed_deg_s, 1.0, 1000.0),
            ("ur.full_speed_mm_s", self.full_speed_mm_s, 1.0, 10000.0),
            ("ur.acceleration_deg_s2", self.acceleration_deg_s2, 1.0, 10000.0),
            ("ur.acceleration_mm_s2", self.acceleration_mm_s2, 1.0, 100_000.0),
            ("ur.blend_mm", self.blend_mm, 0.0, 100.0),
        ])?;
        check_force("ur", &self.force_on, &self.force_off)?;
        name("ur.program", &self.program, Letters::Identifier, 32)
    }
}
