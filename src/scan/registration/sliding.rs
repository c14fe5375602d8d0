//! Along what a fit can slide: the motions that its points do not hold, or hardly.
//!
//! Eigenvectors of JᵀJ/N (Gelfand, Ikemoto, Rusinkiewicz and Levoy, "Geometrically stable sampling for the ICP
//! algorithm", 2003), rows scaled by the points' rms radius. Motions that slide together are taken apart into shifts and
//! turns, since of a cylinder's two any mixture has the eigenvalue 0.

use super::fine::SLIDES_BELOW;
use super::plane_fit::PlaneFit;
use nalgebra::{DMatrix, Isometry3, Matrix6, Point3, SymmetricEigen, Vector3, Vector6};

/// Eigenvalues from `SLIDES_BELOW` to this are held weakly: a camshaft's axis has 3e-3, and 0.03 mm of noise leaves it
/// a slack of 0.54 mm; a connecting rod's least is 2.2e-2 (0.2 mm).
const WEAK_BELOW: f64 = 1e-2;
/// A motion with less turn than this, of unit length, is a shift: its axis is ten rms radii away.
const SHIFT_BELOW: f64 = 0.1;
/// A turn whose axis advances by less than this share of an rms radius a radian is none of a screw.
const SCREW_FROM: f64 = 0.1;

/// Whether a motion is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlidingKind {
    /// By nothing: it stays as it was at the start.
    Slides,
    /// By little: the result may be off by the slack.
    WeaklyHeld,
}

/// What moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlidingMotion {
    /// A turn about the axis.
    Turn,
    /// A shift along it.
    Shift,
    /// Both at once.
    Screw {
        /// Shift a radian, mm.
        mm_per_radian: f64,
    },
}

/// A motion of the scan over the model that hardly shows in the distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sliding {
    /// Whether it slides or is weakly held.
    pub kind: SlidingKind,
    /// What moves.
    pub motion: SlidingMotion,
    /// A point of its axis, part frame, the nearest to the middle of the scan.
    pub point: Point3<f64>,
    /// Unit direction of its axis, part frame; its sign means nothing.
    pub direction: Vector3<f64>,
    /// The way that makes the rms √2 σ, mm at an rms radius from the middle: σ/√λ. `None` where it slides.
    pub slack_mm: Option<f64>,
    /// λ, without unit: 1/3 of each shift and turn where normals point everywhere.
    pub eigenvalue: f64,
}

/// A screw whose part outside of what slides is less than this share of it is a slide.
const ALONG: f64 = 0.05;

/// What a fit holds.
#[derive(Clone, Debug)]
pub(in crate::scan) struct Held {
    /// The motions that slide, then those that are weakly held, the weakest first.
    pub(in crate::scan) sliding: Vec<Sliding>,
    free: Vec<Vector6<f64>>,
    centre: Point3<f64>,
    length_mm: f64,
}

impl Held {
    /// Of a fit whose points scatter by `sigma_mm`.
    pub(in crate::scan) fn of(fit: &PlaneFit, sigma_mm: f64) -> Held {
        let weak = motions(&fit.held).into_iter().filter(|m| m.0 < WEAK_BELOW);
        let (free, held): (Vec<_>, Vec<_>) = weak.partition(|m| m.0 < SLIDES_BELOW);
        let free = taken_apart(&fit.held, &free);
        let named = |(eigenvalue, motion): &(f64, Vector6<f64>), kind: SlidingKind| {
            let (point, direction, motion) = axis_of(motion, &fit.centre, fit.length_mm);
            let slack_mm = (kind == SlidingKind::WeaklyHeld).then(|| sigma_mm / eigenvalue.sqrt());
            Sliding { kind, motion, point, direction, slack_mm, eigenvalue: *eigenvalue }
        };
        let mut sliding: Vec<Sliding> = free.iter().map(|m| named(m, SlidingKind::Slides)).collect();
        sliding.extend(held.iter().map(|m| named(m, SlidingKind::WeaklyHeld)));
        let free = free.into_iter().map(|m| m.1).collect();
        Held { sliding, free, centre: fit.centre, length_mm: fit.length_mm }
    }

    /// Whether a motion of the part frame, however large, is one that slides. What slides is a group of motions, so its
    /// screws are those of the small ones.
    pub(in crate::scan) fn slides(&self, motion: &Isometry3<f64>) -> bool {
        let screw = screw_of(motion, &self.centre, self.length_mm);
        let rest = self.free.iter().fold(screw, |rest, free| rest - free * free.dot(&rest));
        rest.norm() <= ALONG * screw.norm()
    }
}

/// The screw (turn · L, shift) about `centre` that a motion is made by (its logarithm).
fn screw_of(motion: &Isometry3<f64>, centre: &Point3<f64>, length_mm: f64) -> Vector6<f64> {
    let turn = motion.rotation.scaled_axis();
    let shift = motion * centre - centre;
    let angle = turn.norm();
    let share = if angle < 1e-6 {
        1.0 / 12.0
    } else {
        (1.0 - 0.5 * angle * libm::sin(angle) / (1.0 - libm::cos(angle))) / (angle * angle)
    };
    let along = shift - turn.cross(&shift) * 0.5 + turn.cross(&turn.cross(&shift)) * share;
    let turn = turn * length_mm;
    Vector6::new(turn.x, turn.y, turn.z, along.x, along.y, along.z)
}

/// All motions with their eigenvalues, the least first.
pub(in crate::scan) fn motions(held: &Matrix6<f64>) -> Vec<(f64, Vector6<f64>)> {
    if !held.iter().all(|x| x.is_finite()) {
        return Vec::new();
    }
    let eigen = SymmetricEigen::new(*held);
    let column = |k: usize| (eigen.eigenvalues[k].max(0.0), eigen.eigenvectors.column(k).into_owned());
    let mut out: Vec<(f64, Vector6<f64>)> = (0..6).map(column).collect();
    out.sort_by(|a, b| a.0.total_cmp(&b.0));
    out
}

/// Motions that are all free, as shifts and turns where there are such among their mixtures.
fn taken_apart(held: &Matrix6<f64>, free: &[(f64, Vector6<f64>)]) -> Vec<(f64, Vector6<f64>)> {
    if free.is_empty() {
        return Vec::new();
    }
    let all = DMatrix::from_fn(6, free.len(), |r, c| free[c].1[r]);
    // How much each mixture turns; those that turn least come first.
    let turns = all.rows(0, 3).transpose() * all.rows(0, 3);
    let eigen = SymmetricEigen::new(turns);
    let mut order: Vec<usize> = (0..free.len()).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
    let mixed = |k: usize| {
        let mixture = &all * eigen.eigenvectors.column(k);
        let motion = Vector6::from_fn(|r, _| mixture[r]);
        (motion.dot(&(held * motion)).max(0.0), motion)
    };
    order.into_iter().map(mixed).collect()
}

/// The axis of a motion (turn · L, shift) about `centre`.
fn axis_of(motion: &Vector6<f64>, centre: &Point3<f64>, length_mm: f64) -> (Point3<f64>, Vector3<f64>, SlidingMotion) {
    let turn: Vector3<f64> = motion.fixed_rows::<3>(0).into_owned();
    let shift: Vector3<f64> = motion.fixed_rows::<3>(3).into_owned();
    let along = |v: Vector3<f64>| v.try_normalize(0.0).unwrap_or_else(Vector3::z);
    if turn.norm() < SHIFT_BELOW * motion.norm() {
        return (*centre, along(shift), SlidingMotion::Shift);
    }
    let turn = turn / length_mm;
    let squared = turn.norm_squared();
    let mm_per_radian = turn.dot(&shift) / squared.sqrt() / squared.sqrt();
    let is_screw = mm_per_radian.abs() >= SCREW_FROM * length_mm;
    let kind = if is_screw { SlidingMotion::Screw { mm_per_radian } } else { SlidingMotion::Turn };
    (centre + turn.cross(&shift) / squared, along(turn), kind)
}
