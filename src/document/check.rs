//! What can be wrong with the values of a job, before anything is computed from them.

use super::bead::{self, BeadError};
use super::model::Job;
use super::parameter::{PARAMETERS, ParameterError};
use super::recipe::RecipeError;
use crate::program::{UnknownDialect, dialects};
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
    /// The first plane lies outside the first spacing: a wider strip at the rim would stay uncleaned.
    #[error("offset {offset_mm} outside the spacing {spacing_mm}")]
    OffsetOutside {
        /// Distance of the first plane from the lowest point, mm.
        offset_mm: f64,
        /// Spacing, mm.
        spacing_mm: f64,
    },
}

impl Job {
    /// Checks every value, and what values there must be together.
    ///
    /// # Errors
    /// The first that cannot be.
    pub fn check(&self) -> Result<(), ValueError> {
        PARAMETERS.iter().try_for_each(|p| p.check(self.number(p)))?;
        self.check_recipes()?;
        bead::check(self)?;
        dialects::known(&self.cell.dialect)?;
        let spacing_mm = self.layers.spacing_mm;
        match self.layers.offset_mm.mm() {
            Some(offset_mm) if !(0.0..=spacing_mm).contains(&offset_mm) => {
                Err(ValueError::OffsetOutside { offset_mm, spacing_mm })
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Offset;

    #[test]
    fn the_first_value_that_cannot_be_is_told() {
        let mut job = Job::default();
        assert_eq!(job.check(), Ok(()));
        job.layers.offset_mm = Offset::FromLowest(0.6);
        assert_eq!(job.check(), Err(ValueError::OffsetOutside { offset_mm: 0.6, spacing_mm: 0.5 }));
        job.cell.dialect = "klingon".into();
        assert_eq!(job.check(), Err(UnknownDialect("klingon".into()).into()));
        job.bead.width_mm = 1.0;
        assert!(matches!(job.check(), Err(ValueError::Bead(BeadError::Half { .. }))));
        job.layers.passes = 0;
        let Err(ValueError::Parameter(refused)) = job.check() else { panic!("{:?}", job.check()) };
        assert_eq!((refused.parameter.key, refused.value), ("layers.passes", 0.0));
    }
}
