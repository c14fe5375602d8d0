//! A plan as a dialect writes it, read again: what programs are compared with word by word. Where the robot stands and
//! what its beam meets is `driven`'s.

use super::compare::compare;
use super::error::VerifyError;
use super::expected::{Poses, moves};
use super::verdict::{Finding, Verdict};
use crate::cell::Setup;
use crate::program::dialect::{ReadContext, ReadLine};
use crate::program::{Dialect, Program, ProgramFile, ProgramLine, ReadError, WITHOUT_WORDS};

/// A plan as a dialect writes it.
pub struct AsWritten<'a> {
    dialect: &'static dyn Dialect,
    setup: &'a Setup,
    /// The plan's lines.
    pub(super) lines: Vec<ProgramLine>,
    /// The plan's lines, written and read again.
    pub(super) read: Vec<ReadLine>,
}

impl<'a> AsWritten<'a> {
    /// Writes the lines of a plan and reads them again.
    ///
    /// # Errors
    /// They cannot be written in the dialect, or not be read.
    pub fn new(
        dialect: &'static dyn Dialect,
        lines: Vec<ProgramLine>,
        setup: &'a Setup,
    ) -> Result<AsWritten<'a>, VerifyError> {
        let program = Program { head: Vec::new(), lines: lines.clone(), setup, wording: WITHOUT_WORDS };
        let files = dialect.write(&program).map_err(VerifyError::Unwritable)?;
        let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
        let Some(first) = files.first() else { return Err(VerifyError::NoProgram) };
        let read = dialect.read(first, &ReadContext { setup, open: &open }).map_err(VerifyError::OwnUnreadable)?;
        Ok(AsWritten { dialect, setup, lines, read })
    }

    /// Where a program says something else, without driving it. `defocus_mm`: how far the focus stands above the spot.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn differences(
        &self,
        first: &ProgramFile,
        open: &dyn Fn(&str) -> Option<String>,
        defocus_mm: f64,
    ) -> Result<Vec<Finding>, ReadError> {
        let (setup, mut verdict) = (self.setup, Verdict::default());
        let read = self.dialect.read(first, &ReadContext { setup, open })?;
        compare(&moves(&self.lines), &self.read, &Poses { setup, defocus_mm }, &read, &mut verdict);
        Ok(verdict.findings)
    }
}
