//! Why the library of recipes cannot be changed, and why a file of it is no recipe.

use super::document::path;
use super::{Sentence, say};
use crate::document::library::{BrokenRecipe, LibraryError, RecipeFileError};

impl Sentence for LibraryError {
    fn sentence(&self) -> String {
        match self {
            LibraryError::NoFolder => say!(library_no_folder),
            LibraryError::Folder { folder, source } => {
                say!(library_folder_not_made, folder = path(folder), reason = source.to_string())
            }
            LibraryError::Recipe(e) => e.sentence(),
            LibraryError::Unwritable { name, source } => {
                say!(library_not_serialized, name, reason = source.to_string())
            }
            LibraryError::Write(e) => e.sentence(),
            LibraryError::Unknown { name } => say!(library_unknown, name),
            LibraryError::Rename { file, source } => {
                say!(library_not_renamed, file = path(file), reason = source.to_string())
            }
            LibraryError::Taken { name } => say!(library_taken, name),
        }
    }
}

impl Sentence for BrokenRecipe {
    fn sentence(&self) -> String {
        say!(library_broken, file = path(&self.file), why = self.why.sentence())
    }
}

impl Sentence for RecipeFileError {
    fn sentence(&self) -> String {
        match self {
            RecipeFileError::Read(source) => say!(recipe_not_read, reason = source.to_string()),
            RecipeFileError::TooLong { bytes } => say!(recipe_too_long, bytes = *bytes),
            RecipeFileError::NoText(e) => e.sentence(),
            RecipeFileError::Toml(e) => e.sentence(),
            RecipeFileError::NoName => say!(recipe_no_name),
            RecipeFileError::NameTaken { name, other } => say!(recipe_name_taken, name, other = path(other)),
            RecipeFileError::Value(e) => e.sentence(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Library;

    #[test]
    fn a_broken_file_is_named_with_what_is_wrong_and_what_to_do() {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("writes");
        write("a.toml", "name = \"Good\"\n");
        write("b.toml", "name = ");
        write("c.toml", "name = \"Good\"\n");
        write("d.toml", "note = \"nameless\"\n");
        write("e.toml", &"#".repeat(100_001));
        let library = Library::open(Some(folder.path().to_path_buf()));
        let said = ["b.toml: line 1: name: ", "is also that of ", "has no name", "100 001 bytes are more"];
        assert_eq!(library.broken.len(), said.len());
        for (broken, part) in library.broken.iter().zip(said) {
            let line = broken.sentence();
            assert!(line.contains(part) && line.ends_with("; correct or remove the file"), "{line}");
            assert_eq!(line.lines().count(), 1, "{line}");
        }
    }
}
