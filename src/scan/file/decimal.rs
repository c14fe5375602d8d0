//! Numbers written as text, read without making a string of each: what has at most 53 bits of digits and a power of ten
//! that a double holds is exact by one multiplication or division (Clinger 1990, the fast path); the rest goes to the
//! standard library, and both round to the nearest.

/// What a comma is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Comma {
    /// It stands between cells.
    Delimits,
    /// It stands in the place of a decimal point.
    IsPoint,
}

/// Powers of ten that a double holds exactly.
const EXACT: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Whether a byte ends a cell.
#[inline]
pub(super) fn ends_cell(byte: u8, comma: Comma) -> bool {
    matches!(byte, b' ' | b'\t' | b';' | b'\r' | b'\n') || (byte == b',' && comma == Comma::Delimits)
}

/// The cell that the bytes begin with: its number (`None`: it is none) and its length.
#[inline]
pub(super) fn cell(bytes: &[u8], comma: Comma) -> (Option<f64>, usize) {
    let (mut at, mut digits, mut power, mut any, mut exact) = (0, 0u64, 0i32, false, true);
    let is_negative = bytes.first() == Some(&b'-');
    if is_negative || bytes.first() == Some(&b'+') {
        at = 1;
    }
    let mut behind_point = false;
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'0'..=b'9' => {
                any = true;
                exact &= digits < 100_000_000_000_000_000;
                digits = digits.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
                power = power.saturating_sub(i32::from(behind_point));
            }
            b'.' if !behind_point => behind_point = true,
            b',' if comma == Comma::IsPoint && !behind_point => behind_point = true,
            _ => break,
        }
        at += 1;
    }
    if any && matches!(bytes.get(at), Some(b'e' | b'E')) {
        let (more, len) = exponent(&bytes[at + 1..]);
        exact &= len > 0;
        power = power.saturating_add(more);
        at += 1 + len;
    }
    let is_whole = bytes.get(at).is_none_or(|b| ends_cell(*b, comma));
    if any && is_whole && exact && digits <= 1 << 53 && power.unsigned_abs() <= 22 {
        let by = EXACT[power.unsigned_abs() as usize];
        let value = if power < 0 { digits as f64 / by } else { digits as f64 * by };
        return (Some(if is_negative { -value } else { value }), at);
    }
    let len = at + bytes[at..].iter().position(|b| ends_cell(*b, comma)).unwrap_or(bytes.len() - at);
    (rare(&bytes[..len], comma), len)
}

/// The power behind an `e`, and its length; 0 long where there is none, or one that no double has.
fn exponent(bytes: &[u8]) -> (i32, usize) {
    let sign = usize::from(matches!(bytes.first(), Some(b'-' | b'+')));
    let len = bytes[sign..].iter().take_while(|b| b.is_ascii_digit()).count();
    if len == 0 || len > 4 {
        return (0, 0);
    }
    let value = bytes[sign..sign + len].iter().fold(0, |n, b| n * 10 + i32::from(b - b'0'));
    (if bytes[0] == b'-' { -value } else { value }, sign + len)
}

/// No number is written with more characters.
const LONGEST: usize = 512;

/// A number of many digits, or a word that stands for one: `nan`, `-inf`, and what Microsoft's library writes
/// (`1.#QNAN`, `-nan(ind)`).
fn rare(word: &[u8], comma: Comma) -> Option<f64> {
    let text = std::str::from_utf8(word).ok().filter(|t| t.len() <= LONGEST)?;
    let unsigned = text.trim_start_matches(['-', '+']).as_bytes();
    let begins = |with: &[u8]| unsigned.get(..with.len()).is_some_and(|w| w.eq_ignore_ascii_case(with));
    if begins(b"nan") || begins(b"1.#QNAN") || begins(b"1.#IND") || begins(b"1.#SNAN") {
        return Some(f64::NAN);
    }
    if begins(b"1.#INF") {
        return Some(if word[0] == b'-' { f64::NEG_INFINITY } else { f64::INFINITY });
    }
    if comma == Comma::IsPoint && text.contains(',') {
        return text.replacen(',', ".", 1).parse().ok();
    }
    text.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(text: &str) -> Option<f64> {
        cell(text.as_bytes(), Comma::Delimits).0
    }

    #[test]
    fn words_and_numbers_are_told_apart() {
        assert_eq!(cell(b"-1.5e-3,7", Comma::Delimits), (Some(-0.0015), 7));
        assert_eq!(cell(b"-1,5;7", Comma::IsPoint), (Some(-1.5), 4));
        assert_eq!(cell(b"0,12345678901234567890 7", Comma::IsPoint), (Some(0.123_456_789_012_345_68), 22));
        for none in ["", "x", "1x", "1e", "1.2.3", "-", ".", "e5", "1e99999", "1-2"] {
            assert_eq!(read(none), none.parse().ok(), "{none}");
        }
        for nan in ["nan", "NaN", "-nan(ind)", "1.#QNAN", "-1.#IND"] {
            assert!(read(nan).is_some_and(f64::is_nan), "{nan}");
        }
        assert_eq!(read("-inf"), Some(f64::NEG_INFINITY));
        assert_eq!(read("-1.#INF"), Some(f64::NEG_INFINITY));
        assert_eq!(read("1e400"), Some(f64::INFINITY));
        assert_eq!(read("-0").map(f64::to_bits), Some((-0.0f64).to_bits()));
    }

    proptest! {
        #[test]
        fn every_number_is_that_of_the_standard_library(value in any::<f64>(), places in 0usize..20) {
            for text in [format!("{value}"), format!("{value:e}"), format!("{:.places$}", value % 1e7)] {
                let (found, expected) = (read(&text), text.parse::<f64>().ok());
                prop_assert_eq!(found.map(f64::to_bits), expected.map(f64::to_bits), "{}", text);
            }
        }

        #[test]
        fn what_is_no_number_there_is_none_here(text in "[-+0-9.eE]{0,9}") {
            prop_assert_eq!(read(&text), text.parse::<f64>().ok());
        }
    }
}
