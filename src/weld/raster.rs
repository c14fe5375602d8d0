//! Images as numbers, row by row from the top left: grey levels, depths, and which pixels belong to something.

/// A value for each pixel. The fields are open, so `values` may be of another length than the image: functions of this
/// room take what is missing as not there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Raster<T> {
    /// Pixels side by side.
    pub width: usize,
    /// Pixels one below the other.
    pub height: usize,
    /// Row by row, `width` × `height` of them.
    pub values: Vec<T>,
}

/// Levels from 0 to 255; those of 16 bits divided by 257.
pub type GreyImage = Raster<f32>;
/// Depths in the units of the file; 0, less, or not finite: no depth.
pub type DepthImage = Raster<f32>;
/// Which pixels belong to something.
pub type Mask = Raster<bool>;

impl<T> Raster<T> {
    /// `None`: there are more or fewer values than pixels.
    pub fn new(width: usize, height: usize, values: Vec<T>) -> Option<Raster<T>> {
        Some(Raster { width, height, values }).filter(Raster::is_whole)
    }

    /// Whether there are as many values as pixels.
    pub fn is_whole(&self) -> bool {
        self.width.checked_mul(self.height) == Some(self.values.len())
    }

    /// Whether there is no pixel.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Width and height, pixels.
    pub fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// The value of a pixel; `None` outside.
    pub fn at(&self, u: usize, v: usize) -> Option<&T> {
        if u < self.width && v < self.height { self.values.get(v * self.width + u) } else { None }
    }

    /// The values of a row; none outside.
    pub fn row(&self, v: usize) -> &[T] {
        let start = v.saturating_mul(self.width);
        self.values.get(start..start.saturating_add(self.width)).unwrap_or_default()
    }

    /// All pixels with their values, row by row.
    pub fn pixels(&self) -> impl Iterator<Item = ([usize; 2], &T)> {
        let width = self.width.max(1);
        self.values.iter().enumerate().map(move |(i, value)| ([i % width, i / width], value))
    }

    /// An image of the same size.
    pub fn map<U>(&self, change: impl FnMut(&T) -> U) -> Raster<U> {
        Raster { width: self.width, height: self.height, values: self.values.iter().map(change).collect() }
    }
}

impl<T: Clone> Raster<T> {
    /// The same value everywhere.
    pub fn filled(width: usize, height: usize, value: T) -> Raster<T> {
        Raster { width, height, values: vec![value; width.saturating_mul(height)] }
    }
}

impl Mask {
    /// How many pixels belong to it.
    pub fn count(&self) -> usize {
        self.values.iter().filter(|m| **m).count()
    }

    /// Pixels that belong to both, as a share of those that belong to either (intersection over union); 1 where neither
    /// has any, 0 for images of different sizes.
    pub fn overlap(&self, other: &Mask) -> f64 {
        if self.size() != other.size() {
            return 0.0;
        }
        let pairs = self.values.iter().zip(&other.values);
        let (both, either) =
            pairs.fold((0usize, 0usize), |(b, e), (x, y)| (b + usize::from(*x && *y), e + usize::from(*x || *y)));
        if either == 0 { 1.0 } else { both as f64 / either as f64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_stand_row_by_row() {
        let raster = Raster::new(3, 2, vec![0, 1, 2, 10, 11, 12]).expect("six");
        assert_eq!((raster.at(2, 1), raster.at(3, 0), raster.at(0, 2)), (Some(&12), None, None));
        assert_eq!((raster.row(1), raster.row(2)), (&[10, 11, 12][..], &[][..]));
        assert!(raster.pixels().all(|([u, v], value)| *value == 10 * v + u));
        assert!(Raster::new(3, 2, vec![0; 5]).is_none());
        assert!(Raster::<u8> { width: usize::MAX, height: 2, values: Vec::new() }.row(1).is_empty());
    }

    #[test]
    fn overlap_is_the_shared_part() {
        let one = Raster::new(4, 1, vec![true, true, true, false]).expect("four");
        let other = Raster::new(4, 1, vec![false, true, true, true]).expect("four");
        assert_eq!((one.overlap(&other), one.overlap(&one), one.count()), (0.5, 1.0, 3));
        assert_eq!(one.overlap(&Mask::filled(2, 2, true)), 0.0);
    }
}
