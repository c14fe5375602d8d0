//! The point of the mesh that is nearest to a given one, and whether it lies inside a facet, on an edge or at a corner:
//! what decides on which side of the part the given point is. In f64, exact to rounding.

use super::aabb::larger;
use super::{Aabb, Bvh};
use nalgebra::Point3;

/// The nearest point of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest {
    /// The facet it lies on; where several share it, the lowest.
    pub facet: u32,
    /// The point itself.
    pub foot: Point3<f64>,
    /// Where on the facet.
    pub place: FootPlace,
    /// Its distance, mm.
    pub distance_mm: f64,
}

/// Where on a facet a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FootPlace {
    /// Inside.
    Inside,
    /// On edge k, which joins corners k and k + 1.
    Edge(u8),
    /// At corner k.
    Corner(u8),
}

impl Bvh {
    /// The nearest point of all facets with area, nearer than `within_mm`. Of facets at the same distance the lowest is
    /// taken, so the answer does not depend on the order of the hierarchy.
    pub fn closest(&self, point: &Point3<f64>, within_mm: f64) -> Option<Closest> {
        let root = self.nodes.first()?;
        let reach = Reach::new(point, &root.bounds);
        let mut best = Best::within(within_mm);
        let mut stack = [(0u32, 0.0f64); 96];
        stack[0] = (0, reach.squared_gap(&root.bounds));
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (mut index, gap) = stack[depth];
            if gap > best.limit {
                continue;
            }
            // Down to a leaf by the nearer child, the farther one waits.
            loop {
                let node = &self.nodes[index as usize];
                if node.count > 0 {
                    for i in node.at as usize..(node.at + node.count) as usize {
                        best.offer(squared_distance(&self.corners[i], point), self.facet[i], i as u32);
                    }
                    break;
                }
                let child = |at: u32| (at, reach.squared_gap(&self.nodes[at as usize].bounds));
                let (one, other) = (child(node.at), child(node.at + 1));
                let (far, near) = if one.1 <= other.1 { (other, one) } else { (one, other) };
                if far.1 <= best.limit {
                    stack[depth] = far;
                    depth += 1;
                }
                if near.1 > best.limit {
                    break;
                }
                index = near.0;
            }
        }
        best.closest(self, point)
    }
}

/// The nearest facet so far.
pub(super) struct Best {
    /// Its squared distance, mm²; before there is one, that which it has to be below.
    pub(super) limit: f64,
    facet: u32,
    /// `u32::MAX`: none yet.
    slot: u32,
}

impl Best {
    pub(super) fn within(within_mm: f64) -> Best {
        Best { limit: within_mm * within_mm, facet: u32::MAX, slot: u32::MAX }
    }

    #[inline]
    pub(super) fn offer(&mut self, squared: f64, facet: u32, slot: u32) {
        if squared < self.limit || squared == self.limit && self.slot != u32::MAX && facet < self.facet {
            (self.limit, self.facet, self.slot) = (squared, facet, slot);
        }
    }

    /// Place of the facet in the order of the hierarchy.
    pub(super) fn slot(&self) -> Option<u32> {
        (self.slot != u32::MAX).then_some(self.slot)
    }

    pub(super) fn closest(&self, bvh: &Bvh, point: &Point3<f64>) -> Option<Closest> {
        let (foot, place) = foot_on(bvh.corners.get(self.slot as usize)?, point);
        Some(Closest { facet: self.facet, foot, place, distance_mm: self.limit.sqrt() })
    }
}

/// A point prepared for boxes: with it gaps come out too small by more than what rounding adds to the distance of a
/// facet, so that no box hides a facet that is as near by the numbers.
struct Reach {
    above: [f64; 3],
    below: [f64; 3],
}

impl Reach {
    fn new(point: &Point3<f64>, bounds: &Aabb) -> Reach {
        let numbers = bounds.lo.iter().chain(&bounds.hi).chain(point.iter());
        let slack = ROUNDING * numbers.fold(0.0, |m, x| larger(m, x.abs()));
        Reach { above: [0, 1, 2].map(|k| point[k] + slack), below: [0, 1, 2].map(|k| point[k] - slack) }
    }

    #[inline]
    fn squared_gap(&self, b: &Aabb) -> f64 {
        let side = |k: usize| larger(larger(b.lo[k] - self.above[k], self.below[k] - b.hi[k]), 0.0);
        let [x, y, z] = [side(0), side(1), side(2)];
        x * x + y * y + z * z
    }
}

/// Squared distance of a point and a triangle, mm².
#[inline]
pub(super) fn squared_distance(corners: &[Point3<f64>; 3], p: &Point3<f64>) -> f64 {
    (foot_on(corners, p).0 - p).norm_squared()
}

/// The nearest point of a triangle: the foot of the perpendicular where that lies inside, else the nearest on those
/// edges that the point lies beyond. Unlike quotients of areas (Ericson, Real-Time Collision Detection 5.1.5), which
/// lose the foot along a needle by `L³/w²` roundings, this keeps it to a few. Facets that share an edge give the same
/// foot on it, bit by bit.
#[inline]
pub fn foot_on([a, b, c]: &[Point3<f64>; 3], p: &Point3<f64>) -> (Point3<f64>, FootPlace) {
    let (ab, bc, ca) = (b - a, c - b, a - c);
    let (pa, pb, pc) = (p - a, p - b, p - c);
    let n = ca.cross(&ab);
    let beyond = [n.cross(&ab).dot(&pa) < 0.0, n.cross(&bc).dot(&pb) < 0.0, n.cross(&ca).dot(&pc) < 0.0];
    let length2 = n.norm_squared();
    if beyond == [false; 3] && length2 > 0.0 {
        return (p - n * (n.dot(&pa) / length2), FootPlace::Inside);
    }
    let mut best = (*a, FootPlace::Corner(0));
    let mut least = f64::INFINITY;
    for (k, (u, v)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
        if !beyond[k] && length2 > 0.0 {
            continue;
        }
        let found = foot_on_edge(u, v, p, k as u8);
        let squared = (found.0 - p).norm_squared();
        if squared < least {
            (best, least) = (found, squared);
        }
    }
    best
}

/// The nearest point of edge k of a triangle, from corner u to corner v.
#[inline]
fn foot_on_edge(u: &Point3<f64>, v: &Point3<f64>, p: &Point3<f64>, k: u8) -> (Point3<f64>, FootPlace) {
    // From the same end, whichever way a facet runs through its edge.
    let turned = [v.x, v.y, v.z] < [u.x, u.y, u.z];
    let (from, to) = if turned { (v, u) } else { (u, v) };
    let along = to - from;
    let (part, whole) = ((p - from).dot(&along), along.norm_squared());
    let corner = |is_v: bool| FootPlace::Corner(if is_v { (k + 1) % 3 } else { k });
    if part <= 0.0 {
        (*from, corner(turned))
    } else if part >= whole {
        (*to, corner(!turned))
    } else {
        (from + along * (part / whole), FootPlace::Edge(k))
    }
}

/// More than the rounding of a foot, as a share of the largest coordinate.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::distance::point_triangle;
    use crate::part::topology::Mesh;
    use proptest::prelude::*;

    proptest! {
        /// No facet is nearer than the one found, and the foot lies where its place says.
        #[test]
        fn the_closest_point_is_that_of_all_facets(numbers in prop::collection::vec(-10.0..10.0f64, 9..400),
                                                   p in prop::array::uniform3(-15.0..15.0f64)) {
            let raw: Vec<[[f32; 3]; 3]> = numbers.chunks_exact(9)
                .map(|c| std::array::from_fn(|v| std::array::from_fn(|k| c[3 * v + k] as f32))).collect();
            let mesh = Mesh::weld(&raw, 1.0);
            let p = Point3::from(p);
            let all = |f: usize| point_triangle(&p, &mesh.corners(f));
            let least = (0..mesh.facets.len()).map(all).fold(f64::INFINITY, f64::min);
            let bvh = Bvh::new(&mesh);
            let found = bvh.closest(&p, f64::INFINITY).expect("there are facets");
            prop_assert!((found.distance_mm - least).abs() < 1e-9, "{} {}", found.distance_mm, least);
            let corners = mesh.corners(found.facet as usize);
            prop_assert!(point_triangle(&found.foot, &corners) < 1e-9);
            if let FootPlace::Corner(k) = found.place {
                prop_assert_eq!(found.foot, corners[k as usize]);
            }
            prop_assert_eq!(bvh.closest(&p, 0.5 * least), None);
        }
    }

    /// Of a needle 100 mm long and a micrometre wide the foot is where it is, and on an edge two facets agree.
    #[test]
    fn needles_and_shared_edges() {
        let [a, b, c] = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [50.0, 1e-3, 0.0]].map(Point3::from);
        for x in [20.0, 49.0, 77.0] {
            let inside = Point3::new(x, 5e-5, 0.7);
            let (foot, place) = foot_on(&[a, b, c], &inside);
            assert_eq!(place, FootPlace::Inside);
            assert!((foot - Point3::new(x, 5e-5, 0.0)).norm() < 1e-9, "{foot}");
            let beside = Point3::new(x / 3.0, -0.3, 0.1 * x);
            let found = foot_on(&[a, b, c], &beside).0;
            assert!((found - Point3::new(x / 3.0, 0.0, 0.0)).norm() < 1e-12, "{found}");
            let other = foot_on(&[Point3::new(3.0, -1e-3, 9.0), b, a], &Point3::new(x / 3.0, -0.3, -0.1 * x)).0;
            let again = foot_on(&[a, b, c], &Point3::new(x / 3.0, -0.3, -0.1 * x)).0;
            assert_eq!(other, again);
        }
    }
}
