//! The shipped samples are what the generator makes, byte for byte, and each has a job that plans.
//!
//! `CLEARBEAM_BLESS=1 cargo test --test samples` writes them anew.

use clearbeam::sample::{SAMPLES, stl_bytes};
use std::path::PathBuf;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/samples")
}

#[test]
fn the_files_are_what_the_generator_makes() {
    let bless = std::env::var_os("CLEARBEAM_BLESS").is_some();
    for s in SAMPLES {
        let file = folder().join(format!("{}.stl", s.name));
        let made = stl_bytes(&(s.triangles)());
        if bless {
            std::fs::write(&file, &made).expect("writes");
        }
        let shipped = std::fs::read(&file).unwrap_or_default();
        assert!(shipped == made, "{} differs from the generator's", file.display());
    }
}
