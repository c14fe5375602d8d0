//! Abb: to be written.
