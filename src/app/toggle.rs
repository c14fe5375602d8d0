//! What can be shown in the view or beside it, each by a toggle.

use crate::text::say;

/// What can be shown in the view or beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Toggle {
    /// Lines that the spot follows.
    PathLines,
    /// Frames at targets.
    PoseFrames,
    /// Beams at targets.
    Beams,
    /// Moves with the laser off.
    ConnectingMoves,
    /// Beams as they were before the correction.
    BeforeCorrection,
    /// The part without colours.
    PlainPart,
    /// All but the surfaces to clean, which are hidden.
    HideChosen,
    /// The section plane of the current pass, alone.
    SectionPlane,
    /// The robot cell instead of the part alone.
    Cell,
    /// Curves of the motion over time.
    Plots,
    /// The program's text.
    ProgramText,
    /// Head, beam and clamps.
    ToolBodies,
    /// The access map: from which directions the current place can be reached.
    AccessMap,
    /// The dose, and what stays unclean.
    Dose,
    /// The spacing that lines really have.
    Spacing,
    /// The points of the scan, by how far they are off the model.
    Scan,
    /// The points of the scan that cleaning took out.
    DroppedPoints,
    /// The model by how far the scan is off it, in place of the points.
    DeviationOnModel,
    /// A section through part and scan, as a drawing below the view.
    ScanSection,
    /// The images of a weld with its mask, in a window.
    WeldImages,
    /// The points of a bead by their height, its centre line, and the camera.
    WeldPoints,
    /// The part cut open by a plane.
    Cut,
    /// The lists of surfaces, at the left.
    Lists,
    /// The settings of the job, at the right.
    Settings,
}

impl Toggle {
    /// What it shows, in a sentence.
    pub fn about(self) -> String {
        match self {
            Toggle::PathLines => say!(about_path_lines),
            Toggle::PoseFrames => say!(about_pose_frames),
            Toggle::Beams => say!(about_beams),
            Toggle::ConnectingMoves => say!(about_connecting_moves),
            Toggle::BeforeCorrection => say!(about_before_correction),
            Toggle::PlainPart => say!(about_plain_part),
            Toggle::HideChosen => say!(about_hide_chosen),
            Toggle::SectionPlane => say!(about_section_plane),
            Toggle::Cell => say!(about_cell),
            Toggle::Plots => say!(about_plots),
            Toggle::ProgramText => say!(about_program_text),
            Toggle::ToolBodies => say!(about_tool_bodies),
            Toggle::AccessMap => say!(about_access_map),
            Toggle::Dose => say!(about_dose),
            Toggle::Spacing => say!(about_spacing),
            Toggle::Scan => say!(about_scan),
            Toggle::DroppedPoints => say!(about_dropped_points),
            Toggle::DeviationOnModel => say!(about_deviation_on_model),
            Toggle::ScanSection => say!(about_scan_section),
            Toggle::WeldImages => say!(about_weld_images),
            Toggle::WeldPoints => say!(about_weld_points),
            Toggle::Cut => say!(about_cut),
            Toggle::Lists => say!(about_lists),
            Toggle::Settings => say!(about_settings),
        }
    }
}
