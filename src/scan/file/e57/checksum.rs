//! The pages of an E57 file and their checksums: CRC-32C of 1020 bytes, in the last four of each 1024, the highest
//! byte first.

use crate::progress::Progress;
use crate::scan::file::{ScanFileError, Source};
use std::io::{ErrorKind, Read, SeekFrom};

const PAGE: usize = 1024;

/// Pages between two looks at the progress.
const BLOCK: u64 = 1 << 12;

/// Remainders of the reflected Castagnoli polynomial for each byte.
const TABLE: [u32; 256] = {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let (mut rest, mut bit) = (byte as u32, 0);
        while bit < 8 {
            rest = if rest & 1 == 1 { (rest >> 1) ^ 0x82f6_3b78 } else { rest >> 1 };
            bit += 1;
        }
        table[byte] = rest;
        byte += 1;
    }
    table
};

/// CRC-32C.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |rest, byte| TABLE[usize::from((rest as u8) ^ byte)] ^ (rest >> 8))
}

/// The length that the header states; that of a file too short for one is 48.
///
/// # Errors
/// The system cannot read.
pub(super) fn stated_length(source: &mut dyn Source) -> Result<u64, ScanFileError> {
    source.seek(SeekFrom::Start(16))?;
    let mut length = [0; 8];
    match source.read_exact(&mut length) {
        Ok(()) => Ok(u64::from_le_bytes(length)),
        Err(e) if e.kind() == ErrorKind::UnexpectedEof => Ok(48),
        Err(e) => Err(e.into()),
    }
}

/// The first page that does not fit its checksum.
///
/// # Errors
/// The system cannot read, or the work was cancelled.
pub(super) fn first_wrong_page(source: &mut dyn Source, progress: &Progress) -> Result<Option<u64>, ScanFileError> {
    source.rewind()?;
    let mut source = std::io::BufReader::with_capacity(PAGE * 256, source);
    let mut page = Vec::with_capacity(PAGE);
    for number in 0.. {
        if number % BLOCK == 0 {
            progress.check()?;
        }
        page.clear();
        source.by_ref().take(PAGE as u64).read_to_end(&mut page)?;
        let Some((data, stated)) = page.split_last_chunk::<4>() else { break };
        if page.len() < PAGE {
            break;
        }
        if crc(data) != u32::from_be_bytes(*stated) {
            return Ok(Some(number));
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_known_sum() {
        // RFC 3720, B.4: 32 bytes of zeros, and of ones.
        assert_eq!(crc(&[0; 32]), 0x8a91_36aa);
        assert_eq!(crc(&[0xff; 32]), 0x62a8_ab43);
    }
}
