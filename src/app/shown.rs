//! Small things that the session keeps of what is shown: the tab of the settings, where the part is cut open, which
//! places are measured.

use nalgebra::Point3;

/// A tab of the settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Tab {
    /// The lists of surfaces, where the window is too narrow for a panel of their own.
    Lists,
    /// How lines are laid, and recipes.
    Path,
    /// Beam, head, clamps and optics.
    Beam,
    /// How facets become surfaces, and where the part stands.
    Part,
    /// Robot, frames and program.
    Robot,
    /// The dose, with its thresholds.
    Dose,
    /// The scan of the part.
    Scan,
    /// The weld that is ground.
    Weld,
}

/// Where the part is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PartCut {
    /// The axis of the part across which: 0, 1 or 2.
    pub axis: usize,
    /// Where along it, as a share of the part.
    pub share: f32,
    /// Whether the lower side stays rather than the upper one.
    pub is_flipped: bool,
}

impl Default for PartCut {
    fn default() -> PartCut {
        PartCut { axis: 1, share: 0.5, is_flipped: false }
    }
}

/// A place that was picked: facet and point, mm in the part's frame.
pub(super) type Picked = (u32, Point3<f64>);
