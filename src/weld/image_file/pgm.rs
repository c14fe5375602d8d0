//! PGM of depths as they stand: a general reader stretches them when the greatest one that the head names is not 65 535.

use super::ImageFileError;
use super::samples::{Decoded, Samples, check_size};

/// The samples of a grey PNM file as they stand; `None` for any other file. In one byte each, or two where the head
/// names a greatest one above 255.
pub(super) fn unscaled(bytes: &[u8], name: &str) -> Result<Option<Decoded>, ImageFileError> {
    let is_text = match bytes {
        [b'P', b'2', ..] => true,
        [b'P', b'5', ..] => false,
        _ => return Ok(None),
    };
    let broken = |reason: &str| ImageFileError::Broken { file: name.to_owned(), reason: reason.to_owned() };
    let mut words = Words { rest: bytes.get(2..).unwrap_or_default() };
    let head = [words.number(), words.number(), words.number()];
    let [Some(width), Some(height), Some(greatest @ 1..=65_535)] = head else {
        return Err(broken("no width, height and greatest value"));
    };
    check_size(width, height, bytes, name)?;
    let count = (width * height) as usize;
    let is_wide = greatest > 255;
    let values: Vec<u16> = if is_text {
        // Each value takes two bytes at least.
        if words.rest.len() / 2 + 1 < count {
            return Err(broken("ends inside of the image"));
        }
        (0..count).map_while(|_| words.number().and_then(|n| u16::try_from(n).ok())).collect()
    } else {
        // One blank ends the head.
        let data = words.rest.get(1..).unwrap_or_default();
        if is_wide {
            data.chunks_exact(2).take(count).filter_map(|b| b.try_into().ok().map(u16::from_be_bytes)).collect()
        } else {
            data.iter().take(count).map(|b| u16::from(*b)).collect()
        }
    };
    if values.len() < count {
        return Err(broken("ends inside of the image"));
    }
    let samples =
        if is_wide { Samples::Words(values) } else { Samples::Bytes(values.into_iter().map(|x| x as u8).collect()) };
    Ok(Some(Decoded { width: width as usize, height: height as usize, channels: 1, samples }))
}

/// Numbers with blanks and comments between them.
struct Words<'b> {
    rest: &'b [u8],
}

impl Words<'_> {
    fn number(&mut self) -> Option<u64> {
        loop {
            match self.rest {
                [b'#', ..] => {
                    let end = self.rest.iter().position(|b| *b == b'\n')?;
                    self.rest = self.rest.get(end..)?;
                }
                [b, rest @ ..] if b.is_ascii_whitespace() => self.rest = rest,
                _ => break,
            }
        }
        let digits = self.rest.iter().take_while(|b| b.is_ascii_digit()).count();
        let (number, rest) = self.rest.split_at_checked(digits)?;
        self.rest = rest;
        std::str::from_utf8(number).ok()?.parse().ok()
    }
}
