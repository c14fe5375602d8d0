//! *Bead*: what the beam lays, for the job and for a recipe: its size and layers, the section that comes of it,
//! and P3's way between a bead's size and the distance of centres, both ways.

use super::super::{App, theme};
use super::bead_section::bead_section;
use super::fields::{self, Change, Owner, SPACING, back, name};
use super::recipe;
use crate::document::parameter::Group;
use crate::document::{Edit, Job, Parameter, Recipe};
use crate::process::bead::Bead;
use crate::text::{exact, fixed, say};
use eframe::egui::{self, CollapsingHeader, RichText, Role, WidgetInfo};

const WIDTH: &Parameter = Parameter::named("bead.width_mm");
const HEIGHT: &Parameter = Parameter::named("bead.height_mm");
const LAYERS: &Parameter = Parameter::named("bead.layers");
/// The least width and height that are set here, mm; none at all is the checkbox's.
const LEAST_MM: f64 = 0.01;
/// From this share on another distance of centres than that of the bead is worth a word.
const OTHER_SPACING: f64 = 0.005;

impl App {
    /// The job's bead; open where there is one.
    pub(super) fn bead(&mut self, ui: &mut egui::Ui) {
        let job = self.document.job().clone();
        header(Owner::Job, &job).show(ui, |ui| {
            if let Some(Change::To(on)) = laid(ui, Owner::Job, &job, None) {
                self.edit(Edit::Bead(job.bead.with_bead(on, job.beam.spot_mm)));
            }
            if job.section_of_bead().is_none() {
                return;
            }
            for p in Parameter::of_group(Group::BeadSize) {
                if let Some(Change::To(mm)) = fields::number_from(ui, Owner::Job, p, LEAST_MM, job.number(p), None) {
                    self.set_parameter(p, mm);
                }
            }
            self.numbers(ui, Group::BeadLayers);
            ui.horizontal(|ui| {
                name(ui, &say!(bead_panel_second), job.bead.alternate);
                let mut alternate = job.bead.alternate;
                let check = ui.checkbox(&mut alternate, say!(bead_panel_across));
                if check.on_hover_text(say!(bead_panel_across_tip)).changed() {
                    self.edit(Edit::Bead(crate::document::model::BeadParameters { alternate, ..job.bead.clone() }));
                }
            });
            bead_section(ui, Owner::Job, &job);
            if let Some((key, mm)) = fill(ui, Owner::Job, &job) {
                self.edit(Edit::Set(key, mm));
            }
        });
    }
}

/// The bead of a recipe; `own`: the job with it. Changes it, and says what was changed.
pub(super) fn of_recipe(ui: &mut egui::Ui, job: &Job, own: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let mut what = None;
    header(Owner::Recipe, own).show(ui, |ui| {
        let is_own = Parameter::of_group(Group::BeadSize).any(|p| recipe.values.contains_key(p.key));
        match laid(ui, Owner::Recipe, own, is_own.then_some(job)) {
            Some(Change::To(on)) => {
                let with = Job { bead: own.bead.with_bead(on, own.beam.spot_mm), ..own.clone() };
                for p in Parameter::of_group(Group::BeadSize) {
                    recipe.values.insert(p.key.into(), with.number(p));
                }
                // No layers of nothing, the job's among them.
                if with.bead.layers != own.bead.layers {
                    recipe.values.insert(LAYERS.key.into(), with.number(LAYERS));
                }
                what = Some("recipe bead");
            }
            Some(Change::Back) => {
                for p in Parameter::of_group(Group::BeadSize) {
                    recipe.values.remove(p.key);
                }
                if job.section_of_bead().is_none() {
                    recipe.values.remove(LAYERS.key);
                }
                what = Some("recipe bead");
            }
            None => {}
        }
        if own.section_of_bead().is_none() {
            return;
        }
        for p in Parameter::of_group(Group::BeadSize) {
            // To half a bead there is no way back.
            let can_go_back = recipe.values.contains_key(p.key) && job.section_of_bead().is_some();
            let to = can_go_back.then(|| job.number(p));
            match fields::number_from(ui, Owner::Recipe, p, LEAST_MM, own.number(p), to) {
                Some(Change::To(mm)) => recipe.values.insert(p.key.into(), mm),
                Some(Change::Back) => recipe.values.remove(p.key),
                None => continue,
            };
            what = Some(p.key);
        }
        for p in Parameter::of_group(Group::BeadLayers) {
            what = recipe::number(ui, job, own, recipe, p).or(what);
        }
        bead_section(ui, Owner::Recipe, own);
        if let Some((key, mm)) = fill(ui, Owner::Recipe, own) {
            recipe.values.insert(key.into(), mm);
            what = Some("recipe bead");
        }
    });
    what
}

/// The group, closed where nothing is laid, and open once something is.
fn header(owner: Owner, job: &Job) -> CollapsingHeader {
    let bead = &job.bead;
    let is_laid = job.section_of_bead().is_some();
    let (width, height) = (exact(bead.width_mm), exact(bead.height_mm));
    let title = match job.layer_count() {
        _ if !is_laid => say!(bead_panel_none),
        1 => say!(bead_panel_one_layer, width, height),
        layers => say!(bead_panel_layers, width, height, layers),
    };
    CollapsingHeader::new(title).id_salt((owner, "bead", is_laid)).default_open(is_laid)
}

/// Whether a bead is laid; `to`: the job that a recipe can go back to in this.
fn laid(ui: &mut egui::Ui, owner: Owner, job: &Job, to: Option<&Job>) -> Option<Change<bool>> {
    let now = job.section_of_bead().is_some();
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, &say!(bead_panel_metal), to.is_some());
        let mut on = now;
        let check = ui.checkbox(&mut on, say!(bead_panel_lay)).on_hover_text(say!(bead_panel_lay_tip));
        let told = || owner.told(say!(bead_panel_lay));
        check.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, on, told()));
        if check.changed() {
            wanted = Some(Change::To(on));
        }
        if let Some(to) = to {
            let bead = to.section_of_bead();
            let size = |b: Bead| say!(bead_panel_size, width = exact(b.width_mm()), height = exact(b.height_mm()));
            let said = bead.map_or_else(|| say!(bead_panel_back_none), size);
            if back(ui, owner, &say!(bead_panel_name), &said) {
                wanted = Some(Change::Back);
            }
        }
    });
    wanted
}

/// What is changed so that beads fill their layer.
#[derive(Clone, Copy)]
enum Measure {
    Spacing,
    Height,
    Width,
}

impl Measure {
    /// Text, name and tip of the button that sets it.
    fn words(self, mm: f64) -> [String; 3] {
        let mm = &fixed(mm, 2);
        match self {
            Measure::Spacing => {
                [say!(bead_panel_spacing, mm), say!(bead_panel_take_spacing, mm), say!(bead_panel_spacing_tip)]
            }
            Measure::Height => {
                [say!(bead_panel_height, mm), say!(bead_panel_take_height, mm), say!(bead_panel_height_tip)]
            }
            Measure::Width => [say!(bead_panel_width, mm), say!(bead_panel_take_width, mm), say!(bead_panel_width_tip)],
        }
    }
}

/// How the layer comes out at the spacing that is set, and what would fill it: key and value of what is taken.
fn fill(ui: &mut egui::Ui, owner: Owner, job: &Job) -> Option<(&'static str, f64)> {
    let bead = job.section_of_bead()?;
    let (spacing_mm, own_mm) = (job.layers.spacing_mm, bead.spacing_mm());
    if (spacing_mm / own_mm - 1.0).abs() <= OTHER_SPACING {
        ui.label(RichText::new(say!(bead_panel_filled)).small());
        return None;
    }
    let mean_mm = bead.area_mm2() / spacing_mm;
    let text = say!(bead_panel_not_filled, mean = fixed(mean_mm, 2), planned = fixed(bead.height_mm(), 2));
    ui.label(RichText::new(text).color(theme::ATTENTION));
    let ways = [
        (Measure::Spacing, SPACING, Some(own_mm)),
        (Measure::Height, HEIGHT, Bead::of_width(bead.width_mm(), spacing_mm).map(|b| b.height_mm())),
        (Measure::Width, WIDTH, Bead::of_height(bead.height_mm(), spacing_mm).map(|b| b.width_mm())),
    ];
    let mut taken = None;
    ui.horizontal_wrapped(|ui| {
        for (measure, p, mm) in ways {
            // A micrometre is more than anybody can set.
            let mm = mm.map(|mm| (mm * 1e3).round() / 1e3);
            let may = |mm: &f64| *mm >= LEAST_MM && p.check(*mm).is_ok();
            let Some(mm) = mm.filter(may) else { continue };
            let [text, told, tip] = measure.words(mm);
            let button = ui.button(text).on_hover_text(tip);
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, owner.told(told.clone())));
            if button.clicked() {
                taken = Some((p.key, mm));
            }
        }
    });
    taken
}
