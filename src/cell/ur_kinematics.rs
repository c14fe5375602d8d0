//! Six joints without a spherical wrist, as the arms of Universal Robots have them: forward and
//! closed inverse kinematics over the maker's DH parameters (α = 90, 0, 0, 90, −90, 0°).

use nalgebra::{Isometry3, Matrix4, Point3, Rotation3, Translation3, UnitQuaternion};
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_PI_2, PI};

/// DH lengths, mm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UrKinematics {
    /// Base to axis 2.
    pub d1_mm: f64,
    /// Upper arm; negative, as the maker prints it.
    pub a2_mm: f64,
    /// Forearm; negative.
    pub a3_mm: f64,
    /// Sideways offset of the wrist.
    pub d4_mm: f64,
    /// Wrist 2 to wrist 3.
    pub d5_mm: f64,
    /// Wrist 3 to flange.
    pub d6_mm: f64,
}

/// Below this sine of joint 5 joints 4 and 6 are parallel; then joint 6 is 0.
const STRAIGHT: f64 = 1e-9;

/// One, and what rounding adds to a cosine of a pose made by `forward`.
const ONE: f64 = 1.0 + 1e-12;

/// DH step: turn about z, along z, along x, turn about x by 90°·`quarter`.
fn step(theta: f64, d: f64, a: f64, quarter: f64) -> Matrix4<f64> {
    let (s, c) = libm::sincos(theta);
    let (sa, ca) = (quarter, 1.0 - quarter.abs());
    Matrix4::new(
        c,
        -s * ca,
        s * sa,
        a * c, //
        s,
        c * ca,
        -c * sa,
        a * s, //
        0.0,
        sa,
        ca,
        d, //
        0.0,
        0.0,
        0.0,
        1.0,
    )
}

fn isometry(m: &Matrix4<f64>) -> Isometry3<f64> {
    let r = Rotation3::from_matrix_unchecked(m.fixed_view::<3, 3>(0, 0).into());
    let at = m.fixed_view::<3, 1>(0, 3).into_owned();
    Isometry3::from_parts(Translation3::from(at), UnitQuaternion::from_rotation_matrix(&r))
}

/// Inverse of a rigid transformation.
fn inverse(m: &Matrix4<f64>) -> Matrix4<f64> {
    let r = m.fixed_view::<3, 3>(0, 0).transpose();
    let t = -(r * m.fixed_view::<3, 1>(0, 3));
    let mut out = Matrix4::identity();
    out.fixed_view_mut::<3, 3>(0, 0).copy_from(&r);
    out.fixed_view_mut::<3, 1>(0, 3).copy_from(&t);
    out
}

impl UrKinematics {
    fn steps(&self, q: &[f64; 6]) -> [Matrix4<f64>; 6] {
        [
            step(q[0], self.d1_mm, 0.0, 1.0),
            step(q[1], 0.0, self.a2_mm, 0.0),
            step(q[2], 0.0, self.a3_mm, 0.0),
            step(q[3], self.d4_mm, 0.0, 1.0),
            step(q[4], self.d5_mm, 0.0, -1.0),
            step(q[5], self.d6_mm, 0.0, 0.0),
        ]
    }

    /// Flange in the base, mm.
    pub fn forward(&self, joints_deg: &[f64; 6]) -> Isometry3<f64> {
        self.stand(joints_deg).1
    }

    /// Shoulder, elbow, wrist and flange in the base, mm, and the flange's pose; the arm's own sideways offset is
    /// spread as the maker builds it: upper arm and forearm beside each other.
    pub fn stand(&self, joints_deg: &[f64; 6]) -> ([Point3<f64>; 4], Isometry3<f64>) {
        let s = self.steps(&joints_deg.map(f64::to_radians));
        let aside = self.d4_mm;
        let at = |m: &Matrix4<f64>, z: f64| Point3::from((m * nalgebra::Vector4::new(0.0, 0.0, z, 1.0)).xyz());
        let (shoulder, elbow) = (s[0], s[0] * s[1]);
        let wrist = elbow * s[2] * s[3] * s[4];
        let flange = wrist * s[5];
        ([at(&shoulder, aside), at(&elbow, aside), at(&wrist, 0.0), at(&flange, 0.0)], isometry(&flange))
    }

    /// Frames that stand with the base and that move with each joint, in the base, mm; each joint's axis goes through
    /// the origin of its own.
    pub fn frames(&self, joints_deg: &[f64; 6]) -> [Isometry3<f64>; 7] {
        let mut frames = [Isometry3::identity(); 7];
        let mut before = Matrix4::identity();
        for (frame, step) in frames[1..].iter_mut().zip(self.steps(&joints_deg.map(f64::to_radians))) {
            // A DH frame lies on the axis of the joint that follows it.
            let after = before * step;
            *frame = Isometry3::from_parts(isometry(&before).translation, isometry(&after).rotation);
            before = after;
        }
        frames
    }

    /// How far any point of the arm, up to the middle of the flange, is from each axis that moves
    /// it, at most, mm.
    pub fn levers_mm(&self) -> [f64; 6] {
        let last = self.d6_mm.abs();
        let wrist = self.d5_mm.abs() + last;
        let forearm = self.a3_mm.abs() + wrist;
        let arm = self.a2_mm.abs() + forearm;
        [libm::hypot(arm, self.d4_mm), arm, forearm, wrist, last, 0.0]
    }

    /// The joints that bring the flange to a pose, degrees in ±180. The index names the branch:
    /// +1 elbow the other way, +2 wrist flipped, +4 shoulder the other way.
    pub fn inverse(&self, base_from_flange: &Isometry3<f64>) -> [Option<[f64; 6]>; 8] {
        let m = base_from_flange.to_homogeneous();
        let (x, z) = (m.fixed_view::<3, 1>(0, 3).into_owned(), m.fixed_view::<3, 1>(0, 2).into_owned());
        let p5 = x - z * self.d6_mm;
        let mut out = [None; 8];
        let aside = self.d4_mm / libm::hypot(p5.x, p5.y);
        if !(-1.0..=1.0).contains(&aside) {
            return out;
        }
        let (towards, swing) = (libm::atan2(p5.y, p5.x) + FRAC_PI_2, libm::acos(aside));
        for (shoulder, q1) in [(0, towards + swing), (4, towards - swing)] {
            let (s1, c1) = libm::sincos(q1);
            let cos5 = (x.x * s1 - x.y * c1 - self.d4_mm) / self.d6_mm;
            if !(-ONE..=ONE).contains(&cos5) {
                continue;
            }
            let bend = libm::acos(cos5.clamp(-1.0, 1.0));
            for (wrist, q5) in [(0, bend), (2, -bend)] {
                let s5 = libm::sin(q5);
                let q6 = if s5.abs() > STRAIGHT {
                    libm::atan2((-m[(0, 1)] * s1 + m[(1, 1)] * c1) / s5, (m[(0, 0)] * s1 - m[(1, 0)] * c1) / s5)
                } else {
                    0.0
                };
                let first = inverse(&step(q1, self.d1_mm, 0.0, 1.0));
                let last = step(q5, self.d5_mm, 0.0, -1.0) * step(q6, self.d6_mm, 0.0, 0.0);
                let m14 = first * m * inverse(&last);
                // Axis 4 stands d4 along z of frame 4's own step; what is left is planar.
                let (px, py) = (m14[(0, 3)], m14[(1, 3)]);
                let cos3 = (px * px + py * py - self.a2_mm * self.a2_mm - self.a3_mm * self.a3_mm)
                    / (2.0 * self.a2_mm * self.a3_mm);
                if !(-ONE..=ONE).contains(&cos3) {
                    continue;
                }
                let fold = libm::acos(cos3.clamp(-1.0, 1.0));
                for (elbow, q3) in [(0, fold), (1, -fold)] {
                    let (s3, c3) = libm::sincos(q3);
                    let q2 = libm::atan2(py, px) - libm::atan2(self.a3_mm * s3, self.a2_mm + self.a3_mm * c3);
                    // Rotation 1→4 is about z by q2 + q3 + q4, then a quarter about x.
                    let q234 = libm::atan2(m14[(1, 0)], m14[(0, 0)]);
                    let q = [q1, q2, q3, q234 - q2 - q3, q5, q6];
                    out[shoulder + wrist + elbow] = Some(q.map(|a| {
                        let turns = libm::round(a / (2.0 * PI));
                        (a - turns * 2.0 * PI).to_degrees()
                    }));
                }
            }
        }
        out
    }

    /// How far from a singular pose: the least of the sines of joints 5 and 3, and the wrist's
    /// distance from the shoulder's cylinder as a share of the arm's length. 0 is singular.
    pub fn singularity(&self, joints_deg: &[f64; 6]) -> f64 {
        let q = joints_deg.map(f64::to_radians);
        let ahead = self.a2_mm * libm::cos(q[1])
            + self.a3_mm * libm::cos(q[1] + q[2])
            + self.d5_mm * libm::sin(q[1] + q[2] + q[3]);
        let length = self.a2_mm.abs() + self.a3_mm.abs();
        libm::sin(q[4]).abs().min(libm::sin(q[2]).abs()).min(ahead.abs() / length)
    }

    /// Every length, with its name.
    pub fn lengths(&self) -> [(&'static str, f64); 6] {
        [
            ("d1_mm", self.d1_mm),
            ("a2_mm", self.a2_mm),
            ("a3_mm", self.a3_mm),
            ("d4_mm", self.d4_mm),
            ("d5_mm", self.d5_mm),
            ("d6_mm", self.d6_mm),
        ]
    }
}
