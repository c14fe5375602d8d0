//! Every command once: name, menu and keys. Menus, shortcuts, the page of shortcuts and the tests that sweep all
//! commands are made from this table.
//!
//! When a command can be given stands in `enabled`, what it does in `run`. Both match all commands, so
//! one that was forgotten there does not compile. One without a row in the table does not compile either.

use super::toggle::Toggle;
use crate::text::say;
use crate::view::{Navigation, StandardView};
use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers};

/// What the user can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Command {
    /// Opens a part or a job; the user is asked which.
    Open,
    /// Adds a file to the scan of the part; the user is asked which.
    OpenScan,
    /// Opens the images of a weld; the user is asked for each.
    OpenWeld,
    /// Saves the job where it is kept.
    Save,
    /// Saves the job in another file.
    SaveAs,
    /// Writes the program into a folder.
    Export,
    /// Writes its dry run into a folder.
    ExportDryRun,
    /// Goes on from the current pass: those before it count as done, and the program from there on is exported.
    ExportFromPass,
    /// Undoes the last step.
    Undo,
    /// Redoes the step that was undone last.
    Redo,
    /// Moves the selected surfaces to the list to clean.
    Clean,
    /// Moves the selected surfaces back from there.
    Unclean,
    /// Moves the selected surfaces one place up in the order of work.
    CleanEarlier,
    /// Moves the selected surfaces one place down in the order of work.
    CleanLater,
    /// Selects more surfaces.
    Select(More),
    /// Surfaces that are painted over in the view are selected.
    SelectByPainting,
    /// Selects the surface in the next row of its list.
    SelectRow(RowStep),
    /// Makes the selected surfaces one.
    Merge,
    /// Cuts the selected surface at the local angle.
    Split,
    /// Opens the field in which the selected surface is renamed.
    Rename,
    /// Turns the selected surface inside out.
    FlipSurface,
    /// Turns the shell of the selected surface inside out.
    FlipShell,
    /// The next click in the view says where the origin is.
    PickOrigin,
    /// The next click in the view says which face lies on the floor.
    LayFlat,
    /// Clicks in the view say what is measured.
    Measure,
    /// Turns the part by 90° about an axis.
    QuarterTurn(TurnAxis),
    /// Turns the camera.
    Look(StandardView),
    /// Fits the camera to the selected surfaces, or to everything.
    Fit,
    /// Switches between perspective and parallel projection.
    Projection,
    /// Hides the selected surfaces.
    Hide,
    /// Hides all others.
    Isolate,
    /// Shows all surfaces.
    ShowAll,
    /// Shows or hides something.
    Toggle(Toggle),
    /// Which buttons of the mouse move the view.
    Navigate(Navigation),
    /// Goes over to the next of dark, light, and the system's theme.
    Theme,
    /// Goes over to the next language.
    Language,
    /// Plans again what was cancelled or failed, and reads changed files.
    Plan,
    /// Cancels what is being computed.
    Cancel,
    /// Looks for a set-up with which the robot refuses fewer targets.
    BetterSetup,
    /// Starts or stops the simulation.
    Play,
    /// Goes to another target.
    Go(Jump),
    /// Finds a command by its words.
    Palette,
    /// Opens or closes the page of shortcuts.
    Help,
    /// Closes or ends the innermost of these that is open: page of shortcuts, renaming, tool, preview, section,
    /// selection.
    Escape,
}

/// Which surfaces are selected besides those that are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum More {
    /// All that are listed as feature surfaces.
    Listed,
    /// Those of the same shape and size as a selected one.
    SameShape,
    /// Planes with the same normal.
    SameNormal,
    /// Those that share an edge with a selected one.
    Neighbours,
    /// Those of at least the area of the smallest selected one.
    Larger,
}

/// A row of a list relative to the one that was selected last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RowStep {
    /// The one below.
    Below,
    /// The one above.
    Above,
}

/// An axis of the part frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TurnAxis {
    /// x
    X,
    /// y
    Y,
    /// z
    Z,
}

/// A target relative to the current one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Jump {
    /// The next point, of the next pass after the last of this one.
    NextPoint,
    /// The point before, of the pass before it after the first of this one.
    PreviousPoint,
    /// The first point of the next pass.
    NextPass,
    /// The first point of the pass before.
    PreviousPass,
    /// The first point of the program.
    FirstPoint,
    /// The last point of the program.
    LastPoint,
}

/// Where a command stands in the menu bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// Files.
    File,
    /// Undo and redo.
    Edit,
    /// Surfaces and lists.
    Surfaces,
    /// Where the part stands.
    Part,
    /// What is shown.
    View,
    /// Planning and stepping.
    Plan,
    /// The page of shortcuts.
    Help,
}

impl Menu {
    /// All, in the order of the menu bar.
    pub const ALL: [Menu; 7] = [Menu::File, Menu::Edit, Menu::Surfaces, Menu::Part, Menu::View, Menu::Plan, Menu::Help];

    /// What the menu bar says.
    pub fn title(self) -> String {
        match self {
            Menu::File => say!(menu_file),
            Menu::Edit => say!(menu_edit),
            Menu::Surfaces => say!(menu_surfaces),
            Menu::Part => say!(menu_part),
            Menu::View => say!(menu_view),
            Menu::Plan => say!(menu_plan),
            Menu::Help => say!(menu_help),
        }
    }

    /// Its commands, from top to bottom.
    pub fn commands(self) -> impl Iterator<Item = Command> {
        Command::ALL.iter().copied().filter(move |c| c.menu() == self)
    }
}

const fn key(key: Key) -> Option<KeyboardShortcut> {
    with(Modifiers::NONE, key)
}

const fn ctrl(key: Key) -> Option<KeyboardShortcut> {
    with(Modifiers::COMMAND, key)
}

const fn with(modifiers: Modifiers, key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(modifiers, key))
}

/// The list of all commands, and an exhaustive match for each column, from one row a command.
macro_rules! table {
    ($($command:ident $(($inner:path))? => $name:ident, $menu:ident, $keys:expr;)*) => {
        impl Command {
            /// All, in the order of the menus.
            pub const ALL: &[Command] = &[$(Command::$command $(($inner))?),*];

            /// What menus and buttons say.
            pub fn name(self) -> String {
                match self { $(Command::$command $(($inner))? => say!($name)),* }
            }

            /// The menu that it stands in.
            pub const fn menu(self) -> Menu {
                match self { $(Command::$command $(($inner))? => Menu::$menu),* }
            }

            /// The keys that give it.
            pub const fn keys(self) -> Option<KeyboardShortcut> {
                match self { $(Command::$command $(($inner))? => $keys),* }
            }
        }
    };
}

table! {
    Open => command_open, File, ctrl(Key::O);
    OpenScan => command_open_scan, File, with(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::O);
    OpenWeld => command_open_weld, File, ctrl(Key::I);
    Save => command_save, File, ctrl(Key::S);
    SaveAs => command_save_as, File, with(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::S);
    Export => command_export, File, ctrl(Key::E);
    ExportDryRun => command_export_dry_run, File, with(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::E);
    ExportFromPass => command_export_from_pass, File, None;
    Undo => command_undo, Edit, ctrl(Key::Z);
    Redo => command_redo, Edit, ctrl(Key::Y);
    Clean => command_clean, Surfaces, key(Key::Enter);
    Unclean => command_unclean, Surfaces, key(Key::Delete);
    CleanEarlier => command_clean_earlier, Surfaces, with(Modifiers::ALT, Key::ArrowUp);
    CleanLater => command_clean_later, Surfaces, with(Modifiers::ALT, Key::ArrowDown);
    Select(More::Listed) => command_select_all, Surfaces, ctrl(Key::A);
    Select(More::SameShape) => command_select_same_shape, Surfaces, None;
    Select(More::SameNormal) => command_select_same_normal, Surfaces, None;
    Select(More::Neighbours) => command_select_neighbours, Surfaces, None;
    Select(More::Larger) => command_select_larger, Surfaces, None;
    SelectByPainting => command_select_by_painting, Surfaces, None;
    SelectRow(RowStep::Below) => command_select_below, Surfaces, key(Key::ArrowDown);
    SelectRow(RowStep::Above) => command_select_above, Surfaces, key(Key::ArrowUp);
    Merge => command_merge, Surfaces, ctrl(Key::M);
    Split => command_split, Surfaces, None;
    Rename => command_rename, Surfaces, key(Key::F2);
    FlipSurface => command_flip_surface, Surfaces, None;
    FlipShell => command_flip_shell, Surfaces, None;
    PickOrigin => command_pick_origin, Part, None;
    LayFlat => command_lay_flat, Part, None;
    Measure => command_measure, Part, key(Key::Q);
    QuarterTurn(TurnAxis::X) => command_turn_x, Part, None;
    QuarterTurn(TurnAxis::Y) => command_turn_y, Part, None;
    QuarterTurn(TurnAxis::Z) => command_turn_z, Part, None;
    Look(StandardView::Iso) => command_look_iso, View, key(Key::Num0);
    Look(StandardView::Front) => command_look_front, View, key(Key::Num1);
    Look(StandardView::Back) => command_look_back, View, key(Key::Num2);
    Look(StandardView::Left) => command_look_left, View, key(Key::Num3);
    Look(StandardView::Right) => command_look_right, View, key(Key::Num4);
    Look(StandardView::Top) => command_look_top, View, key(Key::Num5);
    Look(StandardView::Bottom) => command_look_bottom, View, key(Key::Num6);
    Fit => command_fit, View, key(Key::F);
    Projection => command_projection, View, key(Key::O);
    Hide => command_hide, View, key(Key::H);
    Isolate => command_isolate, View, with(Modifiers::SHIFT, Key::H);
    ShowAll => command_show_all, View, with(Modifiers::ALT, Key::H);
    Toggle(Toggle::PathLines) => command_path_lines, View, key(Key::L);
    Toggle(Toggle::PoseFrames) => command_pose_frames, View, key(Key::R);
    Toggle(Toggle::Beams) => command_beams, View, key(Key::B);
    Toggle(Toggle::ConnectingMoves) => command_connecting_moves, View, key(Key::A);
    Toggle(Toggle::BeforeCorrection) => command_before_correction, View, key(Key::C);
    Toggle(Toggle::PlainPart) => command_plain_part, View, key(Key::G);
    Toggle(Toggle::HideChosen) => command_hide_chosen, View, None;
    Toggle(Toggle::SectionPlane) => command_section_plane, View, key(Key::S);
    Toggle(Toggle::Cell) => command_cell, View, key(Key::K);
    Toggle(Toggle::Plots) => command_plots, View, key(Key::M);
    Toggle(Toggle::ProgramText) => command_program_text, View, key(Key::P);
    Toggle(Toggle::ToolBodies) => command_tool_bodies, View, key(Key::N);
    Toggle(Toggle::AccessMap) => command_access_map, View, key(Key::T);
    Toggle(Toggle::Dose) => command_dose, View, key(Key::D);
    Toggle(Toggle::Spacing) => command_spacing, View, key(Key::I);
    Toggle(Toggle::Scan) => command_scan, View, key(Key::W);
    Toggle(Toggle::DroppedPoints) => command_dropped_points, View, None;
    Toggle(Toggle::DeviationOnModel) => command_deviation_on_model, View, None;
    Toggle(Toggle::ScanSection) => command_scan_section, View, key(Key::X);
    Toggle(Toggle::WeldImages) => command_weld_images, View, key(Key::V);
    Toggle(Toggle::WeldPoints) => command_weld_points, View, key(Key::E);
    Toggle(Toggle::Cut) => command_cut, View, key(Key::Z);
    Toggle(Toggle::Lists) => command_lists, View, key(Key::OpenBracket);
    Toggle(Toggle::Settings) => command_settings, View, key(Key::CloseBracket);
    Navigate(Navigation::Slicer) => command_navigate_slicer, View, None;
    Navigate(Navigation::Cad) => command_navigate_cad, View, None;
    Navigate(Navigation::Blender) => command_navigate_blender, View, None;
    Theme => command_theme, View, None;
    Language => command_language, View, None;
    Plan => command_plan, Plan, ctrl(Key::R);
    Cancel => command_cancel, Plan, None;
    BetterSetup => command_better_setup, Plan, None;
    Play => command_play, Plan, key(Key::Space);
    Go(Jump::NextPoint) => command_next_point, Plan, key(Key::ArrowRight);
    Go(Jump::PreviousPoint) => command_previous_point, Plan, key(Key::ArrowLeft);
    Go(Jump::NextPass) => command_next_pass, Plan, key(Key::PageDown);
    Go(Jump::PreviousPass) => command_previous_pass, Plan, key(Key::PageUp);
    Go(Jump::FirstPoint) => command_first_point, Plan, key(Key::Home);
    Go(Jump::LastPoint) => command_last_point, Plan, key(Key::End);
    Palette => command_palette, Help, with(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::P);
    Help => command_help, Help, with(Modifiers::SHIFT, Key::Questionmark);
    Escape => command_escape, Help, key(Key::Escape);
}

impl Command {
    /// Its keys, as written on this system; empty without any.
    pub fn keys_text(self, ctx: &Context) -> String {
        self.keys().map_or_else(String::new, |keys| ctx.format_shortcut(&keys))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_commands_share_their_keys_or_name() {
        for (i, a) in Command::ALL.iter().enumerate() {
            for b in &Command::ALL[..i] {
                assert!(a.keys().is_none() || a.keys() != b.keys(), "{a:?} and {b:?}");
                assert!(a.name() != b.name(), "{a:?} and {b:?}");
            }
        }
    }
}
