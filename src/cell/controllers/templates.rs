//! Templates of a cell file, filled when a program is written and matched when it is read, and the plain text that all
//! dialects share: numbers, long lines, line ends.

use thiserror::Error;

/// Fixed decimals, '.' always, never `-0.000`.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| matches!(b, b'0' | b'.')) => rest.into(),
        _ => text,
    }
}

/// A number as controllers write it: sign, digits, one point. No exponent, no infinity.
pub fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let plain = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+'));
    text.parse().ok().filter(|v: &f64| plain && v.is_finite())
}

/// Exactly `N` numbers between commas.
pub fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let list: Vec<f64> = text.split(',').map(number).collect::<Option<_>>()?;
    list.try_into().ok()
}

/// Printable ASCII: what a controller might not take, and each of `forbidden`, becomes `?`.
pub fn plain(text: &str, forbidden: &[char]) -> String {
    text.chars().map(|c| if (c.is_ascii_graphic() || c == ' ') && !forbidden.contains(&c) { c } else { '?' }).collect()
}

/// Pieces of at most `width` characters (1 at least), cut at spaces where there are any; a blank
/// text is one piece. Text is plain.
pub fn cut(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut out: Vec<String> = Vec::new();
    let mut line = String::new();
    for word in text.split(' ') {
        let mut word = word;
        while line.len() + usize::from(!line.is_empty()) + word.len() > width {
            if !line.is_empty() {
                out.push(std::mem::take(&mut line));
            } else {
                // A word that is longer than the line; plain text has a boundary everywhere.
                let Some((head, rest)) = word.split_at_checked(width) else { break };
                out.push(head.into());
                word = rest;
            }
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    if !line.is_empty() || out.is_empty() {
        out.push(line);
    }
    out
}

/// A template with its `{keys}` replaced.
pub fn filled(template: &str, values: &[(&str, &str)]) -> String {
    parts(template)
        .into_iter()
        .map(|part| match part {
            TemplatePart::Text(text) => text,
            TemplatePart::Key(key) => values.iter().find(|(k, _)| *k == key).map_or("", |(_, v)| *v),
        })
        .collect()
}

/// What stands in a line at a template's `{keys}`, in their order; `None` where the line is none
/// of the template's. A key takes as little as it can, the last one all that is left; blanks
/// around the line do not count, and a key that stands twice has to say the same.
pub fn matched<'t, 'l>(template: &'t str, line: &'l str) -> Option<Vec<(&'t str, &'l str)>> {
    let mut rest = line.trim();
    let mut out: Vec<(&str, &str)> = Vec::new();
    let list = parts(template.trim());
    for (i, part) in list.iter().enumerate() {
        match part {
            TemplatePart::Text(text) => rest = rest.strip_prefix(text)?,
            TemplatePart::Key(key) => {
                let value = match &list[i + 1..] {
                    [] => rest,
                    [TemplatePart::Text(end)] => rest.strip_suffix(end)?,
                    [TemplatePart::Text(next), ..] => &rest[..rest.find(next)?],
                    [TemplatePart::Key(_), ..] => return None,
                };
                rest = &rest[value.len()..];
                if out.iter().any(|(k, v)| k == key && *v != value) {
                    return None;
                }
                out.push((key, value));
            }
        }
    }
    rest.is_empty().then_some(out)
}

/// The value of one key in a line of the template.
pub fn matched_key<'l>(template: &str, key: &str, line: &'l str) -> Option<&'l str> {
    matched(template, line)?.into_iter().find(|(k, _)| *k == key).map(|(_, v)| v)
}

/// A template that cannot be used.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{key} = {template:?}: {fault:?}")]
pub struct TemplateError {
    /// Its key in the cell file, with its table's.
    pub key: String,
    /// What stands there.
    pub template: String,
    /// What is wrong with it.
    pub fault: TemplateFault,
}

/// What is wrong with a template.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TemplateFault {
    /// The name of a value that it has to say.
    Lacks(&'static str),
    /// The name of a value that there is none of.
    Unknown {
        /// What stands in the braces.
        name: String,
        /// What may.
        known: &'static [&'static str],
    },
    /// Two values with nothing between them could not be told apart in a program.
    Touching,
    /// There is nothing in it.
    Blank,
    /// It is more than a line, or has other characters than ASCII.
    NotPlain,
}

/// Keys of the templates of signals in a controller's table, and what each of them has to hold.
const SIGNALS: [(&str, &[&str]); 6] = [
    ("output_on", &["n"]),
    ("output_off", &["n"]),
    ("analogue", &["n", "v"]),
    ("group", &["n", "v"]),
    ("wait", &["s"]),
    ("comment", &["text"]),
];

/// Checks a controller's templates of outputs on and off, analogue outputs, groups, dwells and comments, in that order.
/// `None`: the controller can do without it.
///
/// # Errors
/// The first that cannot be filled, or not be read back.
pub fn check_signals(table: &str, templates: [Option<&str>; 6]) -> Result<(), TemplateError> {
    let all = SIGNALS.iter().zip(templates);
    all.filter_map(|((key, names), template)| Some((key, names, template?)))
        .try_for_each(|(key, names, template)| check_template(&format!("{table}.{key}"), template, names))
}

/// Checks a controller's templates of a force on and off. Both are empty where it knows no such words.
///
/// # Errors
/// The first that cannot be filled, or not be read back, or that is missing.
pub fn check_force(table: &str, force_on: &str, force_off: &str) -> Result<(), TemplateError> {
    if force_on.is_empty() && force_off.is_empty() {
        return Ok(());
    }
    let (on, off) = (format!("{table}.force_on"), format!("{table}.force_off"));
    check_template(&on, force_on, &["f"])?;
    check_template(&off, force_off, &[])?;
    let empty = force_off.trim().is_empty();
    let refused = || TemplateError { key: off, template: force_off.to_owned(), fault: TemplateFault::Blank };
    if empty { Err(refused()) } else { Ok(()) }
}

/// Checks that a template has all values of `names`, and can be read back.
///
/// # Errors
/// What is wrong with it; `key` is where it stands.
pub fn check_template(key: &str, template: &str, names: &'static [&'static str]) -> Result<(), TemplateError> {
    let refused = |fault| Err(TemplateError { key: key.to_owned(), template: template.to_owned(), fault });
    let list = parts(template);
    let has = |key: &str| list.iter().any(|p| matches!(p, TemplatePart::Key(k) if *k == key));
    if let Some(missing) = names.iter().find(|n| !has(n)) {
        return refused(TemplateFault::Lacks(missing));
    }
    let unknown = list.iter().find_map(|p| match p {
        TemplatePart::Key(k) if !names.contains(k) => Some(*k),
        _ => None,
    });
    if let Some(name) = unknown {
        return refused(TemplateFault::Unknown { name: name.to_owned(), known: names });
    }
    if list.windows(2).any(|w| matches!(w, [TemplatePart::Key(_), TemplatePart::Key(_)])) {
        return refused(TemplateFault::Touching);
    }
    if plain(template, &[]) != template {
        return refused(TemplateFault::NotPlain);
    }
    Ok(())
}

/// A piece of a template.
enum TemplatePart<'a> {
    Text(&'a str),
    Key(&'a str),
}

/// Literal text and `{keys}` (lower-case words); any other brace is text.
fn parts(template: &str) -> Vec<TemplatePart<'_>> {
    let mut out = Vec::new();
    let (mut start, mut from) = (0, 0);
    while let Some(open) = template[from..].find('{').map(|i| from + i) {
        from = open + 1;
        let Some(close) = template[from..].find('}').map(|i| from + i) else { break };
        let key = &template[from..close];
        if !key.is_empty() && key.bytes().all(|b| b.is_ascii_lowercase()) {
            if start < open {
                out.push(TemplatePart::Text(&template[start..open]));
            }
            out.push(TemplatePart::Key(key));
            (start, from) = (close + 1, close + 1);
        }
    }
    if start < template.len() {
        out.push(TemplatePart::Text(&template[start..]));
    }
    out
}

/// Lines with their ends.
pub fn text(lines: &[String], crlf: bool) -> String {
    let end = if crlf { "\r\n" } else { "\n" };
    lines.iter().flat_map(|l| [l.as_str(), end]).collect()
}

/// Lines that say something, trimmed, with their numbers from 1; they may end with LF, CR LF or CR.
pub fn non_blank_lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines = text.split('\n').flat_map(|l| l.strip_suffix('\r').unwrap_or(l).split('\r'));
    lines.enumerate().map(|(i, l)| (i + 1, l.trim())).filter(|(_, l)| !l.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn never_minus_zero() {
        assert_eq!(fixed(-0.00004, 4), "0.0000");
        assert_eq!(fixed(-0.00006, 4), "-0.0001");
        assert_eq!(fixed(12.0, 3), "12.000");
    }

    #[test]
    fn numbers_are_plain() {
        assert_eq!(number(" -1.50 "), Some(-1.5));
        assert!(["inf", "NaN", "1e5", "", ".", "1.2.3", "0x1", "--1"].iter().all(|t| number(t).is_none()));
        assert_eq!(numbers("1, 2,3"), Some([1.0, 2.0, 3.0]));
        assert_eq!(numbers::<2>("1,2,3"), None);
    }

    #[test]
    fn templates_read_what_they_write() {
        assert_eq!(matched("SET O{n}", "SET O3"), Some(vec![("n", "3")]));
        assert_eq!(matched("SET [{n}]", " SET [03] "), Some(vec![("n", "03")]));
        assert_eq!(matched("AOUT {n},{v} ;", "AOUT 2,4.50 ;"), Some(vec![("n", "2"), ("v", "4.50")]));
        assert_eq!(matched("PULSE {n} {n}", "PULSE 1 2"), None);
        assert!(matched("SET O{n}", "RESET O3").is_none() && matched("DELAY {s}", "DELAY").is_none());
        assert!(matched("WAIT {s}(sec) ;", "WAIT 1.0 ;").is_none());
        assert_eq!(filled("{ {n} }", &[("n", "3")]), "{ 3 }");
        assert_eq!(matched_key("REM \"{text}\"", "text", "REM \"a \"b\" c\""), Some("a \"b\" c"));
    }

    #[test]
    fn templates_that_cannot_work_are_named() {
        assert!(check_template("x", "SET O{n}", &["n"]).is_ok());
        let refused = |bad, names| check_template("nachi.output_on", bad, names).expect_err("refused");
        for (bad, fault) in [
            ("SET O3", TemplateFault::Lacks("n")),
            ("SET {n}{m}", TemplateFault::Unknown { name: "m".into(), known: &["n"] }),
            ("SET\n{n}", TemplateFault::NotPlain),
            ("SÉT {n}", TemplateFault::NotPlain),
        ] {
            assert_eq!(
                refused(bad, &["n"]),
                TemplateError { key: "nachi.output_on".into(), template: bad.into(), fault }
            );
        }
        assert_eq!(refused("A{n}{v}", &["n", "v"]).fault, TemplateFault::Touching);
    }

    #[test]
    fn lines_are_counted_whatever_their_ends() {
        for text in ["\u{feff}a\n\n b \t\nc", "a\r\n\r\n b \r\nc\r\n", "a\r\r b\rc\r"] {
            assert_eq!(non_blank_lines(text).collect::<Vec<_>>(), [(1, "a"), (3, "b"), (4, "c")], "{text:?}");
        }
    }

    #[test]
    fn long_text_is_cut_at_spaces() {
        assert_eq!(cut("one two three", 7), ["one two", "three"]);
        assert_eq!(cut("abcdefgh ij", 3), ["abc", "def", "gh", "ij"]);
        assert_eq!(cut("", 5), [""]);
    }

    proptest! {
        #[test]
        fn filled_then_matched(n in 0..9999u32, v in -1e3..1e3f64) {
            let (n, v) = (n.to_string(), fixed(v, 3));
            for template in ["SETAO {n},{v}", "AO[{n}]={v} ;", "set_analog({n}, {v})"] {
                let line = filled(template, &[("n", &n), ("v", &v)]);
                prop_assert_eq!(matched(template, &line), Some(vec![("n", n.as_str()), ("v", v.as_str())]));
            }
        }

        #[test]
        fn nothing_panics(template in ".{0,20}", line in ".{0,20}", width in 0..9usize) {
            let _ = (matched(&template, &line), filled(&template, &[]), number(&line));
            let _ = check_template("x", &template, &["n"]);
            let text = plain(&line, &['"']);
            let pieces = cut(&text, width);
            prop_assert!(pieces.iter().all(|p| p.len() <= width.max(1)));
            let bare = |t: &str| t.replace(' ', "");
            prop_assert_eq!(bare(&pieces.concat()), bare(&text));
        }
    }
}
