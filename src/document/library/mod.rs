//! Recipes that outlive a job: shipped ones, and those that the user keeps in a folder, a file each.

mod error;
mod recipe_file;

pub use error::{BrokenRecipe, LibraryError, RecipeFileError};

use super::files::write_atomic;
use super::recipe::Recipe;
use recipe_file::{checked, free_file};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// The shipped recipes.
const SHIPPED: [&str; 4] = [
    include_str!("../../../assets/recipes/cleaning.toml"),
    include_str!("../../../assets/recipes/layers.toml"),
    include_str!("../../../assets/recipes/remanufacturing.toml"),
    include_str!("../../../assets/recipes/grinding.toml"),
];

/// The recipes at hand beside those of a job.
#[derive(Debug, Default)]
pub struct Library {
    /// Where the user's are kept; `None`: nowhere.
    folder: Option<PathBuf>,
    /// Shipped ones.
    pub shipped: Vec<Recipe>,
    /// The user's with their files, by file name.
    pub kept: Vec<(PathBuf, Recipe)>,
    /// Files of the folder that are no recipes.
    pub broken: Vec<BrokenRecipe>,
}

/// A recipe that was taken out of the library, and can come back.
#[derive(Clone, Debug, PartialEq)]
pub struct Forgotten {
    /// The recipe.
    pub recipe: Recipe,
    /// Where its file was.
    file: PathBuf,
}

impl Forgotten {
    /// Where the file is now: not removed, under a name that no library reads.
    fn removed_file(&self) -> PathBuf {
        let mut name: OsString = self.file.clone().into();
        name.push(".removed");
        name.into()
    }
}

impl Library {
    /// Reads shipped recipes and those of a folder, which need not be there yet.
    pub fn open(folder: Option<PathBuf>) -> Library {
        let shipped = SHIPPED.iter().filter_map(|text| toml::from_str(text).ok()).collect();
        let mut library = Library { folder, shipped, ..Library::default() };
        library.read_folder();
        library
    }

    /// Where the user's recipes are kept.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// Keeps a recipe in the user's folder, in place of the one of its name.
    ///
    /// # Errors
    /// What is wrong with it, or why its file cannot be written.
    pub fn keep(&mut self, recipe: &Recipe) -> Result<PathBuf, LibraryError> {
        let recipe = recipe.without_places();
        checked(&recipe)?;
        let folder = self.folder.clone().ok_or(LibraryError::NoFolder)?;
        std::fs::create_dir_all(&folder).map_err(|source| LibraryError::Folder { folder: folder.clone(), source })?;
        let known = self.kept.iter().find(|(_, r)| r.name == recipe.name).map(|(file, _)| file.clone());
        let file = known.unwrap_or_else(|| free_file(&folder, &recipe.name));
        let unwritable = |source| LibraryError::Unwritable { name: recipe.name.clone(), source };
        let text = toml::to_string(&recipe).map_err(unwritable)?;
        write_atomic(&file, text.as_bytes())?;
        self.read_folder();
        Ok(file)
    }

    /// Takes a recipe out of the library. Its file stays, with `.removed` behind its name, until another
    /// of that name is forgotten.
    ///
    /// # Errors
    /// It is none of the user's, or its file cannot be renamed.
    pub fn forget(&mut self, name: &str) -> Result<Forgotten, LibraryError> {
        let found = self.kept.iter().find(|(_, r)| r.name == name);
        let (file, recipe) = found.cloned().ok_or_else(|| LibraryError::Unknown { name: name.to_owned() })?;
        let forgotten = Forgotten { recipe, file };
        rename(&forgotten.file, &forgotten.removed_file())?;
        self.read_folder();
        Ok(forgotten)
    }

    /// Puts a forgotten recipe back, to the byte.
    ///
    /// # Errors
    /// Another has its place meanwhile, or its file cannot be renamed.
    pub fn bring_back(&mut self, forgotten: &Forgotten) -> Result<(), LibraryError> {
        let name = &forgotten.recipe.name;
        self.read_folder();
        if forgotten.file.exists() || self.kept.iter().any(|(_, r)| r.name == *name) {
            return Err(LibraryError::Taken { name: name.clone() });
        }
        rename(&forgotten.removed_file(), &forgotten.file)?;
        self.read_folder();
        Ok(())
    }

    fn read_folder(&mut self) {
        (self.kept, self.broken) = (Vec::new(), Vec::new());
        let entries = self.folder.iter().filter_map(|f| std::fs::read_dir(f).ok()).flatten().filter_map(Result::ok);
        let is_toml = |p: &PathBuf| p.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
        let mut files: Vec<PathBuf> = entries.map(|e| e.path()).filter(is_toml).collect();
        files.sort();
        for file in files {
            match self.read_new(&file) {
                Ok(recipe) => self.kept.push((file, recipe)),
                Err(why) => self.broken.push(BrokenRecipe { file, why }),
            }
        }
    }

    /// Reads a file whose recipe has a name that no other has.
    fn read_new(&self, file: &Path) -> Result<Recipe, RecipeFileError> {
        let recipe = recipe_file::read(file)?;
        match self.kept.iter().find(|(_, r)| r.name == recipe.name) {
            Some((other, _)) => Err(RecipeFileError::NameTaken { name: recipe.name, other: other.clone() }),
            None => Ok(recipe),
        }
    }
}

fn rename(from: &Path, to: &Path) -> Result<(), LibraryError> {
    std::fs::rename(from, to).map_err(|source| LibraryError::Rename { file: from.to_path_buf(), source })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::RecipeError;
    use crate::document::StartFrom;
    use crate::path::{Direction, Order, Strategy};

    fn full() -> Recipe {
        Recipe {
            name: "Dichtfläche / fein".into(),
            note: "slow".into(),
            strategy: Some(Strategy::Spiral),
            direction: Some(Direction::Auto),
            order: Some(Order::Shortest),
            border: Some(StartFrom::Border(1)),
            centre_mm: Some([1.0, 2.0, 3.0]),
            inward: Some(true),
            values: [("layers.spacing_mm".to_owned(), 0.25), ("beam.power_w".to_owned(), 300.0)].into(),
        }
    }

    #[test]
    fn shipped_recipes_are_sound_and_change_a_job() {
        let library = Library::open(None);
        assert_eq!(library.shipped.len(), SHIPPED.len());
        for r in &library.shipped {
            assert!(checked(r).is_ok(), "{}", r.name);
            assert!(!r.note.is_empty() && !r.values.is_empty(), "{}", r.name);
        }
        let p2 = library.shipped[1].applied(&crate::document::Job::default());
        assert_eq!((p2.layers.spacing_mm, p2.beam.defocus_mm, p2.path.chord_error_mm), (6.0, 15.0, 0.5));
    }

    #[test]
    fn what_is_kept_comes_back_without_the_places_of_a_part() {
        let home = tempfile::tempdir().expect("a folder");
        let folder = home.path().join("clearbeam/recipes");
        let mut library = Library::open(Some(folder.clone()));
        assert!(library.kept.is_empty() && library.broken.is_empty(), "no folder is no fault");
        let file = library.keep(&full()).expect("keeps");
        let again = Library::open(Some(folder.clone()));
        assert_eq!(again.kept, [(file.clone(), full().without_places())]);
        // The same name is the same file; another that is spelt alike is not.
        library.keep(&Recipe { note: "slower".into(), ..full() }).expect("keeps");
        assert_eq!(library.kept.len(), 1);
        let alike = Recipe { name: "Dichtfläche - fein".into(), ..full() };
        assert_ne!(library.keep(&alike).expect("keeps"), file);
        assert_eq!(library.kept.len(), 2);
        library.forget("Dichtfläche / fein").expect("removes");
        assert_eq!(Library::open(Some(folder)).kept[0].1.name, alike.name);
    }

    #[test]
    fn what_is_forgotten_can_come_back_to_the_byte() {
        let folder = tempfile::tempdir().expect("a folder");
        let mut library = Library::open(Some(folder.path().to_path_buf()));
        let file = library.keep(&full()).expect("keeps");
        let text = format!("# by hand\n{}", std::fs::read_to_string(&file).expect("reads"));
        std::fs::write(&file, &text).expect("writes");
        let forgotten = library.forget(&full().name).expect("forgets");
        assert_eq!(forgotten.recipe, full().without_places());
        assert!(library.kept.is_empty() && library.broken.is_empty() && !file.exists());
        assert!(matches!(library.forget(&full().name), Err(LibraryError::Unknown { .. })));
        library.bring_back(&forgotten).expect("comes back");
        assert_eq!(library.kept, [(file.clone(), full().without_places())]);
        assert_eq!(std::fs::read_to_string(&file).expect("reads"), text);
        // Another that has its place meanwhile stays.
        let forgotten = library.forget(&full().name).expect("forgets");
        let other = Recipe { note: "another".into(), ..full() };
        library.keep(&other).expect("keeps");
        assert!(matches!(library.bring_back(&forgotten), Err(LibraryError::Taken { .. })));
        assert_eq!(library.kept, [(file, other.without_places())]);
    }

    #[test]
    fn broken_files_are_told_and_skipped() {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("writes");
        write("a.toml", "name = \"Good\"\n[values]\n\"beam.power_w\" = 300.0\n");
        write("b.toml", "name = ");
        write("c.toml", "name = \"Key\"\n[values]\n\"cell.deviation_mm\" = 1.0\n");
        write("d.toml", "name = \"Range\"\n[values]\n\"layers.spacing_mm\" = -1.0\n");
        write("e.toml", "name = \"Good\"\n");
        write("f.toml", "[values]\n");
        write("notes.txt", "no recipe");
        let library = Library::open(Some(folder.path().to_path_buf()));
        assert_eq!(library.kept.len(), 1);
        let broken: Vec<_> = library.broken.iter().map(|b| (b.file.clone(), &b.why)).collect();
        let file = |name: &str| folder.path().join(name);
        let [
            (b, RecipeFileError::Toml(_)),
            (c, RecipeFileError::Value(key)),
            (d, RecipeFileError::Value(value)),
            (e, taken),
            (f, RecipeFileError::NoName),
        ] = &broken[..]
        else {
            panic!("{broken:?}")
        };
        assert_eq!([b, c, d, e, f], ["b.toml", "c.toml", "d.toml", "e.toml", "f.toml"].map(file).each_ref());
        assert!(matches!(key, RecipeError::NotForRecipes { key, .. } if key == "cell.deviation_mm"), "{key:?}");
        assert!(matches!(value, RecipeError::Number { recipe, .. } if recipe == "Range"), "{value:?}");
        let other = file("a.toml");
        assert!(matches!(taken, RecipeFileError::NameTaken { name, other: of } if name == "Good" && *of == other));
    }
}
