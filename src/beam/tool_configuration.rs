//! A tool configuration: process settings together with the space that the tool takes up under them. A line that
//! cannot be reached with the first configuration may be planned with another, the head drawn back.

use super::{Optics, ProcessSettings, Tool, ToolGeometry};

/// Process settings, and the geometry of the tool under them.
#[derive(Clone, Debug)]
pub struct ToolConfiguration<'a> {
    /// What a line is made with.
    pub settings: ProcessSettings,
    /// Cone, head and clamps; `None`: the beam is a ray, and there is nothing else.
    pub geometry: Option<ToolGeometry<'a>>,
}

impl<'a> ToolConfiguration<'a> {
    /// The configuration of a tool. `margin_mm`: the clearance that cone and head keep from everything.
    pub fn new(tool: &'a Tool, optics: &Optics, settings: ProcessSettings, margin_mm: f64) -> ToolConfiguration<'a> {
        let geometry = ToolGeometry::new(tool, optics, settings.spot_mm, settings.defocus_mm, margin_mm);
        ToolConfiguration { settings, geometry }
    }

    /// The beam as a ray.
    pub fn ray(settings: ProcessSettings) -> ToolConfiguration<'a> {
        ToolConfiguration { settings, geometry: None }
    }
}
