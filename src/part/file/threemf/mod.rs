//! 3MF files: an archive ([`package`]) of models in XML ([`model`]). The part is what the build of the main model names,
//! each object where its transforms put it; objects that are not built are counted.

mod build;
mod model;
mod package;

use super::PartFileError;
use crate::part::raw_part::RawPart;
use build::Build;
use package::Package;

/// What is wrong with a 3MF file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ThreeMfFault {
    /// The archive is damaged or cut off.
    Archive,
    /// An entry of the archive that is needed is not there.
    NoEntry {
        /// Its name.
        entry: String,
    },
    /// An entry cannot be unpacked: it is damaged, encrypted, or packed in another way than 3MF allows.
    Unreadable {
        /// Its name.
        entry: String,
    },
    /// Unpacked, the models are larger than is read.
    TooLarge {
        /// The most that is read, MiB.
        most_mib: u64,
    },
    /// An entry is no XML.
    Xml {
        /// Its name.
        entry: String,
        /// The line where it is none, from 1.
        line: u32,
    },
    /// A model has a unit that the format does not know.
    Unit {
        /// The word.
        word: String,
    },
    /// Models of one file have different units.
    UnitsDiffer,
    /// The model says that it is not to be read without an extension that is not known here.
    Extension {
        /// Its name.
        name: String,
    },
    /// Something of an object cannot be read: an attribute is missing or no number.
    Value {
        /// The element that has it.
        element: String,
        /// Where it stands in its entry, from 1.
        line: u32,
    },
    /// A triangle has a vertex that is not there.
    NoSuchVertex {
        /// Its object.
        object: u32,
        /// Vertices that are there.
        vertices: usize,
    },
    /// An object is named that is not there.
    NoSuchObject {
        /// Its number.
        object: u32,
    },
    /// Objects are made of each other, or of others in too many steps.
    TooDeep,
    /// Objects are repeated more often than is read.
    TooManyObjects {
        /// The most that are read.
        most: usize,
    },
    /// Objects are repeated so often that the facets are more than are read.
    TooManyFacets {
        /// The most that are read.
        most: usize,
    },
}

/// More is not unpacked of all models together. A triangle takes some 70 bytes with its share of the vertices, so this
/// is a part of three to four million facets; an archive of a few kilobytes can say that it holds terabytes.
const MOST_MIB: u64 = 256;

/// Parses an archive as a 3MF file; `None`: it is another archive.
///
/// # Errors
/// It is damaged, or a model that cannot be read.
pub(super) fn read(bytes: &[u8]) -> Result<Option<RawPart>, PartFileError> {
    let mut package = Package::open(bytes, MOST_MIB)?;
    let Some(main) = package.main_model()? else { return Ok(None) };
    Ok(Some(Build::of(&mut package, &main)?))
}

#[cfg(test)]
mod tests;
