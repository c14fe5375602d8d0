//! Outputs, their values, forces, dwells and comments as they are read, by the templates of a controller's table, in whatever
//! spelling. Moves are each dialect's own; `templates` writes what is read here.

use super::spelling::Spelling;
use super::templates::SignalTemplates;
use crate::cell::controllers::templates::{matched, matched_key, number};
use crate::program::dialect::Statement;

/// What reads the signals of a program. Templates are kept as all their spellings have them.
#[derive(Clone, Debug)]
pub struct SignalReader<'a> {
    spelling: Spelling,
    output_on: String,
    output_off: String,
    analogue: String,
    group: String,
    force_on: String,
    force_off: String,
    wait: String,
    wait_per_s: f64,
    comment: &'a str,
    empty_comment: String,
}

impl<'a> SignalReader<'a> {
    /// For these templates.
    pub fn new(t: &SignalTemplates<'a>) -> SignalReader<'a> {
        let plain = |template: &str| t.spelling.plain(template);
        SignalReader {
            spelling: t.spelling,
            output_on: plain(t.output_on),
            output_off: plain(t.output_off),
            analogue: plain(t.analogue),
            group: plain(t.group),
            force_on: plain(t.force_on),
            force_off: plain(t.force_off),
            wait: plain(t.wait),
            wait_per_s: t.wait_per_s,
            comment: t.comment,
            empty_comment: t.comment(""),
        }
    }

    /// What a line does, if it is one of these.
    pub fn read(&self, line: &str) -> Option<Statement> {
        let plain = self.spelling.plain(line);
        let output = self.read_output(&plain).or_else(|| self.read_output_value(&plain));
        let output = output.or_else(|| self.read_force(&plain));
        output.or_else(|| self.read_wait(&plain)).or_else(|| self.read_comment(line))
    }

    /// The comment that a line is.
    pub fn read_comment(&self, line: &str) -> Option<Statement> {
        let by_template = matched_key(self.comment, "text", line);
        let is_empty = || self.empty_comment == line;
        let is_other = || self.spelling.code(line).is_empty() || self.spelling.is_comment(line);
        let text = by_template.or_else(|| is_empty().then_some(""));
        let text = text.or_else(|| is_other().then(|| self.spelling.comment_of(line)))?;
        Some(Statement::Comment(text.trim().into()))
    }

    fn read_output(&self, plain: &str) -> Option<Statement> {
        let number = |template| matched_key(template, "n", plain)?.trim().parse().ok();
        let on = number(&self.output_on).map(|number| Statement::Output { number, on: true });
        on.or_else(|| number(&self.output_off).map(|number| Statement::Output { number, on: false }))
    }

    fn read_output_value(&self, plain: &str) -> Option<Statement> {
        let output_value = |template, group| {
            let keys = matched(template, plain)?;
            let value = |key: &str| keys.iter().find(|(k, _)| *k == key).map(|(_, v)| *v);
            Some(Statement::OutputValue {
                number: value("n")?.trim().parse().ok()?,
                value: number(value("v")?)?,
                group,
            })
        };
        output_value(&self.group, true).or_else(|| output_value(&self.analogue, false))
    }

    fn read_force(&self, plain: &str) -> Option<Statement> {
        if self.force_on.is_empty() {
            return None;
        }
        let off = || (self.force_off == plain).then_some(0.0);
        let force_n = matched_key(&self.force_on, "f", plain).and_then(number).or_else(off)?;
        Some(Statement::Force(force_n))
    }

    fn read_wait(&self, plain: &str) -> Option<Statement> {
        let count = number(matched_key(&self.wait, "s", plain)?).filter(|count| *count >= 0.0)?;
        Some(Statement::Wait(count / self.wait_per_s))
    }
}
