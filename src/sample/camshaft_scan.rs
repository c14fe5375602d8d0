//! The scan of a worn camshaft, its file, and the truth about it.
//!
//! One lobe of the sample `camshaft` is worn on a flank, up to the nose. The lobe is a cylinder over its outline, so its
//! skin unrolls without stretch into (way along the outline, way along the axis). There the depth is h·(1 − (r/R)²)², r
//! being the distance from the middle of the worn place, measured against the facet's normal. Depth and way are those of
//! the facets, and so the truth is that of the mesh: area and volume of the plane hold exactly, volume being depth
//! summed over the skin of the model. What is really missing is 0.3 % less than that, since the skin is convex.
//!
//! Nothing here finds the wear again.

use super::camshaft::{LOBE, LOBE_SIDES, WORN_NOSE_DEG, triangles, worn_span};
use super::outline::{Flat, radians};
use super::scan_maker::{MadeScan, ScanRecipe, SkinPoint, made_scan};
use nalgebra::{Point3, UnitVector3, Vector3};
use std::f64::consts::PI;

/// Deepest wear, mm (P3, Fig. 3).
pub const DEEPEST_MM: f64 = 0.2;
/// Radius of the worn place in the unrolled skin, mm; the lobe is 14.8 mm wide.
pub const RADIUS_MM: f64 = 7.0;
/// Depth from which on the worn place is told, mm.
pub const THRESHOLD_MM: f64 = 0.05;
/// Its middle, mm along the outline from the nose: where the flank turns from the sharp nose, so the skin's radius is
/// 4.1 mm at one end of the worn place and 30 mm at the other.
const FROM_NOSE_MM: f64 = -8.0;
/// 12 points on each mm² of the worn lobe, a third of that elsewhere.
const POINTS: usize = 84_000;
const DENSER: f64 = 3.0;

/// The running surface of the worn lobe, unrolled.
struct Unrolled {
    /// Corners of the outline, (y, z), and the way to each from the nose.
    corners: Vec<Flat>,
    ways: Vec<f64>,
    /// Where it begins and ends along x, mm.
    span: [f64; 2],
}

impl Unrolled {
    fn new() -> Unrolled {
        let corners = LOBE.points(&LOBE.angles(LOBE_SIDES), 0.0, radians(WORN_NOSE_DEG));
        let mut ways = vec![0.0];
        for pair in corners.windows(2) {
            let [p, q] = [pair[0], pair[1]];
            ways.push(ways[ways.len() - 1] + libm::hypot(q[0] - p[0], q[1] - p[1]));
        }
        let to_nose = ways[LOBE_SIDES / 2];
        ways.iter_mut().for_each(|way| *way -= to_nose);
        Unrolled { corners, ways, span: worn_span() }
    }

    fn has(&self, p: &SkinPoint) -> bool {
        (self.span[0]..=self.span[1]).contains(&p.place.x) && p.normal.x.abs() < 0.1
    }

    /// The way along the outline to the nearest place on it, mm from the nose.
    fn way_mm(&self, place: &Point3<f64>) -> f64 {
        let mut best = (f64::INFINITY, 0.0);
        for (k, pair) in self.corners.windows(2).enumerate() {
            let [p, q] = [pair[0], pair[1]];
            let (u, v) = ([q[0] - p[0], q[1] - p[1]], [place.y - p[0], place.z - p[1]]);
            let share = ((u[0] * v[0] + u[1] * v[1]) / (u[0] * u[0] + u[1] * u[1])).clamp(0.0, 1.0);
            let off = [v[0] - share * u[0], v[1] - share * u[1]];
            let squared = off[0] * off[0] + off[1] * off[1];
            if squared < best.0 {
                best = (squared, self.ways[k] + share * (self.ways[k + 1] - self.ways[k]));
            }
        }
        best.1
    }

    /// Where a point of the surface lies from the middle of the worn place: along the outline, along the axis, mm.
    fn off_middle(&self, place: &Point3<f64>) -> [f64; 2] {
        [self.way_mm(place) - FROM_NOSE_MM, place.x - 0.5 * (self.span[0] + self.span[1])]
    }

    fn depth_mm(&self, p: &SkinPoint) -> f64 {
        if !self.has(p) {
            return 0.0;
        }
        let [along, across] = self.off_middle(&p.place);
        let share = (along * along + across * across) / (RADIUS_MM * RADIUS_MM);
        if share < 1.0 { DEEPEST_MM * (1.0 - share) * (1.0 - share) } else { 0.0 }
    }
}

/// The scan: from above in front, so that the worn side is seen and the back is not.
pub fn scan() -> MadeScan {
    let lobe = Unrolled::new();
    let density = |p: &SkinPoint| if lobe.has(p) { DENSER } else { 1.0 };
    let wear = |p: &SkinPoint| lobe.depth_mm(p);
    let recipe = ScanRecipe {
        seen_from: UnitVector3::new_normalize(Vector3::new(0.3, -0.8, 0.5)),
        density: Some(&density),
        wear_mm: Some(&wear),
        ..ScanRecipe::of(POINTS, 2011)
    };
    made_scan(&triangles(), &recipe)
}

/// Area of the worn place where it is deeper than the threshold, mm².
pub fn worn_area_mm2() -> f64 {
    PI * RADIUS_MM * RADIUS_MM * (1.0 - (THRESHOLD_MM / DEEPEST_MM).sqrt())
}

/// Depth summed over that area, mm³.
pub fn worn_volume_mm3() -> f64 {
    let share = THRESHOLD_MM / DEEPEST_MM;
    PI * RADIUS_MM * RADIUS_MM * DEEPEST_MM / 3.0 * (1.0 - share * share.sqrt())
}

/// Points as a binary PLY file: x, y and z as float, lower byte first; 12 bytes a point.
pub fn ply_bytes(points: &[Point3<f64>]) -> Vec<u8> {
    let properties = "property float x\nproperty float y\nproperty float z";
    let count = points.len();
    let head = format!("ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{properties}\nend_header\n");
    let numbers = points.iter().flat_map(|p| [p.x, p.y, p.z]).flat_map(|x| (x as f32).to_le_bytes());
    head.bytes().chain(numbers).collect()
}

/// The truth as JSON: `model_from_scan` (16 numbers, row-major, mm) and the figures of the wear.
pub fn truth_json(scan: &MadeScan) -> String {
    let rows: Vec<f64> = scan.model_from_scan.to_homogeneous().transpose().iter().copied().collect();
    let truth = serde_json::json!({
        "model_from_scan": rows,
        "deepest_mm": DEEPEST_MM,
        "threshold_mm": THRESHOLD_MM,
        "worn_area_mm2": worn_area_mm2(),
        "worn_volume_mm3": worn_volume_mm3(),
    });
    format!("{truth:#}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Unrolled {
        /// Turn of the outline by way, at a way from the nose, 1/mm: between the corners two before and two behind.
        fn curvature(&self, way_mm: f64) -> f64 {
            let k = self.ways.partition_point(|w| *w < way_mm).clamp(3, LOBE_SIDES - 3);
            let heading = |i: usize| {
                let (p, q) = (self.corners[i], self.corners[i + 1]);
                libm::atan2(q[1] - p[1], q[0] - p[0])
            };
            let turn = libm::remainder(heading(k + 1) - heading(k - 2), 2.0 * PI);
            turn / (0.5 * (self.ways[k + 2] + self.ways[k + 1] - self.ways[k - 1] - self.ways[k - 2]))
        }
    }

    #[test]
    fn every_part_of_the_worn_place_has_ten_points_on_each_square_millimetre() {
        let (scan, lobe) = (scan(), Unrolled::new());
        let mut quarters = [0usize; 4];
        for at in scan.taken_from.iter().flatten().filter(|at| lobe.has(at)) {
            let [along, across] = lobe.off_middle(&at.place);
            if along * along + across * across < RADIUS_MM * RADIUS_MM {
                quarters[usize::from(along > 0.0) + 2 * usize::from(across > 0.0)] += 1;
            }
        }
        let quarter_mm2 = PI * RADIUS_MM * RADIUS_MM / 4.0;
        for count in quarters {
            let density = count as f64 / quarter_mm2;
            assert!((10.5..16.0).contains(&density), "{density} points/mm²");
        }
        let sides = [-Vector3::y(), Vector3::y(), Vector3::x(), -Vector3::x()];
        let seen = sides.map(|n| scan.taken_from.iter().flatten().filter(|at| at.normal.dot(&n) > 0.95).count());
        assert!(seen[0] > 5_000 && seen[1] == 0 && seen[2] > 5_000 && seen[3] > 5_000, "{seen:?}");
    }

    /// Cut into small pieces, the worn lobe's facets have the area and the volume that the truth says.
    #[test]
    fn area_and_volume_are_those_of_the_facets() {
        let lobe = Unrolled::new();
        let (mut area, mut volume, mut deepest, mut convex) = (0.0, 0.0, 0.0f64, 0.0);
        const CUTS: usize = 10;
        for (facet, t) in triangles().iter().enumerate() {
            let [a, b, c] = t.map(Point3::from);
            let cross = (b - a).cross(&(c - a));
            let normal = cross.normalize();
            if !lobe.has(&SkinPoint { place: a + (b - a + (c - a)) / 3.0, normal, facet }) {
                continue;
            }
            let piece_mm2 = 0.5 * cross.norm() / (CUTS * CUTS) as f64;
            for (i, j) in (0..CUTS).flat_map(|i| (0..2 * (CUTS - i) - 1).map(move |j| (i, j))) {
                // Pieces of a row stand on their base and on their point in turns; each counts by its middle.
                let third = if j % 2 == 0 { 1.0 / 3.0 } else { 2.0 / 3.0 };
                let (u, v) = ((i as f64 + third) / CUTS as f64, ((j / 2) as f64 + third) / CUTS as f64);
                let at = SkinPoint { place: a + (b - a) * u + (c - a) * v, normal, facet };
                let depth = lobe.depth_mm(&at);
                deepest = deepest.max(depth);
                if depth > THRESHOLD_MM {
                    area += piece_mm2;
                    volume += piece_mm2 * depth;
                    convex += piece_mm2 * depth * depth / 2.0 * lobe.curvature(lobe.way_mm(&at.place));
                }
            }
        }
        assert!((area / worn_area_mm2() - 1.0).abs() < 2e-3, "{area} {}", worn_area_mm2());
        assert!((volume / worn_volume_mm3() - 1.0).abs() < 2e-3, "{volume} {}", worn_volume_mm3());
        assert!((deepest - DEEPEST_MM).abs() < 1e-3, "{deepest}");
        let less = convex / volume;
        assert!((0.002..0.004).contains(&less), "{less}");
    }

    #[test]
    fn the_file_says_what_it_holds() {
        let bytes = ply_bytes(&[Point3::new(1.5, -2.0, 0.25), Point3::origin()]);
        let head = "ply\nformat binary_little_endian 1.0\nelement vertex 2\n\
                    property float x\nproperty float y\nproperty float z\nend_header\n";
        assert_eq!(&bytes[..head.len()], head.as_bytes());
        assert_eq!(bytes.len(), head.len() + 24);
        assert_eq!(bytes[head.len() + 4..head.len() + 8], (-2.0f32).to_le_bytes());
    }

    #[test]
    fn the_truth_is_a_motion_in_rows() {
        let scan = scan();
        let read: serde_json::Value = serde_json::from_str(&truth_json(&scan)).expect("JSON");
        let m: Vec<f64> =
            read["model_from_scan"].as_array().expect("numbers").iter().filter_map(|x| x.as_f64()).collect();
        assert_eq!((m.len(), &m[12..]), (16, &[0.0, 0.0, 0.0, 1.0][..]));
        let p = scan.points[7];
        let moved = Point3::from([0, 4, 8].map(|r| m[r] * p.x + m[r + 1] * p.y + m[r + 2] * p.z + m[r + 3]));
        assert!((moved - scan.model_from_scan * p).norm() < 1e-9);
    }
}
