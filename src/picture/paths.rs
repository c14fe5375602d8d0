//! Path lines, frames and beams (P1 Figs 7, 9, 13), and the moves between.

use super::palette::{Rgb, state};
use crate::beam::ProcessSettings;
use crate::part::Hasher;
use crate::planning::Plan;
use crate::planning::toolpath::Toolpath;
use crate::pose::{Pass, Target, TargetState};
use crate::program::Step;
use crate::view::{Depth, LineItem, LineSegment, PointItem};
use nalgebra::{Isometry3, Point3, Vector3};
use std::sync::Arc;

/// What is shown of a plan; nothing by default.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PathLook {
    /// Path lines.
    pub lines: bool,
    /// Frames at targets: x = beam axis, y = travel, z (P1 Fig. 13), in magenta, green and cyan.
    pub frames: bool,
    /// Beams from the part to the focus.
    pub beams: bool,
    /// Moves with the laser off.
    pub air: bool,
    /// Before correction: all beams along the normal, those that hit red.
    pub before: bool,
    /// Only this pass.
    pub only_pass: Option<usize>,
    /// The pass that is looked at: it has its frames and beams, of the others a few stand for all.
    pub current_pass: Option<usize>,
    /// So many passes, from the first on, are done: their lines are dimmed.
    pub done: usize,
    /// Whether what is free, corrected or blocked is left out.
    pub hidden: [bool; 3],
    /// Length of a frame's axes, mm.
    pub frame_mm: f64,
}

impl PathLook {
    /// Whether a line or beam of this colour is shown.
    fn shows(&self, line: &LineSegment) -> bool {
        let [r, g, b, _] = line.color;
        let states = [state::FREE, state::CORRECTED, state::BLOCKED];
        !states.iter().zip(self.hidden).any(|(of, hidden)| hidden && *of == [r, g, b])
    }
}

/// Frames and beams that are shown of a pass, at most; of more, every k-th.
const MOST_FRAMES: usize = 500;
const MOST_BEAMS: usize = 4000;
/// Frames and beams of all passes together, beside those of the current one: more hide the part.
const FRAMES_BESIDE: usize = 60;
const BEAMS_BESIDE: usize = 240;
/// Axes of frames, x, y and z: none is a colour of a state, nor of the triad in the corner.
const AXES: [Rgb; 3] = [[226, 72, 214], [64, 184, 92], [62, 196, 226]];

/// Draws a plan. `key` changes with the plan.
pub fn paths(plan: &Plan, look: &PathLook, key: u64) -> Vec<LineItem> {
    let item = |part: u32, segments: Vec<LineSegment>, width_px: f32| {
        let flags = [
            u32::from(look.before),
            look.only_pass.map_or(0, |p| p as u32 + 1),
            look.done as u32,
            part,
            look.current_pass.map_or(0, |p| p as u32 + 1),
            look.hidden.iter().enumerate().map(|(i, hidden)| u32::from(*hidden) << i).sum(),
        ];
        let key = Hasher::default().u32s(&[key as u32, (key >> 32) as u32]).u32s(&flags).f64s(&[look.frame_mm]);
        let (key, scene_from_item) = (key.finish().0 as u64, Isometry3::identity());
        LineItem { key, segments: Arc::new(segments), width_px, depth: Depth::Tested, scene_from_item }
    };
    let numbered = || plan.passes.iter().enumerate().filter(|(i, _)| look.only_pass.is_none_or(|p| p == *i));
    // Of the current pass as many as fit, and a few of all; of all that are shown where none is current.
    let current = look.current_pass.and_then(|pass| plan.passes.get(pass));
    let looked_at = |most: usize, beside: usize| {
        let others = if current.is_some() { beside } else { most };
        thinned(current, most, look.before).chain(thinned(numbered().map(|(_, p)| p), others, look.before))
    };
    let mut items = Vec::new();
    if look.lines {
        let lines = numbered().flat_map(|(i, p)| pass_lines(p, look.before, i < look.done));
        let lines = lines.filter(|line| look.shows(line));
        items.push(item(1, lines.collect(), 1.4));
    }
    if look.beams {
        let beams = looked_at(MOST_BEAMS, BEAMS_BESIDE).map(|(t, settings)| beam(t, settings.defocus_mm, look.before));
        items.push(item(2, beams.filter(|beam| look.shows(beam)).collect(), 1.2));
    }
    if look.frames {
        let frames =
            looked_at(MOST_FRAMES, FRAMES_BESIDE).flat_map(|(t, settings)| frame(t, settings.defocus_mm, look));
        items.push(item(3, frames.collect(), 1.6));
    }
    if look.air && look.only_pass.is_none() {
        items.push(item(4, air(plan), 1.0));
    }
    items
}

/// Draws lines that are laid, and not planned yet; `key` names them.
pub fn toolpath_item(lines: &[Arc<Toolpath>], key: u64) -> LineItem {
    let points = lines.iter().flat_map(|l| &l.lines);
    let segments: Vec<LineSegment> = points
        .flat_map(|line| {
            let closing = line.points.last().zip(line.points.first()).filter(|_| line.closed);
            line.points.windows(2).map(|w| (&w[0], &w[1])).chain(closing)
        })
        .map(|(a, b)| segment(a.p, b.p, state::LAID))
        .collect();
    let (depth, scene_from_item) = (Depth::Tested, Isometry3::identity());
    LineItem { key, segments: Arc::new(segments), width_px: 1.4, depth, scene_from_item }
}

/// Every k-th target; those that interfere are kept more densely.
fn thinned<'a>(
    passes: impl IntoIterator<Item = &'a Pass, IntoIter: Clone>,
    most: usize,
    before: bool,
) -> impl Iterator<Item = (&'a Target, &'a ProcessSettings)> {
    let passes = passes.into_iter();
    let count: usize = passes.clone().map(|p| p.targets.len()).sum();
    let every = count.div_ceil(most).max(1);
    passes
        .flat_map(|p| p.targets.iter().map(|t| (t, &p.settings)))
        .enumerate()
        .filter(move |(i, (t, _))| i % every == 0 || (every < 8 && before && t.normal_hits.is_some() && i % 2 == 0))
        .map(|(_, t)| t)
}

/// Colour of a target in a state, or before correction.
pub fn color(t: &Target, before: bool) -> Rgb {
    match (before, t.state) {
        (true, _) if t.normal_hits.is_some() => state::BLOCKED,
        (true, _) | (_, TargetState::Free) => state::FREE,
        (_, TargetState::Corrected) => state::CORRECTED,
        (_, TargetState::Blocked) => state::BLOCKED,
    }
}

fn segment(a: Point3<f64>, b: Point3<f64>, [r, g, blue]: Rgb) -> LineSegment {
    let f = |p: Point3<f64>| [p.x as f32, p.y as f32, p.z as f32];
    LineSegment { a: f(a), b: f(b), color: [r, g, blue, 255] }
}

fn pass_lines(pass: &Pass, before: bool, is_done: bool) -> impl Iterator<Item = LineSegment> {
    pass.targets.windows(2).map(move |w| {
        if is_done {
            return segment(w[0].p, w[1].p, state::DONE);
        }
        // A move takes the worse colour of its ends.
        let rank = |t: &Target| match color(t, before) {
            state::BLOCKED => 2,
            state::CORRECTED => 1,
            _ => 0,
        };
        let worse = if rank(&w[0]) > rank(&w[1]) { &w[0] } else { &w[1] };
        segment(w[0].p, w[1].p, color(worse, before))
    })
}

fn axis(t: &Target, before: bool) -> Vector3<f64> {
    if before { t.n } else { t.a }
}

fn beam(t: &Target, defocus_mm: f64, before: bool) -> LineSegment {
    segment(t.p, t.p + axis(t, before) * defocus_mm, color(t, before))
}

/// The frame as P1 draws it: x = beam axis, y = travel, z = x × y, at the focus.
fn frame(t: &Target, defocus_mm: f64, look: &PathLook) -> [LineSegment; 3] {
    let x = axis(t, look.before);
    let y = crate::pose::target::travel(&t.o, &x);
    let at = if look.beams { t.p + x * defocus_mm } else { t.p };
    let l = look.frame_mm;
    [segment(at, at + x * l, AXES[0]), segment(at, at + y * l, AXES[1]), segment(at, at + x.cross(&y) * l, AXES[2])]
}

fn air(plan: &Plan) -> Vec<LineSegment> {
    let mut out = Vec::new();
    let (mut at, mut lit) = (None, false);
    for step in &plan.steps.list {
        match step {
            Step::Laser(on) => lit = *on,
            Step::Go(go) => {
                if let (Some(from), false) = (at, lit) {
                    out.push(segment(from, go.to.x, state::AIR));
                }
                at = Some(go.to.x);
            }
            Step::Comment(_) | Step::Home { .. } | Step::Process(_) => {}
        }
    }
    out
}

/// One target with its beam and frame, on top of everything.
pub fn marked(t: &Target, defocus_mm: f64, look: &PathLook, key: u64) -> (LineItem, PointItem) {
    let look = PathLook { beams: false, frame_mm: 2.2 * look.frame_mm, ..look.clone() };
    let mut segments = vec![beam(t, defocus_mm, look.before)];
    segments.extend(frame(t, defocus_mm, &look));
    let numbers = [t.p.x, t.p.y, t.p.z, t.a.x, t.a.y, t.a.z, look.frame_mm, defocus_mm];
    let key = Hasher::default().u32s(&[key as u32, u32::from(look.before)]).f64s(&numbers).finish().0 as u64;
    let [r, g, b] = color(t, look.before);
    let scene_from_item = Isometry3::identity();
    let points = vec![([t.p.x as f32, t.p.y as f32, t.p.z as f32], [r, g, b, 255])];
    (
        LineItem { key, segments: Arc::new(segments), width_px: 3.5, depth: Depth::OnTop, scene_from_item },
        PointItem { key, points: Arc::new(points), size_px: 10.0, depth: Depth::OnTop, scene_from_item },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pass_of(count: u32) -> Pass {
        let target = |x: f64| Target {
            p: Point3::new(x, 0.0, 0.0),
            n: Vector3::z(),
            foot: Point3::new(x, 0.0, 0.0),
            a: Vector3::z(),
            o: Vector3::x(),
            state: TargetState::Free,
            laser: true,
            normal_hits: None,
            clearance_mm: None,
        };
        Pass {
            surface: 1,
            settings: ProcessSettings::default(),
            plane_normal: Vector3::y(),
            closed: false,
            targets: (0..count).map(|i| target(f64::from(i))).collect(),
            line_points: 2,
            dense_points: 2,
            chord_error_mm: 0.0,
            splits: Vec::new(),
        }
    }

    /// The pass that is looked at has its beams, and the others do not hide it.
    #[test]
    fn beams_of_the_current_pass_stand_out() {
        let plan = Plan { passes: vec![pass_of(100); 50], ..Plan::default() };
        let look =
            |current_pass| PathLook { beams: true, frames: true, current_pass, frame_mm: 1.0, ..PathLook::default() };
        let drawn =
            |current| paths(&plan, &look(current), 7).iter().map(|item| item.segments.len()).collect::<Vec<_>>();
        assert_eq!(drawn(None), [2500, 3 * 500], "every second, every tenth");
        assert_eq!(drawn(Some(3)), [100 + 239, 3 * (100 + 60)]);
        let keys = |current| paths(&plan, &look(current), 7).iter().map(|item| item.key).collect::<Vec<_>>();
        assert_ne!(keys(Some(3)), keys(Some(4)), "they are drawn anew");
    }

    #[test]
    fn lines_that_are_done_are_dimmed() {
        let pass = pass_of(2);
        let plan = Plan { passes: vec![pass; 3], ..Plan::default() };
        let look = |done| PathLook { lines: true, done, frame_mm: 1.0, ..PathLook::default() };
        let drawn = |done| {
            let item = paths(&plan, &look(done), 7).remove(0);
            let colors: Vec<Rgb> = item.segments.iter().map(|s| [s.color[0], s.color[1], s.color[2]]).collect();
            (item.key, colors)
        };
        assert_eq!(drawn(0).1, [state::FREE; 3]);
        assert_eq!(drawn(2).1, [state::DONE, state::DONE, state::FREE]);
        assert_ne!(drawn(0).0, drawn(2).0, "the lines are drawn anew");
    }
}
