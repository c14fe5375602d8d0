//! Finds what [`Landmarks`] remember: in place, else after one common shift, else after one turn.

use super::file_frame::{FileFrame, LoadedAs};
use super::file_motion::{Surround, shifts, turns};
use super::landmarks::Landmarks;
use super::pairing::{Lineup, LostReason, Paired};
use super::segmentation::Segmentation;
use super::shells::shells;
use super::trial::{LostEdit, SurfaceSearch, Trial};
use crate::part::{Part, SurfaceEdit, SurfaceRule};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Isometry3, Similarity3};
use std::collections::{BTreeMap, BTreeSet};

/// Motions are the same if they differ by less than this share of the part and bring the same surfaces
/// onto each other: fits to other surfaces differ by some thousandths, turns about a symmetry by tenths.
const SAME_MOTION: f64 = 0.02;

/// Ratios of millimetres, centimetres, metres and inches.
const UNIT_RATIOS: [f64; 10] = [25.4, 1.0 / 25.4, 10.0, 0.1, 100.0, 0.01, 1000.0, 0.001, 1000.0 / 25.4, 25.4 / 1000.0];

/// A surface or a shell that was not found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LostLandmark {
    /// Its old number.
    pub number: u32,
    /// Why.
    pub why: LostReason,
}

/// What was found again.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundAgain {
    /// New numbers of surfaces by their old ones: those needed, and others that were remembered.
    pub numbers: BTreeMap<u32, u32>,
    /// The edits in the new numbers, without those that were lost.
    pub edits: Vec<SurfaceEdit>,
    /// New numbers of shells by their old ones.
    pub shells: BTreeMap<u32, u32>,
    /// The surfaces needed that were not found.
    pub lost: Vec<LostLandmark>,
    /// The edits that could not be repeated.
    pub lost_edits: Vec<LostEdit>,
    /// The flipped shells that were not found.
    pub lost_shells: Vec<LostLandmark>,
    /// The one motion of the file, in its coordinates, that brings everything to its place. `None`: found in place.
    pub motion: Option<Isometry3<f64>>,
    /// Everything is there, but larger by this factor; then nothing counts as found.
    pub scale: Option<f64>,
}

impl FoundAgain {
    /// Whether nothing was lost.
    pub fn is_complete(&self) -> bool {
        self.lost.is_empty() && self.lost_edits.is_empty() && self.lost_shells.is_empty()
    }
}

/// Looks for remembered surfaces in a new part. `edits` are those that the landmarks were made with,
/// `needed` the old numbers that must be found; `loaded` is how the *new* part was read.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn find(
    landmarks: &Landmarks,
    part: &Part,
    loaded: &LoadedAs,
    rule: &SurfaceRule,
    (edits, needed): (&[SurfaceEdit], &BTreeSet<u32>),
    progress: &Progress,
) -> Result<FoundAgain, Cancelled> {
    let mut base = Segmentation::new(part, loaded, rule, progress)?;
    let new = Lineup::new(base.landmarks()?);
    let shells = Lineup::new(shells(part, loaded, progress)?);
    let search = SurfaceSearch { landmarks, loaded: *loaded, base, shells, edits, needed, progress };
    let in_place = search.trial(&Similarity3::identity())?;
    if in_place.complete && search.is_borne_out(&in_place) {
        return Ok(search.found_again(in_place, None));
    }
    let mut outcome = search.best_of(&shifts(landmarks, &new, progress)?, &in_place)?;
    if let BestMotion::None { missed } = outcome {
        outcome = match search.best_of(&turns(landmarks, &new, progress)?, &in_place)? {
            BestMotion::None { missed: turned } => BestMotion::None { missed: missed.min(turned) },
            told => told,
        };
    }
    match outcome {
        BestMotion::One(trial) => {
            let motion = trial.new_from_old.isometry;
            return Ok(search.found_again(*trial, Some(motion)));
        }
        BestMotion::Several => return Ok(search.nothing_found(LostReason::SeveralMotions)),
        // What was found in place may be another hole of a row, the file having moved by one pitch.
        BestMotion::None { missed } if !search.is_borne_out(&in_place) && clearly_fewer(missed, in_place.missed) => {
            return Ok(search.nothing_found(LostReason::PartMoved));
        }
        BestMotion::None { .. } => {}
    }
    Ok(match search.scale(part)?.filter(|_| !in_place.complete) {
        Some(scale) => FoundAgain { scale: Some(scale), ..search.nothing_found(LostReason::NothingAlike) },
        None => search.found_again(in_place, None),
    })
}

/// The best of several assumed motions.
enum BestMotion {
    /// One brings everything needed to its place.
    One(Box<Trial>),
    /// Several do, equally well.
    Several,
    /// None does; the best of them missed this many surfaces.
    None { missed: usize },
}

/// Whether so few are missed that one motion is right and another wrong: less than half as many. Sometimes a single
/// surface is all that distinguishes the two ends of a part.
fn clearly_fewer(missed: usize, other: usize) -> bool {
    2 * missed < other
}

impl SurfaceSearch<'_> {
    /// Whether at least half of all that is remembered is there.
    fn is_borne_out(&self, trial: &Trial) -> bool {
        2 * trial.missed <= self.landmarks.surfaces.len()
    }

    /// The motion that explains what is not found in place.
    fn best_of(&self, motions: &[Isometry3<f64>], in_place: &Trial) -> Result<BestMotion, Cancelled> {
        let of = |m: &Isometry3<f64>| Similarity3::from_isometry(*m, 1.0);
        let trials = motions.iter().map(|m| self.trial(&of(m))).collect::<Result<Vec<Trial>, Cancelled>>()?;
        let missed = trials.iter().map(|t| t.missed).min().unwrap_or(self.landmarks.surfaces.len());
        let counts = |t: &Trial| t.complete && self.is_borne_out(t) && clearly_fewer(t.missed, in_place.missed);
        let mut good: Vec<Trial> = trials.into_iter().filter(counts).collect();
        good.sort_by_key(|t| t.missed);
        let Some((best, others)) = good.split_first() else { return Ok(BestMotion::None { missed }) };
        let surround = Surround::new(self.landmarks);
        let as_good = |t: &Trial| {
            let apart = surround.apart(&best.new_from_old.isometry, &t.new_from_old.isometry);
            let other = apart > SAME_MOTION * self.landmarks.diagonal || t.surfaces.numbers != best.surfaces.numbers;
            other && !clearly_fewer(best.missed, t.missed)
        };
        let is_one = !others.iter().any(as_good);
        Ok(if is_one { BestMotion::One(Box::new(best.clone())) } else { BestMotion::Several })
    }

    /// The scale about the file's origin, if it explains everything.
    fn scale(&self, part: &Part) -> Result<Option<f64>, Cancelled> {
        let area = FileFrame::new(&self.loaded).area(part.mesh.areas.iter().sum());
        let ratio = (area / self.landmarks.area).sqrt();
        // Tessellation changes the area by a per cent: what is meant is the ratio of two units.
        let scale = UNIT_RATIOS.into_iter().find(|r| (ratio / r - 1.0).abs() < 0.01).unwrap_or(ratio);
        if !(1e-6..1e6).contains(&scale) || (scale - 1.0).abs() < 0.02 {
            return Ok(None);
        }
        let trial = self.trial(&Similarity3::from_scaling(scale))?;
        Ok((trial.complete && self.is_borne_out(&trial)).then_some(scale))
    }

    fn found_again(&self, trial: Trial, motion: Option<Isometry3<f64>>) -> FoundAgain {
        let lost = |numbers: &mut dyn Iterator<Item = u32>, of: &Paired| -> Vec<LostLandmark> {
            numbers
                .filter(|n| !of.numbers.contains_key(n))
                .map(|number| LostLandmark {
                    number,
                    why: of.lost.get(&number).copied().unwrap_or(LostReason::NotRemembered),
                })
                .collect()
        };
        FoundAgain {
            lost: lost(&mut self.needed.iter().copied(), &trial.surfaces),
            lost_shells: lost(&mut self.landmarks.flipped_shells.iter().copied(), &trial.shells),
            numbers: trial.surfaces.numbers,
            edits: trial.edits,
            shells: trial.shells.numbers,
            lost_edits: trial.lost_edits,
            motion,
            scale: None,
        }
    }

    /// The result where everything is lost, for one reason.
    fn nothing_found(&self, why: LostReason) -> FoundAgain {
        let lost =
            |numbers: &mut dyn Iterator<Item = u32>| numbers.map(|number| LostLandmark { number, why }).collect();
        FoundAgain {
            numbers: BTreeMap::new(),
            edits: Vec::new(),
            shells: BTreeMap::new(),
            lost: lost(&mut self.needed.iter().copied()),
            lost_edits: (0..self.edits.len()).map(|index| LostEdit { index, why }).collect(),
            lost_shells: lost(&mut self.landmarks.flipped_shells.iter().copied()),
            motion: None,
            scale: None,
        }
    }
}
