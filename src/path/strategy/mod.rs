//! Which lines the spot runs on a surface: parallel planes, planes that follow its slope, lines at
//! equal distance from its border, one spiral, or two rasters across each other.
//!
//! [`lines()`] lays them, [`across`] turns planes about a surface, and [`offset`] finds its borders. All is geometry:
//! the order and sense in which lines are run are the business of `path::order` and `path::tour`.

pub mod adaptive;
mod finding;
mod geodesic_distance;
pub mod offset;
mod radial;
mod ranked_segments;
mod refine;
pub mod spacing;
mod spiral;
mod surface_mesh;
mod winding;

use super::live_facets::{extent, live};
use super::normals::VertexNormals;
use super::planes::{self, SurfacePlanes};
use super::section::{TransversalLine, sections_under};
use crate::part::{Mesh, angle, surfaces::Surface};
use crate::progress::{Cancelled, Progress};
pub use finding::LinesFinding;
use nalgebra::{Point3, Vector3};
use serde::{Deserialize, Serialize};
pub use spacing::Achieved;

/// How lines are laid on a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Strategy {
    /// Parallel planes at equal heights (P2 4.2.1).
    #[default]
    Planes,
    /// Parallel planes, nearer where the surface slopes, so that the spacing on it is kept.
    Adaptive,
    /// Lines at equal distance from the border, measured over the surface.
    Offset,
    /// One spiral with equal distance between its turns (P4 5).
    Spiral,
    /// Two rasters of planes across each other.
    Cross,
}

crate::part::keyed_words!(Strategy: Planes, Adaptive, Offset, Spiral, Cross);

impl Strategy {
    /// All of them, in the order of lists.
    pub const ALL: [Strategy; 5] =
        [Strategy::Planes, Strategy::Adaptive, Strategy::Offset, Strategy::Spiral, Strategy::Cross];

    /// The word used on the command line and in jobs.
    pub fn word(self) -> &'static str {
        match self {
            Strategy::Planes => "planes",
            Strategy::Adaptive => "adaptive",
            Strategy::Offset => "offset",
            Strategy::Spiral => "spiral",
            Strategy::Cross => "cross",
        }
    }

    /// The strategy of that word.
    pub fn from_word(word: &str) -> Option<Strategy> {
        Strategy::ALL.into_iter().find(|s| s.word() == word)
    }
}

/// What a surface's lines follow from, beside its planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// How lines are laid.
    pub strategy: Strategy,
    /// Wanted distance of neighbouring lines, mm: on the surface, for planes from plane to plane.
    pub spacing_mm: f64,
    /// For `Offset`: the border loop to start from, 0 the longest; `None` the whole outline.
    pub border: Option<usize>,
    /// For `Spiral`: its centre in the part frame, or the nearest point of the surface to it; `None`:
    /// the middle of the surface.
    pub centre: Option<Point3<f64>>,
    /// For `Spiral`: from the rim to the centre.
    pub inward: bool,
    /// For `Cross`: from the first planes' normal to the second's, degrees.
    pub cross_deg: f64,
}

impl Layout {
    /// A strategy with default choices: whole outline, middle, outward, square across.
    pub fn new(strategy: Strategy, spacing_mm: f64) -> Layout {
        Layout { strategy, spacing_mm, border: None, centre: None, inward: false, cross_deg: 90.0 }
    }
}

/// The lines of one surface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SurfaceLines {
    /// By ascending rank.
    pub lines: Vec<TransversalLine>,
    /// The spacing that they really have; `None` where no two are neighbours.
    pub achieved: Option<Achieved>,
    /// The planes that cut them, for `coverage`: none for offset and spiral, two for a cross.
    pub planes: Vec<SurfacePlanes>,
    /// How they differ from what was asked for; without lines, why there are none.
    pub finding: Option<LinesFinding>,
}

/// Lays the lines of a surface by a rule. `family` is its family of equal planes: of it `Planes` and
/// `Cross` take all, `Adaptive` the normal alone.
///
/// Points closer than `merge_mm` are merged; lines shorter than that are dropped.
pub fn lines(
    mesh: &Mesh,
    surface: &Surface,
    normals: &VertexNormals,
    rule: &Layout,
    family: &SurfacePlanes,
    merge_mm: f64,
) -> SurfaceLines {
    // Nobody else holds this progress, so it is not cancelled.
    let progress = Progress::default();
    lines_under(&progress, (mesh, surface, normals), rule, family, merge_mm).unwrap_or_default()
}

/// All lines of a surface as [`lines()`] lays them, as long as nobody wants the work to end. `of`: the surface as it has it.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn lines_under(
    progress: &Progress,
    of: (&Mesh, &Surface, &VertexNormals),
    rule: &Layout,
    family: &SurfacePlanes,
    merge_mm: f64,
) -> Result<SurfaceLines, Cancelled> {
    let (mesh, surface, normals) = of;
    if !(rule.spacing_mm.is_finite() && rule.spacing_mm > 0.0) {
        return Ok(none(LinesFinding::SpacingNotPositive));
    }
    let number = surface.number;
    if live(mesh, surface).next().is_none() {
        return Ok(none(LinesFinding::NoProperFacet { surface: number }));
    }
    let cut = |planes: &SurfacePlanes| sections_under(progress, of, &planes.normal, &planes.heights_mm, merge_mm);
    let raster = |planes: SurfacePlanes| {
        let lines = cut(&planes)?;
        progress.check()?;
        Ok(SurfaceLines {
            achieved: spacing::achieved(&lines, Some(&planes.normal), rule.spacing_mm),
            finding: lines.is_empty().then_some(LinesFinding::NoPlaneCrosses { surface: number }),
            lines,
            planes: vec![planes],
        })
    };
    match rule.strategy {
        Strategy::Planes => raster(family.clone()),
        Strategy::Adaptive => raster(SurfacePlanes {
            heights_mm: adaptive::heights_mm(mesh, surface, &family.normal, rule.spacing_mm),
            ..family.clone()
        }),
        Strategy::Offset => offset::lines(mesh, surface, normals, rule, merge_mm, progress),
        Strategy::Spiral => spiral::lines(mesh, surface, normals, rule, merge_mm, progress),
        Strategy::Cross => {
            let Some(second) = across(mesh, surface, family, rule.spacing_mm, rule.cross_deg) else {
                let finding = Some(LinesFinding::NoMeanNormal { surface: number });
                return Ok(SurfaceLines { finding, ..raster(family.clone())? });
            };
            Ok(crossed(raster(family.clone())?, raster(second)?))
        }
    }
}

/// Planes turned by an angle about the surface's mean normal, at equal heights; `None` where it has none.
pub fn across(
    mesh: &Mesh,
    surface: &Surface,
    family: &SurfacePlanes,
    spacing_mm: f64,
    turn_deg: f64,
) -> Option<SurfacePlanes> {
    let axis = mean_normal(mesh, surface)?;
    let normal = angle::unit(angle::turned(&family.normal, &axis, turn_deg))?;
    let extent = extent(mesh, surface, &normal)?;
    Some(SurfacePlanes { surface: surface.number, normal, heights_mm: planes::family(extent, spacing_mm, None) })
}

/// One raster and another across it, whose ranks count on.
fn crossed(one: SurfaceLines, mut two: SurfaceLines) -> SurfaceLines {
    let ranks = one.planes.iter().map(|p| p.heights_mm.len()).sum::<usize>();
    two.lines.iter_mut().for_each(|l| l.plane += ranks);
    SurfaceLines {
        lines: [one.lines, two.lines].concat(),
        achieved: Achieved::of_both(one.achieved, two.achieved),
        planes: [one.planes, two.planes].concat(),
        finding: one.finding.or(two.finding),
    }
}

/// The mean of a surface's normals, unit; `None` where they cancel out, as on a closed surface.
fn mean_normal(mesh: &Mesh, surface: &Surface) -> Option<Vector3<f64>> {
    let (sum, area) = live(mesh, surface)
        .fold((Vector3::zeros(), 0.0), |(n, a), f| (n + mesh.normals[f] * mesh.areas[f], a + mesh.areas[f]));
    angle::unit(sum).filter(|_| sum.norm() > 1e-3 * area)
}

fn none(finding: LinesFinding) -> SurfaceLines {
    SurfaceLines { finding: Some(finding), ..Default::default() }
}
