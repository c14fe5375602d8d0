//! The motion as curves over time: joints within their limits, their speeds, the pose of the flange,
//! the distance from a singular pose and from what stands in the cell. A cursor is where the
//! simulation is; a drag moves both.

use super::super::App;
use super::super::clearance::ClearanceCurve;
use crate::cell::collision::CLEARANCE_REACH_MM;
use crate::program::{Clearance, CurveSample, Timeline};
use crate::text::{Sentence as _, exact, fixed, id, say};
use eframe::egui::{self, Color32, RichText, vec2};
use egui_plot::{HLine, Line, LineStyle, Plot, PlotBounds, PlotUi, VLine};

/// Six colours that colour-blind people tell apart (after Okabe and Ito).
const COLORS: [Color32; 6] = [
    Color32::from_rgb(46, 134, 222),
    Color32::from_rgb(230, 159, 0),
    Color32::from_rgb(0, 158, 115),
    Color32::from_rgb(204, 121, 167),
    Color32::from_rgb(86, 190, 233),
    Color32::from_rgb(213, 94, 0),
];
/// Of more samples than this in sight, least and greatest of each group are drawn.
const MOST_POINTS: usize = 1200;
/// The shortest stretch that can be looked at, s.
const SHORTEST_S: f64 = 0.05;

/// What a curve runs over.
trait Timed {
    fn time_s(&self) -> f64;
}

impl Timed for CurveSample {
    fn time_s(&self) -> f64 {
        self.time_s
    }
}

impl Timed for Clearance {
    fn time_s(&self) -> f64 {
        self.time_s
    }
}

/// One diagram over samples.
struct Diagram<'a, T> {
    /// Tells it apart from the others.
    key: &'static str,
    /// For who cannot see it.
    name: String,
    title: String,
    curves: Vec<Curve<'a, T>>,
    /// Said behind the numbers of the curves.
    words: Option<fn(&T) -> String>,
    /// Where it must not go: value and colour.
    bounds: Vec<(f64, Color32)>,
    decimals: usize,
    /// Least height of the scale.
    least: f64,
}

struct Curve<'a, T> {
    name: String,
    color: Color32,
    value: Box<dyn Fn(&T) -> f64 + 'a>,
}

impl<T> Diagram<'_, T> {
    /// Its share of the width: room for the numbers of its curves, and for words.
    fn share(&self) -> f32 {
        3.0 + self.curves.len() as f32 + if self.words.is_some() { 2.0 } else { 0.0 }
    }
}

impl App {
    pub(in super::super) fn plots(&mut self, ui: &mut egui::Ui) {
        let Some(motion) = self.derived.motion().cloned() else { return };
        let Some(timeline) = &motion.timeline else { return };
        let samples = &motion.curves;
        let span = self.plot_span(timeline.total_s());
        let list = diagrams(timeline, samples);
        let clearance = self.clearance().cloned();
        let last = clearance_diagram(clearance.as_deref());
        let whole = ui.available_width() - list.len() as f32 * ui.spacing().item_spacing.x;
        let width = whole / (list.iter().map(Diagram::share).sum::<f32>() + last.share());
        ui.horizontal_top(|ui| {
            for d in &list {
                self.beside(ui, d, samples, width, span, timeline.total_s());
            }
            let looked_at = clearance.as_ref().map_or(&[][..], |c| &c.samples);
            self.beside(ui, &last, looked_at, width, span, timeline.total_s());
        });
    }

    /// A diagram beside the others, so many times as wide as its share.
    fn beside<T: Timed>(
        &mut self,
        ui: &mut egui::Ui,
        d: &Diagram<'_, T>,
        samples: &[T],
        width: f32,
        span: [f64; 2],
        total_s: f64,
    ) {
        let size = vec2(width * d.share(), ui.available_height());
        ui.allocate_ui(size, |ui| {
            ui.set_width(size.x);
            ui.vertical(|ui| self.diagram(ui, d, samples, span, total_s));
        });
    }

    /// The stretch of time in sight; while playing it follows.
    fn plot_span(&mut self, total_s: f64) -> [f64; 2] {
        let time_s = self.session.playback.time_s;
        if let Some([from, to]) = &mut self.session.plot_span
            && self.session.playback.is_playing
            && !(*from..=*to).contains(&time_s)
        {
            (*from, *to) = (time_s, time_s + (*to - *from));
        }
        self.session.plot_span.unwrap_or([0.0, total_s.max(SHORTEST_S)])
    }

    fn diagram<T: Timed>(
        &mut self,
        ui: &mut egui::Ui,
        d: &Diagram<'_, T>,
        samples: &[T],
        span: [f64; 2],
        total_s: f64,
    ) {
        ui.add(egui::Label::new(RichText::new(&d.title).strong()).truncate());
        let time_s = self.session.playback.time_s;
        let now = samples.get(samples.partition_point(|s| s.time_s() < time_s)).or(samples.last());
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 5.0;
            let small = |text: String| RichText::new(text).small().monospace();
            for c in &d.curves {
                let value = now.map_or(0.0, |s| (c.value)(s));
                let decimals = if value.abs() < 100.0 { d.decimals } else { 0 };
                let text = format!("{} {}", c.name, fixed(value, decimals));
                ui.add(egui::Label::new(small(text).color(c.color)).selectable(false));
            }
            if let (Some(now), Some(words)) = (now, d.words) {
                ui.add(egui::Label::new(small(words(now))).selectable(false).truncate());
            }
        });
        let lines: Vec<Vec<[f64; 2]>> = d.curves.iter().map(|c| thinned(samples, span, &c.value)).collect();
        let range = range(&lines, d.least);
        let cursor = ui.visuals().strong_text_color();
        let plot = Plot::new(d.key)
            .allow_drag(false)
            .allow_zoom(false)
            .allow_scroll(false)
            .allow_boxed_zoom(false)
            .allow_axis_zoom_drag(false)
            .allow_double_click_reset(false)
            .show_crosshair(false)
            .label_formatter(|_| None)
            .y_axis_min_width(34.0)
            .x_axis_formatter(|mark, _| say!(plots_seconds, value = exact(mark.value)));
        let shown = plot.show(ui, |p: &mut PlotUi<'_>| {
            p.set_plot_bounds(PlotBounds::from_min_max([span[0], range[0]], [span[1], range[1]]));
            for (value, color) in d.bounds.iter().filter(|(v, _)| (range[0]..=range[1]).contains(v)) {
                p.hline(HLine::new("limit", *value).color(*color).style(LineStyle::dashed_dense()).allow_hover(false));
            }
            for (c, points) in d.curves.iter().zip(lines) {
                // An angle that goes on from 180° at −180° is no stroke from top to bottom.
                for piece in points.chunk_by(|a, b| (a[1] - b[1]).abs() < 180.0) {
                    p.line(Line::new(c.name.as_str(), piece.to_vec()).color(c.color).width(1.6).allow_hover(false));
                }
            }
            p.vline(VLine::new("now", time_s).color(cursor).width(1.5).allow_hover(false));
            p.pointer_coordinate().map(|at| at.x)
        });
        let response = shown.response;
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, &d.name));
        let Some(x) = shown.inner else { return };
        if response.dragged() || response.clicked() {
            self.go_to_time(x);
        }
        let wheel = ui.input(|i| i.smooth_scroll_delta().y);
        if response.double_clicked() {
            self.session.plot_span = None;
        } else if response.hovered() && wheel != 0.0 {
            self.session.plot_span = zoomed(span, x, libm::exp(-0.0035 * f64::from(wheel)), total_s);
        }
    }
}

/// A stretch scaled about a time, within the program; `None` for all of it.
fn zoomed([from, to]: [f64; 2], about_s: f64, factor: f64, total_s: f64) -> Option<[f64; 2]> {
    let length = ((to - from) * factor).max(SHORTEST_S);
    if length >= total_s {
        return None;
    }
    let share = ((about_s - from) / (to - from)).clamp(0.0, 1.0);
    let from = (about_s - share * length).clamp(0.0, total_s - length);
    Some([from, from + length])
}

/// P2's Fig. 16, and what limits it.
fn diagrams<'a>(timeline: &'a Timeline, samples: &[CurveSample]) -> Vec<Diagram<'a, CurveSample>> {
    let robot = timeline.robot();
    let six = |value: fn(&'a crate::cell::Robot, &CurveSample, usize) -> f64| -> Vec<Curve<'a, CurveSample>> {
        (0..6)
            .map(|i| Curve { name: joint(i), color: COLORS[i], value: Box::new(move |s| value(robot, s, i)) })
            .collect()
    };
    let margin_deg = samples.iter().map(|s| s.limit_margin_deg).fold(f64::INFINITY, f64::min);
    let (peak, which) = (0..6)
        .map(|i| (samples.iter().map(|s| share_of_full(robot, s, i).abs()).fold(0.0, f64::max), i))
        .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
    let singular = samples.iter().map(|s| s.singularity).fold(f64::INFINITY, f64::min);
    let limits = robot.limits_deg.iter().zip(COLORS).flat_map(|(l, color)| l.map(|deg| (deg, color)));
    let red = super::super::theme::WRONG;
    vec![
        Diagram {
            key: "joints",
            name: say!(plots_joints_name),
            title: say!(plots_joints, margin = fixed(margin_deg, 1)),
            curves: six(|_, s, i| s.joints_deg[i]),
            words: None,
            bounds: limits.collect(),
            decimals: 1,
            least: 10.0,
        },
        Diagram {
            key: "joint speeds",
            name: say!(plots_speeds_name),
            title: say!(plots_speeds, percent = fixed(peak, 0), joint = joint(which)),
            curves: six(share_of_full),
            words: None,
            bounds: vec![(100.0, red), (-100.0, red)],
            decimals: 0,
            least: 10.0,
        },
        Diagram {
            key: "flange angles",
            name: say!(plots_angles_name),
            title: say!(plots_angles),
            curves: vec![turn("RZ", 0, COLORS[0]), turn("RY", 1, COLORS[2]), turn("RX", 2, COLORS[5])],
            words: None,
            bounds: Vec::new(),
            decimals: 1,
            least: 10.0,
        },
        Diagram {
            key: "singularity",
            name: say!(plots_singularity_name),
            title: say!(plots_singularity, distance = fixed(singular, 2)),
            curves: vec![Curve { name: say!(plots_distance), color: COLORS[1], value: Box::new(|s| s.singularity) }],
            words: None,
            bounds: vec![(0.0, red)],
            decimals: 2,
            least: 0.2,
        },
    ]
}

/// How near anything comes to anything else; without a curve that is being looked at.
fn clearance_diagram(curve: Option<&ClearanceCurve>) -> Diagram<'static, Clearance> {
    let nearest = curve.iter().flat_map(|c| &c.samples).filter_map(|s| s.nearest.as_ref());
    let least = nearest.min_by(|a, b| a.0.total_cmp(&b.0));
    let title = match (curve, least) {
        (None, _) => say!(plots_clearance_none),
        (_, None) => say!(plots_clearance_beyond, reach = fixed(CLEARANCE_REACH_MM, 0)),
        (_, Some((mm, pair))) => say!(plots_clearance, least = fixed(*mm, 1), pair = pair.sentence()),
    };
    let mm = |s: &Clearance| s.nearest.as_ref().map_or(CLEARANCE_REACH_MM, |n| n.0);
    let words: fn(&Clearance) -> String = |s| match &s.nearest {
        Some((_, pair)) => pair.sentence(),
        None => say!(plots_or_more),
    };
    Diagram {
        key: "clearance",
        name: say!(plots_clearance_name),
        title,
        curves: vec![Curve { name: say!(plots_nearest), color: COLORS[2], value: Box::new(mm) }],
        words: Some(words),
        bounds: vec![(curve.map_or(0.0, |c| c.margin_mm), super::super::theme::WRONG)],
        decimals: 1,
        least: 10.0,
    }
}

/// One of the three angles of the flange, by its place among them.
fn turn(name: &str, place: usize, color: Color32) -> Curve<'static, CurveSample> {
    Curve { name: name.into(), color, value: Box::new(move |s| s.rz_ry_rx_deg[place]) }
}

/// Name of a joint, counted from 0.
fn joint(index: usize) -> String {
    say!(plots_joint, joint = id(index + 1))
}

fn share_of_full(robot: &crate::cell::Robot, s: &CurveSample, joint: usize) -> f64 {
    100.0 * s.speeds_deg_s[joint] / robot.speeds_deg_s[joint]
}

/// The scale of a diagram: its curves with some room, at least so high.
fn range(lines: &[Vec<[f64; 2]>], least: f64) -> [f64; 2] {
    let values = || lines.iter().flatten().map(|p| p[1]);
    let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    if low > high {
        return [0.0, least];
    }
    let room = (0.08 * (high - low)).max(0.5 * (least - (high - low))).max(0.04 * least);
    [low - room, high + room]
}

/// The samples in sight, one beyond each end; of many, what stands out.
fn thinned<T: Timed>(samples: &[T], [from, to]: [f64; 2], value: &dyn Fn(&T) -> f64) -> Vec<[f64; 2]> {
    let first = samples.partition_point(|s| s.time_s() < from).saturating_sub(1);
    let end = (samples.partition_point(|s| s.time_s() <= to) + 1).min(samples.len());
    let seen = samples.get(first..end).unwrap_or_default();
    let point = |s: &T| [s.time_s(), value(s)];
    if seen.len() <= MOST_POINTS {
        return seen.iter().map(point).collect();
    }
    let group = seen.len().div_ceil(MOST_POINTS / 2);
    let mut out = Vec::with_capacity(MOST_POINTS + 2);
    for chunk in seen.chunks(group) {
        let points = || chunk.iter().map(point);
        let (low, high) =
            (points().min_by(|a, b| a[1].total_cmp(&b[1])), points().max_by(|a, b| a[1].total_cmp(&b[1])));
        let mut pair: Vec<[f64; 2]> = low.into_iter().chain(high).collect();
        pair.sort_by(|a, b| a[0].total_cmp(&b[0]));
        out.extend(pair);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(time_s: f64, singularity: f64) -> CurveSample {
        CurveSample {
            time_s,
            joints_deg: [0.0; 6],
            speeds_deg_s: [0.0; 6],
            limit_margin_deg: 0.0,
            singularity,
            rz_ry_rx_deg: [0.0; 3],
        }
    }

    #[test]
    fn a_peak_of_one_sample_survives_thinning() {
        let samples: Vec<CurveSample> =
            (0..50_000).map(|i| sample(f64::from(i) * 0.01, if i == 33_333 { 1.0 } else { 0.5 })).collect();
        let all = thinned(&samples, [0.0, 500.0], &|s| s.singularity);
        assert!(all.len() <= MOST_POINTS + 2 && all.contains(&[333.33, 1.0]), "{} points", all.len());
        assert!(all.windows(2).all(|w| w[0][0] <= w[1][0]), "in the order of time");
        let near = thinned(&samples, [1.0, 2.0], &|s| s.singularity);
        assert!(near.first().is_some_and(|p| p[0] < 1.0) && near.last().is_some_and(|p| p[0] > 2.0));
        assert!(near.len() <= 104, "only what is in sight: {}", near.len());
    }

    #[test]
    fn zooming_keeps_the_time_under_the_pointer_and_stays_within() {
        let [from, to] = zoomed([0.0, 100.0], 25.0, 0.5, 100.0).expect("a part of it");
        assert!((from - 12.5).abs() < 1e-9 && (to - 62.5).abs() < 1e-9);
        assert_eq!(zoomed([10.0, 60.0], 30.0, 4.0, 100.0), None, "all of it");
        let [from, to] = zoomed([90.0, 100.0], 99.0, 1e-9, 100.0).expect("the shortest");
        assert!((to - from - SHORTEST_S).abs() < 1e-9 && to <= 100.0 && from >= 0.0);
    }
}
