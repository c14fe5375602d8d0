//! When a command can be given, and what is missing where it cannot.

use super::command::{Command, More};
use super::context::Context;
use super::toggle::Toggle;
use crate::text::say;

impl Context<'_> {
    /// Whether a command can do anything now.
    pub fn is_enabled(self, command: Command) -> bool {
        self.why_not(command).is_none()
    }

    /// Why a command cannot be given now; `None`: it can.
    pub fn why_not(self, command: Command) -> Option<String> {
        use Command as C;
        let selected = &self.session.selected;
        match command {
            C::Open | C::OpenWeld | C::Palette | C::Help | C::Escape => None,
            C::Theme | C::Language | C::Navigate(_) => None,
            C::Undo => unless(self.document.undo_step().is_some(), || say!(why_not_undo)),
            C::Redo => unless(self.document.redo_step().is_some(), || say!(why_not_redo)),
            C::Cancel => unless(self.progress().is_some(), || say!(why_not_idle)),
            C::Toggle(Toggle::Lists | Toggle::Settings) => self.lacks_part(),
            _ if self.derived.part.is_none() => self.lacks_part(),
            C::OpenScan | C::Save | C::SaveAs | C::Plan | C::SelectRow(_) => None,
            C::Select(More::Listed)
            | C::SelectByPainting
            | C::Measure
            | C::PickOrigin
            | C::LayFlat
            | C::QuarterTurn(_) => None,
            C::Look(_) | C::Fit | C::Projection | C::ShowAll => None,
            C::Export | C::ExportDryRun | C::ExportFromPass => {
                self.lacks_plan().or_else(|| unless(self.plan().is_some(), || say!(cell_panel_not_planned)))
            }
            C::Play | C::Go(_) => self.lacks_plan(),
            C::Toggle(what) => self.lacks(what),
            C::BetterSetup if self.derived.suggestions.is_better_setup_sought() => {
                Some(say!(cell_panel_better_running))
            }
            C::BetterSetup => unless(self.refusing_plan().is_some(), || say!(cell_panel_nothing_refused)),
            C::Clean | C::Unclean | C::CleanEarlier | C::CleanLater if self.is_told_what_to_work() => {
                self.why_told_what_to_work()
            }
            C::Merge | C::Split | C::FlipSurface | C::FlipShell if self.has_weld() => {
                Some(say!(weld_panel_keeps_surfaces))
            }
            C::Merge | C::Split | C::FlipSurface | C::FlipShell if self.has_scan() => {
                Some(say!(scan_panel_keeps_surfaces))
            }
            // Facets are cut and joined on the part as it is.
            C::Merge | C::Split if !self.derived.has_current_surfaces(self.document) => {
                Some(say!(window_part_being_built))
            }
            C::Merge => unless(selected.len() > 1, || say!(why_not_two_selected)),
            C::Rename => unless(!selected.is_empty(), || say!(why_not_selected)),
            C::Split | C::FlipSurface | C::FlipShell => unless(selected.len() == 1, || say!(why_not_one_selected)),
            _ if selected.is_empty() => Some(say!(why_not_selected)),
            C::Clean => unless(!self.all_selected_are(true), || say!(why_not_left)),
            C::Unclean | C::CleanEarlier | C::CleanLater => {
                unless(!self.all_selected_are(false), || say!(why_not_listed))
            }
            C::Select(More::SameShape | More::SameNormal | More::Neighbours | More::Larger) | C::Hide | C::Isolate => {
                None
            }
        }
    }

    /// Whether the selected surfaces are all on the list to clean, or all not.
    fn all_selected_are(self, on_list: bool) -> bool {
        let clean = self.clean_list();
        self.session.selected.iter().all(|n| clean.contains(n) == on_list)
    }

    fn lacks_part(self) -> Option<String> {
        unless(self.derived.part.is_some(), || say!(why_not_part))
    }

    fn lacks_plan(self) -> Option<String> {
        unless(self.derived.plan().is_some(), || say!(why_not_plan))
    }

    /// What is missing for something to be shown.
    fn lacks(self, what: Toggle) -> Option<String> {
        use Toggle as T;
        match what {
            _ if self.has_weld() && is_of_light(what) => Some(say!(weld_panel_no_light)),
            T::WeldImages => unless(self.has_weld(), || say!(why_not_weld)),
            T::WeldPoints => unless(self.weld.measured().is_some(), || say!(why_not_weld)),
            T::PathLines | T::PoseFrames | T::Beams | T::ConnectingMoves => None,
            T::BeforeCorrection | T::PlainPart | T::HideChosen | T::ToolBodies | T::Cut | T::Lists | T::Settings => {
                None
            }
            T::SectionPlane | T::AccessMap | T::Dose | T::Spacing => self.lacks_plan(),
            T::Scan | T::DroppedPoints | T::DeviationOnModel | T::ScanSection => {
                unless(self.scan_is_laid(), || say!(why_not_scan))
            }
            T::Cell => unless(self.derived.cell.is_some(), || say!(menu_needs_robot)),
            T::Plots if self.derived.cell.is_none() => Some(say!(menu_needs_robot)),
            T::Plots => unless(self.timeline().is_some(), || say!(why_not_plan)),
            T::ProgramText => unless(self.derived.playback_data().is_some(), || say!(why_not_plan)),
        }
    }
}

/// What only light has: a grinding tool lays no dose on the part, and nobody corrects its beam.
fn is_of_light(what: Toggle) -> bool {
    matches!(what, Toggle::Dose | Toggle::BeforeCorrection)
}

fn unless(is_there: bool, why: impl FnOnce() -> String) -> Option<String> {
    (!is_there).then(why)
}
