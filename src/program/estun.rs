//! Estun: to be written.
