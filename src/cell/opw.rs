//! Six joints with a spherical wrist: forward and closed inverse kinematics.
//!
//! M. Brandstötter, A. Angerer, M. Hofbaur, "An Analytical Solution of the Inverse Kinematics Problem
//! of Industrial Serial Manipulators with an Ortho-parallel Basis and a Spherical Wrist" (2014).
//! Turns beyond ±180° and limits are not its business.

use nalgebra::{Isometry3, Matrix3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// The seven lengths (mm) and the zero position of the joints.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Opw {
    /// Axis 1 to axis 2, horizontally.
    pub a1_mm: f64,
    /// Axis 3 to the wrist, square to the forearm.
    pub a2_mm: f64,
    /// Sideways offset of the arm's plane.
    pub b_mm: f64,
    /// Base to axis 2.
    pub c1_mm: f64,
    /// Upper arm.
    pub c2_mm: f64,
    /// Forearm.
    pub c3_mm: f64,
    /// Wrist to flange.
    pub c4_mm: f64,
    /// Joint `j` stands at `sign·j − offset` in the model.
    pub offsets_deg: [f64; 6],
    /// 1 or −1.
    pub signs: [f64; 6],
}

/// Below this sine of the wrist's bend joints 4 and 6 turn about the same axis; then joint 4 is 0.
const STRAIGHT: f64 = 1e-9;

impl Opw {
    fn model(&self, joints_deg: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|i| (joints_deg[i] * self.signs[i] - self.offsets_deg[i]).to_radians())
    }

    fn pendant(&self, model: [f64; 6]) -> [f64; 6] {
        std::array::from_fn(|i| {
            let deg = (model[i].to_degrees() + self.offsets_deg[i]) * self.signs[i];
            deg - 360.0 * libm::round(deg / 360.0)
        })
    }

    /// Shoulder, elbow, wrist and flange in the base, mm, and the flange's rotation.
    fn chain(&self, joints_deg: &[f64; 6]) -> ([Point3<f64>; 4], Matrix3<f64>) {
        let q = self.model(joints_deg);
        let ((s1, c1), (s2, c2)) = (libm::sincos(q[0]), libm::sincos(q[1]));
        let (s23, c23) = libm::sincos(q[1] + q[2]);
        let place = |x: f64, z: f64| Point3::new(x * c1 - self.b_mm * s1, x * s1 + self.b_mm * c1, z + self.c1_mm);
        let elbow = (self.a1_mm + self.c2_mm * s2, self.c2_mm * c2);
        let wrist = (elbow.0 + self.c3_mm * s23 + self.a2_mm * c23, elbow.1 + self.c3_mm * c23 - self.a2_mm * s23);
        let r = Matrix3::new(c1 * c23, -s1, c1 * s23, s1 * c23, c1, s1 * s23, -s23, 0.0, c23);
        let ((s4, c4), (s5, c5), (s6, c6)) = (libm::sincos(q[3]), libm::sincos(q[4]), libm::sincos(q[5]));
        let hand = Matrix3::new(
            c4 * c5 * c6 - s4 * s6,
            -c4 * c5 * s6 - s4 * c6,
            c4 * s5,
            s4 * c5 * c6 + c4 * s6,
            -s4 * c5 * s6 + c4 * c6,
            s4 * s5,
            -s5 * c6,
            s5 * s6,
            c5,
        );
        let r = r * hand;
        let wrist = place(wrist.0, wrist.1);
        let flange = wrist + r.column(2) * self.c4_mm;
        ([place(self.a1_mm, 0.0), place(elbow.0, elbow.1), wrist, flange], r)
    }

    /// Flange in the base, mm.
    pub fn forward(&self, joints_deg: &[f64; 6]) -> Isometry3<f64> {
        self.stand(joints_deg).1
    }

    /// Shoulder, elbow, wrist and flange in the base, mm, and the flange's pose.
    pub fn stand(&self, joints_deg: &[f64; 6]) -> ([Point3<f64>; 4], Isometry3<f64>) {
        let (points, r) = self.chain(joints_deg);
        let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(r));
        (points, Isometry3::from_parts(Translation3::from(points[3].coords), rotation))
    }

    /// Frames that stand with the base and that move with each joint, in the base, mm; each joint's axis goes through
    /// the origin of its own.
    pub fn frames(&self, joints_deg: &[f64; 6]) -> [Isometry3<f64>; 7] {
        let q = self.model(joints_deg);
        let [shoulder, elbow, wrist, _] = self.chain(joints_deg).0;
        let about = |axis, angle: f64| UnitQuaternion::from_axis_angle(&axis, angle);
        let (y, z) = (Vector3::y_axis(), Vector3::z_axis());
        let one = about(z, q[0]);
        let (two, three) = (one * about(y, q[1]), one * about(y, q[1] + q[2]));
        let four = three * about(z, q[3]);
        let five = four * about(y, q[4]);
        let frame = |at: Point3<f64>, turn| Isometry3::from_parts(Translation3::from(at.coords), turn);
        [
            Isometry3::identity(),
            frame(Point3::new(0.0, 0.0, self.c1_mm), one),
            frame(shoulder, two),
            frame(elbow, three),
            frame(wrist, four),
            frame(wrist, five),
            frame(wrist, five * about(z, q[5])),
        ]
    }

    /// The joints that bring the flange to a pose, degrees in ±180. The index names the branch:
    /// +1 wrist flipped, +2 elbow the other way, +4 reaching over the back.
    pub fn inverse(&self, base_from_flange: &Isometry3<f64>) -> [Option<[f64; 6]>; 8] {
        let r = base_from_flange.rotation.to_rotation_matrix();
        let r = r.matrix();
        let wrist = base_from_flange.translation.vector - r.column(2) * self.c4_mm;
        let mut out = [None; 8];
        let flat2 = wrist.x * wrist.x + wrist.y * wrist.y - self.b_mm * self.b_mm;
        if flat2 < 0.0 {
            return out;
        }
        let (flat, up) = (flat2.sqrt(), wrist.z - self.c1_mm);
        let (towards, aside) = (libm::atan2(wrist.y, wrist.x), libm::atan2(self.b_mm, flat));
        let k = libm::hypot(self.a2_mm, self.c3_mm);
        let bent = libm::atan2(self.a2_mm, self.c3_mm);
        for (back, q1) in [(0, towards - aside), (4, towards + aside - PI)] {
            let ahead = if back == 0 { flat - self.a1_mm } else { -flat - self.a1_mm };
            let far2 = ahead * ahead + up * up;
            let far = far2.sqrt();
            let (at_shoulder, at_elbow) = (
                (far2 + self.c2_mm * self.c2_mm - k * k) / (2.0 * far * self.c2_mm),
                (far2 - self.c2_mm * self.c2_mm - k * k) / (2.0 * self.c2_mm * k),
            );
            // Not `> 1.0`: where the wrist stands in the shoulder the quotient is no number.
            if !(at_shoulder.abs() <= 1.0 && at_elbow.abs() <= 1.0) {
                continue;
            }
            let (lift, bend) = (libm::acos(at_shoulder), libm::acos(at_elbow));
            let line = libm::atan2(ahead, up);
            let (s1, c1) = libm::sincos(q1);
            for (other, q2, q3) in [(0, line - lift, bend - bent), (2, line + lift, -bend - bent)] {
                let (s23, c23) = libm::sincos(q2 + q3);
                let forearm = Matrix3::new(c1 * c23, -s1, c1 * s23, s1 * c23, c1, s1 * s23, -s23, 0.0, c23);
                let hand = forearm.tr_mul(r);
                let s5 = libm::hypot(hand[(0, 2)], hand[(1, 2)]);
                let q5 = libm::atan2(s5, hand[(2, 2)]);
                let (q4, q6) = if s5 > STRAIGHT {
                    (libm::atan2(hand[(1, 2)], hand[(0, 2)]), libm::atan2(hand[(2, 1)], -hand[(2, 0)]))
                } else {
                    (0.0, libm::atan2(hand[(1, 0)], hand[(1, 1)]))
                };
                out[back + other] = Some(self.pendant([q1, q2, q3, q4, q5, q6]));
                out[back + other + 1] = Some(self.pendant([q1, q2, q3, q4 + PI, -q5, q6 - PI]));
            }
        }
        out
    }

    /// How far from a pose in which a direction of motion is lost: the least of the sine of the
    /// wrist's bend, the sine of the elbow's, and the wrist's distance from axis 1 as a share of
    /// the arm's length. 0 is singular.
    pub fn singularity(&self, joints_deg: &[f64; 6]) -> f64 {
        let q = self.model(joints_deg);
        let k = libm::hypot(self.a2_mm, self.c3_mm);
        let bent = libm::atan2(self.a2_mm, self.c3_mm);
        let ahead = self.a1_mm + self.c2_mm * libm::sin(q[1]) + k * libm::sin(q[1] + q[2] + bent);
        let elbow = libm::sin(q[2] + bent).abs();
        libm::sin(q[4]).abs().min(elbow).min(ahead.abs() / (self.c2_mm + k))
    }

    /// How far any point of the arm, up to the middle of the flange, is from each axis that moves
    /// it, at most, mm.
    pub fn levers_mm(&self) -> [f64; 6] {
        let hand = self.c4_mm.abs();
        let forearm = libm::hypot(self.a2_mm, self.c3_mm) + hand;
        let arm = self.c2_mm + forearm;
        [libm::hypot(self.a1_mm.abs() + arm, self.b_mm), arm, forearm, hand, hand, 0.0]
    }

    /// Every length, with its name.
    pub fn lengths(&self) -> [(&'static str, f64); 7] {
        [
            ("a1_mm", self.a1_mm),
            ("a2_mm", self.a2_mm),
            ("b_mm", self.b_mm),
            ("c1_mm", self.c1_mm),
            ("c2_mm", self.c2_mm),
            ("c3_mm", self.c3_mm),
            ("c4_mm", self.c4_mm),
        ]
    }
}
