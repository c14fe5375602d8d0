//! The point of the mesh that is nearest to a given one, and whether it lies inside a facet, on an edge or at a corner:
//! what decides on which side of the part the given point is. In f64, exact to rounding.

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
        let mut best: Option<Closest> = None;
        let mut limit = within_mm * within_mm;
        let mut stack = [(0u32, 0.0f64); 96];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let (index, gap) = stack[depth];
            if gap > limit {
                continue;
            }
            let node = &self.nodes[index as usize];
            if node.count > 0 {
                for i in node.at as usize..(node.at + node.count) as usize {
                    let (foot, place) = foot_on(&self.corners[i], point);
                    let squared = (foot - point).norm_squared();
                    let facet = self.facet[i];
                    if squared < limit || squared == limit && best.is_some_and(|b| facet < b.facet) {
                        limit = squared;
                        best = Some(Closest { facet, foot, place, distance_mm: squared.sqrt() });
                    }
                }
                continue;
            }
            let child = |at: u32| (at, squared_gap(&self.nodes[at as usize].bounds, point));
            let (one, other) = (child(node.at), child(node.at + 1));
            // The nearer one last, so that it is taken first.
            let (far, near) = if one.1 <= other.1 { (other, one) } else { (one, other) };
            for next in [far, near] {
                if next.1 <= limit {
                    stack[depth] = next;
                    depth += 1;
                }
            }
        }
        best
    }
}

fn squared_gap(b: &Aabb, p: &Point3<f64>) -> f64 {
    let side = |k: usize| (b.lo[k] - p[k]).max(p[k] - b.hi[k]).max(0.0);
    let [x, y, z] = [side(0), side(1), side(2)];
    x * x + y * y + z * z
}

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection 5.1.5: by the regions of Voronoi).
pub fn foot_on([a, b, c]: &[Point3<f64>; 3], p: &Point3<f64>) -> (Point3<f64>, FootPlace) {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (*a, FootPlace::Corner(0));
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return (*b, FootPlace::Corner(1));
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (a + ab * (d1 / (d1 - d3)), FootPlace::Edge(0));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return (*c, FootPlace::Corner(2));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (a + ac * (d2 / (d2 - d6)), FootPlace::Edge(2));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return (b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), FootPlace::Edge(1));
    }
    let share = 1.0 / (va + vb + vc);
    (a + ab * (vb * share) + ac * (vc * share), FootPlace::Inside)
}

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
}
