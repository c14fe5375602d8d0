//! Brings what is computed up to date with the document, once a frame: takes what has arrived, and starts
//! what is missing.

use super::App;
use super::access::Ground;
use super::context::Context;
use super::playback_data::PlaybackData;
use super::scan_section::SectionOf;
use super::scan_view::ScanWanted;
use super::toggle::Toggle;
use crate::part::surfaces::Surface;
use crate::part::{Shape, SurfaceId};
use crate::picture::{CellPicture, PartPicture, ToolPicture, paths};
use crate::planning::surface_plan::tool_geometry;
use crate::planning::{Failure, PartError, PlanningError};
use crate::progress::{Activity, Cancelled};
use crate::text::{Sentence as _, say};
use std::sync::Arc;

impl App {
    /// Takes what has arrived, and starts the work on what is out of date.
    pub(super) fn sync(&mut self) {
        let changes = self.derived.pipeline.sync(self.document.job(), self.document.file());
        if changes.surfaces {
            self.take_surfaces();
        }
        if changes.setup {
            self.take_setup();
        }
        self.sync_shapes();
        self.sync_shattered();
        if self.derived.part.is_none() {
            return;
        }
        self.sync_borders();
        self.sync_tool();
        self.sync_lines();
        self.sync_motion();
        self.sync_dose();
        self.sync_spacing();
        self.sync_scan();
        self.sync_tool_of_scan();
        self.sync_weld();
        self.sync_suggestions();
        self.sync_clearance();
    }

    /// Part and surfaces are taken together: one belongs to the other.
    fn take_surfaces(&mut self) {
        let d = &mut self.derived;
        let Some((part, surfaces)) = d.pipeline.surfaces() else { return };
        let (part, surfaces) = (part.clone(), surfaces.clone());
        // Other patches leave the part where it is, and the camera too.
        let file_part = d.pipeline.part_of_file().cloned();
        let is_same = d.file_part.as_ref().zip(file_part.as_ref()).is_some_and(|(one, other)| Arc::ptr_eq(one, other));
        self.session.fit_pending |= !is_same;
        d.file_part = file_part;
        d.picture = Some(PartPicture::new(&part, &surfaces, d.picture.as_ref()));
        let there = |n: &u32| surfaces.get(*n).is_some();
        self.session.selected.retain(there);
        self.session.hidden.retain(there);
        (d.part, d.surfaces) = (Some(part), surfaces);
        d.part_of.clone_from(&self.document.job().part);
    }

    /// Finds the borders that are chosen, and those of the surface that was right clicked.
    fn sync_borders(&mut self) {
        let Some(part) = &self.derived.part else { return };
        let job = self.document.job();
        let start = |n: u32| Some((n, job.offset_start(SurfaceId(n))?.border()?));
        let chosen: Vec<(u32, u32)> = self.context().clean_list().into_iter().filter_map(start).collect();
        let besides = self.context().offset_surface().map(|surface| surface.0);
        self.borders.sync(part, &self.derived.surfaces, chosen, besides);
    }

    /// Brings dots and scale of the spacing up to date, if they are shown.
    fn sync_spacing(&mut self) {
        if let Some(planned) = self.derived.plan_on_part().filter(|_| self.session.show.is_on(Toggle::Spacing)) {
            self.spacing.sync(planned);
        }
    }

    /// Brings what is shown of the scan up to date, if anything is; labels tell what is off there now.
    fn sync_scan(&mut self) {
        let is_on = |what| self.session.show.is_on(what);
        let wanted = ScanWanted { dropped: is_on(Toggle::DroppedPoints), model: is_on(Toggle::DeviationOnModel) };
        let is_asked_for = is_on(Toggle::Scan) || wanted.dropped || wanted.model || is_on(Toggle::ScanSection);
        let pipeline = &self.derived.pipeline;
        let scanned = pipeline.scanned().filter(|_| is_asked_for || self.session.scan_tool.is_some());
        // One that was refused takes the points of the one before with it.
        let scanned = scanned.filter(|s| s.compared.is_some() || pipeline.error().is_none());
        let part = pipeline.part_of_file().map(|part| &**part);
        if self.scan.sync(scanned.as_ref(), &self.document.job().scan, part, wanted) {
            let labels = std::mem::take(&mut self.session.labels);
            self.session.labels = labels.iter().filter_map(|label| self.scan.label_near(&label.at)).collect();
        }
        self.sync_section();
    }

    /// Brings what is shown of the weld up to date, and its images, if they are shown.
    fn sync_weld(&mut self) {
        let pipeline = &self.derived.pipeline;
        let is_refused = pipeline.error().is_some();
        self.weld.sync(pipeline.welded(), self.document.job().weld.is_there(), is_refused);
        if self.session.show.is_on(Toggle::WeldImages) {
            self.weld.sync_textures(self.session.images.step, &self.ctx);
        }
    }

    /// Cuts part and scan, if the section is shown.
    fn sync_section(&mut self) {
        let d = &self.derived;
        let scanned = d.pipeline.scanned().filter(|_| self.session.show.is_on(Toggle::ScanSection));
        let laid = scanned.as_ref().and_then(|s| s.laid.as_ref().zip(s.compared.as_ref()));
        let parts = d.part.as_ref().zip(d.pipeline.part_of_file());
        let of = laid.zip(parts).zip(self.scan.scale()).map(|(((laid, compared), (part, file_part)), scale)| {
            SectionOf { part, surfaces: &d.surfaces, file_part, laid, compared, scale }
        });
        self.section.sync(&self.session.section, of.as_ref());
    }

    fn sync_shapes(&mut self) {
        let d = &mut self.derived;
        d.shapes.poll();
        let (Some(key), Some((part, surfaces))) = (d.pipeline.surfaces_key(), d.pipeline.surfaces()) else { return };
        if d.shapes.lacks(key) {
            let (part, surfaces) = (part.clone(), surfaces.clone());
            let executor = d.pipeline.executor().clone();
            d.shapes.start(key, Activity::NamingShapes, &*executor, move |progress| {
                use rayon::prelude::*;
                let named = |s: &Surface| progress.check().map(|()| (s.number, Shape::of(&part.mesh, s)));
                Ok(surfaces.list.par_iter().map(named).collect::<Result<_, Cancelled>>()?)
            });
        }
    }

    fn take_setup(&mut self) {
        let d = &mut self.derived;
        d.cell = d.pipeline.setup().and_then(Result::ok).and_then(|setup| CellPicture::new(setup));
        let cell = &self.document.job().cell;
        let stands = Some((cell.file.clone(), cell.robot.clone(), cell.mount));
        if self.session.cell_shown != stands {
            self.session.cell_shown = stands;
            self.session.other_camera = None;
            self.session.fit_pending |= self.session.show.is_on(Toggle::Cell);
        }
    }

    fn sync_tool(&mut self) {
        let d = &mut self.derived;
        let (Some(key), Some(Ok(setup))) = (d.pipeline.setup_key(), d.pipeline.setup()) else { return };
        if d.tool_picture.as_ref().is_none_or(|(known, _)| *known != key) {
            let body = tool_geometry(self.document.job(), setup);
            d.tool_picture = Some((key, ToolPicture::new(&setup.tool, body.as_ref())));
        }
    }

    /// Shows the lines of a plan before it is finished, as it takes a while; not if the plan that is shown has the same.
    fn sync_lines(&mut self) {
        let d = &mut self.derived;
        let Some((key, laid)) = d.pipeline.lines() else {
            d.laid = None;
            return;
        };
        if d.laid.as_ref().is_some_and(|(known, _)| *known == key) {
            return;
        }
        let shown = d.plan_on_part().into_iter().flat_map(|planned| &planned.plan.surfaces);
        let shown = shown.filter(|s| s.toolpath.layer == 0).map(|s| Arc::as_ptr(&s.toolpath));
        d.laid = (!shown.eq(laid.iter().map(Arc::as_ptr))).then(|| (key, paths::toolpath_item(laid, key.0 as u64)));
    }

    /// Works out the motion of the newest plan.
    fn sync_motion(&mut self) {
        let part_name = self.context().part_file_name();
        let d = &mut self.derived;
        let Some(planned) = d.pipeline.newest_plan().cloned() else {
            d.playback_data.clear();
            return;
        };
        let mut arrived = d.playback_data.poll();
        if d.playback_data.lacks(planned.key) {
            let executor = d.pipeline.executor().clone();
            let key = planned.key;
            d.playback_data.start(key, Activity::WorkingOutMotion, &*executor, move |progress| {
                Ok(PlaybackData::new(&planned, &part_name, progress)?)
            });
            arrived |= d.playback_data.of(key).is_some();
        }
        if arrived && self.derived.playback_data().is_some() {
            self.session.plot_span = None;
            self.session.program_view.line = None;
            self.go_to_target(self.session.playback.at);
        }
    }

    /// Brings the dose up to date, if it is shown.
    fn sync_dose(&mut self) {
        let planned = self.context().plan().cloned();
        let current = self.derived.pipeline.dose_key().zip(planned);
        let executor = self.derived.pipeline.executor().clone();
        let is_wanted = self.session.show.is_on(Toggle::Dose);
        self.derived.dose.sync(current, self.document.job(), is_wanted, &*executor);
    }

    /// Brings suggestions and a better set-up up to date with the plan.
    fn sync_suggestions(&mut self) {
        let (refusing, executor) = (self.context().refusing_plan().cloned(), self.derived.pipeline.executor().clone());
        self.derived.suggestions.sync(refusing, &*executor);
    }

    /// Brings the clearance up to date, if the curves are shown.
    fn sync_clearance(&mut self) {
        let planned = self.context().plan().filter(|_| self.session.show.is_on(Toggle::Plots)).cloned();
        let current = planned.and_then(|p| Some((p.clone(), self.derived.playback_data.of(p.key)?.clone())));
        let executor = self.derived.pipeline.executor().clone();
        self.derived.clearance.sync(current, &*executor);
    }

    /// Makes the access map of the place under the cursor, or of the current target, and the strip of its line. Called
    /// right before they are drawn: place and target may have changed in this frame.
    pub(super) fn sync_access(&mut self) {
        let place = self.context().access_place();
        let (d, job) = (&self.derived, self.document.job());
        let (number, over) = (self.session.playback.at.0, self.session.strip_over);
        let setup = d.pipeline.setup().and_then(Result::ok);
        let planned = d.plan();
        let plan = planned.map_or(0, |of| of.picture_key());
        let on = d.part.as_ref().zip(setup).map(|(part, setup)| Ground { part, job, setup, plan });
        self.access.look_at(place, on.as_ref());
        let pass = planned.and_then(|of| Some((number, of.plan.passes.get(number)?)));
        let on = planned.zip(setup).map(|(of, setup)| Ground { part: &of.part, job, setup, plan });
        self.access.look_along(pass, over, on.as_ref());
    }

    /// Looks for changed files when the window gets the focus: the operator may come from the CAD program.
    pub(super) fn watch_focus(&mut self, ctx: &eframe::egui::Context) {
        let is_focused = ctx.input(|i| i.focused);
        if is_focused && !self.session.was_focused {
            self.derived.pipeline.look_again();
            self.look_for_changes();
        }
        self.session.was_focused = is_focused;
    }

    /// Plans again what was cancelled or failed, and reads the files beside the part again.
    pub(super) fn plan_again(&mut self) {
        self.look_for_changes();
        self.derived.pipeline.try_again();
        self.derived.shapes.try_again();
        self.derived.shattered.try_again();
        self.derived.playback_data.try_again();
        self.derived.suggestions.try_again();
        self.derived.dose.try_again();
        self.derived.clearance.try_again();
    }
}

impl Context<'_> {
    /// Why there is no plan for the document as it is, for people.
    pub fn planning_error(self) -> Option<String> {
        use PlanningError as E;
        let error = self.derived.error(self.document)?;
        Some(match error {
            e if e.is_cancelled() => say!(window_planning_cancelled),
            E::Part(Failure::Refused(PartError::Changed)) => say!(window_part_of_another_state),
            E::Part(Failure::Panicked(_))
            | E::Scan(Failure::Panicked(_))
            | E::Weld(Failure::Panicked(_))
            | E::Setup(Failure::Panicked(_))
            | E::Plan(Failure::Panicked(_)) => {
                say!(window_fault, error = error.sentence())
            }
            other => other.sentence(),
        })
    }
}
