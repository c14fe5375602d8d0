//! What a panel may look at: the document, what is computed from it, and what is selected and shown.
//!
//! A panel is a function `ui(ui, context, actions)` in `panels/<feature>.rs`. It reads the [`Context`], draws, and
//! puts what the user wants into [`Actions`](super::actions::Actions): commands, edits, places to go to, changes of
//! the session. The window carries them out right after the panel is drawn, in the order in which they came, so the
//! next panel shows their effect in the same frame. A panel therefore
//!
//! - never sees the `App`: what it cannot find here is a question that is asked here, once, as a method;
//! - changes nothing while it draws: a field works on a copy, and sends the copy when the user changed it
//!   (`if ui.checkbox(&mut on, …).changed() { actions.session(move |s| s.… = on) }`);
//! - sends nothing unasked: an action in every frame would be work in every frame.
//!
//! Questions that only one feature has stand in the feature's own file as functions of the context. State that only
//! one feature has (a timeline's place, a search) is a type of its own with the methods that change it; where the
//! session keeps it, its file knows no context (`panels/recipe/draft`, `panels/compare/state`).

use super::App;
use super::access::AccessViews;
use super::border::Borders;
use super::clearance::ClearanceCurve;
use super::command::Command;
use super::derived::Derived;
use super::dialogs::Answers;
use super::dose::DoseView;
use super::questions::Question;
use super::reading::Reading;
use super::scan_files::ScanAdding;
use super::scan_section::SectionView;
use super::scan_tool::ToolView;
use super::scan_view::ScanView;
use super::session::Session;
use super::shown::Tab;
use super::spacing::{SpacingPicture, SpacingView};
use super::suggestion_search::BetterSetupPreview;
use super::thumbnails::Thumbnails;
use super::toggle::Toggle;
use super::weld::{WeldAsking, WeldView};
use crate::beam::ProcessSettings;
use crate::document::files::JobError;
use crate::document::model::ScanWork;
use crate::document::{Document, Library};
use crate::planning::export::{ExportError, Exported};
use crate::planning::{PlannedJob, Stage};
use crate::pose::Target;
use crate::program::{Moment, Timeline};
use crate::progress::{Activity, Progress};
use crate::text::say;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A look at the window's state; it lasts as long as one panel is drawn.
#[derive(Clone, Copy)]
pub(super) struct Context<'a> {
    /// The job that is worked on, with its file.
    pub document: &'a Document,
    /// What is computed from it.
    pub derived: &'a Derived,
    /// What is selected, shown and open.
    pub session: &'a Session,
    /// The export that is being written.
    pub exporting: &'a Stage<Exported, ExportError>,
    /// The package that is being written.
    pub packing: &'a Stage<PathBuf, Arc<JobError>>,
    /// Files that were opened or saved last, the newest first.
    pub recent: &'a [PathBuf],
    /// Small pictures of those files.
    pub thumbnails: &'a Thumbnails,
    /// The library: recipes of the user and shipped ones.
    pub recipes: &'a Library,
    /// Dots and scale of the achieved spacing.
    pub spacing: &'a SpacingView,
    /// Borders that offset lines may start from.
    pub borders: &'a Borders,
    /// The points of the scan.
    pub scan: &'a ScanView,
    /// The section through part and scan.
    pub section: &'a SectionView,
    /// What is shown for a tool for the scan.
    pub tool: &'a ToolView,
    /// The access map of the current place, and the strip of its line.
    pub access: &'a AccessViews,
    /// The question that waits for the operator's answer.
    pub question: Option<&'a Question>,
    /// What files are being asked for.
    pub answers: &'a Answers,
    /// What is being read.
    pub reading: &'a Reading,
    /// Scans that are on their way into the job.
    pub adding: &'a ScanAdding,
    /// Images of a weld that are on their way into a job.
    pub asking: &'a WeldAsking,
    /// What is shown of the weld.
    pub weld: &'a WeldView,
}

impl App {
    /// The state as it is now.
    pub(super) fn context(&self) -> Context<'_> {
        Context {
            document: &self.document,
            derived: &self.derived,
            session: &self.session,
            exporting: &self.exporting,
            packing: &self.packing,
            recent: &self.recent,
            thumbnails: &self.thumbnails,
            recipes: &self.recipes,
            spacing: &self.spacing,
            borders: &self.borders,
            scan: &self.scan,
            section: &self.section,
            tool: &self.tool,
            access: &self.access,
            question: self.question.as_ref(),
            answers: &self.answers,
            reading: &self.reading,
            adding: &self.adding,
            asking: &self.asking,
            weld: &self.weld,
        }
    }
}

impl<'a> Context<'a> {
    /// Whether the scan lies on the part and was compared with it, so that its points can be shown.
    pub fn scan_is_laid(self) -> bool {
        self.derived.pipeline.scanned().is_some_and(|s| s.compared.is_some())
    }

    /// The plan of the job as it is; `None`: there is none, or what is shown is out of date.
    pub fn plan(self) -> Option<&'a Arc<PlannedJob>> {
        self.derived.current_plan(self.document)
    }

    /// That plan, if the robot refuses anything of it.
    pub fn refusing_plan(self) -> Option<&'a Arc<PlannedJob>> {
        self.plan().filter(|planned| !planned.plan.refusals.is_empty())
    }

    /// The better set-up that was found for it.
    pub fn better_setup(self) -> Option<&'a BetterSetupPreview> {
        self.derived.suggestions.better_setup(self.plan()?.key)
    }

    /// Whether a set-up was looked for in vain.
    pub fn has_no_better_setup(self) -> bool {
        self.plan().is_some_and(|planned| self.derived.suggestions.found_no_better_setup(planned.key))
    }

    /// The dose of the plan as it is; `None`: it is being computed, or was cancelled.
    pub fn dose(self) -> Option<&'a Arc<DoseView>> {
        self.plan()?;
        self.derived.dose.of(self.derived.pipeline.dose_key()?)
    }

    /// The clearance over the plan that is shown; `None`: it is being measured.
    pub fn clearance(self) -> Option<&'a Arc<ClearanceCurve>> {
        self.derived.clearance.of(self.derived.plan()?.key)
    }

    /// Whether there is a scan: then the facets of the surfaces that are shown need not be those of the part's file.
    pub fn has_scan(self) -> bool {
        self.document.job().scan.is_there()
    }

    /// Whether a scan tells what is worked: then nobody chooses surfaces.
    pub fn is_worked_by_scan(self) -> bool {
        self.has_scan() && self.document.job().scan.work == ScanWork::Patches
    }

    /// Whether a weld is ground: then its images tell the part's surfaces, and no light lands on them.
    pub fn has_weld(self) -> bool {
        self.document.job().weld.is_there()
    }

    /// Whether a scan or a weld tells what is worked: then nobody chooses surfaces.
    pub fn is_told_what_to_work(self) -> bool {
        self.is_worked_by_scan() || self.has_weld()
    }

    /// Why nobody chooses surfaces.
    pub fn why_told_what_to_work(self) -> Option<String> {
        let by_weld = self.has_weld().then(|| say!(weld_panel_tells_worked));
        by_weld.or_else(|| self.is_worked_by_scan().then(|| say!(scan_panel_tells_worked)))
    }

    /// Surfaces to clean, in the order of work. While a scan's patches or a weld's areas are looked for there are none.
    pub fn clean_list(self) -> Vec<u32> {
        if self.is_told_what_to_work() && self.derived.surfaces.worked.is_none() {
            return Vec::new();
        }
        self.document.job().chosen(&self.derived.surfaces)
    }

    /// The program over time, with a robot.
    pub fn timeline(self) -> Option<&'a Timeline> {
        self.derived.playback_data()?.timeline.as_ref()
    }

    /// Where arm, part and focus stand now.
    pub fn moment(self) -> Option<Moment> {
        Some(self.timeline()?.moment(self.session.playback.time_s))
    }

    /// The current target.
    pub fn target(self) -> Option<&'a Target> {
        let (pass, point) = self.session.playback.at;
        self.derived.plan()?.plan.passes.get(pass)?.targets.get(point)
    }

    /// The process settings of the current pass.
    pub fn process_settings(self) -> ProcessSettings {
        let pass = self.derived.plan().and_then(|of| of.plan.passes.get(self.session.playback.at.0));
        pass.map_or_else(ProcessSettings::default, |p| p.settings)
    }

    /// The achieved spacing of the plan that is shown, if it is shown too.
    pub fn spacing_picture(self) -> Option<&'a SpacingPicture> {
        let planned = self.derived.plan_on_part().filter(|_| self.session.show.is_on(Toggle::Spacing))?;
        self.spacing.of(planned)
    }

    /// Whether a command is a toggle that is on.
    pub fn is_shown(self, command: Command) -> bool {
        let is_on = |what| self.session.show.is_on(what);
        match command {
            Command::Toggle(Toggle::Lists) if self.session.is_narrow => {
                is_on(Toggle::Settings) && self.tab() == Tab::Lists
            }
            Command::Toggle(what) => is_on(what),
            Command::Navigate(navigation) => self.session.navigation == navigation,
            _ => false,
        }
    }

    /// Whether the robot cell is shown.
    pub fn is_in_cell(self) -> bool {
        self.session.show.is_on(Toggle::Cell) && self.derived.cell.is_some()
    }

    /// What can be cancelled, and its share done: the opening of a document, planning, an export, a search for what would
    /// help, the dose.
    pub fn progress(self) -> Option<(Activity, f32)> {
        let d = self.derived;
        let computed = [
            d.pipeline.progress(),
            self.exporting.progress(),
            self.packing.progress(),
            d.suggestions.progress(),
            d.dose.progress(),
        ];
        let read = [self.reading.progress(), self.adding.progress(), self.asking.progress()];
        let works = read.into_iter().chain(computed);
        works.flatten().find_map(Progress::now)
    }

    /// Name of the part without folder and ending.
    pub fn part_name(self) -> Option<String> {
        Path::new(&self.document.job().part.file).file_stem().map(|n| n.to_string_lossy().into_owned())
    }

    /// Name of the part's file, as the program's head says it.
    pub fn part_file_name(self) -> String {
        let name = Path::new(&self.document.job().part.file).file_name().map(|n| n.to_string_lossy().into_owned());
        name.unwrap_or_default()
    }
}
