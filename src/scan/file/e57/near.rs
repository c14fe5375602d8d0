//! A file that is read page by page in order, with a seek before each: a buffer that such seeks do not empty.

use crate::scan::file::Source;
use std::io::{BufReader, Read, Result, Seek, SeekFrom};

/// Bytes of the buffer.
const BUFFER: usize = 1 << 18;

/// The file, and where in it the next byte stands.
pub(super) struct Near<'a> {
    inner: BufReader<&'a mut dyn Source>,
    at: u64,
}

impl<'a> Near<'a> {
    /// Begins at the beginning of the file.
    ///
    /// # Errors
    /// The system cannot.
    pub fn new(source: &'a mut dyn Source) -> Result<Near<'a>> {
        source.rewind()?;
        Ok(Near { inner: BufReader::with_capacity(BUFFER, source), at: 0 })
    }
}

impl Read for Near<'_> {
    fn read(&mut self, into: &mut [u8]) -> Result<usize> {
        let read = self.inner.read(into)?;
        self.at += read as u64;
        Ok(read)
    }
}

impl Seek for Near<'_> {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        match to {
            SeekFrom::Start(to) if to.max(self.at) < 1 << 62 => {
                self.inner.seek_relative(to as i64 - self.at as i64)?;
                self.at = to;
            }
            to => self.at = self.inner.seek(to)?,
        }
        Ok(self.at)
    }
}
