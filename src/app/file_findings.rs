//! What is to be known of the part's file that is shown, and what cures it. Some of it casts doubt on the part: that
//! stands above the view until it is cured or dismissed.

use super::App;
use super::context::Context;
use crate::document::{Edit, Parameter};
use crate::part::{Digest, Hasher, PartFinding, Units};
use crate::progress::Activity;

const ISLANDS: &Parameter = Parameter::named("surfaces.min_area_mm2");

/// One click that cures a finding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FileCure {
    /// The file is read in another unit.
    Units(Units),
    /// Islands below this area are absorbed, mm².
    Absorb(f64),
}

impl FileCure {
    /// What cures a finding, if a click can.
    pub fn of(finding: &PartFinding) -> Option<FileCure> {
        match finding {
            PartFinding::ImplausibleSize { better_units, .. } => better_units.map(FileCure::Units),
            PartFinding::Shattered { absorb_below_mm2, .. } => Some(FileCure::Absorb(*absorb_below_mm2)),
            _ => None,
        }
    }
}

impl App {
    /// Does it.
    pub(super) fn cure(&mut self, cure: FileCure) {
        match cure {
            FileCure::Units(units) => self.edit(Edit::Units(units)),
            FileCure::Absorb(below_mm2) => self.set_parameter(ISLANDS, below_mm2),
        }
    }

    /// Looks whether the part shatters; what brings it to order is sought on a thread.
    pub(super) fn sync_shattered(&mut self) {
        self.derived.shattered.poll();
        let Some(key) = self.context().shattered_key() else { return };
        let (d, job) = (&mut self.derived, self.document.job());
        let Some((part, surfaces)) = d.pipeline.surfaces().filter(|_| d.shattered.lacks(key)) else { return };
        let (rule, spot_mm2) = (job.surfaces.rule(), job.beam.spot_area_mm2());
        if !PartFinding::may_be_shattered(part, surfaces, spot_mm2) {
            d.shattered.fill(key, || Ok(None));
            return;
        }
        let (part, surfaces, executor) = (part.clone(), surfaces.clone(), d.pipeline.executor().clone());
        d.shattered.start(key, Activity::CuttingSurfaces, &*executor, move |progress| {
            Ok(PartFinding::shattered(&part, &surfaces, &rule, spot_mm2, progress)?)
        });
    }
}

impl Context<'_> {
    /// What the finding of a part that shatters depends on.
    fn shattered_key(self) -> Option<Digest> {
        let surfaces = self.derived.pipeline.surfaces_key()?;
        Some(Hasher::default().of(&surfaces).of(&self.document.job().beam.spot_mm).finish())
    }

    /// What is to be known of the file of the part that is shown, the worst first.
    pub fn file_findings(self) -> Vec<PartFinding> {
        let Some(part) = &self.derived.part else { return Vec::new() };
        let shattered = self.shattered_key().and_then(|key| self.derived.shattered.of(key));
        PartFinding::with(PartFinding::of(part), shattered.and_then(|found| (**found).clone()))
    }

    /// Those that cast doubt on the part and were not dismissed.
    pub fn doubts(self) -> Vec<PartFinding> {
        let is_open = |f: &PartFinding| f.casts_doubt() && !self.session.dismissed.contains(f);
        self.file_findings().into_iter().filter(is_open).collect()
    }
}
