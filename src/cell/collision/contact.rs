//! What touches what: bodies of the cell by kind and number, and two of them that meet. How it is said is told
//! elsewhere.

use crate::cell::Link;
use serde::ser::{Serialize, SerializeMap as _, Serializer};
use std::cmp::Ordering;
use std::sync::Arc;

/// A body of the cell that another may touch; what is dearest comes first.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum BodyId {
    /// The laser head, as the cell file has it.
    Head,
    /// The workpiece.
    Part,
    /// A link of the arm.
    Link(Link),
    /// A clamp of the job.
    Clamp {
        /// Its place in the job's list, from 0.
        index: usize,
        /// Its file, as the job names it.
        file: Arc<str>,
    },
    /// An obstacle of the cell.
    Obstacle {
        /// Its place in the cell file's list, from 0.
        index: usize,
        /// Its file, as the cell file names it.
        file: Arc<str>,
    },
    /// Everything below the cell's height of table or floor.
    Table,
}

impl BodyId {
    /// The word in `report.json`.
    pub fn word(&self) -> &'static str {
        match self {
            BodyId::Head => "head",
            BodyId::Part => "part",
            BodyId::Link(link) => link.word(),
            BodyId::Clamp { .. } => "clamp",
            BodyId::Obstacle { .. } => "obstacle",
            BodyId::Table => "table",
        }
    }
}

/// The word, and place and file of a clamp or an obstacle.
impl Serialize for BodyId {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("body", self.word())?;
        if let BodyId::Clamp { index, file } | BodyId::Obstacle { index, file } = self {
            map.serialize_entry("index", index)?;
            map.serialize_entry("file", &**file)?;
        }
        map.end()
    }
}

/// Two bodies that touch, or come nearer than the margin. The order is that of how bad it is, the worst first: by the
/// dearer of the two bodies, then by the other.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Contact {
    /// One that the robot moves: a link, or what it carries.
    pub a: BodyId,
    /// The other: one that stands, what the robot carries, or a link.
    pub b: BodyId,
}

impl Contact {
    /// Whether one of the bodies is of that kind.
    pub fn any(&self, is: impl Fn(&BodyId) -> bool) -> bool {
        is(&self.a) || is(&self.b)
    }

    fn dearer_first(&self) -> [&BodyId; 2] {
        let (a, b) = (&self.a, &self.b);
        [a.min(b), a.max(b)]
    }
}

impl Ord for Contact {
    fn cmp(&self, other: &Self) -> Ordering {
        self.dearer_first().cmp(&other.dearer_first()).then_with(|| self.a.cmp(&other.a))
    }
}

impl PartialOrd for Contact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn obstacle(index: usize, file: &str) -> BodyId {
        BodyId::Obstacle { index, file: file.into() }
    }

    #[test]
    fn the_worst_contact_comes_first() {
        let contact = |a: BodyId, b: BodyId| Contact { a, b };
        let forearm = || BodyId::Link(Link::Forearm);
        let worst_first = [
            contact(BodyId::Head, BodyId::Part),
            contact(BodyId::Part, BodyId::Head),
            contact(forearm(), BodyId::Head),
            contact(BodyId::Part, BodyId::Table),
            contact(forearm(), BodyId::Link(Link::Base)),
            contact(forearm(), BodyId::Clamp { index: 0, file: "z.stl".into() }),
            contact(forearm(), obstacle(0, "z.stl")),
            contact(forearm(), obstacle(1, "a.stl")),
            contact(forearm(), BodyId::Table),
        ];
        let mut sorted = worst_first.clone();
        sorted.reverse();
        sorted.sort();
        assert_eq!(sorted, worst_first);
    }

    #[test]
    fn a_contact_is_two_bodies_by_word_and_place() {
        let contact = Contact { a: BodyId::Link(Link::UpperArm), b: obstacle(2, "fence.stl") };
        let json = serde_json::to_value(&contact).expect("JSON");
        let b = serde_json::json!({ "body": "obstacle", "index": 2, "file": "fence.stl" });
        assert_eq!(json, serde_json::json!({ "a": { "body": "upper_arm" }, "b": b }));
    }
}
