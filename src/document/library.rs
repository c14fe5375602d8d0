//! Recipes that outlive a job: shipped ones, and those that the user keeps in a folder, a file each.

use super::files::{JobError, write_atomic};
use super::recipe::Recipe;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The shipped recipes.
const SHIPPED: [&str; 4] = [
    include_str!("../../assets/recipes/cleaning.toml"),
    include_str!("../../assets/recipes/layers.toml"),
    include_str!("../../assets/recipes/remanufacturing.toml"),
    include_str!("../../assets/recipes/grinding.toml"),
];

/// Files longer than this are no recipes, bytes.
const LONGEST: u64 = 100_000;

/// The recipes at hand beside those of a job.
#[derive(Clone, Debug, Default)]
pub struct Library {
    /// Where the user's are kept; `None`: nowhere.
    folder: Option<PathBuf>,
    /// Shipped ones.
    pub shipped: Vec<Recipe>,
    /// The user's, by file name.
    pub own: Vec<(PathBuf, Recipe)>,
    /// Files of the folder that are no recipes: which, why, what to do.
    pub broken: Vec<String>,
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
    fn put_away(&self) -> PathBuf {
        let mut name: OsString = self.file.clone().into();
        name.push(".removed");
        name.into()
    }
}

/// Why the library cannot be changed.
#[derive(Debug, Error)]
pub enum LibraryError {
    /// There is nowhere to keep recipes.
    #[error("no folder for recipes is known: set HOME")]
    NoFolder,
    /// The folder cannot be made.
    #[error("{}: cannot be made: {source}; choose another HOME", .folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The recipe is not fit to be kept.
    #[error("{0}")]
    Recipe(String),
    /// Its file cannot be written.
    #[error(transparent)]
    Write(#[from] JobError),
    /// There is no recipe of that name among the user's.
    #[error("there is no recipe {name:?} among your own")]
    Unknown {
        /// The name.
        name: String,
    },
    /// Its file cannot be put away, or back.
    #[error("{}: cannot be renamed: {source}; look at who may write there", .file.display())]
    Rename {
        /// The file.
        file: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Meanwhile another recipe has its place.
    #[error("recipe {name:?} cannot come back: there is another in its place; rename or remove that first")]
    Taken {
        /// The name.
        name: String,
    },
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
        checked(&recipe).map_err(LibraryError::Recipe)?;
        let folder = self.folder.clone().ok_or(LibraryError::NoFolder)?;
        std::fs::create_dir_all(&folder).map_err(|source| LibraryError::Folder { folder: folder.clone(), source })?;
        let known = self.own.iter().find(|(_, r)| r.name == recipe.name).map(|(file, _)| file.clone());
        let file = known.unwrap_or_else(|| free_file(&folder, &recipe.name));
        let text = toml::to_string(&recipe)
            .map_err(|e| LibraryError::Recipe(format!("recipe {:?}: cannot be written: {e}", recipe.name)))?;
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
        let found = self.own.iter().find(|(_, r)| r.name == name);
        let (file, recipe) = found.cloned().ok_or_else(|| LibraryError::Unknown { name: name.to_owned() })?;
        let forgotten = Forgotten { recipe, file };
        rename(&forgotten.file, &forgotten.put_away())?;
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
        if forgotten.file.exists() || self.own.iter().any(|(_, r)| r.name == *name) {
            return Err(LibraryError::Taken { name: name.clone() });
        }
        rename(&forgotten.put_away(), &forgotten.file)?;
        self.read_folder();
        Ok(())
    }

    fn read_folder(&mut self) {
        (self.own, self.broken) = (Vec::new(), Vec::new());
        let entries = self.folder.iter().filter_map(|f| std::fs::read_dir(f).ok()).flatten().filter_map(Result::ok);
        let is_toml = |p: &PathBuf| p.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
        let mut files: Vec<PathBuf> = entries.map(|e| e.path()).filter(is_toml).collect();
        files.sort();
        for file in files {
            let taken = |recipe: Recipe| match self.own.iter().find(|(_, r)| r.name == recipe.name) {
                Some((other, _)) => Err(format!("its name {:?} is that of {} too", recipe.name, other.display())),
                None => Ok(recipe),
            };
            match read(&file).and_then(taken) {
                Ok(recipe) => self.own.push((file, recipe)),
                Err(why) => self.broken.push(format!("{}: {why}; mend or remove the file", file.display())),
            }
        }
    }
}

fn rename(from: &Path, to: &Path) -> Result<(), LibraryError> {
    std::fs::rename(from, to).map_err(|source| LibraryError::Rename { file: from.to_path_buf(), source })
}

/// Reads one file.
fn read(file: &Path) -> Result<Recipe, String> {
    let length = std::fs::metadata(file).map_err(|e| format!("cannot be read: {e}"))?.len();
    if length > LONGEST {
        return Err(format!("{length} bytes are more than a recipe can have"));
    }
    let text = std::fs::read_to_string(file).map_err(|e| format!("cannot be read: {e}"))?;
    let recipe: Recipe = toml::from_str(&text).map_err(|e| e.to_string().trim_end().replace('\n', " "))?;
    checked(&recipe)?;
    Ok(recipe)
}

fn checked(recipe: &Recipe) -> Result<(), String> {
    if recipe.name.trim().is_empty() {
        return Err("the recipe has no name".into());
    }
    recipe.check().map_err(|e| e.to_string())
}

/// A file that is not there yet, named after a recipe.
fn free_file(folder: &Path, name: &str) -> PathBuf {
    let plain = |c: char| if c.is_alphanumeric() { c } else { '-' };
    let stem: String = name.trim().to_lowercase().chars().map(plain).take(60).collect();
    let named = |k: u32| match k {
        // Never alone: `con` and `nul` are no file names on every system.
        1 => folder.join(format!("recipe-{stem}.toml")),
        _ => folder.join(format!("recipe-{stem}-{k}.toml")),
    };
    (1..).map(named).find(|f| !f.exists()).unwrap_or_else(|| named(1))
}

#[cfg(test)]
mod tests {
    use super::*;
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
            assert_eq!(checked(r), Ok(()));
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
        assert!(library.own.is_empty() && library.broken.is_empty(), "no folder is no fault");
        let file = library.keep(&full()).expect("keeps");
        let again = Library::open(Some(folder.clone()));
        assert_eq!(again.own, [(file.clone(), full().without_places())]);
        // The same name is the same file; another that is spelt alike is not.
        library.keep(&Recipe { note: "slower".into(), ..full() }).expect("keeps");
        assert_eq!(library.own.len(), 1);
        let alike = Recipe { name: "Dichtfläche - fein".into(), ..full() };
        assert_ne!(library.keep(&alike).expect("keeps"), file);
        assert_eq!(library.own.len(), 2);
        library.forget("Dichtfläche / fein").expect("removes");
        assert_eq!(Library::open(Some(folder)).own[0].1.name, alike.name);
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
        assert!(library.own.is_empty() && library.broken.is_empty() && !file.exists());
        assert!(matches!(library.forget(&full().name), Err(LibraryError::Unknown { .. })));
        library.bring_back(&forgotten).expect("comes back");
        assert_eq!(library.own, [(file.clone(), full().without_places())]);
        assert_eq!(std::fs::read_to_string(&file).expect("reads"), text);
        // Another that has its place meanwhile stays.
        let forgotten = library.forget(&full().name).expect("forgets");
        let other = Recipe { note: "another".into(), ..full() };
        library.keep(&other).expect("keeps");
        assert!(matches!(library.bring_back(&forgotten), Err(LibraryError::Taken { .. })));
        assert_eq!(library.own, [(file, other.without_places())]);
    }

    #[test]
    fn broken_files_are_said_and_skipped() {
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
        assert_eq!(library.own.len(), 1);
        let said = ["b.toml: ", "a recipe can hold", "above 0", "is that of", "no name"];
        assert_eq!(library.broken.len(), said.len());
        for (line, part) in library.broken.iter().zip(said) {
            assert!(line.contains(part) && line.ends_with("mend or remove the file"), "{line}");
        }
    }
}
