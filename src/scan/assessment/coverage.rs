//! Which area of the model has no points.
