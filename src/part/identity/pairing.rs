//! Gives each remembered surface the one new surface that it must be, or none.

use super::alike::{clearly_nearer, reach, unlikeness_in_place};
use super::fingerprint::{Fingerprint, Landmark};
use std::collections::BTreeMap;

/// Why a surface, a shell or an edit is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LostReason {
    /// Nothing like it is there.
    NothingAlike,
    /// Several are so much alike that none can be told apart.
    SeveralAlike,
    /// It results from an edit that could not be repeated.
    EditNotRepeated,
    /// It was cut out facet by facet, and the facets are others now.
    OtherFacets,
    /// Nothing was remembered of it.
    NotRemembered,
    /// The part has moved as a whole, and fits itself in several ways.
    SeveralMotions,
    /// The part has moved as a whole, and not everything needed is found at its new place.
    PartMoved,
}

/// New surfaces, sorted along the axis on which they are spread most.
pub(super) struct Lineup {
    axis: usize,
    sorted: Vec<Landmark>,
}

/// The result of pairing old surfaces with new ones.
#[derive(Clone, Debug, Default)]
pub(super) struct Paired {
    /// New numbers by old ones.
    pub numbers: BTreeMap<u32, u32>,
    /// The others.
    pub lost: BTreeMap<u32, LostReason>,
}

impl Lineup {
    pub(super) fn new(mut surfaces: Vec<Landmark>) -> Lineup {
        let extent = |k: usize| {
            let at = |l: &Landmark| l.print.centroid[k];
            let (lo, hi) = surfaces.iter().fold((f64::MAX, f64::MIN), |(lo, hi), l| (lo.min(at(l)), hi.max(at(l))));
            hi - lo
        };
        let axis = (1..3).fold(0, |best, k| if extent(k) > extent(best) { k } else { best });
        surfaces
            .sort_by(|a, b| a.print.centroid[axis].total_cmp(&b.print.centroid[axis]).then(a.number.cmp(&b.number)));
        Lineup { axis, sorted: surfaces }
    }

    /// All of them.
    pub(super) fn all(&self) -> &[Landmark] {
        &self.sorted
    }

    /// Whether any may be this one.
    pub(super) fn holds(&self, old: &Fingerprint, diagonal: f64) -> bool {
        !self.candidates(old, diagonal).is_empty()
    }

    /// Those that may be this one, the nearest first.
    fn candidates(&self, old: &Fingerprint, diagonal: f64) -> Vec<(f64, u32)> {
        // The new one may be larger by the tolerance of areas, and its reach with it.
        let (at, reach) = (old.centroid[self.axis], 1.2 * reach(old, diagonal));
        let first = self.sorted.partition_point(|l| l.print.centroid[self.axis] < at - reach);
        let mut found: Vec<(f64, u32)> = self.sorted[first..]
            .iter()
            .take_while(|l| l.print.centroid[self.axis] <= at + reach)
            .filter_map(|l| Some((unlikeness_in_place(old, &l.print, diagonal)?, l.number)))
            .collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        found
    }
}

/// Pairs old surfaces, each at the place where it ought to be, with new ones: each with its clearly
/// nearest, and a new one with one old one only.
pub(super) fn paired(old: impl IntoIterator<Item = Landmark>, new: &Lineup, diagonal: f64) -> Paired {
    let mut paired = Paired::default();
    let mut claims: BTreeMap<u32, Vec<(f64, u32)>> = BTreeMap::new();
    for Landmark { number, print } in old {
        match new.candidates(&print, diagonal)[..] {
            [] => {
                paired.lost.insert(number, LostReason::NothingAlike);
            }
            [(nearest, _), (next, _), ..] if !clearly_nearer(nearest, next) => {
                paired.lost.insert(number, LostReason::SeveralAlike);
            }
            [(nearest, claimed), ..] => claims.entry(claimed).or_default().push((nearest, number)),
        }
    }
    for (claimed, mut by) in claims {
        by.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let tied = by.len() > 1 && !clearly_nearer(by[0].0, by[1].0);
        for (rank, &(_, number)) in by.iter().enumerate() {
            match (rank, tied) {
                (_, true) => paired.lost.insert(number, LostReason::SeveralAlike).is_some(),
                (0, false) => paired.numbers.insert(number, claimed).is_some(),
                _ => paired.lost.insert(number, LostReason::NothingAlike).is_some(),
            };
        }
    }
    paired
}
