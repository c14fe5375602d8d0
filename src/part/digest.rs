//! Hashes: of a part file (SHA-256, kept in the job), and of the inputs of a computed stage
//! (so that only what changed is computed again). Neither depends on machine or run.

use sha2::{Digest as _, Sha256};
use std::fmt;

/// First 128 bits of a SHA-256.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug, Default)]
pub struct Digest(pub u128);

impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

/// Collects the inputs of a stage.
#[derive(Default)]
pub struct Hasher(Sha256);

impl Hasher {
    /// Adds raw bytes, with their length, so that neighbours cannot run into each other.
    pub fn bytes(mut self, bytes: &[u8]) -> Self {
        self.0.update((bytes.len() as u64).to_le_bytes());
        self.0.update(bytes);
        self
    }

    /// Adds numbers by their exact bits.
    pub fn f64s(mut self, values: &[f64]) -> Self {
        self.0.update((values.len() as u64).to_le_bytes());
        for v in values {
            self.0.update(v.to_bits().to_le_bytes());
        }
        self
    }

    /// Adds whole numbers.
    pub fn u32s(mut self, values: &[u32]) -> Self {
        self.0.update((values.len() as u64).to_le_bytes());
        for v in values {
            self.0.update(v.to_le_bytes());
        }
        self
    }

    /// Adds another digest.
    pub fn digest(mut self, d: Digest) -> Self {
        self.0.update(d.0.to_le_bytes());
        self
    }

    /// The digest of all that was added.
    pub fn finish(self) -> Digest {
        let mut first = [0u8; 16];
        first.copy_from_slice(&self.0.finalize()[..16]);
        Digest(u128::from_be_bytes(first))
    }
}

/// SHA-256 of a file's bytes, hexadecimal, as kept in a job.
pub fn file_sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_digest_and_no_run_together() {
        assert!(file_sha256(b"abc").starts_with("ba7816bf8f01cfea414140de5dae2223"));
        let ab = Hasher::default().bytes(b"a").bytes(b"b").finish();
        assert_ne!(ab, Hasher::default().bytes(b"ab").bytes(b"").finish());
    }
}
