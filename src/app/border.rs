//! Borders of surfaces that are worked in offset lines: which are chosen, drawn on the part, and which is nearest
//! to a place.

use crate::part::{Part, Surfaces};
use crate::path::strategy::offset::{Border, borders};
use crate::picture::border;
use crate::text::{fixed, id, say};
use crate::view::LineItem;
use nalgebra::Point3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The borders that were asked for, and what is drawn of them.
#[derive(Default)]
pub(super) struct Borders {
    /// The feature surfaces that the borders belong to.
    of: Option<Arc<Surfaces>>,
    known: BTreeMap<u32, Vec<Border>>,
    /// Surface and border of what is drawn.
    chosen: Vec<(u32, u32)>,
    lines: Vec<LineItem>,
}

impl Borders {
    /// Finds the borders of the surfaces in `chosen`, whose chosen borders (surface, border) are drawn, and of one surface
    /// besides.
    pub fn sync(&mut self, part: &Part, surfaces: &Arc<Surfaces>, chosen: Vec<(u32, u32)>, besides: Option<u32>) {
        if self.of.as_ref().is_none_or(|of| !Arc::ptr_eq(of, surfaces)) {
            *self = Borders { of: Some(surfaces.clone()), ..Borders::default() };
        }
        for n in chosen.iter().map(|c| c.0).chain(besides) {
            if let Some(surface) = surfaces.get(n) {
                self.known.entry(n).or_insert_with(|| borders(&part.mesh, surface));
            }
        }
        if self.chosen != chosen {
            let border = |(n, index): &(u32, u32)| self.known.get(n)?.get(*index as usize);
            self.lines = chosen.iter().filter_map(border).map(border::item).collect();
            self.chosen = chosen;
        }
    }

    /// The borders that are chosen, as lines on the part.
    pub fn lines(&self) -> &[LineItem] {
        &self.lines
    }

    /// The border of a surface that is nearest to a point.
    pub fn nearest(&self, surface: u32, at: &Point3<f64>) -> Option<u32> {
        let distance_mm = |b: &Border| b.edges.iter().map(|e| to_edge_mm(e, at)).fold(f64::INFINITY, f64::min);
        let loops = self.known.get(&surface)?.iter().map(distance_mm).enumerate();
        let (index, _) = loops.min_by(|a, b| a.1.total_cmp(&b.1))?;
        u32::try_from(index).ok()
    }

    /// A border in words.
    pub fn words(&self, surface: u32, index: u32) -> Option<String> {
        let all = self.known.get(&surface)?;
        let border = all.get(index as usize)?;
        Some(say!(
            view_border,
            number = id(u64::from(index) + 1),
            count = all.len(),
            surface = id(surface),
            length_mm = fixed(border.length_mm, 1)
        ))
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
