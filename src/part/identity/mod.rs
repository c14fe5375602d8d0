//! Feature surfaces found again in a part file whose bytes have changed: exported anew in another
//! order of facets, in another tessellation, or about another origin.
//!
//! A job speaks of surfaces by number, and numbers follow the order of facets. So a saved job keeps
//! [`Landmarks`]: area, centroid, mean normal, shape and neighbours of its surfaces, in the file's
//! own coordinates, so that neither unit nor placement matters. [`find()`] looks for them in the new
//! part, repeats the operator's edits there, and gives the new numbers, or says of each surface why
//! it was not found. It never guesses: what could be two is lost.
//!
//! Surfaces are sought where they were. Only if that fails is one common motion tried, first a shift,
//! then a turn with a shift; it is told, and whether to follow it is for the operator to say. A
//! surface whose form has changed is another surface, and files that were scaled are not followed.

mod alike;
mod cut_facets;
mod file_frame;
mod file_motion;
mod find;
mod fingerprint;
mod landmarks;
mod pairing;
mod segmentation;
mod shells;
mod trial;

#[cfg(test)]
mod tests;

pub use file_frame::LoadedAs;
pub use find::{FoundAgain, LostLandmark, find};
pub use landmarks::Landmarks;
pub use pairing::LostReason;
pub use trial::LostEdit;
