//! One spiral over a surface, its turns one spacing apart (P4 5).
//!
//! It passes the radial curve of angle φ at arc length `Ns (turn + φ/2π)`. So it is where
//! `ρ/Ns − φ/2π` is a whole number, and that is cut out of every facet: every point lies on an edge and
//! every chord in a facet. Rims and holes cut it into pieces, in the order of the spiral.

use super::super::normals::VertexNormals;
use super::radial::SpiralAxis;
use super::surface_mesh::SurfaceMesh;
use super::winding::Winding;
use super::{Layout, LinesFinding, SurfaceLines, mean_normal, spacing};
use crate::part::{Mesh, angle, surfaces::Surface};
use crate::path::live_facets::live;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};

/// A chord within a facet is at most so far from the spiral, mm.
const CHORD_MM: f64 = 0.004;

pub(super) fn lines(
    mesh: &Mesh,
    surface: &Surface,
    normals: &VertexNormals,
    rule: &Layout,
    merge_mm: f64,
    progress: &Progress,
) -> Result<SurfaceLines, Cancelled> {
    let surface_mesh = SurfaceMesh::new(mesh, surface, normals, progress)?;
    let (surface_mesh, axis) = centred(mesh, surface, surface_mesh, rule, progress)?;
    let finest = rule.spacing_mm / 24.0;
    let size_mm = |p: &Point3<f64>| libm::sqrt(8.0 * CHORD_MM * axis.radius_mm(p)).max(finest);
    let surface_mesh = surface_mesh.refined(false, size_mm, progress)?;
    let winding = Winding::new(&surface_mesh, &axis, rule.spacing_mm);
    progress.check()?;
    let (mut lines, mut turns) = winding.lines(merge_mm, progress)?;
    // Near the axis a spiral leads outwards more than around, and turns lie nearer.
    let around = |p: &Point3<f64>| axis.radius_mm(p) >= 2.5 * rule.spacing_mm;
    let achieved = spacing::measured(&lines, &turns, None, around, rule.spacing_mm);
    if rule.inward {
        lines.reverse();
        turns.reverse();
        lines.iter_mut().for_each(|l| l.points.reverse());
    }
    let missed: f64 =
        (0..surface_mesh.mesh.facets.len()).filter(|&f| !winding.reaches(f)).map(|f| surface_mesh.mesh.areas[f]).sum();
    let finding = if lines.is_empty() {
        Some(LinesFinding::NoTurnFits { surface: surface.number, spacing_mm: rule.spacing_mm })
    } else if missed > rule.spacing_mm * rule.spacing_mm {
        Some(LinesFinding::BeyondSpiral { surface: surface.number, area_mm2: missed })
    } else {
        None
    };
    Ok(SurfaceLines { lines, achieved, planes: Vec::new(), finding })
}

/// Where the spiral turns about, its centre a vertex of the surface mesh.
///
/// The middle is the centroid of the area, or the given point; its normal line meets the surface in the
/// centre. Where it meets nothing, the centre is a hole. A closed surface has no mean normal; then it is z.
fn centred(
    mesh: &Mesh,
    surface: &Surface,
    surface_mesh: SurfaceMesh,
    rule: &Layout,
    progress: &Progress,
) -> Result<(SurfaceMesh, SpiralAxis), Cancelled> {
    let (sum, area) = live(mesh, surface)
        .fold((Vector3::zeros(), 0.0), |(s, a), f| (s + mesh.centroid(f).coords * mesh.areas[f], a + mesh.areas[f]));
    let middle = rule.centre.unwrap_or(Point3::from(sum / f64::max(area, 1e-300)));
    let mean = mean_normal(mesh, surface);
    let along = mean.unwrap_or_else(Vector3::z);
    // On a closed surface the far end of the line; else the nearest place.
    let hits = (0..surface_mesh.mesh.facets.len() as u32).filter_map(|f| {
        let (weights, height) = pierced(&surface_mesh.mesh.corners(f as usize), &middle, &along)?;
        Some((if mean.is_some() || rule.centre.is_some() { height.abs() } else { -height }, f, weights))
    });
    let hit = hits.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let axis = |at: Point3<f64>, along: Vector3<f64>, vertex: Option<u32>| {
        let u = angle::any_square_to(&along);
        SpiralAxis { at, along, u, v: along.cross(&u), vertex }
    };
    let Some((_, facet, weights)) = hit else { return Ok((surface_mesh, axis(middle, along, None))) };
    let own = surface_mesh.mesh.normals[facet as usize];
    let (surface_mesh, vertex) = surface_mesh.with_vertex(facet, weights, progress)?;
    // Vertex normals look to the side that is worked on; the curves need that of the facets.
    let there = surface_mesh.normals[vertex as usize];
    let there = if there.dot(&own) < 0.0 { -there } else { there };
    let at = surface_mesh.mesh.vertices[vertex as usize];
    Ok((surface_mesh, axis(at, angle::unit(there).unwrap_or(own), Some(vertex))))
}

/// Where a line meets a facet: weights of its corners, and height along the line.
fn pierced(corners: &[Point3<f64>; 3], p: &Point3<f64>, along: &Vector3<f64>) -> Option<([f64; 3], f64)> {
    let [a, b, c] = corners.map(|q| q - p);
    let parts = [b.cross(&c).dot(along), c.cross(&a).dot(along), a.cross(&b).dot(along)];
    let whole: f64 = parts.iter().sum();
    let weights = parts.map(|x| x / whole);
    let height = (a * weights[0] + b * weights[1] + c * weights[2]).dot(along);
    (whole != 0.0 && height.is_finite() && weights.iter().all(|w| *w >= -1e-9)).then(|| {
        let kept = weights.map(|w| w.max(0.0));
        let sum: f64 = kept.iter().sum();
        (kept.map(|w| w / sum), height)
    })
}
