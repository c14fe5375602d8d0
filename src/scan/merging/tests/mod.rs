//! Scans brought together: what is kept of them, and whether overlap tells where they lie.

mod merged;
mod overlap;
