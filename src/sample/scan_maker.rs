//! Scans of parts whose facets are known: points on them with noise, outliers, a side that was not seen, wear, and a
//! pose, together with the truth that a registration or a deviation is held to.
//!
//! A scan is made of the facets themselves, so what a mesh lacks of the true curve is no part of it. What lies in front
//! of what is not looked at: unseen is what faces away from the scanner, wherever it is.

use super::fixed_numbers::FixedNumbers;
use super::shell::Triangles;
use nalgebra::{Isometry3, Point3, Translation3, UnitVector3, Vector3};

/// How much the facing of a point counts beside its place when the unseen share is chosen: a scanner that stands to
/// one side sees the near end better, and never a back.
const FACING_WEIGHT: f64 = 0.7;
/// How far outliers lie outside of the part's box at most, as a share of its sides.
const OUTLIER_MARGIN: f64 = 0.2;
/// Scans lie this far from their origin along each axis at most, mm.
const SHIFT_MM: f64 = 200.0;

/// A point of the part's skin, in the part frame, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkinPoint {
    /// Where it is.
    pub place: Point3<f64>,
    /// The unit normal of its facet, outward.
    pub normal: Vector3<f64>,
    /// The facet it lies on.
    pub facet: usize,
}

/// A number for each point of the skin.
pub type OnSkin<'a> = &'a dyn Fn(&SkinPoint) -> f64;

/// What a scan is like.
#[derive(Clone, Copy)]
pub struct ScanRecipe<'a> {
    /// Number of points, outliers among them.
    pub points: usize,
    /// Standard deviation of the noise along each axis, mm.
    pub noise_mm: f64,
    /// Share of the points that are none of the part, 0 to 1.
    pub outlier_share: f64,
    /// Share of the skin that was not seen, 0 to below 1; by points, where they are denser at some places.
    pub missing_share: f64,
    /// Towards the scanner, in the part frame.
    pub seen_from: UnitVector3<f64>,
    /// Where the part stands in the frame of the scan.
    pub scan_from_model: Isometry3<f64>,
    /// How many times as dense as elsewhere the points lie; asked at the middle of each facet. `None`: evenly.
    pub density: Option<OnSkin<'a>>,
    /// Depth of wear, mm, against the normal: above 0 where material is missing.
    pub wear_mm: Option<OnSkin<'a>>,
    /// What all the rest follows from.
    pub seed: u64,
}

impl ScanRecipe<'_> {
    /// A scan as P3's sensor gives it: noise of 0.03 mm, 1 % outliers, 30 % not seen; turn, place and view follow from
    /// the seed.
    pub fn of(points: usize, seed: u64) -> ScanRecipe<'static> {
        let mut numbers = FixedNumbers::new(!seed);
        let turn = numbers.turn();
        let shift = Vector3::from_fn(|_, _| SHIFT_MM * (2.0 * numbers.share() - 1.0));
        ScanRecipe {
            points,
            noise_mm: 0.03,
            outlier_share: 0.01,
            missing_share: 0.3,
            seen_from: numbers.direction(),
            scan_from_model: Isometry3::from_parts(Translation3::from(shift), turn),
            density: None,
            wear_mm: None,
            seed,
        }
    }
}

/// A scan and the truth about it.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeScan {
    /// The points in the frame of the scan, mm, in no order.
    pub points: Vec<Point3<f64>>,
    /// Where each was taken from; `None` for an outlier.
    pub taken_from: Vec<Option<SkinPoint>>,
    /// What brings the scan onto the model.
    pub model_from_scan: Isometry3<f64>,
}

/// The scan of a part. No points where the part has no area.
pub fn made_scan(part: &Triangles, recipe: &ScanRecipe<'_>) -> MadeScan {
    let mut numbers = FixedNumbers::new(recipe.seed);
    let outliers = (recipe.points as f64 * recipe.outlier_share.clamp(0.0, 1.0)).round() as usize;
    let kept = recipe.points - outliers;
    let all = (kept as f64 / (1.0 - recipe.missing_share.clamp(0.0, 0.99))).ceil() as usize;
    let skin = seen(spread(part, recipe.density, all.max(kept), &mut numbers), part, recipe, kept);
    let mut made: Vec<(Point3<f64>, Option<SkinPoint>)> = Vec::with_capacity(recipe.points);
    for at in skin {
        let depth_mm = recipe.wear_mm.map_or(0.0, |wear| wear(&at));
        let place = at.place - at.normal * depth_mm + numbers.normal_vector() * recipe.noise_mm;
        made.push((recipe.scan_from_model * place, Some(at)));
    }
    if let Some((lo, hi)) = bounds(part).filter(|_| !made.is_empty()) {
        for _ in 0..outliers {
            let span = |k: usize, share: f64| {
                lo[k] + (hi[k] - lo[k]) * (share * (1.0 + 2.0 * OUTLIER_MARGIN) - OUTLIER_MARGIN)
            };
            let place = Point3::from(Vector3::from_fn(|k, _| span(k, numbers.share())));
            made.push((recipe.scan_from_model * place, None));
        }
    }
    numbers.shuffle(&mut made);
    let (points, taken_from) = made.into_iter().unzip();
    MadeScan { points, taken_from, model_from_scan: recipe.scan_from_model.inverse() }
}

/// Points on the facets, in their order: as many as asked for, each in a piece of its own of the skin laid end to
/// end, so that no place has many more or fewer than its due.
pub fn spread(
    part: &Triangles,
    density: Option<OnSkin<'_>>,
    count: usize,
    numbers: &mut FixedNumbers,
) -> Vec<SkinPoint> {
    let corners = |t: &[[f64; 3]; 3]| t.map(Point3::from);
    let crosses = part.iter().map(corners).map(|[a, b, c]| (b - a).cross(&(c - a)));
    let mut whole = 0.0;
    let (mut ends, mut normals) = (Vec::with_capacity(part.len()), Vec::with_capacity(part.len()));
    for (facet, cross) in crosses.enumerate() {
        let twice = cross.norm();
        let normal = if twice > 0.0 { cross / twice } else { Vector3::zeros() };
        let [a, b, c] = corners(&part[facet]);
        let middle = SkinPoint { place: Point3::from((a.coords + b.coords + c.coords) / 3.0), normal, facet };
        whole += twice * density.map_or(1.0, |of| of(&middle).max(0.0));
        ends.push(whole);
        normals.push(normal);
    }
    let mut points = Vec::with_capacity(count);
    if !(whole > 0.0 && whole.is_finite()) {
        return points;
    }
    let mut facet = 0;
    for i in 0..count {
        let way = whole * ((i as f64 + numbers.share()) / count as f64);
        while facet + 1 < part.len() && ends[facet] <= way {
            facet += 1;
        }
        let [a, b, c] = corners(&part[facet]);
        let (mut u, mut v) = (numbers.share(), numbers.share());
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        points.push(SkinPoint { place: a + (b - a) * u + (c - a) * v, normal: normals[facet], facet });
    }
    points
}

/// Those points that the scanner sees best, in their order.
fn seen(points: Vec<SkinPoint>, part: &Triangles, recipe: &ScanRecipe<'_>, kept: usize) -> Vec<SkinPoint> {
    let Some((lo, hi)) = bounds(part).filter(|_| kept < points.len()) else { return points };
    let size = (hi - lo).norm();
    let score =
        |p: &SkinPoint| (p.place - lo).dot(&recipe.seen_from) / size + FACING_WEIGHT * p.normal.dot(&recipe.seen_from);
    let scores: Vec<f64> = points.iter().map(score).collect();
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| scores[j].total_cmp(&scores[i]).then(i.cmp(&j)));
    order.truncate(kept);
    order.sort_unstable();
    order.into_iter().map(|i| points[i]).collect()
}

/// The corners of the box around all facets.
fn bounds(part: &Triangles) -> Option<(Point3<f64>, Point3<f64>)> {
    part.iter().flatten().copied().map(Point3::from).fold(None, |box_, p| {
        let (lo, hi) = box_.unwrap_or((p, p));
        Some((lo.inf(&p), hi.sup(&p)))
    })
}

#[cfg(test)]
mod tests {
    use super::super::solids;
    use super::*;

    fn cube_scan(recipe: &ScanRecipe<'_>) -> MadeScan {
        made_scan(&solids::cube(10.0), recipe)
    }

    /// Back in the part frame a scan without noise lies where it was taken, less its wear.
    #[test]
    fn the_truth_brings_the_scan_onto_the_part() {
        let wear = |p: &SkinPoint| if p.normal.z > 0.5 { 0.2 } else { 0.0 };
        let recipe = ScanRecipe { noise_mm: 0.0, wear_mm: Some(&wear), ..ScanRecipe::of(2_000, 3) };
        let scan = cube_scan(&recipe);
        assert_eq!((scan.points.len(), scan.taken_from.len()), (2_000, 2_000));
        assert_eq!(scan.taken_from.iter().filter(|t| t.is_none()).count(), 20);
        for (p, at) in scan.points.iter().zip(&scan.taken_from) {
            let back = scan.model_from_scan * p;
            match at {
                Some(at) => assert!((back - (at.place - at.normal * wear(at))).norm() < 1e-9),
                None => assert!(back.iter().all(|x| (-2.0..=12.0).contains(x)), "{back}"),
            }
        }
        assert_eq!(scan, cube_scan(&recipe));
        assert_ne!(scan.points, cube_scan(&ScanRecipe { seed: 4, ..recipe }).points);
    }

    #[test]
    fn noise_has_the_deviation_asked_for() {
        let scan = cube_scan(&ScanRecipe { outlier_share: 0.0, ..ScanRecipe::of(20_000, 5) });
        let squares = scan.points.iter().zip(&scan.taken_from).map(|(p, at)| {
            let at = at.expect("no outliers");
            (scan.model_from_scan * p - at.place).norm_squared() / 3.0
        });
        let deviation_mm = (squares.sum::<f64>() / 20_000.0).sqrt();
        assert!((deviation_mm - 0.03).abs() < 0.0005, "{deviation_mm}");
    }

    /// Of a cube seen along z, half of the skin is: the top, and of the sides the upper part; never the bottom.
    #[test]
    fn what_faces_away_is_missing() {
        let recipe = ScanRecipe { missing_share: 0.5, seen_from: Vector3::z_axis(), ..ScanRecipe::of(6_000, 9) };
        let scan = cube_scan(&recipe);
        let seen: Vec<SkinPoint> = scan.taken_from.iter().flatten().copied().collect();
        let on = |z: f64| seen.iter().filter(|p| (p.normal.z - z).abs() < 0.5).count();
        assert_eq!((seen.len(), on(-1.0)), (5_940, 0));
        // A sixth of the 11 880 points before the choice, within the one or two at which a facet begins.
        assert!(on(1.0).abs_diff(1_980) <= 3, "{}", on(1.0));
        let lowest = seen.iter().map(|p| p.place.z).fold(f64::INFINITY, f64::min);
        assert!((lowest - 5.0).abs() < 0.2, "{lowest}");
    }

    #[test]
    fn density_gives_each_facet_its_due() {
        let density = |p: &SkinPoint| if p.normal.x > 0.5 { 3.0 } else { 1.0 };
        let points = spread(&solids::cube(10.0), Some(&density), 8_000, &mut FixedNumbers::new(1));
        let mut counts = [0usize; 12];
        points.iter().for_each(|p| counts[p.facet] += 1);
        for (facet, count) in counts.into_iter().enumerate() {
            let dense = points.iter().any(|p| p.facet == facet && p.normal.x > 0.5);
            assert!(count.abs_diff(if dense { 1_500 } else { 500 }) <= 2, "facet {facet}: {count}");
        }
    }

    #[test]
    fn a_part_without_area_gives_no_points() {
        let needle: Triangles = vec![[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]];
        for part in [Triangles::new(), needle] {
            assert!(made_scan(&part, &ScanRecipe::of(100, 1)).points.is_empty());
        }
    }
}
