//! The envelope that a head of facets sweeps as it turns about the beam: a stack of cylinders.
//!
//! The spot is round, so the turn about the beam is free, and a head that is clear whatever the turn is
//! clear with all of them. A cable that sticks out to one side counts as a disc.

use super::HeadPart;
use crate::part::Mesh;
use nalgebra::Point3;

/// Slices along the axis. A nozzle of 20° half angle and 60 mm length is taken 0.7 mm too wide.
const SLICES: usize = 32;

/// Cylinders about z that contain all facets; empty for a mesh without height.
pub fn envelope(mesh: &Mesh) -> Vec<HeadPart> {
    let (lo, hi) = mesh.bounds();
    let height = (hi.z - lo.z) / SLICES as f64;
    if height.is_nan() || height <= 0.0 {
        return Vec::new();
    }
    let at = |i: usize| lo.z + height * i as f64;
    let mut radius2 = [0.0f64; SLICES];
    for f in 0..mesh.facets.len() {
        let corners = mesh.corners(f);
        let low = corners.iter().map(|c| c.z).fold(f64::INFINITY, f64::min);
        let high = corners.iter().map(|c| c.z).fold(f64::NEG_INFINITY, f64::max);
        let slice = |z: f64| (((z - lo.z) / height) as usize).min(SLICES - 1);
        // Slightly wider: a corner on the border between two slices belongs to both.
        for (i, most) in radius2.iter_mut().enumerate().take(slice(high) + 1).skip(slice(low).saturating_sub(1)) {
            *most = most.max(farthest2(&corners, at(i) - 1e-9, at(i + 1) + 1e-9));
        }
    }
    let mut out: Vec<HeadPart> = Vec::new();
    for (i, r2) in radius2.iter().enumerate().filter(|(_, r2)| **r2 > 0.0) {
        let r = r2.sqrt();
        match out.last_mut() {
            Some(last) if last.to_mm == at(i) && (last.r1_mm - r).abs() <= 1e-6 * r => last.to_mm = at(i + 1),
            _ => out.push(HeadPart { from_mm: at(i), to_mm: at(i + 1), r0_mm: r, r1_mm: r }),
        }
    }
    out
}

/// Greatest squared distance from the axis of the stretch of a facet between two heights.
fn farthest2(corners: &[Point3<f64>; 3], low: f64, high: f64) -> f64 {
    let r2 = |p: &Point3<f64>| p.x * p.x + p.y * p.y;
    let mut most = corners.iter().filter(|c| (low..=high).contains(&c.z)).map(r2).fold(0.0, f64::max);
    for i in 0..3 {
        let (p, q) = (&corners[i], &corners[(i + 1) % 3]);
        for z in [low, high] {
            if (p.z - z) * (q.z - z) < 0.0 {
                most = most.max(r2(&(p + (q - p) * ((z - p.z) / (q.z - p.z)))));
            }
        }
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::solids;

    #[test]
    fn it_holds_every_point_and_little_more() {
        let ball = solids::sphere(20.0, 48, 24);
        let raw: Vec<[[f32; 3]; 3]> = ball.iter().map(|t| t.map(|c| c.map(|x| x as f32))).collect();
        let stack = envelope(&Mesh::weld(&raw, 1.0));
        assert!(stack.windows(2).all(|w| w[0].to_mm == w[1].from_mm));
        assert!((stack[0].from_mm + 20.0).abs() < 1e-5 && (stack[stack.len() - 1].to_mm - 20.0).abs() < 1e-5);
        for c in ball.iter().flatten() {
            let r = libm::hypot(c[0], c[1]);
            let around = stack.iter().filter(|p| p.from_mm - 1e-5 <= c[2] && c[2] <= p.to_mm + 1e-5);
            assert!(around.map(|p| p.r0_mm).fold(0.0, f64::max) >= r - 1e-5);
        }
        for p in &stack {
            let nearest = if p.from_mm < 0.0 && p.to_mm > 0.0 { 0.0 } else { p.from_mm.abs().min(p.to_mm.abs()) };
            assert!(p.r0_mm <= libm::sqrt(400.0 - nearest * nearest) + 1e-3, "{p:?}");
        }
    }
}
