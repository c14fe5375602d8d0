//! A job with all files that it names, in one archive to hand over: `NAME.clearbeam`.
//!
//! The archive is a zip of `package.toml`, which tells its `schema`, `job.toml`, the files that the job names in folders of
//! their own under `files/`, each with what it names itself, and a picture. A package is unpacked before it is worked on: the
//! job in it is a readable file like any other.

mod error;
mod pack;
mod unpack;

pub use error::PackageError;
pub use pack::pack;
pub use unpack::{is_package, unpack, unpacked, unpacked_in};

use serde::{Deserialize, Serialize};

/// Ending of a package.
pub const ENDING: &str = "clearbeam";
/// The form that is written, and the latest that is read.
const SCHEMA: u32 = 1;
const ABOUT: &str = "package.toml";
const JOB: &str = "job.toml";
const THUMBNAIL: &str = "thumbnail.png";
const FILES: &str = "files";

/// What a package says of itself.
#[derive(Serialize, Deserialize)]
struct AboutPackage {
    schema: u32,
}
