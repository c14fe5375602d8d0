//! Ur: to be written.
