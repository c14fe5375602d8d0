//! 3MF files: an archive ([`package`]) of models in XML ([`model`]). The part is what the build of the main model
//! names, each object where its transforms put it; objects that are not built are counted.

mod build;
mod model;
mod package;

use super::PartFileError;
use crate::part::raw_part::RawPart;
use crate::progress::Progress;
use build::Build;
use package::Package;

/// More is not unpacked of all models together. A triangle takes some 70 bytes with its share of the vertices, so this
/// is a part of three to four million facets; an archive of a few kilobytes can say that it holds terabytes.
const MOST_MIB: u64 = 256;

/// Parses an archive as a 3MF file; `None`: it is another archive.
///
/// # Errors
/// It is damaged, or a model that cannot be read; [`PartFileError::Cancelled`] when `progress` says so.
pub(super) fn read(bytes: &[u8], progress: &Progress) -> Result<Option<RawPart>, PartFileError> {
    let mut package = Package::open(bytes, MOST_MIB, progress)?;
    let Some(main) = package.main_model()? else { return Ok(None) };
    Ok(Some(Build::of(&mut package, &main)?))
}

#[cfg(test)]
mod tests;
