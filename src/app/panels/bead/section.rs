//! The section of overlapping beads as a drawing to scale, with its measures drawn in and written below.

use super::super::super::theme;
use super::super::fields::Owner;
use crate::document::Job;
use crate::picture::beads::{BeadSection, section};
use crate::process::bead::Bead;
use crate::text::{fixed, say};
use eframe::egui::{
    self, Align2, Color32, FontId, Grid, Painter, Pos2, Rect, RichText, Role, Sense, Shape, Stroke, WidgetInfo, pos2,
    vec2,
};

/// Beads side by side.
const BEADS: usize = 3;
/// Layers that are drawn, at most.
const MOST_LAYERS: u32 = 4;
/// The beads fill so much at most, in points.
const MOST: egui::Vec2 = vec2(250.0, 130.0);
/// Room above the beads, of the ground beneath them, for a row of measures, and beside them, in points.
const ABOVE: f32 = 16.0;
const GROUND: f32 = 7.0;
const ROW: f32 = 15.0;
const BESIDE: f32 = 24.0;

/// Draws the section of a job's bead; nothing where none is laid.
pub(super) fn bead_section(ui: &mut egui::Ui, owner: Owner, job: &Job) {
    let Some(bead) = job.section_of_bead() else { return };
    let spacing_mm = job.layers.spacing_mm;
    let layers = job.layer_count().min(MOST_LAYERS);
    let drawn = section(&bead, BEADS, layers as usize, spacing_mm);
    let top_mm = f64::from(layers) * bead.height_mm();
    let wide_mm = width_mm(&drawn);
    let room = vec2((ui.available_width() - 2.0 * BESIDE).clamp(60.0, MOST.x), MOST.y);
    // One scale for both axes.
    let scale = (room.x / wide_mm as f32).min(room.y / top_mm as f32);
    let height = scale * top_mm as f32 + ABOVE + GROUND + 2.0 * ROW;
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let measures = Measures::new(job, &bead, &drawn);
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, owner.told(measures.told())));
    response.on_hover_text(say!(bead_section_tip));
    let foot = pos2(rect.center().x - 0.5 * scale * wide_mm as f32, rect.bottom() - GROUND - 2.0 * ROW);
    let sheet = Sheet { foot, scale, left_mm: drawn.ground.first().map_or(0.0, |p| p[0]) };
    paint(ui, &ui.painter_at(rect), &sheet, &drawn);
    measure(ui, &ui.painter_at(rect), &sheet, &bead, &drawn, spacing_mm);
    let grid = Grid::new((owner, "measures of the bead")).num_columns(4).striped(false).spacing([10.0, 2.0]);
    grid.show(ui, |ui| {
        for pair in measures.rows().chunks(2) {
            for (what, value) in pair {
                ui.label(what);
                ui.label(RichText::new(value).monospace());
            }
            ui.end_row();
        }
    });
    let count = job.layer_count();
    let remarks = [
        (layers < count).then(|| say!(bead_section_drawn, drawn = layers, layers = count)),
        job.bead.alternate.then(|| say!(bead_section_alternate)),
    ];
    for remark in remarks.into_iter().flatten() {
        ui.label(RichText::new(remark).small().weak());
    }
}

/// The measures as numbers that are read.
struct Measures {
    width: String,
    height: String,
    centres: String,
    overlap: String,
    ripple: String,
    build_up: String,
}

impl Measures {
    fn new(job: &Job, bead: &Bead, drawn: &BeadSection) -> Measures {
        Measures {
            width: fixed(bead.width_mm(), 2),
            height: fixed(bead.height_mm(), 2),
            centres: fixed(job.layers.spacing_mm, 2),
            overlap: fixed(job.overlap_percent(), 1),
            ripple: fixed(drawn.ripple_mm, 2),
            build_up: fixed(bead.height_mm() * f64::from(job.layer_count()), 2),
        }
    }

    /// All measures in a row, as the accessible text of the drawing.
    fn told(&self) -> String {
        let Measures { width, height, centres, overlap, ripple, build_up } = self;
        say!(bead_section_told, width, height, centres, overlap, ripple, build_up)
    }

    /// Names and values, two to a line.
    fn rows(&self) -> [(String, String); 6] {
        let mm = |value: &String| say!(bead_section_mm, value);
        [
            (say!(bead_section_width), mm(&self.width)),
            (say!(bead_section_height), mm(&self.height)),
            (say!(bead_section_centres), mm(&self.centres)),
            (say!(bead_section_overlap), say!(bead_section_percent, value = &self.overlap)),
            (say!(bead_section_ripple), mm(&self.ripple)),
            (say!(bead_section_build_up), mm(&self.build_up)),
        ]
    }
}

fn width_mm(drawn: &BeadSection) -> f64 {
    drawn.ground.last().zip(drawn.ground.first()).map_or(1.0, |(to, from)| to[0] - from[0])
}

/// Where millimetres of the section stand on the screen.
struct Sheet {
    /// The left end of the ground.
    foot: Pos2,
    /// Points per mm.
    scale: f32,
    left_mm: f64,
}

impl Sheet {
    fn at(&self, [y_mm, z_mm]: [f64; 2]) -> Pos2 {
        self.foot + vec2((y_mm - self.left_mm) as f32, -z_mm as f32) * self.scale
    }

    fn line(&self, points: &[[f64; 2]]) -> Vec<Pos2> {
        points.iter().map(|p| self.at(*p)).collect()
    }
}

fn paint(ui: &egui::Ui, painter: &Painter, sheet: &Sheet, drawn: &BeadSection) {
    let ink = ui.visuals().strong_text_color();
    let ends = sheet.line(&drawn.ground);
    if let [from, to] = ends[..] {
        let ground = Rect::from_min_max(from - vec2(8.0, 0.0), to + vec2(8.0, GROUND));
        painter.rect_filled(ground, 0, ui.visuals().weak_text_color().gamma_multiply(0.45));
        painter.line_segment([ground.left_top(), ground.right_top()], Stroke::new(1.2, ink));
    }
    let thin = Stroke::new(1.0, theme::ACCENT);
    for (k, arc) in drawn.arcs.iter().enumerate() {
        // What two beads share is darker; layers are told apart by it too.
        let strength = if (k / BEADS).is_multiple_of(2) { 0.34 } else { 0.5 };
        let points = sheet.line(arc);
        painter.add(Shape::convex_polygon(points.clone(), theme::ACCENT.gamma_multiply(strength), Stroke::NONE));
        painter.add(Shape::line(points, thin));
    }
    // Each layer on ground of its own.
    for arc in drawn.arcs.chunks(BEADS).skip(1).filter_map(|layer| layer.first()) {
        let z_mm = arc.first().map_or(0.0, |p| p[1]);
        let line = drawn.ground.iter().map(|p| sheet.at([p[0], z_mm])).collect();
        painter.add(Shape::line(line, Stroke::new(0.7, ui.visuals().weak_text_color())));
    }
    painter.add(Shape::line(sheet.line(&drawn.outline), Stroke::new(2.0, ink)));
}

/// Width and centres beneath the ground, height beside the beads, ripple in a valley.
fn measure(ui: &egui::Ui, painter: &Painter, sheet: &Sheet, bead: &Bead, drawn: &BeadSection, spacing_mm: f64) {
    let color = ui.visuals().text_color();
    let half_mm = 0.5 * bead.width_mm();
    let last_mm = (BEADS - 1) as f64 * spacing_mm;
    let below = sheet.foot.y + GROUND;
    let rows = [(last_mm - spacing_mm, last_mm, below + 0.5 * ROW, "c"), (-half_mm, half_mm, below + 1.5 * ROW, "ω")];
    for (from_mm, to_mm, y, letter) in rows {
        let (from, to) = (sheet.at([from_mm, 0.0]).x, sheet.at([to_mm, 0.0]).x);
        for x in [from, to] {
            let thin = Stroke::new(0.7, ui.visuals().weak_text_color());
            painter.line_segment([pos2(x, below - GROUND), pos2(x, y + 3.0)], thin);
        }
        dimension(ui, painter, [pos2(from, y), pos2(to, y)], letter, color);
    }
    let beside = sheet.at([sheet.left_mm + width_mm(drawn), 0.0]).x + 12.0;
    let (low, high) = (sheet.at([0.0, 0.0]).y, sheet.at([0.0, bead.height_mm()]).y);
    dimension(ui, painter, [pos2(beside, low), pos2(beside, high)], "h", color);
    let top_mm = drawn.outline.iter().map(|p| p[1]).fold(0.0, f64::max);
    let valley = [sheet.at([0.5 * spacing_mm, top_mm - drawn.ripple_mm]), sheet.at([0.5 * spacing_mm, top_mm])];
    // A ripple that cannot be seen has no place for a letter.
    if valley[0].y - valley[1].y > 4.0 {
        let stroke = Stroke::new(1.4, theme::ATTENTION);
        painter.line_segment(valley, stroke);
        let tops = [sheet.at([0.0, top_mm]), sheet.at([spacing_mm, top_mm])];
        painter.line_segment(tops, Stroke::new(0.7, stroke.color));
        painter.text(valley[1], Align2::CENTER_BOTTOM, "r", FontId::proportional(12.0), stroke.color);
    }
}

/// A line with ticks at its ends, its letter in the middle.
fn dimension(ui: &egui::Ui, painter: &Painter, [from, to]: [Pos2; 2], letter: &str, color: Color32) {
    let stroke = Stroke::new(1.0, color);
    painter.line_segment([from, to], stroke);
    let tick = if from.x == to.x { vec2(3.0, 0.0) } else { vec2(0.0, 3.0) };
    for end in [from, to] {
        painter.line_segment([end - tick, end + tick], stroke);
    }
    let galley = painter.layout_no_wrap(letter.to_owned(), FontId::proportional(12.0), color);
    let middle = Rect::from_center_size(from.lerp(to, 0.5), galley.size());
    painter.rect_filled(middle.expand2(vec2(2.0, 0.0)), 0, ui.visuals().panel_fill);
    painter.galley(middle.min, galley, color);
}
