//! Cuts a field of depths at a threshold: of each triangle the part where the depth, linear inside, is at least that
//! (marching triangles), with its area and the integral of the depth over it.

use super::DepthField;
use nalgebra::{Point3, Vector3};

/// A place on a triangle's side, or at a corner (then both are the same): where an outline passes.
pub(super) type Node = [u32; 2];

/// The part of a triangle at least as deep as the threshold.
#[derive(Clone, Debug)]
pub(super) struct Deep {
    /// Index of the triangle.
    pub(super) triangle: u32,
    /// Its area, mm².
    pub(super) area_mm2: f64,
    /// Integral of the depth over it, mm³.
    pub(super) volume_mm3: f64,
    /// Slope of the depth across the threshold, summed along that, mm: how fast the depth ends there.
    pub(super) slope_mm: f64,
    /// Integral of the place over it, mm³.
    pub(super) moment: Vector3<f64>,
    /// Its sides in order, wound as the triangle is, and whether each runs through the triangle (where the
    /// depth is the threshold) or along its side.
    pub(super) sides: Vec<(Node, Node, bool)>,
}

/// Where a depth is the threshold, between two vertices; the same from both sides, bit by bit.
pub(super) fn place(field: &DepthField, node: Node, sign: f64, least_mm: f64) -> Point3<f64> {
    let [a, b] = node.map(|v| field.vertices[v as usize]);
    let [da, db] = node.map(|v| sign * field.depth_mm[v as usize]);
    if node[0] == node[1] { a } else { a + (b - a) * ((least_mm - da) / (db - da)) }
}

/// The deep part of a triangle, where it has one and all its depths are known. `sign`: −1 for surplus.
pub(super) fn deep_part(field: &DepthField, triangle: u32, sign: f64, least_mm: f64) -> Option<Deep> {
    let corners = field.triangles[triangle as usize];
    let depth = corners.map(|v| sign * field.depth_mm[v as usize]);
    if depth.iter().any(|d| d.is_nan()) || depth.iter().all(|d| *d < least_mm) {
        return None;
    }
    let mut nodes: Vec<(Node, Point3<f64>, f64)> = Vec::with_capacity(4);
    for k in 0..3 {
        let next = (k + 1) % 3;
        if depth[k] >= least_mm {
            let v = corners[k];
            nodes.push(([v, v], field.vertices[v as usize], depth[k]));
        }
        if (depth[k] >= least_mm) != (depth[next] >= least_mm) {
            let (a, b) = (corners[k], corners[next]);
            let node = [a.min(b), a.max(b)];
            nodes.push((node, place(field, node, sign, least_mm), least_mm));
        }
    }
    let (origin, first_depth) = (nodes[0].1, nodes[0].2);
    let mut deep =
        Deep { triangle, area_mm2: 0.0, volume_mm3: 0.0, slope_mm: 0.0, moment: Vector3::zeros(), sides: Vec::new() };
    for pair in nodes[1..].windows(2) {
        let area = 0.5 * (pair[0].1 - origin).cross(&(pair[1].1 - origin)).norm();
        deep.area_mm2 += area;
        deep.volume_mm3 += area * (first_depth + pair[0].2 + pair[1].2) / 3.0;
        deep.moment += (origin.coords + pair[0].1.coords + pair[1].1.coords) * (area / 3.0);
    }
    for (i, (node, at, _)) in nodes.iter().enumerate() {
        let (next, onto, _) = nodes[(i + 1) % nodes.len()];
        let through = node[0] != node[1] && next[0] != next[1];
        if through {
            deep.slope_mm += slope(&corners.map(|v| field.vertices[v as usize]), &depth) * (onto - at).norm();
        }
        deep.sides.push((*node, next, through));
    }
    Some(deep)
}

/// Steepness of a depth that is linear on a triangle, mm/mm; 0 on one without area.
fn slope([a, b, c]: &[Point3<f64>; 3], depth: &[f64; 3]) -> f64 {
    let twice_area = (b - a).cross(&(c - a)).norm();
    let turned = (b - a) * (depth[2] - depth[0]) - (c - a) * (depth[1] - depth[0]);
    if twice_area > 0.0 { turned.norm() / twice_area } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// What is deep and what is not make up the whole triangle, and their volumes that of its prism.
        #[test]
        fn deep_and_shallow_make_the_whole(depth in prop::array::uniform3(-1.0..1.0f64), least in -1.2..1.2f64,
                                           c in prop::array::uniform9(-5.0..5.0f64)) {
            let vertices: Vec<Point3<f64>> = c.chunks_exact(3).map(|p| Point3::new(p[0], p[1], p[2])).collect();
            let whole = 0.5 * (vertices[1] - vertices[0]).cross(&(vertices[2] - vertices[0])).norm();
            let field = DepthField { vertices, triangles: vec![[0, 1, 2]], parent: vec![0], depth_mm: depth.to_vec() };
            let deep = deep_part(&field, 0, 1.0, least);
            let shallow = deep_part(&field, 0, -1.0, -least);
            let sum = |of: fn(&Deep) -> f64| [&deep, &shallow].map(|d| d.as_ref().map_or(0.0, of));
            prop_assert!((sum(|d| d.area_mm2).iter().sum::<f64>() - whole).abs() < 1e-9);
            let [below, above] = sum(|d| d.volume_mm3);
            let prism = whole * depth.iter().sum::<f64>() / 3.0;
            prop_assert!((below - above - prism).abs() < 1e-9);
            for d in deep.iter().chain(&shallow) {
                prop_assert_eq!(d.sides.len() + usize::from(d.sides.len() == 4), if d.sides.len() == 4 { 5 } else { 3 });
            }
        }
    }

    #[test]
    fn nothing_unknown_is_deep() {
        let vertices = vec![Point3::origin(), Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0)];
        let field =
            DepthField { vertices, triangles: vec![[0, 1, 2]], parent: vec![0], depth_mm: vec![1.0, f64::NAN, 1.0] };
        assert!(deep_part(&field, 0, 1.0, 0.5).is_none());
    }
}
