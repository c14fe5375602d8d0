//! One recipe as a file: read and checked, and a file name for a new one.

use super::error::RecipeFileError;
use crate::document::recipe::Recipe;
use crate::file;
use std::path::{Path, PathBuf};

/// Files longer than this are no recipes, bytes.
const LONGEST: u64 = 100_000;

/// Reads a recipe.
///
/// # Errors
/// The file cannot be read, or is no sound recipe.
pub(super) fn read(path: &Path) -> Result<Recipe, RecipeFileError> {
    let bytes = std::fs::metadata(path)?.len();
    if bytes > LONGEST {
        return Err(RecipeFileError::TooLong { bytes });
    }
    let bytes = std::fs::read(path)?;
    let recipe: Recipe = file::read_toml(file::decode(&bytes)?)?;
    checked(&recipe)?;
    Ok(recipe)
}

/// Checks that a recipe has a name, and values that recipes hold.
///
/// # Errors
/// It has no name, or a value that cannot be.
pub(super) fn checked(recipe: &Recipe) -> Result<(), RecipeFileError> {
    if recipe.name.trim().is_empty() {
        return Err(RecipeFileError::NoName);
    }
    Ok(recipe.check()?)
}

/// A file of a folder that is not there yet, named after a recipe.
pub(super) fn free_file(folder: &Path, name: &str) -> PathBuf {
    let plain = |c: char| if c.is_alphanumeric() { c } else { '-' };
    let stem: String = name.trim().to_lowercase().chars().map(plain).take(60).collect();
    let named = |k: u32| match k {
        // Never alone: `con` and `nul` are no file names on every system.
        1 => folder.join(format!("recipe-{stem}.toml")),
        _ => folder.join(format!("recipe-{stem}-{k}.toml")),
    };
    (1..).map(named).find(|f| !f.exists()).unwrap_or_else(|| named(1))
}
