//! The surfaces of a part while the operator's edits are made one by one, and their fingerprints.

use super::file_frame::{FileFrame, LoadedAs};
use super::fingerprint::{Fingerprint, FormWord, Landmark};
use crate::part::numbering::Numbering;
use crate::part::shape::Shape;
use crate::part::surface::{Surface, listed};
use crate::part::{Part, SurfaceEdit, SurfaceRule};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// The surfaces of a part at one moment.
#[derive(Clone)]
pub(super) struct Segmentation<'a> {
    part: &'a Part,
    frame: FileFrame,
    flipped_shells: &'a [u32],
    numbering: Numbering,
    list: Vec<Surface>,
    /// Count and area of the neighbours of each surface in `list`, mm².
    neighbours: Vec<(u32, f64)>,
    /// Of surfaces whose facets have not changed since: what costs most.
    known: BTreeMap<u32, Fingerprint>,
    progress: &'a Progress,
}

impl<'a> Segmentation<'a> {
    /// Before the first edit.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so, now or later.
    pub(super) fn new(
        part: &'a Part,
        loaded: &LoadedAs<'a>,
        rule: &SurfaceRule,
        progress: &'a Progress,
    ) -> Result<Segmentation<'a>, Cancelled> {
        let mut new = Segmentation {
            part,
            frame: FileFrame::new(loaded),
            flipped_shells: loaded.flipped_shells,
            numbering: Numbering::new(&part.mesh, &part.tree, &part.dihedral_deg, rule),
            list: Vec::new(),
            neighbours: Vec::new(),
            known: BTreeMap::new(),
            progress,
        };
        new.list_again()?;
        Ok(new)
    }

    /// Makes one edit.
    pub(super) fn apply(&mut self, edit: &SurfaceEdit) -> Result<(), Cancelled> {
        self.numbering.apply(&self.part.mesh, &self.part.dihedral_deg, edit);
        for number in operands(edit) {
            self.known.remove(number);
        }
        self.list_again()
    }

    /// The highest number that was ever given out.
    pub(super) fn last_number(&self) -> u32 {
        self.numbering.last_number
    }

    /// Facets of a surface, ascending; none if it does not exist.
    pub(super) fn facets(&self, number: u32) -> &[u32] {
        self.position(number).map_or(&[], |i| &self.list[i].facets)
    }

    /// Corners of a facet in the file.
    pub(super) fn corners(&self, facet: u32) -> [Point3<f64>; 3] {
        self.part.mesh.corners(facet as usize).map(|p| self.frame.point(&p))
    }

    /// The numbers of all surfaces, the largest first.
    pub(super) fn largest_first(&self) -> Vec<u32> {
        let mut order: Vec<&Surface> = self.list.iter().collect();
        order.sort_by(|a, b| b.area_mm2.total_cmp(&a.area_mm2).then(a.number.cmp(&b.number)));
        order.iter().map(|s| s.number).collect()
    }

    /// One surface as it is now.
    pub(super) fn landmark(&self, number: u32) -> Option<Landmark> {
        let i = self.position(number)?;
        let print = self.known.get(&number).copied().unwrap_or_else(|| self.measured(&self.list[i]));
        let (neighbours, area) = self.neighbours[i];
        Some(Landmark { number, print: Fingerprint { neighbours, neighbour_area: self.frame.area(area), ..print } })
    }

    /// All surfaces as they are now; what was measured is kept.
    pub(super) fn landmarks(&mut self) -> Result<Vec<Landmark>, Cancelled> {
        let numbers: Vec<u32> = self.list.iter().map(|s| s.number).collect();
        let now = |&n: &u32| self.progress.check().map(|()| self.landmark(n)).transpose();
        let all = numbers.par_iter().filter_map(now).collect::<Result<Vec<Landmark>, Cancelled>>()?;
        self.known = all.iter().map(|l| (l.number, l.print)).collect();
        Ok(all)
    }

    fn position(&self, number: u32) -> Option<usize> {
        self.list.binary_search_by_key(&number, |s| s.number).ok()
    }

    fn list_again(&mut self) -> Result<(), Cancelled> {
        let (mesh, of_facet) = (&self.part.mesh, &self.numbering.of_facet);
        self.progress.check()?;
        self.list = listed(mesh, of_facet);
        self.progress.check()?;
        let mut borders: Vec<(u32, u32)> = (0..mesh.edges.len() as u32)
            .flat_map(|e| mesh.edge_facets(e).windows(2))
            .map(|pair| (of_facet[pair[0] as usize], of_facet[pair[1] as usize]))
            .filter(|(a, b)| a != b)
            .flat_map(|(a, b)| [(a, b), (b, a)])
            .collect();
        self.progress.check()?;
        borders.par_sort_unstable();
        borders.dedup();
        self.progress.check()?;
        self.neighbours = vec![(0, 0.0); self.list.len()];
        for (a, b) in borders {
            if let (Some(i), Some(j)) = (self.position(a), self.position(b)) {
                self.neighbours[i].0 += 1;
                self.neighbours[i].1 += self.list[j].area_mm2;
            }
        }
        Ok(())
    }

    /// All but the neighbours.
    fn measured(&self, surface: &Surface) -> Fingerprint {
        let (area, centroid, normal) = self.sums(surface);
        let (form, size) = match Shape::of(&self.part.mesh, surface) {
            Shape::Plane { .. } => (FormWord::Plane, 0.0),
            Shape::Cylinder { diameter_mm, .. } => (FormWord::Cylinder, self.frame.length(diameter_mm)),
            Shape::Cone { half_angle_deg, .. } => (FormWord::Cone, half_angle_deg),
            Shape::Sphere { diameter_mm, .. } => (FormWord::Sphere, self.frame.length(diameter_mm)),
            Shape::Freeform => (FormWord::Freeform, 0.0),
        };
        Fingerprint {
            area: self.frame.area(area),
            centroid: self.frame.point(&centroid),
            mean_normal: self.frame.direction(&normal),
            form,
            size,
            neighbours: 0,
            neighbour_area: 0.0,
        }
    }

    /// Area, centroid and mean normal in the part frame, flipped shells turned back.
    fn sums(&self, surface: &Surface) -> (f64, Point3<f64>, Vector3<f64>) {
        let (mesh, shell_of) = (&self.part.mesh, &self.part.orientation.shell_of);
        let first = surface.facets.first().map_or(Point3::origin(), |&f| mesh.centroid(f as usize));
        let (mut area, mut moment, mut normal) = (0.0, Vector3::zeros(), Vector3::zeros());
        for f in surface.facets.iter().map(|&f| f as usize) {
            let a = mesh.areas[f];
            area += a;
            moment += (mesh.centroid(f) - first) * a;
            normal += mesh.normals[f] * if self.flipped_shells.contains(&shell_of[f]) { -a } else { a };
        }
        let over = if area > 0.0 { area } else { 1.0 };
        (area, first + moment / over, normal / over)
    }
}

/// The surfaces that an edit is about.
pub(super) fn operands(edit: &SurfaceEdit) -> &[u32] {
    match edit {
        SurfaceEdit::Merge { merge } => merge,
        SurfaceEdit::Split { split, .. } => std::slice::from_ref(split),
        SurfaceEdit::Cut { cut, .. } => std::slice::from_ref(cut),
    }
}
