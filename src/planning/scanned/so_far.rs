//! What is known of a job's scan, as far as its stages have come.

use super::{ComparedScan, LaidScan, ReadScan, WornPart};
use crate::scan::cleaning::Cleaned;
use std::sync::Arc;

/// What is known of the scan of the job that was synced last, as far as it has come.
#[derive(Clone, Debug)]
pub struct Scanned {
    /// As read.
    pub read: Arc<ReadScan>,
    /// Cleaned.
    pub cleaned: Option<Arc<Cleaned>>,
    /// On the part.
    pub laid: Option<Arc<LaidScan>>,
    /// Compared with it.
    pub compared: Option<Arc<ComparedScan>>,
    /// The part with its patches.
    pub worn: Option<Arc<WornPart>>,
}
