//! The bodies of an arm as STL files: which file stands for what, how they are read, and how far they reach. What they
//! touch is told in `cell/collision`.
//!
//! A file has the coordinates of the robot's base, as the arm stands at `at_deg`: so CAD writes an arm that was put
//! together there. Each body then moves as its joint does.

use super::link::Link;
use super::{Joints, Robot, RobotError, RobotFigureError};
use crate::cell::check::ranges;
use crate::part::{self, Part, Placement, Units};
use nalgebra::Isometry3;
use serde::Deserialize;
use std::path::Path;
use std::sync::Arc;

/// Facets of all files of an arm, at most: arms as makers offer them have 20 000 to 150 000, and far more tells
/// nothing more at the margin that is kept, but makes every look at a pose slower.
pub const MOST_MESH_FACETS: usize = 200_000;

/// A body has its joint within this share of the arm's length from the sphere around it. Bodies that are drawn in the
/// frame of their own joint, or in metres where mm are told, lie farther off: elbow and wrist by half the arm; bodies
/// of the right place have the axis in them.
const OFF_SHARE: f64 = 0.25;

/// The bodies of an arm that have a file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct LinkMeshes {
    /// Joints that the arm stands at in the files, degrees.
    pub at_deg: Joints,
    base: Option<LinkMesh>,
    j1: Option<LinkMesh>,
    j2: Option<LinkMesh>,
    j3: Option<LinkMesh>,
    j4: Option<LinkMesh>,
    j5: Option<LinkMesh>,
    j6: Option<LinkMesh>,
}

/// An STL file for one body of an arm.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LinkMesh {
    /// STL file, relative to the robot file.
    pub file: String,
    /// Unit of the file.
    #[serde(default)]
    pub unit: Units,
    /// What the file held.
    #[serde(skip)]
    solid: Arc<Part>,
}

impl PartialEq for LinkMesh {
    fn eq(&self, other: &LinkMesh) -> bool {
        (&self.file, self.unit, self.solid.digest) == (&other.file, other.unit, other.solid.digest)
    }
}

impl LinkMesh {
    /// Its facets in the base, mm, as the arm stands in the files.
    pub fn solid(&self) -> &Part {
        &self.solid
    }
}

/// Keys of the bodies: the base, and what moves with each joint.
const KEYS: [&str; 7] = [
    "links.meshes.base",
    "links.meshes.j1",
    "links.meshes.j2",
    "links.meshes.j3",
    "links.meshes.j4",
    "links.meshes.j5",
    "links.meshes.j6",
];

/// The link that each body is of.
const LINKS: [Link; 7] =
    [Link::Base, Link::Shoulder, Link::UpperArm, Link::Forearm, Link::Forearm, Link::Wrist, Link::Wrist];

impl LinkMeshes {
    fn slots(&self) -> [&Option<LinkMesh>; 7] {
        [&self.base, &self.j1, &self.j2, &self.j3, &self.j4, &self.j5, &self.j6]
    }

    /// The bodies that have a file, by the joint that moves them: 0 the base, 1 to 6.
    pub fn bodies(&self) -> impl Iterator<Item = (usize, Link, &LinkMesh)> {
        self.slots().into_iter().zip(LINKS).enumerate().filter_map(|(k, (mesh, link))| Some((k, link, mesh.as_ref()?)))
    }

    /// Whether files stand for all of a link: its capsule is left out.
    pub fn cover(&self, link: Link) -> bool {
        self.slots().into_iter().zip(LINKS).all(|(mesh, of)| of != link || mesh.is_some())
    }

    /// Reads the files, which are named relative to `folder`.
    ///
    /// # Errors
    /// One cannot be read or is no STL; it is named with its key.
    pub(super) fn load(&mut self, folder: Option<&Path>, robot_file: &str) -> Result<(), RobotError> {
        let slots =
            [&mut self.base, &mut self.j1, &mut self.j2, &mut self.j3, &mut self.j4, &mut self.j5, &mut self.j6];
        for (key, mesh) in KEYS.into_iter().zip(slots).filter_map(|(key, mesh)| Some((key, mesh.as_mut()?))) {
            let file = folder.map_or_else(|| mesh.file.clone().into(), |f| f.join(&mesh.file));
            let solid = part::load(&file, mesh.unit, &Placement::default(), &[]).map_err(|what| RobotError::Mesh {
                file: robot_file.into(),
                key,
                what,
            })?;
            mesh.solid = Arc::new(solid);
        }
        Ok(())
    }
}

impl Robot {
    /// How far any point of the bodies that have a file is from each axis that moves it, at most, mm.
    pub fn mesh_levers_mm(&self) -> Joints {
        let meshes = &self.links.meshes;
        let frames = self.frames(&meshes.at_deg);
        let mut levers_mm = [0.0; 6];
        for (k, _, mesh) in meshes.bodies() {
            let Some((centre, radius_mm)) = mesh.solid.bvh.sphere() else { continue };
            let mut reach_mm = (centre.coords - frames[k].translation.vector).norm() + radius_mm;
            // From axis to axis towards the base: neighbouring axes stay as far apart as they are.
            for j in (1..=k).rev() {
                levers_mm[j - 1] = f64::max(levers_mm[j - 1], reach_mm);
                reach_mm += apart_mm(&frames[j], &frames[j - 1]);
            }
        }
        levers_mm
    }

    /// Whether the files can be an arm.
    ///
    /// # Errors
    /// They have too many facets, or one lies far from its joint.
    pub(super) fn check_meshes(&self) -> Result<(), RobotFigureError> {
        let meshes = &self.links.meshes;
        ranges(&meshes.at_deg.map(|deg| ("links.meshes.at_deg", deg, -3600.0, 3600.0)))?;
        let facets = meshes.bodies().map(|(_, _, mesh)| mesh.solid.mesh.facets.len()).sum();
        if facets > MOST_MESH_FACETS {
            return Err(RobotFigureError::MeshFacets { facets, most: MOST_MESH_FACETS });
        }
        let frames = self.frames(&meshes.at_deg);
        for (k, _, mesh) in meshes.bodies() {
            let Some((centre, radius_mm)) = mesh.solid.bvh.sphere() else { continue };
            let off_mm = (centre.coords - frames[k].translation.vector).norm() - radius_mm;
            if off_mm > OFF_SHARE * self.reach_mm() {
                return Err(RobotFigureError::MeshOff { key: KEYS[k], file: mesh.file.clone(), off_mm });
            }
        }
        Ok(())
    }
}

fn apart_mm(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
    (a.translation.vector - b.translation.vector).norm()
}

#[cfg(test)]
#[path = "meshes_tests.rs"]
pub(super) mod tests;
