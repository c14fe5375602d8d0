//! The `[outputs]` table of a cell file: what the program switches beside the moves, whatever the
//! controller. The words for it are in the controllers' own tables.

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
    pub power: LevelOutput,
    /// How the frequency of its pulses is set, kHz.
    #[serde(default)]
    pub frequency: LevelOutput,
}

impl Default for Outputs {
    /// The laser at the first output, and its power set by hand.
    fn default() -> Self {
        let laser = Switch { number: 1, on_wait_s: 0.0, off_wait_s: 0.0 };
        let level = LevelOutput::default();
        Outputs { laser, powder: None, shielding_gas: None, cooling: None, power: level, frequency: level }
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
pub struct LevelOutput {
    /// By hand, or by an output.
    #[serde(rename = "as")]
    pub form: LevelForm,
    /// Number of the analogue output or of the group.
    pub number: u32,
    /// Units of the output for one watt, or one kilohertz.
    pub scale: f64,
}

impl Default for LevelOutput {
    fn default() -> Self {
        LevelOutput { form: LevelForm::Comment, number: 1, scale: 1.0 }
    }
}

/// By hand, or by an output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LevelForm {
    /// The program's head states it, and it is set at the laser.
    #[default]
    Comment,
    /// An analogue output.
    Analogue,
    /// A group of digital outputs, as a whole number.
    Group,
}

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

    /// # Errors
    /// Which figure makes no sense, and what it may be.
    pub fn check(&self) -> Result<(), String> {
        let mut taken: Vec<(&str, u32)> = Vec::new();
        for (name, s) in self.switches() {
            if s.number > 9999 {
                return Err(format!("outputs.{name}.number = {}: give 0 to 9999", s.number));
            }
            if let Some((other, _)) = taken.iter().find(|(_, n)| *n == s.number) {
                return Err(format!("outputs.{name}.number = {}: {other} has it already; give another", s.number));
            }
            taken.push((name, s.number));
            for (wait, seconds) in [("on_wait_s", s.on_wait_s), ("off_wait_s", s.off_wait_s)] {
                if !(0.0..=600.0).contains(&seconds) {
                    return Err(format!("outputs.{name}.{wait} = {seconds}: give 0 to 600"));
                }
            }
        }
        for (name, unit, level) in [("power", "W", &self.power), ("frequency", "kHz", &self.frequency)] {
            if level.number > 9999 {
                return Err(format!("outputs.{name}.number = {}: give 0 to 9999", level.number));
            }
            if !(1e-6..=1e6).contains(&level.scale) {
                let scale = level.scale;
                return Err(format!("outputs.{name}.scale = {scale}: give 0.000001 to 1000000 units per {unit}"));
            }
        }
        let (power, frequency) = (&self.power, &self.frequency);
        if power.form != LevelForm::Comment && (power.form, power.number) == (frequency.form, frequency.number) {
            return Err(format!("outputs.frequency.number = {}: power has it already; give another", frequency.number));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checked(text: &str) -> Result<(), String> {
        toml::from_str::<Outputs>(text).map_err(|e| e.to_string())?.check()
    }

    #[test]
    fn bad_outputs_are_named() {
        assert_eq!(checked("laser = { number = 3 }"), Ok(()));
        let twice = checked("laser = { number = 3 }\npowder = { number = 3 }").expect_err("refused");
        assert!(twice.contains("outputs.laser") && twice.contains("powder has it"), "{twice}");
        let wait = checked("laser = { number = 3, on_wait_s = -1.0 }").expect_err("refused");
        assert!(wait.contains("outputs.laser.on_wait_s = -1"), "{wait}");
        let scale = checked("laser = { number = 3 }\npower = { as = \"group\", scale = 0.0 }").expect_err("refused");
        assert!(scale.contains("outputs.power.scale"), "{scale}");
        let both = "power = { as = \"group\", number = 2 }\nfrequency = { as = \"group\", number = 2 }";
        let both = checked(&format!("laser = {{ number = 3 }}\n{both}")).expect_err("refused");
        assert!(both.contains("outputs.frequency.number = 2: power has it"), "{both}");
        assert!(checked("powder = { number = 3 }").is_err(), "a cell without a laser");
        assert!(checked("laser = { number = 3, during = \"program\" }").is_err(), "the laser is no supply");
    }
}
