//! Outputs, levels, dwells and comments by the templates of a controller's table, both ways. Moves
//! are each dialect's own.

use super::dialect::Read;
use super::lines::Line;
use crate::cell::controllers::words::{cut, filled, fixed, matched, matched_key, number, plain};

/// A controller's templates.
#[derive(Clone, Copy, Debug)]
pub struct Phrases<'a> {
    /// Output `{n}` on.
    pub output_on: &'a str,
    /// Output `{n}` off.
    pub output_off: &'a str,
    /// Analogue output `{n}` to `{v}`.
    pub analogue: &'a str,
    /// Group `{n}` of outputs to the whole number `{v}`.
    pub group: &'a str,
    /// Dwell of `{s}` seconds.
    pub wait: &'a str,
    /// How many `{s}` there are in a second: 1000 where the controller counts milliseconds.
    pub wait_per_s: f64,
    /// Decimals of `{s}`.
    pub wait_decimals: usize,
    /// Comment of `{text}`.
    pub comment: &'a str,
    /// Characters that would end the comment.
    pub forbidden: &'a [char],
    /// Longest comment.
    pub width: usize,
}

impl Phrases<'_> {
    /// The lines of anything but a move.
    pub fn write(&self, line: &Line) -> Vec<String> {
        match line {
            Line::Say(text) => {
                cut(plain(text, self.forbidden).trim(), self.width).iter().map(|t| self.comment(t)).collect()
            }
            Line::Output { number, on } => {
                let template = if *on { self.output_on } else { self.output_off };
                vec![filled(template, &[("n", &number.to_string())])]
            }
            Line::Level { number, value, group } => {
                let (template, decimals) = if *group { (self.group, 0) } else { (self.analogue, 3) };
                vec![filled(template, &[("n", &number.to_string()), ("v", &fixed(*value, decimals))])]
            }
            Line::Wait(seconds) => {
                vec![filled(self.wait, &[("s", &fixed(seconds * self.wait_per_s, self.wait_decimals))])]
            }
            Line::Move(_) => Vec::new(),
        }
    }

    fn comment(&self, text: &str) -> String {
        filled(self.comment, &[("text", text)]).trim_end().into()
    }

    /// What a line does, if it is one of these.
    pub fn read(&self, line: &str) -> Option<Read> {
        let output = |template, on| {
            let number = matched_key(template, "n", line)?.parse().ok()?;
            Some(Read::Output { number, on })
        };
        let level = |template, group| {
            let keys = matched(template, line)?;
            let value = |key: &str| keys.iter().find(|(k, _)| *k == key).map(|(_, v)| *v);
            Some(Read::Level { number: value("n")?.parse().ok()?, value: number(value("v")?)?, group })
        };
        let wait = || Some(Read::Wait(number(matched_key(self.wait, "s", line)?)? / self.wait_per_s));
        let say = || {
            let text = matched_key(self.comment, "text", line).or((self.comment("") == line).then_some(""))?;
            Some(Read::Say(text.into()))
        };
        output(self.output_on, true)
            .or_else(|| output(self.output_off, false))
            .or_else(|| level(self.group, true))
            .or_else(|| level(self.analogue, false))
            .or_else(wait)
            .or_else(say)
    }
}
