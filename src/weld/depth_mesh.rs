//! A depth image as a coarse mesh: what a part without a model looks like before anything is known of its weld. It has the
//! bead on it and noise in it, so nothing is planned on it; `skin` is what tools run over.

use super::camera::DepthCamera;
use super::raster::DepthImage;
use crate::part::raw_part::RawFacet;
use crate::scan::upper_median;
use nalgebra::Point3;

/// Nodes are so far apart, mm.
const PITCH_MM: f64 = 3.0;
/// A node needs depths at so many of its block's pixels: at a flying edge there are none worth showing.
const LEAST_FILLED: f64 = 0.25;
/// Facets steeper than this against the image's plane are jumps from one body to another, not skin.
const STEEPEST: f64 = 5.0;

/// Facets over a depth image in the camera's frame, mm, outward towards the camera: medians over blocks of pixels.
pub fn depth_mesh(depth: &DepthImage, camera: &DepthCamera) -> Vec<RawFacet> {
    let mut all_mm: Vec<f64> = depth.values.iter().filter_map(|d| camera.depth_mm(*d)).collect();
    let Some(middle_mm) = upper_median(&mut all_mm) else { return Vec::new() };
    let block = ((PITCH_MM * camera.fx / middle_mm) as usize).max(1);
    let (columns, rows) = (depth.width / block, depth.height / block);
    let mut room = Vec::with_capacity(block * block);
    let mut node = |column: usize, row: usize| {
        room.clear();
        for v in row * block..(row + 1) * block {
            let line = &depth.row(v)[column * block..(column + 1) * block];
            room.extend(line.iter().filter_map(|d| camera.depth_mm(*d)));
        }
        let is_filled = room.len() as f64 >= LEAST_FILLED * (block * block) as f64;
        let z_mm = upper_median(&mut room).filter(|_| is_filled)?;
        let middle = |at: usize| (at * block) as f64 + 0.5 * (block as f64 - 1.0);
        Some(Point3::from(camera.ray(middle(column), middle(row))? * z_mm))
    };
    let nodes: Vec<Option<Point3<f64>>> =
        (0..rows).flat_map(|r| (0..columns).map(move |c| (c, r))).map(|(c, r)| node(c, r)).collect();
    facets(&nodes, columns)
}

/// Triangles over a grid of nodes, row by row, seen from the camera: down, then right.
fn facets(nodes: &[Option<Point3<f64>>], columns: usize) -> Vec<RawFacet> {
    let mut out = Vec::new();
    if columns < 2 {
        return out;
    }
    for (above, below) in nodes.chunks_exact(columns).zip(nodes.chunks_exact(columns).skip(1)) {
        for (above, below) in above.windows(2).zip(below.windows(2)) {
            for corners in [[above[0], below[0], above[1]], [above[1], below[0], below[1]]] {
                let [Some(a), Some(b), Some(c)] = corners else { continue };
                let normal = (b - a).cross(&(c - a));
                if normal.norm() < STEEPEST * normal.z.abs() {
                    out.push([a, b, c].map(|p| p.coords.map(|x| x as f32).into()));
                }
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wall_is_a_sheet_that_faces_the_camera_and_a_jump_is_a_gap() {
        let camera = DepthCamera { units_per_mm: 10.0, ..DepthCamera::pinhole(100.0, 100.0, 49.5, 39.5) };
        let wall = |z_of: fn(usize) -> f32| {
            let values = (0..80 * 100).map(|i| z_of(i % 100)).collect();
            depth_mesh(&DepthImage { width: 100, height: 80, values }, &camera)
        };
        let flat = wall(|_| 5000.0);
        assert!(!flat.is_empty());
        for [a, b, c] in &flat {
            let [a, b, c] = [a, b, c].map(|p| Point3::from(p.map(f64::from)));
            assert!((a.z - 500.0).abs() < 1e-3 && (b - a).cross(&(c - a)).z < 0.0);
        }
        let split = wall(|u| if u < 50 { 5000.0 } else { 9000.0 });
        assert!(split.iter().all(|f| f.iter().all(|p| (p[2] - f[0][2]).abs() < 1.0)), "no facet across the jump");
        assert!(
            wall(|_| 0.0).is_empty()
                && depth_mesh(&DepthImage { width: 0, height: 0, values: Vec::new() }, &camera).is_empty()
        );
    }
}
