//! What `inspect` prints for people, and the names of shapes.

use super::part::size;
use super::{exact, fixed, say};
use crate::part::Shape;
use crate::part::inspect::InspectReport;

/// The report of a part: counts, size, and a table of its surfaces; every line ends with a line break.
pub(crate) fn inspected(r: &InspectReport) -> String {
    use std::fmt::Write as _;
    let mut out = say!(inspect_counts, facets = r.facets, vertices = r.vertices, edges = r.edges);
    let shells = r.shells;
    let shells = if r.watertight { say!(inspect_watertight, shells) } else { say!(inspect_open, shells) };
    let [low, high] = [r.bounds_mm.min, r.bounds_mm.max];
    let size_mm = std::array::from_fn(|k| high[k] - low[k]);
    let size = say!(inspect_size, size = size(&size_mm, 3), area = fixed(r.area_mm2, 2));
    let _ = write!(out, "\n{shells}\n{size}\n");
    if let Some(volume_mm3) = r.volume_mm3 {
        let _ = writeln!(out, "{}", say!(inspect_volume, volume = fixed(volume_mm3, 2)));
    }
    let surfaces = say!(inspect_surfaces, count = r.surfaces.len(), angle = exact(r.angle_deg));
    let _ = writeln!(out, "{surfaces}");
    let columns = [say!(inspect_column_surface), say!(inspect_column_facets), say!(inspect_column_area)];
    let [surface, facets, area] = columns;
    let _ = writeln!(out, "{surface:>8} {facets:>8} {area:>14}  {}", say!(inspect_column_shape));
    for s in &r.surfaces {
        let _ = writeln!(out, "{:>8} {:>8} {:>14.3}  {}", s.surface, s.facets, s.area_mm2, name(&s.shape));
    }
    out
}

/// A shape with its size: `cylinder Ø12.00`.
pub(crate) fn shape_label(shape: &Shape) -> String {
    match shape {
        Shape::Cylinder { diameter_mm, .. } | Shape::Sphere { diameter_mm, .. } => {
            say!(shape_with_diameter, shape = name(shape), diameter = fixed(*diameter_mm, 2))
        }
        Shape::Cone { half_angle_deg, .. } => {
            say!(shape_with_angle, shape = name(shape), angle = fixed(*half_angle_deg, 1))
        }
        Shape::Plane { .. } | Shape::Freeform => name(shape),
    }
}

fn name(shape: &Shape) -> String {
    match shape {
        Shape::Plane { .. } => say!(shape_plane),
        Shape::Cylinder { .. } => say!(shape_cylinder),
        Shape::Cone { .. } => say!(shape_cone),
        Shape::Sphere { .. } => say!(shape_sphere),
        Shape::Freeform => say!(shape_freeform),
    }
}
