//! The grid of tilts around a normal: a hexagonal lattice in the plane of lead and lean.

use super::track::TiltVector;
use std::collections::BTreeSet;

/// Radius of the coarse grid in spacings: 241 cells, whatever the greatest tilt.
const SPACINGS: f64 = 8.1;

/// Spacing of the coarse grid, degrees.
pub fn coarse_spacing_deg(max_tilt_deg: f64) -> f64 {
    max_tilt_deg / SPACINGS
}

/// A cell: row and column.
pub type GridCell = (i32, i32);

/// The middle of a cell of the lattice with this spacing.
pub fn middle((row, column): GridCell, spacing_deg: f64) -> TiltVector {
    let shift = if row % 2 == 0 { 0.0 } else { 0.5 };
    TiltVector::new((f64::from(column) + shift) * spacing_deg, f64::from(row) * row_deg(spacing_deg))
}

fn row_deg(spacing_deg: f64) -> f64 {
    spacing_deg * 0.75f64.sqrt()
}

/// Adds the cells within a radius of a tilt.
pub fn add_disc(cells: &mut BTreeSet<GridCell>, around: &TiltVector, radius_deg: f64, spacing_deg: f64) {
    let rows = |y: f64| y / row_deg(spacing_deg);
    for row in rows(around.y - radius_deg).floor() as i32..=rows(around.y + radius_deg).ceil() as i32 {
        let columns = |x: f64| x / spacing_deg;
        for column in columns(around.x - radius_deg).floor() as i32 - 1..=columns(around.x + radius_deg).ceil() as i32 {
            if (middle((row, column), spacing_deg) - around).norm() <= radius_deg + 1e-9 {
                cells.insert((row, column));
            }
        }
    }
}

/// Moves a tilt that exceeds the greatest by no more than half a spacing onto the greatest, so that the rim has
/// candidates, too; `None` if it exceeds it by more.
pub fn at_rim(tilt: TiltVector, max_tilt_deg: f64, spacing_deg: f64) -> Option<TiltVector> {
    (tilt.norm() <= max_tilt_deg + 0.5 * spacing_deg).then(|| tilt.cap_magnitude(max_tilt_deg))
}

/// The middles of the cells within a radius of the normal.
pub fn disc(radius_deg: f64, spacing_deg: f64) -> Vec<TiltVector> {
    let mut cells = BTreeSet::new();
    add_disc(&mut cells, &TiltVector::zeros(), radius_deg, spacing_deg);
    cells.into_iter().map(|c| middle(c, spacing_deg)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn about_240_cells_each_with_six_neighbours() {
        let spacing_deg = coarse_spacing_deg(45.0);
        let cells = disc(45.0, spacing_deg);
        assert_eq!(cells.len(), 241);
        assert!(cells.contains(&TiltVector::zeros()));
        for c in cells.iter().filter(|c| c.norm() < 45.0 - spacing_deg) {
            let near = cells.iter().filter(|d| *d != c && (*d - c).norm() < 1.1 * spacing_deg);
            assert_eq!(near.count(), 6);
        }
        assert!(cells.iter().all(|c| c.norm() <= 45.0 + 1e-8));
    }
}
