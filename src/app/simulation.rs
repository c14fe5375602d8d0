//! The simulation: time and target go together, either may lead. And the two modes of the view:
//! the part alone in its own frame, or the robot cell in the base.

use super::App;
use crate::cell::{Joints, Setup};
use crate::picture::CellPicture;
use crate::program::{Moment, Timeline};
use crate::view::{Bounds, Camera};
use eframe::egui;
use nalgebra::{Isometry3, Point3};

/// What stands where in the base.
pub(super) struct Placed {
    /// The arm.
    pub joints_deg: Joints,
    /// The part.
    pub base_from_part: Isometry3<f64>,
    /// The focus, z against the light.
    pub base_from_focus: Isometry3<f64>,
    /// Whether the laser is on.
    pub lit: bool,
}

impl App {
    /// The program over time, with a robot.
    pub(super) fn timeline(&self) -> Option<&Timeline> {
        self.derived.motion()?.timeline.as_ref()
    }

    /// The arm now.
    pub(super) fn moment(&self) -> Option<Moment> {
        Some(self.timeline()?.moment(self.session.time_s))
    }

    /// Steps to a target; the time follows.
    pub(super) fn go_to_target(&mut self, at: (usize, usize)) {
        self.session.at = at;
        self.session.time_s = self.derived.motion().map_or(0.0, |m| m.time_of(at));
    }

    /// Goes to a time; the target follows: the one that is being gone to, or was reached last.
    pub(super) fn go_to_time(&mut self, time_s: f64) {
        let Some(timeline) = self.timeline() else { return };
        let time_s = time_s.clamp(0.0, timeline.total_s());
        let stops = &timeline.stops()[..=timeline.stop_at(time_s)];
        let at = stops.iter().rev().find_map(|s| s.target).unwrap_or((0, 0));
        (self.session.time_s, self.session.at) = (time_s, at);
    }

    /// Moves the time on while playing.
    pub(super) fn advance_time(&mut self, ctx: &egui::Context) {
        let Some(total_s) = self.timeline().map(Timeline::total_s) else { return };
        let since_s = f64::from(ctx.input(|i| i.stable_dt).min(0.1) * self.session.play_speed);
        let time_s = self.session.time_s + since_s;
        let ended = time_s >= total_s;
        self.go_to_time(if ended && self.session.play_loop { 0.0 } else { time_s });
        self.session.playing = !ended || self.session.play_loop;
    }

    fn setup(&self) -> Option<&Setup> {
        self.derived.pipeline.setup()?.ok().map(|setup| &**setup)
    }

    /// Arm and head: as they stand, or as a proposed set-up would have them.
    pub(super) fn cell_picture(&self) -> Option<&CellPicture> {
        let proposed = self.proposal().and_then(|p| p.picture.as_ref());
        proposed.or(self.derived.cell.as_ref())
    }

    /// Whether the robot cell is shown.
    pub(super) fn is_in_cell(&self) -> bool {
        self.session.show.cell && self.derived.cell.is_some()
    }

    /// What stands where now, or would; at home before there is a plan.
    pub(super) fn placed(&self) -> Option<Placed> {
        let proposal = self.proposal();
        let setup = proposal.map_or_else(|| self.setup(), |p| Some(&p.setup))?;
        let robot = setup.robot.as_ref()?;
        let moment = self.moment().filter(|_| proposal.is_none());
        let still = || proposal.map_or(setup.home_joints_deg(), |p| self.proposed_joints_deg(p));
        let joints_deg = moment.map_or_else(still, |m| m.joints_deg);
        let flange = moment.map_or_else(|| robot.forward(&joints_deg), |m| m.base_from_flange);
        Some(Placed {
            joints_deg,
            base_from_part: setup.mounted().part_at(&flange),
            base_from_focus: setup.mounted().focus_at(&flange),
            lit: moment.is_some_and(|m| m.lit),
        })
    }

    /// Where the part stands in the view: in its own frame, or in the base.
    pub(super) fn scene_from_part(&self) -> Isometry3<f64> {
        let placed = if self.is_in_cell() { self.placed() } else { None };
        placed.map_or_else(Isometry3::identity, |p| p.base_from_part)
    }

    /// Length of the beam from the head to the part, mm.
    pub(super) fn beam_mm(&self, placed: &Placed, tip_mm: f64) -> f64 {
        let defocus_mm = self.document.job().beam.defocus_mm;
        let part_from_focus = placed.base_from_part.inverse() * placed.base_from_focus;
        let from = part_from_focus * Point3::new(0.0, 0.0, tip_mm);
        let light = part_from_focus * -nalgebra::Vector3::z();
        let hit = self.derived.part.as_ref().and_then(|p| p.bvh.nearest_hit(&from, &light, 0.0, f64::INFINITY));
        // Past the part the light goes on; shown is as much as would reach it.
        hit.map_or(tip_mm + defocus_mm.max(0.0), |h| h.t_mm)
    }

    /// The box around all that is shown.
    pub(super) fn whole_bounds(&self) -> Option<Bounds> {
        let (min, max) = self.derived.part.as_ref()?.mesh.bounds();
        let part = Bounds { min, max };
        let (true, Some(cell), Some(placed)) = (self.is_in_cell(), self.cell_picture(), self.placed()) else {
            return Some(part);
        };
        let moved = Bounds::around(part.corners().map(|c| placed.base_from_part * c))?;
        Some(moved.union(&cell.bounds(&placed.joints_deg, &placed.base_from_focus)))
    }

    /// The whole cell, seen from its front left.
    pub(super) fn fit_cell(&mut self) {
        let (Some(bounds), Some(size), Some(cell)) = (self.whole_bounds(), self.viewport.size(), &self.derived.cell)
        else {
            return; // the size of the view is known after its first frame
        };
        let hand_mm = self.derived.part.as_ref().map_or(0.0, |p| p.mesh.diagonal()) + 300.0;
        let mut camera = Camera {
            projection: self.viewport.camera.projection,
            scene_bounds: cell.reachable(hand_mm),
            ..Camera::default()
        };
        camera.fit(&bounds, size);
        self.jump(camera);
        self.session.fit_pending = false;
    }

    fn jump(&mut self, camera: Camera) {
        self.viewport.camera = camera;
        self.viewport.glide_to(camera); // ends a flight that is under way
    }

    /// From the part to the cell, or back; each keeps its camera.
    pub(super) fn toggle_cell(&mut self) {
        self.session.show.section = false;
        self.session.show.cell = !self.session.show.cell;
        match self.session.other_camera.replace(self.viewport.camera) {
            Some(camera) => self.jump(camera),
            None => self.session.fit_pending = true,
        }
    }

    /// Back to the part, where only its own frame will do.
    pub(super) fn leave_cell(&mut self) {
        if self.session.show.cell {
            let section = self.session.show.section;
            self.toggle_cell();
            self.session.show.section = section;
        }
    }
}
