//! One feature surface, and the list of all of them by the number of each facet.

use super::topology::Mesh;
use std::collections::BTreeMap;

/// One feature surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Its number.
    pub number: u32,
    /// Its facets in file order.
    pub facets: Vec<u32>,
    /// Its area, mm².
    pub area_mm2: f64,
}

/// The surfaces of a numbering, in the order of their numbers.
pub(super) fn listed(mesh: &Mesh, of_facet: &[u32]) -> Vec<Surface> {
    let mut list: BTreeMap<u32, Surface> = BTreeMap::new();
    for (f, &number) in of_facet.iter().enumerate() {
        let s = list.entry(number).or_insert_with(|| Surface { number, ..Default::default() });
        s.facets.push(f as u32);
        s.area_mm2 += mesh.areas[f];
    }
    list.into_values().collect()
}
