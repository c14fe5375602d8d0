//! TIFF by its own reader, which knows floats of one channel: the first image of the file.

use super::samples::{Decoded, Samples, check_size};
use super::{ImageFileError, MOST_PIXELS, WrongPixels, wrong};
use std::io::Cursor;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::{ColorType, TiffError};

/// Decodes the bytes of a TIFF file.
pub(super) fn decoded(bytes: &[u8], name: &str) -> Result<Decoded, ImageFileError> {
    let broken = |e: TiffError| ImageFileError::Broken { file: name.to_owned(), reason: e.to_string() };
    let mut limits = Limits::default();
    limits.decoding_buffer_size = 16 * MOST_PIXELS as usize;
    limits.intermediate_buffer_size = limits.decoding_buffer_size;
    let mut decoder = Decoder::new(Cursor::new(bytes)).map_err(broken)?.with_limits(limits);
    let (width, height) = decoder.dimensions().map_err(broken)?;
    check_size(width.into(), height.into(), bytes, name)?;
    let channels = match decoder.colortype().map_err(broken)? {
        ColorType::Gray(_) => 1,
        ColorType::GrayA(_) => 2,
        ColorType::RGB(_) => 3,
        ColorType::RGBA(_) => 4,
        _ => return Err(wrong(name, WrongPixels::Other)),
    };
    let samples = match decoder.read_image().map_err(broken)? {
        DecodingResult::U8(all) => Samples::Bytes(all),
        DecodingResult::U16(all) => Samples::Words(all),
        DecodingResult::F32(all) => Samples::Floats(all),
        DecodingResult::F64(all) => Samples::Floats(all.into_iter().map(|x| x as f32).collect()),
        _ => return Err(wrong(name, WrongPixels::Other)),
    };
    Ok(Decoded { width: width as usize, height: height as usize, channels, samples })
}
