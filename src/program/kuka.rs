//! Kuka: to be written.
