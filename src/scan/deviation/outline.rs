//! Chains the sides of deep parts into the outlines of a patch: closed lines, the patch on their left seen from
//! outside. An outline runs along the threshold, and along the rims of the model and of what was scanned.

use super::DepthField;
use super::contour::{Deep, Node, place};
use nalgebra::Point3;
use std::collections::{BTreeMap, HashMap};

/// The outlines of the parts of one patch; each line's first point is not repeated at its end.
pub(super) fn outlines(field: &DepthField, parts: &[&Deep], sign: f64, least_mm: f64) -> Vec<Vec<Point3<f64>>> {
    // A piece of a side that another part shares runs the other way there, and both are inside.
    let mut along: HashMap<(Node, Node), i32> = HashMap::new();
    for (from, to, _) in parts.iter().flat_map(|p| &p.sides).filter(|s| !s.2) {
        let turned = to < from;
        *along.entry(if turned { (*to, *from) } else { (*from, *to) }).or_default() += if turned { -1 } else { 1 };
    }
    let mut next: BTreeMap<Node, Vec<Node>> = BTreeMap::new();
    for (from, to, through) in parts.iter().flat_map(|p| &p.sides) {
        let is_border = *through || along.get(&if to < from { (*to, *from) } else { (*from, *to) }) != Some(&0);
        if is_border && from != to {
            next.entry(*from).or_default().push(*to);
        }
    }
    let mut lines = Vec::new();
    while let Some((&first, _)) = next.first_key_value() {
        let (mut at, mut line) = (first, Vec::new());
        while let Some(ways) = next.get_mut(&at) {
            let to = ways.pop();
            if ways.is_empty() {
                next.remove(&at);
            }
            let Some(to) = to else { break };
            line.push(place(field, at, sign, least_mm));
            at = to;
        }
        if line.len() > 2 {
            lines.push(line);
        }
    }
    lines
}
