//! A weld in the view: the points of its beads by their height, their centre lines, and the camera that saw them.

use super::colormap::viridis;
use crate::part::Hasher;
use crate::planning::welded::MeasuredWeld;
use crate::view::{CloudItem, Depth, LineItem, LineSegment};
use crate::weld::bead::WeldBead;
use crate::weld::camera::DepthCamera;
use nalgebra::{Isometry3, Point3, Vector3};
use std::sync::Arc;

/// Side of a dot, points of the display: the points of a bead lie a few tenths of a millimetre apart.
const SIZE_POINTS: f32 = 2.5;
/// How far points are drawn in front of their places, as a multiple of the noise: half of them lie below the surface that
/// is laid through them.
const LIFT_NOISES: f64 = 4.0;
const CENTRE_WIDTH_PX: f32 = 3.5;
const CENTRE: [u8; 4] = [20, 22, 26, 255];
const CAMERA_WIDTH_PX: f32 = 2.0;
/// Length of the camera's axes as a share of its distance.
const CAMERA_SHARE: f64 = 0.12;
/// Axes of a frame: x red, y green, z blue.
const AXES: [[u8; 4]; 3] = [[222, 22, 34, 255], [20, 150, 60, 255], [0, 101, 220, 255]];
/// The edges of what the camera sees.
const SIGHT: [u8; 4] = [150, 154, 162, 255];

/// What is shown of a weld, part frame.
#[derive(Clone, Debug)]
pub struct WeldPicture {
    /// The points of all beads by their height; `None` without a bead.
    pub points: Option<CloudItem>,
    /// Centre lines, and the camera.
    pub lines: Vec<LineItem>,
    /// The height at the end of the scale, mm.
    pub highest_mm: f64,
}

/// A weld in the view. `size`: of the camera's images, px.
pub fn weld_picture(
    measured: &MeasuredWeld,
    camera: &DepthCamera,
    size: [usize; 2],
    part_from_camera: &Isometry3<f64>,
) -> WeldPicture {
    let beads: Vec<&WeldBead> = measured.areas.iter().filter_map(|area| area.bead.as_ref()).collect();
    let highest_mm = beads.iter().map(|bead| bead.max_height_mm).fold(0.0, f64::max);
    let mut lines: Vec<LineItem> = beads.iter().map(|bead| centre_line(bead, part_from_camera)).collect();
    lines.push(camera_frame(camera, size, part_from_camera));
    WeldPicture { points: points(&beads, highest_mm, part_from_camera), lines, highest_mm }
}

/// The colour of a height on a scale up to `highest_mm`.
pub fn height_color(height_mm: f64, highest_mm: f64) -> [u8; 3] {
    viridis(height_mm / highest_mm.max(1e-9))
}

fn points(beads: &[&WeldBead], highest_mm: f64, part_from_camera: &Isometry3<f64>) -> Option<CloudItem> {
    let all = || beads.iter().flat_map(|bead| &bead.points);
    let first = all().next()?.point;
    let places: Vec<[f32; 3]> = all().map(|p| near(&(p.point - first).into())).collect();
    let opaque = |[r, g, b]: [u8; 3]| [r, g, b, 255];
    let colors: Vec<[u8; 4]> = all().map(|p| opaque(height_color(p.height_mm, highest_mm))).collect();
    let bits: Vec<u32> = places.as_flattened().iter().map(|x| x.to_bits()).collect();
    let noise_mm = beads.iter().map(|bead| bead.parent.noise_mm).fold(0.0, f64::max);
    Some(CloudItem {
        geometry_key: Hasher::default().u32s(&bits).finish().0 as u64,
        places: Arc::new(places),
        colors_key: Hasher::default().bytes(colors.as_flattened()).finish().0 as u64,
        colors: Arc::new(colors),
        size_points: SIZE_POINTS,
        lift_mm: (LIFT_NOISES * noise_mm).min(highest_mm) as f32,
        fades: false,
        scene_from_item: part_from_camera * nalgebra::Translation3::from(first.coords),
    })
}

/// Along the crest, so that it is seen from the side as well.
fn centre_line(bead: &WeldBead, part_from_camera: &Isometry3<f64>) -> LineItem {
    let crest = |s: &crate::weld::bead::WeldSection| part_from_camera * (s.centre + s.normal * s.height_mm.max(0.0));
    let places: Vec<[f32; 3]> = bead.sections.iter().map(|s| near(&crest(s))).collect();
    let pieces = places.windows(2).map(|w| LineSegment { a: w[0], b: w[1], color: CENTRE });
    line(pieces.collect(), CENTRE_WIDTH_PX)
}

/// The axes of the camera's frame, and the corners of what it sees at their end.
fn camera_frame(camera: &DepthCamera, [width, height]: [usize; 2], part_from_camera: &Isometry3<f64>) -> LineItem {
    let eye = part_from_camera * Point3::origin();
    // The part frame is somewhere in sight, or the camera's own: then its distance is unknown, and a hand wide does.
    let length_mm = (CAMERA_SHARE * eye.coords.norm()).max(30.0);
    let to = |from: Point3<f64>, at: Vector3<f64>, color| LineSegment {
        a: near(&from),
        b: near(&(part_from_camera * Point3::from(at))),
        color,
    };
    let mut pieces: Vec<LineSegment> =
        (0..3).zip(AXES).map(|(k, color)| to(eye, Vector3::ith(k, length_mm), color)).collect();
    let [right, below] = [width, height].map(|n| n as f64 - 1.0);
    let corners = [[0.0, 0.0], [right, 0.0], [right, below], [0.0, below]];
    let seen: Vec<Vector3<f64>> =
        corners.iter().filter_map(|[u, v]| camera.ray(*u, *v)).map(|ray| ray * (length_mm / ray.z.max(1e-9))).collect();
    for (i, corner) in seen.iter().enumerate() {
        let next = seen[(i + 1) % seen.len()];
        pieces.push(to(eye, *corner, SIGHT));
        pieces.push(to(part_from_camera * Point3::from(*corner), next, SIGHT));
    }
    line(pieces, CAMERA_WIDTH_PX)
}

fn near(p: &Point3<f64>) -> [f32; 3] {
    [p.x as f32, p.y as f32, p.z as f32]
}

fn line(segments: Vec<LineSegment>, width_px: f32) -> LineItem {
    let bits: Vec<u32> =
        segments.iter().flat_map(|s| [s.a, s.b]).flatten().map(f32::to_bits).chain([width_px.to_bits()]).collect();
    LineItem {
        key: Hasher::default().u32s(&bits).finish().0 as u64,
        segments: Arc::new(segments),
        width_px,
        depth: Depth::OnTop,
        scene_from_item: Isometry3::identity(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_goes_from_dark_to_light_and_stays_within_its_ends() {
        let gray = |mm: f64| height_color(mm, 15.0).iter().map(|x| u32::from(*x)).sum::<u32>();
        assert!(gray(0.0) < gray(7.0) && gray(7.0) < gray(15.0));
        assert_eq!(
            (height_color(-1.0, 15.0), height_color(99.0, 15.0)),
            (height_color(0.0, 15.0), height_color(15.0, 15.0))
        );
    }

    #[test]
    fn a_weld_without_a_bead_shows_its_camera_alone() {
        let [fx, fy, cx, cy, units_per_mm] = [600.0, 600.0, 319.5, 239.5, 10.0];
        let [k1, k2, p1, p2, k3] = [0.0; 5];
        let camera = DepthCamera { width: None, height: None, fx, fy, cx, cy, units_per_mm, k1, k2, p1, p2, k3 };
        let picture =
            weld_picture(&MeasuredWeld::default(), &camera, [640, 480], &Isometry3::translation(0.0, 0.0, 300.0));
        assert!(picture.points.is_none() && picture.lines.len() == 1);
        let segments = &picture.lines[0].segments;
        assert_eq!(segments[0].a, [0.0, 0.0, 300.0]);
        assert!(segments.len() == 11, "three axes, four edges and what they end at");
    }
}
