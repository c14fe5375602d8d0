//! An arm whose files hold its capsules: it moves as they do. What cannot be read is told by its key.

use super::*;
use crate::cell::check::FigureError;
use crate::cell::robot::LinkCapsule;
use crate::part::{LoadError, angle};
use crate::sample::{Triangles, solids, stl_bytes};
use nalgebra::{Point3, Translation3, Vector3};
use proptest::prelude::*;
use std::fs;

/// Facets of a capsule, inscribed: two halves of a sphere, drawn apart. A hundredth of the radius lies outside at most.
fn facets(from: &Point3<f64>, to: &Point3<f64>, radius_mm: f64) -> Triangles {
    let length = (to - from).norm();
    let axis = angle::unit(to - from).unwrap_or_else(Vector3::z);
    let place = Translation3::from(from.coords) * angle::rotation_between(&Vector3::z(), &axis);
    let drawn = |p: [f64; 3]| {
        let z = if p[2] > 0.0 { p[2] + length } else { p[2] };
        (place * Point3::new(p[0], p[1], z)).coords.into()
    };
    solids::sphere(radius_mm, 32, 17).into_iter().map(|t| t.map(drawn)).collect()
}

/// The text of a shipped robot's file with bodies.
fn with_bodies(key: &str, bodies: &str) -> String {
    let (_, text) = crate::cell::robot::SHIPPED.iter().find(|(k, _)| *k == key).expect("shipped");
    format!("{text}\n[links.meshes]\n{bodies}")
}

/// A shipped robot whose bodies have files with the facets of its own capsules, in metres, drawn as it stands at some
/// joints; where a link has two bodies, the second one is a ball in the end of the first.
pub(crate) fn meshed(key: &str, at_deg: Joints) -> Robot {
    let folder = tempfile::tempdir().expect("a folder");
    let [base, shoulder, upper, forearm, wrist] = Robot::load(key, None).expect("shipped").capsules(&at_deg);
    let end = |c: LinkCapsule| LinkCapsule { from: c.to, ..c };
    let bodies = [base, shoulder, upper, forearm, end(forearm), wrist, end(wrist)];
    let mut named = format!("at_deg = {at_deg:?}\n");
    for (k, c) in bodies.into_iter().enumerate() {
        let metres = facets(&c.from, &c.to, c.radius_mm).into_iter().map(|t| t.map(|p| p.map(|mm| mm / 1000.0)));
        fs::write(folder.path().join(format!("{k}.stl")), stl_bytes(&metres.collect())).expect("written");
        let body = if k == 0 { "base".into() } else { format!("j{k}") };
        named += &format!("{body} = {{ file = \"{k}.stl\", unit = \"m\" }}\n");
    }
    fs::write(folder.path().join("arm.toml"), with_bodies(key, &named)).expect("written");
    Robot::load("arm.toml", Some(folder.path())).expect("an arm of seven bodies")
}

/// Why a robot cannot be used whose only body is a sphere for joint 3, its middle at a height above the base.
fn refused(body: &str, sphere: Triangles, z: f64) -> RobotError {
    let folder = tempfile::tempdir().expect("a folder");
    let raised: Triangles = sphere.into_iter().map(|t| t.map(|[x, y, h]| [x, y, h + z])).collect();
    fs::write(folder.path().join("ball.stl"), stl_bytes(&raised)).expect("written");
    let file = folder.path().join("arm.toml");
    fs::write(&file, with_bodies("mz04", body)).expect("written");
    Robot::load(&file.display().to_string(), None).expect_err("refused")
}

#[test]
fn what_is_no_body_is_named_with_its_key() {
    let ball = || solids::sphere(60.0, 12, 6);
    let gone = refused("j3 = { file = \"j3.stl\" }", ball(), 600.0);
    let RobotError::Mesh { file, key: "links.meshes.j3", what: LoadError::Io { file: body, .. } } = &gone else {
        panic!("{gone:?}")
    };
    assert!(file.ends_with("arm.toml") && body.ends_with("j3.stl"), "{gone}");
    let text = refused("j3 = { file = \"arm.toml\" }", ball(), 600.0);
    assert!(matches!(text, RobotError::Mesh { what: LoadError::Unusable { .. }, .. }), "{text:?}");

    let figure = |body: &str, sphere: Triangles, z: f64| match refused(body, sphere, z) {
        RobotError::Figure { what, .. } => *what,
        other => panic!("{other:?}"),
    };
    // The elbow of the MZ04 stands at 600 mm where its upper arm is upright; the arm is 613 mm long.
    let standing = "at_deg = [0.0, 90.0, 0.0, 0.0, 0.0, 0.0]\nj3 = { file = \"ball.stl\" }";
    let off = figure(standing, ball(), 0.0);
    assert!(
        matches!(off, RobotFigureError::MeshOff { key: "links.meshes.j3", off_mm, .. } if (off_mm - 540.0).abs() < 1e-3)
    );
    let in_metres = standing.replace("\" }", "\", unit = \"m\" }");
    assert!(matches!(figure(&in_metres, ball(), 600.0), RobotFigureError::MeshOff { .. }));
    let nowhere = figure("at_deg = [0.0, 4000.0, 0.0, 0.0, 0.0, 0.0]", ball(), 0.0);
    assert!(
        matches!(&nowhere, RobotFigureError::Figure(FigureError::Range { key, value: 4000.0, .. }) if key == "links.meshes.at_deg"),
        "{nowhere}"
    );
    let twice = format!("{standing}\nj4 = {{ file = \"ball.stl\" }}");
    let most = MOST_MESH_FACETS;
    let fine = figure(&twice, solids::sphere(60.0, 400, 127), 600.0);
    assert_eq!(fine, RobotFigureError::MeshFacets { facets: 2 * 2 * 400 * 126, most });
}

/// A link is left to its capsule as long as a body of it has no file.
#[test]
fn a_capsule_goes_where_all_of_its_link_has_files() {
    let mut robot = meshed("mz04", [0.0; 6]);
    assert!(
        [Link::Base, Link::Shoulder, Link::UpperArm, Link::Forearm, Link::Wrist]
            .iter()
            .all(|l| robot.links.meshes.cover(*l))
    );
    robot.links.meshes.j4 = None;
    assert!(!robot.links.meshes.cover(Link::Forearm) && robot.links.meshes.cover(Link::Wrist));
    assert!(!Robot::load("mz04", None).expect("shipped").links.meshes.cover(Link::Base));
    assert_ne!(robot, meshed("mz04", [0.0; 6]));
    assert_eq!(meshed("mz04", [0.0; 6]), meshed("mz04", [0.0; 6]));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// However the arm stood when it was drawn, its bodies go where its capsules go, no farther than their levers tell.
    #[test]
    fn bodies_go_with_their_capsules(u in prop::array::uniform6(0.0..1.0f64), drawn in prop::array::uniform6(0.0..1.0f64),
                                     joint in 0..6usize, turn in 0.1..30.0f64, is_ur in prop::bool::ANY) {
        let key = if is_ur { "ur5e" } else { "tx2-60" };
        let limits = Robot::load(key, None).expect("shipped").limits_deg;
        let within = |share: [f64; 6]| -> Joints {
            std::array::from_fn(|i| limits[i][0] + (limits[i][1] - limits[i][0]) * share[i])
        };
        let (joints, at_deg) = (within(u), within(drawn));
        let robot = meshed(key, at_deg);
        let mut turned = joints;
        turned[joint] += turn;
        let capsules = robot.capsules(&joints);
        let [drawn, there, on] = [&at_deg, &joints, &turned].map(|j| robot.frames(j));
        let reach = robot.mesh_levers_mm()[joint] * turn.to_radians();
        for (k, link, mesh) in robot.links.meshes.bodies() {
            let [place, next] = [&there, &on].map(|f| f[k] * drawn[k].inverse());
            let capsule = capsules.iter().find(|c| c.link == link).expect("five");
            // The forearm's capsule of a UR leads to its wrist, which joint 4 moves.
            for v in mesh.solid().mesh.vertices.iter().step_by(7) {
                let p = place * v;
                let off = crate::part::distance::point_segment(&p, &capsule.from, &capsule.to);
                let is_inside = k == 4 || k == 6;
                if !(is_ur && link == Link::Forearm) {
                    let depth = capsule.radius_mm - off;
                    prop_assert!(depth > -0.01 && (is_inside || depth < 0.01), "{link:?}: {off} mm off the axis");
                }
                let moved = (next * v - p).norm();
                prop_assert!(moved <= reach + 1e-9, "body {k} moves {moved} of {reach}");
            }
        }
    }
}
