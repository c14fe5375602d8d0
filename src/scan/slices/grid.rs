//! Places in a plane, in rows of cells: which of them are near a place.

use nalgebra::Vector2;

/// Places sorted by row, then by column.
#[derive(Clone, Debug)]
pub(super) struct PlaneGrid {
    cell_mm: f64,
    /// Row, column and which place.
    cells: Vec<(i64, i64, u32)>,
}

impl PlaneGrid {
    /// Of places that are numbers.
    pub(super) fn new(places: impl Iterator<Item = Vector2<f64>>, cell_mm: f64) -> PlaneGrid {
        let cell_mm = cell_mm.max(f64::MIN_POSITIVE);
        let cell = |(at, i): (Vector2<f64>, u32)| ((at.y / cell_mm).floor() as i64, (at.x / cell_mm).floor() as i64, i);
        let mut cells: Vec<(i64, i64, u32)> = places.zip(0..).map(cell).collect();
        cells.sort_unstable();
        PlaneGrid { cell_mm, cells }
    }

    /// All places of the cells that a square about `at` with half the side `reach_mm` touches.
    pub(super) fn near(&self, at: Vector2<f64>, reach_mm: f64) -> impl Iterator<Item = u32> + '_ {
        let cell = |x: f64| (x / self.cell_mm).floor() as i64;
        let (low, high) = (at.map(|x| cell(x - reach_mm)), at.map(|x| cell(x + reach_mm)));
        (low.y..=high.y).flat_map(move |row| {
            let from = self.cells.partition_point(|c| (c.0, c.1) < (row, low.x));
            self.cells[from..].iter().take_while(move |c| c.0 == row && c.1 <= high.x).map(|c| c.2)
        })
    }
}
