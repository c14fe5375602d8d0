//! How long one-way, zigzag and spiral take for an area at the four speeds that P4 compares (Table 1), by the motion model.
//! The lines are those that a plan would have; what a robot could not reach of them is not left out.

use super::MeasuredWeld;
use super::report_rows::AreaTimes;
use crate::document::Job;
use crate::part::patched::PatchSurface;
use crate::part::{Part, Surfaces};
use crate::path::along_rim::along_rim;
use crate::path::back_and_forth::{REACH_IN_SPACINGS, back_and_forth};
use crate::path::motion_time::{ToolMotion, path_time};
use crate::path::normals::VertexNormals;
use crate::path::planes::{self, PlaneRaster};
use crate::path::strategy::{self, Layout, Strategy};
use crate::path::{Direction, Order, TransversalLine, order};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Rotation3};

/// The speeds that P4 compares, mm/s.
const SPEEDS_MM_S: [f64; 4] = [50.0, 70.0, 90.0, 110.0];

/// A tool that leaves the surface is lifted so far at least before it goes on, mm.
const LIFT_MM: f64 = 10.0;

/// The times of the first area of each kind. `on`: the part without its bead, and the surfaces of the areas on it.
///
/// # Errors
/// [`Cancelled`] when the work should end.
pub fn area_times(
    measured: &MeasuredWeld,
    (part, surfaces): (&Part, &Surfaces),
    patches: &[Vec<PatchSurface>],
    job: &Job,
    progress: &Progress,
) -> Result<Vec<AreaTimes>, Cancelled> {
    let mut out: Vec<AreaTimes> = Vec::new();
    for (area, pieces) in measured.areas.iter().zip(patches) {
        if out.iter().any(|t| t.area == area.kind()) {
            continue;
        }
        let mut ways: [Vec<Vec<Point3<f64>>>; 3] = Default::default();
        for piece in pieces {
            let of_piece = ways_of((part, surfaces), piece.surface.0, job.layers.spacing_mm, progress)?;
            ways.iter_mut().zip(of_piece).for_each(|(all, of)| all.extend(of));
        }
        let lifts = ways.each_ref().map(|pieces| pieces.len().saturating_sub(1) as u32);
        out.extend(SPEEDS_MM_S.map(|speed_mm_s| {
            let motion = ToolMotion {
                speed_mm_s,
                acceleration_mm_s2: job.weld.acceleration_mm_s2,
                arc_mm: job.weld.arc_mm,
                lift_mm: LIFT_MM,
                air_speed_mm_s: job.beam.air_speed_mm_s,
            };
            let [one_way_s, zigzag_s, spiral_s] = ways.each_ref().map(|pieces| path_time(pieces, &motion).total_s());
            AreaTimes { area: area.kind(), speed_mm_s, one_way_s, zigzag_s, spiral_s, lifts }
        }));
    }
    Ok(out)
}

/// The ways of the tool on a surface without lifting, by one-way, zigzag and spiral.
fn ways_of(
    (part, surfaces): (&Part, &Surfaces),
    number: u32,
    spacing_mm: f64,
    progress: &Progress,
) -> Result<[Vec<Vec<Point3<f64>>>; 3], Cancelled> {
    let raster = PlaneRaster { surface: number, direction: Direction::Auto, spacing_mm, offset_mm: None };
    let families = planes::planes(&part.mesh, surfaces, &[raster], &Rotation3::identity());
    let (Some(family), Some(surface)) = (families.first(), surfaces.get(number)) else { return Ok(Default::default()) };
    let normals = VertexNormals::new_under(progress, &part.mesh, surfaces, surface)?;
    let merge_mm = 1e-6 * part.mesh.diagonal();
    let laid = |by: Strategy| {
        let rule = Layout::new(by, spacing_mm);
        strategy::lines_under(progress, (&part.mesh, surface, &normals), &rule, family, merge_mm)
            .map(|found| found.lines)
    };
    let (raster, spiral) = (laid(Strategy::Planes)?, laid(Strategy::Spiral)?);
    let ordered = |by: Order| order::ordered(raster.clone(), by, &family.normal);
    let zigzag = back_and_forth(ordered(Order::Zigzag), REACH_IN_SPACINGS * spacing_mm);
    let spiral = along_rim(&part.mesh, surface, &normals, spiral);
    Ok([ordered(Order::OneWay), zigzag, spiral].map(|lines| lines.iter().flat_map(pieces).collect()))
}

/// The lit pieces of a line; a closed one ends where it began.
fn pieces(line: &TransversalLine) -> Vec<Vec<Point3<f64>>> {
    let mut out: Vec<Vec<Point3<f64>>> = line.pieces().map(|piece| piece.iter().map(|q| q.p).collect()).collect();
    if let (true, Some(first), Some(last)) = (line.closed, line.points.first(), out.last_mut()) {
        last.push(first.p);
    }
    out
}
