//! The 3D scene of the moment, and stepping through the plan.

use super::App;
use super::command::Command;
use super::derived::Derived;
use super::session::{Session, Show};
use crate::beam::Work;
use crate::picture::{PartLook, PathLook, paths, section};
use crate::pose::{State, Target};
use crate::view::{Camera, LineItem, MeshItem, PointItem, Projection, Scene};
use eframe::egui;
use nalgebra::{Isometry3, Vector3};
use std::sync::Arc;

/// Lines of the paths, and what they were made from: plan, defocus and look.
pub(super) struct PathLines {
    of: (u64, PathLook),
    lines: Vec<LineItem>,
}

impl App {
    /// What is shown of paths.
    pub(super) fn path_look(&self, show: &Show) -> PathLook {
        let size = self.derived.part.as_ref().map_or(100.0, |p| p.mesh.diagonal());
        PathLook {
            // Where the spacing is shown its dots stand for the lines.
            lines: show.lines && !show.spacing,
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
        let look = self.path_look(&s.show);
        if s.show.section
            && let Some(of) = d.plan_on_part()
        {
            // Before and after at once, as P1 Fig. 8 sets them side by side.
            scene.lines = section::section(part, &d.surfaces, &of.plan, s.at.0, &look, of.picture_key());
        } else {
            let place = self.scene_from_part();
            let dose = self.dose_picture();
            let part = dose.unwrap_or_else(|| picture.item(&d.surfaces, &part_look(d, s, self.clean_list())));
            scene.meshes.push(MeshItem { scene_from_item: place, ..part });
            let laid = d.laid.as_ref().map(|(_, lines)| lines);
            if let Some(lines) = laid.filter(|_| look.lines) {
                scene.lines.push(LineItem { scene_from_item: place, ..lines.clone() });
            }
            if let Some(of) = d.plan_on_part().filter(|_| laid.is_none()) {
                let known = (of.picture_key(), look.clone());
                if self.path_lines.as_ref().is_none_or(|l| l.of != known) {
                    let lines = paths::paths(&of.plan, &look, of.picture_key());
                    self.path_lines = Some(PathLines { of: known, lines });
                }
                let lines = self.path_lines.iter().flat_map(|l| &l.lines);
                scene.lines.extend(lines.map(|l| LineItem { scene_from_item: place, ..l.clone() }));
            }
            scene.lines.extend(self.border_lines().iter().map(|l| LineItem { scene_from_item: place, ..l.clone() }));
            let dots = self.spacing_points().iter();
            scene.points.extend(dots.map(|d| PointItem { scene_from_item: place, ..d.clone() }));
            self.add_simulation(&mut scene, place);
            self.add_tool(&mut scene, place);
            scene.points.extend(self.proposed_points(place));
        }
        let on_part = self.derived.plan_on_part().filter(|_| self.derived.laid.is_none());
        if let (Some(of), Some(t)) = (on_part, self.target()) {
            let (line, point) = paths::marked(t, self.work().defocus_mm, &look, of.picture_key());
            let scene_from_item = self.scene_from_part();
            scene.lines.push(LineItem { scene_from_item, ..line });
            scene.points.push(PointItem { scene_from_item, ..point });
        }
        Arc::new(scene)
    }

    /// What has been done, and in the robot cell who does it.
    fn add_simulation(&self, scene: &mut Scene, place: Isometry3<f64>) {
        let trail = self.derived.motion().and_then(|m| m.trail.as_ref());
        if let (Some(moment), Some(trail), Some(_)) = (self.moment(), trail, self.derived.plan_on_part()) {
            scene.lines.extend(trail.until(&moment, place));
        }
        let (true, Some(cell), Some(placed)) = (self.is_in_cell(), self.cell_picture(), self.placed()) else { return };
        scene.lines.push(cell.floor());
        scene.meshes.extend(cell.solids(&placed.joints_deg, placed.base_from_focus));
        let length_mm = self.beam_mm(&placed, cell.tip_mm());
        let (cone, line, spot) = cell.beam(placed.base_from_focus, length_mm, placed.lit);
        scene.meshes.extend(cone);
        scene.lines.push(line);
        scene.points.extend(spot);
    }

    /// Head and beam at the current target, and what stands on the part.
    fn add_tool(&self, scene: &mut Scene, place: Isometry3<f64>) {
        let Some((_, tool)) = self.derived.tool_picture.as_ref().filter(|_| self.session.show.tool) else { return };
        scene.meshes.extend(tool.clamps(&place));
        if self.is_in_cell() {
            scene.meshes.extend(self.placed().map_or_else(Vec::new, |p| tool.at(&p.base_from_focus, p.lit)));
        } else if let Some(t) = self.target() {
            let focus = place * t.frame(self.work().defocus_mm);
            scene.meshes.extend(tool.at(&focus, t.state != State::Blocked));
        }
    }

    /// What the pass that is stepped to is worked with.
    pub(super) fn work(&self) -> Work {
        let pass = self.derived.plan().and_then(|of| of.plan.passes.get(self.session.at.0));
        pass.map_or_else(Work::default, |p| p.work)
    }

    /// The target that is stepped to.
    pub(super) fn target(&self) -> Option<&Target> {
        let (pass, point) = self.session.at;
        self.derived.plan()?.plan.passes.get(pass)?.targets.get(point)
    }

    pub(super) fn step(&mut self, command: Command) {
        let Some(plan) = self.derived.plan().map(|of| &of.plan) else { return };
        let (mut pass, mut point) = self.session.at;
        let count = |p: usize| plan.passes.get(p).map_or(0, |x| x.targets.len());
        let last_pass = plan.passes.len().saturating_sub(1);
        match command {
            Command::Play => {
                self.session.playing = !self.session.playing;
                self.session.play_clock_s = 0.0;
                let ended = self.timeline().is_some_and(|t| self.session.time_s >= t.total_s());
                if self.session.playing && ended {
                    self.go_to_time(0.0);
                }
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
        if !matches!(command, Command::Play) {
            self.go_to_target((pass, point));
        }
    }

    /// Moves on while playing, at the speed of the spot.
    pub(super) fn advance_playback(&mut self, ctx: &egui::Context) {
        let Some(of) = self.derived.plan().cloned().filter(|_| self.session.playing) else { return };
        let plan = &of.plan;
        ctx.request_repaint();
        if self.timeline().is_some() {
            self.advance_time(ctx);
            return;
        }
        let speed = self.work().speed_mm_s;
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
    }

    /// Turns the camera onto the section plane of the current pass.
    pub(super) fn look_along_section(&mut self) {
        let Some(of) = self.derived.plan() else { return };
        let Some(pass) = of.plan.passes.get(self.session.at.0) else { return };
        let part = &of.part;
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
    let missed = d
        .plan_on_part()
        .into_iter()
        .flat_map(|of| &of.plan.surfaces)
        .flat_map(|p| p.laid.coverage.missed_facets.iter().copied());
    PartLook {
        chosen,
        selected: s.selected.clone(),
        hovered: s.hovered,
        hidden: s.hidden.clone(),
        hide_chosen: s.show.hide_chosen,
        plain: s.show.plain || s.show.spacing,
        missed: Arc::new(missed.collect()),
    }
}
