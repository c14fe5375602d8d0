//! Numbers as people and programs of other countries write them.

/// Whether a number is written with a comma in the place of its point.
pub(super) fn has_decimal_comma(word: &[u8]) -> bool {
    let digits = |pair: &[u8]| pair[0].is_ascii_digit() && pair[1] == b',' && pair[2].is_ascii_digit();
    !word.contains(&b'.') && word.windows(3).any(digits)
}
