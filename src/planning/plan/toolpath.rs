//! The toolpath of a surface: its lines by strategy, rim and joins, and the order in which they are run.
//!
//! Geometry alone: whether a beam gets there is asked afterwards.

use super::remark::ToolpathRemark;
use super::taken_by::TakenBy;
use crate::document::model::{GrindingStrategy, Job, LineParameters};
use crate::part::ground::{CentrePoint, Ground};
use crate::part::surfaces::Surface;
use crate::part::{Part, SurfaceId, Surfaces, keyed};
use crate::path::along::{AlongSurface, along_lines};
use crate::path::coverage::{Coverage, coverage};
use crate::path::dense::max_gap_mm;
use crate::path::ends::{self, DroppedLines};
use crate::path::measured_lines::{MeasuredRules, measured_lines};
use crate::path::neighbour_axes::neighbour_axes;
use crate::path::normals::VertexNormals;
use crate::path::strategy::{self, Achieved, Layout, Strategy, SurfaceLines};
use crate::path::tour::{Sense, shift_seams, toured, way_mm};
use crate::path::{AxisSource, Order, SurfacePlanes, TransversalLine, order};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};

/// The lines of one surface, not yet in order.
#[derive(Clone, Debug)]
pub struct Toolpath {
    /// Surface number.
    pub surface: u32,
    /// Normal of its planes, by which the first corner is found.
    pub normal: Vector3<f64>,
    /// The planes that cut them: none for lines that no plane cuts.
    pub planes: Vec<SurfacePlanes>,
    /// The lines, by rank.
    pub lines: Vec<TransversalLine>,
    /// The spacing that they really have, where it was measured.
    pub achieved: Option<Achieved>,
    /// The area that they miss, and their spacing.
    pub coverage: Coverage,
    /// How they differ from what the job asks for.
    pub remarks: Vec<ToolpathRemark>,
    /// Layer of a build-up, from 0.
    pub layer: u32,
    /// How far closed lines begin behind their start, so that layers do not all begin at one place, mm.
    pub start_shift_mm: f64,
}

/// All that the lines of a surface depend on, beside the part and its planes.
pub struct ToolpathRules<'a> {
    /// Strategy, spacing, rim.
    pub layers: &'a LineParameters,
    /// The axis that the beam follows.
    pub axis: AxisSource,
    /// How far curves through measured points may lie off their chords, mm.
    pub chord_error_mm: f64,
    /// Every second layer runs across the others.
    pub is_alternate: bool,
    /// How far closed lines of a layer begin behind those of the one before, mm.
    pub start_shift_mm: f64,
    /// Layer of a build-up, from 0.
    pub layer: u32,
    /// Whether the surface's other side is worked on.
    pub is_flipped: bool,
    /// The centre line that lines are laid along; none where they are laid by their strategy.
    pub centre_line: &'a [CentrePoint],
    /// How far above it the surface may lie, mm.
    pub highest_mm: f64,
}

keyed!(ToolpathRules<'_> { layers, axis, chord_error_mm, is_alternate, start_shift_mm, layer, is_flipped, centre_line, highest_mm });

impl<'a> ToolpathRules<'a> {
    /// What the job of a surface wants for one layer.
    pub fn new(surfaces: &'a Surfaces, surface: u32, job: &'a Job, layer: u32) -> ToolpathRules<'a> {
        let ground = surfaces.ground(surface).filter(|_| job.weld.bead_strategy == GrindingStrategy::Along);
        ToolpathRules {
            layers: &job.layers,
            axis: job.path.axis,
            chord_error_mm: job.path.chord_error_mm,
            is_alternate: job.bead.alternate,
            start_shift_mm: job.bead.start_shift_mm,
            layer,
            is_flipped: job.settings.of(SurfaceId(surface)).flipped,
            centre_line: ground.map_or(&[], |g| &g.centre_line),
            highest_mm: ground.map_or(0.0, Ground::highest_mm),
        }
    }
}

/// The lines of a surface by its job; `family`: its planes. Part and surfaces are as they have grown when the layer
/// begins.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn plan_toolpath(
    part: &Part,
    surfaces: &Surfaces,
    surface: &Surface,
    family: SurfacePlanes,
    by: &ToolpathRules<'_>,
    progress: &Progress,
) -> Result<Toolpath, Cancelled> {
    let (mesh, l, layer) = (&part.mesh, by.layers, by.layer);
    let mut remarks = Vec::new();
    let is_across = layer % 2 == 1 && by.is_alternate;
    let family = match strategy::across(mesh, surface, &family, l.spacing_mm, 90.0).filter(|_| is_across) {
        Some(turned) => turned,
        None if is_across => {
            remarks.push(ToolpathRemark::LayersAlike);
            family
        }
        None => family,
    };
    let (found, mut taken_by) = lines_to_rim(part, surfaces, surface, (&family, by), &mut remarks, progress)?;
    progress.check()?;
    let lines = if l.join_mm > 0.0 { ends::joined(found.lines, l.join_mm) } else { found.lines };
    let (lines, DroppedLines { count, length_mm }) = ends::without_short(lines, l.shortest_mm);
    if count > 0 {
        remarks.push(ToolpathRemark::TooShort { pieces: count, length_mm, shortest_mm: l.shortest_mm });
    }
    if lines.is_empty() {
        let taken_by = *taken_by.get_or_insert(TakenBy::Shortest { shortest_mm: l.shortest_mm });
        remarks.push(ToolpathRemark::NoLines { taken_by, area_mm2: surface.area_mm2, layer });
    }
    remarks.extend(found.finding.map(ToolpathRemark::Lines));
    let mut coverage = coverage(mesh, surface, &found.planes, l.spacing_mm, &lines, progress)?;
    if l.strategy != Strategy::Planes {
        coverage.spacing_min_mm = found.achieved.as_ref().map(|a| a.min_mm);
        coverage.spacing_max_mm = found.achieved.as_ref().map(|a| a.max_mm);
    }
    Ok(Toolpath {
        surface: surface.number,
        normal: family.normal,
        planes: found.planes,
        lines,
        achieved: found.achieved,
        coverage,
        remarks,
        layer,
        start_shift_mm: f64::from(layer) * by.start_shift_mm,
    })
}

/// The lines of a strategy with their axes, ended where the job wants them at the rim: within it, on it or beyond it;
/// and what takes the last one, if none is left.
fn lines_to_rim(
    part: &Part,
    surfaces: &Surfaces,
    surface: &Surface,
    (family, by): (&SurfacePlanes, &ToolpathRules<'_>),
    remarks: &mut Vec<ToolpathRemark>,
    progress: &Progress,
) -> Result<(SurfaceLines, Option<TakenBy>), Cancelled> {
    let (mesh, l) = (&part.mesh, by.layers);
    if !by.centre_line.is_empty() {
        return Ok(along_centre_line(part, surfaces, surface, by));
    }
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
    if over_mm > 0.0 {
        let grown = ends::extended(mesh, surface, over_mm);
        progress.check()?;
        let normals = VertexNormals::extended(mesh, surfaces, surface, &grown.beyond);
        let family = widened(mesh, &grown.surface, family.clone(), l.spacing_mm);
        let mut found = strategy::lines_under(progress, (mesh, &grown.surface, &normals), &rule, &family, merge_mm)?;
        let taken_by = TakenBy::strategy(&found, mesh, surface, &family, l);
        apply_axes(&mut found.lines, by);
        progress.check()?;
        let (lines, stopped) = ends::run_over(mesh, surface, &grown, found.lines);
        found.lines = lines;
        if stopped > 0 {
            remarks.push(ToolpathRemark::StopsAtRim { ends: stopped });
        }
        let is_none = found.lines.is_empty();
        Ok((found, taken_by.or(is_none.then_some(TakenBy::Inset { inset_mm: l.inset_mm }))))
    } else {
        let normals = VertexNormals::new_under(progress, mesh, surfaces, surface)?;
        let mut found = strategy::lines_under(progress, (mesh, surface, &normals), &rule, family, merge_mm)?;
        through_points((part, surfaces, surface), &mut found, by, progress)?;
        let taken_by = TakenBy::strategy(&found, mesh, surface, family, l);
        apply_axes(&mut found.lines, by);
        if l.inset_mm > 0.0 && taken_by.is_none() {
            progress.check()?;
            let taken_by = inset(part, surface, &mut found, l);
            return Ok((found, taken_by));
        }
        Ok((found, taken_by))
    }
}

/// The lines along the centre line of a bead.
fn along_centre_line(
    part: &Part,
    surfaces: &Surfaces,
    surface: &Surface,
    by: &ToolpathRules<'_>,
) -> (SurfaceLines, Option<TakenBy>) {
    let spacing_mm = by.layers.spacing_mm;
    let on = AlongSurface { bvh: &part.bvh, surfaces, number: surface.number, highest_mm: by.highest_mm };
    let lines = along_lines(&on, by.centre_line, spacing_mm);
    let taken_by = lines.is_empty().then_some(TakenBy::Spacing { spacing_mm });
    (SurfaceLines { lines, ..SurfaceLines::default() }, taken_by)
}

/// Lays the lines of planes through the points that were measured, where there are such.
fn through_points(
    of: (&Part, &Surfaces, &Surface),
    found: &mut SurfaceLines,
    by: &ToolpathRules<'_>,
    progress: &Progress,
) -> Result<(), Cancelled> {
    let Some(measured) = of.1.measured.as_ref().filter(|_| !found.planes.is_empty()) else { return Ok(()) };
    let rules = MeasuredRules { step_mm: max_gap_mm(by.layers.spacing_mm), chord_mm: by.chord_error_mm };
    let (mut lines, mut rank) = (Vec::new(), 0);
    for planes in &found.planes {
        lines.extend(measured_lines(of, measured, (planes, rank), &rules, progress)?);
        rank += planes.heights_mm.len();
    }
    found.lines = lines;
    Ok(())
}

/// Draws lines back from the rim; returns what takes the last one, if none is left.
fn inset(part: &Part, surface: &Surface, found: &mut SurfaceLines, l: &LineParameters) -> Option<TakenBy> {
    let within = |ignore_holes_mm| ends::inset(&part.mesh, surface, found.lines.clone(), l.inset_mm, ignore_holes_mm);
    let kept = within(l.ignore_holes_mm);
    let inset_mm = l.inset_mm;
    let taken_by = kept.is_empty().then(|| match within(f64::INFINITY).is_empty() {
        true => TakenBy::Inset { inset_mm },
        false => TakenBy::Holes { inset_mm },
    });
    found.lines = kept;
    taken_by
}

/// Gives lines the axes that the job wants in place of the mesh's normals.
fn apply_axes(lines: &mut [TransversalLine], by: &ToolpathRules<'_>) {
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

impl Toolpath {
    /// What takes the last of its lines, where there is none.
    pub fn taken_by(&self) -> Option<TakenBy> {
        self.remarks.iter().find_map(|remark| match remark {
            ToolpathRemark::NoLines { taken_by, .. } => Some(*taken_by),
            _ => None,
        })
    }

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
    /// The lines in the order and sense in which they are run.
    pub lines: Vec<TransversalLine>,
    /// Length of the way between them, and from the surface before, mm.
    pub way_mm: f64,
    /// Length of the way in a plain zigzag, mm.
    pub zigzag_way_mm: f64,
}

/// Puts lines in order; `spot`: where the surface before ends.
pub fn ordered(toolpath: &Toolpath, layers: &LineParameters, spot: Option<&Point3<f64>>) -> Ordered {
    // The pieces of a spiral come in order, and run as it does.
    let is_spiral = layers.strategy == Strategy::Spiral;
    let by = |order| match is_spiral {
        true => toolpath.lines.clone(),
        false => order::ordered(toolpath.lines.clone(), order, &toolpath.normal),
    };
    let zigzag = by(Order::Zigzag);
    let zigzag_way_mm = way_mm(&zigzag, spot);
    let mut lines = match layers.order {
        Order::Zigzag => zigzag,
        Order::OneWay => by(Order::OneWay),
        Order::Shortest if is_spiral => toured(toolpath.lines.clone(), spot, Sense::Kept, &toolpath.normal),
        Order::Shortest => toured(toolpath.lines.clone(), spot, Sense::Either, &toolpath.normal),
    };
    if layers.seam_shift_mm > 0.0 {
        let first_mm = lines.iter().find(|l| l.closed).map_or(1.0, TransversalLine::length_mm);
        shift_seams(&mut lines, layers.seam_shift_mm, toolpath.start_shift_mm / first_mm);
    } else if toolpath.start_shift_mm > 0.0 {
        for line in &mut lines {
            let share = toolpath.start_shift_mm / line.length_mm();
            shift_seams(std::slice::from_mut(line), 0.0, share);
        }
    }
    Ordered { way_mm: way_mm(&lines, spot), zigzag_way_mm, lines }
}

/// Where the spot is after the last of some lines.
pub fn end_of(lines: &[TransversalLine]) -> Option<Point3<f64>> {
    let last = lines.last()?;
    let end = if last.closed { last.points.first() } else { last.points.last() };
    end.map(|q| q.p)
}
