//! What lies at the place that was right clicked in the view.

use super::context::Context;
use crate::part::SurfaceId;
use crate::path::Strategy;
use nalgebra::Point3;

impl Context<'_> {
    /// The place, mm in the part's frame, with its surface.
    fn menu_place(self) -> Option<(SurfaceId, Point3<f64>)> {
        let (facet, at) = self.session.menu_place?;
        Some((SurfaceId(self.surface_of(facet)?), at))
    }

    /// The place and its surface, if that is worked in a spiral.
    pub fn spiral_place(self) -> Option<(SurfaceId, Point3<f64>)> {
        let job = self.document.job();
        self.menu_place().filter(|(surface, _)| job.of_surface(*surface).layers.strategy == Strategy::Spiral)
    }

    /// The surface there, if it is worked in offset lines.
    pub fn offset_surface(self) -> Option<SurfaceId> {
        let (surface, _) = self.menu_place()?;
        self.document.job().offset_start(surface).is_some().then_some(surface)
    }

    /// The border nearest to the place, with its surface, if that is worked in offset lines.
    pub fn border_place(self) -> Option<(SurfaceId, u32)> {
        let surface = self.offset_surface()?;
        let (_, at) = self.menu_place()?;
        Some((surface, self.borders.nearest(surface.0, &at)?))
    }
}
