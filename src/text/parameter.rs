//! Words of the table of parameters, looked up by the key of a row, and why a number is refused.

use super::bundle::by_key;
use super::number::exact;
use super::{Sentence, say};
use crate::document::parameter::{NumberFault, NumberKind, Parameter, ParameterError};

/// Name of a parameter in the window.
pub fn label(parameter: &Parameter) -> String {
    by_key(&text_key(parameter), None)
}

/// What a parameter means, and what it does, in one line without a full stop.
pub fn meaning(parameter: &Parameter) -> String {
    by_key(&text_key(parameter), Some("meaning"))
}

/// Key of the words of a parameter: that of the job file, with underscores for dots.
fn text_key(parameter: &Parameter) -> String {
    parameter.key.replace('.', "_")
}

/// Name and unit, as in lists.
pub(crate) fn label_with_unit(parameter: &Parameter) -> String {
    match parameter.kind.unit() {
        "" => label(parameter),
        unit => say!(compared_number, label = label(parameter), unit),
    }
}

/// A number with all its digits and its unit.
pub(crate) fn with_unit(value: f64, kind: NumberKind) -> String {
    let value = exact(value);
    match kind.unit() {
        "" => value,
        "°" => say!(number_in_degrees, value),
        unit => say!(number_with_unit, value, unit),
    }
}

/// The tip of a field: meaning, range from `least` on, symbol.
pub(crate) fn hint(parameter: &Parameter, least: f64) -> String {
    let decimals = parameter.kind.decimals();
    // As many digits as the field shows, without zeros that say nothing.
    let shown = super::fixed(least, decimals);
    let least = if decimals > 0 { shown.trim_end_matches('0').trim_end_matches('.').to_owned() } else { shown };
    let greatest = with_unit(parameter.limits.greatest, parameter.kind);
    let mut lines = vec![meaning(parameter), say!(number_range, least, greatest)];
    if !parameter.symbol.is_empty() {
        lines.push(parameter.symbol.into());
    }
    lines.join("\n")
}

impl Sentence for ParameterError {
    fn sentence(&self) -> String {
        refused(self.parameter.key.to_owned(), self)
    }
}

/// Why the number of an option is refused.
pub(crate) fn refused_option(e: &ParameterError) -> String {
    let name = e.parameter.option.map_or_else(|| e.parameter.key.to_owned(), |option| format!("--{option}"));
    refused(name, e)
}

fn refused(name: String, e: &ParameterError) -> String {
    let ParameterError { parameter: p, value, fault } = e;
    let value = exact(*value);
    let least = exact(p.limits.least);
    let greatest = with_unit(p.limits.greatest, p.kind);
    // What is out of range is told to be whole too.
    let fault = if p.kind.is_whole() { NumberFault::NotWhole } else { *fault };
    match fault {
        NumberFault::NotWhole => say!(number_not_whole, name, value, least, greatest),
        NumberFault::OutOfRange if p.limits.is_above_least => say!(number_not_above, name, value, least, greatest),
        NumberFault::OutOfRange => say!(number_out_of_range, name, value, least, greatest),
    }
}

#[cfg(test)]
mod tests {
    use super::super::messages::LANGUAGES;
    use super::*;
    use crate::document::PARAMETERS;
    use fluent_syntax::ast::Entry;
    use std::collections::BTreeSet;

    /// The keys of a file, attributes as `key.attribute`.
    fn keys(source: &str) -> BTreeSet<String> {
        let mut out = BTreeSet::new();
        for entry in fluent_syntax::parser::parse(source).expect("every file can be read").body {
            let Entry::Message(message) = entry else { continue };
            out.insert(message.id.name.to_owned());
            out.extend(message.attributes.iter().map(|a| format!("{}.{}", message.id.name, a.id.name)));
        }
        out
    }

    #[test]
    fn every_language_has_words_for_every_parameter_and_for_no_other() {
        let wanted = PARAMETERS.iter().map(text_key);
        let wanted: BTreeSet<String> = wanted.flat_map(|key| [format!("{key}.meaning"), key]).collect();
        assert_eq!(wanted.len(), 2 * PARAMETERS.len(), "no two keys become one");
        for (language, files) in LANGUAGES {
            let file = files.iter().find(|f| f.0 == "parameters").expect("a file of parameters");
            assert_eq!(keys(file.1), wanted, "{language}");
        }
    }

    #[test]
    fn what_is_refused_is_told_with_what_can_be() {
        let told = |key: &str, value: f64| Parameter::named(key).check(value).expect_err(key).sentence();
        assert_eq!(told("layers.spacing_mm", 0.0), "layers.spacing_mm = 0: give a number above 0, up to 1000 mm");
        assert_eq!(told("path.max_tilt_deg", 80.5), "path.max_tilt_deg = 80.5: give a number from 0 to 75°");
        assert_eq!(told("layers.passes", 1.5), "layers.passes = 1.5: give a whole number from 1 to 1000");
        let passes = Parameter::named("layers.passes").check(0.0).expect_err("none");
        assert_eq!(refused_option(&passes), "--passes = 0: give a whole number from 1 to 1000");
    }

    #[test]
    fn a_hint_tells_meaning_range_and_symbol() {
        let hint = hint(Parameter::named("layers.spacing_mm"), 0.001);
        let lines: Vec<&str> = hint.lines().collect();
        assert_eq!(lines[1..], ["0.001 to 1000 mm", "d (P2)"]);
        assert_eq!(lines[0], meaning(Parameter::named("layers.spacing_mm")));
    }
}
