//! Whether something comes near the facets of a hierarchy: a capsule, another mesh, a half space.
//!
//! Every question is a yes or a no, so that a search may end at the first facet that is near.

use super::{Bounds, Bvh, Node, meet};
use crate::part::distance::{segment_triangle, triangles};
use nalgebra::{Isometry3, Matrix3, Point3, Vector3};

impl Bvh {
    /// Centre and radius of a sphere around all facets, mm; `None`: there are none.
    pub fn sphere(&self) -> Option<(Point3<f64>, f64)> {
        let b = &self.nodes.first()?.bounds;
        let centre = Point3::from(Vector3::from_fn(|k, _| b.middle(k)));
        let far2 = self.corners.iter().flatten().map(|p| (p - centre).norm_squared()).fold(0.0, f64::max);
        Some((centre, far2.sqrt()))
    }

    /// Centre and radius of the sphere around the box of all facets, mm: wider than [`Self::sphere`],
    /// and known at once.
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
        let along = to - from;
        let length = along.norm();
        let dir = if length > 0.0 { along / length } else { Vector3::z() };
        let mut near = false;
        self.visit_ray(from, &dir, 0.0, length, reach_mm, |_, corners| {
            let through = meet(corners, from, &dir).is_some_and(|t| (0.0..=length).contains(&t));
            near = near || through || segment_triangle(from, to, corners) <= reach_mm;
            if near { -1.0 } else { length }
        });
        near
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

    /// Whether a corner has `dir·p` below `height_mm`.
    pub fn reaches_below(&self, dir: &Vector3<f64>, height_mm: f64) -> bool {
        let mut open = Vec::from_iter((!self.nodes.is_empty()).then_some(0u32));
        while let Some(i) = open.pop() {
            let node = &self.nodes[i as usize];
            let b = &node.bounds;
            let lowest: f64 = (0..3).map(|k| dir[k] * if dir[k] > 0.0 { b.lo[k] } else { b.hi[k] }).sum();
            if lowest >= height_mm {
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
                if let Some(t) = meet(corners, point, &dir).filter(|t| (0.0..first.0).contains(t)) {
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

/// A motion made ready for boxes.
struct Turn {
    rotation: Matrix3<f64>,
    spread: Matrix3<f64>,
    shift: Vector3<f64>,
}

impl Turn {
    fn new(motion: &Isometry3<f64>) -> Turn {
        let rotation = *motion.rotation.to_rotation_matrix().matrix();
        Turn { rotation, spread: rotation.abs(), shift: motion.translation.vector }
    }

    /// The box around a moved box.
    fn bounds(&self, b: &Bounds) -> Bounds {
        let middle = self.rotation * Vector3::from_fn(|k, _| b.middle(k)) + self.shift;
        let half = self.spread * Vector3::from_fn(|k, _| 0.5 * (b.hi[k] - b.lo[k]));
        Bounds { lo: (middle - half).into(), hi: (middle + half).into() }
    }
}

impl Bounds {
    fn is_near(&self, o: &Bounds, reach_mm: f64) -> bool {
        // Wider by more than the rounding of a turned box.
        let reach = reach_mm * (1.0 + 1e-9) + 1e-9;
        (0..3).all(|k| self.lo[k] <= o.hi[k] + reach && o.lo[k] <= self.hi[k] + reach)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::Mesh;
    use crate::part::topology::Dead;
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
        (0..mesh.facets.len()).filter(|&f| mesh.dead[f] == Dead::No).map(|f| mesh.corners(f))
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
                let through = meet(&c, &p, &dir).is_some_and(|t| (0.0..=(q - p).norm()).contains(&t));
                if through { 0.0 } else { segment_triangle(&p, &q, &c) }
            }).fold(f64::INFINITY, f64::min);
            prop_assert_eq!(Bvh::new(&mesh).near_segment(&p, &q, reach), least <= reach);
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
            prop_assert_eq!(Bvh::new(&one).near_mesh(&Bvh::new(&two), &motion, reach), least <= reach);
        }

        #[test]
        fn the_lowest_corner_is_that_of_all(numbers in prop::collection::vec(-10.0..10.0f64, 9..300),
                                            d in prop::array::uniform3(-1.0..1.0f64), height in -12.0..2.0f64) {
            let mesh = soup(&numbers);
            let d = Vector3::from(d);
            let least = live(&mesh).flatten().map(|p| d.dot(&p.coords)).fold(f64::INFINITY, f64::min);
            prop_assert_eq!(Bvh::new(&mesh).reaches_below(&d, height), least < height);
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
