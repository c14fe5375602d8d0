//! The `[outputs]` table of a cell file: what the program switches beside the moves, whatever the
//! controller. The templates for it are in the controllers' own tables.

use super::check::{FigureError, ranges};
use serde::{Deserialize, Serialize};

/// Everything that is switched or set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Outputs {
    /// The laser: on for a lit piece only.
    pub laser: Switch,
    /// Powder feed: on for a lit piece only, before the laser.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub powder: Option<Switch>,
    /// Shielding gas, before powder and laser.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shielding_gas: Option<Supply>,
    /// Cooling, before all others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cooling: Option<Supply>,
    /// How the laser's power is set, W.
    #[serde(default)]
    pub power: ValueOutput,
    /// How the frequency of its pulses is set, kHz.
    #[serde(default)]
    pub frequency: ValueOutput,
}

impl Default for Outputs {
    /// The laser at the first output, and its power set by hand.
    fn default() -> Self {
        let laser = Switch { number: 1, on_wait_s: 0.0, off_wait_s: 0.0 };
        let by_hand = ValueOutput::default();
        Outputs { laser, powder: None, shielding_gas: None, cooling: None, power: by_hand, frequency: by_hand }
    }
}

/// A digital output and how long the robot stands after switching it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Switch {
    /// The controller's number of the output.
    pub number: u32,
    /// After it went on, s.
    #[serde(default)]
    pub on_wait_s: f64,
    /// After it went off, s.
    #[serde(default)]
    pub off_wait_s: f64,
}

/// A digital output that may stay on between lit pieces.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Supply {
    /// The controller's number of the output.
    pub number: u32,
    /// After it went on, s.
    #[serde(default)]
    pub on_wait_s: f64,
    /// After it went off, s.
    #[serde(default)]
    pub off_wait_s: f64,
    /// How long it stays on.
    #[serde(default)]
    pub during: During,
}

impl Supply {
    /// Output and waits.
    pub fn switch(&self) -> Switch {
        Switch { number: self.number, on_wait_s: self.on_wait_s, off_wait_s: self.off_wait_s }
    }
}

/// How long a supply stays on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum During {
    /// From the first line to the last.
    #[default]
    Program,
    /// For each lit piece.
    Piece,
}

/// How a figure of the laser is set.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ValueOutput {
    /// By hand, or by an output.
    #[serde(rename = "as")]
    pub form: ValueForm,
    /// Number of the analogue output or of the group.
    pub number: u32,
    /// Units of the output for one watt, or one kilohertz.
    pub scale: f64,
}

impl Default for ValueOutput {
    fn default() -> Self {
        ValueOutput { form: ValueForm::Comment, number: 1, scale: 1.0 }
    }
}

/// By hand, or by an output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ValueForm {
    /// The program's head states it, and it is set at the laser.
    #[default]
    Comment,
    /// An analogue output.
    Analogue,
    /// A group of digital outputs, as a whole number.
    Group,
}

/// No controller numbers its outputs higher.
const MOST_NUMBER: f64 = 9999.0;

impl Outputs {
    /// Every digital output with its name, in the order in which they go on.
    pub fn switches(&self) -> impl Iterator<Item = (&'static str, Switch)> {
        [
            ("cooling", self.cooling.map(|s| s.switch())),
            ("shielding_gas", self.shielding_gas.map(|s| s.switch())),
            ("powder", self.powder),
            ("laser", Some(self.laser)),
        ]
        .into_iter()
        .filter_map(|(name, switch)| Some((name, switch?)))
    }

    /// Whether each output has a number of its own, and figures within their ranges.
    ///
    /// # Errors
    /// The first figure that makes no sense.
    pub fn check(&self) -> Result<(), FigureError> {
        let range = |name: &str, key: &str, value: f64, low: f64, high: f64| {
            ranges(&[(&format!("outputs.{name}.{key}"), value, low, high)])
        };
        let taken = |name, number, by| FigureError::Taken { key: format!("outputs.{name}.number"), number, by };
        let mut before: Vec<(&'static str, u32)> = Vec::new();
        for (name, s) in self.switches() {
            range(name, "number", f64::from(s.number), 0.0, MOST_NUMBER)?;
            if let Some((by, _)) = before.iter().find(|(_, n)| *n == s.number) {
                return Err(taken(name, s.number, by));
            }
            before.push((name, s.number));
            range(name, "on_wait_s", s.on_wait_s, 0.0, 600.0)?;
            range(name, "off_wait_s", s.off_wait_s, 0.0, 600.0)?;
        }
        for (name, output) in [("power", &self.power), ("frequency", &self.frequency)] {
            range(name, "number", f64::from(output.number), 0.0, MOST_NUMBER)?;
            range(name, "scale", output.scale, 1e-6, 1e6)?;
        }
        let (power, frequency) = (&self.power, &self.frequency);
        if power.form != ValueForm::Comment && (power.form, power.number) == (frequency.form, frequency.number) {
            return Err(taken("frequency", frequency.number, "power"));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> FigureError {
        toml::from_str::<Outputs>(text).expect("outputs").check().expect_err("refused")
    }

    fn is_read(text: &str) -> bool {
        toml::from_str::<Outputs>(text).is_ok()
    }

    #[test]
    fn bad_outputs_are_named() {
        let good: Outputs = toml::from_str("laser = { number = 3 }").expect("outputs");
        assert_eq!(good.check(), Ok(()));
        let taken = |key: &str, number, by| FigureError::Taken { key: key.into(), number, by };
        let twice = refused("laser = { number = 3 }\npowder = { number = 3 }");
        assert_eq!(twice, taken("outputs.laser.number", 3, "powder"));
        let range = |key: &str, value, low, high| FigureError::Range { key: key.into(), value, low, high };
        let wait = refused("laser = { number = 3, on_wait_s = -1.0 }");
        assert_eq!(wait, range("outputs.laser.on_wait_s", -1.0, 0.0, 600.0));
        let scale = refused("laser = { number = 3 }\npower = { as = \"group\", scale = 0.0 }");
        assert_eq!(scale, range("outputs.power.scale", 0.0, 1e-6, 1e6));
        let both = "power = { as = \"group\", number = 2 }\nfrequency = { as = \"group\", number = 2 }";
        let both = refused(&format!("laser = {{ number = 3 }}\n{both}"));
        assert_eq!(both, taken("outputs.frequency.number", 2, "power"));
        assert!(!is_read("powder = { number = 3 }"), "a cell without a laser");
        assert!(!is_read("laser = { number = 3, during = \"program\" }"), "the laser is no supply");
    }
}
