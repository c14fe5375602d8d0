//! Borders of surfaces that are worked in offset lines: which is chosen, drawn on the part, and which is nearest
//! to the place that was right clicked.

use super::App;
use crate::document::StartFrom;
use crate::part::{SurfaceId, Surfaces};
use crate::path::strategy::offset::{Border, borders};
use crate::picture::border;
use crate::text::Sentence;
use crate::view::LineItem;
use nalgebra::Point3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The borders that were asked for, and what is drawn of them.
#[derive(Default)]
pub(super) struct Borders {
    /// The surfaces that they are of.
    of: Option<Arc<Surfaces>>,
    known: BTreeMap<u32, Vec<Border>>,
    /// Surface and border of what is drawn.
    chosen: Vec<(u32, u32)>,
    lines: Vec<LineItem>,
}

impl App {
    /// Finds the borders that are chosen, and those of the surface that was right clicked.
    pub(super) fn sync_borders(&mut self) {
        let Some(part) = self.derived.part.clone() else { return };
        let surfaces = self.derived.surfaces.clone();
        if self.borders.of.as_ref().is_none_or(|of| !Arc::ptr_eq(of, &surfaces)) {
            self.borders = Borders { of: Some(surfaces.clone()), ..Borders::default() };
        }
        let job = self.document.job();
        let start = |n: u32| Some((n, job.offset_start(SurfaceId(n))?.border()?));
        let chosen: Vec<(u32, u32)> = self.clean_list().into_iter().filter_map(start).collect();
        let menu = self.menu_surface().filter(|n| job.offset_start(SurfaceId(*n)).is_some());
        for n in chosen.iter().map(|c| c.0).chain(menu) {
            if let Some(surface) = surfaces.get(n) {
                self.borders.known.entry(n).or_insert_with(|| borders(&part.mesh, surface));
            }
        }
        if self.borders.chosen != chosen {
            let known = &self.borders.known;
            let border = |(n, index): &(u32, u32)| known.get(n)?.get(*index as usize);
            self.borders.lines = chosen.iter().filter_map(border).map(border::item).collect();
            self.borders.chosen = chosen;
        }
    }

    /// The borders that are chosen, as lines on the part.
    pub(super) fn border_lines(&self) -> &[LineItem] {
        &self.borders.lines
    }

    fn menu_surface(&self) -> Option<u32> {
        self.derived.surfaces.of_facet.get(self.session.menu_place?.0 as usize).copied()
    }

    /// The border nearest to the place that was right clicked, if the surface there is worked in offset lines:
    /// surface and border.
    pub(super) fn border_place(&self) -> Option<(u32, u32)> {
        let (_, at) = self.session.menu_place?;
        let surface = self.menu_surface().filter(|n| self.document.job().offset_start(SurfaceId(*n)).is_some())?;
        let distance_mm = |b: &Border| b.edges.iter().map(|e| to_edge_mm(e, &at)).fold(f64::INFINITY, f64::min);
        let loops = self.borders.known.get(&surface)?.iter().map(distance_mm).enumerate();
        let (index, _) = loops.min_by(|a, b| a.1.total_cmp(&b.1))?;
        Some((surface, u32::try_from(index).ok()?))
    }

    /// A border in words.
    pub(super) fn border_words(&self, surface: u32, index: u32) -> Option<String> {
        let all = self.borders.known.get(&surface)?;
        let border = all.get(index as usize)?;
        let name = StartFrom::Border(index).sentence();
        Some(format!("{name} of {} of surface {surface}, {:.1} mm long", all.len(), border.length_mm))
    }
}

/// Distance of a point from an edge, mm.
fn to_edge_mm([a, b]: &[Point3<f64>; 2], p: &Point3<f64>) -> f64 {
    let along = b - a;
    let share = (p - a).dot(&along) / along.norm_squared();
    // An edge without length is a point.
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    (p - (a + along * share)).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_is_as_near_as_its_nearest_point() {
        let edge = [Point3::new(0.0, 0.0, 0.0), Point3::new(4.0, 0.0, 0.0)];
        for (at, mm) in [([2.0, 3.0, 0.0], 3.0), ([7.0, 4.0, 0.0], 5.0), ([-1.0, 0.0, 0.0], 1.0)] {
            assert_eq!(to_edge_mm(&edge, &Point3::from(at)), mm);
        }
        let point = [Point3::new(1.0, 0.0, 0.0); 2];
        assert_eq!(to_edge_mm(&point, &Point3::new(1.0, 2.0, 0.0)), 2.0);
    }
}
