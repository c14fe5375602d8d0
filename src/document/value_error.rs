//! Why the values of a job cannot be, as data: numbers, recipes, beads. Sentences of it stand in `text`.

use super::parameter::ParameterError;
use crate::part::SurfaceId;
use crate::program::UnknownDialect;
use crate::scan::transform_file::MatrixFault;
use thiserror::Error;

/// Why nothing can be computed from the values of a job.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ValueError {
    /// A number that cannot be.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A recipe that cannot be, or one that is not there.
    #[error(transparent)]
    Recipe(#[from] RecipeError),
    /// A bead that cannot be.
    #[error(transparent)]
    Bead(#[from] BeadError),
    /// A dialect that does not exist.
    #[error(transparent)]
    Dialect(#[from] UnknownDialect),
    /// The transform of the scan is no rigid motion.
    #[error("scan.transform: {0:?}")]
    Transform(MatrixFault),
    /// The first plane lies outside the first spacing: a wider strip at the rim would stay uncleaned.
    #[error("offset {offset_mm} outside the spacing {spacing_mm}")]
    OffsetOutside {
        /// Distance of the first plane from the lowest point, mm.
        offset_mm: f64,
        /// Spacing, mm.
        spacing_mm: f64,
    },
}

/// What is wrong with the recipes of a job.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RecipeError {
    /// A key of a number that recipes do not hold, or of none.
    #[error("recipe {recipe:?}: {key:?} is not for recipes")]
    NotForRecipes {
        /// Name of the recipe.
        recipe: String,
        /// The key.
        key: String,
    },
    /// A number that cannot be.
    #[error("recipe {recipe:?}: {source}")]
    Number {
        /// Name of the recipe.
        recipe: String,
        /// Which, and what is wrong with it.
        source: ParameterError,
    },
    /// A bead that cannot be, with the job's values beside those of the recipe.
    #[error("recipe {recipe:?}: {source}")]
    Bead {
        /// Name of the recipe.
        recipe: String,
        /// What is wrong with it.
        source: BeadError,
    },
    /// Two of one name.
    #[error("two recipes {name:?}")]
    Twice {
        /// The name.
        name: String,
    },
    /// A surface has one that is not there.
    #[error("surface {surface} has recipe {name:?}, which is not there")]
    Missing {
        /// The surface.
        surface: SurfaceId,
        /// The name.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
}

/// Why the values of a bead cannot be.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum BeadError {
    /// It has a width or a height alone.
    #[error("half a bead: {width_mm} by {height_mm}")]
    Half {
        /// Width, mm.
        width_mm: f64,
        /// Height, mm.
        height_mm: f64,
    },
    /// Several layers where nothing is laid.
    #[error("{layers} layers of no bead")]
    LayersOfNothing {
        /// How many.
        layers: u32,
    },
}
