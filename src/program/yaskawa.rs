//! Yaskawa: to be written.
