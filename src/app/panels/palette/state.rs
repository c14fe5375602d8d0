//! The search for a command, as the session keeps it.

/// What is searched.
#[derive(Clone, Debug, Default)]
pub(in super::super::super) struct Palette {
    /// The words so far.
    pub text: String,
    /// The row that Enter gives.
    pub at: usize,
}
