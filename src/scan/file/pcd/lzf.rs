//! LZF, the compression of PCD: runs of bytes as they are, and copies of what came at most 8 KiB before.
//!
//! A control byte below 32 is followed by so many bytes and one more as they are. Else its upper three bits are the
//! length of a copy less 2 (7: a byte with more follows), its lower five and the next byte the distance less 1
//! (Lehmann, liblzf). So the unpacked bytes can be used up as they come, but for the last 8 KiB.

/// The farthest that a copy reaches back.
const REACH: usize = 1 << 13;

/// Unpacked bytes between two uses.
const PIECE: usize = 1 << 18;

/// No step of the input is longer: a control byte and 32 bytes.
pub(super) const LONGEST_STEP: usize = 33;

/// Unpacks step by step.
#[derive(Default)]
pub(super) struct Unpacker {
    /// What is unpacked, at least as far back as copies reach.
    out: Vec<u8>,
    /// Bytes of it that were used.
    used: usize,
    /// All bytes that were unpacked.
    pub total: u64,
}

impl Unpacker {
    /// Unpacks what it can of the input, at most a piece; returns how much of the input that took. Without `is_last`
    /// it leaves steps that may go on behind the input. `None`: this is no LZF.
    pub fn unpack(&mut self, input: &[u8], is_last: bool) -> Option<usize> {
        let mut at = 0;
        let begin = self.out.len();
        let end = if is_last { input.len() } else { input.len().saturating_sub(LONGEST_STEP) };
        while at < end && self.out.len() - begin < PIECE {
            let control = usize::from(input[at]);
            at += 1;
            if control < 32 {
                let run = input.get(at..at + control + 1)?;
                self.out.extend_from_slice(run);
                at += control + 1;
                continue;
            }
            let mut length = control >> 5;
            if length == 7 {
                length += usize::from(*input.get(at)?);
                at += 1;
            }
            let back = ((control & 31) << 8) + usize::from(*input.get(at)?) + 1;
            at += 1;
            let from = self.out.len().checked_sub(back)?;
            // A copy may run into what it writes.
            for k in from..from + length + 2 {
                self.out.push(self.out[k]);
            }
        }
        self.total += (self.out.len() - begin) as u64;
        Some(at)
    }

    /// What is unpacked and was not used.
    pub fn bytes(&self) -> &[u8] {
        &self.out[self.used..]
    }

    /// Notes that bytes were used, and forgets those that nothing reaches any more.
    pub fn take(&mut self, count: usize) {
        self.used += count;
        let gone = self.used.min(self.out.len().saturating_sub(REACH));
        if gone >= PIECE {
            self.out.drain(..gone);
            self.used -= gone;
        }
    }
}

#[cfg(test)]
pub(in super::super) mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::HashMap;

    /// Packs by the last place where the next three bytes stood.
    pub(in super::super::super) fn pack(bytes: &[u8]) -> Vec<u8> {
        let (mut out, mut run, mut at) = (Vec::new(), Vec::new(), 0);
        let mut seen: HashMap<[u8; 3], usize> = HashMap::new();
        let flush = |run: &mut Vec<u8>, out: &mut Vec<u8>| {
            for part in run.chunks(32) {
                out.push(part.len() as u8 - 1);
                out.extend_from_slice(part);
            }
            run.clear();
        };
        while at < bytes.len() {
            let key = bytes[at..].first_chunk::<3>().copied();
            let before = key.and_then(|k| seen.insert(k, at)).filter(|b| at - b <= REACH);
            let Some(before) = before else {
                run.push(bytes[at]);
                at += 1;
                continue;
            };
            flush(&mut run, &mut out);
            let length = (0..264.min(bytes.len() - at)).take_while(|k| bytes[before + k] == bytes[at + k]).count();
            let (code, back) = (length - 2, at - before - 1);
            out.push((code.min(7) << 5) as u8 | (back >> 8) as u8);
            if code >= 7 {
                out.push((code - 7) as u8);
            }
            out.push(back as u8);
            at += length;
        }
        flush(&mut run, &mut out);
        out
    }

    /// Unpacks, with the input in pieces of so many bytes.
    fn unpack(packed: &[u8], piece: usize) -> Option<Vec<u8>> {
        let (mut unpacker, mut out, mut at) = (Unpacker::default(), Vec::new(), 0);
        while at < packed.len() {
            let end = packed.len().min(at + piece.max(LONGEST_STEP + 1));
            at += unpacker.unpack(&packed[at..end], end == packed.len())?;
            let new = unpacker.bytes().len();
            out.extend_from_slice(unpacker.bytes());
            unpacker.take(new);
        }
        assert_eq!(unpacker.total, out.len() as u64);
        Some(out)
    }

    #[test]
    fn long_runs_and_far_copies_come_back() {
        let mut bytes: Vec<u8> = (0..20_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
        bytes.extend(std::iter::repeat_n(7, 1_000_000));
        bytes.extend_from_within(5000..9000);
        let packed = pack(&bytes);
        assert!(packed.len() < 60_000);
        assert_eq!(unpack(&packed, 4096), Some(bytes.clone()));
        assert_eq!(unpack(&packed, usize::MAX / 2), Some(bytes));
    }

    #[test]
    fn a_copy_from_before_the_beginning_is_no_lzf() {
        assert_eq!(unpack(&[0, 1, 0x20, 5], 64), None);
        assert_eq!(unpack(&[3, 1, 2], 64), None);
        assert_eq!(unpack(&[0, 1, 0x20, 0], 64), Some(vec![1; 4]));
    }

    proptest! {
        #[test]
        fn what_is_packed_comes_back(bytes in prop::collection::vec(0u8..4, 0..3000), piece in 34usize..200) {
            prop_assert_eq!(unpack(&pack(&bytes), piece), Some(bytes));
        }
    }
}
