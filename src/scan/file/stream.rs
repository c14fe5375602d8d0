//! A file that is read piece by piece: readers see a window of it, and take from its beginning what they have
//! understood. On the way its digest is made, text in UTF-16 becomes single bytes, and progress is told.

use super::ScanFileError;
use crate::part::file::Utf16Form;
use crate::progress::{Activity, Progress};
use sha2::{Digest as _, Sha256};
use std::io::Read;

/// Bytes that are read at a time: a few milliseconds of work between two looks at the progress.
pub(super) const CHUNK: usize = 1 << 20;

/// No line of text is longer, and no row.
const LONGEST: usize = 16 * CHUNK;

/// A file on its way through a window.
pub(super) struct Stream<'a> {
    source: &'a mut dyn Read,
    progress: &'a Progress,
    hash: Sha256,
    window: Vec<u8>,
    /// Bytes of the window that are taken.
    taken: usize,
    /// Bytes that were before the window.
    before: u64,
    /// Bytes of the file.
    len: u64,
    utf16: Option<Utf16Form>,
    /// Half a unit of UTF-16 at the end of a piece.
    half: Vec<u8>,
    has_ended: bool,
}

impl<'a> Stream<'a> {
    /// Reads the first piece of a file of so many bytes.
    ///
    /// # Errors
    /// The system cannot, or the work was cancelled.
    pub fn new(source: &'a mut dyn Read, len: u64, progress: &'a Progress) -> Result<Stream<'a>, ScanFileError> {
        progress.begin(Activity::Reading, (len / CHUNK as u64) as usize + 1);
        let (window, half) = (Vec::with_capacity(CHUNK), Vec::new());
        let (hash, utf16) = (Sha256::default(), None);
        let mut stream =
            Stream { source, progress, hash, window, taken: 0, before: 0, len, utf16, half, has_ended: false };
        stream.fill()?;
        if let Some(form) = Utf16Form::of(&stream.window) {
            let units = stream.window.split_off(form.begin);
            stream.window.clear();
            stream.utf16 = Some(form);
            stream.put(&units);
        }
        Ok(stream)
    }

    /// What stands in the window and is not taken.
    pub fn bytes(&self) -> &[u8] {
        &self.window[self.taken..]
    }

    /// Whether the text is UTF-16; then it is nothing but text.
    pub fn is_utf16(&self) -> bool {
        self.utf16.is_some()
    }

    /// Takes bytes from the beginning of the window.
    pub fn take(&mut self, count: usize) {
        self.taken = (self.taken + count).min(self.window.len());
    }

    /// Bytes that are not taken, those behind the window too, by the length of the file.
    pub fn remaining(&self) -> u64 {
        let (scale, begin) = self.utf16.map_or((1, 0), |form| (2, form.begin as u64));
        (self.len.saturating_sub(begin) / scale).saturating_sub(self.before + self.taken as u64)
    }

    /// Where a byte of the window, not taken, stands in the file.
    pub fn place(&self, at: usize) -> u64 {
        let (scale, begin) = self.utf16.map_or((1, 0), |form| (2, form.begin as u64));
        begin + scale * (self.before + (self.taken + at) as u64)
    }

    /// Whether the window ends where the file does.
    pub fn has_ended(&self) -> bool {
        self.has_ended
    }

    /// Reads another piece behind the window; false at the end of the file.
    ///
    /// # Errors
    /// The system cannot, or the work was cancelled.
    pub fn fill(&mut self) -> Result<bool, ScanFileError> {
        self.progress.step()?;
        self.window.drain(..self.taken);
        self.before += self.taken as u64;
        self.taken = 0;
        if self.utf16.is_some() {
            let mut piece = std::mem::take(&mut self.half);
            self.read_behind(&mut piece)?;
            self.put(&piece);
        } else {
            let mut window = std::mem::take(&mut self.window);
            let read = self.read_behind(&mut window);
            self.window = window;
            read?;
        }
        Ok(!self.has_ended)
    }

    fn read_behind(&mut self, into: &mut Vec<u8>) -> Result<(), ScanFileError> {
        let begin = into.len();
        let read = (&mut *self.source).take(CHUNK as u64).read_to_end(into)?;
        self.hash.update(&into[begin..]);
        self.has_ended = read < CHUNK;
        Ok(())
    }

    fn put(&mut self, units: &[u8]) {
        if let Some(form) = self.utf16 {
            self.window.extend(form.ascii(units));
            self.half = units.chunks_exact(2).remainder().to_vec();
        }
    }

    /// Fills the window until it has so many bytes, if there are.
    ///
    /// # Errors
    /// As [`Stream::fill`].
    pub fn need(&mut self, count: usize) -> Result<bool, ScanFileError> {
        while self.bytes().len() < count && !self.has_ended {
            self.fill()?;
        }
        Ok(self.bytes().len() >= count)
    }

    /// Passes over bytes; false where the file ends before.
    ///
    /// # Errors
    /// As [`Stream::fill`].
    pub fn skip(&mut self, mut count: u64) -> Result<bool, ScanFileError> {
        loop {
            let now = count.min(self.bytes().len() as u64);
            self.take(now as usize);
            count -= now;
            if count == 0 || self.has_ended {
                return Ok(count == 0);
            }
            self.fill()?;
        }
    }

    /// Bytes of whole lines that the window begins with; 0 at the end of the file. The last line needs no end.
    ///
    /// # Errors
    /// As [`Stream::fill`]; [`ScanFileError::Unknown`]: a line is so long that this is no text.
    pub fn lines(&mut self) -> Result<usize, ScanFileError> {
        loop {
            let bytes = self.bytes();
            if self.has_ended {
                return Ok(bytes.len());
            }
            // A carriage return at the end may be half of the end of a line.
            let whole = &bytes[..bytes.len() - usize::from(bytes.last() == Some(&b'\r'))];
            if let Some(end) = whole.iter().rposition(|b| matches!(b, b'\n' | b'\r')) {
                let has_feed = bytes[end] == b'\r' && bytes.get(end + 1) == Some(&b'\n');
                return Ok(end + 1 + usize::from(has_feed));
            }
            if bytes.len() > LONGEST {
                return Err(ScanFileError::Unknown);
            }
            self.fill()?;
        }
    }

    /// Bytes that nothing took: how many, and where they begin; white space at their beginning is none.
    ///
    /// # Errors
    /// As [`Stream::fill`].
    pub fn left(&mut self) -> Result<Option<(u64, u64)>, ScanFileError> {
        loop {
            let blank = self.bytes().iter().take_while(|b| b.is_ascii_whitespace()).count();
            self.take(blank);
            if !self.bytes().is_empty() {
                return Ok(Some((self.remaining(), self.place(0))));
            }
            if self.has_ended {
                return Ok(None);
            }
            self.fill()?;
        }
    }

    /// Reads what is left, for the SHA-256 of the whole file, hexadecimal.
    ///
    /// # Errors
    /// As [`Stream::fill`].
    pub fn digest(mut self) -> Result<String, ScanFileError> {
        loop {
            self.taken = self.window.len();
            if self.has_ended {
                return Ok(self.hash.finalize().iter().map(|b| format!("{b:02x}")).collect());
            }
            self.fill()?;
        }
    }
}

/// Lines of text without their ends: line feeds, carriage returns, or both in one.
pub(super) struct Lines<'a>(pub &'a [u8]);

impl<'a> Iterator for Lines<'a> {
    type Item = &'a [u8];

    #[inline]
    fn next(&mut self) -> Option<&'a [u8]> {
        if self.0.is_empty() {
            return None;
        }
        let end = self.0.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.0.len());
        let (line, rest) = self.0.split_at(end);
        let long = if rest.starts_with(b"\r\n") { 2 } else { rest.len().min(1) };
        self.0 = &rest[long..];
        Some(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_every_kind_of_end_come_out_whole_across_pieces() {
        for end in ["\n", "\r", "\r\n"] {
            let text: String = (0..200_000).map(|i| format!("{i} 0 1{end}")).collect();
            for bytes in [text.clone().into_bytes(), text.encode_utf16().flat_map(u16::to_le_bytes).collect()] {
                let progress = Progress::default();
                let mut source = &bytes[..];
                let mut stream = Stream::new(&mut source, bytes.len() as u64, &progress).expect("reads");
                let mut count = 0;
                loop {
                    let whole = stream.lines().expect("text");
                    if whole == 0 {
                        break;
                    }
                    for line in Lines(&stream.bytes()[..whole]) {
                        assert_eq!(line, format!("{count} 0 1").as_bytes(), "{end:?}");
                        count += 1;
                    }
                    stream.take(whole);
                }
                assert_eq!((count, stream.remaining()), (200_000, 0));
                assert_eq!(stream.digest().expect("read"), crate::part::digest_of(&bytes));
            }
        }
    }

    #[test]
    fn a_cancelled_stream_ends() {
        let bytes = vec![b'1'; 4 * CHUNK];
        let (progress, mut source) = (Progress::ending_after(3), &bytes[..]);
        let mut stream = Stream::new(&mut source, bytes.len() as u64, &progress).expect("goes on");
        assert!(matches!(stream.skip(bytes.len() as u64), Err(ScanFileError::Cancelled)));
    }
}
