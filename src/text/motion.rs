//! What touches what, and why the robot refuses a target.

use super::{Sentence, fixed, id, say};
use crate::cell::motion::RefusalReason;
use crate::cell::{BodyId, Contact, Link};

impl Sentence for BodyId {
    fn sentence(&self) -> String {
        match self {
            BodyId::Head => say!(body_head),
            BodyId::Part => say!(body_part),
            BodyId::Table => say!(body_table),
            BodyId::Clamp { file, .. } => say!(body_clamp, file = &**file),
            BodyId::Obstacle { file, .. } => say!(body_obstacle, file = &**file),
            BodyId::Link(Link::Base) => say!(body_base),
            BodyId::Link(Link::Shoulder) => say!(body_shoulder),
            BodyId::Link(Link::UpperArm) => say!(body_upper_arm),
            BodyId::Link(Link::Forearm) => say!(body_forearm),
            BodyId::Link(Link::Wrist) => say!(body_wrist),
        }
    }
}

impl Sentence for Contact {
    fn sentence(&self) -> String {
        say!(contact_pair, a = self.a.sentence(), b = self.b.sentence())
    }
}

impl Sentence for RefusalReason {
    fn sentence(&self) -> String {
        match self {
            RefusalReason::OutOfReach { robot } => say!(why_out_of_reach, robot),
            RefusalReason::JointLimit { joint, needs_deg, range_deg: [low, high] } => say!(
                why_joint_limit,
                joint = id(joint),
                needs = fixed(*needs_deg, 1),
                low = fixed(*low, 0),
                high = fixed(*high, 0),
            ),
            RefusalReason::LimitBetween => say!(why_limit_between),
            RefusalReason::JointSpeed { joint, needs_deg_s, can_deg_s } => {
                say!(why_joint_speed, joint = id(joint), needs = fixed(*needs_deg_s, 0), can = fixed(*can_deg_s, 0))
            }
            RefusalReason::WristFlip { joint, jump_deg } => {
                say!(why_wrist_flip, joint = id(joint), jump = fixed(*jump_deg, 0))
            }
            RefusalReason::Singular => say!(why_singular),
            RefusalReason::BranchChange => say!(why_branch_change),
            RefusalReason::NoMotion => say!(why_no_motion),
            RefusalReason::Contact(contact) => contact.sentence(),
            RefusalReason::ContactAtHome(contact) => say!(why_contact_at_home, contact = contact.sentence()),
            RefusalReason::NoWay => say!(why_no_way),
            RefusalReason::NotChosen => say!(why_not_chosen),
            RefusalReason::HitOnMove { spot_mm, hit } => {
                let [x, y, z] = spot_mm.map(|mm| fixed(mm, 2));
                say!(why_hit_on_move, x, y, z, hit = hit.sentence())
            }
            RefusalReason::HitAsWritten { hit } => say!(why_hit_as_written, hit = hit.sentence()),
            RefusalReason::HitDrawnBack { hit } => say!(why_hit_drawn_back, hit = hit.sentence()),
            RefusalReason::OffLine { off_mm } => say!(why_off_line, off = fixed(*off_mm, 2)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contact_names_both_bodies() {
        let b = BodyId::Obstacle { index: 0, file: "headstock.stl".into() };
        let contact = Contact { a: BodyId::Link(Link::UpperArm), b };
        assert_eq!(contact.sentence(), "upper arm against obstacle headstock.stl");
        let home = RefusalReason::ContactAtHome(contact).sentence();
        assert!(home.starts_with("upper arm against obstacle headstock.stl already at home"), "{home}");
    }

    #[test]
    fn a_joint_is_named_with_its_figures() {
        let limit = RefusalReason::JointLimit { joint: 2, needs_deg: -56.12, range_deg: [-55.0, 170.0] };
        assert_eq!(limit.sentence(), "J2 would need -56.1°, its range is -55 to 170°");
    }
}
