//! The camera's two images: a grey one (PNG, TIFF, JPEG or PNM of 8 or 16 bits) and one of depths (PNG, PGM or TIFF of 16
//! bits, or TIFF of floats). What a file is, its first bytes tell, not its name. How large an image would become is
//! checked before anything is decoded.
//!
//! Turned or mirrored images are taken as they stand: a camera's figures belong to its pixels. Colour becomes grey with
//! the weights of Rec. 709 on the values as stored; transparency is passed over. What is certainly not the image of a
//! workpiece (one level, half of it white, no depth) is refused here, since nothing can be found on it.

mod check;
mod decode;
mod pgm;
mod samples;
#[cfg(test)]
mod tests;
mod tiff_file;

pub use check::{ImageFault, check_depth, check_grey, check_pair};

use super::raster::{DepthImage, GreyImage, Raster};
use crate::file::{self, FileError};
use crate::part::digest_of;
use crate::progress::{Cancelled, Progress};
use samples::{Decoded, Samples};
use std::path::Path;
use thiserror::Error;

/// The most pixels of an image: 8192 × 4096, beyond any depth camera. Decoded, that is 200 MB at worst.
pub const MOST_PIXELS: u64 = 1 << 25;
/// The longest side of an image, pixels.
pub const LONGEST_SIDE: u32 = 65_535;
/// The most bytes of a file: MOST_PIXELS of three floats.
const MOST_BYTES: u64 = 12 * MOST_PIXELS + (1 << 20);
/// Weights of red, green and blue, Rec. 709.
const REC_709: [f32; 3] = [0.2126, 0.7152, 0.0722];
/// 16 bits to levels: 65 535 / 255.
const WORDS_PER_LEVEL: f32 = 257.0;

/// An image and the file it is of.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageFile {
    /// Levels from 0 to 255, or depths in the file's units.
    pub image: Raster<f32>,
    /// SHA-256 of the file's bytes, hexadecimal.
    pub sha256: String,
}

/// Why a file is no image that can be used.
#[derive(Debug, Error)]
pub enum ImageFileError {
    /// It cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// It, or its image, is too large.
    #[error("{file}: {bytes} bytes, image of {size:?}")]
    TooLarge {
        /// The file.
        file: String,
        /// Its bytes.
        bytes: u64,
        /// Width and height; `None`: it was not looked into.
        size: Option<[u64; 2]>,
    },
    /// It is none of the kinds of images.
    #[error("{file}: no image")]
    NoImage {
        /// The file.
        file: String,
    },
    /// It begins as an image, and cannot be decoded.
    #[error("{file}: {reason}")]
    Broken {
        /// The file.
        file: String,
        /// What the reader says, in English.
        reason: String,
    },
    /// Its pixels are not of a kind that is read.
    #[error("{file}: {kind:?}")]
    Pixels {
        /// The file.
        file: String,
        /// What they are.
        kind: WrongPixels,
    },
    /// Nothing can be found on it.
    #[error("{file}: {fault}")]
    Fault {
        /// The file.
        file: String,
        /// Why.
        fault: ImageFault,
    },
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

/// Pixels that are not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WrongPixels {
    /// Depths of 8 bits: 256 steps are no measurement; often a picture of a depth image.
    EightBitDepth,
    /// Depths in colour: a picture of a depth image.
    DepthInColour,
    /// Grey levels as floats: nothing says which of them is white.
    FloatGrey,
    /// Another kind, such as palettes or 32-bit whole numbers.
    Other,
}

impl From<Cancelled> for ImageFileError {
    fn from(_: Cancelled) -> ImageFileError {
        ImageFileError::Cancelled
    }
}

/// Reads a grey image.
///
/// # Errors
/// There is none in the file, or nothing can be found on it.
pub fn read_grey(path: &Path, progress: &Progress) -> Result<ImageFile, ImageFileError> {
    let (bytes, name) = (bytes(path)?, path.display().to_string());
    progress.check()?;
    Ok(ImageFile { image: grey_from_bytes(&bytes, &name, progress)?, sha256: digest_of(&bytes) })
}

/// Reads a depth image.
///
/// # Errors
/// There is none in the file, or it has no depth anywhere.
pub fn read_depth(path: &Path, progress: &Progress) -> Result<ImageFile, ImageFileError> {
    let (bytes, name) = (bytes(path)?, path.display().to_string());
    progress.check()?;
    Ok(ImageFile { image: depth_from_bytes(&bytes, &name, progress)?, sha256: digest_of(&bytes) })
}

fn bytes(path: &Path) -> Result<Vec<u8>, ImageFileError> {
    let bytes = std::fs::metadata(path).map_or(0, |m| m.len());
    if bytes > MOST_BYTES {
        return Err(ImageFileError::TooLarge { file: path.display().to_string(), bytes, size: None });
    }
    Ok(file::bytes(path)?)
}

/// The grey image of a file's bytes; `name` is what the file is called.
///
/// # Errors
/// As [`read_grey`].
pub fn grey_from_bytes(bytes: &[u8], name: &str, progress: &Progress) -> Result<GreyImage, ImageFileError> {
    let Decoded { width, height, channels, samples } = decode::decoded(bytes, name)?;
    progress.check()?;
    let levels = match samples {
        Samples::Bytes(all) => levels(&all, channels, 1.0),
        Samples::Words(all) => levels(&all, channels, WORDS_PER_LEVEL),
        Samples::Floats(_) => return Err(wrong(name, WrongPixels::FloatGrey)),
    };
    let image = Raster::new(width, height, levels).ok_or_else(|| wrong(name, WrongPixels::Other))?;
    check_grey(&image).map_err(|fault| ImageFileError::Fault { file: name.to_owned(), fault })?;
    Ok(image)
}

/// The depth image of a file's bytes; `name` is what the file is called.
///
/// # Errors
/// As [`read_depth`].
pub fn depth_from_bytes(bytes: &[u8], name: &str, progress: &Progress) -> Result<DepthImage, ImageFileError> {
    let Decoded { width, height, channels, samples } = match pgm::unscaled(bytes, name)? {
        Some(decoded) => decoded,
        None => decode::decoded(bytes, name)?,
    };
    progress.check()?;
    let depths = match samples {
        _ if channels > 1 => return Err(wrong(name, WrongPixels::DepthInColour)),
        Samples::Bytes(_) => return Err(wrong(name, WrongPixels::EightBitDepth)),
        Samples::Words(all) => all.into_iter().map(f32::from).collect(),
        Samples::Floats(all) => all,
    };
    let image = Raster::new(width, height, depths).ok_or_else(|| wrong(name, WrongPixels::Other))?;
    check_depth(&image).map_err(|fault| ImageFileError::Fault { file: name.to_owned(), fault })?;
    Ok(image)
}

fn wrong(name: &str, kind: WrongPixels) -> ImageFileError {
    ImageFileError::Pixels { file: name.to_owned(), kind }
}

/// Grey levels of pixels of one to four channels; the second of two and the fourth of four are transparency.
fn levels<T: Copy + Into<f32>>(samples: &[T], channels: usize, per_level: f32) -> Vec<f32> {
    let grey = |pixel: &[T]| match pixel {
        [r, g, b, ..] => [r, g, b].into_iter().zip(REC_709).map(|(x, w)| w * (*x).into()).sum::<f32>(),
        [grey, ..] => (*grey).into(),
        [] => 0.0,
    };
    samples.chunks_exact(channels.max(1)).map(|pixel| grey(pixel) / per_level).collect()
}
