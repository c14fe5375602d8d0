//! A part with metal laid on some of its surfaces: their vertices move outwards so that each facet's plane
//! moves by the height laid on it; other facets follow at vertices that they share.
//!
//! Facets, edges and numbers stay, so surfaces stay. Where a surface is hollow with a radius less than the
//! height its facets fold over; such a growth is refused, and so nothing is planned on it.

use super::surfaces::Surfaces;
use super::topology::{FacetDefect, Mesh};
use super::{Bvh, Hasher, Part, angle};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
use std::collections::BTreeMap;
use std::sync::Arc;
use thiserror::Error;

/// A part and its surfaces with metal on them.
#[derive(Clone, Debug, Default)]
pub struct GrownPart {
    /// The part; figures of its file and merge tree are those of the bare part.
    pub part: Part,
    /// The surfaces of the bare part, with the areas that they have on this one.
    pub surfaces: Surfaces,
}

impl GrownPart {
    /// The part at its largest, of the shapes that it has one after the other: with all that is laid on, or before
    /// anything is ground off.
    pub fn largest<'a>(part: &'a Part, shapes: &'a [Arc<GrownPart>]) -> &'a Part {
        shapes.last().filter(|last| last.surfaces.grounds.is_empty()).map_or(part, |last| &last.part)
    }
}

/// Below this share of the greatest eigenvalue facets that differ in direction count as one rounded face,
/// and its vertex moves along their mean: creases from some 25° on are met exactly.
const ROUND: f64 = 0.05;

/// Why metal cannot be laid on surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum GrowthError {
    /// A surface folds, by its number.
    #[error("surface {0} folds")]
    Folds(u32),
    /// The work was cancelled.
    #[error("cancelled")]
    Cancelled,
}

impl From<Cancelled> for GrowthError {
    fn from(_: Cancelled) -> GrowthError {
        GrowthError::Cancelled
    }
}

/// What becomes of a surface that folds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Folds {
    /// It is refused: no metal can be laid so.
    AreRefused,
    /// It is taken as it is: that is how it was found.
    AreTaken,
}

/// Lays metal on surfaces: their numbers and heights, mm.
///
/// # Errors
/// The surface that folds; [`GrowthError::Cancelled`] when `progress` says so.
pub fn grown(
    part: &Part,
    surfaces: &Surfaces,
    heights_mm: &BTreeMap<u32, f64>,
    progress: &Progress,
) -> Result<GrownPart, GrowthError> {
    let height = |f: u32, _: u32| heights_mm.get(&surfaces.of_facet[f as usize]).copied();
    laid_on(part, surfaces, &height, Folds::AreRefused, progress)
}

/// Moves facets at their vertices: `height_mm` tells for a facet and one of its vertices how far outwards, mm; `None` or
/// 0: the facet does not say.
///
/// # Errors
/// The surface that folds, where that is refused; [`GrowthError::Cancelled`] when `progress` says so.
pub fn laid_on(
    part: &Part,
    surfaces: &Surfaces,
    height_mm: &dyn Fn(u32, u32) -> Option<f64>,
    folds: Folds,
    progress: &Progress,
) -> Result<GrownPart, GrowthError> {
    let height = |f: u32, v: u32| height_mm(f, v).filter(|h| *h != 0.0);
    let at = |f: u32| part.mesh.facets[f as usize].map(|v| height(f, v));
    let is_grown: Vec<bool> = (0..part.mesh.facets.len() as u32).map(|f| at(f) != [None; 3]).collect();
    let mut mesh = part.mesh.clone();
    for (v, place) in mesh.vertices.iter_mut().enumerate() {
        progress.check_at(v)?;
        let (mut spread, mut wanted) = (Matrix3::<f64>::zeros(), Vector3::<f64>::zeros());
        let facets = part.mesh.vertex_facets(v as u32).iter().copied();
        for f in facets.filter(|&f| part.mesh.defects[f as usize] == FacetDefect::None) {
            let Some(height_mm) = height(f, v as u32) else { continue };
            // Where facets are pieces the normal that their surface had goes: there and back is the same way then.
            let kept = surfaces.vertex_normal(surfaces.of_facet[f as usize], v as u32);
            let (n, weight) = (kept.unwrap_or(surfaces.normals[f as usize]), corner_deg(&part.mesh, f, v as u32));
            spread += n * n.transpose() * weight;
            wanted += n * (weight * height_mm);
        }
        *place += vertex_shift(spread, &wanted);
    }
    mesh.update_geometry_under(progress)?;
    let grown = |f: u32| is_grown[f as usize].then(|| surfaces.of_facet[f as usize]);
    if let Some(surface) =
        Some(folds).filter(|f| *f == Folds::AreRefused).and_then(|_| folded(&part.mesh, &mesh, grown))
    {
        return Err(GrowthError::Folds(surface));
    }
    progress.check()?;
    let mut normals = mesh.normals.clone();
    for (f, n) in normals.iter_mut().enumerate() {
        // A surface that is worked on from its other side stays so.
        if surfaces.normals[f] != part.mesh.normals[f] {
            *n = -*n;
        }
    }
    let list = surfaces.list.iter().map(|s| {
        let area_mm2 = s.facets.iter().map(|&f| mesh.areas[f as usize]).fold(0.0, |a, b| a + b);
        super::surfaces::Surface { area_mm2, ..s.clone() }
    });
    let surfaces = Surfaces {
        of_facet: surfaces.of_facet.clone(),
        list: list.collect(),
        normals,
        last_number: surfaces.last_number,
        worked: surfaces.worked.clone(),
        vertex_normals: surfaces.vertex_normals.clone(),
        fills: surfaces.fills.clone(),
        grounds: surfaces.grounds.clone(),
        measured: surfaces.measured.clone(),
    };
    let mut hasher = Hasher::default().digest(part.digest);
    for f in (0..is_grown.len() as u32).filter(|f| is_grown[*f as usize]) {
        hasher = hasher.u32s(&[f]).f64s(&at(f).map(|h| h.unwrap_or(0.0)));
    }
    let dihedral_deg = super::merge_tree::dihedral_angles_under(progress, &mesh)?;
    let part = Part { bvh: Bvh::built(&mesh, progress)?, dihedral_deg, digest: hasher.finish(), mesh, ..part.clone() };
    Ok(GrownPart { part, surfaces })
}

/// The grown surface at whose vertices an edge has come to run backwards, or a facet to look elsewhere: a bore
/// that closed, a floor that rose above its rim.
fn folded(before: &Mesh, mesh: &Mesh, grown: impl Fn(u32) -> Option<u32>) -> Option<u32> {
    let at = |v: u32| before.vertex_facets(v).iter().find_map(|&f| grown(f));
    let way = |m: &Mesh, [a, b]: [u32; 2]| m.vertices[b as usize] - m.vertices[a as usize];
    let backwards = |ends: &&[u32; 2]| way(mesh, **ends).dot(&way(before, **ends)) <= 0.0;
    let edge = mesh.edges.iter().find(backwards).and_then(|[a, b]| at(*a).or(at(*b)));
    let turned = |f: &u32| {
        let f = *f as usize;
        before.defects[f] == FacetDefect::None
            && (mesh.defects[f] != FacetDefect::None || mesh.normals[f].dot(&before.normals[f]) < 0.5)
    };
    edge.or_else(|| (0..mesh.facets.len() as u32).filter(turned).find_map(grown))
}

/// The angle of a facet at one of its vertices.
fn corner_deg(mesh: &Mesh, facet: u32, vertex: u32) -> f64 {
    let corners = mesh.corners(facet as usize);
    let Some(k) = mesh.facets[facet as usize].iter().position(|&v| v == vertex) else { return 0.0 };
    angle::between_deg(&(corners[(k + 1) % 3] - corners[k]), &(corners[(k + 2) % 3] - corners[k]))
}

/// The shortest shift of a vertex that moves the planes of its facets by their heights (least squares).
fn vertex_shift(spread: Matrix3<f64>, wanted: &Vector3<f64>) -> Vector3<f64> {
    let eigen = SymmetricEigen::new(spread);
    let most = eigen.eigenvalues.max();
    if most <= 0.0 {
        return Vector3::zeros();
    }
    (0..3)
        .filter(|&k| eigen.eigenvalues[k] > ROUND * most)
        .map(|k| {
            let v = eigen.eigenvectors.column(k);
            v * (v.dot(wanted) / eigen.eigenvalues[k])
        })
        .fold(Vector3::zeros(), |a, b| a + b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{Placement, Units};
    use crate::sample::{solids, stl_bytes};

    fn made(triangles: &crate::sample::Triangles) -> (Part, Surfaces) {
        let part = Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part");
        let surfaces = crate::document::segmented(&part, &crate::document::Job::default());
        (part, surfaces)
    }

    fn grown(part: &Part, surfaces: &Surfaces, heights_mm: &BTreeMap<u32, f64>) -> Result<GrownPart, GrowthError> {
        super::grown(part, surfaces, heights_mm, &Progress::default())
    }

    fn on(numbers: &[u32], height_mm: f64) -> BTreeMap<u32, f64> {
        numbers.iter().map(|n| (*n, height_mm)).collect()
    }

    #[test]
    fn a_cube_grows_by_faces_edges_and_corners() {
        let (part, surfaces) = made(&solids::cube(10.0));
        let facing = |n: Vector3<f64>| {
            surfaces.list.iter().find(|s| part.mesh.normals[s.facets[0] as usize] == n).expect("a face").number
        };
        let (top, side) = (facing(Vector3::z()), facing(Vector3::x()));
        let bounds = |numbers: &[u32]| {
            let grown = grown(&part, &surfaces, &on(numbers, 1.5)).expect("grows").part;
            let (low, high) = grown.mesh.bounds();
            assert!(grown.mesh.normals.iter().zip(&part.mesh.normals).all(|(a, b)| (a - b).norm() < 1e-12));
            (low.coords, high.coords)
        };
        let near = |a: (Vector3<f64>, Vector3<f64>), low: [f64; 3], high: [f64; 3]| {
            assert!((a.0 - Vector3::from(low)).norm() + (a.1 - Vector3::from(high)).norm() < 1e-9, "{a:?}");
        };
        near(bounds(&[top]), [0.0; 3], [10.0, 10.0, 11.5]);
        near(bounds(&[top, side]), [0.0; 3], [11.5, 10.0, 11.5]);
        near(bounds(&[1, 2, 3, 4, 5, 6]), [-1.5; 3], [11.5; 3]);
        near(bounds(&[]), [0.0; 3], [10.0; 3]);
    }

    #[test]
    fn round_faces_grow_by_the_height_everywhere() {
        let (part, surfaces) = made(&solids::cylinder(20.0, 30.0, 72));
        let round = surfaces.list.iter().max_by(|a, b| a.facets.len().cmp(&b.facets.len())).expect("one").number;
        let made_of = grown(&part, &surfaces, &on(&[round], 2.0)).expect("grows");
        for &f in &made_of.surfaces.get(round).expect("there").facets {
            let n = made_of.surfaces.normals[f as usize];
            let moved = n.dot(&(made_of.part.mesh.centroid(f as usize) - part.mesh.centroid(f as usize)));
            assert!((moved - 2.0).abs() < 1e-6, "{moved}");
        }
        assert_ne!(made_of.part.digest, part.digest);
        let (part, surfaces) = made(&solids::sphere(25.0, 90, 60));
        let ball = grown(&part, &surfaces, &on(&[1], 3.0)).expect("grows");
        for v in &ball.part.mesh.vertices {
            let radius = v.coords.norm();
            assert!((radius - 28.0).abs() < 0.01, "{radius}");
        }
    }

    #[test]
    fn what_is_hollow_closes_until_it_folds() {
        let (part, mut surfaces) = made(&solids::sphere(5.0, 60, 40));
        // Worked on from within.
        surfaces.normals.iter_mut().for_each(|n| *n = -*n);
        let within = grown(&part, &surfaces, &on(&[1], 3.0)).expect("grows");
        assert!(within.part.mesh.vertices.iter().all(|v| (v.coords.norm() - 2.0).abs() < 0.01));
        assert!(within.surfaces.normals.iter().zip(&within.part.mesh.normals).all(|(a, b)| *a == -*b));
        assert_eq!(grown(&part, &surfaces, &on(&[1], 6.0)).err(), Some(GrowthError::Folds(1)));
        // A pocket is full when its floor comes to the rim.
        let (part, surfaces) = made(&solids::blind_hole(20.0, 4.0, 6.0, 40));
        let up = |s: &&crate::part::surfaces::Surface| {
            let f = s.facets[0] as usize;
            part.mesh.normals[f].z > 0.99 && part.mesh.centroid(f).z < part.mesh.bounds().1.z - 1.0
        };
        let floor = surfaces.list.iter().find(up).expect("a floor").number;
        assert!(grown(&part, &surfaces, &on(&[floor], 5.9)).is_ok());
        assert_eq!(grown(&part, &surfaces, &on(&[floor], 6.1)).err(), Some(GrowthError::Folds(floor)));
    }
}
