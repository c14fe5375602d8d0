//! What a saved job remembers of a part's surfaces, to find them again.

use super::cut_facets;
use super::file_frame::{FileFrame, LoadedAs};
use super::fingerprint::{Landmark, short};
use super::segmentation::{Segmentation, operands};
use super::shells::shells;
use crate::part::{Part, SurfaceEdit, SurfaceRule};
use crate::progress::{Cancelled, Progress};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// How many surfaces are remembered beside those needed, the largest first, and as many shells: they
/// tell whether the part as a whole is where it was.
const WITNESSES: usize = 64;

/// What is remembered of a part's surfaces, in the file's own coordinates.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Landmarks {
    /// Area of the part.
    pub(super) area: f64,
    /// Diagonal of the box around it.
    pub(super) diagonal: f64,
    /// Grid of [`cut_facets`].
    pub(super) grid: f64,
    /// The highest number before the first edit.
    pub(super) last_number: u32,
    /// Shells that were flipped.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) flipped_shells: Vec<u32>,
    /// The surfaces after all edits.
    pub(super) surfaces: Vec<Landmark>,
    /// The shells.
    pub(super) shells: Vec<Landmark>,
    /// The operands of each edit.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) edits: Vec<EditMark>,
}

/// The operands of one edit.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct EditMark {
    /// Its surfaces just before it; none: the edit was of surfaces that do not exist.
    pub operands: Vec<Landmark>,
    /// The facets of a cut, as [`cut_facets`] writes them.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub facets: String,
    /// The highest number once it was made: numbers above that of the edit before are its own.
    pub last_number: u32,
}

impl Landmarks {
    /// What is to be remembered of a part whose surfaces come of `rule` and `edits`. `needed` are the
    /// numbers of all surfaces that the job says anything of; those that do not exist are left out.
    pub fn new(
        part: &Part,
        loaded: &LoadedAs,
        rule: &SurfaceRule,
        edits: &[SurfaceEdit],
        needed: &BTreeSet<u32>,
    ) -> Landmarks {
        // Nobody else holds this progress, so it is not cancelled.
        Landmarks::made(part, loaded, rule, edits, needed, &Progress::default()).unwrap_or_default()
    }

    fn made(
        part: &Part,
        loaded: &LoadedAs,
        rule: &SurfaceRule,
        edits: &[SurfaceEdit],
        needed: &BTreeSet<u32>,
        progress: &Progress,
    ) -> Result<Landmarks, Cancelled> {
        let frame = FileFrame::new(loaded);
        let diagonal = frame.length(part.mesh.diagonal());
        let farthest = part.mesh.vertices.iter().map(|p| frame.point(p).coords.amax()).fold(0.0, f64::max);
        let grid = short(cut_facets::grid(diagonal, farthest));
        let mut now = Segmentation::new(part, loaded, rule, progress)?;
        let last_number = now.last_number();
        let edits = edits.iter().map(|edit| EditMark::new(&mut now, edit, grid)).collect::<Result<_, Cancelled>>()?;
        let mut numbers = needed.clone();
        numbers.extend(now.largest_first().into_iter().take(WITNESSES));
        Ok(Landmarks {
            area: short(frame.area(part.mesh.areas.iter().sum())),
            diagonal: short(diagonal),
            grid,
            last_number,
            flipped_shells: loaded.flipped_shells.to_vec(),
            surfaces: numbers.into_iter().filter_map(|n| now.landmark(n)).collect(),
            shells: remembered_shells(part, loaded, progress)?,
            edits,
        })
    }

    /// Numbers of the surfaces that are remembered.
    pub fn numbers(&self) -> impl Iterator<Item = u32> {
        self.surfaces.iter().map(|l| l.number)
    }

    /// The numbers that edit `index` gave out.
    pub(super) fn numbers_given_by(&self, index: usize) -> RangeInclusive<u32> {
        let before = index.checked_sub(1).and_then(|i| self.edits.get(i)).map_or(self.last_number, |e| e.last_number);
        before.saturating_add(1)..=self.edits.get(index).map_or(0, |e| e.last_number)
    }
}

impl EditMark {
    /// Remembers what the edit is made on, and makes it.
    fn new(now: &mut Segmentation, edit: &SurfaceEdit, grid: f64) -> Result<EditMark, Cancelled> {
        let numbers: BTreeSet<u32> = operands(edit).iter().copied().collect();
        let operands = numbers.into_iter().filter_map(|n| now.landmark(n)).collect();
        let facets = match edit {
            SurfaceEdit::Cut { cut, facets } => {
                let listed: BTreeSet<u32> = facets.iter().copied().collect();
                let own: Vec<u32> = now.facets(*cut).iter().copied().filter(|f| listed.contains(f)).collect();
                cut_facets::hash_facets(now, &own, grid)
            }
            _ => String::new(),
        };
        now.apply(edit)?;
        Ok(EditMark { operands, facets, last_number: now.last_number() })
    }
}

/// The flipped ones and the largest.
fn remembered_shells(part: &Part, loaded: &LoadedAs, progress: &Progress) -> Result<Vec<Landmark>, Cancelled> {
    let mut all = shells(part, loaded, progress)?;
    let is_flipped = |l: &Landmark| loaded.flipped_shells.contains(&l.number);
    all.sort_by(|a, b| {
        is_flipped(b).cmp(&is_flipped(a)).then(b.print.area.total_cmp(&a.print.area)).then(a.number.cmp(&b.number))
    });
    let count = all.iter().filter(|l| is_flipped(l)).count() + WITNESSES;
    all.truncate(count);
    all.sort_by_key(|l| l.number);
    Ok(all)
}
