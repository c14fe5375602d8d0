//! In which line of a TOML text a key stands, and which key stands at a place: errors that are found once a file is
//! read are told with the line.

use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// One step of the way to a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step<'k> {
    /// Into a table, by its key.
    Key(&'k str),
    /// Into a list, by the place from 0.
    Entry(usize),
}

/// The way of a key that is written with dots.
pub fn way_of(key: &str) -> Vec<Step<'_>> {
    key.split('.').map(Step::Key).collect()
}

/// The line, from 1, of the value that a way leads to; where it ends early, that of the last step that is there.
/// `None`: not even the first is, or the text is no TOML.
pub fn line_of(text: &str, way: &[Step<'_>]) -> Option<usize> {
    let root = DeTable::parse(text).ok()?;
    let (mut found, mut inside): (_, Option<&DeValue<'_>>) = (None, None);
    for step in way {
        let next = match (step, inside) {
            (Step::Key(key), None) => entry(root.get_ref(), key),
            (Step::Key(key), Some(DeValue::Table(table))) => entry(table, key),
            (Step::Entry(n), Some(DeValue::Array(list))) => list.get(*n).map(|v| (v.span(), v.get_ref())),
            _ => None,
        };
        let Some((at, value)) = next else { break };
        (found, inside) = (Some(at), Some(value));
    }
    found.map(|at| line_at(text, at.start))
}

fn entry<'t, 'i>(table: &'t DeTable<'i>, key: &str) -> Option<(Range<usize>, &'t DeValue<'i>)> {
    table.iter().find(|(k, _)| k.get_ref() == key).map(|(k, v)| (k.span(), v.get_ref()))
}

/// The line, from 1, of a place in a text.
pub(super) fn line_at(text: &str, at: usize) -> usize {
    text.bytes().take(at).filter(|b| *b == b'\n').count() + 1
}

/// The key, with those of its tables, of the innermost value or key that a place lies in; empty where there is none.
pub(super) fn key_at(root: &DeTable<'_>, at: usize) -> String {
    let mut way = Vec::new();
    descend(root, at, &mut way);
    way.join(".")
}

fn descend(table: &DeTable<'_>, at: usize, way: &mut Vec<String>) {
    // The span of a table in brackets is that of its header alone: what stands below is looked at all the same.
    for (key, value) in table {
        way.push(key.get_ref().to_string());
        if key.span().contains(&at) || is_within(value, at, way) {
            return;
        }
        way.pop();
    }
}

fn is_within(value: &Spanned<DeValue<'_>>, at: usize, way: &mut Vec<String>) -> bool {
    let depth = way.len();
    match value.get_ref() {
        DeValue::Table(table) => descend(table, at, way),
        DeValue::Array(list) => drop(list.iter().find(|v| is_within(v, at, way))),
        _ => {}
    }
    way.len() > depth || value.span().contains(&at)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "version = 2\n\n[part]\nfile = \"a.stl\"\n[part.placement]\nscale = 2\n\n[[tilts]]\nsurface = 1\n\
                        [[tilts]]\nsurface = 2\npreferred = { lead_deg = 1 }\n";

    #[test]
    fn a_key_is_found_in_its_line_and_a_line_by_its_key() {
        use Step::{Entry, Key};
        assert_eq!(line_of(TEXT, &[Key("version")]), Some(1));
        assert_eq!(line_of(TEXT, &[Key("part"), Key("placement"), Key("scale")]), Some(6));
        assert_eq!(line_of(TEXT, &[Key("tilts"), Entry(1), Key("preferred"), Key("lead_deg")]), Some(12));
        assert_eq!(line_of(TEXT, &[Key("tilts"), Entry(1), Key("least_deg")]), Some(10), "the row that lacks it");
        assert_eq!(line_of(TEXT, &[Key("cell")]), None);
        let root = DeTable::parse(TEXT).expect("TOML");
        let key = |word: &str| key_at(root.get_ref(), TEXT.find(word).expect(word));
        assert_eq!(key("scale = 2"), "part.placement.scale");
        assert_eq!(key("\"a.stl\""), "part.file");
        assert_eq!(key("lead_deg"), "tilts.preferred.lead_deg");
        assert_eq!(key("1 }"), "tilts.preferred.lead_deg");
    }
}
