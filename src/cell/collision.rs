//! Whether anything in the cell touches, at one pose of the robot, and how far it keeps from it:
//! links, what the robot carries, and what stands.
//!
//! Links and head are capsules, part and fixtures their facets; distances between them are exact.
//! What stands is not tested against what stands (the robot's base among it), nor a link against its
//! neighbours, nor the wrist against what it carries.

mod contact;
mod shapes;

use super::robot::LinkCapsule;
use super::{Joints, Mount, Robot, Setup};
use crate::beam::Obstacle;
use crate::part::Part;
use nalgebra::Isometry3;
use shapes::{Capsule, CollisionBody, CollisionSolid};
use std::ops::ControlFlow;

pub use contact::{BodyId, Contact};

/// Everything that can touch, made ready for many poses.
#[derive(Clone, Debug)]
pub struct Collision<'a> {
    robot: &'a Robot,
    /// What stands, in the base.
    standing: Vec<CollisionSolid<'a>>,
    /// A head that stands, in the base.
    standing_head: Vec<Capsule>,
    carried: Carried<'a>,
    table_z_mm: Option<f64>,
    margin_mm: f64,
    /// See [`Robot::levers_mm`], with what is carried.
    levers_mm: [f64; 6],
}

/// What hangs on the flange, in the flange.
#[derive(Clone, Debug)]
enum Carried<'a> {
    Part(CollisionSolid<'a>),
    Head(Vec<Capsule>),
}

/// A look at two bodies: which they are, and their shapes.
type Look<'l, B> = dyn FnMut(Pair<'_>, &CollisionBody<'_, '_>, &CollisionBody<'_, '_>) -> ControlFlow<B> + 'l;

/// Two bodies that may touch.
#[derive(Clone, Copy)]
struct Pair<'p>(&'p BodyId, &'p BodyId);

impl From<Pair<'_>> for Contact {
    fn from(Pair(a, b): Pair<'_>) -> Contact {
        Contact { a: a.clone(), b: b.clone() }
    }
}

/// Clearance is told up to here, mm: nothing that keeps a hand's width away is in danger, and the
/// search for what is nearest ends early.
pub const CLEARANCE_REACH_MM: f64 = 100.0;

impl<'a> Collision<'a> {
    /// What may touch in a cell with this part; `None`: there is no robot that could touch anything.
    pub fn new(setup: &'a Setup, part: &'a Part) -> Option<Collision<'a>> {
        let robot = setup.robot.as_ref()?;
        let (cell, bodies) = (&setup.cell, &setup.cell.bodies);
        let obstacle = |(index, o): (usize, &'a Obstacle)| {
            let id = BodyId::Obstacle { index, file: o.file.as_str().into() };
            CollisionSolid::new(id, o.solid(), o.at())
        };
        let mut standing: Vec<CollisionSolid<'a>> = bodies.obstacles.iter().enumerate().filter_map(obstacle).collect();
        let head = |focus: Isometry3<f64>| bodies.head.iter().map(|h| Capsule::of(h, &focus)).collect::<Vec<_>>();
        let (standing_head, carried) = match setup.mount {
            Mount::PartInHand => {
                let part = CollisionSolid::new(BodyId::Part, part, cell.flange_from_part.isometry());
                (head(cell.base_from_laser.isometry()), part.map_or(Carried::Head(Vec::new()), Carried::Part))
            }
            Mount::ToolInHand => {
                standing.extend(CollisionSolid::new(BodyId::Part, part, cell.base_from_part.isometry()));
                (Vec::new(), Carried::Head(head(cell.flange_from_focus())))
            }
        };
        let reach = carried.reach_mm();
        Some(Collision {
            robot,
            standing,
            standing_head,
            carried,
            table_z_mm: bodies.table_z_mm,
            margin_mm: bodies.margin_mm,
            levers_mm: robot.levers_mm().map(|lever| lever + reach),
        })
    }

    /// The first contact at a pose of the robot, in an order that is always the same; joints in
    /// degrees.
    pub fn first_contact(&self, joints_deg: &Joints) -> Option<Contact> {
        let met = self.visit_pairs(joints_deg, &mut |pair, one, other| {
            if !one.is_near(other, self.margin_mm) {
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

    /// The distance that everything keeps, mm.
    pub fn margin_mm(&self) -> f64 {
        self.margin_mm
    }

    /// Shows all that may touch at a pose, two by two and always in this order, until one look ends it.
    fn visit_pairs<B>(&self, joints_deg: &Joints, look: &mut Look<'_, B>) -> ControlFlow<B> {
        let links = self.robot.capsules(joints_deg);
        let base_from_flange = self.robot.forward(joints_deg);
        let [_, moving @ ..] = &links;
        for l in moving {
            self.visit_pairs_of(&BodyId::Link(l.link), &CollisionBody::Capsule(Capsule::of_link(l)), &[], look)?;
        }
        // What is carried may touch all but the wrist that carries it.
        let [rest @ .., _] = &links;
        match &self.carried {
            Carried::Part(part) => {
                self.visit_pairs_of(&BodyId::Part, &CollisionBody::Solid(&part.moved(&base_from_flange)), rest, look)?;
            }
            Carried::Head(head) => {
                for c in head {
                    self.visit_pairs_of(
                        &BodyId::Head,
                        &CollisionBody::Capsule(c.moved(&base_from_flange)),
                        rest,
                        look,
                    )?;
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// A body with all that stands, and with links.
    fn visit_pairs_of<B>(
        &self,
        id: &BodyId,
        body: &CollisionBody<'_, 'a>,
        links: &[LinkCapsule],
        look: &mut Look<'_, B>,
    ) -> ControlFlow<B> {
        if let Some(z_mm) = self.table_z_mm {
            look(Pair(id, &BodyId::Table), body, &CollisionBody::Below(z_mm))?;
        }
        for h in &self.standing_head {
            look(Pair(id, &BodyId::Head), body, &CollisionBody::Capsule(*h))?;
        }
        for l in links {
            look(Pair(id, &BodyId::Link(l.link)), body, &CollisionBody::Capsule(Capsule::of_link(l)))?;
        }
        for s in &self.standing {
            look(Pair(id, &s.id), body, &CollisionBody::Solid(s))?;
        }
        ControlFlow::Continue(())
    }

    /// The first contact on a joint move, and where it is: 0 at `from`, 1 at `to`.
    ///
    /// Looked at so often that nothing moves farther than the margin between two looks; what is
    /// free at both cannot touch between them.
    pub fn first_contact_between(&self, from: &Joints, to: &Joints) -> Option<(f64, Contact)> {
        let pieces = (self.travel_mm(from, to) / self.margin_mm).ceil().clamp(1.0, MOST_LOOKS) as u32;
        (0..=pieces).find_map(|i| {
            let t = f64::from(i) / f64::from(pieces);
            let joints: Joints = std::array::from_fn(|k| from[k] + (to[k] - from[k]) * t);
            Some((t, self.first_contact(&joints)?))
        })
    }

    /// The first contact on a motion of the joints given over 0 to 1, and where on it; they may not turn back within a
    /// sixteenth of it.
    pub fn first_contact_along(&self, at: impl Fn(f64) -> Joints) -> Option<(f64, Contact)> {
        let start = at(0.0);
        if let Some(contact) = self.first_contact(&start) {
            return Some((0.0, contact));
        }
        let piece = |i: u32| f64::from(i) / 16.0;
        let mut here = start;
        (0..16).find_map(|i| {
            let ends = [(piece(i), here), (piece(i + 1), at(piece(i + 1)))];
            here = ends[1].1;
            self.first_contact_within(&at, ends, HALVINGS)
        })
    }

    /// The first contact on a piece of the motion whose start is free.
    fn first_contact_within(
        &self,
        at: &impl Fn(f64) -> Joints,
        [from, to]: [(f64, Joints); 2],
        halvings: u32,
    ) -> Option<(f64, Contact)> {
        if halvings == 0 || self.travel_mm(&from.1, &to.1) <= self.margin_mm {
            return Some((to.0, self.first_contact(&to.1)?));
        }
        let t = 0.5 * (from.0 + to.0);
        let middle = (t, at(t));
        self.first_contact_within(at, [from, middle], halvings - 1)
            .or_else(|| self.first_contact_within(at, [middle, to], halvings - 1))
    }

    /// How far any point of arm and load moves between two poses, at most, mm.
    pub fn travel_mm(&self, from: &Joints, to: &Joints) -> f64 {
        (0..6).map(|i| (to[i] - from[i]).abs().to_radians() * self.levers_mm[i]).sum()
    }
}

/// A joint move is looked at this often at most; two turns of all joints of a large arm need a tenth.
const MOST_LOOKS: f64 = 1e6;

/// A sixteenth of a path is halved so often at most: a jump in the joints never gets short.
const HALVINGS: u32 = 10;

impl Carried<'_> {
    /// How far from the middle of the flange anything is.
    fn reach_mm(&self) -> f64 {
        match self {
            Carried::Part(s) => s.centre.coords.norm() + s.radius_mm,
            Carried::Head(head) => {
                head.iter().map(|c| c.from.coords.norm().max(c.to.coords.norm()) + c.radius_mm).fold(0.0, f64::max)
            }
        }
    }
}

#[cfg(test)]
#[path = "collision_tests.rs"]
mod tests;
