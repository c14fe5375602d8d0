//! How the beam stands at every target: path frames, interference, the corrections, the motion
//! between targets, and an independent checker.
//!
//! Part frame, millimetres and degrees. The beam here is a ray (P1); robots come later.

pub mod access;
pub mod around;
pub mod checker;
pub mod clearance;
pub mod correction;
pub mod interference;
pub mod line;
pub mod motion;
pub mod section_plane;
pub mod target;
pub mod tilt;

pub use correction::Correction;
pub use interference::{Beam, Blocker, Obstruction, ToolBody};
pub use line::{Line, LineRules, plan_line, plan_line_by_section_plane};
pub use target::{Pass, Split, State, Target};
pub use tilt::{Pin, Tilt, TiltRule};
