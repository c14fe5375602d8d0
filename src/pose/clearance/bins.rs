//! A grid of bins for looking up tilts that are near another.

use super::track::TiltVector;

/// Candidates sorted into square bins, so that those within reach are found without checking all.
pub struct Bins {
    width_deg: f64,
    /// Row, column and index, in order.
    list: Vec<(i32, i32, usize)>,
}

impl Bins {
    /// Sorts the candidates that have a weight into bins of this width.
    pub fn new(tilts: &[TiltVector], weight: &[Option<f64>], width_deg: f64) -> Bins {
        let mut bins = Bins { width_deg: width_deg.max(0.05), list: Vec::new() };
        for (i, t) in tilts.iter().enumerate().filter(|(i, _)| weight[*i].is_some()) {
            let (row, column) = bins.place(t);
            bins.list.push((row, column, i));
        }
        bins.list.sort_unstable();
        bins
    }

    fn place(&self, t: &TiltVector) -> (i32, i32) {
        ((t.y / self.width_deg).floor() as i32, (t.x / self.width_deg).floor() as i32)
    }

    /// Calls `with` for every candidate within a bin's width of a tilt, and for some others.
    pub fn for_each_near(&self, t: &TiltVector, mut with: impl FnMut(usize)) {
        let (row, column) = self.place(t);
        for r in row - 1..=row + 1 {
            let from = self.list.partition_point(|x| (x.0, x.1) < (r, column - 1));
            for x in self.list[from..].iter().take_while(|x| (x.0, x.1) <= (r, column + 1)) {
                with(x.2);
            }
        }
    }
}
