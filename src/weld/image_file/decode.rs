//! An image file as samples: PNG, JPEG and PNM here, TIFF beside. Sizes are looked at before pixels are.

use super::samples::{Decoded, Samples, check_size};
use super::{ImageFileError, MOST_PIXELS, WrongPixels, tiff_file, wrong};
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};
use std::io::Cursor;

/// The most memory that a decoder takes, bytes: three channels of 16 bits, and as much again to work in.
const MOST_MEMORY: u64 = 12 * MOST_PIXELS;

/// Decodes a file's bytes.
pub(super) fn decoded(bytes: &[u8], name: &str) -> Result<Decoded, ImageFileError> {
    let format = image::guess_format(bytes).ok();
    match format {
        Some(ImageFormat::Tiff) => tiff_file::decoded(bytes, name),
        Some(format @ (ImageFormat::Png | ImageFormat::Jpeg | ImageFormat::Pnm)) => of_format(bytes, format, name),
        _ => Err(ImageFileError::NoImage { file: name.to_owned() }),
    }
}

fn of_format(bytes: &[u8], format: ImageFormat, name: &str) -> Result<Decoded, ImageFileError> {
    let broken = |e: image::ImageError| ImageFileError::Broken { file: name.to_owned(), reason: e.to_string() };
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(MOST_MEMORY);
    reader.limits(limits);
    let decoder = reader.into_decoder().map_err(broken)?;
    let (width, height) = decoder.dimensions();
    check_size(width.into(), height.into(), bytes, name)?;
    let decoded = DynamicImage::from_decoder(decoder).map_err(broken)?;
    let channels = usize::from(decoded.color().channel_count());
    let samples = match decoded {
        DynamicImage::ImageLuma8(b) => Samples::Bytes(b.into_raw()),
        DynamicImage::ImageLumaA8(b) => Samples::Bytes(b.into_raw()),
        DynamicImage::ImageRgb8(b) => Samples::Bytes(b.into_raw()),
        DynamicImage::ImageRgba8(b) => Samples::Bytes(b.into_raw()),
        DynamicImage::ImageLuma16(b) => Samples::Words(b.into_raw()),
        DynamicImage::ImageLumaA16(b) => Samples::Words(b.into_raw()),
        DynamicImage::ImageRgb16(b) => Samples::Words(b.into_raw()),
        DynamicImage::ImageRgba16(b) => Samples::Words(b.into_raw()),
        _ => return Err(wrong(name, WrongPixels::Other)),
    };
    Ok(Decoded { width: width as usize, height: height as usize, channels, samples })
}
