//! Moves between lit pieces, the laser off: the space around the part that they lead through, lead-ins and
//! lead-outs, and the moves themselves: those of the focus without a robot, those that an arm can make with one.

pub mod lead;
pub mod pieces;
pub mod pose_cache;
pub mod transfer_space;
pub mod with_robot;
pub mod without_robot;
