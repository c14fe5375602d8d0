//! The values of a job are checked before anything is computed from them.

use super::bead;
use super::model::Job;
use super::parameter::PARAMETERS;
use super::value_error::ValueError;
use crate::program::dialects;

impl Job {
    /// Checks every value, and what values there must be together.
    ///
    /// # Errors
    /// The first that cannot be.
    pub fn check(&self) -> Result<(), ValueError> {
        PARAMETERS.iter().try_for_each(|p| p.check(self.number(p)))?;
        self.check_recipes()?;
        bead::check(self)?;
        self.scan.model_from_scan().map_err(ValueError::Transform)?;
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
    use crate::document::{BeadError, FirstPlane};
    use crate::program::UnknownDialect;

    #[test]
    fn the_first_value_that_cannot_be_is_told() {
        let mut job = Job::default();
        assert_eq!(job.check(), Ok(()));
        job.layers.offset_mm = FirstPlane::FromLowest(0.6);
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
