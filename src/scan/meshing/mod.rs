//! A triangle mesh from a cloud: the scan of a sound part becomes the nominal model, and a scan its own obstacle.
//!
//! Points are thinned to voxels, a quadric is fitted to the neighbours of each, and the surface crosses a lattice of
//! cells where the signed distance to the nearest quadrics changes its sign. Nothing is closed: where no point was
//! measured the mesh has a rim, but for holes of three cells or less. Edges are rounded over up to two cells. Everything is
//! in the frame of the cloud, mm.

mod cell_patches;
mod cell_size;
mod dual;
mod facets;
mod first_planes;
mod fit_figures;
mod lattice;
mod orientation;
mod relaxed;
#[cfg(test)]
mod sample_tests;
mod surfel;
mod surfels;
#[cfg(test)]
mod tests;

pub use orientation::Oriented;

use super::cloud::Cloud;
use crate::part::Mesh;
use crate::part::raw_part::RawFacet;
use crate::progress::{Cancelled, Progress};
use lattice::Lattice;
use nalgebra::Point3;
use surfels::{Room, Surfels};
use thiserror::Error;

/// A cloud as a surface. Every edge has one facet or two, which run along it in opposite directions.
#[derive(Clone, Debug, PartialEq)]
pub struct ScanMesh {
    /// Vertices, mm, in the frame of the cloud.
    pub vertices: Vec<Point3<f64>>,
    /// Vertices of each facet, counter-clockwise seen from outside.
    pub facets: Vec<[u32; 3]>,
    /// Edges with one facet: where the scan ends, or has a hole.
    pub rim_edges: Vec<[u32; 2]>,
    /// Side of the cells, mm: what is smaller is not told, and sheets must be four of them apart.
    pub cell_mm: f64,
    /// Standard deviation of the points across the surface, mm, by which the cells were chosen.
    pub noise_mm: f64,
    /// Mean distance of the points that were used to the mesh, mm, from an even sample of them.
    pub mean_mm: f64,
    /// Root mean square of those distances, mm.
    pub rms_mm: f64,
    /// Points that the mesh stands for.
    pub used_points: usize,
    /// Points left out: no numbers, or strays.
    pub dropped_points: usize,
    /// How outside was told from inside.
    pub oriented: Oriented,
}

/// Why a cloud becomes no mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum MeshingError {
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// Fewer finite points than tell a surface (21), or all in one line.
    #[error("{finite} points tell no surface")]
    NoSurface {
        /// Points of finite coordinates.
        finite: usize,
    },
    /// The cloud is millions of cells wide: points that are none of the part are far away.
    #[error("too wide for the density of its points")]
    TooWide,
}

impl From<Cancelled> for MeshingError {
    fn from(_: Cancelled) -> MeshingError {
        MeshingError::Cancelled
    }
}

/// Makes a mesh of a cloud, mm.
///
/// # Errors
/// The points tell no surface, or lie too far apart; [`MeshingError::Cancelled`] when the work should end.
pub fn mesh_of(cloud: &Cloud, progress: &Progress) -> Result<ScanMesh, MeshingError> {
    let is_finite = |i: &u32| cloud.offsets[*i as usize].iter().all(|c| c.is_finite());
    let finite: Vec<u32> = (0..cloud.len() as u32).filter(is_finite).collect();
    let no_surface = MeshingError::NoSurface { finite: finite.len() };
    let points = cloud.picked(&finite);
    let grain = cell_size::grain(&points, progress)?.ok_or(no_surface)?;
    let surfels = Surfels::new(&points, &grain, progress)?.ok_or(MeshingError::TooWide)?;
    if surfels.all.is_empty() {
        return Err(no_surface);
    }
    let lattice = Lattice::new(&surfels, grain.cell_mm, progress)?.ok_or(MeshingError::TooWide)?;
    let land = |p: &Point3<f64>, room: &mut Room| surfels.landed(p, grain.cell_mm, room);
    let mut faces = dual::faces(&lattice, land, progress)?;
    relaxed::relax(&mut faces, &surfels, grain.cell_mm, progress)?;
    let made = facets::facets(&faces);
    if made.facets.is_empty() {
        return Err(no_surface);
    }
    let mesh = Mesh::from_indexed_under(progress, made.vertices, made.facets)?;
    let [mean_mm, rms_mm] = fit_figures::distances_mm(&mesh, &points, &surfels.stand_for, grain.cell_mm, progress)?;
    Ok(ScanMesh {
        rim_edges: facets::rim_edges(&mesh.facets),
        vertices: mesh.vertices,
        facets: mesh.facets,
        cell_mm: grain.cell_mm,
        noise_mm: grain.noise_mm,
        mean_mm,
        rms_mm,
        used_points: points.len() - surfels.dropped,
        dropped_points: cloud.len() - points.len() + surfels.dropped,
        oriented: surfels.oriented,
    })
}

impl ScanMesh {
    /// The facets with their corners as a part's file has them, for [`crate::part::Source`]: f32, mm. The cloud has to
    /// stand near the origin: at 1 m off, places are kept to 0.06 µm, at 1 km to 0.06 mm.
    pub fn facets_f32(&self) -> Vec<RawFacet> {
        let corner = |v: u32| {
            let p = self.vertices[v as usize];
            [p.x as f32, p.y as f32, p.z as f32]
        };
        self.facets.iter().map(|f| f.map(corner)).collect()
    }
}
