//! Nearest points of a cloud.
