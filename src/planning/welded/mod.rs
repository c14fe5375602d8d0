//! From the two images of a job's weld to the part that its grinding is planned on (P4): read, masked, measured, and the
//! part with its areas as surfaces. Each step is a stage of the pipeline; here is what each does, and why it has no value.

mod error;
mod grinding;
mod masking;
mod measuring;
mod on_part;
mod passes;
mod reading;
mod report_rows;
mod so_far;
mod times;
mod weld_on_part;
mod weld_report;

pub use error::WeldError;
pub use grinding::{GroundWeld, ground};
pub use masking::mask_weld;
pub use measuring::{MeasuredArea, MeasuredWeld, UnmeasuredArea, measure_weld};
pub use on_part::{WeldPart, weld_part};
pub use passes::WeldProgress;
pub use reading::{ReadWeld, read_weld};
pub use report_rows::{AreaReport, AreaTimes, GroundPassReport, HeldReason};
pub use so_far::Welded;
pub use times::area_times;
pub use weld_on_part::{WeldOnPart, weld_on_part};
pub use weld_report::{HandEyeReport, RoughnessReport, WeldReport};
