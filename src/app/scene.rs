//! Builds the 3D scene of each frame.

use super::App;
use super::context::Context;
use super::derived::Derived;
use super::session::{Coloring, Session};
use super::toggle::Toggle;
use crate::document::Job;
use crate::picture::dose::DoseLook;
use crate::picture::{PartLook, PathLook, paths, section};
use crate::pose::TargetState;
use crate::view::{Camera, LineItem, MeshItem, PointItem, Projection, Scene};
use nalgebra::{Isometry3, Vector3};
use std::sync::Arc;

/// Lines that are seen so far apart, px, have their full width.
const FULL_PX: f64 = 4.0;

/// Lines of the paths, and what they were made from: plan, defocus and look.
pub(super) struct PathLines {
    of: (u64, PathLook),
    lines: Vec<LineItem>,
}

impl App {
    /// Builds the scene of this frame.
    pub(super) fn build_scene(&mut self, dark: bool) -> Arc<Scene> {
        let mut scene = Scene::default();
        if !dark {
            (scene.background_top, scene.background_bottom) = ([232, 236, 242], [190, 198, 210]);
        }
        let d = &self.derived;
        let s = &self.session;
        let (Some(picture), Some(part)) = (&d.picture, &d.part) else { return Arc::new(scene) };
        if self.add_scan_tool(&mut scene) {
            return Arc::new(scene);
        }
        let look = self.context().path_look();
        if s.show.is_on(Toggle::SectionPlane)
            && let Some(of) = d.plan_on_part()
        {
            // Before and after at once, as P1 Fig. 8 sets them side by side.
            scene.lines = section::section(part, &d.surfaces, &of.plan, s.playback.at.0, &look, of.picture_key());
        } else {
            let place = self.context().scene_from_part();
            let look_of_part = part_look(d, s, self.context().clean_list(), self.tool.left_out());
            let part = picture.item(&d.surfaces, &look_of_part);
            let by_scan = self.scan.model().filter(|_| self.context().shows_deviation_on_model());
            let by_scan = by_scan.map(|model| MeshItem { edges: part.edges.clone(), ..model.clone() });
            let part = self.context().dose_picture().cloned().or(by_scan).unwrap_or(part);
            scene.cut = self.context().cut_of(part.geometry_key);
            // Edges of what is cut away would hang in the air.
            let edges = part.edges.clone().filter(|_| scene.cut.is_none());
            scene.meshes.push(MeshItem { scene_from_item: place, edges, ..part });
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
                let thinned = self.line_share(&of.job);
                let thin =
                    |l: &LineItem| LineItem { scene_from_item: place, width_px: l.width_px * thinned, ..l.clone() };
                scene.lines.extend(lines.map(thin));
            }
            scene.lines.extend(self.borders.lines().iter().map(|l| LineItem { scene_from_item: place, ..l.clone() }));
            let dots = self.context().spacing_picture().map_or(&[][..], |s| &s.dots).iter();
            scene.points.extend(dots.map(|d| PointItem { scene_from_item: place, ..d.clone() }));
            self.add_scan(&mut scene, place);
            self.add_weld(&mut scene, place);
            self.context().add_simulation(&mut scene, place);
            self.context().add_tool(&mut scene, place);
            self.context().add_better_setup(&mut scene, place);
        }
        let on_part = self.derived.plan_on_part().filter(|_| self.derived.laid.is_none());
        if let (Some(of), Some(t)) = (on_part, self.context().target()) {
            let (line, point) = paths::marked(t, self.context().process_settings().defocus_mm, &look, of.picture_key());
            let scene_from_item = self.context().scene_from_part();
            scene.lines.push(LineItem { scene_from_item, ..line });
            scene.points.push(PointItem { scene_from_item, ..point });
        }
        Arc::new(scene)
    }

    /// The share of their width at which lines are drawn: seen from afar they would run into each other.
    fn line_share(&self, job: &Job) -> f32 {
        let camera = &self.viewport.camera;
        let apart_px = self
            .viewport
            .size()
            .map_or(f64::INFINITY, |size| job.layers.spacing_mm * camera.px_per_mm(&camera.target, size));
        (apart_px / FULL_PX).clamp(0.35, 1.0) as f32
    }

    /// The points of the scan, unless the model shows what they tell, and the outlines of patches.
    fn add_scan(&self, scene: &mut Scene, place: Isometry3<f64>) {
        let show = &self.session.show;
        let on_model = self.context().shows_deviation_on_model();
        let points = show.is_on(Toggle::Scan) && !on_model;
        scene.clouds.extend(self.scan.items([points, show.is_on(Toggle::DroppedPoints)], &place));
        let outlines = self.scan.outlines().filter(|_| points || on_model);
        let section = self.section.line().filter(|_| show.is_on(Toggle::ScanSection));
        let lines = outlines.chain(section);
        scene.lines.extend(lines.map(|l| LineItem { scene_from_item: place, ..l.clone() }));
    }

    /// The points of beads by their height, their centre lines, and the camera.
    fn add_weld(&self, scene: &mut Scene, place: Isometry3<f64>) {
        if self.session.show.is_on(Toggle::WeldPoints) {
            scene.clouds.extend(self.weld.points(&place));
            scene.lines.extend(self.weld.lines().map(|l| LineItem { scene_from_item: place, ..l.clone() }));
        }
    }

    /// Turns the camera onto the section plane of the current pass.
    pub(super) fn look_along_section(&mut self) {
        let Some(of) = self.derived.plan() else { return };
        let Some(pass) = of.plan.passes.get(self.session.playback.at.0) else { return };
        let part = &of.part;
        let m = pass.plane_normal;
        let mut camera = self.viewport.camera;
        camera.projection = Projection::Parallel;
        (camera.yaw_rad, camera.pitch_rad) = angles_onto(&m, &camera);
        let (min, max) = part.mesh.bounds();
        camera.target = min + (max - min) * 0.5;
        self.viewport.glide_to(camera);
    }

    /// Shows all passes again, from where the camera was before.
    pub(super) fn leave_section(&mut self) {
        self.session.show.set(Toggle::SectionPlane, false);
        if let Some(camera) = self.session.camera_before_section.take() {
            self.viewport.glide_to(camera);
        }
    }
}

impl<'a> Context<'a> {
    /// The part coloured by dose or incidence, if that is asked for and known.
    fn dose_picture(self) -> Option<&'a MeshItem> {
        let look = match self.session.coloring {
            Coloring::Surface => return None,
            Coloring::Dose => DoseLook::Dose,
            Coloring::Incidence => DoseLook::Incidence,
        };
        Some(self.dose()?.picture(look))
    }

    /// Whether the part is shown by how far the scan is off it.
    pub fn shows_deviation_on_model(self) -> bool {
        self.session.show.is_on(Toggle::DeviationOnModel) && self.scan_is_laid()
    }

    /// Targets within reach and out of it, in a better set-up.
    fn add_better_setup(self, scene: &mut Scene, place: Isometry3<f64>) {
        // In the cell the part is small: dots must not hide it.
        let share = if self.is_in_cell() { 0.5 } else { 1.0 };
        scene.points.extend(self.better_setup().into_iter().flat_map(|p| p.points_at(place, share)));
    }

    /// What is shown of paths.
    pub fn path_look(self) -> PathLook {
        let size = self.derived.part.as_ref().map_or(100.0, |p| p.mesh.diagonal());
        PathLook {
            // Where the spacing is shown its dots stand for the lines, and the dose lies under them.
            lines: self.session.show.is_on(Toggle::PathLines)
                && !self.session.show.is_on(Toggle::Spacing)
                && self.session.coloring == Coloring::Surface,
            hidden: self.session.hidden_states,
            frames: self.session.show.is_on(Toggle::PoseFrames),
            beams: self.session.show.is_on(Toggle::Beams),
            air: self.session.show.is_on(Toggle::ConnectingMoves),
            before: self.session.show.is_on(Toggle::BeforeCorrection),
            only_pass: None,
            current_pass: self.current_pass_with_details(),
            done: self.going_on_from().unwrap_or(0),
            frame_mm: 0.014 * size,
        }
    }

    /// The current pass, where anything is shown of single passes: all lines are laid anew with it.
    fn current_pass_with_details(self) -> Option<usize> {
        let show = &self.session.show;
        let has_details = show.is_on(Toggle::PoseFrames) || show.is_on(Toggle::Beams);
        has_details.then_some(self.session.playback.at.0)
    }

    /// The trail of the spot, and in the robot cell the arm.
    fn add_simulation(self, scene: &mut Scene, place: Isometry3<f64>) {
        let trail = self.derived.playback_data().and_then(|m| m.trail.as_ref());
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
    fn add_tool(self, scene: &mut Scene, place: Isometry3<f64>) {
        let Some((_, tool)) =
            self.derived.tool_picture.as_ref().filter(|_| self.session.show.is_on(Toggle::ToolBodies))
        else {
            return;
        };
        scene.meshes.extend(tool.clamps(&place));
        if self.is_in_cell() {
            scene.meshes.extend(self.placed().map_or_else(Vec::new, |p| tool.at(&p.base_from_focus, p.lit)));
        } else if let Some(t) = self.target() {
            let focus = place * t.frame(self.process_settings().defocus_mm);
            scene.meshes.extend(tool.at(&focus, t.state != TargetState::Blocked));
        }
    }
}

/// Yaw and pitch of a camera that looks against `m`.
fn angles_onto(m: &Vector3<f64>, camera: &Camera) -> (f64, f64) {
    let pitch = libm::asin(m.z.clamp(-1.0, 1.0));
    let yaw = if libm::hypot(m.x, m.y) < 1e-6 { camera.yaw_rad } else { libm::atan2(m.x, -m.y) };
    (yaw, pitch)
}

fn part_look(d: &Derived, s: &Session, chosen: Vec<u32>, left_out: &Arc<Vec<u32>>) -> PartLook {
    let missed = d
        .plan_on_part()
        .into_iter()
        .flat_map(|of| &of.plan.surfaces)
        .flat_map(|p| p.toolpath.coverage.missed_facets.iter().copied());
    PartLook {
        chosen,
        selected: s.selected.clone(),
        hovered: s.hovered,
        hidden: s.hidden.clone(),
        hide_chosen: s.show.is_on(Toggle::HideChosen),
        plain: s.show.is_on(Toggle::PlainPart) || s.show.is_on(Toggle::Spacing),
        missed: Arc::new(missed.collect()),
        left_out: left_out.clone(),
    }
}
