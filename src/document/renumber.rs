//! What becomes of the settings of surfaces whose numbers or facets change: one renumbering for merges, splits and
//! cuts, another crease angle, and another part.
//!
//! Where more than one old surface goes into a new one, each property is what most of its area had; in a merge the
//! number that is kept keeps its own.

use super::model::Job;
use super::settings::{Settings, SurfaceSettings};
use crate::part::{SurfaceId, Surfaces};
use std::collections::BTreeMap;

/// What becomes of surfaces: old number → new ones.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Renumbering {
    heirs: BTreeMap<SurfaceId, Vec<(SurfaceId, Inherits)>>,
    /// Whether surfaces that are not named stay what they are; else they are gone.
    others_stay: bool,
}

/// What a new surface takes over from an old one.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Inherits {
    /// All: it has the same facets.
    All,
    /// As much as this share of its area was the old one's, 0 to 1; never pins and border, which mean nothing on
    /// other facets.
    Share(f64),
    /// It was merged into one that kept its number: its place in the order of work, the sides that it forbids, and
    /// its name where that one has none.
    Joined,
    /// It was cut off: recipe, tilt rule and side.
    Cut,
}

/// What a surface lost because its facets are others now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LostSettings {
    /// The surface, as it was called.
    pub surface: SurfaceId,
    /// Tilts that were pinned on its lines.
    pub pins: usize,
    /// Whether it had a border of its own to start from.
    pub border: bool,
}

impl Renumbering {
    /// Surfaces become one under the lowest of their numbers; all of them exist. One alone stays what it is.
    pub fn merged(surfaces: &[SurfaceId]) -> Renumbering {
        let inherits =
            |id: &SurfaceId, keep: &SurfaceId| if id == keep { Inherits::Share(1.0) } else { Inherits::Joined };
        let heirs = match surfaces.iter().min() {
            Some(keep) if surfaces.iter().any(|id| id != keep) => {
                surfaces.iter().map(|id| (*id, vec![(*keep, inherits(id, keep))])).collect()
            }
            _ => BTreeMap::new(),
        };
        Renumbering { heirs, others_stay: true }
    }

    /// Pieces are cut off surfaces, which keep their numbers: surface and piece.
    pub fn cut_off(pieces: impl IntoIterator<Item = (SurfaceId, SurfaceId)>) -> Renumbering {
        let mut heirs: BTreeMap<SurfaceId, Vec<(SurfaceId, Inherits)>> = BTreeMap::new();
        for (of, piece) in pieces {
            heirs.entry(of).or_insert_with(|| vec![(of, Inherits::Share(1.0))]).push((piece, Inherits::Cut));
        }
        Renumbering { heirs, others_stay: true }
    }

    /// The facets of a part are cut into other surfaces: each takes over what most of its area was. Numbers that were no
    /// surface's are gone. `areas_mm2` are those of the facets.
    pub fn by_area(areas_mm2: &[f64], before: &Surfaces, after: &Surfaces) -> Renumbering {
        let mut heirs: BTreeMap<SurfaceId, Vec<(SurfaceId, Inherits)>> =
            before.ids().map(|id| (id, Vec::new())).collect();
        for surface in &after.list {
            let mut was_mm2: BTreeMap<u32, f64> = BTreeMap::new();
            for facet in surface.facets.iter().map(|f| *f as usize) {
                if let (Some(old), Some(mm2)) = (before.of_facet.get(facet), areas_mm2.get(facet)) {
                    *was_mm2.entry(*old).or_default() += mm2;
                }
            }
            for (old, mm2) in was_mm2 {
                let is_same = before.get(old).is_some_and(|b| b.facets == surface.facets);
                let inherits = if is_same { Inherits::All } else { Inherits::Share(mm2 / surface.area_mm2) };
                heirs.entry(SurfaceId(old)).or_default().push((SurfaceId(surface.number), inherits));
            }
        }
        Renumbering { heirs, others_stay: false }
    }

    /// Surfaces of a part whose file has changed: old number → new one. Those that are not named are gone.
    pub fn found(numbers: &BTreeMap<SurfaceId, SurfaceId>) -> Renumbering {
        let heirs = numbers.iter().map(|(old, new)| (*old, vec![(*new, Inherits::All)])).collect();
        Renumbering { heirs, others_stay: false }
    }

    /// The settings under the new numbers, and what was lost.
    fn carry_over(&self, settings: &Settings) -> (Settings, Vec<LostSettings>) {
        let mut parents: BTreeMap<SurfaceId, Vec<(&SurfaceSettings, Inherits)>> = BTreeMap::new();
        for (old, heirs) in &self.heirs {
            for (new, inherits) in heirs {
                parents.entry(*new).or_default().push((settings.of(*old), *inherits));
            }
        }
        let mut lost = Vec::new();
        for (old, before) in settings.iter() {
            match self.heirs.get(&old) {
                // A number that was no surface's does not go before the piece that gets it.
                None if self.others_stay && !parents.contains_key(&old) => {
                    parents.entry(old).or_default().push((before, Inherits::All))
                }
                heirs => {
                    let stays = heirs.is_some_and(|h| h.iter().any(|(_, inherits)| *inherits == Inherits::All));
                    if !stays && (before.border.is_some() || !before.pins.is_empty()) {
                        lost.push(LostSettings {
                            surface: old,
                            pins: before.pins.len(),
                            border: before.border.is_some(),
                        });
                    }
                }
            }
        }
        let of = parents.into_iter().map(|(new, parents)| (new, merged_settings(&parents))).collect();
        (Settings::new(settings.cleans_all(), of), lost)
    }
}

impl Job {
    /// Carries what is said of surfaces over to their new numbers, and tells what was lost.
    pub fn renumber(&mut self, map: &Renumbering) -> Vec<LostSettings> {
        let (settings, lost) = map.carry_over(&self.settings);
        self.settings = settings;
        lost
    }
}

/// What a surface has from those that went into it, in the order of their numbers.
fn merged_settings(parents: &[(&SurfaceSettings, Inherits)]) -> SurfaceSettings {
    if let Some((parent, _)) = parents.iter().find(|(_, inherits)| *inherits == Inherits::All) {
        return (*parent).clone();
    }
    if let Some((parent, _)) = parents.iter().find(|(_, inherits)| *inherits == Inherits::Cut) {
        let (recipe, tilt) = (parent.recipe.clone(), parent.tilt.clone());
        return SurfaceSettings { recipe, tilt, flipped: parent.flipped, ..SurfaceSettings::default() };
    }
    let mut merged = by_majority(parents);
    for (joined, _) in parents.iter().filter(|(_, inherits)| *inherits == Inherits::Joined) {
        if merged.name.is_empty() {
            merged.name.clone_from(&joined.name);
        }
        merged.later = false;
        merged.work = merged.work.into_iter().chain(joined.work).min();
        merged.tilt.forbidden.extend(&joined.tilt.forbidden);
        merged.tilt.forbidden.sort_unstable();
        merged.tilt.forbidden.dedup();
    }
    merged
}

/// What surfaces of more than half the area had, property by property; else the default.
fn by_majority(parents: &[(&SurfaceSettings, Inherits)]) -> SurfaceSettings {
    fn most<T: PartialEq + Clone + Default>(
        parents: &[(&SurfaceSettings, Inherits)],
        get: impl Fn(&SurfaceSettings) -> T,
    ) -> T {
        let share_of = |value: &T| -> f64 {
            let share = |(s, inherits): &(&SurfaceSettings, Inherits)| match inherits {
                Inherits::Share(share) if get(s) == *value => *share,
                _ => 0.0,
            };
            parents.iter().map(share).sum()
        };
        parents.iter().map(|(s, _)| get(s)).find(|value| share_of(value) > 0.5).unwrap_or_default()
    }
    let shares = parents.iter().filter(|(_, inherits)| matches!(inherits, Inherits::Share(_)));
    let first = shares.filter_map(|(s, _)| s.work).min();
    SurfaceSettings {
        name: most(parents, |s| s.name.clone()),
        recipe: most(parents, |s| s.recipe.clone()),
        work: first.filter(|_| most(parents, |s| s.work.is_some())),
        later: most(parents, |s| s.later),
        flipped: most(parents, |s| s.flipped),
        tilt: most(parents, |s| s.tilt.clone()),
        centre_mm: most(parents, |s| s.centre_mm),
        pins: Vec::new(),
        border: None,
    }
}
