//! What merges, splits and cuts of surfaces do to a job. The edits that ask for them are made in `cutting`.

use super::model::Job;
use super::renumber::{LostSettings, Renumbering};
use crate::part::{SurfaceEdit, SurfaceId};

/// Facets that are cut off a surface.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cut {
    /// The surface.
    pub of: SurfaceId,
    /// Some of its facets, not all.
    pub facets: Vec<u32>,
    /// The surface that they become.
    pub piece: SurfaceId,
}

impl Job {
    /// Merges surfaces, those of them that are among `all` that exist.
    pub(super) fn merge(&mut self, list: &[SurfaceId], all: &[SurfaceId]) -> Vec<LostSettings> {
        self.surfaces.edits.push(SurfaceEdit::Merge { merge: list.iter().map(|id| id.0).collect() });
        let there: Vec<SurfaceId> = all.iter().copied().filter(|id| list.contains(id)).collect();
        self.renumber(&Renumbering::merged(&there))
    }

    /// Splits a surface; `made` are the pieces that are cut off it.
    pub(super) fn split(&mut self, surface: SurfaceId, angle_deg: f64, made: &[SurfaceId]) -> Vec<LostSettings> {
        self.surfaces.edits.push(SurfaceEdit::Split { split: surface.0, angle_deg });
        self.renumber(&Renumbering::cut_off(made.iter().map(|piece| (surface, *piece))))
    }

    /// Cuts facets off surfaces.
    pub(super) fn cut(&mut self, cuts: &[Cut]) -> Vec<LostSettings> {
        let edit = |c: &Cut| SurfaceEdit::Cut { cut: c.of.0, facets: c.facets.clone() };
        self.surfaces.edits.extend(cuts.iter().map(edit));
        self.renumber(&Renumbering::cut_off(cuts.iter().map(|c| (c.of, c.piece))))
    }

    /// Puts surfaces aside, after the cuts that make them surfaces of their own.
    pub(super) fn put_aside(&mut self, cuts: &[Cut], surfaces: &[SurfaceId]) -> Vec<LostSettings> {
        let lost = self.cut(cuts);
        self.settings.change_each(surfaces, |s| s.later = true);
        lost
    }
}
