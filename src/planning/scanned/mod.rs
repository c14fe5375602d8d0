//! From the files of a job's scan to the part that its patches are planned on (P3): read, cleaned, laid on the model,
//! compared with it. Each step is a stage of the pipeline; here is what each does, and why it has no value.

mod comparing;
mod error;
mod laying;
mod reading;

pub use comparing::{ComparedScan, WornPart, compare, worn};
pub use error::ScanError;
pub use laying::{LaidScan, lay};
pub use reading::{ReadScan, read_scan};
