//! Why the library of recipes cannot be changed, and why a file of it is no recipe.

use crate::document::RecipeError;
use crate::document::files::JobError;
use crate::file::{NoText, TomlError};
use std::path::PathBuf;
use thiserror::Error;

/// Why the library cannot be changed.
#[derive(Debug, Error)]
pub enum LibraryError {
    /// There is nowhere to keep recipes.
    #[error("no folder for recipes")]
    NoFolder,
    /// The folder cannot be made.
    #[error("{}: not made", .folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The recipe is not fit to be kept.
    #[error(transparent)]
    Recipe(#[from] RecipeFileError),
    /// The recipe cannot be turned into TOML.
    #[error("recipe {name:?} not serialized")]
    Unwritable {
        /// Name of the recipe.
        name: String,
        /// What the serializer said.
        source: toml::ser::Error,
    },
    /// Its file cannot be written.
    #[error(transparent)]
    Write(#[from] JobError),
    /// There is no recipe of that name among the user's.
    #[error("no recipe {name:?}")]
    Unknown {
        /// The name.
        name: String,
    },
    /// Its file cannot be put away, or back.
    #[error("{}: not renamed", .file.display())]
    Rename {
        /// The file.
        file: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Meanwhile another recipe has its place.
    #[error("recipe {name:?}: place taken")]
    Taken {
        /// The name.
        name: String,
    },
}

/// A file of the library's folder that is no recipe.
#[derive(Debug)]
pub struct BrokenRecipe {
    /// The file.
    pub file: PathBuf,
    /// What is wrong with it.
    pub why: RecipeFileError,
}

/// Why a file is no recipe that the library can take.
#[derive(Debug, Error)]
pub enum RecipeFileError {
    /// It cannot be read.
    #[error("not read")]
    Read(#[from] std::io::Error),
    /// It is longer than a recipe can be.
    #[error("{bytes} bytes")]
    TooLong {
        /// Its length.
        bytes: u64,
    },
    /// It is no text.
    #[error(transparent)]
    NoText(#[from] NoText),
    /// It is no TOML, or has a key that no recipe has.
    #[error(transparent)]
    Toml(#[from] TomlError),
    /// The recipe has no name.
    #[error("no name")]
    NoName,
    /// Another recipe of the library has its name.
    #[error("name {name:?} taken")]
    NameTaken {
        /// The name.
        name: String,
        /// File of the other.
        other: PathBuf,
    },
    /// A value that recipes do not hold, or that is out of range.
    #[error(transparent)]
    Value(#[from] RecipeError),
}
