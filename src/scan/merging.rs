//! Brings several scans into one frame.
