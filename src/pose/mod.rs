//! How the beam stands at every target: path frames, interference of beam and head, the corrections, the
//! motion between targets, and an independent checker.
//!
//! Part frame, millimetres and degrees. Robots are unknown here; they come in `cell`.

pub mod access;
mod beam_pose;
pub mod checker;
pub mod clearance;
pub mod correction;
pub mod interference;
pub mod line;
pub mod line_rules;
pub mod motion;
pub mod section_plane;
pub mod target;
pub mod tilt;

pub use beam_pose::Pose;
pub use correction::Correction;
pub use interference::{BeamInterference, Blocker, Obstruction, ToolBody};
pub use line::{LineOnSurface, plan_line, plan_line_by_section_plane};
pub use line_rules::LineRules;
pub use target::{Pass, Split, Target, TargetState};
pub use tilt::{Pin, Tilt, TiltRule};
