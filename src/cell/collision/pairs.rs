//! Which bodies may touch each other, shown two by two at a pose of the robot.

use super::arm::{ArmAt, LinkAt};
use super::contact::{BodyId, Contact};
use super::shapes::{Capsule, CollisionBody};
use super::{Collision, own_margin_mm};
use crate::cell::Joints;
use std::ops::ControlFlow;

/// A look at two bodies: which they are, and their shapes.
pub(super) type Look<'l, B> =
    dyn FnMut(Pair<'_>, &CollisionBody<'_, '_>, &CollisionBody<'_, '_>) -> ControlFlow<B> + 'l;

/// Two bodies that may touch, and the distance that they keep, mm.
#[derive(Clone, Copy)]
pub(super) struct Pair<'p> {
    one: &'p BodyId,
    other: &'p BodyId,
    pub margin_mm: f64,
}

impl From<Pair<'_>> for Contact {
    fn from(pair: Pair<'_>) -> Contact {
        Contact { a: pair.one.clone(), b: pair.other.clone() }
    }
}

impl<'a> Collision<'a> {
    /// Shows all that may touch at a pose, two by two and always in this order, until one look ends it.
    pub(super) fn visit_pairs<B>(&self, joints_deg: &Joints, look: &mut Look<'_, B>) -> ControlFlow<B> {
        let arm = self.arm.at(joints_deg);
        let [_, moving @ ..] = &arm.links;
        for link in moving {
            for body in link.bodies() {
                self.visit_pairs_of(&link.id, &body, &[], look)?;
            }
        }
        // What is carried may touch all but the wrist that carries it.
        let [rest @ .., _] = &arm.links;
        for solid in &self.carried.solids {
            let solid = solid.moved(&arm.base_from_flange);
            self.visit_pairs_of(&solid.id, &CollisionBody::Solid(&solid), rest, look)?;
        }
        for capsule in &self.carried.head {
            let capsule: Capsule = capsule.moved(&arm.base_from_flange);
            self.visit_pairs_of(&BodyId::Head, &CollisionBody::Capsule(capsule), rest, look)?;
        }
        self.visit_own_pairs(&arm, look)
    }

    /// A body with all that stands, and with links.
    fn visit_pairs_of<B>(
        &self,
        id: &BodyId,
        body: &CollisionBody<'_, 'a>,
        links: &[LinkAt<'a>],
        look: &mut Look<'_, B>,
    ) -> ControlFlow<B> {
        let with = |other| Pair { one: id, other, margin_mm: self.margin_mm };
        if let Some(z_mm) = self.table_z_mm {
            look(with(&BodyId::Table), body, &CollisionBody::Below(z_mm))?;
        }
        for h in &self.standing.head {
            look(with(&BodyId::Head), body, &CollisionBody::Capsule(*h))?;
        }
        for link in links {
            for of_link in link.bodies() {
                look(with(&link.id), body, &of_link)?;
            }
        }
        for s in &self.standing.solids {
            look(with(&s.id), body, &CollisionBody::Solid(s))?;
        }
        ControlFlow::Continue(())
    }

    /// Links of the arm with each other, the one nearer the flange first.
    fn visit_own_pairs<B>(&self, arm: &ArmAt<'a>, look: &mut Look<'_, B>) -> ControlFlow<B> {
        let margin_mm = own_margin_mm(self.margin_mm);
        for &[inner, outer] in &self.own_pairs {
            let (inner, outer) = (&arm.links[inner], &arm.links[outer]);
            for body in outer.bodies() {
                for other in inner.bodies() {
                    look(Pair { one: &outer.id, other: &inner.id, margin_mm }, &body, &other)?;
                }
            }
        }
        ControlFlow::Continue(())
    }
}
