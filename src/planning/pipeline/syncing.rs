//! The pipeline is brought up to date with a job: what has arrived is taken, and what is out of date is started.

use super::super::cures::cures;
use super::super::error::PartError;
use super::super::failure::Failure;
use super::super::key::Keys;
use super::super::making::plan;
use super::super::planned::PlannedJob;
use super::super::preview;
use super::super::report::{Report, in_file, notices_worst_first};
use super::super::scanned::ScanReport;
use super::super::stage::Stage;
use super::{Changes, Pipeline, Wanted};
use crate::beam::Obstacle;
use crate::cell::{Frame, Setup};
use crate::document::files::{self, JobError};
use crate::document::stamps::Stamps;
use crate::document::{Job, segmented};
use crate::part::raw_part::RawPart;
use crate::part::{Digest, Part, Placement, Source, Units, Weld};
use crate::progress::{Activity, Progress};
use crate::scan::unscanned_space::unscanned_facets;
use nalgebra::Isometry3;
use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

impl Pipeline {
    /// Whether it was synced to this job last, and what it calls current is current.
    pub fn is_synced(&self, job: &Job, job_file: Option<&Path>) -> bool {
        self.wanted.as_ref().is_some_and(|w| w.job == *job && w.file.as_deref() == job_file)
    }

    /// Takes what has arrived for a job in its file, and starts what is out of date.
    pub fn sync(&mut self, job: &Job, job_file: Option<&Path>) -> Changes {
        let mut changes = Changes::default();
        let Some(source) = self.source.clone() else { return changes };
        let keys = self.keys_for(&source, job, job_file);
        self.sync_part(&source, job, &keys);
        self.sync_scan(job, job_file, &keys);
        self.sync_weld(job, job_file, &keys);
        if let Some(key) = self.surfaces_key().filter(|key| self.told != Some(*key) && self.surfaces().is_some()) {
            self.told = Some(key);
            changes.surfaces = true;
        }
        self.sync_setup(job, job_file, &keys, &mut changes);
        self.sync_stamps(job, job_file, &keys);
        self.sync_plan(job, &keys);
        changes
    }

    /// The keys of what is wanted: those of the last time, while nothing has changed.
    fn keys_for(&mut self, source: &Source, job: &Job, job_file: Option<&Path>) -> Keys {
        if let Some(known) = self.wanted.as_ref().filter(|_| self.is_synced(job, job_file)) {
            return known.keys;
        }
        let keys = Keys::new(source, job, job_file, self.reading);
        self.wanted = Some(Wanted { job: job.clone(), file: job_file.map(Path::to_path_buf), keys });
        keys
    }

    fn sync_part(&mut self, source: &Arc<Source>, job: &Job, keys: &Keys) {
        self.part.poll();
        if self.part.lacks(keys.part) {
            let (source, of) = (source.clone(), job.part.clone());
            self.part.start(keys.part, Activity::BuildingPart, &*self.executor, move |progress| {
                if of.is_of_another_file(&source.sha256) {
                    return Err(Failure::Refused(PartError::Changed));
                }
                let made = source.part(of.units, of.weld, &of.placement, &of.flipped_shells, progress);
                made.map_err(|e| Failure::Refused(e.into()))?.ok_or(Failure::Cancelled)
            });
        }
        let Some(part) = self.part.of(keys.part) else { return };
        if self.surfaces.lacks(keys.surfaces) {
            self.surfaces.fill(keys.surfaces, || Ok(segmented(part, job)));
        }
    }

    /// Work that is done at once brings the next stage in the same sync, so that whoever waits gets all.
    fn sync_scan(&mut self, job: &Job, job_file: Option<&Path>, keys: &Keys) {
        let (Some(part), Some(surfaces)) = (self.part.of(keys.part), self.surfaces.of(keys.surfaces)) else { return };
        let Some(scan) = &keys.scan else {
            self.scan.stop();
            return;
        };
        self.scan.sync(part, surfaces, job, job_file, scan, &*self.executor);
    }

    fn sync_weld(&mut self, job: &Job, job_file: Option<&Path>, keys: &Keys) {
        let (Some(part), Some(surfaces)) = (self.part.of(keys.part), self.surfaces.of(keys.surfaces)) else { return };
        let Some((weld, report)) = keys.weld.zip(keys.weld_report) else {
            self.weld.stop();
            return;
        };
        self.weld.sync(part, surfaces, job, job_file, (&weld, report), &*self.executor);
    }

    /// Files are small and read at once; each is read again only where its own key changes, as frames are
    /// dragged.
    fn sync_setup(&mut self, job: &Job, job_file: Option<&Path>, keys: &Keys, changes: &mut Changes) {
        // Where the scanner's place is known the part's follows from the scan.
        let scan = &job.scan;
        let is_placed = keys.scan.is_some() && (scan.base_from_scan.is_some() || scan.flange_from_scan.is_some());
        let laid = keys.scan.filter(|_| is_placed).and_then(|scan| self.scan.laid.of(scan.laid));
        // And likewise where it is known where the camera stood.
        let is_seen = keys.weld.is_some() && !job.weld.hand_eye.is_empty();
        let seen = keys.weld.filter(|_| is_seen).and_then(|weld| self.weld.ground.of(weld.ground)).cloned();
        if !self.setup.lacks(keys.setup) || is_placed && laid.is_none() || is_seen && seen.is_none() {
            return;
        }
        let job = &placed_by_scan(job, laid.map(|laid| laid.model_from_scan));
        let job = &seen.as_ref().map_or(Cow::Borrowed(&**job), |seen| seen.placed(job));
        let refused = |e: JobError| Failure::Refused(Arc::new(e));
        if self.tool.lacks(keys.tool) {
            self.tool.fill(keys.tool, || files::load_tool(job, job_file).map_err(refused));
        }
        if self.cell.lacks(keys.cell) {
            self.cell.fill(keys.cell, || files::load_cell(job, job_file).map_err(refused));
        }
        if self.robot.lacks(keys.cell) {
            self.robot.fill(keys.cell, || files::load_robot(job, job_file).map_err(refused));
        }
        let (tool, cell) = (current(&self.tool, keys.tool), current(&self.cell, keys.cell));
        let robot = current(&self.robot, keys.cell);
        self.setup.fill(keys.setup, || {
            files::set_up(job, (*robot?).clone(), (*cell?).clone(), (*tool?).clone()).map_err(refused)
        });
        changes.setup = true;
    }

    /// Stamps the files that are read with the job, once any of them is another one.
    fn sync_stamps(&mut self, job: &Job, job_file: Option<&Path>, keys: &Keys) {
        let of = (keys.tool, keys.cell, [keys.scan.map(|scan| scan.read), keys.weld.map(|weld| weld.read)]);
        if self.stamped == Some(of) || self.cell.lacks(keys.cell) {
            return;
        }
        let robot = self.robot.of(keys.cell).and_then(|robot| robot.as_ref().as_ref());
        self.stamps = Stamps::of(job, job_file, self.cell.of(keys.cell).map(|cell| &**cell), robot);
        self.stamped = Some(of);
    }

    fn sync_plan(&mut self, job: &Job, keys: &Keys) {
        self.lines.poll();
        self.plan.poll();
        if self.waits_for_scan() || self.waits_for_weld() {
            self.lines.clear();
            self.plan.only(keys.plan);
            return;
        }
        let Some((on, (part, surfaces))) = self.surfaces_key().zip(self.surfaces()) else { return };
        let (part, surfaces) = (part.clone(), surfaces.clone());
        if job.chosen(&surfaces).is_empty() && surfaces.worked.is_none() {
            self.lines.clear();
            self.plan.clear();
            return;
        }
        let Some(setup) = self.setup.of(keys.setup) else { return };
        let setup = setup.clone();
        if self.with_lines && self.lines.lacks(keys.plan) {
            let (part, surfaces, job, cache) = (part.clone(), surfaces.clone(), job.clone(), self.cache.clone());
            self.plan.only(keys.plan);
            let of = (on, keys.plan);
            self.lines
                .start(of, &*self.executor, move |progress| Ok(preview(&part, &surfaces, &job, &cache, progress)?));
        }
        let is_laid = !self.with_lines || !self.lines.is_running();
        let weld_report = keys.weld_report.and_then(|report| self.weld.reported.of(report)).cloned();
        let is_reported = weld_report.is_some() || keys.weld_report.is_none();
        if !is_reported {
            self.plan.only(keys.plan);
        }
        if is_laid && is_reported && self.plan.lacks(keys.plan) {
            let (key, job, cache) = (keys.plan, job.clone(), self.cache.clone());
            let scanned = self.scanned();
            let weld = self.welded().and_then(|welded| welded.ground);
            let slack_mm = scanned.as_ref().and_then(|s| s.laid.as_ref()).map_or(0.0, |laid| laid.slack_mm());
            let slack_mm = weld.as_ref().map_or(slack_mm, |weld| slack_mm.max(weld.on.slack_mm()));
            self.plan.start(key, Activity::Planning, &*self.executor, move |progress| {
                let setup = beside_unscanned(with_slack(setup, slack_mm), &part);
                let mut plan = plan(&part, &surfaces, &job, &setup, &cache, progress)?;
                let is_placed = job.scan.scanner(setup.mount).is_some();
                (plan.weld, plan.weld_report) = (weld, weld_report);
                plan.scan = scanned.and_then(|s| ScanReport::new(&s, is_placed));
                let in_file = in_file(&part, &surfaces, &job, progress)?;
                let report = Report::new(&plan, &surfaces).with_inputs(&in_file, &job, &setup);
                let notices = notices_worst_first(&report, &job, &in_file);
                let cures = cures(&part, &surfaces, &job, &plan, &cache, progress)?;
                Ok(PlannedJob { key, job, part, surfaces, setup, plan, report, notices, cures })
            });
        }
    }
}

/// The set-up for a part that may lie so far off where it was scanned: everything keeps clear of it by so much more.
fn with_slack(mut setup: Arc<Setup>, slack_mm: f64) -> Arc<Setup> {
    if slack_mm > 0.0 {
        let wider = Arc::make_mut(&mut setup);
        wider.tool.slack_mm = slack_mm;
        wider.cell.bodies.margin_mm += slack_mm;
    }
    setup
}

/// The set-up with what was not scanned of a part that was meshed from its scan.
fn beside_unscanned(mut setup: Arc<Setup>, part: &Part) -> Arc<Setup> {
    let facets = part.figures.meshed.map_or(Vec::new(), |_| unscanned_facets(part));
    if !facets.is_empty() {
        let raw = RawPart { facets, ..RawPart::default() };
        let source = Source { raw, sha256: String::new() };
        let solid = source.part(Units::Mm, Weld::Exact, &Placement::default(), &[], &Progress::default());
        // Nobody else holds this progress, and rims have length.
        if let Ok(Some(solid)) = solid {
            Arc::make_mut(&mut setup).tool.clamps.push(Obstacle::unscanned(solid));
        }
    }
    setup
}

/// The job with the part where scanner and scan put it (P3 4.4): `base_from_part = base_from_scan · model_from_scan⁻¹`, and
/// on the flange likewise.
fn placed_by_scan<'a>(job: &'a Job, model_from_scan: Option<Isometry3<f64>>) -> Cow<'a, Job> {
    let Some(model_from_scan) = model_from_scan else { return Cow::Borrowed(job) };
    let part_in = |scanner: &Frame| Frame::of(&(scanner.isometry() * model_from_scan.inverse()));
    let mut placed = job.clone();
    if let Some(scanner) = &job.scan.base_from_scan {
        placed.cell.base_from_part = Some(part_in(scanner));
    }
    if let Some(scanner) = &job.scan.flange_from_scan {
        placed.cell.flange_from_part = Some(part_in(scanner));
    }
    Cow::Owned(placed)
}

fn current<V, E: Clone>(stage: &Stage<V, E>, key: Digest) -> Result<Arc<V>, Failure<E>> {
    match (stage.of(key), stage.failure(key)) {
        (Some(value), _) => Ok(value.clone()),
        (None, Some(why)) => Err(why.clone()),
        (None, None) => Err(Failure::Cancelled),
    }
}
