//! The tabs of the settings: which there are, and which is shown.

use super::context::Context;
use super::shown::Tab;
use crate::text::say;

impl Tab {
    const ALL: [Tab; 8] = [Tab::Lists, Tab::Weld, Tab::Scan, Tab::Path, Tab::Beam, Tab::Part, Tab::Robot, Tab::Dose];

    /// What it is called.
    pub fn name(self) -> String {
        match self {
            Tab::Lists => say!(tab_lists),
            Tab::Path => say!(tab_path),
            Tab::Beam => say!(tab_beam),
            Tab::Part => say!(tab_part),
            Tab::Robot => say!(tab_robot),
            Tab::Dose => say!(tab_dose),
            Tab::Scan => say!(tab_scan),
            Tab::Weld => say!(tab_weld),
        }
    }
}

impl Context<'_> {
    /// The tabs that there are, from left to right.
    pub fn tabs(self) -> impl Iterator<Item = Tab> {
        Tab::ALL.into_iter().filter(move |tab| self.has_tab(*tab))
    }

    /// The tab that is shown.
    pub fn tab(self) -> Tab {
        let first = self.tabs().find(|tab| matches!(tab, Tab::Lists | Tab::Weld | Tab::Scan)).unwrap_or(Tab::Path);
        self.session.tab.filter(|tab| self.has_tab(*tab)).unwrap_or(first)
    }

    fn has_tab(self, tab: Tab) -> bool {
        match tab {
            Tab::Lists => self.session.is_narrow,
            Tab::Scan => self.has_scan(),
            Tab::Weld => self.has_weld(),
            // A grinding tool lays no dose on the part.
            Tab::Dose => !self.has_weld(),
            Tab::Path | Tab::Beam | Tab::Part | Tab::Robot => true,
        }
    }
}
