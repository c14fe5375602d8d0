//! The simulation in the window: its place in the plan, and where arm, part and focus stand then. Also the two modes of
//! the view: the part alone in its own frame, or the robot cell in the base.

use super::App;
use super::command::Jump;
use super::context::Context;
use super::suggestion_search::BetterSetupPreview;
use super::toggle::Toggle;
use crate::cell::motion::Arm;
use crate::cell::{Joints, Setup};
use crate::picture::CellPicture;
use crate::view::{Bounds, Camera};
use eframe::egui;
use nalgebra::{Isometry3, Point3};

/// The longest time, s, that one frame moves the simulation on, so that it does not jump after a slow frame.
const LONGEST_FRAME_S: f32 = 0.1;

/// Where arm, part and focus stand in the base.
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
    /// Steps to a target; the time follows.
    pub(super) fn go_to_target(&mut self, at: (usize, usize)) {
        self.session.playback.go_to_target(at, self.derived.playback_data().map(|m| &**m));
    }

    /// Goes to a time; the target follows.
    pub(super) fn go_to_time(&mut self, time_s: f64) {
        if let Some(timeline) = self.derived.playback_data().and_then(|m| m.timeline.as_ref()) {
            self.session.playback.go_to_time(time_s, timeline);
        }
    }

    /// Goes to another target.
    pub(super) fn jump(&mut self, jump: Jump) {
        if let Some(of) = self.derived.plan() {
            self.session.playback.jump(jump, &of.plan, self.derived.playback_data().map(|m| &**m));
        }
    }

    /// Starts or stops the simulation.
    pub(super) fn play_or_pause(&mut self) {
        let timeline = self.derived.playback_data().and_then(|m| m.timeline.as_ref());
        self.session.playback.play_or_pause(timeline);
    }

    /// Goes on while playing.
    pub(super) fn advance_playback(&mut self, ctx: &egui::Context) {
        let Some(of) = self.derived.plan().filter(|_| self.session.playback.is_playing) else { return };
        ctx.request_repaint();
        let real_s = f64::from(ctx.input(|i| i.stable_dt).min(LONGEST_FRAME_S));
        self.session.playback.advance(real_s, &of.plan, self.derived.playback_data().map(|m| &**m));
    }

    /// The whole cell, seen from its front left.
    pub(super) fn fit_cell(&mut self) {
        let (Some(bounds), Some(size), Some(cell)) =
            (self.context().whole_bounds(), self.viewport.size(), &self.derived.cell)
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
        self.set_camera(camera);
        self.session.fit_pending = false;
    }

    fn set_camera(&mut self, camera: Camera) {
        self.viewport.camera = camera;
        self.viewport.glide_to(camera); // ends a flight that is under way
    }

    /// From the part to the cell, or back; each keeps its camera.
    pub(super) fn toggle_cell(&mut self) {
        self.session.show.set(Toggle::SectionPlane, false);
        if let Some(camera) = self.session.camera_before_section.take() {
            self.set_camera(camera);
        }
        self.session.show.flip(Toggle::Cell);
        match self.session.other_camera.replace(self.viewport.camera) {
            Some(camera) => self.set_camera(camera),
            None => self.session.fit_pending = true,
        }
    }

    /// Leaves the cell for the part, for what is shown in the part's own frame alone.
    pub(super) fn leave_cell(&mut self) {
        if self.session.show.is_on(Toggle::Cell) {
            let section = self.session.show.is_on(Toggle::SectionPlane);
            self.toggle_cell();
            self.session.show.set(Toggle::SectionPlane, section);
        }
    }
}

impl<'a> Context<'a> {
    fn setup(self) -> Option<&'a Setup> {
        self.derived.pipeline.setup()?.ok().map(|setup| &**setup)
    }

    /// Arm and head: as they stand, or as a better set-up would have them.
    pub fn cell_picture(self) -> Option<&'a CellPicture> {
        let better = self.better_setup().and_then(|p| p.picture.as_ref());
        better.or(self.derived.cell.as_ref())
    }

    /// Where all stands now, or would in a proposed set-up; at home before there is a plan.
    pub fn placed(self) -> Option<Placed> {
        let better = self.better_setup();
        let setup = better.map_or_else(|| self.setup(), |p| Some(&p.setup))?;
        let robot = setup.robot.as_ref()?;
        let moment = self.moment().filter(|_| better.is_none());
        let still = || better.map_or(setup.home_joints_deg(), |p| self.better_setup_joints_deg(p));
        let joints_deg = moment.map_or_else(still, |m| m.joints_deg);
        let flange = moment.map_or_else(|| robot.forward(&joints_deg), |m| m.base_from_flange);
        Some(Placed {
            joints_deg,
            base_from_part: setup.mounted().part_at(&flange),
            base_from_focus: setup.mounted().focus_at(&flange),
            lit: moment.is_some_and(|m| m.lit),
        })
    }

    /// The arm in a better set-up: at the current target, else at home.
    fn better_setup_joints_deg(self, better: &BetterSetupPreview) -> Joints {
        let job = self.document.job();
        let frame = self.target().map(|t| t.frame(self.process_settings().defocus_mm));
        let states = frame.and_then(|f| Arm::new(&better.setup, job.cell.spin)?.states(&f).ok());
        // The one that is furthest from a singular pose.
        let best = states.and_then(|s| s.into_iter().max_by(|a, b| a.singularity.total_cmp(&b.singularity)));
        best.map_or(better.setup.home_joints_deg(), |s| s.joints_deg)
    }

    /// Where the part stands in the view: in its own frame, or in the base.
    pub fn scene_from_part(self) -> Isometry3<f64> {
        let placed = if self.is_in_cell() { self.placed() } else { None };
        placed.map_or_else(Isometry3::identity, |p| p.base_from_part)
    }

    /// Length of the beam from the head to the part, mm.
    pub fn beam_mm(self, placed: &Placed, tip_mm: f64) -> f64 {
        let defocus_mm = self.document.job().beam.defocus_mm;
        let part_from_focus = placed.base_from_part.inverse() * placed.base_from_focus;
        let from = part_from_focus * Point3::new(0.0, 0.0, tip_mm);
        let light = part_from_focus * -nalgebra::Vector3::z();
        let hit = self.derived.part.as_ref().and_then(|p| p.bvh.nearest_hit(&from, &light, 0.0, f64::INFINITY));
        // Past the part the light goes on; shown is as much as would reach it.
        hit.map_or(tip_mm + defocus_mm.max(0.0), |h| h.t_mm)
    }

    /// The box around all that is shown.
    pub fn whole_bounds(self) -> Option<Bounds> {
        let (min, max) = self.derived.part.as_ref()?.mesh.bounds();
        let part = Bounds { min, max };
        let (true, Some(cell), Some(placed)) = (self.is_in_cell(), self.cell_picture(), self.placed()) else {
            return Some(part);
        };
        let moved = Bounds::around(part.corners().map(|c| placed.base_from_part * c))?;
        Some(moved.union(&cell.bounds(&placed.joints_deg, &placed.base_from_focus)))
    }
}
