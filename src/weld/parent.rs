//! The surface of the parent metal under a bead and around it, from the points on both sides of the bead (P4 4).
//!
//! A robust plane makes a frame of its own, with z towards the camera; a cubic over it, fitted robustly to what lies
//! within 45 mm of the bead, bridges the bead itself. A skin that bends more within that strip than a cubic can is not
//! followed: [`ParentSurface::rms_mm`] tells. Heights above it are taken along its normals.

use super::cubic_fit::{self, Cubic, slopes, terms};
use super::pixel_distance::distances_px;
use super::points::PixelPoint;
use super::raster::Mask;
use crate::scan::{SIGMA_OF_MEDIAN, TUKEY, upper_median};
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, SymmetricEigen, Translation3, UnitQuaternion, Vector2, Vector3};
use thiserror::Error;

/// Points so far from the bead count, mm. Over a whole skin a cubic is 0.26 mm off under the bead, over this strip
/// 0.013 to 0.034 mm; less width leaves less to hold it.
pub const REACH_MM: f64 = 45.0;
/// Fewer points tell no cubic that is worth its name: ten coefficients under noise.
const LEAST_POINTS: usize = 200;
/// Stations along the bead at which points are looked for on both sides, and the share of them that has to have some.
const STATIONS: usize = 24;
const LEAST_BOTH_SIDES: f64 = 0.6;
/// A foot moves less than this in its last step, mm.
const STILL_MM: f64 = 1e-9;
/// Steps towards a foot; bends of 60 mm radius under a point 15 mm up take twenty.
const FOOT_STEPS: usize = 40;

/// The surface of the parent metal. Its own frame: origin within the bead's surroundings, x along the bead, z towards
/// the camera; mm.
#[derive(Clone, Debug, PartialEq)]
pub struct ParentSurface {
    /// Its frame in that of the camera.
    pub camera_from_local: Isometry3<f64>,
    /// Root of the weighted mean square of the points that it was fitted to, mm.
    pub rms_mm: f64,
    /// Standard deviation of their noise, by the median, mm.
    pub noise_mm: f64,
    /// How many points it was fitted to.
    pub points: usize,
    /// Where it holds: least and greatest x and y of those points, local, mm.
    pub region_mm: [[f64; 2]; 2],
    cubic: Cubic,
}

/// The foot of a point on the parent surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Foot {
    /// On the surface, camera frame, mm.
    pub foot: Point3<f64>,
    /// Of the surface there, towards the camera, camera frame.
    pub normal: Vector3<f64>,
    /// Distance of the point from the surface, positive towards the camera, mm.
    pub height_mm: f64,
    /// x and y of the foot in the frame of the surface, mm.
    pub local: [f64; 2],
    /// Whether the line to the point is normal to the surface; else no foot was found, and this is only near one.
    pub is_converged: bool,
}

/// Why there is no parent surface.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ParentError {
    /// The masks are of different sizes, or have fewer values than pixels.
    #[error("masks {area:?} and {covered:?}")]
    Sizes {
        /// Width and height of the area's mask, px.
        area: [usize; 2],
        /// Those of the mask of all that is covered.
        covered: [usize; 2],
    },
    /// The mask covers no measured point.
    #[error("no depth under the mask")]
    NothingCovered,
    /// Too few points around the bead.
    #[error("{count} points around the bead, {least} needed")]
    FewPoints {
        /// How many there are.
        count: usize,
        /// How many there have to be.
        least: usize,
    },
    /// Along much of the bead only one side was measured.
    #[error("both sides along {share} of the bead only")]
    OneSide {
        /// Share of the bead's length with points on both sides.
        share: f64,
    },
    /// The points tell no surface.
    #[error("no surface fits")]
    NoSurface,
}

impl ParentSurface {
    /// Fits the surface to what was measured around an area, but for all that a mask covers and `margin_px` beside it.
    ///
    /// # Errors
    /// There are too few points, or on one side of the area only.
    pub fn fit(
        points: &[PixelPoint],
        area: &Mask,
        covered: &Mask,
        margin_px: f64,
    ) -> Result<ParentSurface, ParentError> {
        if !area.is_whole() || !covered.is_whole() || area.size() != covered.size() {
            return Err(ParentError::Sizes { area: area.size(), covered: covered.size() });
        }
        let from_area = distances_px(area);
        let from_covered = if covered == area { from_area.clone() } else { distances_px(covered) };
        let measured = || {
            points.iter().filter_map(|p| {
                let [u, v] = p.pixel.map(|c| c as usize);
                Some((*from_area.at(u, v)?, *from_covered.at(u, v)?, p.point))
            })
        };
        let under: Vec<Point3<f64>> = measured().filter(|(off, ..)| *off <= 0.0).map(|(.., p)| p).collect();
        let reach_px = REACH_MM / mm_per_px(points).ok_or(ParentError::NothingCovered)?;
        let counts = |off: f32, beside: f32| f64::from(beside) > margin_px && f64::from(off) <= reach_px;
        let around: Vec<Point3<f64>> =
            measured().filter(|(off, beside, _)| counts(*off, *beside)).map(|(.., p)| p).collect();
        if under.is_empty() {
            return Err(ParentError::NothingCovered);
        }
        if around.len() < LEAST_POINTS {
            return Err(ParentError::FewPoints { count: around.len(), least: LEAST_POINTS });
        }
        let camera_from_local = frame(&under, &around).ok_or(ParentError::NoSurface)?;
        let local = |p: &Point3<f64>| camera_from_local.inverse_transform_point(p);
        let around: Vec<Point3<f64>> = around.iter().map(local).collect();
        let share = on_both_sides(&under.iter().map(local).collect::<Vec<_>>(), &around);
        if share < LEAST_BOTH_SIDES {
            return Err(ParentError::OneSide { share });
        }
        let mut region_mm = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for p in &around {
            for (k, [least, greatest]) in region_mm.iter_mut().enumerate() {
                (*least, *greatest) = (least.min(p[k]), greatest.max(p[k]));
            }
        }
        let mut surface = ParentSurface {
            camera_from_local,
            rms_mm: 0.0,
            noise_mm: 0.0,
            points: around.len(),
            region_mm,
            cubic: Cubic::zeros(),
        };
        let rows: Vec<[f64; 3]> = around
            .iter()
            .map(|p| {
                let [x, y] = surface.normalised(p.x, p.y);
                [x, y, p.z]
            })
            .collect();
        let fitted = cubic_fit::fit(&rows).ok_or(ParentError::NoSurface)?;
        (surface.cubic, surface.rms_mm, surface.noise_mm) = (fitted.cubic, fitted.rms_mm, fitted.sigma_mm);
        Ok(surface)
    }

    /// z of the surface, local, mm.
    pub fn height_mm(&self, x: f64, y: f64) -> f64 {
        let [x, y] = self.normalised(x, y);
        self.cubic.dot(&terms(x, y))
    }

    /// Its slopes by x and by y.
    pub fn gradient(&self, x: f64, y: f64) -> Vector2<f64> {
        let [[x0, x1], [y0, y1]] = self.region_mm;
        let [x, y] = self.normalised(x, y);
        let [by_x, by_y] = slopes(x, y);
        Vector2::new(self.cubic.dot(&by_x) * 2.0 / (x1 - x0), self.cubic.dot(&by_y) * 2.0 / (y1 - y0))
    }

    /// The point of the surface over a local place, camera frame.
    pub fn point_at(&self, local: [f64; 2]) -> Point3<f64> {
        let [x, y] = local;
        self.camera_from_local * Point3::new(x, y, self.height_mm(x, y))
    }

    /// Its normal there, towards the camera, camera frame.
    pub fn normal_at(&self, local: [f64; 2]) -> Vector3<f64> {
        let slope = self.gradient(local[0], local[1]);
        self.camera_from_local * Vector3::new(-slope.x, -slope.y, 1.0).normalize()
    }

    /// Whether a local place lies where points were.
    pub fn holds_at(&self, local: [f64; 2]) -> bool {
        self.region_mm.iter().zip(local).all(|([least, greatest], at)| (*least..=*greatest).contains(&at))
    }

    /// The foot of a point of the camera's frame: onto the tangent plane, the surface over there, and again (P4 4).
    pub fn foot(&self, point: &Point3<f64>) -> Foot {
        let p = self.camera_from_local.inverse_transform_point(point);
        let (mut x, mut y) = (p.x, p.y);
        let mut is_converged = false;
        for _ in 0..FOOT_STEPS {
            let slope = self.gradient(x, y);
            let off = Vector3::new(p.x - x, p.y - y, p.z - self.height_mm(x, y));
            // The normal equations of the tangents (1, 0, slope.x) and (0, 1, slope.y).
            let (a, b, c) = (1.0 + slope.x * slope.x, slope.x * slope.y, 1.0 + slope.y * slope.y);
            let (r, s) = (off.x + off.z * slope.x, off.y + off.z * slope.y);
            let determinant = a * c - b * b;
            let step = Vector2::new((c * r - b * s) / determinant, (a * s - b * r) / determinant);
            (x, y) = (x + step.x, y + step.y);
            if step.norm() < STILL_MM {
                is_converged = true;
                break;
            }
        }
        let foot = self.point_at([x, y]);
        let normal = self.normal_at([x, y]);
        Foot { foot, normal, height_mm: (point - foot).dot(&normal), local: [x, y], is_converged }
    }

    /// x and y in −1..1 over the region.
    fn normalised(&self, x: f64, y: f64) -> [f64; 2] {
        let [[x0, x1], [y0, y1]] = self.region_mm;
        [(2.0 * x - x0 - x1) / (x1 - x0), (2.0 * y - y0 - y1) / (y1 - y0)]
    }
}

/// How wide a pixel is on the part, mm: by the directions of neighbours in a row, which noise of depth leaves alone.
pub(super) fn mm_per_px(points: &[PixelPoint]) -> Option<f64> {
    let across = |p: &PixelPoint| p.point.x / p.point.z;
    let beside = |a: &PixelPoint, b: &PixelPoint| a.pixel[1] == b.pixel[1] && a.pixel[0] + 1 == b.pixel[0];
    let steps = points.windows(2).filter(|w| beside(&w[0], &w[1])).map(|w| across(&w[1]) - across(&w[0]));
    let per_px = upper_median(&mut steps.collect::<Vec<_>>())?;
    let depth = upper_median(&mut points.iter().map(|p| p.point.z).collect::<Vec<_>>())?;
    Some(per_px * depth).filter(|mm| mm.is_finite() && *mm > 0.0)
}

/// The frame of a robust plane through `around`: z towards the camera, x along where `under` is longest.
fn frame(under: &[Point3<f64>], around: &[Point3<f64>]) -> Option<Isometry3<f64>> {
    let mut weights = vec![1.0; around.len()];
    let (mut origin, mut normal) = (Point3::origin(), Vector3::zeros());
    for _ in 0..6 {
        let (middle, spread) = spread(around.iter().zip(weights.iter().copied()));
        if !spread.iter().all(|x| x.is_finite()) {
            return None;
        }
        let eigen = SymmetricEigen::new(spread);
        normal = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
        origin = middle;
        let mut offs: Vec<f64> = around.iter().map(|p| (p - origin).dot(&normal).abs()).collect();
        let sigma = SIGMA_OF_MEDIAN * upper_median(&mut offs)?;
        let width = (TUKEY * sigma).max(1e-6);
        for (weight, p) in weights.iter_mut().zip(around) {
            let share = (p - origin).dot(&normal) / width;
            *weight = (1.0 - share * share).max(0.0).powi(2);
        }
    }
    let z = if normal.dot(&origin.coords) > 0.0 { -normal } else { normal };
    let (_, spread) = spread(under.iter().map(|p| (p, 1.0)));
    if !spread.iter().all(|x| x.is_finite()) {
        return None;
    }
    let eigen = SymmetricEigen::new(spread);
    let longest = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned();
    let x = (longest - z * z.dot(&longest)).try_normalize(1e-9)?;
    // Of the two senses the one to the right of the picture: an eigenvector has none of its own.
    let x = if x.x < 0.0 { -x } else { x };
    let turn = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, z.cross(&x), z]));
    let frame = Isometry3::from_parts(Translation3::from(origin), UnitQuaternion::from_rotation_matrix(&turn));
    frame.to_homogeneous().iter().all(|x| x.is_finite()).then_some(frame)
}

/// Middle and covariance of weighted points.
fn spread<'p>(points: impl Iterator<Item = (&'p Point3<f64>, f64)> + Clone) -> (Point3<f64>, Matrix3<f64>) {
    let total = points.clone().map(|(_, w)| w).sum::<f64>().max(f64::MIN_POSITIVE);
    let middle = points.clone().fold(Vector3::zeros(), |s: Vector3<f64>, (p, w)| s + p.coords * w) / total;
    let spread = points.fold(Matrix3::zeros(), |s, (p, w)| {
        let off = p.coords - middle;
        s + off * off.transpose() * w
    });
    (Point3::from(middle), spread / total)
}

/// The share of the stations along x, where `under` is, that have points of `around` on both sides of it.
fn on_both_sides(under: &[Point3<f64>], around: &[Point3<f64>]) -> f64 {
    let (least, greatest) = under.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.x), b.max(p.x)));
    let station = |p: &Point3<f64>| {
        let at = (p.x - least) / (greatest - least) * STATIONS as f64;
        (0.0..STATIONS as f64).contains(&at).then_some(at as usize)
    };
    let mut middles = [(0.0, 0usize); STATIONS];
    for p in under {
        if let Some((sum, count)) = station(p).and_then(|k| middles.get_mut(k)) {
            (*sum, *count) = (*sum + p.y, *count + 1);
        }
    }
    let mut sides = [[false; 2]; STATIONS];
    for p in around {
        let Some(k) = station(p) else { continue };
        let (sum, count) = middles[k];
        sides[k][usize::from(p.y * count as f64 > sum)] = true;
    }
    let of_bead = middles.iter().zip(&sides).filter(|((_, count), _)| *count > 0);
    let both = of_bead.clone().filter(|(_, sides)| sides[0] && sides[1]).count();
    both as f64 / of_bead.count().max(1) as f64
}

#[cfg(test)]
mod tests;
