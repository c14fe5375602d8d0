//! The links of an arm: how thick their capsules are, where those are at some joints, and the files of their shapes.

use super::link::Link;
use super::meshes::LinkMeshes;
use super::{Joints, Robot};
use nalgebra::{Isometry3, Point3};
use serde::Deserialize;

/// Radii of the capsules that stand for the arm, mm, and what stands for it in their place.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Links {
    /// Base to axis 2.
    pub base_mm: f64,
    /// Around axis 2.
    pub shoulder_mm: f64,
    /// Axis 2 to axis 3.
    pub upper_arm_mm: f64,
    /// Axis 3 to the wrist.
    pub forearm_mm: f64,
    /// Wrist to flange.
    pub wrist_mm: f64,
    /// STL files of its bodies.
    #[serde(default)]
    pub meshes: LinkMeshes,
}

/// A link as a capsule in the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkCapsule {
    /// The link.
    pub link: Link,
    /// Start of its axis, mm.
    pub from: Point3<f64>,
    /// End of its axis, mm.
    pub to: Point3<f64>,
    /// Radius, mm.
    pub radius_mm: f64,
}

impl Robot {
    /// The arm as capsules in the base, from the base to the flange.
    pub fn capsules(&self, joints_deg: &Joints) -> [LinkCapsule; 5] {
        self.stand(joints_deg).0
    }

    /// The arm as capsules in the base, from the base to the flange, and the pose of the flange.
    pub fn stand(&self, joints_deg: &Joints) -> ([LinkCapsule; 5], Isometry3<f64>) {
        let ([shoulder, elbow, wrist, flange], base_from_flange) = match (&self.opw, &self.ur) {
            (Some(opw), _) => opw.stand(joints_deg),
            (None, Some(ur)) => ur.stand(joints_deg),
            (None, None) => ([Point3::origin(); 4], Isometry3::identity()),
        };
        let column = Point3::new(0.0, 0.0, shoulder.z);
        let l = &self.links;
        let link = |link, from, to, radius_mm| LinkCapsule { link, from, to, radius_mm };
        let capsules = [
            link(Link::Base, Point3::origin(), column, l.base_mm),
            link(Link::Shoulder, column, shoulder, l.shoulder_mm),
            link(Link::UpperArm, shoulder, elbow, l.upper_arm_mm),
            link(Link::Forearm, elbow, wrist, l.forearm_mm),
            link(Link::Wrist, wrist, flange, l.wrist_mm),
        ];
        (capsules, base_from_flange)
    }
}
