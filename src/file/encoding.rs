//! Bytes as text. Everything that people write for clearbeam is UTF-8; what editors put out beside that is told by
//! what it looks like.

use thiserror::Error;

/// Why bytes are no text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum NoText {
    /// They are UTF-16, as some editors call *Unicode*.
    #[error("UTF-16")]
    Utf16,
    /// A byte that no UTF-8 has there: a letter of an older encoding, such as Latin-1, or no text at all.
    #[error("line {line}: byte {byte:#04x}")]
    Byte {
        /// The line, from 1.
        line: usize,
        /// The byte.
        byte: u8,
    },
}

/// The text of bytes, without the mark that some editors put in front of it.
///
/// # Errors
/// They are no UTF-8.
pub(super) fn decode(bytes: &[u8]) -> Result<&str, NoText> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(NoText::Utf16);
    }
    match std::str::from_utf8(bytes) {
        // Plain letters in UTF-16 are every second byte 0, which is UTF-8 as well, and nobody's text.
        Ok(text) if text.contains('\0') => Err(NoText::Utf16),
        Ok(text) => Ok(text.strip_prefix('\u{feff}').unwrap_or(text)),
        Err(e) => {
            let (before, rest) = bytes.split_at(e.valid_up_to().min(bytes.len()));
            let line = before.iter().filter(|b| **b == b'\n').count() + 1;
            Err(NoText::Byte { line, byte: rest.first().copied().unwrap_or_default() })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_told_from_what_is_none() {
        assert_eq!(decode("\u{feff}a = 1".as_bytes()), Ok("a = 1"));
        assert_eq!(decode("größe = 1".as_bytes()), Ok("größe = 1"));
        assert_eq!(decode(b"a = 1\n# gr\xf6\xdfe\n"), Err(NoText::Byte { line: 2, byte: 0xf6 }));
        let wide = |order: fn(u16) -> [u8; 2], mark: &str| -> Vec<u8> {
            format!("{mark}a = 1").encode_utf16().flat_map(order).collect()
        };
        for bytes in
            [wide(u16::to_le_bytes, "\u{feff}"), wide(u16::to_be_bytes, "\u{feff}"), wide(u16::to_le_bytes, "")]
        {
            assert_eq!(decode(&bytes), Err(NoText::Utf16));
        }
    }
}
