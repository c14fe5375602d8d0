//! A type of each message of the English files, made by the build.

// Words that nobody says would be translated for nothing.
#![deny(dead_code)]
#![allow(non_camel_case_types, reason = "types are named as their keys, so that both are found by one search")]

include!(concat!(env!("OUT_DIR"), "/messages.rs"));
