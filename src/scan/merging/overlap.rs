//! A scan brought into the common frame by the area that it shares with what is there: point to plane between the clouds,
//! with the weights of registration, and points without a partner left out.
//!
//! From anywhere it is the search of registration, which knows the part's outside from its inside no better than the clouds
//! do: two views of a shaft may fit as well half a turn off. That is refused, and never chosen in silence.

use super::cloud_surface::CloudSurface;
use super::overlap_fit::{OverlapError, OverlapFit, OverlapStart};
use super::sampled::Sampled;
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use crate::scan::registration::coarse::{Apart, walked};
use crate::scan::registration::field::Field;
use crate::scan::registration::fine::SLIDES_BELOW;
use crate::scan::registration::plane_fit::{PlaneFit, Schedule, plane_fit};
use crate::scan::registration::sliding::Held;
use crate::scan::registration::starts::Skin;
use nalgebra::{Isometry3, Point3, Vector3};
use rayon::prelude::*;

/// Fewest points of a scan, as registration wants them.
const FEWEST_POINTS: usize = 100;
/// Points and steps of the way and of the end.
const WAY: (usize, usize) = (5_000, 30);
const END: (usize, usize) = (30_000, 8);
/// Points and steps by which poses from anywhere are told apart, and most poses.
const TRIED: (usize, usize) = (1_000, 16);
const MOST_TRIED: usize = 150;
/// Width of the weights at the first step as a share of the diagonal: from a start that is given, off by 15° and a
/// twentieth; from one that was found; at the end.
const GIVEN_WIDTH: f64 = 1.0 / 8.0;
const FOUND_WIDTH: f64 = 1.0 / 20.0;
const END_WIDTH: f64 = 1.0 / 150.0;
/// Points that are nearer than so many standard deviations lie on the other cloud.
const WITHIN_SIGMAS: f64 = 3.0;
/// What clouds without noise are off each other at the least, as a share of the diagonal.
const FLOOR: f64 = 1e-4;
/// Least share of a scan's points that lie on the other cloud: two thirds of the 30 % that scans ought to share, since points
/// beside edges have no partner. Not bracketed from below: wrong poses are told by what agrees, and by rivals.
const LEAST_OVERLAP: f64 = 0.2;
/// Least share of the points with a partner that lie on it. The right pose leaves out those beside edges: two views of
/// bracket and camshaft have 0.98 and more, wrong poses of the camshaft up to 0.86. A wrong one of the bracket has 0.998
/// as well, at 0.69 of the right one's overlap: `RIVAL` tells those.
const LEAST_AGREEING: f64 = 0.92;
/// How far from a start that was given the scan's middle may be moved, as a share of its diagonal, and how far it may be
/// turned, degrees: half as far again as a start may be off. A scan of a plate's other face comes to lie on the first
/// one by its thickness.
const MOST_MOVED: f64 = 0.075;
const MOST_TURNED_DEG: f64 = 22.5;
/// Another pose with this share of the best one's overlap is as good.
const RIVAL: f64 = 0.8;

/// Brings a scan (its frame, mm) to the cloud of those that are placed (common frame, mm). They ought to share 30 % of
/// the scan's area. Where both clouds have normals, those tell the two sides of a thin wall apart.
///
/// The same input gives the same bytes, on any number of threads.
///
/// # Errors
/// [`OverlapError`].
pub fn by_overlap(
    placed: &Cloud,
    added: &Cloud,
    start: &OverlapStart,
    progress: &Progress,
) -> Result<OverlapFit, OverlapError> {
    let diagonal_mm = placed.diagonal().max(added.diagonal());
    let placed_points = Sampled::new(placed, diagonal_mm, progress)?;
    let added_points = Sampled::new(added, diagonal_mm, progress)?;
    let found = placed_points.thinned.point_count().min(added_points.thinned.point_count());
    if found < FEWEST_POINTS {
        return Err(OverlapError::TooFewPoints { found, needed: FEWEST_POINTS });
    }
    let surface = placed_points.surface(progress)?;
    let noise_mm = libm::hypot(placed_points.noise_mm, added_points.noise_mm);
    let laying = Laying {
        surface: &surface,
        added: &added_points,
        signed: placed.normals.is_some() && added.normals.is_some(),
        diagonal_mm,
        within_mm: WITHIN_SIGMAS * noise_mm.max(FLOOR * diagonal_mm),
    };
    let (near, width) = match start {
        OverlapStart::Near(pose) => (*pose, GIVEN_WIDTH),
        OverlapStart::Anywhere => (laying.found(&placed_points, progress)?, FOUND_WIDTH),
    };
    let way = laying.laid(&near, WAY, width, progress)?;
    let fit = laying.laid(&way.model_from_scan, END, END_WIDTH, progress)?;
    let met = laying.met(&fit);
    if !met.is_overlap() {
        return Err(OverlapError::NoOverlap { overlap_share: met.overlap, agreeing_share: met.agreeing });
    }
    if let OverlapStart::Near(start) = start {
        laying.stayed_near(start, &fit.model_from_scan)?;
    }
    Ok(OverlapFit {
        common_from_scan: fit.model_from_scan,
        rms_mm: met.rms_mm,
        noise_mm,
        overlap_share: met.overlap,
        sliding: Held::of(&fit, met.rms_mm).sliding,
    })
}

/// A scan that is laid on a cloud.
struct Laying<'a> {
    surface: &'a CloudSurface<'a>,
    added: &'a Sampled,
    signed: bool,
    diagonal_mm: f64,
    within_mm: f64,
}

/// How much of a scan meets the other cloud.
#[derive(Clone, Copy)]
struct Met {
    overlap: f64,
    agreeing: f64,
    rms_mm: f64,
}

impl Met {
    fn is_overlap(&self) -> bool {
        self.overlap >= LEAST_OVERLAP && self.agreeing >= LEAST_AGREEING
    }
}

impl Laying<'_> {
    fn laid(
        &self,
        start: &Isometry3<f64>,
        (count, steps): (usize, usize),
        width: f64,
        progress: &Progress,
    ) -> Result<PlaneFit, Cancelled> {
        let first_width_mm = width * self.diagonal_mm;
        let (points, normals) = self.added.fewer(count);
        let on = self.surface.for_points(&normals, self.signed, first_width_mm);
        let schedule = Schedule { steps, first_width_mm, least_held: SLIDES_BELOW };
        plane_fit(&on, &points, &[], start, &schedule, progress)
    }

    fn met(&self, fit: &PlaneFit) -> Met {
        let partners = || fit.rows.iter().filter(|r| r.distance_mm.is_finite());
        let on = || partners().filter(|r| r.distance_mm < self.within_mm);
        let (count, squares) = on().fold((0usize, 0.0), |(n, s), r| (n + 1, s + r.off_mm * r.off_mm));
        let share = |all: usize| count as f64 / all.max(1) as f64;
        let rms_mm = (squares / count.max(1) as f64).sqrt();
        Met { overlap: share(fit.rows.len()), agreeing: share(partners().count()), rms_mm }
    }

    /// # Errors
    /// [`OverlapError::FarFromStart`].
    fn stayed_near(&self, start: &Isometry3<f64>, found: &Isometry3<f64>) -> Result<(), OverlapError> {
        let middle = self.apart().middle;
        let moved_mm = (found * middle - start * middle).norm();
        let turned_deg = start.rotation.angle_to(&found.rotation).to_degrees();
        // Of the scan's own skin: its box has outliers in it, and is none of a scan that lies askew.
        let axes = Skin::of_points(&self.added.thinned.middles).axes;
        let extent_mm = axes.iter().map(|a| a.norm_squared()).sum::<f64>().sqrt();
        let is_near = moved_mm <= MOST_MOVED * extent_mm && turned_deg <= MOST_TURNED_DEG;
        if is_near { Ok(()) } else { Err(OverlapError::FarFromStart { moved_mm, turned_deg }) }
    }

    /// The pose from anywhere that more of the scan agrees with than with any other.
    fn found(&self, placed: &Sampled, progress: &Progress) -> Result<Isometry3<f64>, OverlapError> {
        let mut tried = self.tried(placed, progress)?;
        tried.sort_by(|a, b| b.1.overlap.total_cmp(&a.1.overlap));
        let Some((best, met)) = tried.iter().find(|t| t.1.is_overlap()).or(tried.first()) else {
            return Err(OverlapError::NoOverlap { overlap_share: 0.0, agreeing_share: 0.0 });
        };
        if !met.is_overlap() {
            return Err(OverlapError::NoOverlap { overlap_share: met.overlap, agreeing_share: met.agreeing });
        }
        let held = Held::of(best, met.rms_mm);
        let slides = |fit: &PlaneFit| held.slides(&(fit.model_from_scan * best.model_from_scan.inverse()));
        let is_rival = |t: &&(PlaneFit, Met)| t.1.is_overlap() && t.1.overlap >= RIVAL * met.overlap && !slides(&t.0);
        let poses: Vec<Isometry3<f64>> = tried.iter().filter(is_rival).map(|t| t.0.model_from_scan).collect();
        let apart = self.apart();
        let others = apart.distinct(poses, |p| *p, usize::MAX);
        let is_best = |p: &Isometry3<f64>| !apart.are_others(p, &best.model_from_scan);
        if others.iter().all(is_best) {
            return Ok(best.model_from_scan);
        }
        let others = others.into_iter().filter(|p| !is_best(p));
        Err(OverlapError::Ambiguous { poses: std::iter::once(best.model_from_scan).chain(others).collect() })
    }

    /// Poses walked to from turns everywhere, each laid on the cloud.
    fn tried(&self, placed: &Sampled, progress: &Progress) -> Result<Vec<(PlaneFit, Met)>, Cancelled> {
        let on: &[Point3<f64>] = &placed.thinned.middles;
        let Some(first) = on.first() else { return Ok(Vec::new()) };
        let bounds = on.iter().fold((*first, *first), |(lo, hi), p| (lo.inf(p), hi.sup(p)));
        let thin = CloudSurface::new(on, &[], progress)?;
        let field = Field::new(bounds, |at, within| thin.closest(at, within), progress)?;
        let apart = self.apart();
        let walked = walked(&Skin::of_points(on), &field, &self.added.thinned, &apart, progress)?;
        let poses = apart.distinct(walked, |p| *p, MOST_TRIED);
        let one = |pose: &Isometry3<f64>| {
            let fit = self.laid(pose, TRIED, FOUND_WIDTH, progress)?;
            let met = self.met(&fit);
            Ok((fit, met))
        };
        poses.par_iter().map(one).collect()
    }

    fn apart(&self) -> Apart {
        let middles = &self.added.thinned.middles;
        let from = middles.first().copied().unwrap_or_else(Point3::origin);
        let sum = middles.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + (p - from));
        Apart { middle: from + sum / middles.len().max(1) as f64, diagonal_mm: self.diagonal_mm }
    }
}
