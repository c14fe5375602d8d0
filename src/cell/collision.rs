//! Whether anything in the cell touches, at one pose of the robot, and how far it keeps from it:
//! links, what the robot carries, and what stands.
//!
//! Links are capsules, or the facets of their files; the head is capsules; part, clamps and fixtures are their facets;
//! distances between them are exact. Links are tested against each other as well. What stands is not tested against
//! what stands (the robot's base among it), nor a link against its neighbours, nor the wrist against what it carries.

mod arm;
mod contact;
mod pairs;
mod shapes;
mod sweep;

use super::{Joints, Mount, Setup};
use crate::beam::Obstacle;
use crate::part::Part;
use arm::ArmBodies;
use nalgebra::Isometry3;
use shapes::{Capsule, CollisionSolid};
use std::ops::ControlFlow;

pub use contact::{BodyId, Contact};

/// Everything that can touch, made ready for many poses.
#[derive(Clone, Debug)]
pub struct Collision<'a> {
    arm: ArmBodies<'a>,
    /// Links that may touch each other, by their places in the arm.
    own_pairs: Vec<[usize; 2]>,
    /// What stands, in the base.
    standing: Bodies<'a>,
    /// What hangs on the flange, in the flange.
    carried: Bodies<'a>,
    table_z_mm: Option<f64>,
    margin_mm: f64,
    /// How far any point of arm and load is from each axis that moves it, at most, mm.
    levers_mm: Joints,
}

/// Bodies that stand or move as one.
#[derive(Clone, Debug, Default)]
struct Bodies<'a> {
    head: Vec<Capsule>,
    solids: Vec<CollisionSolid<'a>>,
}

/// Clearance is told up to here, mm: nothing that keeps a hand's width away is in danger, and the
/// search for what is nearest ends early.
pub const CLEARANCE_REACH_MM: f64 = 100.0;

/// Links keep the margin from each other, but no more than this, mm: a wide margin is for what is not known of where
/// things stand in the cell, and the links of one arm stand where its joints say.
const MOST_OWN_MARGIN_MM: f64 = 5.0;

impl<'a> Collision<'a> {
    /// What may touch in a cell with this part; `None`: there is no robot that could touch anything.
    pub fn new(setup: &'a Setup, part: &'a Part) -> Option<Collision<'a>> {
        let robot = setup.robot.as_ref()?;
        let (cell, bodies) = (&setup.cell, &setup.cell.bodies);
        let obstacle = |(index, o): (usize, &'a Obstacle)| {
            let id = BodyId::Obstacle { index, file: o.file.as_str().into() };
            CollisionSolid::new(id, o.solid(), o.at())
        };
        let obstacles = bodies.obstacles.iter().enumerate().filter_map(obstacle);
        let head = |focus: Isometry3<f64>| bodies.head.iter().map(|h| Capsule::of(h, &focus)).collect();
        let (standing, carried) = match setup.mount {
            Mount::PartInHand => (
                Bodies { head: head(cell.base_from_laser.isometry()), solids: obstacles.collect() },
                Bodies { head: Vec::new(), solids: with_clamps(setup, part, &cell.flange_from_part.isometry()) },
            ),
            Mount::ToolInHand => {
                let lying = with_clamps(setup, part, &cell.base_from_part.isometry());
                (
                    Bodies { head: Vec::new(), solids: obstacles.chain(lying).collect() },
                    Bodies { head: head(cell.flange_from_focus()), solids: Vec::new() },
                )
            }
        };
        let (reach_mm, links_mm, mesh_mm) = (carried.reach_mm(), robot.levers_mm(), robot.mesh_levers_mm());
        let arm = ArmBodies::new(robot);
        Some(Collision {
            own_pairs: arm.own_pairs(&setup.home_joints_deg(), own_margin_mm(bodies.margin_mm)),
            arm,
            standing,
            carried,
            table_z_mm: bodies.table_z_mm,
            margin_mm: bodies.margin_mm,
            levers_mm: std::array::from_fn(|i| f64::max(links_mm[i] + reach_mm, mesh_mm[i])),
        })
    }

    /// The first contact at a pose of the robot, in an order that is always the same; joints in
    /// degrees.
    pub fn first_contact(&self, joints_deg: &Joints) -> Option<Contact> {
        let met = self.visit_pairs(joints_deg, &mut |pair, one, other| {
            if !one.is_near(other, pair.margin_mm) {
                return ControlFlow::Continue(());
            }
            ControlFlow::Break(Contact::from(pair))
        });
        met.break_value()
    }

    /// Distance of the two bodies that are nearest each other at a pose of the robot, mm, 0 where they
    /// touch; of equals the first in the order of [`Self::first_contact`]. `None`: all keep farther apart than
    /// [`CLEARANCE_REACH_MM`].
    pub fn clearance(&self, joints_deg: &Joints) -> Option<(f64, Contact)> {
        let mut nearest = None;
        let mut within_mm = CLEARANCE_REACH_MM;
        let _: ControlFlow<()> = self.visit_pairs(joints_deg, &mut |pair, one, other| {
            if let Some(mm) = one.distance_mm(other, within_mm) {
                within_mm = mm;
                nearest = Some((mm, pair.into()));
            }
            ControlFlow::Continue(())
        });
        nearest
    }

    /// The distance that everything keeps, mm; links keep `MOST_OWN_MARGIN_MM` of each other at most.
    pub fn margin_mm(&self) -> f64 {
        self.margin_mm
    }
}

/// The distance that links of the arm keep from each other, mm.
fn own_margin_mm(margin_mm: f64) -> f64 {
    margin_mm.min(MOST_OWN_MARGIN_MM)
}

/// The part and the job's clamps on it, where the part's frame is `at`. Obstacles of the cell stand among the clamps of
/// a tool in hand, and are looked at as what they are; where a scan ends the arm that holds the part begins.
fn with_clamps<'a>(setup: &'a Setup, part: &'a Part, at: &Isometry3<f64>) -> Vec<CollisionSolid<'a>> {
    let clamps = setup.tool.clamps.iter().enumerate().filter(|(_, c)| !c.is_of_cell() && !c.is_unscanned());
    let clamp = |(index, c): (usize, &'a Obstacle)| {
        let id = BodyId::Clamp { index, file: c.file.as_str().into() };
        CollisionSolid::new(id, c.solid(), at * c.at())
    };
    CollisionSolid::new(BodyId::Part, part, *at).into_iter().chain(clamps.filter_map(clamp)).collect()
}

impl Bodies<'_> {
    /// How far from the origin of its frame anything is, mm.
    fn reach_mm(&self) -> f64 {
        let head = self.head.iter().map(|c| c.from.coords.norm().max(c.to.coords.norm()) + c.radius_mm);
        let solids = self.solids.iter().map(|s| s.centre.coords.norm() + s.radius_mm);
        head.chain(solids).fold(0.0, f64::max)
    }
}

#[cfg(test)]
#[path = "collision_tests.rs"]
mod tests;
