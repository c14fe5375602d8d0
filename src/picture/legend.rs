//! The legend of a scale as data: its colours from end to end, numbers marked on it, and colours beside it. What the
//! numbers are called is said in `text`; the window and the pictures of `render` each paint it their own way.

use super::palette::Rgb;

/// Colours of a bar: enough that no step is seen.
const STEPS: usize = 256;

/// What the numbers of a scale are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Energy per area, J/cm².
    Dose,
    /// Angle between light and normal, degrees.
    Incidence,
    /// How far what was scanned lies off the model, outside above 0, mm.
    Deviation,
}

/// What a colour beside a scale stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LegendEntry {
    /// More light than is allowed.
    Over,
    /// Too little, for want of light.
    Under,
    /// Too little, because something shades it.
    Shaded,
    /// No light lands there.
    NoLight,
    /// More material than the model has.
    Surplus,
    /// As the model, within the tolerance.
    Within,
    /// Less material than the model has.
    Missing,
    /// No point of the scan there, or no model near the point.
    NotScanned,
}

/// A colour scale, and what has a colour beside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Legend {
    /// What the numbers are.
    pub quantity: Quantity,
    /// The ends of the scale.
    pub range: [f64; 2],
    /// Numbers to be marked on it, ascending.
    pub marks: Vec<f64>,
    /// Digits of them behind the point.
    pub decimals: usize,
    /// Colours of equal steps from the low end to the high one.
    pub bar: Vec<Rgb>,
    /// Colours beside the scale.
    pub entries: Vec<(LegendEntry, Rgb)>,
}

impl Legend {
    /// A legend without anything beside its scale; `color` gives the colour of a number.
    pub fn new(quantity: Quantity, range: [f64; 2], color: impl Fn(f64) -> Rgb) -> Legend {
        let [low, high] = range;
        let number = |step: usize| low + (high - low) * (step as f64 + 0.5) / STEPS as f64;
        let bar = (0..STEPS).map(|step| color(number(step))).collect();
        Legend { quantity, range, marks: Vec::new(), decimals: 0, bar, entries: Vec::new() }
    }

    /// The colour at a share of the scale, 0 at its low end; what is beyond takes the end's.
    pub fn color(&self, share: f64) -> Rgb {
        let step = (share.clamp(0.0, 1.0) * self.bar.len() as f64) as usize;
        self.bar.get(step.min(self.bar.len().saturating_sub(1))).copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_goes_from_the_low_end_to_the_high_one() {
        let grey = |v: f64| [(v * 10.0) as u8; 3];
        let legend = Legend::new(Quantity::Dose, [10.0, 20.0], grey);
        assert_eq!([-1.0, 0.0, 0.5, 1.0, 7.0].map(|share| legend.color(share)[0]), [100, 100, 150, 199, 199]);
    }
}
