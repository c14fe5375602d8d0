//! The 3D scene of the moment, and stepping through the plan.

use super::App;
use super::command::Command;
use super::derived::Derived;
use super::session::{Session, Show};
use crate::picture::{PartLook, PathLook, paths, section};
use crate::pose::Target;
use crate::view::{Camera, Projection, Scene};
use eframe::egui;
use nalgebra::Vector3;
use std::sync::Arc;

impl App {
    /// What is shown of paths.
    pub(super) fn path_look(&self, show: &Show) -> PathLook {
        let size = self.derived.part.as_ref().map_or(100.0, |p| p.mesh.diagonal());
        PathLook {
            lines: show.lines,
            frames: show.frames,
            beams: show.beams,
            air: show.air,
            before: show.before,
            only_pass: None,
            frame_mm: 0.014 * size,
        }
    }

    /// Builds the scene of this frame.
    pub(super) fn build_scene(&mut self, dark: bool) -> Arc<Scene> {
        let mut scene = Scene::default();
        if !dark {
            (scene.background_top, scene.background_bottom) = ([232, 236, 242], [190, 198, 210]);
        }
        let d = &self.derived;
        let s = &self.session;
        let (Some(picture), Some(part)) = (&d.picture, &d.part) else { return Arc::new(scene) };
        let defocus_mm = self.document.job().beam.defocus_mm;
        let look = self.path_look(&s.show);
        if s.show.section
            && let Some((plan, _)) = &d.plan
        {
            // Before and after at once, as P1 Fig. 8 sets them side by side.
            scene.lines = section::section(part, &d.surfaces, plan, s.at.0, defocus_mm, &look, d.plan_count);
        } else {
            scene.meshes.push(picture.item(&d.surfaces, &part_look(d, s, self.clean_list())));
            if let Some((plan, _)) = &d.plan {
                scene.lines = paths::paths(plan, defocus_mm, &look, d.plan_count);
            }
        }
        if let Some(t) = self.target() {
            let (line, point) = paths::marked(t, defocus_mm, &look, d.plan_count);
            scene.lines.push(line);
            scene.points.push(point);
        }
        Arc::new(scene)
    }

    /// The target that is stepped to.
    pub(super) fn target(&self) -> Option<&Target> {
        let (plan, _) = self.derived.plan.as_ref()?;
        let (pass, point) = self.session.at;
        plan.passes.get(pass)?.targets.get(point)
    }

    pub(super) fn step(&mut self, command: Command) {
        let Some((plan, _)) = self.derived.plan.clone() else { return };
        let (mut pass, mut point) = self.session.at;
        let count = |p: usize| plan.passes.get(p).map_or(0, |x| x.targets.len());
        let last_pass = plan.passes.len().saturating_sub(1);
        match command {
            Command::Play => {
                self.session.playing = !self.session.playing;
                self.session.play_clock_s = 0.0;
            }
            Command::NextPoint if point + 1 < count(pass) => point += 1,
            Command::NextPoint if pass < last_pass => (pass, point) = (pass + 1, 0),
            Command::LastPoint if point > 0 => point -= 1,
            Command::LastPoint if pass > 0 => (pass, point) = (pass - 1, count(pass - 1).saturating_sub(1)),
            Command::NextPass => (pass, point) = ((pass + 1).min(last_pass), 0),
            Command::LastPass => (pass, point) = (pass.saturating_sub(1), 0),
            Command::First => (pass, point) = (0, 0),
            Command::Last => (pass, point) = (last_pass, count(last_pass).saturating_sub(1)),
            _ => {}
        }
        self.session.at = (pass, point);
    }

    /// Moves on while playing, at the speed of the spot.
    pub(super) fn advance_playback(&mut self, ctx: &egui::Context) {
        let Some((plan, _)) = self.derived.plan.clone().filter(|_| self.session.playing) else { return };
        let speed = self.document.job().beam.speed_mm_s;
        self.session.play_clock_s += f64::from(ctx.input(|i| i.stable_dt).min(0.1) * self.session.play_speed);
        loop {
            let (pass, point) = self.session.at;
            let Some(p) = plan.passes.get(pass) else { break };
            let needed = match (p.targets.get(point), p.targets.get(point + 1)) {
                (Some(a), Some(b)) => (b.p - a.p).norm() / speed,
                _ => 0.3,
            };
            if self.session.play_clock_s < needed {
                break;
            }
            self.session.play_clock_s -= needed;
            self.step(Command::NextPoint);
            if self.session.at == (pass, point) {
                self.session.at = (0, 0);
                self.session.playing = self.session.play_loop;
                break;
            }
        }
        ctx.request_repaint();
    }

    /// Turns the camera onto the section plane of the current pass.
    pub(super) fn look_along_section(&mut self) {
        let Some((plan, _)) = &self.derived.plan else { return };
        let Some(pass) = plan.passes.get(self.session.at.0) else { return };
        let Some(part) = &self.derived.part else { return };
        let m = pass.plane_normal;
        let mut camera = self.viewport.camera;
        camera.projection = Projection::Parallel;
        (camera.yaw_rad, camera.pitch_rad) = angles_onto(&m, &camera);
        let (min, max) = part.mesh.bounds();
        camera.target = min + (max - min) * 0.5;
        self.viewport.glide_to(camera);
    }
}

/// Yaw and pitch of a camera that looks against `m`.
fn angles_onto(m: &Vector3<f64>, camera: &Camera) -> (f64, f64) {
    let pitch = libm::asin(m.z.clamp(-1.0, 1.0));
    let yaw = if libm::hypot(m.x, m.y) < 1e-6 { camera.yaw_rad } else { libm::atan2(m.x, -m.y) };
    (yaw, pitch)
}

fn part_look(d: &Derived, s: &Session, chosen: Vec<u32>) -> PartLook {
    let missed =
        d.plan.iter().flat_map(|(plan, _)| &plan.surfaces).flat_map(|p| p.coverage.missed_facets.iter().copied());
    PartLook {
        chosen,
        selected: s.selected.clone(),
        hovered: s.hovered,
        hidden: s.hidden.clone(),
        hide_chosen: s.show.hide_chosen,
        plain: s.show.plain,
        missed: Arc::new(missed.collect()),
    }
}
