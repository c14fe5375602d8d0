//! Hashes: of a part file (SHA-256, kept in the job), and of the inputs of a computed stage
//! (so that only what changed is computed again). Neither depends on machine or run.
//!
//! A type says by [`Keyed`] which of its fields a result can depend on. `keyed!` and `keyed_words!` write that from a
//! list of its fields or variants, and do not compile where one was forgotten.

use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use sha2::{Digest as _, Sha256};
use std::collections::BTreeMap;
use std::fmt;

/// What can be an input of a computed stage.
pub trait Keyed {
    /// Adds all that a result can depend on.
    fn feed(&self, into: &mut Hasher);
}

/// Implements [`Keyed`] for a struct: `keyed!(Type { fields; fields on which nothing computed depends })`.
macro_rules! keyed {
    ($type:ty { $($field:ident),* $(,)? $(; $($left:ident),+)? }) => {
        impl $crate::part::Keyed for $type {
            fn feed(&self, into: &mut $crate::part::Hasher) {
                let Self { $($field,)* $($($left: _,)+)? } = self;
                $($crate::part::Keyed::feed($field, into);)*
            }
        }
    };
}
pub(crate) use keyed;

/// Implements [`Keyed`] for an enum without fields: `keyed_words!(Type: variants)`.
macro_rules! keyed_words {
    ($type:ty: $($variant:ident),+ $(,)?) => {
        impl $crate::part::Keyed for $type {
            fn feed(&self, into: &mut $crate::part::Hasher) {
                // By name: a variant that is put between others changes no key.
                let name = match self {
                    $(Self::$variant => stringify!($variant),)+
                };
                $crate::part::Keyed::feed(name, into);
            }
        }
    };
}
pub(crate) use keyed_words;

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
    /// Adds a value by what its type says a result can depend on.
    pub fn of(mut self, value: &(impl Keyed + ?Sized)) -> Self {
        value.feed(&mut self);
        self
    }

    fn put(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

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

impl Keyed for f64 {
    fn feed(&self, into: &mut Hasher) {
        into.put(&self.to_bits().to_le_bytes());
    }
}

impl Keyed for u32 {
    fn feed(&self, into: &mut Hasher) {
        into.put(&self.to_le_bytes());
    }
}

impl Keyed for u64 {
    fn feed(&self, into: &mut Hasher) {
        into.put(&self.to_le_bytes());
    }
}

impl Keyed for bool {
    fn feed(&self, into: &mut Hasher) {
        into.put(&[u8::from(*self)]);
    }
}

impl Keyed for str {
    fn feed(&self, into: &mut Hasher) {
        (self.len() as u64).feed(into);
        into.put(self.as_bytes());
    }
}

impl Keyed for String {
    fn feed(&self, into: &mut Hasher) {
        self.as_str().feed(into);
    }
}

impl Keyed for Digest {
    fn feed(&self, into: &mut Hasher) {
        into.put(&self.0.to_le_bytes());
    }
}

impl Keyed for Vector3<f64> {
    fn feed(&self, into: &mut Hasher) {
        self.as_slice().feed(into);
    }
}

impl Keyed for Point3<f64> {
    fn feed(&self, into: &mut Hasher) {
        self.coords.feed(into);
    }
}

impl<T: Keyed + ?Sized> Keyed for &T {
    fn feed(&self, into: &mut Hasher) {
        (**self).feed(into);
    }
}

impl<T: Keyed> Keyed for Option<T> {
    fn feed(&self, into: &mut Hasher) {
        self.is_some().feed(into);
        if let Some(value) = self {
            value.feed(into);
        }
    }
}

impl<T: Keyed> Keyed for [T] {
    fn feed(&self, into: &mut Hasher) {
        (self.len() as u64).feed(into);
        self.iter().for_each(|value| value.feed(into));
    }
}

impl<T: Keyed> Keyed for Vec<T> {
    fn feed(&self, into: &mut Hasher) {
        self.as_slice().feed(into);
    }
}

impl<T: Keyed, const N: usize> Keyed for [T; N] {
    fn feed(&self, into: &mut Hasher) {
        self.iter().for_each(|value| value.feed(into));
    }
}

impl<K: Keyed, V: Keyed> Keyed for BTreeMap<K, V> {
    fn feed(&self, into: &mut Hasher) {
        (self.len() as u64).feed(into);
        for (key, value) in self {
            key.feed(into);
            value.feed(into);
        }
    }
}

/// SHA-256 of a file's bytes, hexadecimal, as kept in a job.
pub fn file_sha256(bytes: &[u8]) -> String {
    hexadecimal(Sha256::digest(bytes).as_slice())
}

/// The SHA-256 of a file's bytes, hexadecimal, as long as nobody wants the work to end.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn file_sha256_under(progress: &Progress, bytes: &[u8]) -> Result<String, Cancelled> {
    let mut hash = Sha256::new();
    for block in bytes.chunks(HASHED_AT_ONCE) {
        progress.check()?;
        hash.update(block);
    }
    Ok(hexadecimal(hash.finalize().as_slice()))
}

/// So many bytes are hashed between two looks whether that should end: some milliseconds.
const HASHED_AT_ONCE: usize = 1 << 20;

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|b| format!("{b:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_digest_and_no_run_together() {
        assert!(file_sha256(b"abc").starts_with("ba7816bf8f01cfea414140de5dae2223"));
        let long = vec![7; 5 * HASHED_AT_ONCE / 2];
        assert_eq!(file_sha256_under(&Progress::default(), &long), Ok(file_sha256(&long)));
        let ab = Hasher::default().bytes(b"a").bytes(b"b").finish();
        assert_ne!(ab, Hasher::default().bytes(b"ab").bytes(b"").finish());
    }
}
