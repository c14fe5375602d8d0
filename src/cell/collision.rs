//! Whether anything in the cell touches, at one pose of the robot: links, what the robot carries,
//! and what stands.
//!
//! Links and head are capsules, part and fixtures their facets; distances between them are exact.
//! What stands is not tested against what stands (the robot's base among it), nor a link against its
//! neighbours, nor the wrist against what it carries.

use super::bodies::HeadCapsule;
use super::robot::LinkCapsule;
use super::{Joints, Mount, Robot, Setup};
use crate::part::distance::{point_segment, segments};
use crate::part::{Bvh, Part};
use nalgebra::{Isometry3, Point3, Vector3};
use std::borrow::Cow;
use std::fmt;

/// Two bodies that touch, or come nearer than the margin.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contact {
    /// A link, `part` or `head`.
    pub a: &'static str,
    /// `part`, `head`, `table`, a link, or `obstacle` and its file.
    pub b: String,
}

impl fmt::Display for Contact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} against {}", self.a, self.b)
    }
}

/// Everything that can touch, made ready for many poses.
#[derive(Clone, Debug)]
pub struct Collision<'a> {
    robot: &'a Robot,
    /// What stands, in the base.
    standing: Vec<Solid<'a>>,
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
    Part(Solid<'a>),
    Head(Vec<Capsule>),
}

#[derive(Clone, Copy, Debug)]
struct Capsule {
    from: Point3<f64>,
    to: Point3<f64>,
    radius_mm: f64,
}

/// Facets with a place, and a sphere around them.
#[derive(Clone, Debug)]
struct Solid<'a> {
    name: Cow<'a, str>,
    bvh: &'a Bvh,
    /// Whether it has an inside.
    closed: bool,
    at: Isometry3<f64>,
    centre: Point3<f64>,
    radius_mm: f64,
}

const PART: &str = "part";
const HEAD: &str = "head";
const TABLE: &str = "table";

impl<'a> Collision<'a> {
    /// Of a cell with a robot and a part; `None`: there is no robot that could touch anything.
    pub fn new(setup: &'a Setup, part: &'a Part) -> Option<Collision<'a>> {
        let robot = setup.robot.as_ref()?;
        let (cell, bodies) = (&setup.cell, &setup.cell.bodies);
        let obstacle = |o: &'a crate::beam::Obstacle| Solid::new(format!("obstacle {}", o.file), o.solid(), o.at());
        let mut standing: Vec<Solid<'a>> = bodies.obstacles.iter().filter_map(obstacle).collect();
        let head = |focus: Isometry3<f64>| bodies.head.iter().map(|h| Capsule::of(h, &focus)).collect::<Vec<_>>();
        let (standing_head, carried) = match setup.mount {
            Mount::PartInHand => {
                let part = Solid::new(PART, part, cell.flange_from_part.isometry());
                (head(cell.base_from_laser.isometry()), part.map_or(Carried::Head(Vec::new()), Carried::Part))
            }
            Mount::ToolInHand => {
                standing.extend(Solid::new(PART, part, cell.base_from_part.isometry()));
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
    pub fn first(&self, joints_deg: &Joints) -> Option<Contact> {
        let links = self.robot.capsules(joints_deg);
        let base_from_flange = self.robot.forward(joints_deg);
        let [_, moving @ ..] = &links;
        let touched = moving.iter().find_map(|l| Some((l.name, self.met_by(&Capsule::of_link(l))?)));
        // What is carried may touch all but the wrist that carries it.
        let [rest @ .., _] = &links;
        let touched = touched.or_else(|| match &self.carried {
            Carried::Part(part) => Some((PART, self.met_by_part(&part.moved(&base_from_flange), rest)?)),
            Carried::Head(head) => {
                head.iter().find_map(|c| Some((HEAD, self.met_by_head(&c.moved(&base_from_flange), rest)?)))
            }
        });
        touched.map(|(a, b)| Contact { a, b: b.into() })
    }

    /// What a capsule of the arm touches of all that stands.
    fn met_by(&self, c: &Capsule) -> Option<&str> {
        let head = || self.standing_head.iter().any(|h| h.near(c, self.margin_mm)).then_some(HEAD);
        let table = || self.table_z_mm.filter(|z| c.lowest_mm() < z + self.margin_mm).map(|_| TABLE);
        let solid = || self.standing.iter().find(|s| s.near(c, self.margin_mm)).map(|s| &*s.name);
        table().or_else(head).or_else(solid)
    }

    fn met_by_part(&self, part: &Solid<'_>, links: &[LinkCapsule]) -> Option<&str> {
        let margin = self.margin_mm;
        let table = || self.table_z_mm.filter(|z| part.reaches_below(z + margin)).map(|_| TABLE);
        let head = || self.standing_head.iter().any(|h| part.near(h, margin)).then_some(HEAD);
        let link = || links.iter().find(|l| part.near(&Capsule::of_link(l), margin)).map(|l| l.name);
        let solid = || self.standing.iter().find(|s| s.near_solid(part, margin)).map(|s| &*s.name);
        table().or_else(head).or_else(link).or_else(solid)
    }

    fn met_by_head(&self, c: &Capsule, links: &[LinkCapsule]) -> Option<&str> {
        let margin = self.margin_mm;
        let table = || self.table_z_mm.filter(|z| c.lowest_mm() < z + margin).map(|_| TABLE);
        let link = || links.iter().find(|l| c.near(&Capsule::of_link(l), margin)).map(|l| l.name);
        let solid = || self.standing.iter().find(|s| s.near(c, margin)).map(|s| &*s.name);
        table().or_else(link).or_else(solid)
    }

    /// The first contact on a joint move, and where it is: 0 at `from`, 1 at `to`.
    ///
    /// Looked at so often that nothing moves farther than the margin between two looks; what is
    /// free at both cannot touch between them.
    pub fn first_between(&self, from: &Joints, to: &Joints) -> Option<(f64, Contact)> {
        let pieces = (self.travel_mm(from, to) / self.margin_mm).ceil().clamp(1.0, MOST_LOOKS) as u32;
        (0..=pieces).find_map(|i| {
            let t = f64::from(i) / f64::from(pieces);
            let joints: Joints = std::array::from_fn(|k| from[k] + (to[k] - from[k]) * t);
            Some((t, self.first(&joints)?))
        })
    }

    /// The same for joints given over 0 to 1; they may not turn back within a sixteenth of it.
    pub fn first_along(&self, at: impl Fn(f64) -> Joints) -> Option<(f64, Contact)> {
        let start = at(0.0);
        if let Some(contact) = self.first(&start) {
            return Some((0.0, contact));
        }
        let piece = |i: u32| f64::from(i) / 16.0;
        let mut here = start;
        (0..16).find_map(|i| {
            let ends = [(piece(i), here), (piece(i + 1), at(piece(i + 1)))];
            here = ends[1].1;
            self.first_within(&at, ends, HALVINGS)
        })
    }

    /// Of a piece whose start is free.
    fn first_within(
        &self,
        at: &impl Fn(f64) -> Joints,
        [from, to]: [(f64, Joints); 2],
        halvings: u32,
    ) -> Option<(f64, Contact)> {
        if halvings == 0 || self.travel_mm(&from.1, &to.1) <= self.margin_mm {
            return Some((to.0, self.first(&to.1)?));
        }
        let t = 0.5 * (from.0 + to.0);
        let middle = (t, at(t));
        self.first_within(at, [from, middle], halvings - 1)
            .or_else(|| self.first_within(at, [middle, to], halvings - 1))
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

impl Capsule {
    fn of(h: &HeadCapsule, focus: &Isometry3<f64>) -> Capsule {
        let at = |mm: f64| focus * Point3::new(0.0, 0.0, mm);
        Capsule { from: at(h.from_mm), to: at(h.to_mm), radius_mm: h.radius_mm }
    }

    fn of_link(l: &LinkCapsule) -> Capsule {
        Capsule { from: l.from, to: l.to, radius_mm: l.radius_mm }
    }

    fn moved(&self, by: &Isometry3<f64>) -> Capsule {
        Capsule { from: by * self.from, to: by * self.to, ..*self }
    }

    fn lowest_mm(&self) -> f64 {
        self.from.z.min(self.to.z) - self.radius_mm
    }

    fn near(&self, o: &Capsule, margin_mm: f64) -> bool {
        segments(&self.from, &self.to, &o.from, &o.to) <= self.radius_mm + o.radius_mm + margin_mm
    }
}

impl<'a> Solid<'a> {
    fn new(name: impl Into<Cow<'a, str>>, part: &'a Part, at: Isometry3<f64>) -> Option<Solid<'a>> {
        let (centre, radius_mm) = part.bvh.sphere()?;
        Some(Solid {
            name: name.into(),
            bvh: &part.bvh,
            closed: part.orientation.watertight,
            at,
            centre: at * centre,
            radius_mm,
        })
    }

    fn moved(&self, by: &Isometry3<f64>) -> Solid<'a> {
        Solid { name: self.name.clone(), at: by * self.at, centre: by * self.centre, ..*self }
    }

    fn near(&self, c: &Capsule, margin_mm: f64) -> bool {
        let reach = c.radius_mm + margin_mm;
        if point_segment(&self.centre, &c.from, &c.to) > self.radius_mm + reach {
            return false;
        }
        let [from, to] = [c.from, c.to].map(|p| self.at.inverse_transform_point(&p));
        self.bvh.near_segment(&from, &to, reach) || self.closed && self.bvh.holds(&from)
    }

    fn near_solid(&self, o: &Solid<'_>, margin_mm: f64) -> bool {
        if (self.centre - o.centre).norm() > self.radius_mm + o.radius_mm + margin_mm {
            return false;
        }
        let self_from_other = self.at.inv_mul(&o.at);
        self.bvh.near_mesh(o.bvh, &self_from_other, margin_mm)
            || self.holds_corner_of(o, &self_from_other)
            || o.holds_corner_of(self, &self_from_other.inverse())
    }

    /// Of two that do not touch: whether the other is inside.
    fn holds_corner_of(&self, o: &Solid<'_>, self_from_other: &Isometry3<f64>) -> bool {
        self.closed && o.bvh.corner().is_some_and(|p| self.bvh.holds(&(self_from_other * p)))
    }

    fn reaches_below(&self, z_mm: f64) -> bool {
        if self.centre.z - self.radius_mm >= z_mm {
            return false;
        }
        let down = self.at.rotation.inverse() * Vector3::z();
        self.bvh.reaches_below(&down, z_mm - self.at.translation.z)
    }
}

#[cfg(test)]
#[path = "collision_tests.rs"]
mod tests;
