//! What the robot refuses, and why: the kind of refusal, bodies, joints and figures. Its sentences stand in `text`.

use crate::cell::{BodyId, Contact};
use crate::pose::{Blocker, Obstruction, ToolBody};
use serde::Serialize;
use serde::ser::{SerializeMap as _, Serializer};

/// The kind of a refusal, the most harmful first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum RefusalCause {
    /// The beam hits the part.
    Beam,
    /// The arm touches the part or itself, or no connecting move leads there.
    Robot,
    /// The head touches something, or is touched.
    Head,
    /// The table, an obstacle or a clamp is touched.
    Obstacle,
    /// No pose of the arm leads to the target.
    Reach,
    /// A joint would leave its range.
    Limit,
    /// A joint would have to turn faster than it can.
    Speed,
    /// The arm would pass a singularity, flip its wrist or change its branch.
    Singularity,
}

impl RefusalCause {
    /// The word in `report.json`.
    pub fn word(self) -> &'static str {
        match self {
            RefusalCause::Beam => "beam",
            RefusalCause::Robot => "robot",
            RefusalCause::Head => "head",
            RefusalCause::Obstacle => "obstacle",
            RefusalCause::Reach => "reach",
            RefusalCause::Limit => "limit",
            RefusalCause::Speed => "speed",
            RefusalCause::Singularity => "singularity",
        }
    }

    /// The cause of something in the way of beam or head.
    pub fn of_blocker(b: &Blocker) -> RefusalCause {
        match (b.tool_body, b.obstruction) {
            (_, Obstruction::Clamp(_) | Obstruction::Unscanned) => RefusalCause::Obstacle,
            (ToolBody::Head | ToolBody::Abrasive | ToolBody::Gouge, _) => RefusalCause::Head,
            (ToolBody::Beam, _) => RefusalCause::Beam,
        }
    }

    /// The cause of a contact, by the bodies that touch.
    pub fn of_contact(contact: &Contact) -> RefusalCause {
        if contact.any(|b| matches!(b, BodyId::Head)) {
            RefusalCause::Head
        } else if contact.any(|b| matches!(b, BodyId::Table | BodyId::Clamp { .. } | BodyId::Obstacle { .. })) {
            RefusalCause::Obstacle
        } else {
            RefusalCause::Robot
        }
    }
}

/// A target that the robot refuses.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// Pass.
    pub pass: usize,
    /// Point of the pass.
    pub point: usize,
    /// The kind of refusal.
    pub cause: RefusalCause,
    /// The reason, with its figures.
    pub why: RefusalReason,
}

/// Why the robot refuses a target. Joints are counted from 1, as their names are: J1.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum RefusalReason {
    /// No pose of the arm leads there, at any spin.
    OutOfReach {
        /// The robot's name for people.
        robot: String,
    },
    /// A joint would have to go beyond its range.
    JointLimit {
        /// The joint.
        joint: usize,
        /// Angle that it would need, degrees.
        needs_deg: f64,
        /// Least and greatest that it can, degrees.
        range_deg: [f64; 2],
    },
    /// Between two targets some joint would leave its range.
    LimitBetween,
    /// A joint would have to turn faster than it can.
    JointSpeed {
        /// The joint.
        joint: usize,
        /// Speed that it would need, degrees per second.
        needs_deg_s: f64,
        /// The greatest that it can, degrees per second.
        can_deg_s: f64,
    },
    /// A joint would jump: the wrist flips.
    WristFlip {
        /// The joint.
        joint: usize,
        /// How far it would jump, degrees.
        jump_deg: f64,
    },
    /// Every pose of the arm that reaches the target is too near a singularity.
    Singular,
    /// The arm would have to change its branch in the middle of a pass.
    BranchChange,
    /// No continuous motion of the arm leads on.
    NoMotion,
    /// Something touches.
    Contact(Contact),
    /// Something touches already where the program begins and ends.
    ContactAtHome(Contact),
    /// No way leads there on which arm and part keep clear of everything.
    NoWay,
    /// No pose was chosen for the target.
    NotChosen,
    /// As the flange goes straight, beam or head hits something.
    HitOnMove {
        /// Where the spot is then, in the part, mm.
        spot_mm: [f64; 3],
        /// What hits what.
        #[serde(serialize_with = "blocker")]
        hit: Blocker,
    },
    /// As the program is written, rounded to its digits, beam or head hits something.
    HitAsWritten {
        /// What hits what.
        #[serde(serialize_with = "blocker")]
        hit: Blocker,
    },
    /// As the head is drawn back, it hits something.
    HitDrawnBack {
        /// What hits what.
        #[serde(serialize_with = "blocker")]
        hit: Blocker,
    },
    /// As the flange goes straight, the spot leaves its line.
    OffLine {
        /// How far, mm.
        off_mm: f64,
    },
}

impl RefusalReason {
    /// The refusal because of a contact, with its cause.
    pub fn contact(contact: Contact) -> (RefusalCause, RefusalReason) {
        (RefusalCause::of_contact(&contact), RefusalReason::Contact(contact))
    }
}

/// What hits what: `beam` or `head`, the facet or the clamp from 0, and how far along the beam.
fn blocker<S: Serializer>(b: &Blocker, serializer: S) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(Some(3))?;
    map.serialize_entry("tool", b.tool_body.word())?;
    match b.obstruction {
        Obstruction::Facet(facet) => map.serialize_entry("facet", &facet)?,
        Obstruction::Clamp(clamp) => map.serialize_entry("clamp", &clamp)?,
        Obstruction::Unscanned => map.serialize_entry("unscanned", &true)?,
    }
    map.serialize_entry("t_mm", &b.t_mm)?;
    map.end()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Link;
    use serde_json::json;

    fn json(why: &RefusalReason) -> serde_json::Value {
        serde_json::to_value(why).expect("JSON")
    }

    #[test]
    fn the_cause_of_a_contact_is_in_its_bodies() {
        let obstacle = |file: &str| BodyId::Obstacle { index: 0, file: file.into() };
        let cause = |a, b| RefusalCause::of_contact(&Contact { a, b });
        let arm = || BodyId::Link(Link::UpperArm);
        assert_eq!(cause(BodyId::Part, obstacle("headstock.stl")), RefusalCause::Obstacle);
        assert_eq!(cause(BodyId::Head, obstacle("fence.stl")), RefusalCause::Head);
        assert_eq!(cause(arm(), BodyId::Head), RefusalCause::Head);
        assert_eq!(cause(BodyId::Part, BodyId::Table), RefusalCause::Obstacle);
        assert_eq!(cause(arm(), BodyId::Part), RefusalCause::Robot);
        assert_eq!(cause(BodyId::Link(Link::Wrist), arm()), RefusalCause::Robot);
        assert_eq!(cause(arm(), BodyId::Clamp { index: 0, file: "vice.stl".into() }), RefusalCause::Obstacle);
    }

    #[test]
    fn reasons_are_codes_and_figures() {
        let limit = RefusalReason::JointLimit { joint: 5, needs_deg: 127.25, range_deg: [-120.0, 120.0] };
        let told = json!({ "code": "joint_limit", "joint": 5, "needs_deg": 127.25, "range_deg": [-120.0, 120.0] });
        assert_eq!(json(&limit), told);
        assert_eq!(json(&RefusalReason::NoWay), json!({ "code": "no_way" }));
        let touch = RefusalReason::contact(Contact { a: BodyId::Link(Link::Forearm), b: BodyId::Part }).1;
        assert_eq!(json(&touch), json!({ "code": "contact", "a": { "body": "forearm" }, "b": { "body": "part" } }));
        let hit = Blocker { tool_body: ToolBody::Head, obstruction: Obstruction::Facet(12), t_mm: 40.5 };
        let back = json!({ "code": "hit_drawn_back", "hit": { "tool": "head", "facet": 12, "t_mm": 40.5 } });
        assert_eq!(json(&RefusalReason::HitDrawnBack { hit }), back);
        let moved = json(&RefusalReason::HitOnMove { spot_mm: [1.0, 2.0, 3.5], hit });
        assert_eq!(moved["spot_mm"], json!([1.0, 2.0, 3.5]));
    }
}
