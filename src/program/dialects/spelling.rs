//! What a line of a program is however it is spelled: blanks and tabs, large letters where the language knows none,
//! comments behind the code, names beside numbers, figures with more or fewer digits. Controllers change those by
//! themselves when they give a program back. What a line does is the readers'.

use crate::program::dialect::Statement;

/// Figures are the same to a share of this: controllers give back six digits.
const SAME_SHARE: f64 = 5e-6;
/// Figures near zero are the same to this: a micrometre, or 0.0001 degrees in a quaternion.
const SAME_NEAR_ZERO: f64 = 1e-6;

/// How a language may spell one and the same line.
#[derive(Clone, Copy, Debug)]
pub struct Spelling {
    /// Large and small letters are the same.
    pub folds_case: bool,
    /// What begins a comment behind the code of a line.
    pub comment: Option<char>,
    /// Names may stand behind numbers in brackets, as in `DO[1:laser]`.
    pub names_in_brackets: bool,
    /// What a line begins with that is a comment, whatever the cell file makes of its own.
    pub comment_starts: &'static [&'static str],
}

impl Spelling {
    /// The line without a comment behind it.
    pub fn code<'t>(&self, line: &'t str) -> &'t str {
        let mut quoted = false;
        let end = line.char_indices().find(|(_, c)| {
            quoted ^= *c == '"';
            !quoted && self.comment == Some(*c)
        });
        end.map_or(line, |(at, _)| &line[..at]).trim()
    }

    /// The code of a line as all its spellings have it: blanks only where two words would run together, letters
    /// large where they do not count, no names in brackets. Texts in quotes and the `{keys}` of templates stay.
    pub fn plain(&self, line: &str) -> String {
        let code = self.code(line);
        let mut out = String::with_capacity(code.len());
        let (mut quoted, mut inside, mut named, mut blank) = (false, false, false, false);
        let mut key_until = 0;
        for (at, c) in code.char_indices() {
            if quoted {
                out.push(c);
                quoted = c != '"';
                continue;
            }
            named &= c != ']';
            if named {
                continue;
            }
            if c.is_whitespace() {
                blank = true;
                continue;
            }
            if std::mem::take(&mut blank) && is_word(c) && out.ends_with(is_word) {
                out.push(' ');
            }
            match c {
                '"' => quoted = true,
                '[' => inside = true,
                ']' => inside = false,
                ':' if self.names_in_brackets && inside => {
                    named = true;
                    continue;
                }
                '{' => key_until = key_end(&code[at..]).map_or(0, |n| at + n),
                _ => {}
            }
            out.push(if self.folds_case && at >= key_until { c.to_ascii_uppercase() } else { c });
        }
        out
    }

    /// What a line says that is nothing but a comment.
    pub fn comment_of<'t>(&self, line: &'t str) -> &'t str {
        self.comment.map_or(line, |mark| line.trim_start_matches(mark)).trim()
    }

    /// Whether a line is nothing but a comment.
    pub fn is_comment(&self, line: &str) -> bool {
        let begins = |start: &&str| line.get(..start.len()).is_some_and(|l| l.eq_ignore_ascii_case(start));
        self.comment_starts.iter().any(begins)
    }

    /// A line that the cell file has: in the words that it has there, however it is spelled here.
    pub fn known(&self, known: &[String], line: &str) -> Option<Statement> {
        let plain = self.plain(line);
        known.iter().find(|k| is_same_code(&self.plain(k), &plain)).map(|k| Statement::Other(k.clone()))
    }

    /// A line that begins as one of the cell file does and is another: its own words.
    pub fn altered(&self, known: &[String], line: &str) -> Option<Statement> {
        let plain = self.plain(line);
        let word = first_word(&plain);
        let is_alike = |k: &String| !word.is_empty() && first_word(&self.plain(k)) == word;
        known.iter().any(is_alike).then(|| Statement::Other(self.code(line).to_owned()))
    }
}

/// Whether a blank between it and its like counts.
fn is_word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '$' | '.' | '{' | '}' | '-' | '+')
}

/// How long the `{key}` of a template is that a text begins with.
fn key_end(text: &str) -> Option<usize> {
    let close = text.find('}')?;
    let key = text.get(1..close)?;
    (!key.is_empty() && key.bytes().all(|b| b.is_ascii_lowercase())).then_some(close + 1)
}

/// Its first word, with the marks before it.
fn first_word(plain: &str) -> &str {
    let marks = |c: char| matches!(c, '/' | '$' | '.' | '_');
    let end = plain.find(|c: char| !(c.is_alphanumeric() || marks(c))).unwrap_or(plain.len());
    &plain[..end]
}

/// Whether two codes say the same: alike in their words, and in their figures to six digits.
pub fn is_same_code(a: &str, b: &str) -> bool {
    let (mut a, mut b) = (Pieces(a), Pieces(b));
    loop {
        match (a.next(), b.next()) {
            (None, None) => return true,
            (Some(a), Some(b)) if a == b || is_same_figure(a, b) => {}
            _ => return false,
        }
    }
}

fn is_same_figure(a: &str, b: &str) -> bool {
    let figure = |t: &str| t.parse::<f64>().ok().filter(|v| v.is_finite() && begins_with_figure(t));
    let (Some(a), Some(b)) = (figure(a), figure(b)) else { return false };
    (a - b).abs() <= SAME_NEAR_ZERO + SAME_SHARE * a.abs().max(b.abs())
}

fn begins_with_figure(text: &str) -> bool {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    unsigned.strip_prefix('.').unwrap_or(unsigned).starts_with(|c: char| c.is_ascii_digit())
}

/// A text in figures and what stands between them. Digits of a name belong to the name.
struct Pieces<'t>(&'t str);

impl<'t> Iterator for Pieces<'t> {
    type Item = &'t str;

    fn next(&mut self) -> Option<&'t str> {
        let text = self.0;
        let end = if begins_with_figure(text) { figure_end(text) } else { words_end(text) };
        let (piece, rest) = text.split_at(end);
        self.0 = rest;
        (!piece.is_empty()).then_some(piece)
    }
}

/// Sign, digits with one point, exponent.
fn figure_end(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| from + bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut end = digits(usize::from(matches!(bytes.first(), Some(b'-' | b'+'))));
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let from = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'-' | b'+')));
        if digits(from.min(bytes.len())) > from {
            end = digits(from);
        }
    }
    end
}

/// Up to the next figure that is no part of a name.
fn words_end(text: &str) -> usize {
    let mut before = None::<char>;
    let found = text.char_indices().find(|(at, c)| {
        let joins = |c: char| c.is_alphanumeric() || matches!(c, '_' | ')' | ']');
        let starts = !before.is_some_and(joins) && begins_with_figure(&text[*at..]);
        before = Some(*c);
        starts && *at > 0
    });
    found.map_or(text.len(), |(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const KRL: Spelling =
        Spelling { folds_case: true, comment: Some(';'), names_in_brackets: true, comment_starts: &[";"] };

    #[test]
    fn spellings_of_a_line_are_one() {
        for (a, b) in [
            ("$OUT[3]=TRUE", " $out[ 3 ] = true ; laser"),
            ("LIN {X 1.0,Y -2.0} C_DIS", "lin\t{X  1.0, Y -2.0}   C_DIS"),
            ("DO[1]=OFF", "DO[1:laser off]=OFF"),
            ("P[1]{", "P[1:\"home; \"]{"),
            ("BAS(#INITMOV,0)", "BAS (#INITMOV,0 )"),
        ] {
            assert_eq!(KRL.plain(a), KRL.plain(b));
        }
        for (a, b) in [("WAIT SEC 1", "WAITSEC 1"), ("X 1", "X -1"), ("$OUT[3]=TRUE", "$OUT[31]=TRUE")] {
            assert_ne!(KRL.plain(a), KRL.plain(b));
        }
        assert_eq!(KRL.plain("out {n} {v}"), "OUT {n} {v}");
        assert_eq!(KRL.code("a \"x;y\" ; b"), "a \"x;y\"");
    }

    #[test]
    fn figures_are_the_same_to_six_digits() {
        for (a, b) in [
            ("[[380.0000,0.0],[0.707106781]]", "[[380,0],[0.707107]]"),
            ("9E9,9E9", "9E+09,9E+09"),
            ("a=1.3963,r=0", "a=1.39630,r=0.000"),
            ("1234.5678", "1234.57"),
            ("[-.5]", "[-0.50]"),
        ] {
            assert!(is_same_code(a, b), "{a} {b}");
        }
        for (a, b) in [
            ("UF0 UT1", "UF0 UT2"),
            ("380.001", "380.01"),
            ("tool1", "tool1.0"),
            ("a=1,b=2", "a=1"),
            ("a=1", "b=1"),
            ("[1,2]", "[1,-2]"),
            ("0.5", ""),
        ] {
            assert!(!is_same_code(a, b), "{a} {b}");
        }
    }

    #[test]
    fn lines_of_the_cell_are_known_and_their_changes_told() {
        let known = ["$TOOL=$NULLFRAME".to_owned(), "BAS(#INITMOV,0)".to_owned()];
        assert_eq!(KRL.known(&known, "$tool = $nullframe"), Some(Statement::Other(known[0].clone())));
        assert_eq!(KRL.known(&known, "$TOOL=$WORLD"), None);
        assert_eq!(KRL.altered(&known, "$TOOL=$WORLD ; x"), Some(Statement::Other("$TOOL=$WORLD".into())));
        assert_eq!(KRL.altered(&known, "$OV_PRO=50"), None);
    }

    proptest! {
        #[test]
        fn any_text_is_spelled(line in "\\PC{0,40}", other in "\\PC{0,40}") {
            let plain = KRL.plain(&line);
            prop_assert_eq!(KRL.plain(&plain), plain.clone());
            prop_assert!(is_same_code(&line, &line));
            prop_assert_eq!(is_same_code(&line, &other), is_same_code(&other, &line));
            let _ = (KRL.is_comment(&line), KRL.altered(std::slice::from_ref(&other), &line));
        }
    }
}
