//! The arm's own bodies: where they are at some joints, and which of its links may touch each other.

use super::contact::BodyId;
use super::shapes::{Capsule, CollisionBody, CollisionSolid};
use crate::cell::robot::LinkMesh;
use crate::cell::{Joints, Link, Robot};
use nalgebra::Isometry3;

/// Poses at which links are tried against each other, beside home.
const POSES: u32 = 64;

/// What the steps of the sequence of poses are made of: the root of x⁷ = x + 1, whose powers fill six dimensions evenly
/// (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
const EVEN: f64 = 1.112_775_684_278_705_5;

/// The bodies of an arm, made ready for many poses.
#[derive(Clone, Debug)]
pub(super) struct ArmBodies<'a> {
    robot: &'a Robot,
    /// Those that have a file, each in the frame that moves it.
    meshes: Vec<MeshBody<'a>>,
}

#[derive(Clone, Debug)]
struct MeshBody<'a> {
    link: Link,
    /// Which of [`Robot::frames`] moves it.
    frame: usize,
    solid: CollisionSolid<'a>,
}

/// An arm at some joints, in the base.
pub(super) struct ArmAt<'a> {
    /// From the base to the wrist.
    pub links: [LinkAt<'a>; 5],
    pub base_from_flange: Isometry3<f64>,
}

/// A link at some joints, in the base.
pub(super) struct LinkAt<'a> {
    pub id: BodyId,
    /// `None`: its files stand for all of it.
    capsule: Option<Capsule>,
    solids: Vec<CollisionSolid<'a>>,
}

impl<'a> LinkAt<'a> {
    /// The shapes that stand for it.
    pub fn bodies(&self) -> impl Iterator<Item = CollisionBody<'_, 'a>> {
        self.capsule.iter().map(|c| CollisionBody::Capsule(*c)).chain(self.solids.iter().map(CollisionBody::Solid))
    }

    fn is_near(&self, other: &LinkAt<'a>, margin_mm: f64) -> bool {
        self.bodies().any(|a| other.bodies().any(|b| a.is_near(&b, margin_mm)))
    }
}

impl<'a> ArmBodies<'a> {
    /// The bodies of a robot.
    pub fn new(robot: &'a Robot) -> ArmBodies<'a> {
        let meshes = &robot.links.meshes;
        let drawn = robot.frames(&meshes.at_deg);
        let body = |(frame, link, mesh): (usize, Link, &'a LinkMesh)| {
            let solid = CollisionSolid::new(BodyId::Link(link), mesh.solid(), drawn[frame].inverse())?;
            Some(MeshBody { link, frame, solid })
        };
        ArmBodies { robot, meshes: meshes.bodies().filter_map(body).collect() }
    }

    /// Where they are at some joints.
    pub fn at(&self, joints_deg: &Joints) -> ArmAt<'a> {
        let (capsules, base_from_flange) = self.robot.stand(joints_deg);
        // Frames are dear, and most arms are capsules alone.
        let frames = if self.meshes.is_empty() { None } else { Some(self.robot.frames(joints_deg)) };
        let links = capsules.map(|c| {
            let of_link = self.meshes.iter().filter(|m| m.link == c.link);
            let solids = frames.iter().flat_map(|f| of_link.clone().map(|m| m.solid.moved(&f[m.frame])));
            let is_covered = self.robot.links.meshes.cover(c.link);
            LinkAt {
                id: BodyId::Link(c.link),
                capsule: (!is_covered).then(|| Capsule::of_link(&c)),
                solids: solids.collect(),
            }
        });
        ArmAt { links, base_from_flange }
    }

    /// Links that may touch each other, by their places in the arm, the one nearer the base first.
    ///
    /// Neighbours meet in their joint, and are left out; so are two links that are near each other at home and at all
    /// [`POSES`] within the limits: shapes that overlap whatever the arm does say nothing about where it stands. Of
    /// the shipped arms that is the base with the upper arm, whose capsules share the shoulder; of all other pairs the
    /// one that is near most often, base and forearm of the MZ04, is so at a third of all poses, and most are below a
    /// tenth.
    pub fn own_pairs(&self, home_deg: &Joints, margin_mm: f64) -> Vec<[usize; 2]> {
        let poses: Vec<Joints> =
            std::iter::once(*home_deg).chain((0..POSES).map(|i| pose(&self.robot.limits_deg, i))).collect();
        let mut always: Vec<[usize; 2]> = (0..5).flat_map(|i| (i + 2..5).map(move |j| [i, j])).collect();
        let all = always.clone();
        for joints in &poses {
            if always.is_empty() {
                break;
            }
            let arm = self.at(joints);
            always.retain(|&[i, j]| arm.links[i].is_near(&arm.links[j], margin_mm));
        }
        all.into_iter().filter(|pair| !always.contains(pair)).collect()
    }
}

/// One of a sequence of poses that fills the limits evenly.
fn pose(limits_deg: &[[f64; 2]; 6], i: u32) -> Joints {
    let mut step = 1.0;
    std::array::from_fn(|k| {
        step /= EVEN;
        let share = (0.5 + f64::from(i) * step).fract();
        let [low, high] = limits_deg[k];
        low + (high - low) * share
    })
}

#[cfg(test)]
#[path = "arm_tests.rs"]
mod tests;
