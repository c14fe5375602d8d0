//! Fanuc: to be written.
