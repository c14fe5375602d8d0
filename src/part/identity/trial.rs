//! One assumed motion tried out: edits repeated, surfaces and shells paired.

use super::cut_facets;
use super::file_frame::LoadedAs;
use super::fingerprint::Landmark;
use super::landmarks::{EditMark, Landmarks};
use super::pairing::{Lineup, LostReason, Paired, paired};
use super::segmentation::{Segmentation, operands};
use crate::part::SurfaceEdit;
use crate::progress::{Cancelled, Progress};
use nalgebra::Similarity3;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

/// An edit that could not be repeated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LostEdit {
    /// Its place in the list, from 0.
    pub index: usize,
    /// Why.
    pub why: LostReason,
}

/// What is sought, and where.
pub(super) struct SurfaceSearch<'a> {
    pub landmarks: &'a Landmarks,
    pub loaded: LoadedAs<'a>,
    /// The new part before the first edit.
    pub base: Segmentation<'a>,
    /// Its shells.
    pub shells: Lineup,
    pub edits: &'a [SurfaceEdit],
    pub needed: &'a BTreeSet<u32>,
    pub progress: &'a Progress,
}

/// The result of one assumed motion.
#[derive(Clone, Debug)]
pub(super) struct Trial {
    pub new_from_old: Similarity3<f64>,
    pub surfaces: Paired,
    pub shells: Paired,
    /// In the new numbers.
    pub edits: Vec<SurfaceEdit>,
    pub lost_edits: Vec<LostEdit>,
    /// Whether everything needed was found.
    pub complete: bool,
    /// How many remembered surfaces were not.
    pub missed: usize,
}

/// Old numbers used or given out by edits that could not be repeated.
#[derive(Default)]
struct LostNumbers(Vec<RangeInclusive<u32>>);

impl LostNumbers {
    fn contains(&self, number: u32) -> bool {
        self.0.iter().any(|range| range.contains(&number))
    }
}

impl SurfaceSearch<'_> {
    /// Tries a motion of the file.
    ///
    /// # Errors
    /// [`Cancelled`] when the search should end.
    pub(super) fn trial(&self, new_from_old: &Similarity3<f64>) -> Result<Trial, Cancelled> {
        let moved = |l: &Landmark| Landmark { number: l.number, print: l.print.moved(new_from_old) };
        let diagonal = self.landmarks.diagonal * new_from_old.scaling();
        let mut now = self.base.clone();
        let (mut edits, mut lost_edits, mut lost_numbers) = (Vec::new(), Vec::new(), LostNumbers::default());
        for (index, edit) in self.edits.iter().enumerate() {
            self.progress.check()?;
            match self.repeated(&mut now, index, &lost_numbers, new_from_old)? {
                Ok(None) => {}
                Ok(Some(edit)) => {
                    now.apply(&edit)?;
                    edits.push(edit);
                }
                Err(why) => {
                    lost_edits.push(LostEdit { index, why });
                    lost_numbers.0.extend(operands(edit).iter().map(|&n| n..=n));
                    lost_numbers.0.push(self.landmarks.numbers_given_by(index));
                }
            }
        }
        let mut surfaces = paired(self.landmarks.surfaces.iter().map(moved), &Lineup::new(now.landmarks()?), diagonal);
        let asked = self.landmarks.surfaces.iter().map(|l| l.number).chain(self.needed.iter().copied());
        for number in asked.filter(|n| lost_numbers.contains(*n)) {
            surfaces.numbers.remove(&number);
            surfaces.lost.insert(number, LostReason::EditNotRepeated);
        }
        let shells = paired(self.landmarks.shells.iter().map(moved), &self.shells, diagonal);
        let gone = |l: &&Landmark| {
            matches!(surfaces.lost.get(&l.number), Some(LostReason::NothingAlike | LostReason::EditNotRepeated))
        };
        Ok(Trial {
            new_from_old: *new_from_old,
            complete: lost_edits.is_empty()
                && self.needed.iter().all(|n| surfaces.numbers.contains_key(n))
                && self.landmarks.flipped_shells.iter().all(|n| shells.numbers.contains_key(n)),
            missed: self.landmarks.surfaces.iter().filter(gone).count(),
            surfaces,
            shells,
            edits,
            lost_edits,
        })
    }

    /// An edit in the new numbers; `None` if its surfaces never existed.
    fn repeated(
        &self,
        now: &mut Segmentation,
        index: usize,
        lost_numbers: &LostNumbers,
        new_from_old: &Similarity3<f64>,
    ) -> Result<Result<Option<SurfaceEdit>, LostReason>, Cancelled> {
        let edit = &self.edits[index];
        let Some(mark) = self.landmarks.edits.get(index) else { return Ok(Err(LostReason::NotRemembered)) };
        if mark.operands.is_empty() {
            return Ok(Ok(None));
        }
        if mark.operands.iter().any(|o| !operands(edit).contains(&o.number)) {
            return Ok(Err(LostReason::NotRemembered));
        }
        if mark.operands.iter().any(|o| lost_numbers.contains(o.number)) {
            return Ok(Err(LostReason::EditNotRepeated));
        }
        let numbers = match self.operands_now(now, mark, new_from_old)? {
            Ok(numbers) => numbers,
            Err(why) => return Ok(Err(why)),
        };
        let number = |old: &u32| numbers.get(old).copied();
        Ok(Ok(match edit {
            SurfaceEdit::Merge { merge } => {
                Some(SurfaceEdit::Merge { merge: merge.iter().filter_map(number).collect() })
            }
            SurfaceEdit::Split { split, angle_deg } => {
                number(split).map(|split| SurfaceEdit::Split { split, angle_deg: *angle_deg })
            }
            SurfaceEdit::Cut { cut, .. } => match number(cut) {
                Some(cut) => {
                    let facets = cut_facets::find_facets(now, cut, &mark.facets, self.landmarks.grid, new_from_old);
                    let Some(facets) = facets else { return Ok(Err(LostReason::OtherFacets)) };
                    Some(SurfaceEdit::Cut { cut, facets })
                }
                None => None,
            },
        }))
    }

    /// The new numbers of all operands, or why one has none.
    fn operands_now(
        &self,
        now: &mut Segmentation,
        mark: &EditMark,
        new_from_old: &Similarity3<f64>,
    ) -> Result<Result<BTreeMap<u32, u32>, LostReason>, Cancelled> {
        let moved = mark.operands.iter().map(|l| Landmark { number: l.number, print: l.print.moved(new_from_old) });
        let diagonal = self.landmarks.diagonal * new_from_old.scaling();
        let Paired { numbers, lost } = paired(moved, &Lineup::new(now.landmarks()?), diagonal);
        Ok(lost.values().next().map_or(Ok(numbers), |why| Err(*why)))
    }
}
