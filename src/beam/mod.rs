//! The tool: optics and the head behind them, or what grinds in their place, and the space that they take up at a pose;
//! also the bodies of facets that stand in its way, such as clamps.
//!
//! Millimetres; along the beam, t runs from the point on the part and z from the focus.

pub mod contact_tool;
pub mod envelope;
pub mod frustum;
pub mod head;
mod head_part;
pub mod obstacle;
pub mod optics;
pub mod process_settings;
pub mod sample_heads;
mod simplex;
pub mod tool_configuration;
pub mod tool_geometry;

pub use contact_tool::contact_body::ContactBody;
pub use contact_tool::grinding::{ContactPlace, Grinding};
pub use contact_tool::{Abrasive, ContactSide, ContactTool, ContactToolError, ContactToolFault};
pub use frustum::Frustum;
pub use head::{Head, HeadError, StackError};
pub use head_part::HeadPart;
pub use obstacle::{Obstacle, Standing};
pub use optics::Optics;
pub use process_settings::{ProcessSettings, WorkingMedium};
pub use sample_heads::SampleHead;
pub use tool_configuration::ToolConfiguration;
pub use tool_geometry::ToolGeometry;

/// The tool as the files of a job describe it: read once, and kept with the set-up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tool {
    /// The head; `None`: the beam is a ray.
    pub head: Option<Head>,
    /// Clamps on the part, in its frame; where the robot carries the head, obstacles of the cell follow them.
    pub clamps: Vec<Obstacle>,
    /// How far the part may lie off where it is taken to be, mm: beam and head keep so much more than their margin.
    pub slack_mm: f64,
    /// What grinds in place of beam and head; `None`: a laser.
    pub contact: Option<Grinding>,
}

crate::part::keyed!(Tool { head, clamps, slack_mm, contact });
