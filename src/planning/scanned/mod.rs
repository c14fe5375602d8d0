//! From the files of a job's scan to the part that its patches are planned on (P3): read, cleaned, laid on the model,
//! compared with it. Each step is a stage of the pipeline; here is what each does, and why it has no value.

mod comparing;
mod continuing;
mod deviation_report;
mod error;
mod laying;
mod measuring;
mod reading;
mod registration_report;
mod scan_report;
mod so_far;
mod worn;

pub use comparing::{ComparedScan, compare};
pub use continuing::{ContinuedFigures, ScanModel};
pub use deviation_report::{DeviationReport, FillingLayer, WornPatch};
pub use error::{BeyondGate, ScanError};
pub use laying::{LaidScan, lay};
pub use reading::{BroughtTogether, ReadScan, by_overlap, read_scan};
pub use registration_report::{MarkerResidual, PlacedScan, RegistrationReport, RivalReport, SlidingReport};
pub use scan_report::ScanReport;
pub use so_far::Scanned;
pub use worn::{WornPart, worn};
