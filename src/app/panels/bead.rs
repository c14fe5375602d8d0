//! *Bead*: what the beam lays, for the job and for a recipe: its size and layers, the section that comes of it,
//! and P3's way between a bead's size and the distance of centres, both ways.

use super::super::{App, theme};
use super::bead_section::bead_section;
use super::fields::{self, Change, JOB, Owner, RECIPE, SPACING, back, name};
use super::recipe;
use crate::document::parameter::Group;
use crate::document::{Edit, Job, Parameter, Recipe};
use crate::process::bead::Bead;
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
        header(JOB, &job).show(ui, |ui| {
            if let Some(Change::To(on)) = laid(ui, JOB, &job, None) {
                self.edit(Edit::Bead(job.bead.laid(on, job.beam.spot_mm)));
            }
            if job.section_of_bead().is_none() {
                return;
            }
            for p in Parameter::of_group(Group::BeadSize) {
                if let Some(Change::To(mm)) = fields::number_from(ui, JOB, p, LEAST_MM, job.number(p), None) {
                    self.set_parameter(p, mm);
                }
            }
            self.numbers(ui, Group::BeadLayers);
            ui.horizontal(|ui| {
                name(ui, "Every second layer", job.bead.alternate);
                let mut alternate = job.bead.alternate;
                let tip = "Its planes are turned by 90°; offset lines and spirals run alike in all layers";
                if ui.checkbox(&mut alternate, "across the others").on_hover_text(tip).changed() {
                    self.edit(Edit::Bead(crate::document::model::BeadParameters { alternate, ..job.bead.clone() }));
                }
            });
            bead_section(ui, JOB, &job);
            if let Some((key, mm)) = fill(ui, JOB, &job) {
                self.edit(Edit::Set(key, mm));
            }
        });
    }
}

/// The bead of a recipe; `own`: the job with it. Changes it, and says what was changed.
pub(super) fn of_recipe(ui: &mut egui::Ui, job: &Job, own: &Job, recipe: &mut Recipe) -> Option<&'static str> {
    let mut what = None;
    header(RECIPE, own).show(ui, |ui| {
        let is_own = Parameter::of_group(Group::BeadSize).any(|p| recipe.values.contains_key(p.key));
        match laid(ui, RECIPE, own, is_own.then_some(job)) {
            Some(Change::To(on)) => {
                let with = Job { bead: own.bead.laid(on, own.beam.spot_mm), ..own.clone() };
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
            match fields::number_from(ui, RECIPE, p, LEAST_MM, own.number(p), to) {
                Some(Change::To(mm)) => recipe.values.insert(p.key.into(), mm),
                Some(Change::Back) => recipe.values.remove(p.key),
                None => continue,
            };
            what = Some(p.key);
        }
        for p in Parameter::of_group(Group::BeadLayers) {
            what = recipe::number(ui, job, own, recipe, p).or(what);
        }
        bead_section(ui, RECIPE, own);
        if let Some((key, mm)) = fill(ui, RECIPE, own) {
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
    let title = match job.layer_count() {
        _ if !is_laid => "Bead: none".into(),
        1 => format!("Bead: {} × {} mm", bead.width_mm, bead.height_mm),
        n => format!("Bead: {} × {} mm, {n} layers", bead.width_mm, bead.height_mm),
    };
    CollapsingHeader::new(title).id_salt((owner.prefix, "bead", is_laid)).default_open(is_laid)
}

/// Whether a bead is laid; `to`: the job that a recipe can go back to in this.
fn laid(ui: &mut egui::Ui, owner: Owner, job: &Job, to: Option<&Job>) -> Option<Change<bool>> {
    let now = job.section_of_bead().is_some();
    let mut wanted = None;
    ui.horizontal(|ui| {
        name(ui, "Metal", to.is_some());
        let mut on = now;
        let check = ui.checkbox(&mut on, "lay a bead").on_hover_text("Cladding: the beam lays a bead on the part");
        let told = format!("{}lay a bead", owner.prefix);
        check.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, on, told.clone()));
        if check.changed() {
            wanted = Some(Change::To(on));
        }
        if let Some(to) = to {
            let bead = to.section_of_bead();
            let said = bead.map_or("none".into(), |b| format!("{} × {} mm", b.width_mm(), b.height_mm()));
            if back(ui, owner, "bead", &said) {
                wanted = Some(Change::Back);
            }
        }
    });
    wanted
}

/// How the layer comes out at the spacing that is set, and what would fill it: key and value of what is taken.
fn fill(ui: &mut egui::Ui, owner: Owner, job: &Job) -> Option<(&'static str, f64)> {
    let bead = job.section_of_bead()?;
    let (spacing_mm, own_mm) = (job.layers.spacing_mm, bead.spacing_mm());
    if (spacing_mm / own_mm - 1.0).abs() <= OTHER_SPACING {
        ui.label(RichText::new("The beads fill a layer of their own height (P3)").small());
        return None;
    }
    let mean_mm = bead.area_mm2() / spacing_mm;
    let text = format!(
        "The metal is enough for {mean_mm:.2} mm, the layer is planned as {:.2} mm; it is filled with:",
        bead.height_mm()
    );
    ui.label(RichText::new(text).color(theme::ATTENTION));
    let ways = [
        ("Spacing", SPACING, Some(own_mm), "Centres so far apart, with the bead as it is"),
        (
            "Height",
            HEIGHT,
            Bead::of_width(bead.width_mm(), spacing_mm).map(|b| b.height_mm()),
            "A bead so high, with width and spacing as they are",
        ),
        (
            "Width",
            WIDTH,
            Bead::of_height(bead.height_mm(), spacing_mm).map(|b| b.width_mm()),
            "A bead so wide, with height and spacing as they are",
        ),
    ];
    let mut taken = None;
    ui.horizontal_wrapped(|ui| {
        for (word, p, mm, tip) in ways {
            // A micrometre is more than anybody can set.
            let mm = mm.map(|mm| (mm * 1e3).round() / 1e3);
            let may = |mm: &f64| *mm >= LEAST_MM && p.check(*mm).is_ok();
            let Some(mm) = mm.filter(may) else { continue };
            let button = ui.button(format!("{word} {mm:.2} mm")).on_hover_text(format!("{tip} (P3 4.1)"));
            let told = format!("{}take {} {mm:.2} mm", owner.prefix, word.to_lowercase());
            button.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.clone()));
            if button.clicked() {
                taken = Some((p.key, mm));
            }
        }
    });
    taken
}
