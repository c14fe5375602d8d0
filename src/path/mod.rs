//! Where the spot travels: the lines of each strategy, their normals and neighbours, their ends at the rim, chord
//! error, working order, and what no line reaches.
//!
//! Part frame, millimetres. Whether a beam can get there is decided in `pose`.

pub mod along;
pub mod along_rim;
pub mod back_and_forth;
pub mod chord;
pub mod coverage;
pub mod dense;
pub mod ends;
mod key_index;
pub mod live_facets;
pub mod measured_lines;
pub mod motion_time;
mod narrowest;
pub mod neighbour_axes;
pub mod normals;
pub mod order;
pub mod planes;
pub mod reduce;
pub mod section;
pub mod strategy;
mod suited_direction;
pub mod tour;

pub use dense::DensePoint;
pub use neighbour_axes::AxisSource;
pub use order::Order;
pub use planes::{Direction, DirectionError, SurfacePlanes};
pub use section::{SectionPoint, TransversalLine};
pub use strategy::{LinesFinding, Strategy};
