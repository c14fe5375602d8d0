//! The text form of STL: tokens, any case, any white space, any bytes in names (GBK occurs),
//! several solids in one file.

use super::raw_part::{FacetFault, InvalidFacet, RawFacet, RawPart, StlError, StlFormat};

/// Whether the bytes begin like the text form: `solid`, no NUL early on (binary headers are padded
/// with them), and `facet` or `endsolid` further on.
pub(super) fn looks_like_text(bytes: &[u8]) -> bool {
    let mut tokens = Tokens { bytes, at: bom_len(bytes) };
    let holds = |word: &[u8]| bytes.windows(word.len()).take(1 << 20).any(|w| w.eq_ignore_ascii_case(word));
    tokens.next().is_some_and(|t| is(t.word, "solid"))
        && !bytes.iter().take(512).any(|&b| b == 0)
        && (holds(b"facet") || holds(b"endsolid"))
}

fn bom_len(bytes: &[u8]) -> usize {
    if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }
}

fn is(word: &[u8], keyword: &str) -> bool {
    word.eq_ignore_ascii_case(keyword.as_bytes())
}

#[derive(Clone, Copy)]
struct Token<'a> {
    word: &'a [u8],
    byte: usize,
}

/// White-space separated words.
#[derive(Clone)]
struct Tokens<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Iterator for Tokens<'a> {
    type Item = Token<'a>;

    fn next(&mut self) -> Option<Token<'a>> {
        let rest = &self.bytes[self.at..];
        let start = rest.iter().position(|b| !b.is_ascii_whitespace())?;
        let len = rest[start..].iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len() - start);
        let byte = self.at + start;
        self.at = byte + len;
        Some(Token { word: &rest[start..start + len], byte })
    }
}

impl Tokens<'_> {
    /// Skips a solid's name: to the end of the line, or to `facet normal` on the same line.
    fn skip_name(&mut self) {
        let line_end = self.bytes[self.at..]
            .iter()
            .position(|b| matches!(b, b'\n' | b'\r'))
            .map_or(self.bytes.len(), |n| self.at + n);
        let mut ahead = self.clone();
        loop {
            let before = ahead.at;
            match ahead.next() {
                Some(t) if t.byte < line_end => {
                    let next_is_normal = || ahead.clone().next().is_some_and(|n| is(n.word, "normal"));
                    if is(t.word, "facet") && next_is_normal() {
                        self.at = before;
                        return;
                    }
                }
                _ => break,
            }
        }
        self.at = line_end;
    }
}

/// Parses the text form.
///
/// # Errors
/// [`StlError::TextCutOff`] when a solid has no `endsolid`.
pub(super) fn read(bytes: &[u8]) -> Result<RawPart, StlError> {
    let mut part = RawPart { format: StlFormat::Text, ..Default::default() };
    let mut tokens = Tokens { bytes, at: bom_len(bytes) };
    let mut number = 0;
    let mut inside = false;
    while let Some(token) = tokens.next() {
        if is(token.word, "solid") {
            part.solids += 1;
            inside = true;
            tokens.skip_name();
        } else if is(token.word, "endsolid") {
            inside = false;
            tokens.skip_name();
        } else if is(token.word, "facet") {
            match facet(&mut tokens) {
                Ok(f) => part.push_checked(f, number, token.byte),
                Err(FacetReadError::Ends) => return Err(StlError::TextCutOff { facets: number, byte: bytes.len() }),
                Err(FacetReadError::Facet(fault)) => {
                    part.invalid.push(InvalidFacet { facet: number, byte: token.byte, fault })
                }
            }
            number += 1;
        }
    }
    if inside {
        return Err(StlError::TextCutOff { facets: number, byte: bytes.len() });
    }
    Ok(part)
}

enum FacetReadError {
    /// The file ends inside the facet.
    Ends,
    /// This facet is unusable; the next may be good.
    Facet(FacetFault),
}

/// Reads up to `endfacet`; a bad facet is read to its end too, so that the next one is found.
fn facet(tokens: &mut Tokens<'_>) -> Result<RawFacet, FacetReadError> {
    let mut corners: RawFacet = Default::default();
    let (mut count, mut readable) = (0, true);
    loop {
        let before = tokens.at;
        let token = tokens.next().ok_or(FacetReadError::Ends)?;
        if is(token.word, "vertex") {
            for axis in 0..3 {
                let value = number(tokens.next().ok_or(FacetReadError::Ends)?.word);
                readable &= value.is_some();
                if let (Some(corner), Some(v)) = (corners.get_mut(count), value) {
                    corner[axis] = v;
                }
            }
            count += 1;
        } else if is(token.word, "endfacet") {
            break;
        } else if is(token.word, "facet") || is(token.word, "endsolid") {
            tokens.at = before;
            return Err(FacetReadError::Facet(FacetFault::NoEnd));
        }
    }
    match (count, readable) {
        (3, true) => Ok(corners),
        (3, false) => Err(FacetReadError::Facet(FacetFault::Unreadable)),
        _ => Err(FacetReadError::Facet(FacetFault::NotThreeVertices)),
    }
}

/// A number as CAD systems write it; Windows' `1.#QNAN` and `1.#INF` are no numbers here.
fn number(word: &[u8]) -> Option<f32> {
    let text = std::str::from_utf8(word).ok()?;
    if text.contains('#') {
        return Some(f32::NAN);
    }
    text.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::super::stl::read as read_any;
    use super::*;

    const ONE: &str =
        "facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 1 0\n endloop\n endfacet\n";

    fn facets(text: &[u8]) -> usize {
        read_any(text).expect("reads").facets.len()
    }

    #[test]
    fn unnamed_blank_led_upper_case_and_gbk_named() {
        assert_eq!(facets(format!("solid\n{ONE}endsolid").as_bytes()), 1);
        assert_eq!(facets(format!("\n   solid part\n{ONE}endsolid part\n").as_bytes()), 1);
        assert_eq!(facets(format!("SOLID X\n{}ENDSOLID X", ONE.to_uppercase()).as_bytes()), 1);
        let gbk = [b"solid \xc1\xe3\xbc\xfe\n".as_slice(), ONE.as_bytes(), b"endsolid \xc1\xe3\xbc\xfe\n"].concat();
        assert_eq!(facets(&gbk), 1);
        assert_eq!(facets(format!("\u{feff}solid a\r\n{}endsolid", ONE.replace('\n', "\r\n")).as_bytes()), 1);
    }

    #[test]
    fn several_solids_are_joined_and_names_may_hold_keywords() {
        let two = format!("solid a\n{ONE}endsolid a\nsolid facet of b\n{ONE}{ONE}endsolid b\n");
        let part = read_any(two.as_bytes()).expect("reads");
        assert_eq!((part.facets.len(), part.solids), (3, 2));
    }

    #[test]
    fn one_line_files() {
        let line = format!("solid {} endsolid", ONE.replace('\n', " "));
        assert_eq!(facets(line.as_bytes()), 1);
    }

    #[test]
    fn a_text_that_ends_inside_a_solid_is_refused() {
        let whole = format!("solid a\n{ONE}{ONE}endsolid a\n");
        for cut in [whole.len() - 12, whole.len() - 40, 60] {
            let result = read_any(&whole.as_bytes()[..cut]);
            assert!(matches!(result, Err(StlError::TextCutOff { .. })), "cut at {cut}: {result:?}");
        }
    }

    #[test]
    fn bad_facets_are_dropped_and_said() {
        let text = format!(
            "solid a\n{ONE}{}{}{}{ONE}endsolid a",
            ONE.replace("vertex 1 0 0", "vertex nan 0 0"),
            ONE.replace("vertex 1 0 0", "vertex 1,5 0 0"),
            ONE.replace("vertex 1 0 0\n", ""),
        );
        let part = read_any(text.as_bytes()).expect("reads");
        assert_eq!(part.facets.len(), 2);
        let faults: Vec<_> = part.invalid.iter().map(|i| (i.facet, i.fault)).collect();
        let expected = [(1, FacetFault::Nan), (2, FacetFault::Unreadable), (3, FacetFault::NotThreeVertices)];
        assert_eq!(faults, expected);
    }
}
