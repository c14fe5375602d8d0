//! The text form of STL: any case, any white space, any bytes in names (GBK occurs), several solids in one file, and a
//! binary solid behind them.

use super::super::PartFileError;
use super::super::number::has_decimal_comma;
use super::binary;
use super::words::{NAME, Tokens, Word, bom_len};
use crate::part::raw_part::{FacetFault, RawFacet, RawPart};
use crate::progress::Progress;

/// Where a binary solid begins behind an `endsolid`, its name or the end of its line.
fn binary_behind(tokens: &Tokens<'_>) -> Option<usize> {
    let near = &tokens.bytes[tokens.at..tokens.bytes.len().min(tokens.at + NAME)];
    let line = near.iter().position(|b| matches!(b, b'\n' | b'\r')).map_or(near.len(), |end| end + 2);
    let candidates = || tokens.at..=tokens.at + line;
    near.contains(&0).then(candidates)?.find(|at| binary::solids(tokens.bytes, *at).is_some())
}

/// Parses the text form from `at` on; returns where something else begins.
///
/// # Errors
/// [`PartFileError::TextCutOff`] when a solid has no `endsolid`, [`PartFileError::DecimalComma`];
/// [`PartFileError::Cancelled`] when `progress` says so.
pub(super) fn read(bytes: &[u8], at: usize, part: &mut RawPart, progress: &Progress) -> Result<usize, PartFileError> {
    let mut tokens = Tokens { bytes, at: at + bom_len(&bytes[at..]) };
    let mut inside = false;
    while let Some(token) = tokens.next() {
        progress.check()?;
        match token.word {
            Word::Solid => {
                part.solids += 1;
                inside = true;
                tokens.skip_name();
            }
            Word::EndSolid => {
                inside = false;
                if let Some(at) = binary_behind(&tokens) {
                    return Ok(at);
                }
                tokens.skip_name();
            }
            Word::Facet => match facet(&mut tokens, part) {
                Ok(f) => part.push_checked(f, token.byte),
                Err(FacetReadError::Facet(fault)) => part.push_invalid(fault, token.byte),
                Err(FacetReadError::Ends) => return Err(cut_off(bytes, part)),
                Err(FacetReadError::DecimalComma { byte }) => return Err(PartFileError::DecimalComma { byte }),
            },
            _ => part.pass_over(token.text.len(), token.byte),
        }
    }
    if inside { Err(cut_off(bytes, part)) } else { Ok(bytes.len()) }
}

fn cut_off(bytes: &[u8], part: &RawPart) -> PartFileError {
    PartFileError::TextCutOff { facets: part.facets.len() + part.invalid.len(), byte: bytes.len() }
}

enum FacetReadError {
    /// The file ends inside the facet.
    Ends,
    /// This facet is unusable; the next may be good.
    Facet(FacetFault),
    /// Numbers are written with a comma, so none of the file can be read.
    DecimalComma { byte: usize },
}

/// Reads up to `endfacet`; a bad facet is read to its end too, so that the next one is found.
fn facet(tokens: &mut Tokens<'_>, part: &mut RawPart) -> Result<RawFacet, FacetReadError> {
    let mut corners: RawFacet = Default::default();
    let (mut count, mut readable) = (0, true);
    loop {
        let before = tokens.at;
        let token = tokens.next().ok_or(FacetReadError::Ends)?;
        match token.word {
            Word::Vertex => {
                let values = vertex(tokens)?;
                readable &= values.iter().all(Option::is_some);
                if let Some(corner) = corners.get_mut(count) {
                    *corner = values.map(Option::unwrap_or_default);
                }
                count += 1;
            }
            Word::EndFacet => break,
            Word::Normal => {
                tokens.numbers();
            }
            Word::Loop => {}
            Word::Facet | Word::Solid | Word::EndSolid => {
                tokens.at = before;
                return Err(FacetReadError::Facet(FacetFault::NoEnd));
            }
            Word::Other => part.pass_over(token.text.len(), token.byte),
        }
    }
    match (count, readable) {
        (3, true) => Ok(corners),
        (3, false) => Err(FacetReadError::Facet(FacetFault::Unreadable)),
        _ => Err(FacetReadError::Facet(FacetFault::NotThreeVertices)),
    }
}

fn vertex(tokens: &mut Tokens<'_>) -> Result<[Option<f32>; 3], FacetReadError> {
    let words = tokens.numbers();
    if let Some(comma) = words.iter().flatten().find(|t| has_decimal_comma(t.text)) {
        return Err(FacetReadError::DecimalComma { byte: comma.byte });
    }
    Ok(words.map(|t| number(t?.text)))
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
    use super::super::super::read as read_any;
    use super::*;
    use crate::part::raw_part::PassedOver;

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
            assert!(matches!(result, Err(PartFileError::TextCutOff { .. })), "cut at {cut}: {result:?}");
        }
    }

    #[test]
    fn bad_facets_are_dropped_and_said() {
        let text = format!(
            "solid a\n{ONE}{}{}{}{ONE}endsolid a",
            ONE.replace("vertex 1 0 0", "vertex nan 0 0"),
            ONE.replace("vertex 1 0 0", "vertex one 0 0"),
            ONE.replace("vertex 1 0 0\n", ""),
        );
        let part = read_any(text.as_bytes()).expect("reads");
        assert_eq!(part.facets.len(), 2);
        let faults: Vec<_> = part.invalid.iter().map(|i| (i.facet, i.fault)).collect();
        let expected = [(1, FacetFault::Nan), (2, FacetFault::Unreadable), (3, FacetFault::NotThreeVertices)];
        assert_eq!(faults, expected);
    }

    #[test]
    fn utf_16_line_ends_of_old_and_words_apart() {
        let text = format!("solid part\n{ONE}{ONE}endsolid part\n");
        let utf16 = |bytes: fn(u16) -> [u8; 2], mark: &[u8]| -> Vec<u8> {
            mark.iter().copied().chain(text.encode_utf16().flat_map(bytes)).collect()
        };
        for bytes in [
            utf16(u16::to_le_bytes, b"\xff\xfe"),
            utf16(u16::to_be_bytes, b"\xfe\xff"),
            utf16(u16::to_le_bytes, b""),
            utf16(u16::to_be_bytes, b""),
            text.replace('\n', "\r").into_bytes(),
            text.replace("endloop", "end loop")
                .replace("endfacet", "end  facet")
                .replace("endsolid", "End Solid")
                .into_bytes(),
        ] {
            let part = read_any(&bytes).expect("reads");
            assert_eq!((part.facets.len(), part.solids, part.passed_over), (2, 1, None));
        }
        // Places are those of the file.
        let cut = utf16(u16::to_le_bytes, b"\xff\xfe")[..202].to_vec();
        assert_eq!(read_any(&cut), Err(PartFileError::TextCutOff { facets: 0, byte: 202 }));
    }

    #[test]
    fn a_decimal_comma_is_told_by_name() {
        let text = format!("solid a\n{ONE}{}endsolid a", ONE.replace("vertex 1 0 0", "vertex 1,5 0 0"));
        let byte = text.find("1,5").expect("there");
        assert_eq!(read_any(text.as_bytes()), Err(PartFileError::DecimalComma { byte }));
    }

    #[test]
    fn words_that_the_format_does_not_know_are_told() {
        let text = format!("solid a\n{ONE}color 1 0 0\n{ONE}endsolid a\nbye");
        let part = read_any(text.as_bytes()).expect("reads");
        let at = text.find("color").expect("there");
        assert_eq!((part.facets.len(), part.passed_over), (2, Some(PassedOver { count: 11, at })));
    }
}
