//! Proximity queries: whether a capsule, another mesh or a half space comes near the facets of a hierarchy, and how
//! near.
//!
//! A question of yes or no ends at the first facet that is near. A distance is sought in the nearer
//! box first, and no box is entered that keeps farther away than what was found.

use super::aabb::Aabb;
use super::build::Node;
use super::prepared::{SegmentForBoxes, SegmentForFacets, Turn};
use super::{Bvh, ray_hit_mm};
use crate::part::distance::triangles;
use nalgebra::{Isometry3, Point3, Vector3};

impl Bvh {
    /// Centre and radius of a sphere around all facets, mm; `None`: there are none.
    pub fn sphere(&self) -> Option<(Point3<f64>, f64)> {
        let b = &self.nodes.first()?.bounds;
        let centre = Point3::from(Vector3::from_fn(|k, _| b.middle(k)));
        let far2 = self.corners.iter().flatten().map(|p| (p - centre).norm_squared()).fold(0.0, f64::max);
        Some((centre, far2.sqrt()))
    }

    /// Centre and radius of the sphere around the box of all facets, mm: wider than [`Self::sphere`],
    /// but known without visiting facets.
    pub fn sphere_of_box(&self) -> Option<(Point3<f64>, f64)> {
        let b = &self.nodes.first()?.bounds;
        Some((Point3::from(Vector3::from_fn(|k, _| b.middle(k))), 0.5 * self.diagonal_mm()))
    }

    /// A corner of some facet.
    pub fn corner(&self) -> Option<Point3<f64>> {
        self.corners.first().map(|[a, ..]| *a)
    }

    /// Whether a facet is within `reach_mm` of the segment.
    pub fn near_segment(&self, from: &Point3<f64>, to: &Point3<f64>, reach_mm: f64) -> bool {
        let segment = SegmentForFacets::new(from, to);
        let sides = SegmentForBoxes::new(&segment);
        let mut near = false;
        self.visit_near_boxes(
            |lo, hi| sides.gap(&Aabb { lo: *lo, hi: *hi }) <= reach_mm,
            |_, corners| {
                near = segment.is_near(corners, reach_mm);
                !near
            },
        );
        near
    }

    /// Visits every facet of a leaf whose box `near` does not rule out, until `visit` returns false.
    pub fn visit_near_boxes(
        &self,
        near: impl Fn(&[f64; 3], &[f64; 3]) -> bool,
        mut visit: impl FnMut(u32, &[Point3<f64>; 3]) -> bool,
    ) {
        let mut stack = [0u32; 96];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let node = &self.nodes[stack[depth] as usize];
            if !near(&node.bounds.lo, &node.bounds.hi) {
                continue;
            }
            if node.count > 0 {
                for i in node.at as usize..(node.at + node.count) as usize {
                    if !visit(self.facet[i], &self.corners[i]) {
                        return;
                    }
                }
            } else {
                stack[depth] = node.at;
                stack[depth + 1] = node.at + 1;
                depth += 2;
            }
        }
    }

    /// Visits every facet of a leaf whose box is near one of several bodies, until `visit` returns false. Bodies are
    /// bits: `near` gets a box with the bodies that may be near it and returns those that still are; `visit` gets
    /// them with the facet.
    pub fn visit_near_boxes_of(
        &self,
        all: u32,
        near: impl Fn(&[f64; 3], &[f64; 3], u32) -> u32,
        mut visit: impl FnMut(&[Point3<f64>; 3], u32) -> bool,
    ) {
        let mut stack = [(0u32, all); 96];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let (at, of) = stack[depth];
            let node = &self.nodes[at as usize];
            let of = near(&node.bounds.lo, &node.bounds.hi, of);
            if of == 0 {
                continue;
            }
            if node.count > 0 {
                if !self.leaf(node).iter().all(|corners| visit(corners, of)) {
                    return;
                }
            } else {
                stack[depth] = (node.at, of);
                stack[depth + 1] = (node.at + 1, of);
                depth += 2;
            }
        }
    }

    /// Whether a facet of this mesh is within `reach_mm` of one of the other.
    pub fn near_mesh(&self, other: &Bvh, self_from_other: &Isometry3<f64>, reach_mm: f64) -> bool {
        if self.nodes.is_empty() || other.nodes.is_empty() {
            return false;
        }
        let turn = Turn::new(self_from_other);
        let mut pairs = vec![(0u32, 0u32)];
        while let Some((i, j)) = pairs.pop() {
            let (a, b) = (&self.nodes[i as usize], &other.nodes[j as usize]);
            if !turn.bounds(&b.bounds).is_near(&a.bounds, reach_mm) {
                continue;
            }
            match (a.count, b.count) {
                (0, 0) if a.bounds.half_area() < b.bounds.half_area() => pairs.extend([(i, b.at), (i, b.at + 1)]),
                (0, _) => pairs.extend([(a.at, j), (a.at + 1, j)]),
                (_, 0) => pairs.extend([(i, b.at), (i, b.at + 1)]),
                _ => {
                    let near = |mine: &[Point3<f64>; 3]| {
                        other.leaf(b).iter().any(|c| triangles(mine, &c.map(|p| self_from_other * p)) <= reach_mm)
                    };
                    if self.leaf(a).iter().any(near) {
                        return true;
                    }
                }
            }
        }
        false
    }

    /// Distance of the nearest facet from the segment, mm, 0 where it passes through one; `None`: at
    /// least `within_mm`.
    pub fn distance_to_segment(&self, from: &Point3<f64>, to: &Point3<f64>, within_mm: f64) -> Option<f64> {
        let segment = SegmentForFacets::new(from, to);
        let sides = SegmentForBoxes::new(&segment);
        let mut best = within_mm;
        let mut open = Vec::from_iter(self.nodes.first().map(|n| (sides.gap(&n.bounds), 0u32)));
        while let Some((gap, i)) = open.pop() {
            if gap >= best {
                continue;
            }
            let node = &self.nodes[i as usize];
            if node.count == 0 {
                let child = |at: u32| (sides.gap(&self.nodes[at as usize].bounds), at);
                push_nearer_last(&mut open, child(node.at), child(node.at + 1));
                continue;
            }
            best = self.leaf(node).iter().map(|c| segment.distance(c)).fold(best, f64::min);
        }
        (best < within_mm).then_some(best)
    }

    /// Distance of the two nearest facets of this mesh and another, mm, 0 where they meet; `None`: at
    /// least `within_mm`.
    pub fn distance_to_mesh(&self, other: &Bvh, self_from_other: &Isometry3<f64>, within_mm: f64) -> Option<f64> {
        let turn = Turn::new(self_from_other);
        let gap = |i: u32, j: u32| {
            let (a, b) = (&self.nodes[i as usize].bounds, &other.nodes[j as usize].bounds);
            (turn.bounds(b).gap(a), (i, j))
        };
        let mut best = within_mm;
        let there = !self.nodes.is_empty() && !other.nodes.is_empty();
        let mut open = Vec::from_iter(there.then(|| gap(0, 0)));
        while let Some((near, (i, j))) = open.pop() {
            if near >= best {
                continue;
            }
            let (a, b) = (&self.nodes[i as usize], &other.nodes[j as usize]);
            if a.count > 0 && b.count > 0 {
                for mine in self.leaf(a) {
                    let theirs = other.leaf(b).iter().map(|c| triangles(mine, &c.map(|p| self_from_other * p)));
                    best = theirs.fold(best, f64::min);
                }
            } else if a.count > 0 || b.count == 0 && a.bounds.half_area() < b.bounds.half_area() {
                push_nearer_last(&mut open, gap(i, b.at), gap(i, b.at + 1));
            } else {
                push_nearer_last(&mut open, gap(a.at, j), gap(a.at + 1, j));
            }
        }
        (best < within_mm).then_some(best)
    }

    /// The least `dir·p` of all corners, mm (`dir` is a unit vector); `None`: there are none.
    pub fn lowest_mm(&self, dir: &Vector3<f64>) -> Option<f64> {
        let mut best = f64::INFINITY;
        let lowest = |i: u32| (self.nodes[i as usize].bounds.lowest(dir), i);
        let mut open = Vec::from_iter((!self.nodes.is_empty()).then(|| lowest(0)));
        while let Some((low, i)) = open.pop() {
            if low >= best {
                continue;
            }
            let node = &self.nodes[i as usize];
            if node.count == 0 {
                push_nearer_last(&mut open, lowest(node.at), lowest(node.at + 1));
                continue;
            }
            best = self.leaf(node).iter().flatten().map(|p| dir.dot(&p.coords)).fold(best, f64::min);
        }
        (best < f64::INFINITY).then_some(best)
    }

    /// Whether a corner has `dir·p` below `height_mm`.
    pub fn reaches_below(&self, dir: &Vector3<f64>, height_mm: f64) -> bool {
        let mut open = Vec::from_iter((!self.nodes.is_empty()).then_some(0u32));
        while let Some(i) = open.pop() {
            let node = &self.nodes[i as usize];
            if node.bounds.lowest(dir) >= height_mm {
                continue;
            }
            if node.count == 0 {
                open.extend([node.at, node.at + 1]);
            } else if self.leaf(node).iter().flatten().any(|p| dir.dot(&p.coords) < height_mm) {
                return true;
            }
        }
        false
    }

    /// Whether a point is inside a closed mesh whose facets wind outwards.
    ///
    /// Two rays must agree: one alone may graze an edge where front and back meet.
    pub fn holds(&self, point: &Point3<f64>) -> bool {
        let leaves = |dir: Vector3<f64>| {
            let dir = dir.normalize();
            let mut first = (f64::INFINITY, 0.0);
            self.visit_ray(point, &dir, 0.0, f64::INFINITY, 0.0, |_, corners| {
                if let Some(t) = ray_hit_mm(corners, point, &dir).filter(|t| (0.0..first.0).contains(t)) {
                    let [a, b, c] = corners;
                    first = (t, (b - a).cross(&(c - a)).dot(&dir));
                }
                first.0
            });
            first.1 > 0.0
        };
        leaves(Vector3::new(0.36, 0.48, 0.80)) && leaves(Vector3::new(-0.61, 0.29, -0.73))
    }

    fn leaf(&self, node: &Node) -> &[[Point3<f64>; 3]] {
        self.corners.get(node.at as usize..(node.at + node.count) as usize).unwrap_or_default()
    }
}

/// Two boxes to look into, by how far away they are; the last one is taken first.
fn push_nearer_last<I>(open: &mut Vec<(f64, I)>, one: (f64, I), other: (f64, I)) {
    open.extend(if one.0 < other.0 { [other, one] } else { [one, other] });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::Mesh;
    use crate::part::distance::segment_triangle;
    use crate::part::topology::FacetDefect;
    use crate::sample::solids;
    use proptest::prelude::*;

    fn soup(numbers: &[f64]) -> Mesh {
        let raw: Vec<[[f32; 3]; 3]> = numbers
            .chunks_exact(9)
            .map(|c| std::array::from_fn(|v| std::array::from_fn(|k| c[3 * v + k] as f32)))
            .collect();
        Mesh::weld(&raw, 1.0)
    }

    fn live(mesh: &Mesh) -> impl Iterator<Item = [Point3<f64>; 3]> + Clone + '_ {
        (0..mesh.facets.len()).filter(|&f| mesh.defects[f] == FacetDefect::None).map(|f| mesh.corners(f))
    }

    fn point(c: [f64; 3]) -> Point3<f64> {
        Point3::from(Vector3::from(c))
    }

    proptest! {
        /// The tree finds what a look at all facets finds.
        #[test]
        fn near_is_what_is_near_any_facet(numbers in prop::collection::vec(-10.0..10.0f64, 9..300),
                                          ends in prop::array::uniform6(-15.0..15.0f64), reach in 0.0..8.0f64) {
            let mesh = soup(&numbers);
            let (p, q) = (point([ends[0], ends[1], ends[2]]), point([ends[3], ends[4], ends[5]]));
            let dir = (q - p).normalize();
            let least = live(&mesh).map(|c| {
                let through = ray_hit_mm(&c, &p, &dir).is_some_and(|t| (0.0..=(q - p).norm()).contains(&t));
                if through { 0.0 } else { segment_triangle(&p, &q, &c) }
            }).fold(f64::INFINITY, f64::min);
            let tree = Bvh::new(&mesh);
            prop_assert_eq!(tree.near_segment(&p, &q, reach), least <= reach);
            prop_assert_eq!(tree.distance_to_segment(&p, &q, reach), (least < reach).then_some(least));
        }

        #[test]
        fn two_meshes_are_near_where_two_facets_are(one in prop::collection::vec(-6.0..6.0f64, 9..120),
                                                    two in prop::collection::vec(-6.0..6.0f64, 9..120),
                                                    at in prop::array::uniform6(-3.0..3.0f64), reach in 0.0..4.0f64) {
            let (one, two) = (soup(&one), soup(&two));
            let motion = Isometry3::new(Vector3::new(at[0] * 8.0, at[1], at[2]), Vector3::new(at[3], at[4], at[5]));
            let moved = |c: [Point3<f64>; 3]| c.map(|p| motion * p);
            let least = live(&one)
                .flat_map(|a| live(&two).map(move |b| triangles(&a, &moved(b))).collect::<Vec<_>>())
                .fold(f64::INFINITY, f64::min);
            prop_assume!((least - reach).abs() > 1e-9);
            let (one, two) = (Bvh::new(&one), Bvh::new(&two));
            prop_assert_eq!(one.near_mesh(&two, &motion, reach), least <= reach);
            prop_assert_eq!(one.distance_to_mesh(&two, &motion, reach), (least < reach).then_some(least));
        }

        #[test]
        fn the_lowest_corner_is_that_of_all(numbers in prop::collection::vec(-10.0..10.0f64, 9..300),
                                            d in prop::array::uniform3(-1.0..1.0f64), height in -12.0..2.0f64) {
            let mesh = soup(&numbers);
            let d = Vector3::from(d);
            let least = live(&mesh).flatten().map(|p| d.dot(&p.coords)).fold(f64::INFINITY, f64::min);
            let tree = Bvh::new(&mesh);
            prop_assert_eq!(tree.reaches_below(&d, height), least < height);
            prop_assert_eq!(tree.lowest_mm(&d), least.is_finite().then_some(least));
        }

        /// A ball holds what is nearer its centre than its flats are.
        #[test]
        fn a_ball_holds_what_is_inside(p in prop::array::uniform3(-8.0..8.0f64)) {
            let flat: Vec<f64> = solids::sphere(5.0, 48, 24).into_iter().flatten().flatten().collect();
            let ball = Bvh::new(&soup(&flat));
            let r = Vector3::from(p).norm();
            prop_assume!(!(4.9..=5.0).contains(&r));
            prop_assert_eq!(ball.holds(&point(p)), r < 4.9);
        }
    }
}
