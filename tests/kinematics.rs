//! The closed inverse beside `rs-opw-kinematics`: the same forward pose, and the same solutions, for
//! every shipped robot with a spherical wrist.

use clearbeam::cell::{Joints, Robot};
use proptest::prelude::*;
use rs_opw_kinematics::glam::{DQuat, DVec3};
use rs_opw_kinematics::kinematic_traits::Kinematics as _;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use rs_opw_kinematics::pose::Pose;

/// The peer, built from the robot's own file.
fn peer(key: &str) -> Option<OPWKinematics> {
    let text = std::fs::read_to_string(format!("{}/assets/robots/{key}.toml", env!("CARGO_MANIFEST_DIR")));
    let table: toml::Table = text.expect("shipped").parse().expect("TOML");
    let opw = table.get("opw")?;
    let number = |v: &toml::Value| v.as_float().expect("a number");
    let metres = |name: &str| number(&opw[name]) / 1000.0;
    let six = |name: &str| opw[name].as_array().expect("six").iter().map(number).collect::<Vec<_>>();
    let (offsets, signs) = (six("offsets_deg"), six("signs"));
    Some(OPWKinematics::new(Parameters {
        a1: metres("a1_mm"),
        a2: metres("a2_mm"),
        b: metres("b_mm"),
        c1: metres("c1_mm"),
        c2: metres("c2_mm"),
        c3: metres("c3_mm"),
        c4: metres("c4_mm"),
        offsets: std::array::from_fn(|i| offsets[i].to_radians()),
        sign_corrections: std::array::from_fn(|i| signs[i] as i8),
        dof: 6,
    }))
}

/// Difference of two angles, whole turns taken out, degrees.
fn apart(a: f64, b: f64) -> f64 {
    let d = a - b;
    (d - 360.0 * (d / 360.0).round()).abs()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn forward_and_inverse_agree_with_the_peer(u in prop::array::uniform6(0.0..1.0f64), which in 0..11usize) {
        let keys: Vec<&str> = Robot::shipped().filter(|k| *k != "ur5e").collect();
        let (key, robot) = (keys[which], Robot::load(keys[which], None).expect("shipped"));
        let peer = peer(key).expect("a spherical wrist");
        let joints: Joints = std::array::from_fn(|i| {
            let [low, high] = robot.limits_deg[i];
            low + (high - low) * u[i]
        });
        // Next to a singularity neither can say which of many solutions is meant.
        prop_assume!(robot.singularity(&joints) > 0.01);
        let ours = robot.forward(&joints);
        let theirs = peer.forward(&joints.map(f64::to_radians));
        let at = ours.translation.vector / 1000.0;
        prop_assert!(theirs.translation.distance(DVec3::new(at.x, at.y, at.z)) < 1e-9);
        let q = ours.rotation;
        let rotation = DQuat::from_xyzw(q.i, q.j, q.k, q.w);
        prop_assert!(theirs.rotation.angle_between(rotation) < 1e-7 || theirs.rotation.angle_between(-rotation) < 1e-7);

        let pose = Pose { translation: DVec3::new(at.x, at.y, at.z), rotation };
        let found: Vec<Joints> = robot.inverse(&ours).into_iter().flatten().collect();
        for solution in peer.inverse(&pose) {
            let deg = solution.map(f64::to_degrees);
            let known = found.iter().any(|f| (0..6).all(|j| apart(f[j], deg[j]) < 1e-4));
            prop_assert!(known, "{key}: the peer has {deg:?}, we have {found:?}");
        }
    }
}
