//! From a job to the lines of its surfaces: strategy, rim, joins, and the order of work.
//!
//! Geometry alone: whether a beam gets there is asked afterwards.

use super::remark::LayingRemark;
use crate::document::model::{Job, Layers};
use crate::part::surfaces::Surface;
use crate::part::{Part, SurfaceId, Surfaces, keyed};
use crate::path::coverage::{Coverage, coverage};
use crate::path::ends::{self, DroppedLines};
use crate::path::neighbour_axes::neighbour_axes;
use crate::path::normals::VertexNormals;
use crate::path::strategy::{self, Achieved, Layout, Strategy};
use crate::path::tour::{Sense, shift_seams, toured, way_mm};
use crate::path::{AxisSource, Order, SurfacePlanes, TransversalLine, order};
use nalgebra::{Point3, Vector3};

/// The lines of one surface, not yet in order.
#[derive(Clone, Debug)]
pub struct Laid {
    /// Surface number.
    pub surface: u32,
    /// Normal of its planes, by which the first corner is found.
    pub normal: Vector3<f64>,
    /// The planes that cut them: none for lines that no plane cuts.
    pub planes: Vec<SurfacePlanes>,
    /// By rank.
    pub lines: Vec<TransversalLine>,
    /// The spacing that they really have, where it was measured.
    pub achieved: Option<Achieved>,
    /// What they miss.
    pub coverage: Coverage,
    /// What is not as it was wanted.
    pub remarks: Vec<LayingRemark>,
    /// Layer of a build-up, from 0.
    pub layer: u32,
    /// How far closed lines begin behind their start, so that layers do not all begin at one place, mm.
    pub start_shift_mm: f64,
}

/// All that the lines of a surface depend on, beside the part and its planes.
pub struct LayingRules<'a> {
    /// Strategy, spacing, rim.
    pub layers: &'a Layers,
    /// What the beam stands along.
    pub axis: AxisSource,
    /// Every second layer runs across the others.
    pub is_alternate: bool,
    /// How far closed lines of a layer begin behind those of the one before, mm.
    pub start_shift_mm: f64,
    /// Layer of a build-up, from 0.
    pub layer: u32,
    /// Whether the surface's other side is worked on.
    pub is_flipped: bool,
}

keyed!(LayingRules<'_> { layers, axis, is_alternate, start_shift_mm, layer, is_flipped });

impl<'a> LayingRules<'a> {
    /// What the job of a surface wants for one layer.
    pub fn new(surface: u32, job: &'a Job, layer: u32) -> LayingRules<'a> {
        LayingRules {
            layers: &job.layers,
            axis: job.path.axis,
            is_alternate: job.bead.alternate,
            start_shift_mm: job.bead.start_shift_mm,
            layer,
            is_flipped: job.settings.of(SurfaceId(surface)).flipped,
        }
    }
}

/// Lays the lines of a surface; `family`: its planes. Part and surfaces are as they have grown when the layer
/// begins.
pub fn laid(part: &Part, surfaces: &Surfaces, surface: &Surface, family: SurfacePlanes, by: &LayingRules<'_>) -> Laid {
    let (mesh, l, layer) = (&part.mesh, by.layers, by.layer);
    let merge_mm = 1e-6 * mesh.diagonal();
    let over_mm = (-l.inset_mm).max(0.0);
    let rule = Layout {
        strategy: l.strategy,
        spacing_mm: l.spacing_mm,
        border: l.border.map(|b| b as usize),
        centre: l.centre_mm.map(Point3::from),
        inward: l.inward,
        cross_deg: l.cross_deg,
    };
    let mut remarks = Vec::new();
    let is_across = layer % 2 == 1 && by.is_alternate;
    let family = match strategy::across(mesh, surface, &family, l.spacing_mm, 90.0).filter(|_| is_across) {
        Some(turned) => turned,
        None if is_across => {
            remarks.push(LayingRemark::LayersAlike);
            family
        }
        None => family,
    };
    let mut found;
    if over_mm > 0.0 {
        let extended = ends::extended(mesh, surface, over_mm);
        let normals = VertexNormals::extended(mesh, surfaces, surface, &extended.beyond);
        let family = widened(mesh, &extended.surface, family.clone(), l.spacing_mm);
        found = strategy::lines(mesh, &extended.surface, &normals, &rule, &family, merge_mm);
        stand(&mut found.lines, by);
        let (lines, stopped) = ends::run_over(mesh, surface, &extended, found.lines);
        found.lines = lines;
        if stopped > 0 {
            remarks.push(LayingRemark::StopsAtRim { ends: stopped });
        }
    } else {
        let normals = VertexNormals::new(mesh, surfaces, surface);
        found = strategy::lines(mesh, surface, &normals, &rule, &family, merge_mm);
        stand(&mut found.lines, by);
        if l.inset_mm > 0.0 {
            found.lines = ends::inset(mesh, surface, found.lines, l.inset_mm, l.ignore_holes_mm);
        }
    }
    let lines = if l.join_mm > 0.0 { ends::joined(found.lines, l.join_mm) } else { found.lines };
    let (lines, DroppedLines { count, length_mm }) = ends::without_short(lines, l.shortest_mm);
    if count > 0 {
        remarks.push(LayingRemark::TooShort { pieces: count, length_mm, shortest_mm: l.shortest_mm });
    }
    remarks.extend(found.finding.map(LayingRemark::Lines));
    let mut coverage = coverage(mesh, surface, &found.planes, l.spacing_mm, &lines);
    if l.strategy != Strategy::Planes {
        coverage.spacing_min_mm = found.achieved.as_ref().map(|a| a.min_mm);
        coverage.spacing_max_mm = found.achieved.as_ref().map(|a| a.max_mm);
    }
    Laid {
        surface: surface.number,
        normal: family.normal,
        planes: found.planes,
        lines,
        achieved: found.achieved,
        coverage,
        remarks,
        layer,
        start_shift_mm: f64::from(layer) * by.start_shift_mm,
    }
}

/// Gives lines the axes that the job wants in place of the mesh's normals.
fn stand(lines: &mut [TransversalLine], by: &LayingRules<'_>) {
    if by.axis == AxisSource::Neighbours {
        neighbour_axes(lines, by.layers.spacing_mm);
    }
}

/// A family with more planes of the same distance, as far as an extended surface goes.
fn widened(mesh: &crate::part::Mesh, surface: &Surface, mut family: SurfacePlanes, spacing_mm: f64) -> SurfacePlanes {
    let corners = surface.facets.iter().flat_map(|&f| mesh.corners(f as usize));
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for h in corners.map(|p| p.coords.dot(&family.normal)) {
        (low, high) = (low.min(h), high.max(h));
    }
    let (Some(&first), Some(&last)) = (family.heights_mm.first(), family.heights_mm.last()) else { return family };
    let below = (1..).map(|i| first - f64::from(i) * spacing_mm).take_while(|h| *h > low);
    let above = (1..).map(|i| last + f64::from(i) * spacing_mm).take_while(|h| *h < high);
    family.heights_mm = below.chain(family.heights_mm.iter().copied()).chain(above).collect();
    family.heights_mm.sort_by(f64::total_cmp);
    family
}

impl Laid {
    /// Normal of the plane that a line lies in, if it lies in one.
    pub fn plane_of(&self, line: &TransversalLine) -> Option<Vector3<f64>> {
        let mut rank = line.plane;
        for planes in &self.planes {
            if rank < planes.heights_mm.len() {
                return Some(planes.normal);
            }
            rank -= planes.heights_mm.len();
        }
        None
    }
}

/// The lines of one surface in the order of work.
#[derive(Clone, Debug)]
pub struct Ordered {
    /// In order, turned as they will be run.
    pub lines: Vec<TransversalLine>,
    /// Length of the way between them, and from the surface before, mm.
    pub way_mm: f64,
    /// Length of the way in a plain zigzag, mm.
    pub zigzag_way_mm: f64,
}

/// Puts lines in order; `spot`: where the surface before ends.
pub fn ordered(laid: &Laid, layers: &Layers, spot: Option<&Point3<f64>>) -> Ordered {
    // The pieces of a spiral come in order, and run as it does.
    let is_spiral = layers.strategy == Strategy::Spiral;
    let by = |order| match is_spiral {
        true => laid.lines.clone(),
        false => order::ordered(laid.lines.clone(), order, &laid.normal),
    };
    let zigzag = by(Order::Zigzag);
    let zigzag_way_mm = way_mm(&zigzag, spot);
    let mut lines = match layers.order {
        Order::Zigzag => zigzag,
        Order::OneWay => by(Order::OneWay),
        Order::Shortest if is_spiral => toured(laid.lines.clone(), spot, Sense::Kept, &laid.normal),
        Order::Shortest => toured(laid.lines.clone(), spot, Sense::Either, &laid.normal),
    };
    if layers.seam_shift_mm > 0.0 {
        let first_mm = lines.iter().find(|l| l.closed).map_or(1.0, TransversalLine::length_mm);
        shift_seams(&mut lines, layers.seam_shift_mm, laid.start_shift_mm / first_mm);
    } else if laid.start_shift_mm > 0.0 {
        for line in &mut lines {
            let share = laid.start_shift_mm / line.length_mm();
            shift_seams(std::slice::from_mut(line), 0.0, share);
        }
    }
    Ordered { way_mm: way_mm(&lines, spot), zigzag_way_mm, lines }
}

/// Where the spot is behind some lines.
pub fn end_of(lines: &[TransversalLine]) -> Option<Point3<f64>> {
    let last = lines.last()?;
    let end = if last.closed { last.points.first() } else { last.points.last() };
    end.map(|q| q.p)
}
