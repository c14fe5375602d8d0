//! Targets and passes, and the path frame `[n o a]` at a target (P2 4.3).

use super::interference::Blocker;
use super::tilt::Tilt;
use crate::beam::ProcessSettings;
use crate::part::angle;
use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};

/// Whether the beam is free at a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TargetState {
    /// The beam stands along the surface normal, or as the surface's rule and the pins ask.
    Free,
    /// The beam is tilted to avoid something.
    Corrected,
    /// No free beam was found; the laser is off here.
    Blocked,
}

impl TargetState {
    /// The word in `path.csv`.
    pub fn word(self) -> &'static str {
        match self {
            TargetState::Free => "free",
            TargetState::Corrected => "corrected",
            TargetState::Blocked => "blocked",
        }
    }
}

/// One target of a pass. All directions are unit vectors in the part frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// On the part, mm.
    pub p: Point3<f64>,
    /// Surface normal.
    pub n: Vector3<f64>,
    /// Where the tool's axis begins, mm: in p, but for a disc that touches with its rim, whose axis passes beside it.
    pub foot: Point3<f64>,
    /// Beam axis, from the surface towards the laser.
    pub a: Vector3<f64>,
    /// Travel direction, square to a.
    pub o: Vector3<f64>,
    /// Whether the beam is free here.
    pub state: TargetState,
    /// Whether the move that ends here is made with the laser on.
    pub laser: bool,
    /// What the beam along the normal hits here.
    pub normal_hits: Option<Blocker>,
    /// Clearance of beam and head here, mm; `None` without a head.
    pub clearance_mm: Option<f64>,
}

impl Target {
    /// Angle between beam and normal, degrees.
    pub fn tilt_deg(&self) -> f64 {
        angle::between_deg(&self.a, &self.n)
    }

    /// Travel direction on the surface, unit, square to n.
    pub fn tangent(&self) -> Vector3<f64> {
        let along = self.a.dot(&self.n);
        let flat = if along.abs() > 1e-6 { self.o - self.a * (self.o.dot(&self.n) / along) } else { self.o };
        travel(&flat, &self.n)
    }

    /// How the beam is tilted against the normal.
    pub fn tilt(&self) -> Tilt {
        Tilt::of(&self.a, &self.n, &self.tangent())
    }

    /// How long the move from the target before takes, s: at the speed of the work, and no faster than a contact tool may
    /// swing.
    pub fn seconds_from(&self, before: &Target, settings: &ProcessSettings) -> f64 {
        let work_s = (self.p - before.p).norm() / settings.speed_mm_s;
        let is_bound = settings.axis_speed_mm_s > 0.0;
        let swing_s = if is_bound { (self.foot - before.foot).norm() / settings.axis_speed_mm_s } else { 0.0 };
        work_s.max(swing_s)
    }

    /// Where the focus stands: `p + D·a`, from the foot of the axis, mm.
    pub fn focus(&self, defocus_mm: f64) -> Point3<f64> {
        self.foot + self.a * defocus_mm
    }

    /// The path frame `[n o a | p + D·a]` in the part frame (P2: n = o × a).
    pub fn frame(&self, defocus_mm: f64) -> Isometry3<f64> {
        frame(&self.focus(defocus_mm), &self.a, &self.o)
    }
}

/// Frame with z along the unit axis `a` and y along the unit `o` square to it.
pub fn frame(origin: &Point3<f64>, a: &Vector3<f64>, o: &Vector3<f64>) -> Isometry3<f64> {
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[o.cross(a), *o, *a]));
    Isometry3::from_parts(Translation3::from(origin.coords), UnitQuaternion::from_rotation_matrix(&rotation))
}

/// How far a beam axis turns against the normal that is carried along: normal and axis before and behind,
/// degrees.
pub fn against_normal_deg(before: (&Vector3<f64>, &Vector3<f64>), behind: (&Vector3<f64>, &Vector3<f64>)) -> f64 {
    angle::between_deg(&(angle::rotation_between(before.0, behind.0) * before.1), behind.1)
}

/// The part of a tangent that is square to the axis, unit.
pub fn travel(tangent: &Vector3<f64>, a: &Vector3<f64>) -> Vector3<f64> {
    angle::unit(tangent - a * a.dot(tangent)).unwrap_or_else(|| angle::any_square_to(a))
}

/// The targets along one line of one surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// Surface number.
    pub surface: u32,
    /// What it is made with.
    pub settings: ProcessSettings,
    /// Unit normal of its section plane (m).
    pub plane_normal: Vector3<f64>,
    /// Whether it ends where it began.
    pub closed: bool,
    /// Its targets in order.
    pub targets: Vec<Target>,
    /// Number of points of its line; those of a section are where the plane crosses edges of the part.
    pub line_points: usize,
    /// Number of points of its dense line, from which the targets were chosen; a closed one repeats its first.
    pub dense_points: usize,
    /// Largest distance of a dropped point from its chord, mm.
    pub chord_error_mm: f64,
    /// Where the laser is off while the beam turns, because every lit way to turn is blocked.
    pub splits: Vec<Split>,
}

/// A place where a pass is split: two targets at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Split {
    /// Index of the second of the two; the move that ends at it is made with the laser off.
    pub point: usize,
    /// What the beam would hit on the way.
    pub wall: Option<Blocker>,
}

impl Pass {
    /// Length of the moves that `which` picks by the target they end at, mm.
    pub fn length_mm(&self, which: impl Fn(&Target, &Target) -> bool) -> f64 {
        self.targets
            .windows(2)
            .filter(|w| which(&w[0], &w[1]))
            .map(|w| (w[1].p - w[0].p).norm())
            .fold(0.0, |a, b| a + b)
    }

    /// Whether the laser is off between two neighbouring targets though nothing blocks the beam: a gap that the
    /// line passes over, or a split.
    pub fn is_gap(from: &Target, to: &Target) -> bool {
        !to.laser && from.state != TargetState::Blocked && to.state != TargetState::Blocked
    }

    /// Fastest turn of the beam against the normal on lit moves that touch a corrected target, degrees/mm.
    pub fn max_tilt_rate_deg_mm(&self) -> f64 {
        let is = |t: &Target| t.state == TargetState::Corrected;
        let rate = |w: &[Target]| {
            let way_mm = (w[1].p - w[0].p).norm();
            against_normal_deg((&w[0].n, &w[0].a), (&w[1].n, &w[1].a)) / way_mm.max(1e-9)
        };
        self.targets.windows(2).filter(|w| w[1].laser && (is(&w[0]) || is(&w[1]))).map(rate).fold(0.0, f64::max)
    }

    /// Runs of targets that are reached with the laser on: first and last index of each.
    pub fn lit_pieces(&self) -> Vec<(usize, usize)> {
        let mut pieces: Vec<(usize, usize)> = Vec::new();
        for (i, _) in self.targets.iter().enumerate().filter(|(_, t)| t.laser) {
            match pieces.last_mut() {
                Some((_, last)) if *last + 1 == i => *last = i,
                _ => pieces.push((i - 1, i)),
            }
        }
        pieces
    }
}
