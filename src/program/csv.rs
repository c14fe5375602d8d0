//! CSV: to be written.
