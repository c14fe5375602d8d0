//! What decoders hand on, and how large that may be.

use super::{ImageFileError, LONGEST_SIDE, MOST_PIXELS};

/// The samples of an image, channel by channel, pixel by pixel, row by row.
pub(super) struct Decoded {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) channels: usize,
    pub(super) samples: Samples,
}

/// Samples as they stand in the file.
pub(super) enum Samples {
    Bytes(Vec<u8>),
    Words(Vec<u16>),
    Floats(Vec<f32>),
}

/// Whether an image may be so large, and has pixels at all.
pub(super) fn check_size(width: u64, height: u64, bytes: &[u8], name: &str) -> Result<(), ImageFileError> {
    let file = name.to_owned();
    if width == 0 || height == 0 {
        return Err(ImageFileError::NoImage { file });
    }
    let longest = u64::from(LONGEST_SIDE);
    if width > longest || height > longest || width * height > MOST_PIXELS {
        return Err(ImageFileError::TooLarge { file, bytes: bytes.len() as u64, size: Some([width, height]) });
    }
    Ok(())
}
