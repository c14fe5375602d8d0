//! The archive of a 3MF file: its entries as text, unpacked no further than a limit, and which of them is the main
//! model.

use super::super::encoding::Utf16;
use super::super::{PartFileError, ThreeMfFault};
use crate::progress::Progress;
use std::io::{Cursor, Read as _};
use zip::ZipArchive;

/// Says which entry is what.
const RELATIONSHIPS: &str = "_rels/.rels";

/// So many bytes are unpacked between two looks whether that should end: a few milliseconds.
const UNPACKED_AT_ONCE: u64 = 1 << 20;

/// The archive.
pub(super) struct Package<'a> {
    archive: ZipArchive<Cursor<&'a [u8]>>,
    /// Bytes that may still be unpacked, and all that might, MiB.
    left: u64,
    most_mib: u64,
    /// Whether its reading should end.
    pub progress: &'a Progress,
}

impl<'a> Package<'a> {
    /// Opens an archive, of which so much may be unpacked.
    pub fn open(bytes: &'a [u8], most_mib: u64, progress: &'a Progress) -> Result<Package<'a>, ThreeMfFault> {
        let archive = ZipArchive::new(Cursor::new(bytes)).map_err(|_| ThreeMfFault::Archive)?;
        Ok(Package { archive, left: most_mib << 20, most_mib, progress })
    }

    /// The name of an entry as the archive has it: capitals do not count.
    fn entry(&self, name: &str) -> Option<usize> {
        let name = name.trim_start_matches('/');
        let same = |raw: &[u8]| raw.eq_ignore_ascii_case(name.as_bytes());
        self.archive.file_names_raw().position(same)
    }

    /// An entry as text.
    pub fn text(&mut self, name: &str) -> Result<String, PartFileError> {
        let entry = || name.trim_start_matches('/').to_owned();
        let index = self.entry(name).ok_or_else(|| ThreeMfFault::NoEntry { entry: entry() })?;
        let unreadable = || ThreeMfFault::Unreadable { entry: entry() };
        let file = self.archive.by_index(index).map_err(|_| unreadable())?;
        let (mut bytes, mut unpacked) = (Vec::new(), file.take(self.left + 1));
        loop {
            self.progress.check()?;
            let read = (&mut unpacked).take(UNPACKED_AT_ONCE).read_to_end(&mut bytes).map_err(|_| unreadable())?;
            if read == 0 {
                break;
            }
        }
        self.left =
            self.left.checked_sub(bytes.len() as u64).ok_or(ThreeMfFault::TooLarge { most_mib: self.most_mib })?;
        if let Some(utf16) = Utf16::of(&bytes) {
            bytes = utf16.ascii;
        }
        let text = String::from_utf8(bytes).map_err(|_| ThreeMfFault::Xml { entry: entry(), line: 1 })?;
        Ok(match text.strip_prefix('\u{feff}') {
            Some(unmarked) => unmarked.to_owned(),
            None => text,
        })
    }

    /// The name of the main model; `None`: the archive is no 3MF file.
    pub fn main_model(&mut self) -> Result<Option<String>, PartFileError> {
        if self.entry(RELATIONSHIPS).is_none() {
            return Ok(None);
        }
        let text = self.text(RELATIONSHIPS)?;
        let document = parsed(&text, RELATIONSHIPS)?;
        let is_model = |n: &roxmltree::Node<'_, '_>| n.attribute("Type").is_some_and(|t| t.ends_with("/3dmodel"));
        let target = document.descendants().find(is_model).and_then(|n| n.attribute("Target"));
        Ok(target.map(str::to_owned))
    }
}

/// The XML of an entry.
pub(super) fn parsed<'a>(text: &'a str, entry: &str) -> Result<roxmltree::Document<'a>, ThreeMfFault> {
    roxmltree::Document::parse(text)
        .map_err(|e| ThreeMfFault::Xml { entry: entry.trim_start_matches('/').to_owned(), line: e.pos().row })
}
