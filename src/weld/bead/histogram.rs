//! How many points stand how high (P4 Fig. 16).

/// Counts of heights in bins of one width.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeightHistogram {
    /// Lower end of the first bin, mm; a whole number of bins off 0.
    pub from_mm: f64,
    /// Width of a bin, mm.
    pub bin_mm: f64,
    /// Points in each bin; a point at the border of two is in the upper one.
    pub counts: Vec<usize>,
}

/// More bins than this are not made: a stray height far off is none of the picture.
const MOST_BINS: f64 = 1000.0;

impl HeightHistogram {
    /// Counts heights; those that are no number or more than a thousand bins above the least are left out.
    pub fn new(heights_mm: impl Iterator<Item = f64> + Clone, bin_mm: f64) -> HeightHistogram {
        let finite = heights_mm.filter(|h| h.is_finite());
        let least = finite.clone().fold(f64::INFINITY, f64::min);
        if !least.is_finite() || bin_mm <= 0.0 {
            return HeightHistogram { bin_mm, ..HeightHistogram::default() };
        }
        let first = (least / bin_mm).floor();
        let mut counts = Vec::new();
        for height in finite {
            let bin = (height / bin_mm).floor() - first;
            if (0.0..MOST_BINS).contains(&bin) {
                let bin = bin as usize;
                counts.resize(counts.len().max(bin + 1), 0);
                counts[bin] += 1;
            }
        }
        HeightHistogram { from_mm: first * bin_mm, bin_mm, counts }
    }
}
