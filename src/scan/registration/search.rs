//! From a start to poses that have arrived, the best of them first, and which of the others are rivals.

use super::super::Cloud;
use super::coarse::{Apart, candidates};
use super::fine::{Fine, way};
use super::noise::noise_mm;
use super::options::Start;
use super::outcome::RegistrationError;
use super::pairs::start_of;
use super::plane_fit::{PlaneFit, capped_rms_mm};
use super::rivals::{Alike, Rival, telling_patch};
use super::surface::Model;
use super::thinned::Thinned;
use crate::progress::{Cancelled, Progress};
use crate::scan::TUKEY;
use nalgebra::Vector3;

/// Voxels along the model's diagonal: of 2 mm on a shaft of 150 mm, 5 000 to 10 000 of them on a part.
const VOXELS: f64 = 75.0;
/// Fewest points: with fewer the median of what a voxel has says nothing.
const FEWEST_POINTS: usize = 100;
/// How far off a start may be, and how far what was found coarsely is, as shares of the diagonal.
const GIVEN_WIDTH: f64 = 1.0 / 20.0;
const FOUND_WIDTH: f64 = 1.0 / 60.0;
/// Up to this share of the diagonal a point's distance counts between poses that have arrived.
const SCORE_CAP: f64 = 1.0 / 180.0;
/// Coarse scores up to so many times the best go on: distances count up to D/180 in them, and a hundredth of the points so
/// far off, no more than a rival may have, doubles the score.
const GOES_ON: f64 = 4.0;
/// A score below this many times the best is a rival's. With distances cut off at 4.685 σ 2 % of the points decide
/// between them: a worn lobe is as many.
const RIVAL: f64 = 1.2;
/// What scores are told apart by at the least, as a share of the diagonal: data without noise.
const SCORE_FLOOR: f64 = 1e-5;

/// The strip along creases that does not count is no wider than this share of a voxel: a sparse cloud's noise is said too
/// large, and a shaft's shoulders are only a voxel wide.
const MOST_CREASE: f64 = 0.25;

/// A scan that is looked for on a model.
#[derive(Clone)]
pub(super) struct Search<'a> {
    pub(super) model: Model<'a>,
    cloud: &'a Cloud,
    pub(super) thinned: Thinned,
    /// Of the scan by itself, as a standard deviation.
    pub(super) noise_mm: f64,
    apart: Apart,
}

impl<'a> Search<'a> {
    /// Thins the scan, and looks how noisy it is.
    ///
    /// # Errors
    /// [`RegistrationError::TooFewPoints`], [`RegistrationError::Cancelled`].
    pub(super) fn new(
        mut model: Model<'a>,
        cloud: &'a Cloud,
        left_out: &[bool],
        progress: &Progress,
    ) -> Result<Search<'a>, RegistrationError> {
        let diagonal_mm = model.part.mesh.diagonal();
        let thinned = Thinned::new(cloud, left_out, diagonal_mm / VOXELS, progress)?;
        let found = thinned.point_count();
        if found < FEWEST_POINTS {
            return Err(RegistrationError::TooFewPoints { found, needed: FEWEST_POINTS });
        }
        let sum = thinned.middles.iter().fold(Vector3::zeros(), |s: Vector3<f64>, p| s + (p - cloud.origin));
        let middle = cloud.origin + sum / thinned.middles.len() as f64;
        let noise_mm = noise_mm(cloud, &thinned);
        progress.check()?;
        model.crease_mm = (TUKEY * noise_mm).min(MOST_CREASE * thinned.cell_mm);
        Ok(Search { model, cloud, thinned, noise_mm, apart: Apart { middle, diagonal_mm } })
    }

    /// The best pose, and others that may be as good.
    ///
    /// # Errors
    /// [`RegistrationError::PairsTellNoMotion`], [`RegistrationError::NoModel`], [`RegistrationError::Cancelled`].
    pub(super) fn ways(
        &self,
        start: &Start,
        progress: &Progress,
    ) -> Result<(PlaneFit, Vec<PlaneFit>), RegistrationError> {
        let (starts, width) = match start {
            Start::From(pose) => (vec![*pose], GIVEN_WIDTH),
            Start::Pairs(pairs) => (vec![start_of(pairs)?], GIVEN_WIDTH),
            Start::Anywhere => {
                let mut found = candidates(&self.model, self.cloud, &self.thinned, &self.apart, progress)?;
                let limit_mm = self.limit_mm(found.first().map_or(0.0, |c| c.score_mm), GOES_ON);
                found.retain(|c| c.score_mm <= limit_mm);
                (found.into_iter().map(|c| c.model_from_scan).collect(), FOUND_WIDTH)
            }
        };
        let width_mm = width * self.apart.diagonal_mm;
        let arrived = |start| way(&self.model, self.cloud, &self.thinned, start, width_mm, progress);
        let mut ways = starts.iter().map(arrived).collect::<Result<Vec<PlaneFit>, Cancelled>>()?;
        let score = |w: &PlaneFit| capped_rms_mm(&w.rows, SCORE_CAP * self.apart.diagonal_mm);
        ways.sort_by(|a, b| score(a).total_cmp(&score(b)));
        let mut ways = self.apart.distinct(ways, |w| w.model_from_scan, usize::MAX).into_iter();
        // A start always arrives somewhere; none is found only where there is nothing to lie on.
        ways.next().map(|best| (best, ways.collect())).ok_or(RegistrationError::NoModel)
    }

    /// Which of the others fit nearly as well as the best. What only slid is none.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub(super) fn rivals(
        &self,
        fine: &Fine,
        best: &PlaneFit,
        others: &[PlaneFit],
        alike: &Alike<'_>,
        progress: &Progress,
    ) -> Result<Vec<Rival>, Cancelled> {
        let part = self.model.part;
        let pose = fine.fit.model_from_scan;
        let limit_mm = self.limit_mm(capped_rms_mm(&best.rows, alike.cap_mm), RIVAL);
        let mut rivals = Vec::new();
        for other in others {
            let rms_mm = capped_rms_mm(&other.rows, alike.cap_mm);
            let between = other.model_from_scan * pose.inverse();
            if rms_mm > limit_mm || alike.held.slides(&between) {
                continue;
            }
            let same_by_symmetry = alike.is_symmetry(part, &between);
            let telling = if same_by_symmetry {
                None
            } else {
                telling_patch(part, &self.thinned, &pose, &other.model_from_scan, progress)?
            };
            rivals.push(Rival { model_from_scan: other.model_from_scan, rms_mm, same_by_symmetry, telling });
        }
        rivals.sort_by(|a, b| a.rms_mm.total_cmp(&b.rms_mm));
        Ok(rivals)
    }

    fn limit_mm(&self, best_mm: f64, times: f64) -> f64 {
        times * best_mm + SCORE_FLOOR * self.apart.diagonal_mm
    }
}
