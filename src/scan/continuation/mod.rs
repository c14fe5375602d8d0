//! The worn part's own sound regions, continued across the damage: where no model of the part exists (P3's third case),
//! what is left of a surface tells what is missing of it.
//!
//! A surface of the kind that the user names is fitted to the points marked sound; worn points among them lose their
//! say. What the points do not tell is refused, never guessed. Where the damage is, and which kind it takes, is decided
//! elsewhere. All in one frame, mm.

mod error;
mod profile;
mod repaired;
mod robust;
mod starts;
mod surface;
#[cfg(test)]
mod tests;
mod told;

pub use error::ContinuationError;

use super::cloud::Cloud;
use super::neighbours::Neighbours;
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use robust::Fit;
use starts::Given;
use surface::{Form, Surface};

/// What a point of a region is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointState {
    /// Of the surface as it was made: it is fitted.
    Sound,
    /// Worn, broken or welded over: the surface goes on across it.
    Damaged,
    /// Of another surface: it is left alone.
    Other,
}

/// Points around a damage: of a cloud, or the vertices of its mesh.
#[derive(Clone, Copy, Debug)]
pub struct DamagedRegion<'a> {
    /// Places, mm.
    pub points: &'a [Point3<f64>],
    /// Unit normals, outward, one a point.
    pub normals: &'a [Vector3<f64>],
    /// What each point is.
    pub state: &'a [PointState],
    /// Standard deviation of the points across the surface, mm, above 0.
    pub noise_mm: f64,
}

/// Which kind of surface is continued.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceKind {
    /// A plane.
    Plane,
    /// A circular cylinder, from without or within.
    Cylinder,
    /// A curve turned about an axis; its radius is a function of the place along the axis.
    Revolved,
    /// A curve drawn along a direction; seen along it, the curve is a height over a line.
    Extruded,
    /// A height over a plane: a polynomial of degree 4 at most, of the least that fits.
    Smooth,
}

/// What was found of a surface, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SurfaceFigures {
    /// A plane.
    Plane {
        /// A point of it.
        point: Point3<f64>,
        /// Unit normal, outward.
        normal: Vector3<f64>,
    },
    /// A cylinder.
    Cylinder {
        /// A point of the axis.
        point: Point3<f64>,
        /// Unit axis.
        axis: Vector3<f64>,
        /// Radius.
        radius_mm: f64,
    },
    /// What is revolved.
    Revolved {
        /// A point of the axis.
        point: Point3<f64>,
        /// Unit axis.
        axis: Vector3<f64>,
    },
    /// What is extruded.
    Extruded {
        /// Unit direction.
        direction: Vector3<f64>,
    },
    /// A polynomial.
    Smooth {
        /// Its degree.
        degree: usize,
    },
}

/// A surface that goes on across the damage.
#[derive(Clone, Debug, PartialEq)]
pub struct ContinuedSurface {
    /// Its kind.
    pub kind: SurfaceKind,
    /// Root mean square of the sound points' distances, mm; those that turned out to be none left out.
    pub rms_mm: f64,
    /// Points marked sound that lie off the surface.
    pub strays: usize,
    /// Width of the widest damage, mm: twice the greatest distance of a damaged point from the next sound one.
    pub gap_mm: f64,
    /// Standard deviation of the surface where it is least sure among the damaged points, mm.
    pub spread_mm: f64,
    surface: Surface,
}

/// Sound points that a fit needs: three for each parameter of a surface with fifteen.
const FEWEST: usize = 45;
/// Points that are fitted at most, evenly taken: the noise of 20 000 leaves 1 % of itself in the surface.
const MOST: usize = 20_000;
/// Levels of refinement: degrees of a polynomial, intervals of a curve.
const DEGREES: &[usize] = &[1, 2, 3, 4];
const INTERVALS: &[usize] = &[2, 4, 8, 16, 32];
/// The next level is worth its parameters where it brings the distances down to this share.
const WORTH_IT: f64 = 0.95;
/// As long as the distances are so many times the noise, the next level is tried in any case.
const NOT_YET: f64 = 1.15;

/// Continues a surface of a kind across the damaged points of a region.
///
/// # Errors
/// The sound points do not tell such a surface: see [`ContinuationError`].
pub fn continued(
    region: &DamagedRegion,
    kind: SurfaceKind,
    progress: &Progress,
) -> Result<ContinuedSurface, ContinuationError> {
    let count = region.points.len();
    let is_region = region.normals.len() == count && region.state.len() == count;
    if !(is_region && region.noise_mm > 0.0 && region.noise_mm.is_finite()) {
        return Err(ContinuationError::NoRegion);
    }
    let finite =
        |i: &usize| region.points[*i].iter().chain(region.normals[*i].iter()).all(|c| c.is_finite() && c.abs() < 1e12);
    let of =
        |state: PointState| -> Vec<usize> { (0..count).filter(|i| region.state[*i] == state).filter(finite).collect() };
    let (sound, damaged) = (of(PointState::Sound), of(PointState::Damaged));
    if sound.len() < FEWEST {
        return Err(ContinuationError::TooFewPoints { sound: sound.len() });
    }
    let some = sound.len().min(MOST);
    let taken: Vec<usize> = (0..some).map(|k| sound[k * sound.len() / some]).collect();
    let places = |of: &[usize]| of.iter().map(|i| region.points[*i]).collect::<Vec<Point3<f64>>>();
    let (points, holes) = (places(&taken), places(&damaged));
    let normals: Vec<Vector3<f64>> = taken.iter().map(|i| region.normals[*i]).collect();
    let reached = [places(&sound), holes.clone()].concat();
    let size_mm = Cloud::of_points(&points).diagonal();
    if size_mm.is_nan() || size_mm <= 0.0 {
        return Err(ContinuationError::TooFewPoints { sound: sound.len() });
    }
    let given = Given { points: &points, normals: &normals, reached: &reached, size_mm };
    let fit = best(&given, kind, region.noise_mm, progress)?;
    let spread_mm = told::told(&fit, &points, &holes, region.noise_mm)?;
    let strays = sound.len() - (fit.share * sound.len() as f64).round() as usize;
    let gap_mm = 2.0 * furthest_mm(&places(&sound), &holes, progress)?;
    Ok(ContinuedSurface { kind, rms_mm: fit.rms_mm, strays, gap_mm, spread_mm, surface: fit.surface })
}

/// The fit of the lowest level that is as good as the next.
fn best(given: &Given, kind: SurfaceKind, noise_mm: f64, progress: &Progress) -> Result<Fit, ContinuationError> {
    let levels: &[usize] = match kind {
        SurfaceKind::Plane => &[1],
        SurfaceKind::Cylinder => &[0],
        SurfaceKind::Smooth => DEGREES,
        SurfaceKind::Revolved | SurfaceKind::Extruded => INTERVALS,
    };
    let mut best: Option<Fit> = None;
    for level in levels {
        let start = match kind {
            SurfaceKind::Plane | SurfaceKind::Smooth => given.height(*level),
            SurfaceKind::Cylinder => given.cylinder(),
            SurfaceKind::Revolved => given.revolved(*level),
            SurfaceKind::Extruded => given.extruded(*level),
        };
        let Some(start) = start else { break };
        let Some(fit) = robust::fitted(given.points, start, given.size_mm, progress)? else { break };
        let is_better = best.as_ref().is_none_or(|b| fit.rms_mm < WORTH_IT * b.rms_mm);
        let is_enough = best.as_ref().is_some_and(|b| b.rms_mm <= NOT_YET * noise_mm);
        if is_better {
            best = Some(fit);
        } else if is_enough {
            break;
        }
    }
    best.ok_or(ContinuationError::OtherKind { rms_mm: None })
}

/// The greatest distance from a point of `from` to the nearest of `to`, mm; 0 without any.
fn furthest_mm(to: &[Point3<f64>], from: &[Point3<f64>], progress: &Progress) -> Result<f64, Cancelled> {
    let neighbours = Neighbours::new(&Cloud::of_points(to), progress)?;
    let distances = from.iter().filter_map(|p| neighbours.nearest_one(p, f64::INFINITY));
    Ok(distances.fold(0.0, |most: f64, n| most.max(f64::from(n.squared).sqrt())))
}

impl ContinuedSurface {
    /// The foot of a point on the surface, and the outward unit normal there; `None` where the surface does not reach:
    /// beyond the ends of its curve, or on its axis.
    pub fn closest(&self, p: &Point3<f64>) -> Option<(Point3<f64>, Vector3<f64>)> {
        self.surface.closest(p)
    }

    /// What was found of the surface.
    pub fn figures(&self) -> SurfaceFigures {
        let Surface { frame, coefficients, form, .. } = &self.surface;
        let (point, axis) = (Point3::from(frame.translation.vector), frame * Vector3::z());
        match (self.kind, form) {
            (SurfaceKind::Plane, _) => {
                let (point, normal) = self.closest(&point).unwrap_or((point, axis));
                SurfaceFigures::Plane { point, normal }
            }
            (SurfaceKind::Cylinder, _) => SurfaceFigures::Cylinder { point, axis, radius_mm: coefficients[0] },
            (SurfaceKind::Revolved, _) => SurfaceFigures::Revolved { point, axis },
            (SurfaceKind::Extruded, _) => SurfaceFigures::Extruded { direction: frame * Vector3::y() },
            (SurfaceKind::Smooth, Form::Height { degree, .. }) => SurfaceFigures::Smooth { degree: *degree },
            (SurfaceKind::Smooth, _) => SurfaceFigures::Smooth { degree: 0 },
        }
    }
}
