//! The workpiece: reading its file (STL, OBJ, PLY, 3MF), its topology, its feature surfaces and their shapes,
//! its place in space, and rays against it.
//!
//! Everything here is in the part frame, millimetres; only `identity` compares parts in the coordinates and unit of
//! their files. Nothing here knows of section planes, beams or robots.

pub mod angle;
mod bounds;
mod box_tree;
pub mod bvh;
pub mod circle;
mod digest;
pub mod distance;
mod doubt;
mod edges;
pub mod far_from_origin;
pub mod file;
pub mod fill;
pub mod finding;
pub mod ground;
pub mod growth;
pub mod identity;
pub mod inspect;
pub mod load;
pub mod loops;
pub mod measured;
pub mod merge_tree;
mod nesting;
mod numbering;
pub mod orient;
pub mod part_figures;
pub mod patched;
pub mod placement;
mod pseudonormals;
pub mod raw_part;
pub mod reshaped;
pub mod rpy;
#[cfg(test)]
mod scale_tests;
pub mod shape;
mod shattered;
mod sides;
pub mod source;
mod surface;
mod surface_rule;
pub mod surfaces;
pub mod topology;
mod triangle;
pub mod union_find;
pub mod units;
pub mod weld;
mod workpiece;

pub use bvh::Bvh;
pub use digest::{Digest, Hasher, Keyed, file_sha256 as digest_of};
pub(crate) use digest::{keyed, keyed_words};
pub use finding::PartFinding;
pub use growth::{GrownPart, GrowthError, grown};
pub use load::load;
pub use merge_tree::MergeTree;
pub use patched::{PatchCut, PatchSurface, PatchedPart, RefinedFacets, patch_layers, with_patches};
pub use placement::Placement;
pub use pseudonormals::PseudoNormals;
pub use shape::Shape;
pub use source::{LoadError, Source};
pub use surface_rule::{SurfaceEdit, SurfaceRule};
pub use surfaces::{SurfaceId, Surfaces};
pub use topology::Mesh;
pub use units::Units;
pub use weld::Weld;
pub use workpiece::Part;
