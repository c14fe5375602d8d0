//! The arm of a robot: the files of its bodies where it has any, else rods and balls from its own figures.

use super::palette::Rgb;
use super::solid::{ColoredSolid, along};
use super::tool::facets;
use crate::cell::robot::{LinkCapsule, LinkMesh};
use crate::cell::{Joints, Robot};
use crate::view::MeshItem;
use nalgebra::Isometry3;

const LINK: Rgb = [206, 212, 220];
const JOINT: Rgb = [70, 80, 96];

/// Links shorter than this are balls.
const LEAST_LINK_MM: f64 = 1.0;

/// Solids of an arm, made once.
#[derive(Clone, Debug)]
pub(super) struct ArmPicture {
    /// On the floor, if the base is a capsule.
    plate: Option<ColoredSolid>,
    /// `None`: files stand for all of the link.
    links: [Option<ColoredSolid>; 5],
    /// Shoulder, elbow, wrist, each where both links that meet there are capsules.
    joints: [Option<ColoredSolid>; 3],
    flange: Option<ColoredSolid>,
    bodies: Vec<ArmBody>,
}

/// A body that has a file.
#[derive(Clone, Debug)]
struct ArmBody {
    /// Which of [`Robot::frames`] moves it.
    frame: usize,
    item: MeshItem,
    frame_from_drawn: Isometry3<f64>,
}

impl ArmPicture {
    /// The solids of a robot, whose links are as long as those capsules.
    pub fn new(robot: &Robot, capsules: &[LinkCapsule; 5]) -> ArmPicture {
        let meshes = &robot.links.meshes;
        let is_rod = capsules.map(|c| !meshes.cover(c.link));
        let length = |i: usize| (capsules[i].to - capsules[i].from).norm();
        // The column stands on the floor, and the flange is flat.
        let rod = |i: usize| {
            ColoredSolid::rod(capsules[i].radius_mm, length(i), [i > 0, i < 4 || length(4) < LEAST_LINK_MM], LINK)
        };
        let ball = |i: usize| {
            let radius_mm = 1.03 * capsules[i].radius_mm.max(capsules[i + 1].radius_mm);
            (is_rod[i] && is_rod[i + 1]).then(|| ColoredSolid::rod(radius_mm, 0.0, [true, true], JOINT))
        };
        let disc = |i: usize, share: f64, mm: f64| {
            is_rod[i].then(|| ColoredSolid::rod(share * capsules[i].radius_mm, mm, [false, false], JOINT))
        };
        let drawn = robot.frames(&meshes.at_deg);
        let body = |(frame, _, mesh): (usize, _, &LinkMesh)| ArmBody {
            frame,
            item: facets(mesh.solid(), LINK, 255),
            frame_from_drawn: drawn[frame].inverse(),
        };
        ArmPicture {
            plate: disc(0, 1.35, 14.0),
            links: std::array::from_fn(|i| is_rod[i].then(|| rod(i))),
            joints: [ball(1), ball(2), ball(3)],
            flange: disc(4, 0.85, 5.0),
            bodies: meshes.bodies().map(body).collect(),
        }
    }

    /// Where they stand at some joints.
    pub fn solids(&self, robot: &Robot, joints_deg: &Joints) -> Vec<MeshItem> {
        let (capsules, base_from_flange) = robot.stand(joints_deg);
        let mut items: Vec<MeshItem> = self.plate.iter().map(|p| p.at(Isometry3::identity())).collect();
        let links = self.links.iter().zip(&capsules);
        items.extend(links.filter_map(|(link, c)| Some(link.as_ref()?.at(along(&c.from, &c.to)))));
        let joints = self.joints.iter().zip(&capsules[1..4]);
        let place = |c: &LinkCapsule| Isometry3::translation(c.to.x, c.to.y, c.to.z);
        items.extend(joints.filter_map(|(ball, c)| Some(ball.as_ref()?.at(place(c)))));
        items.extend(self.flange.iter().map(|f| f.at(base_from_flange)));
        let frames = robot.frames(joints_deg);
        let at = |b: &ArmBody| MeshItem { scene_from_item: frames[b.frame] * b.frame_from_drawn, ..b.item.clone() };
        items.extend(self.bodies.iter().map(at));
        items
    }
}
