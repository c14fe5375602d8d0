//! From gathered points to a cloud: what is no number is dropped, what not all points have is left out, normals become
//! unit ones, and the middle of the box becomes the origin.

use super::gather::{Gather, Has};
use super::{Attribute, ScanFileError, ScanFinding};
use crate::progress::{Cancelled, Progress};
use crate::scan::Cloud;
use nalgebra::Point3;

/// Points between two looks at the progress: about a millisecond.
const BLOCK: usize = 1 << 17;

impl Gather {
    /// The cloud, with what is to be told of it. An offset is rounded once where coordinates were single numbers,
    /// else twice: at most 2⁻²³ of the box's diagonal.
    ///
    /// # Errors
    /// No point is left, one lies too far off, or the work was cancelled.
    pub fn settle(mut self, invalid: u64, progress: &Progress) -> Result<(Cloud, Vec<ScanFinding>), ScanFileError> {
        if let Some(point) = self.too_far {
            return Err(ScanFileError::TooFar { point });
        }
        let mut findings = Vec::new();
        let gathered = self.offsets.len() as u64;
        let (nan, infinite) = self.drop_unusable(progress)?;
        if nan + infinite > 0 {
            findings.push(ScanFinding::PointsDropped { nan, infinite });
        }
        if invalid > 0 {
            findings.push(ScanFinding::InvalidPoints { count: invalid });
        }
        if self.offsets.is_empty() {
            let dropped = nan + infinite + invalid;
            return Err(if dropped == 0 { ScanFileError::NoPoints } else { ScanFileError::AllDropped { dropped } });
        }
        let without = [
            (self.has.normals, Attribute::Normals, self.straighten(progress)?),
            (
                self.has.colours,
                Attribute::Colours,
                gathered - self.coloured.into_iter().min().unwrap_or(0).min(gathered),
            ),
            (self.has.intensities, Attribute::Intensities, unknown(&self.intensities)),
        ];
        let lacks = |(_, what, without): (bool, Attribute, u64)| ScanFinding::NotForAll { what, without };
        findings.extend(without.into_iter().filter(|(has, _, without)| *has && *without > 0).map(lacks));
        let [normals, colours, intensities] = without.map(|(has, _, without)| has && without == 0);
        if self.clamped > 0 && colours {
            findings.push(ScanFinding::ColoursClamped { count: self.clamped });
        }
        let origin = self.centre(progress)?;
        let cloud = Cloud {
            origin,
            offsets: self.offsets,
            normals: normals.then_some(self.normals),
            colours: colours.then_some(self.colours),
            intensities: intensities.then_some(self.intensities),
        };
        Ok((cloud, findings))
    }

    /// Drops points with a coordinate that is none, in place; returns how many have a NaN, and how many else.
    fn drop_unusable(&mut self, progress: &Progress) -> Result<(u64, u64), Cancelled> {
        let (mut kept, mut nan, mut infinite) = (0, 0, 0);
        let Has { normals, colours, intensities } = self.has;
        for i in 0..self.offsets.len() {
            if i % BLOCK == 0 {
                progress.check()?;
            }
            let place = self.offsets[i];
            if !place.iter().all(|c| c.is_finite()) {
                let is_nan = place.iter().any(|c| c.is_nan());
                nan += u64::from(is_nan);
                infinite += u64::from(!is_nan);
                continue;
            }
            if kept < i {
                self.offsets[kept] = place;
                if normals {
                    self.normals[kept] = self.normals[i];
                }
                if colours {
                    self.colours[kept] = self.colours[i];
                }
                if intensities {
                    self.intensities[kept] = self.intensities[i];
                }
            }
            kept += 1;
        }
        self.offsets.truncate(kept);
        self.normals.truncate(kept);
        self.colours.truncate(kept);
        self.intensities.truncate(kept);
        Ok((nan, infinite))
    }

    /// Makes normals one long; returns how many have no direction.
    fn straighten(&mut self, progress: &Progress) -> Result<u64, Cancelled> {
        let mut without = 0;
        for block in self.normals.chunks_mut(BLOCK) {
            progress.check()?;
            for normal in block {
                let [x, y, z] = normal.map(f64::from);
                let length = (x * x + y * y + z * z).sqrt();
                if length > 0.0 && length.is_finite() {
                    *normal = [x, y, z].map(|c| (c / length) as f32);
                } else {
                    without += 1;
                }
            }
        }
        Ok(without)
    }

    /// Counts offsets from the middle of the box, which is returned.
    fn centre(&mut self, progress: &Progress) -> Result<Point3<f64>, Cancelled> {
        let (mut lo, mut hi) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for block in self.offsets.chunks(BLOCK) {
            progress.check()?;
            for place in block {
                for k in 0..3 {
                    lo[k] = lo[k].min(place[k]);
                    hi[k] = hi[k].max(place[k]);
                }
            }
        }
        let middle: [f64; 3] = std::array::from_fn(|k| (f64::from(lo[k]) + f64::from(hi[k])) * 0.5);
        for block in self.offsets.chunks_mut(BLOCK) {
            progress.check()?;
            for place in block {
                for k in 0..3 {
                    place[k] = (f64::from(place[k]) - middle[k]) as f32;
                }
            }
        }
        Ok(Point3::from(std::array::from_fn::<f64, 3, _>(|k| self.base[k].unwrap_or(0.0) + middle[k])))
    }
}

fn unknown(values: &[f32]) -> u64 {
    values.iter().filter(|v| !v.is_finite()).count() as u64
}
