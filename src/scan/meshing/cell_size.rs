//! How large the cells of the mesh are: from the density of the points, and from their noise where that is larger.
//!
//! Noise is told from points further apart than they scatter: in a cloud that is denser than that, the nearest points
//! make a ball, and planes through them are any. So a dense cloud is looked at through fewer and fewer of its points.

use crate::progress::{Cancelled, Progress};
use crate::scan::assessment::point_figures::{PointFigures, point_figures};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::Neighbours;

/// Side of a cell in distances between points: there are four of them to the square of a cell, so that a cell without
/// any is a hole (of scattered points one in fifty has none).
const SPACINGS: f64 = 2.0;
/// Side of a cell in standard deviations of the noise: the layer in which the points scatter (±2 σ) stays below a cell.
const NOISES: f64 = 6.0;
/// Facets that a mesh has at most, about.
const MOST_FACETS: f64 = 1e6;
/// Facets to the square of a cell: two where the surface lies along the lattice, three on all sides of a sphere.
const FACETS_OF_CELL: f64 = 3.0;
/// Noise in distances between points up to which the figures of a cloud hold: 20 neighbours lie within 2.5 distances,
/// which is 5 σ then, where noise is told 5 % too low.
const NOISE_OF_SPACING: f64 = 0.5;
/// Fewer points than these are not taken fewer still.
const FEWEST: usize = 2_000;

/// What the size of the cells follows from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grain {
    /// Side of a cell, mm.
    pub cell_mm: f64,
    /// Standard deviation of the points across the surface, mm.
    pub noise_mm: f64,
}

/// The size of cells for a cloud of finite points; `None` where they tell no surface.
pub(super) fn grain(cloud: &Cloud, progress: &Progress) -> Result<Option<Grain>, Cancelled> {
    let mut share = 1.0;
    let mut figures = figures_of(cloud, progress)?;
    let mut left: Vec<u32> = (0..cloud.len() as u32).collect();
    while let Some(now) = figures
        && now.noise_mm * now.density_per_mm2.sqrt() > NOISE_OF_SPACING
        && left.len() >= 4 * FEWEST
    {
        // One of four, by the golden ratio's multiples: rows of a scanner's raster are not taken or left as a whole.
        left.retain(|i| (i.wrapping_add(1).wrapping_mul(0x9e37_79b9).rotate_left(left_bits(share)) >> 30) == 0);
        share *= 0.25;
        figures = figures_of(&cloud.picked(&left), progress)?;
    }
    Ok(figures.and_then(|f| {
        let density_per_mm2 = f.density_per_mm2 / share;
        let area_mm2 = cloud.len() as f64 / density_per_mm2;
        let by_points = SPACINGS / density_per_mm2.sqrt();
        let by_facets = (FACETS_OF_CELL * area_mm2 / MOST_FACETS).sqrt();
        let cell_mm = by_points.max(NOISES * f.noise_mm).max(by_facets);
        (cell_mm > 0.0 && cell_mm.is_finite()).then_some(Grain { cell_mm, noise_mm: f.noise_mm })
    }))
}

/// Which bits of the multiples are looked at, other ones each time.
fn left_bits(share: f64) -> u32 {
    (-libm::log2(share)) as u32
}

fn figures_of(cloud: &Cloud, progress: &Progress) -> Result<Option<PointFigures>, Cancelled> {
    let neighbours = Neighbours::new(cloud, progress)?;
    point_figures(cloud, &neighbours, progress)
}
