//! What is selected, shown and open: neither saved nor undone.

use super::dose::Clicked;
use super::gizmo::state::Gizmo;
use super::panels::compare::state::Compare;
use super::panels::head_editor::state::HeadDraft;
use super::panels::palette::state::Palette;
use super::panels::recipe::draft::Draft;
use super::playback::Playback;
use super::program_view::ProgramView;
use super::scan_section::SectionAsked;
use super::scan_tool::ScanTool;
use super::scan_view::ScanLabel;
use super::shown::{PartCut, Picked, Tab};
use super::toggle::Toggle;
use super::tour::state::Tour;
use super::weld::ImagesView;
use crate::cell::Mount;
use crate::cell::calibration::PointPair;
use crate::document::{Forgotten, Job, RecutAnchor};
use crate::part::{Digest, PartFinding, SurfaceId};
use crate::pose::access::TiltPart;
use crate::view::{Camera, Navigation};
use eframe::egui;
use nalgebra::Point3;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// State of the window that is no part of the job.
#[derive(Debug)]
pub struct Session {
    /// Selected surfaces, in either list.
    pub selected: BTreeSet<u32>,
    /// Where Shift extends from.
    pub anchor: Option<u32>,
    /// Row that was clicked last.
    pub last_clicked: Option<u32>,
    /// Surface under the cursor in this frame, and in the frame before.
    pub hovered: Option<u32>,
    /// A selection made in the view: its row is scrolled into sight.
    pub scroll_to: Option<u32>,
    /// Surfaces that are not shown.
    pub hidden: BTreeSet<u32>,
    /// What is shown.
    pub show: Show,
    /// Filter texts of the two lists.
    pub filter: [String; 2],
    /// Sort column of the feature surfaces, and whether the order is reversed.
    pub sort: (Column, bool),
    /// Where the simulation is, and how it goes on.
    pub playback: Playback,
    /// Stretch of time that the curves show, s; `None`: all.
    pub plot_span: Option<[f64; 2]>,
    /// What is in sight of the program's text.
    pub program_view: ProgramView,
    /// Camera that the section plane took the place of.
    pub camera_before_section: Option<Camera>,
    /// Camera of the other mode, part or cell, when that was left.
    pub other_camera: Option<Camera>,
    /// Cell, robot and mount that were shown last: the camera is fitted to others anew.
    pub cell_shown: Option<(String, String, Option<Mount>)>,
    /// Job and surfaces when a drag of the angle began, and the job that it has reached.
    pub recut_anchor: Option<(RecutAnchor, Job)>,
    /// Local angle of the next split.
    pub split_angle_deg: f64,
    /// Surface that is being renamed, and the text so far.
    pub renaming: Option<(u32, String)>,
    /// The tab of the settings that was chosen; `None`: what suits the job.
    pub tab: Option<Tab>,
    /// Whether the window is too narrow for panels on both sides of the view.
    pub is_narrow: bool,
    /// The search for a command.
    pub palette: Option<Palette>,
    /// Page of shortcuts.
    pub help_open: bool,
    /// What waits for the answer to *Save changes?*.
    pub after_guard: Option<AfterGuard>,
    /// The answer was given; the window may close.
    pub may_close: bool,
    /// The window's title as it was last set.
    pub title: String,
    /// Whether the window had the focus in the last frame.
    pub was_focused: bool,
    /// The recipe that was taken out of the library last: it can come back.
    pub forgotten: Option<Forgotten>,
    /// The last message of the status line.
    pub said: String,
    /// Findings of the part's file that were dismissed from above the view.
    pub dismissed: Vec<PartFinding>,
    /// An error that must be read.
    pub error: Option<String>,
    /// Facet and point of the part under the cursor.
    pub hover_place: Option<(u32, Point3<f64>)>,
    /// Which part of the tilt is shown along the line.
    pub strip_over: TiltPart,
    /// The pin that is dragged, by its place among those of the line.
    pub pin_dragged: Option<usize>,
    /// What the part is coloured by.
    pub coloring: Coloring,
    /// What lands at the place that was clicked last.
    pub clicked: Option<Clicked>,
    /// What a click in the view does, other than select.
    pub tool: PointerTool,
    /// Which buttons of the mouse move the view.
    pub navigation: Navigation,
    /// Places that are measured, two at most.
    pub measured: Vec<Picked>,
    /// Handles by which something is moved in the view.
    pub gizmo: Option<Gizmo>,
    /// The tool for the scan that is in the hand, with what it has gathered.
    pub scan_tool: Option<ScanTool>,
    /// Where the part is cut open.
    pub cut: PartCut,
    /// Where the section through part and scan is.
    pub section: SectionAsked,
    /// The window of a weld's images.
    pub images: ImagesView,
    /// Markers of the scanner that tell no frame yet.
    pub markers: Option<Vec<PointPair>>,
    /// Labels on the scan.
    pub labels: Vec<ScanLabel>,
    /// Facet and point that were right clicked.
    pub menu_place: Option<(u32, Point3<f64>)>,
    /// Name or note of a recipe that is being typed.
    pub draft: Option<Draft>,
    /// Recipes side by side.
    pub compare: Option<Compare>,
    /// A head that is being put together.
    pub head_draft: Option<HeadDraft>,
    /// The pass to go on from after a stop, and the plan that it is one of.
    pub going_on: Option<GoingOn>,
    /// Whether it was a dry run that was exported last.
    pub exported_dry_run: bool,
    /// How many exports were written.
    pub exports: usize,
    /// The guided tour.
    pub tour: Option<Tour>,
    /// Whether lines are hidden that are free, corrected, blocked.
    pub hidden_states: [bool; 3],
    /// Whether an export writes the report as a page as well.
    pub writes_page: bool,
    /// Camera must be fitted once the part is there.
    pub fit_pending: bool,
}

/// Where work goes on after a stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GoingOn {
    /// Key of the plan.
    pub plan: Digest,
    /// The first pass that is not done.
    pub pass: usize,
}

/// What the part is coloured by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Coloring {
    /// Its surfaces.
    #[default]
    Surface,
    /// Energy that lands.
    Dose,
    /// Angle between light and normal.
    Incidence,
}

/// What a click in the view does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PointerTool {
    /// Select surfaces.
    #[default]
    Select,
    /// Put the origin on the clicked place.
    PickOrigin,
    /// Lay the clicked face down on z = 0.
    LayFlat,
    /// Measure between the clicked places.
    Measure,
    /// Select the surfaces that are painted over.
    Paint,
    /// Put a clamp with its origin on the clicked place, its z axis out of it.
    PutClamp(usize),
}

/// What is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Show(BTreeSet<Toggle>);

impl Default for Show {
    fn default() -> Show {
        let shown = [Toggle::PathLines, Toggle::ToolBodies, Toggle::Scan, Toggle::WeldPoints];
        Show(shown.into_iter().chain([Toggle::Lists, Toggle::Settings]).collect())
    }
}

impl Show {
    /// Whether something is shown.
    pub fn is_on(&self, what: Toggle) -> bool {
        self.0.contains(&what)
    }

    /// Shows it, or does not.
    pub fn set(&mut self, what: Toggle, on: bool) {
        if on {
            self.0.insert(what);
        } else {
            self.0.remove(&what);
        }
    }

    /// Shows what was hidden, and hides what was shown; returns whether it is shown now.
    pub fn flip(&mut self, what: Toggle) -> bool {
        let on = !self.is_on(what);
        self.set(what, on);
        on
    }
}

/// Columns of the lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Surface number.
    Number,
    /// Shape or name.
    Shape,
    /// Area.
    Area,
}

/// What happens once unsaved changes are dealt with.
#[derive(Clone, Debug, PartialEq)]
pub enum AfterGuard {
    /// The window closes.
    Close,
    /// A file is opened.
    Open(PathBuf),
    /// A file is asked for.
    AskOpen,
    /// Images of a weld are asked for.
    AskWeld,
}

impl Default for Session {
    fn default() -> Self {
        Session {
            selected: BTreeSet::new(),
            anchor: None,
            last_clicked: None,
            hovered: None,
            scroll_to: None,
            hidden: BTreeSet::new(),
            show: Show::default(),
            filter: Default::default(),
            sort: (Column::Number, false),
            playback: Playback::default(),
            plot_span: None,
            program_view: ProgramView::default(),
            camera_before_section: None,
            other_camera: None,
            tab: None,
            is_narrow: false,
            palette: None,
            cell_shown: None,
            recut_anchor: None,
            split_angle_deg: 10.0,
            renaming: None,
            help_open: false,
            after_guard: None,
            may_close: false,
            title: String::new(),
            said: String::new(),
            was_focused: true,
            forgotten: None,
            dismissed: Vec::new(),
            error: None,
            hover_place: None,
            strip_over: TiltPart::Lead,
            pin_dragged: None,
            coloring: Coloring::Surface,
            clicked: None,
            tool: PointerTool::Select,
            navigation: Navigation::default(),
            measured: Vec::new(),
            gizmo: None,
            scan_tool: None,
            cut: PartCut::default(),
            section: SectionAsked::default(),
            images: ImagesView::default(),
            markers: None,
            labels: Vec::new(),
            menu_place: None,
            draft: None,
            compare: None,
            head_draft: None,
            going_on: None,
            exported_dry_run: false,
            exports: 0,
            tour: None,
            hidden_states: [false; 3],
            writes_page: false,
            fit_pending: false,
        }
    }
}

impl Session {
    /// The selected surfaces.
    pub fn selected_ids(&self) -> Vec<SurfaceId> {
        self.selected.iter().copied().map(SurfaceId).collect()
    }

    /// Selects as lists do: Ctrl toggles, Shift adds.
    pub fn select(&mut self, surface: Option<u32>, modifiers: egui::Modifiers) {
        let selected = &mut self.selected;
        match surface {
            Some(n) if modifiers.command && selected.contains(&n) => {
                selected.remove(&n);
            }
            Some(n) if modifiers.shift || modifiers.command => {
                selected.insert(n);
            }
            Some(n) => *selected = [n].into(),
            None if !modifiers.command && !modifiers.shift => selected.clear(),
            None => {}
        }
        self.anchor = surface;
    }

    /// Lays down what is in the hand: one tool at a time is.
    pub fn empty_hand(&mut self) {
        (self.tool, self.scan_tool, self.gizmo) = (PointerTool::Select, None, None);
    }

    /// Resets all that belongs to one part.
    pub fn forget_part(&mut self) {
        let playback = Playback::at_speed(self.playback.speed);
        let (navigation, tour) = (self.navigation, self.tour.take());
        *self = Session { show: self.show.clone(), playback, navigation, tour, ..Session::default() };
    }
}
