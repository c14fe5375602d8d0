//! What a job says of single surfaces, all in one place under the name of the surface. What becomes of it when
//! surfaces get other numbers is told in `renumber`.

use super::chosen::Chosen;
use super::start_from::StartFrom;
use crate::part::{Hasher, Keyed, SurfaceId, keyed};
use crate::pose::{Pin, Tilt, TiltRule};
use std::collections::BTreeMap;
use std::sync::Arc;

/// What a job says of one surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceSettings {
    /// The name that the operator gave it; empty: none.
    pub name: String,
    /// The recipe that it is worked with; `None`: the job's own values.
    pub recipe: Option<String>,
    /// Its place in the order of work, from 0; `None`: it is not in the list to clean. Unused where a job
    /// cleans all.
    pub work: Option<u32>,
    /// Put aside for another job: it is not planned.
    pub later: bool,
    /// Its other side is to be worked on.
    pub flipped: bool,
    /// What it asks of the tilt.
    pub tilt: TiltRule,
    /// Tilts that the operator has set on its lines.
    pub pins: Vec<Pin>,
    /// What its offset lines start from, whatever recipe and job say.
    pub border: Option<StartFrom>,
    /// Where the centre of its spiral is, whatever recipe and job say: mm, part frame.
    pub centre_mm: Option<[f64; 3]>,
}

/// The settings of a surface that has none of its own.
static SILENT: SurfaceSettings = SurfaceSettings {
    name: String::new(),
    recipe: None,
    work: None,
    later: false,
    flipped: false,
    tilt: TiltRule { preferred: Tilt { lead_deg: 0.0, lean_deg: 0.0 }, least_deg: 0.0, forbidden: Vec::new() },
    pins: Vec::new(),
    border: None,
    centre_mm: None,
};

/// What a job says of its surfaces.
///
/// Surfaces that nothing is said of have no entry, and places in the order of work are 0, 1, 2, …, so that jobs
/// that say the same are equal. The map is shared between copies of a job until one of them changes it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    cleans_all: bool,
    of: Arc<BTreeMap<SurfaceId, SurfaceSettings>>,
}

keyed!(SurfaceSettings { recipe, work, later, flipped, tilt, pins, border, centre_mm; name });

impl Keyed for Settings {
    fn feed(&self, into: &mut Hasher) {
        let Settings { cleans_all, of } = self;
        cleans_all.feed(into);
        // A surface that only has a name is one that nothing is said of.
        let says_more = |s: &SurfaceSettings| SurfaceSettings { name: String::new(), ..s.clone() } != SILENT;
        for (id, settings) in of.iter().filter(|(_, settings)| says_more(settings)) {
            id.0.feed(into);
            settings.feed(into);
        }
    }
}

impl Settings {
    /// What these say, and whether all surfaces are cleaned; in the order of work places may be left out, and
    /// what is put aside has none.
    pub(super) fn new(cleans_all: bool, of: BTreeMap<SurfaceId, SurfaceSettings>) -> Settings {
        let mut settings = Settings { cleans_all, of: Arc::new(of) };
        settings.normalize();
        settings
    }

    /// What is said of one surface.
    pub fn of(&self, surface: SurfaceId) -> &SurfaceSettings {
        self.of.get(&surface).unwrap_or(&SILENT)
    }

    /// All that something is said of, by their numbers.
    pub fn iter(&self) -> impl Iterator<Item = (SurfaceId, &SurfaceSettings)> {
        self.of.iter().map(|(id, s)| (*id, s))
    }

    /// Surfaces whose settings meet a condition, by their numbers.
    pub fn having(&self, what: impl Fn(&SurfaceSettings) -> bool) -> Vec<SurfaceId> {
        self.iter().filter(|(_, s)| what(s)).map(|(id, _)| id).collect()
    }

    /// Changes what is said of one surface.
    pub fn change(&mut self, surface: SurfaceId, change: impl Fn(&mut SurfaceSettings)) {
        self.change_each(&[surface], change);
    }

    /// Changes what is said of several surfaces.
    pub fn change_each(&mut self, surfaces: &[SurfaceId], change: impl Fn(&mut SurfaceSettings)) {
        let of = Arc::make_mut(&mut self.of);
        surfaces.iter().for_each(|id| change(of.entry(*id).or_default()));
        self.normalize();
    }

    /// Whether all surfaces are cleaned, in the order of their numbers, but those put aside.
    pub fn cleans_all(&self) -> bool {
        self.cleans_all
    }

    /// Whether no surface is chosen to be cleaned.
    pub fn cleans_nothing(&self) -> bool {
        !self.cleans_all && self.of.values().all(|s| s.work.is_none())
    }

    /// The surfaces to clean in the order of work, given all that exist. A chosen one that does not exist is among
    /// them, so that it can be told.
    pub fn chosen(&self, all: impl IntoIterator<Item = SurfaceId>) -> Vec<SurfaceId> {
        match self.choice() {
            Chosen::All => all.into_iter().filter(|id| !self.of(*id).later).collect(),
            Chosen::These(list) => list,
        }
    }

    /// Which surfaces are named to be cleaned, as it is written in a job.
    pub fn choice(&self) -> Chosen {
        if self.cleans_all {
            return Chosen::All;
        }
        let mut list: Vec<(u32, SurfaceId)> = self.iter().filter_map(|(id, s)| Some((s.work?, id))).collect();
        list.sort_unstable();
        Chosen::These(list.into_iter().map(|(_, id)| id).collect())
    }

    /// Chooses all surfaces, but those put aside; or these and no others, in this order, which brings back what was
    /// put aside of them. One that stands twice has its first place.
    pub fn choose(&mut self, chosen: impl Into<Chosen>) {
        let chosen = chosen.into();
        let of = Arc::make_mut(&mut self.of);
        of.values_mut().for_each(|s| s.work = None);
        self.cleans_all = chosen == Chosen::All;
        if let Chosen::These(list) = chosen {
            for (place, id) in (0..).zip(list) {
                let s = of.entry(id).or_default();
                s.work = s.work.or(Some(place));
                s.later = false;
            }
        }
        self.normalize();
    }

    /// Drops empty entries, and counts places anew.
    fn normalize(&mut self) {
        let cleans_all = self.cleans_all;
        let of = Arc::make_mut(&mut self.of);
        for s in of.values_mut().filter(|s| s.later || cleans_all) {
            s.work = None;
        }
        let mut order: Vec<_> =
            of.iter_mut().filter_map(|(id, s)| s.work.as_mut().map(|place| (*place, *id, place))).collect();
        order.sort_unstable_by_key(|(before, id, _)| (*before, *id));
        (0..).zip(order).for_each(|(place, (_, _, at))| *at = place);
        of.retain(|_, s| *s != SILENT);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [SurfaceId; 5] = [SurfaceId(1), SurfaceId(2), SurfaceId(3), SurfaceId(4), SurfaceId(5)];

    fn numbers(settings: &Settings) -> Vec<u32> {
        settings.chosen(ALL).into_iter().map(|id| id.0).collect()
    }

    #[test]
    fn a_list_is_cleaned_in_its_order_and_all_in_that_of_numbers() {
        let mut settings = Settings::default();
        assert!(settings.cleans_nothing());
        settings.choose([4, 1, 9, 4]);
        assert_eq!((numbers(&settings), settings.choice()), (vec![4, 1, 9], [4, 1, 9].into()));
        settings.change_each(&[SurfaceId(1), SurfaceId(5)], |s| s.later = true);
        assert_eq!(numbers(&settings), [4, 9], "what is put aside is in no list");
        assert_eq!(settings.of(SurfaceId(9)).work, Some(1), "no place is left out");
        settings.choose(Chosen::All);
        assert_eq!(numbers(&settings), [2, 3, 4]);
        assert!(settings.cleans_all() && !settings.cleans_nothing());
        settings.choose([5]);
        assert_eq!(numbers(&settings), [5], "chosen by its number it comes back");
        assert!(settings.of(SurfaceId(1)).later);
    }

    #[test]
    fn what_says_the_same_is_equal() {
        let mut settings = Settings::default();
        settings.change(SurfaceId(3), |s| s.flipped = true);
        settings.change(SurfaceId(7), |s| s.work = Some(40));
        assert_eq!(settings.of(SurfaceId(7)).work, Some(0));
        let shared = settings.clone();
        settings.change(SurfaceId(3), |s| s.flipped = false);
        assert_ne!(settings, shared);
        settings.choose([]);
        assert_eq!(settings, Settings::default());
        assert!(shared.of(SurfaceId(3)).flipped, "a copy keeps what it had");
    }
}
