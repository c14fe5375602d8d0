//! Why a stage has no value: ended, refused, or a panic that was caught.

use crate::progress::Cancelled;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use thiserror::Error;

/// Why a stage has no value.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Failure<E> {
    /// The user ended the work.
    #[error("cancelled")]
    Cancelled,
    /// A fault of the program: the words of the panic.
    #[error("panicked: {0}")]
    Panicked(String),
    /// What was given cannot be worked on.
    #[error(transparent)]
    Refused(E),
}

impl<E> From<Cancelled> for Failure<E> {
    fn from(_: Cancelled) -> Failure<E> {
        Failure::Cancelled
    }
}

/// Does some work; a panic in it is a failure.
pub(super) fn guarded<V, E>(work: impl FnOnce() -> Result<V, Failure<E>>) -> Result<V, Failure<E>> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|panic| Err(Failure::Panicked(words_of(panic.as_ref()))))
}

fn words_of(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "without words".into())
}
