//! The hand on a scan in the view: pairs of points, regions that do not count, cuts, labels. What was gathered is a
//! draft of the session (`draft`) until the operator takes it over; then it is an edit of the job as any other.

mod draft;
mod hand;
mod picture;
mod view;

pub(super) use draft::{CutDraft, CutShape, LeaveOutDraft, LeaveOutHand, PairsDraft, ScanTool};
pub(super) use hand::{around, brush_circle, left_out, pointer};
pub(super) use view::ToolView;
