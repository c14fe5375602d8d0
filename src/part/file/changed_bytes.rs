//! Any changes of a file's bytes, for the tests of its reader.

use proptest::prelude::*;
use proptest::sample::Index;

/// Bytes that stand elsewhere, and where the file ends.
#[derive(Clone, Debug)]
pub struct ChangedBytes {
    changes: Vec<(Index, u8)>,
    end: Index,
}

impl ChangedBytes {
    /// Less than a dozen changes, and the end anywhere.
    pub fn any() -> impl Strategy<Value = ChangedBytes> {
        let changes = prop::collection::vec((any::<Index>(), any::<u8>()), 0..12);
        (changes, any::<Index>()).prop_map(|(changes, end)| ChangedBytes { changes, end })
    }

    /// A file with these changes; it has one byte at least.
    pub fn of(&self, file: impl Into<Vec<u8>>) -> Vec<u8> {
        let mut bytes = file.into();
        for (at, byte) in &self.changes {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        bytes.truncate(self.end.index(bytes.len()) + 1);
        bytes
    }
}
