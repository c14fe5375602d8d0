//! Every command once: name, menu, shortcut. The menus, the keys, the `?` page and the tests that
//! sweep them are made from this table.

use eframe::egui::{Key, KeyboardShortcut, Modifiers};

/// What the user can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "the table below says what each does")]
pub enum Command {
    Open,
    Save,
    SaveAs,
    Export,
    Undo,
    Redo,
    Clean,
    Unclean,
    Earlier,
    Later,
    SelectAll,
    SelectSameShape,
    SelectSameNormal,
    SelectNeighbours,
    Merge,
    Split,
    Rename,
    FlipSurface,
    FlipShell,
    PickOrigin,
    LayFlat,
    TurnX,
    TurnY,
    TurnZ,
    Look(u8),
    Fit,
    Projection,
    Hide,
    Isolate,
    ShowAll,
    Lines,
    Frames,
    Beams,
    Air,
    Before,
    Plain,
    HideChosen,
    Section,
    Cell,
    Plots,
    Text,
    ToolBodies,
    Access,
    Dose,
    Spacing,
    Plan,
    Cancel,
    BetterSetup,
    Play,
    NextPoint,
    LastPoint,
    NextPass,
    LastPass,
    First,
    Last,
    Theme,
    Help,
    Escape,
}

/// Where a command stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Menu {
    /// Files.
    File,
    /// The document.
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
    /// All, in the order of the menu bar, with their titles.
    pub const ALL: [(Menu, &'static str); 7] = [
        (Menu::File, "File"),
        (Menu::Edit, "Edit"),
        (Menu::Surfaces, "Surfaces"),
        (Menu::Part, "Part"),
        (Menu::View, "View"),
        (Menu::Plan, "Plan"),
        (Menu::Help, "Help"),
    ];
}

/// A row of the table.
pub struct Row {
    /// The command.
    pub command: Command,
    /// Its name in menus.
    pub name: &'static str,
    /// Its menu.
    pub menu: Menu,
    /// Its keys.
    pub keys: Option<KeyboardShortcut>,
}

const fn row(command: Command, name: &'static str, menu: Menu, keys: Option<KeyboardShortcut>) -> Row {
    Row { command, name, menu, keys }
}

const fn key(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::NONE, key))
}

const fn ctrl(key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(Modifiers::COMMAND, key))
}

const fn with(modifiers: Modifiers, key: Key) -> Option<KeyboardShortcut> {
    Some(KeyboardShortcut::new(modifiers, key))
}

use Command as C;
use Menu as M;

/// The table.
pub const COMMANDS: &[Row] = &[
    row(C::Open, "Open…", M::File, ctrl(Key::O)),
    row(C::Save, "Save job", M::File, ctrl(Key::S)),
    row(C::SaveAs, "Save job as…", M::File, with(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::S)),
    row(C::Export, "Export program…", M::File, ctrl(Key::E)),
    row(C::Undo, "Undo", M::Edit, ctrl(Key::Z)),
    row(C::Redo, "Redo", M::Edit, ctrl(Key::Y)),
    row(C::Clean, "Move to clean", M::Surfaces, key(Key::Enter)),
    row(C::Unclean, "Move back", M::Surfaces, key(Key::Delete)),
    row(C::Earlier, "Earlier in the order", M::Surfaces, with(Modifiers::ALT, Key::ArrowUp)),
    row(C::Later, "Later in the order", M::Surfaces, with(Modifiers::ALT, Key::ArrowDown)),
    row(C::SelectAll, "Select all", M::Surfaces, ctrl(Key::A)),
    row(C::SelectSameShape, "Select same shape", M::Surfaces, None),
    row(C::SelectSameNormal, "Select same normal", M::Surfaces, None),
    row(C::SelectNeighbours, "Select connected", M::Surfaces, None),
    row(C::Merge, "Merge selected", M::Surfaces, ctrl(Key::M)),
    row(C::Split, "Split by the local angle", M::Surfaces, None),
    row(C::Rename, "Rename…", M::Surfaces, key(Key::F2)),
    row(C::FlipSurface, "Flip side of surface", M::Surfaces, None),
    row(C::FlipShell, "Flip side of shell", M::Surfaces, None),
    row(C::PickOrigin, "Origin at a picked face, edge or hole…", M::Part, None),
    row(C::LayFlat, "Lay a picked face down…", M::Part, None),
    row(C::TurnX, "Turn 90° about x", M::Part, None),
    row(C::TurnY, "Turn 90° about y", M::Part, None),
    row(C::TurnZ, "Turn 90° about z", M::Part, None),
    row(C::Look(0), "Iso", M::View, key(Key::Num0)),
    row(C::Look(1), "Front", M::View, key(Key::Num1)),
    row(C::Look(2), "Back", M::View, key(Key::Num2)),
    row(C::Look(3), "Left", M::View, key(Key::Num3)),
    row(C::Look(4), "Right", M::View, key(Key::Num4)),
    row(C::Look(5), "Top", M::View, key(Key::Num5)),
    row(C::Look(6), "Bottom", M::View, key(Key::Num6)),
    row(C::Fit, "Fit", M::View, key(Key::F)),
    row(C::Projection, "Perspective or parallel", M::View, key(Key::O)),
    row(C::Hide, "Hide selected", M::View, key(Key::H)),
    row(C::Isolate, "Show only selected", M::View, with(Modifiers::SHIFT, Key::H)),
    row(C::ShowAll, "Show all", M::View, with(Modifiers::ALT, Key::H)),
    row(C::Lines, "Path lines", M::View, key(Key::L)),
    row(C::Frames, "Pose frames", M::View, key(Key::R)),
    row(C::Beams, "Beams", M::View, key(Key::B)),
    row(C::Air, "Connecting moves", M::View, key(Key::A)),
    row(C::Before, "Before correction", M::View, key(Key::C)),
    row(C::Plain, "Part without colours", M::View, key(Key::G)),
    row(C::HideChosen, "Hide surfaces to clean", M::View, None),
    row(C::Section, "One section plane", M::View, key(Key::S)),
    row(C::Cell, "Robot cell", M::View, key(Key::K)),
    row(C::Plots, "Motion plots", M::View, key(Key::M)),
    row(C::Text, "Program text", M::View, key(Key::P)),
    row(C::ToolBodies, "Head and clamps", M::View, key(Key::N)),
    row(C::Access, "Access map", M::View, key(Key::T)),
    row(C::Dose, "Dose", M::View, key(Key::D)),
    row(C::Spacing, "Achieved spacing", M::View, key(Key::I)),
    row(C::Theme, "Dark or light", M::View, None),
    row(C::Plan, "Plan now", M::Plan, ctrl(Key::R)),
    row(C::Cancel, "Cancel planning or search", M::Plan, None),
    row(C::BetterSetup, "Find a better set-up", M::Plan, None),
    row(C::Play, "Play or pause", M::Plan, key(Key::Space)),
    row(C::NextPoint, "Next point", M::Plan, key(Key::ArrowRight)),
    row(C::LastPoint, "Previous point", M::Plan, key(Key::ArrowLeft)),
    row(C::NextPass, "Next pass", M::Plan, key(Key::PageDown)),
    row(C::LastPass, "Previous pass", M::Plan, key(Key::PageUp)),
    row(C::First, "First point", M::Plan, key(Key::Home)),
    row(C::Last, "Last point", M::Plan, key(Key::End)),
    row(C::Help, "Shortcuts", M::Help, with(Modifiers::SHIFT, Key::Questionmark)),
    row(C::Escape, "Step out", M::Help, key(Key::Escape)),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_commands_share_their_keys_or_name() {
        for (i, a) in COMMANDS.iter().enumerate() {
            for b in &COMMANDS[..i] {
                assert!(a.keys.is_none() || a.keys != b.keys, "{} and {}", a.name, b.name);
                assert!(a.name != b.name && a.command != b.command);
            }
        }
    }
}
