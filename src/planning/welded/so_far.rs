//! What is known of a job's weld, as far as its stages have come.

use super::{MeasuredWeld, ReadWeld, WeldOnPart, WeldReport};
use crate::weld::masking::MaskedImage;
use std::sync::Arc;

/// What is known of the weld of the job that was synced last, as far as it has come.
#[derive(Clone, Debug)]
pub struct Welded {
    /// As read.
    pub read: Arc<ReadWeld>,
    /// Masked.
    pub masked: Option<Arc<MaskedImage>>,
    /// Measured.
    pub measured: Option<Arc<MeasuredWeld>>,
    /// On the part, with what is ground of it.
    pub ground: Option<Arc<WeldOnPart>>,
    /// What is reported of it.
    pub report: Option<Arc<WeldReport>>,
}
