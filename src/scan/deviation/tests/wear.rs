//! Patches of wear by formula, h·(1 − (r/R)²)² with h = 0.2 and R = 10 mm: above t = 0.05 mm area πR²(1 − √(t/h)) =
//! 157.08 mm² and volume πR²h(1 − (t/h)^1.5)/3 = 18.33 mm³.

use super::*;

const H: f64 = 0.2;
const R: f64 = 10.0;
const T: f64 = 0.05;
const AREA: f64 = 157.08;
const VOLUME: f64 = 18.326;

fn wear(r: f64) -> f64 {
    if r < R { H * (1.0 - r * r / (R * R)) * (1.0 - r * r / (R * R)) } else { 0.0 }
}

fn patches_of(part: &Part, points: &[Point3<f64>]) -> (Patches, f64) {
    let (cloud, deviation) = measured(part, points);
    let progress = Progress::default();
    let depths = SmoothedDepths::new(part, &cloud, &deviation, &progress).expect("nobody cancels");
    let rules = PatchRules { min_depth_mm: T, min_area_mm2: 0.0 };
    let patches = Patches::new(part, &depths, &rules, &progress).expect("nobody cancels");
    (patches, unscanned::unscanned_mm2(part, &depths, &progress).expect("nobody cancels"))
}

fn is_near(found: f64, truth: f64, share: f64) -> bool {
    (found / truth - 1.0).abs() < share
}

/// A scan of the sheet with wear about (2, 1), 10 points/mm².
fn worn_sheet(noise: f64, draw: &mut Draw) -> Vec<Point3<f64>> {
    let point = |draw: &mut Draw| {
        let (x, y) = (40.0 * draw.even() - 20.0, 40.0 * draw.even() - 20.0);
        let r = ((x - 2.0) * (x - 2.0) + (y - 1.0) * (y - 1.0)).sqrt();
        Point3::new(x, y, noise * draw.normal() - wear(r))
    };
    (0..16_000).map(|_| point(draw)).collect()
}

/// Two facets, each far larger than the patch.
#[test]
fn wear_on_a_plane_is_told_with_depth_area_and_volume() {
    let part = part_of(&sheet(40.0));
    for (noise, depth, share) in [(0.0, 0.005, 0.01), (0.03, 0.01, 0.03), (0.05, 0.02, 0.03)] {
        let (found, open) = patches_of(&part, &worn_sheet(noise, &mut Draw(3)));
        assert_eq!(
            found.patches.len(),
            1,
            "{noise}: {:?}",
            found.patches.iter().map(|p| p.area_mm2).collect::<Vec<_>>()
        );
        let p = &found.patches[0];
        assert_eq!((p.kind, p.facets.as_slice()), (PatchKind::Missing, [0, 1].as_slice()));
        assert!((p.depth_mm - H).abs() < depth, "{noise}: depth {}", p.depth_mm);
        assert!(is_near(p.area_mm2, AREA, share), "{noise}: area {}", p.area_mm2);
        assert!(is_near(p.volume_mm3, VOLUME, share), "{noise}: volume {}", p.volume_mm3);
        assert!((p.centre - Point3::new(2.0, 1.0, 0.0)).norm() < 0.3, "{}", p.centre);
        // The outlines enclose the area (Gauss), holes the other way round.
        let ring = |line: &[Point3<f64>], i: usize| (line[i], line[(i + 1) % line.len()]);
        let enclosed = p.outlines.iter().flat_map(|line| (0..line.len()).map(|i| ring(line, i)));
        let enclosed: f64 = enclosed.map(|(a, b)| 0.5 * (a.x * b.y - a.y * b.x)).sum();
        assert!((enclosed - p.area_mm2).abs() < 1e-6);
        assert!(open < 2.0, "{open}");
    }
}

/// The same wear around a cylinder's side, r along the skin, and its surplus on the other side.
#[test]
fn wear_and_surplus_on_a_cylinder() {
    let (radius, height) = (25.0, 50.0);
    let part = part_of(&solids::cylinder(radius, height, 120));
    // Of the polygon that the cylinder is.
    let step = std::f64::consts::TAU / 120.0;
    let skin = |angle: f64| radius * libm::cos(0.5 * step) / libm::cos(angle % step - 0.5 * step);
    let mut draw = Draw(8);
    let point = |draw: &mut Draw| {
        let (angle, z) = (std::f64::consts::TAU * draw.even(), height * draw.even());
        let (u, v) = ((angle - 1.0) * radius, (angle - 4.0) * radius);
        let r = |u: f64| (u * u + (z - 25.0) * (z - 25.0)).sqrt();
        let out = skin(angle) - wear(r(u)) + wear(r(v)) + 0.03 * draw.normal();
        Point3::new(out * libm::cos(angle), out * libm::sin(angle), z)
    };
    let points: Vec<_> = (0..78_540).map(|_| point(&mut draw)).collect();
    let (found, open) = patches_of(&part, &points);
    assert_eq!(found.patches.len(), 2);
    for p in &found.patches {
        assert!((p.depth_mm - H).abs() < 0.01, "{:?}: depth {}", p.kind, p.depth_mm);
        assert!(is_near(p.area_mm2, AREA, 0.03), "{:?}: area {}", p.kind, p.area_mm2);
        assert!(is_near(p.volume_mm3, VOLUME, 0.03), "{:?}: volume {}", p.kind, p.volume_mm3);
    }
    let missing = found.patches.iter().find(|p| p.kind == PatchKind::Missing).expect("there is wear");
    let surplus = found.patches.iter().find(|p| p.kind == PatchKind::Surplus).expect("there is surplus");
    let at = |angle: f64| Point3::new(radius * libm::cos(angle), radius * libm::sin(angle), 25.0);
    assert!((missing.deepest_at - at(1.0)).norm() < 4.0 && (surplus.deepest_at - at(4.0)).norm() < 4.0);
    // The ends were not scanned.
    assert!(is_near(open, 2.0 * std::f64::consts::PI * radius * radius, 0.05), "{open}");
}

/// Wear over a crease of 90°: a patch on two faces of a cube, of even depth, told whole.
#[test]
fn a_patch_runs_over_a_crease() {
    let part = part_of(&solids::cube(30.0));
    let (up_to, mut draw) = (sums(&part.mesh), Draw(21));
    // Both faces at the edge x = z = 30 lack 0.3 mm within 8 mm of it, for y from 10 to 20.
    let point = |draw: &mut Draw| {
        let (p, f) = draw.on(&part.mesh, &up_to);
        let worn = (30.0 - p.x).max(30.0 - p.z) < 8.0 && (10.0..20.0).contains(&p.y);
        let side = part.mesh.normals[f].x > 0.5 || part.mesh.normals[f].z > 0.5;
        let off = if worn && side { -0.3 } else { 0.0 } + 0.02 * draw.normal();
        p + part.mesh.normals[f] * off
    };
    let points: Vec<_> = (0..54_000).map(|_| point(&mut draw)).collect();
    let (found, _) = patches_of(&part, &points);
    assert_eq!(found.patches.len(), 1);
    let p = &found.patches[0];
    assert_eq!(p.facets.len(), 2, "{:?}", p.facets);
    assert!((p.depth_mm - 0.3).abs() < 0.02, "{}", p.depth_mm);
    // The threshold lies at a sixth of the step: smoothing moves the outline out by a third of its radius there.
    assert!(is_near(p.area_mm2, 160.0, 0.15), "{}", p.area_mm2);
}

/// The back of a wall 0.8 mm thin is not worn because its front is, and half of the front is not scanned.
#[test]
fn a_thin_wall_has_two_sides_and_what_was_not_scanned_is_no_patch() {
    let mut wall = sheet(40.0);
    let mut points = worn_sheet(0.02, &mut Draw(30));
    let back: Vec<_> = sheet(40.0).iter().map(|[a, b, c]| [*a, *c, *b].map(|[x, y, _]| [x, y, -0.8])).collect();
    wall.extend(back);
    let part = part_of(&wall);
    let mut draw = Draw(31);
    points.extend(
        (0..16_000)
            .map(|_| Point3::new(40.0 * draw.even() - 20.0, 40.0 * draw.even() - 20.0, -0.8 + 0.02 * draw.normal())),
    );
    let (found, open) = patches_of(&part, &points);
    assert_eq!(found.patches.len(), 1);
    assert_eq!(found.patches[0].facets, [0, 1]);
    assert!(is_near(found.patches[0].area_mm2, AREA, 0.03), "{}", found.patches[0].area_mm2);
    assert!(open < 4.0, "{open}");
    // Half of the patch is left.
    points.retain(|p| p.x < 2.0 || p.z < -0.4);
    let (found, open) = patches_of(&part, &points);
    assert_eq!(found.patches.len(), 1);
    assert!(is_near(found.patches[0].area_mm2, 0.5 * AREA, 0.15), "{}", found.patches[0].area_mm2);
    assert!(is_near(open, 18.0 * 40.0, 0.05), "{open}");
    assert!(found.field.depth_mm.iter().any(|d| d.is_nan()));
}

/// Points of the worn area are told for a fit without them.
#[test]
fn worn_points_are_those_of_the_patch() {
    let part = part_of(&sheet(40.0));
    let points = worn_sheet(0.02, &mut Draw(40));
    let (cloud, deviation) = measured(&part, &points);
    let depths = SmoothedDepths::new(&part, &cloud, &deviation, &Progress::default()).expect("nobody cancels");
    let sigma_mm = DeviationStatistics::of(&deviation).sigma_mm;
    assert!((0.02..0.03).contains(&sigma_mm), "{sigma_mm}");
    let worn = depths.worn_points(cloud.len(), 0.06);
    for (p, worn) in points.iter().zip(worn) {
        let depth = wear(((p.x - 2.0) * (p.x - 2.0) + (p.y - 1.0) * (p.y - 1.0)).sqrt());
        assert!(worn == (depth > 0.06) || (depth - 0.06).abs() < 0.02, "{p}: {depth}");
    }
    assert!((depths.density_per_mm2() / 10.0 - 1.0).abs() < 0.05, "{}", depths.density_per_mm2());
    let deepest = depths.depth_mm(&Point3::new(2.0, 1.0, 0.0), &[Vector3::z()]).expect("it was scanned");
    assert!((deepest - H).abs() < 0.01, "{deepest}");
    assert_eq!(depths.depth_mm(&Point3::new(2.0, 1.0, 0.0), &[-Vector3::z()]), None);
}
