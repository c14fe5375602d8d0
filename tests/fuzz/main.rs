//! Every reader of files that come from outside, given files that nobody would write: parts, jobs, recipes, cells, robots,
//! heads, images and cameras, and programs of every dialect. It may refuse them; it may not panic, run on without an end,
//! take memory for what a file only promises, or give what does not hold.
//!
//! A test for each kind. It tries what the project itself writes, then the files of `tests/fuzz/corpus/KIND` (made by
//! hand, or found here before: what fails is put there under the name of its digest), then a few hundred changes of
//! those. The changes are the same in every run. By hand, as many as are asked for:
//! `CLEARBEAM_FUZZ=10000000 cargo test --release --test fuzz ply -- --nocapture`.

mod bundle;
mod documents;
mod mutation;
mod part_files;
mod programs;
#[path = "../common/random.rs"]
mod random;
mod run;
mod setups;
#[path = "../common/small_programs.rs"]
mod small_programs;
mod welds;
