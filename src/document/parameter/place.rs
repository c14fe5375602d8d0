//! Where a parameter belongs: its section of the panel, whether recipes may hold it, and what another value makes
//! stale.

/// The numbers that stand together in the panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// From which angle on an edge is a crease.
    Crease,
    /// What else decides how facets become surfaces.
    Islands,
    /// The distance of lines.
    Spacing,
    /// The two rasters of a cross.
    Cross,
    /// Rims, joined and short pieces, repeated passes.
    Rim,
    /// The bead's width and height: both, or neither.
    BeadSize,
    /// The layers that beads are laid in.
    BeadLayers,
    /// The beam and its speeds.
    Beam,
    /// What the head keeps, and may give way by.
    Head,
    /// How far the beam may tilt.
    Tilt,
    /// How fast the beam may tilt.
    TiltRates,
    /// How wide the beam is along its axis.
    Optics,
    /// Which points become targets, and the leads before and behind a line.
    Targets,
    /// The scanned line, for its profile alone.
    ScannedLine,
    /// What is little and what is much of the dose.
    Dose,
    /// The robot cell.
    Cell,
    /// The part as a whole.
    Part,
    /// The scan of the part, and its patches.
    Scan,
    /// How areas are found in the grey image.
    WeldMask,
    /// What is taken off a bead, and when that is enough.
    WeldPasses,
    /// How the grinding tool is led.
    Grinding,
}

/// Whether single surfaces can have a value of their own, by a recipe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// One value for the whole program.
    Program,
    /// A recipe may hold it.
    Surface,
    /// A recipe may hold it, and is mostly about such: it is shown first.
    SurfaceFirst,
}

/// The earliest of what is computed that another value makes stale, with all that is made of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Affects {
    /// The part.
    Part,
    /// What the scan says of it, and its patches.
    Scan,
    /// What the camera's images say of it, and its areas.
    Weld,
    /// Its feature surfaces: their numbers mean other ones.
    Surfaces,
    /// Robot, head and clamps as they stand.
    Setup,
    /// Lines and plan.
    Plan,
    /// The dose alone.
    Dose,
}
