//! The guided tour: the first job on the workpiece, step by step. A step is done when the operator has done it in the
//! window, by whatever way.

mod following;
pub(super) mod state;
