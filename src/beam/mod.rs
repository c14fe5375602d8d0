//! The tool: optics, the head behind them, what is clamped to the part, and the space that all of it
//! takes up at a pose.
//!
//! Millimetres; along the beam, t runs from the point on the part and z from the focus.

pub mod body;
pub mod envelope;
pub mod frustum;
pub mod head;
pub mod obstacle;
pub mod optics;
pub mod work;

pub use body::Body;
pub use frustum::Frustum;
pub use head::{Head, HeadError, HeadPart, StackError};
pub use obstacle::Obstacle;
pub use optics::Optics;
pub use work::{Stance, Work};

/// What the files of a job hold of the tool: read once, and kept with the set-up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tool {
    /// The head; `None`: the beam is a ray.
    pub head: Option<Head>,
    /// What stands on the part, in its frame; behind it, where the head is carried, what stands in the cell.
    pub clamps: Vec<Obstacle>,
}

crate::part::keyed!(Tool { head, clamps });
