//! Closed forms, what is exempt, and brute force over sampled points.

use super::*;
use crate::cell::bodies::HeadCapsule;
use crate::cell::check::FigureError;
use crate::cell::motion::RefusalCause;
use crate::cell::{Cell, CellError, Frame, Link, Robot};
use crate::part::distance::{point_segment, point_triangle};
use crate::part::{LoadError, Placement, Units};
use crate::sample::{Triangles, solids, stl_bytes};
use nalgebra::Point3;
use proptest::prelude::*;

/// Upper arm upright on axis 1, forearm forward: flange at (352, 0, 625), pointing along x.
const FORWARD: Joints = [0.0, 90.0, 0.0, 0.0, 0.0, 0.0];

fn part(triangles: &Triangles) -> Part {
    Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part")
}

fn setup(robot: &str, mount: Mount) -> Setup {
    let mut cell = Cell::shipped("mz04").expect("shipped");
    cell.bodies = Default::default();
    Setup { cell, robot: Some(Robot::load(robot, None).expect("shipped")), mount, tool: crate::beam::Tool::default() }
}

fn at(position_mm: [f64; 3]) -> Frame {
    Frame::new(position_mm, [0.0; 3])
}

fn first(setup: &Setup, part: &Part) -> Option<Contact> {
    Collision::new(setup, part).expect("a robot").first_contact(&FORWARD)
}

const PART: BodyId = BodyId::Part;
const HEAD: BodyId = BodyId::Head;
const TABLE: BodyId = BodyId::Table;

fn link(link: Link) -> BodyId {
    BodyId::Link(link)
}

fn obstacle(index: usize, file: &str) -> BodyId {
    BodyId::Obstacle { index, file: file.into() }
}

fn touch(a: BodyId, b: BodyId) -> Option<Contact> {
    Some(Contact { a, b })
}

#[test]
fn a_link_keeps_its_radius_and_the_margin_from_a_fixed_part() {
    let cube = part(&solids::cube(20.0));
    let mut setup = setup("mz04", Mount::ToolInHand);
    let links = setup.robot.as_ref().expect("one").links.clone();
    let reach = links.upper_arm_mm + 5.0;
    setup.cell.base_from_part = at([reach - 0.001, -10.0, 400.0]);
    assert_eq!(first(&setup, &cube), touch(link(Link::UpperArm), PART));
    setup.cell.base_from_part = at([reach + 0.001, -10.0, 400.0]);
    assert_eq!(first(&setup, &cube), None);
    // Under the middle of the wrist capsule, which the tool in hand does not excuse.
    setup.cell.base_from_part = at([310.0, -10.0, 625.0 - links.wrist_mm - 5.0 - 20.0 + 0.001]);
    let contact = first(&setup, &cube).expect("touches");
    assert!([link(Link::Wrist), link(Link::Forearm)].contains(&contact.a) && contact.b == PART, "{contact:?}");
}

#[test]
fn a_carried_part_keeps_the_margin_from_head_table_and_arm() {
    let cube = part(&solids::cube(20.0));
    let mut setup = setup("mz04", Mount::PartInHand);
    // The flange points along x: its z from 60 to 80 is x from 412 to 432 in the base.
    setup.cell.flange_from_part = at([-10.0, -10.0, 60.0]);
    setup.cell.bodies.head = vec![HeadCapsule { from_mm: -50.0, to_mm: 200.0, radius_mm: 25.0 }];
    setup.cell.base_from_laser = at([432.0 + 30.0 - 0.001, 0.0, 600.0]);
    assert_eq!(first(&setup, &cube), touch(PART, HEAD));
    setup.cell.base_from_laser = at([432.0 + 30.0 + 0.001, 0.0, 600.0]);
    assert_eq!(first(&setup, &cube), None);
    // The flange's x points up: this hangs from 225 to 245 mm, below the lowest link but the base.
    setup.cell.flange_from_part = at([-400.0, -10.0, 60.0]);
    for (table_z_mm, contact) in [(220.001, touch(PART, TABLE)), (219.999, None)] {
        setup.cell.bodies.table_z_mm = Some(table_z_mm);
        assert_eq!(first(&setup, &cube), contact);
    }
    setup.cell.bodies.table_z_mm = None;
    // Beside the upper arm, 352 mm back along the flange's axis.
    let arm = setup.robot.as_ref().expect("one").links.upper_arm_mm;
    for (off, contact) in [(-0.001, touch(PART, link(Link::UpperArm))), (0.001, None)] {
        setup.cell.flange_from_part = at([-200.0, -10.0, -352.0 + arm + 5.0 + off]);
        assert_eq!(first(&setup, &cube), contact);
    }
}

#[test]
fn what_carries_and_what_stands_is_exempt() {
    let cube = part(&solids::cube(20.0));
    let mut hand = setup("mz04", Mount::PartInHand);
    hand.cell.flange_from_part = at([-10.0, -10.0, -10.0]);
    assert_eq!(first(&hand, &cube), None, "the wrist carries the part");
    hand.cell.bodies.table_z_mm = Some(20.0);
    hand.cell.bodies.head = vec![HeadCapsule { from_mm: 0.0, to_mm: 50.0, radius_mm: 20.0 }];
    hand.cell.base_from_laser = at([0.0, 0.0, 60.0]);
    assert_eq!(first(&hand, &cube), None, "the base stands on the table, and the head stands as well");
    let mut tool = setup("mz04", Mount::ToolInHand);
    tool.cell.flange_from_tool = at([0.0, 0.0, 100.0]);
    tool.cell.bodies.head = vec![HeadCapsule { from_mm: 0.0, to_mm: 50.0, radius_mm: 20.0 }];
    tool.cell.base_from_part = at([440.0, -10.0, 615.0]);
    assert_eq!(first(&tool, &cube), touch(HEAD, PART), "but not the wrist that carries the head");
    tool.cell.bodies.head = vec![HeadCapsule { from_mm: 40.0, to_mm: 90.0, radius_mm: 20.0 }];
    assert_eq!(first(&tool, &cube), None, "the wrist carries the head");
    tool.cell.bodies.head = vec![HeadCapsule { from_mm: 0.0, to_mm: 200.0, radius_mm: 20.0 }];
    assert_eq!(first(&tool, &cube), touch(HEAD, link(Link::Forearm)));
    let mut none = tool;
    none.robot = None;
    assert!(Collision::new(&none, &cube).is_none());
}

#[test]
fn clearance_is_the_distance_of_head_and_box_and_of_what_is_nearer() {
    let cube = part(&solids::cube(20.0));
    let mut tool = setup("mz04", Mount::ToolInHand);
    let told = |setup: &Setup| Collision::new(setup, &cube).expect("a robot").clearance(&FORWARD);
    let is = |told: Option<(f64, Contact)>, mm: f64, pair: Option<Contact>| {
        let (found, between) = told.expect("something is near");
        assert!((found - mm).abs() < 1e-9 && Some(&between) == pair.as_ref(), "{found} mm, {between:?}");
    };
    // The head goes on along the flange's axis: its ball ends at x = 352 + 100 - 10 + 8.
    tool.cell.flange_from_tool = at([0.0, 0.0, 100.0]);
    tool.cell.bodies.head = vec![HeadCapsule { from_mm: 10.0, to_mm: 60.0, radius_mm: 8.0 }];
    tool.cell.base_from_part = at([450.0 + 12.5, -10.0, 615.0]);
    is(told(&tool), 12.5, touch(HEAD, PART));
    // Beside an edge that is 30 mm to the side and 40 mm ahead of the ball's middle.
    tool.cell.base_from_part = at([442.0 + 40.0, 30.0, 615.0]);
    is(told(&tool), 50.0 - 8.0, touch(HEAD, PART));
    tool.cell.bodies.table_z_mm = Some(625.0 - 8.0 - 30.0);
    // Axis 2 of this arm is lower than that: the upper arm reaches through the table.
    is(told(&tool), 0.0, touch(link(Link::Shoulder), TABLE));
    tool.cell.bodies.table_z_mm = None;
    tool.cell.base_from_part = at([442.0, -10.0, 615.0]);
    is(told(&tool), 0.0, touch(HEAD, PART));
    // Far enough out for the forearm not to count.
    tool.cell.flange_from_tool = at([0.0, 0.0, 300.0]);
    for (off, mm) in [(-0.5, Some(CLEARANCE_REACH_MM - 0.5)), (0.001, None)] {
        tool.cell.base_from_part = at([650.0 + CLEARANCE_REACH_MM + off, -10.0, 615.0]);
        match mm {
            Some(mm) => is(told(&tool), mm, touch(HEAD, PART)),
            None => assert_eq!(told(&tool), None, "nothing is near"),
        }
    }

    // Held beside the upper arm and above the table.
    let mut hand = setup("mz04", Mount::PartInHand);
    let arm_mm = hand.robot.as_ref().expect("one").links.upper_arm_mm;
    hand.cell.flange_from_part = at([-200.0, -10.0, -352.0 + arm_mm + 21.0]);
    is(told(&hand), 21.0, touch(PART, link(Link::UpperArm)));
    hand.cell.flange_from_part = at([-400.0, -10.0, 60.0]);
    hand.cell.bodies.table_z_mm = Some(218.0);
    is(told(&hand), 7.0, touch(PART, TABLE));
}

/// A cell file beside the STL file of a cube.
fn cell_with_cube(file_of_cube: &str, edge: f64, bodies: &str) -> Result<Cell, CellError> {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join(file_of_cube), stl_bytes(&solids::cube(edge))).expect("written");
    let text = include_str!("../../assets/cells/mz04.toml").replace("table_z_mm = 0.0", bodies);
    let file = folder.path().join("cell.toml");
    std::fs::write(&file, text).expect("written");
    Cell::load(&file)
}

#[test]
fn fixtures_are_read_beside_the_cell_file_and_are_solid() {
    let cube = part(&solids::cube(20.0));
    let mut hand = setup("mz04", Mount::PartInHand);
    let flange_from_part = at([-10.0, -10.0, 60.0]);
    let mut with = |edge: f64, table: &str| {
        hand.cell = cell_with_cube("fixture.stl", edge, table).expect("a cell");
        hand.cell.flange_from_part = flange_from_part.clone();
        first(&hand, &cube)
    };
    let near = |x: f64| format!("obstacles = [{{ file = \"fixture.stl\", position_mm = [{x}, -20.0, 600.0] }}]");
    assert_eq!(with(40.0, &near(437.001)), None);
    assert_eq!(with(40.0, &near(436.999)), touch(PART, obstacle(0, "fixture.stl")));
    let turned = "obstacles = [{ file = \"fixture.stl\", position_mm = [477.001, -20.0, 600.0], \
                  rz_ry_rx_deg = [90.0, 0.0, 0.0] }]\nmargin_mm = 4.99";
    assert_eq!(with(40.0, turned), None);
    // No facet is near, but all of it is inside.
    let around = "obstacles = [{ file = \"fixture.stl\", position_mm = [-1.0, -1.0, -1.0], units = \"m\" }]";
    assert_eq!(with(2.0, around), touch(link(Link::Shoulder), obstacle(0, "fixture.stl")));
    let refused = |bodies: &str| cell_with_cube("fixture.stl", 40.0, bodies).expect_err("refused");
    let gone = refused("obstacles = [{ file = \"fence.stl\" }]");
    assert!(
        matches!(&gone, CellError::Obstacle(LoadError::Io { file, .. }) if file.ends_with("fence.stl")),
        "{gone:?}"
    );
    let figure = |bodies: &str| match refused(bodies) {
        CellError::Figure { file, what, .. } if file.ends_with("cell.toml") => *what,
        other => panic!("{other}"),
    };
    let range = FigureError::Range { key: "bodies.margin_mm".into(), value: 0.0, low: 0.5, high: 200.0 };
    assert_eq!(figure("margin_mm = 0.0"), range);
    let piece = FigureError::HeadPiece { from_mm: 9.0, to_mm: 3.0 };
    assert_eq!(figure("head = [{ from_mm = 9.0, to_mm = 3.0, radius_mm = 5.0 }]"), piece);
}

/// What an obstacle's file is called does not make it another body.
#[test]
fn an_obstacle_is_one_whatever_its_file_is_called() {
    let cube = part(&solids::cube(20.0));
    let mut hand = setup("mz04", Mount::PartInHand);
    for file in ["headstock.stl", "tablet.stl", "part.stl"] {
        let near = format!("obstacles = [{{ file = \"{file}\", position_mm = [430.0, -20.0, 600.0] }}]");
        hand.cell = cell_with_cube(file, 40.0, &near).expect("a cell");
        hand.cell.flange_from_part = at([-10.0, -10.0, 60.0]);
        let contact = first(&hand, &cube).expect("touches");
        assert_eq!(contact.b, obstacle(0, file));
        assert_eq!(RefusalCause::of_contact(&contact), RefusalCause::Obstacle, "{file}");
    }
}

/// A clamp of the job: a cube of 20 mm, in the part's frame.
fn clamp(position_mm: [f64; 3]) -> Obstacle {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("vice.stl"), stl_bytes(&solids::cube(20.0))).expect("written");
    let mut clamp = Obstacle::named("vice.stl".into());
    clamp.position_mm = position_mm;
    clamp.load(Some(folder.path())).expect("a cube");
    clamp
}

#[test]
fn a_clamp_moves_with_the_part_that_the_robot_holds() {
    let cube = part(&solids::cube(20.0));
    let mut hand = setup("mz04", Mount::PartInHand);
    let vice = BodyId::Clamp { index: 0, file: "vice.stl".into() };
    // The flange's x points up, its z along the base's x: the clamp hangs 400 mm below the part, lower than all links.
    hand.cell.flange_from_part = at([-10.0, -10.0, 60.0]);
    hand.tool.clamps = vec![clamp([-400.0, 0.0, 0.0])];
    let lowest = 625.0 - 10.0 - 400.0;
    for (off, contact) in [(0.001, touch(vice.clone(), TABLE)), (-0.001, None)] {
        hand.cell.bodies.table_z_mm = Some(lowest - 5.0 + off);
        assert_eq!(first(&hand, &cube), contact);
    }
    hand.cell.bodies.table_z_mm = None;
    // Beside the upper arm, 412 mm back along the flange's axis.
    let arm_mm = hand.robot.as_ref().expect("one").links.upper_arm_mm;
    for (off, contact) in [(-0.001, touch(vice.clone(), link(Link::UpperArm))), (0.001, None)] {
        hand.tool.clamps = vec![clamp([-190.0, 0.0, -412.0 + arm_mm + 5.0 + off])];
        assert_eq!(first(&hand, &cube), contact);
    }
    // It reaches farther than the part: so does every look between two poses.
    let with = Collision::new(&hand, &cube).expect("a robot").travel_mm(&FORWARD, &[1.0, 90.0, 0.0, 0.0, 0.0, 0.0]);
    hand.tool.clamps.clear();
    let without = Collision::new(&hand, &cube).expect("a robot").travel_mm(&FORWARD, &[1.0, 90.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(with > without + 200.0_f64.to_radians(), "{with} and {without}");
    assert_eq!(RefusalCause::of_contact(&touch(vice, link(Link::UpperArm)).expect("two")), RefusalCause::Obstacle);
}

#[test]
fn a_clamp_stands_with_the_part_under_a_head() {
    let cube = part(&solids::cube(20.0));
    let mut tool = setup("mz04", Mount::ToolInHand);
    tool.cell.base_from_part = at([300.0, 200.0, 0.0]);
    let reach = tool.robot.as_ref().expect("one").links.upper_arm_mm + 5.0;
    let vice = BodyId::Clamp { index: 0, file: "vice.stl".into() };
    for (off, contact) in [(-0.001, touch(link(Link::UpperArm), vice)), (0.001, None)] {
        tool.tool.clamps = vec![clamp([reach + off - 300.0, -210.0, 400.0])];
        assert_eq!(first(&tool, &cube), contact);
    }
    // What stands in the cell is one of it, whatever list it has come to be in for the beam's sake.
    let fixture = clamp([reach - 1.0, -10.0, 400.0]);
    tool.tool.clamps = vec![fixture.seen_in(&tool.cell.base_from_part.isometry().inverse())];
    assert_eq!(first(&tool, &cube), None);
    tool.cell.bodies.obstacles = vec![fixture];
    assert_eq!(first(&tool, &cube), touch(link(Link::UpperArm), obstacle(0, "vice.stl")));
}

/// Distance of two bodies given as points on one and anything on the other, by sampling.
fn sampled(c: &Capsule, off: impl Fn(&Point3<f64>) -> f64) -> f64 {
    let points = (0..=60).map(|i| c.from + (c.to - c.from) * (f64::from(i) / 60.0));
    points.map(|p| off(&p)).fold(f64::INFINITY, f64::min) - c.radius_mm
}

/// How far apart all bodies are that may touch each other, by sampling; `table_z` is the height of the table, mm.
fn sampled_pairs(setup: &Setup, ball: &Part, joints: &Joints, table_z: f64) -> Vec<(BodyId, BodyId, f64)> {
    let (robot, is_carried) = (setup.robot.as_ref().expect("one"), setup.mount == Mount::PartInHand);
    let (flange, links, cell) = (robot.forward(joints), robot.capsules(joints), &setup.cell);
    let facets: Vec<_> = (0..ball.mesh.facets.len()).map(|f| ball.mesh.corners(f)).collect();
    let (head_at, ball_at) = match setup.mount {
        Mount::PartInHand => (cell.base_from_laser.isometry(), flange * cell.flange_from_part.isometry()),
        Mount::ToolInHand => (flange * cell.flange_from_focus(), cell.base_from_part.isometry()),
    };
    let to_ball = |p: &Point3<f64>| {
        let p = ball_at.inverse_transform_point(p);
        facets.iter().map(|c| point_triangle(&p, c)).fold(f64::INFINITY, f64::min)
    };
    let head = Capsule::of(&cell.bodies.head[0], &head_at);
    let to_head = |p: &Point3<f64>| point_segment(p, &head.from, &head.to) - head.radius_mm;
    let to_table = |p: &Point3<f64>| p.z - table_z;
    let mut pairs: Vec<(BodyId, BodyId, f64)> = Vec::new();
    for (i, l) in links.iter().enumerate() {
        let c = Capsule::of_link(l);
        if i > 0 {
            pairs.push((link(l.link), TABLE, sampled(&c, to_table)));
        }
        if if is_carried { i > 0 } else { i < 4 } {
            pairs.push((link(l.link), HEAD, sampled(&c, to_head)));
        }
        if if is_carried { i < 4 } else { i > 0 } {
            pairs.push((link(l.link), PART, sampled(&c, to_ball)));
        }
    }
    if is_carried {
        let lowest = ball.mesh.vertices.iter().map(|v| (ball_at * v).z).fold(f64::INFINITY, f64::min);
        pairs.push((PART, TABLE, lowest - table_z));
    } else {
        pairs.push((HEAD, TABLE, sampled(&head, to_table)));
    }
    pairs.push((HEAD, PART, sampled(&head, to_ball)));
    // Base and upper arm of all these arms share the shoulder.
    for (inner, outer) in [(0, 3), (0, 4), (1, 3), (1, 4), (2, 4)] {
        let (inner, outer) = (&links[inner], &links[outer]);
        let to_inner = |p: &Point3<f64>| point_segment(p, &inner.from, &inner.to) - inner.radius_mm;
        pairs.push((link(outer.link), link(inner.link), sampled(&Capsule::of_link(outer), to_inner)));
    }
    pairs
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// What is said to be free has no sampled pair within the margin; what touches has one, but for
    /// the grain of the samples.
    #[test]
    fn sampled_points_agree(u in prop::array::uniform6(0.0..1.0f64), which in 0..12usize, carried in prop::bool::ANY,
                            place in prop::array::uniform3(-1.0..1.0f64), table in -0.3..0.5f64) {
        let key = Robot::shipped().nth(which).expect("one");
        let mut setup = setup(key, if carried { Mount::PartInHand } else { Mount::ToolInHand });
        let robot = setup.robot.clone().expect("one");
        let size = robot.levers_mm()[1];
        let [x, y, z] = place.map(|p| p * size * 0.8);
        setup.cell.flange_from_part = at([x * 0.1, y * 0.1, 70.0]);
        setup.cell.flange_from_tool = at([x * 0.1, y * 0.1, 120.0]);
        setup.cell.base_from_part = at([x, y, z]);
        setup.cell.base_from_laser = at([x, y, z + 100.0]);
        setup.cell.bodies.head = vec![HeadCapsule { from_mm: 20.0, to_mm: 150.0, radius_mm: 30.0 }];
        setup.cell.bodies.table_z_mm = Some(table * size);
        let ball = part(&solids::sphere(40.0, 12, 6));
        let collision = Collision::new(&setup, &ball).expect("a robot");
        let joints: Joints = std::array::from_fn(|i| {
            let [low, high] = robot.limits_deg[i];
            low + (high - low) * u[i]
        });
        let found = collision.first_contact(&joints);
        let clearance = collision.clearance(&joints);
        let bare = Collision { margin_mm: 0.0, ..collision.clone() };
        prop_assert_eq!(clearance.as_ref().is_some_and(|(mm, _)| *mm <= 5.0), found.is_some(), "{:?}", clearance);
        prop_assert_eq!(clearance.as_ref().is_some_and(|(mm, _)| *mm == 0.0), bare.first_contact(&joints).is_some());
        if let Some((0.0, pair)) = &clearance {
            prop_assert_eq!(Some(pair.clone()), bare.first_contact(&joints));
        }

        let pairs = sampled_pairs(&setup, &ball, &joints, table * size);
        match found {
            None => for (a, b, off) in pairs {
                prop_assert!(off > 5.0 - 1e-9, "{key}: {a:?} and {b:?} are {off} apart");
            },
            Some(c) => {
                let same = |p: &&(BodyId, BodyId, f64)| (p.0 == c.a && p.1 == c.b) || (p.1 == c.a && p.0 == c.b);
                let off = pairs.iter().find(same).expect("a pair that counts").2;
                // Half of the coarsest step, squared against the nearest distance, is below this.
                prop_assert!(off < 5.0 + size / 100.0, "{key}: {c:?}, {off} apart");
            }
        }
    }

    /// No look at ten times as many poses finds a touch that the sweep has missed.
    #[test]
    fn a_sweep_misses_nothing(u in prop::array::uniform6(0.0..1.0f64), turn in prop::array::uniform6(-40.0..40.0f64),
                              place in prop::array::uniform3(-1.0..1.0f64), which in 0..12usize) {
        let mut setup = setup(Robot::shipped().nth(which).expect("one"), Mount::ToolInHand);
        let robot = setup.robot.clone().expect("one");
        setup.cell.base_from_part = at([place[0] * 400.0, place[1] * 400.0, 300.0 + place[2] * 300.0]);
        let ball = part(&solids::sphere(20.0, 12, 6));
        let collision = Collision::new(&setup, &ball).expect("a robot");
        let from: Joints = std::array::from_fn(|i| {
            let [low, high] = robot.limits_deg[i];
            low + (high - low) * u[i]
        });
        let to: Joints = std::array::from_fn(|i| from[i] + turn[i]);
        let straight = |t: f64| -> Joints { std::array::from_fn(|i| from[i] + (to[i] - from[i]) * t) };
        let found = collision.first_contact_between(&from, &to);
        let along = collision.first_contact_along(straight);
        let end = found.as_ref().map_or(1.0, |(t, _)| *t);
        let bare = Collision { margin_mm: 0.0, ..collision.clone() };
        let looks = 10.0 * (collision.travel_mm(&from, &to) / 5.0).ceil();
        let step = 10.0 / looks;
        let touched = (0..=looks as u32).map(|i| f64::from(i) / looks).find(|t| bare.first_contact(&straight(*t)).is_some());
        if let Some(t) = touched {
            prop_assert!(t >= end - step, "touches at {t}, first seen at {end}");
            prop_assert!(found.is_some());
        }
        if let Some((t, contact)) = &found {
            prop_assert_eq!(collision.first_contact(&straight(*t)), Some(contact.clone()));
        }
        if let (Some((a, _)), Some((b, _))) = (&found, &along) {
            prop_assert!((a - b).abs() <= 2.0 * step + 1e-9, "{a} and {b}");
        }
    }
}

#[test]
fn a_path_that_jumps_comes_to_an_end() {
    let cube = part(&solids::cube(20.0));
    let setup = setup("mz04", Mount::PartInHand);
    let collision = Collision::new(&setup, &cube).expect("a robot");
    let jump = |t: f64| if t < 0.37 { FORWARD } else { [170.0, 90.0, 0.0, 0.0, 0.0, 180.0] };
    assert_eq!(collision.first_contact_along(jump), None);
    assert_eq!(collision.first_contact_between(&FORWARD, &FORWARD), None);
}
