//! Two views of one part, brought together by what both saw.

use super::super::*;
use crate::sample::scan_maker::{ScanRecipe, made_scan};
use crate::sample::solids::{PlateFeature, cylinder, plate};
use crate::sample::{SAMPLES, Triangles};
use crate::scan::registration::{SlidingKind, SlidingMotion};
use nalgebra::{Point3, UnitVector3};

/// Two scans, and the motion that brings the second to the first.
struct Views {
    placed: Cloud,
    added: Cloud,
    truth: Isometry3<f64>,
    corners: Vec<Point3<f64>>,
}

/// Views from two sides; each sees `seen` of the skin. The outliers are none.
fn views(part: &Triangles, from: [[f64; 3]; 2], seen: f64, points: usize) -> Views {
    let scans = [0, 1].map(|k| {
        let seen_from = UnitVector3::new_normalize(Vector3::from(from[k]));
        let recipe = ScanRecipe {
            missing_share: 1.0 - seen,
            seen_from,
            outlier_share: 0.005,
            ..ScanRecipe::of(points, 11 + k as u64)
        };
        made_scan(part, &recipe)
    });
    let truth = scans[0].model_from_scan.inverse() * scans[1].model_from_scan;
    let [placed, added] = [0, 1].map(|k| Cloud::of_points(&scans[k].points));
    let all = part.iter().flatten().map(|p| Point3::from(*p));
    let (lo, hi) = all.fold((Point3::from(part[0][0]), Point3::from(part[0][0])), |(l, h), p| (l.inf(&p), h.sup(&p)));
    let corner = |i: usize| Point3::from([0, 1, 2].map(|k| if i >> k & 1 == 0 { lo[k] } else { hi[k] }));
    let corners = (0..8).map(|i| scans[1].model_from_scan.inverse() * corner(i)).collect();
    Views { placed, added, truth, corners }
}

impl Views {
    fn off_mm(&self, found: &Isometry3<f64>) -> f64 {
        self.corners.iter().map(|c| (found * c - self.truth * c).norm()).fold(0.0, f64::max)
    }

    /// A start that is off by 15° and a twentieth of the diagonal, about the middle of the scan.
    fn near(&self) -> OverlapStart {
        let (lo, hi) = self.added.bounds().expect("it has points");
        let middle = (lo + (hi - lo) * 0.5).coords;
        let shift = Vector3::new(0.6, -0.6, 0.5).normalize() * (0.05 * (self.corners[7] - self.corners[0]).norm());
        let off = Isometry3::new(shift, Vector3::new(0.6, 0.5, -0.6).normalize() * 15f64.to_radians());
        let about = Isometry3::translation(middle.x, middle.y, middle.z);
        OverlapStart::Near(self.truth * about * off * about.inverse())
    }

    fn found(&self, start: &OverlapStart) -> Result<OverlapFit, OverlapError> {
        by_overlap(&self.placed, &self.added, start, &Progress::default())
    }
}

fn bracket() -> Triangles {
    let feature = |x, y, diameter, height| PlateFeature { centre: [x, y], diameter, sides: 48, height };
    plate([80.0, 50.0, 12.0], &[feature(20.0, 18.0, 24.0, 25.0), feature(60.0, 30.0, 10.0, 0.0)])
}

fn camshaft() -> Triangles {
    let sample = SAMPLES.iter().find(|s| s.name == "camshaft").expect("it is shipped");
    (sample.triangles)()
}

#[test]
fn two_views_come_together_from_a_rough_start() {
    for (part, from) in [
        (bracket(), [[0.5, 0.2, 1.0], [-0.6, 0.5, 1.0]]),
        (bracket(), [[1.0, 0.1, 0.4], [0.2, 1.0, 0.5]]),
        (camshaft(), [[0.2, 1.0, 0.1], [0.1, -0.2, 1.0]]),
        (camshaft(), [[0.1, 1.0, 0.4], [-0.3, 0.6, -1.0]]),
    ] {
        let views = views(&part, from, 0.6, 40_000);
        let fit = views.found(&views.near()).expect("they overlap");
        let off = views.off_mm(&fit.common_from_scan);
        assert!(off < 0.05, "{off} {fit:?}");
        assert!(fit.overlap_share > 0.3 && fit.overlap_share < 0.8, "{fit:?}");
        assert!((fit.rms_mm / fit.noise_mm - 1.0).abs() < 0.25, "{fit:?}");
        assert!(fit.sliding.iter().all(|s| s.kind != SlidingKind::Slides), "{fit:?}");
    }
}

#[test]
fn from_anywhere_it_is_found_or_refused_and_never_wrong() {
    let of_bracket = views(&bracket(), [[0.5, 0.2, 1.0], [-0.6, 0.5, 1.0]], 0.6, 20_000);
    let fit = of_bracket.found(&OverlapStart::Anywhere).expect("a bracket is like itself in one way only");
    assert!(of_bracket.off_mm(&fit.common_from_scan) < 0.05, "{}", of_bracket.off_mm(&fit.common_from_scan));
    let of_shaft = views(&camshaft(), [[0.2, 1.0, 0.1], [0.1, -0.2, 1.0]], 0.6, 40_000);
    match of_shaft.found(&OverlapStart::Anywhere) {
        Ok(fit) => {
            assert!(of_shaft.off_mm(&fit.common_from_scan) < 0.05, "{} {fit:?}", of_shaft.off_mm(&fit.common_from_scan))
        }
        Err(error) => println!("{error}"),
    }
}

/// The two ends of a camshaft.
fn views_of_sides() -> Views {
    let part = camshaft();
    let (lo, hi) = part.iter().flatten().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p[0]), h.max(p[0])));
    let half = |from: f64| -> Triangles {
        let is_in = |t: &&[[f64; 3]; 3]| t.iter().all(|p| (from..from + 0.5).contains(&((p[0] - lo) / (hi - lo))));
        part.iter().filter(is_in).copied().collect()
    };
    let one = views(&half(0.0), [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0]], 0.9, 10_000);
    let other = views(&half(0.5), [[0.0, 1.0, 0.0], [0.0, 1.0, 0.0]], 0.9, 10_000);
    Views { added: other.added, ..one }
}

#[test]
fn views_that_share_nothing_are_refused() {
    let views = views(&bracket(), [[0.0, 0.1, 1.0], [0.1, 0.0, -1.0]], 0.35, 10_000);
    let refused = views.found(&OverlapStart::Near(views.truth));
    // The lower face fits on the upper one as well as on itself, 12 mm off.
    assert!(matches!(refused, Err(OverlapError::FarFromStart { .. })), "{refused:?}");
    let sides = views_of_sides();
    let refused = sides.found(&OverlapStart::Near(sides.truth));
    assert!(refused.is_err(), "{refused:?}");
}

/// The skin of a cylinder without its ends: along the axis and about it nothing holds, and what slides stays.
#[test]
fn what_slides_is_told() {
    let skin: Triangles = cylinder(10.0, 50.0, 96).into_iter().filter(|t| t.iter().any(|p| p[2] != t[0][2])).collect();
    let views = views(&skin, [[1.0, 0.2, 0.0], [0.3, 1.0, 0.0]], 0.6, 10_000);
    let fit = views.found(&OverlapStart::Near(views.truth)).expect("they overlap");
    let sliding: Vec<_> = fit.sliding.iter().filter(|s| s.kind == SlidingKind::Slides).collect();
    assert_eq!(sliding.len(), 2, "{sliding:?}");
    assert!(sliding.iter().any(|s| s.motion == SlidingMotion::Shift));
    assert!(views.off_mm(&fit.common_from_scan) < 0.1, "{}", views.off_mm(&fit.common_from_scan));
}

/// A plate without features is itself again after half a turn.
#[test]
fn what_fits_as_well_is_refused_from_anywhere() {
    let views = views(&plate([80.0, 50.0, 12.0], &[]), [[0.5, 0.2, 1.0], [-0.6, 0.5, 1.0]], 0.6, 10_000);
    match views.found(&OverlapStart::Anywhere) {
        Err(OverlapError::Ambiguous { poses }) => assert!(poses.len() >= 2, "{poses:?}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bytes_and_too_few_points_and_a_wish_to_end_are_told() {
    let views = views(&bracket(), [[0.5, 0.2, 1.0], [-0.6, 0.5, 1.0]], 0.6, 10_000);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| format!("{:?}", views.found(&views.near())))
    };
    assert_eq!(on(1), on(4));
    let few = by_overlap(&views.placed, &Cloud::default(), &views.near(), &Progress::default());
    assert_eq!(few, Err(OverlapError::TooFewPoints { found: 0, needed: 100 }));
    for looks in [1, 20] {
        let ended = by_overlap(&views.placed, &views.added, &views.near(), &Progress::ending_after(looks));
        assert_eq!(ended, Err(OverlapError::Cancelled));
    }
}
