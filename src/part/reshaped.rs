//! A part whose vertices stand elsewhere: what follows from their places is made anew.

use super::merge_tree::dihedral_angles_under;
use super::{Bvh, Hasher, MergeTree, Part};
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;

/// The part with its vertices at these places, part frame, mm; as many as it has. Facets, shells and the figures of its
/// file stay.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn reshaped(part: &Part, vertices: Vec<Point3<f64>>, progress: &Progress) -> Result<Part, Cancelled> {
    let mut mesh = part.mesh.clone();
    mesh.vertices = vertices;
    mesh.update_geometry_under(progress)?;
    let dihedral_deg = dihedral_angles_under(progress, &mesh)?;
    let tree = MergeTree::built(&mesh, &dihedral_deg, progress)?;
    let digest = Hasher::default().digest(part.digest).of(&mesh.vertices[..]).finish();
    Ok(Part { bvh: Bvh::built(&mesh, progress)?, dihedral_deg, tree, digest, mesh, ..part.clone() })
}
