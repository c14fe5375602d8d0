//! The beam with cone and head: closed forms, what its own neighbourhood is, thin fins between targets,
//! and an independent checker on thousands of cases.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::beam::{Frustum, Head, Obstacle, Optics, Tool, ToolGeometry};
use clearbeam::cell::{Cell, Frame, Mount};
use clearbeam::document::files::set_up;
use clearbeam::document::{Job, JobError};
use clearbeam::part::Part;
use clearbeam::part::angle::between_deg;
use clearbeam::pose::checker::{Checker, CutCone};
use clearbeam::pose::{BeamInterference, Obstruction, Tilt, ToolBody};
use clearbeam::pose::{Pose, motion};
use clearbeam::sample::{Triangles, solids};
use nalgebra::{Isometry3, Point3, Translation3, Vector3};
use parts::{block, cylinder, part};
use proptest::prelude::*;

const SPOT_MM: f64 = 1.0;
const DEFOCUS_MM: f64 = 20.0;
const MARGIN_MM: f64 = 0.5;

/// A head that is never in the way: what counts is the beam.
fn needle() -> Tool {
    let text = "[[part]]\nfrom_mm = 900\nto_mm = 901\nr0_mm = 1\nr1_mm = 1\n";
    Tool { head: Some(Head::from_toml(text).expect("a stack")), ..Tool::default() }
}

fn body(tool: &Tool) -> ToolGeometry<'_> {
    ToolGeometry::new(tool, &Optics::default(), SPOT_MM, DEFOCUS_MM, MARGIN_MM).expect("a head")
}

fn floor_and(more: &[Triangles]) -> Part {
    let mut all = block([-200.0, -200.0, -10.0], [200.0, 200.0, 0.0]);
    all.extend(more.iter().flatten());
    part(&all)
}

fn lean(deg: f64) -> Vector3<f64> {
    Tilt { lead_deg: 0.0, lean_deg: deg }.axis(&Vector3::z(), &Vector3::y())
}

/// The least angle away from +x at which a beam on the origin is free, by halving.
fn least_lean(part: &Part, body: Option<&ToolGeometry<'_>>) -> f64 {
    // A wide head that leans more comes down on the floor.
    let most = if body.is_some() { 25.0 } else { 60.0 };
    let beam = BeamInterference::with(part, body);
    let free = |deg: f64| beam.is_free(&Point3::origin(), &lean(-deg));
    let (mut low, mut high) = (0.0, most);
    assert!(!free(low) && free(high), "a wall");
    while high - low > 1e-6 {
        let middle = 0.5 * (low + high);
        if free(middle) { high = middle } else { low = middle }
    }
    high
}

#[test]
fn a_wall_beside_the_head_asks_for_the_tilt_of_the_closed_form() {
    // The head's lower edge must keep the margin from the face: r·cos τ − t0·sin τ = x − margin.
    for (x, r) in [(10.0f64, 15.0f64), (4.0, 15.0), (14.0, 14.0), (20.0, 35.0)] {
        let wall = floor_and(&[block([x, -150.0, 0.0], [x + 40.0, 150.0, 90.0])]);
        let t0 = DEFOCUS_MM + 20.0;
        let expected = libm::acos((x - MARGIN_MM) / libm::hypot(r, t0)) - libm::atan2(t0, r);
        let tool = cylinder(r);
        let found = least_lean(&wall, Some(&body(&tool)));
        assert!(
            (found - expected.to_degrees()).abs() < 1e-3,
            "x {x}, r {r}: {found} against {}",
            expected.to_degrees()
        );
    }
}

#[test]
fn a_wall_lower_than_the_head_asks_for_less() {
    // Its upper edge at (x, h), below the head: r0·… the lower edge passes above it, or beside it.
    let (x, r, h) = (10.0f64, 15.0f64, 36.0f64);
    let wall = floor_and(&[block([x, -150.0, 0.0], [x + 40.0, 150.0, h])]);
    let tool = cylinder(r);
    let (b, beam_free) = (body(&tool), 40.0 - h > MARGIN_MM);
    assert!(beam_free && BeamInterference::with(&wall, Some(&b)).is_free(&Point3::origin(), &lean(0.0)));
    // Leaning towards the wall the flat end comes down on its edge: h = t0·cos τ − r·sin τ − margin.
    let beam = BeamInterference::with(&wall, Some(&b));
    let expected = libm::acos((h + MARGIN_MM) / libm::hypot(40.0, r)) - libm::atan2(r, 40.0);
    let towards = |deg: f64| beam.is_free(&Point3::origin(), &lean(deg));
    let deg = expected.to_degrees();
    assert!(deg > 0.0 && towards(deg - 0.01) && !towards(deg + 0.01), "{deg}");
}

#[test]
fn a_wall_beside_the_cone_asks_for_the_tilt_of_the_closed_form() {
    // The widened beam is as wide as the cone of its own neighbourhood at t*, and nowhere wider nearby.
    let slope = (0.05 - 0.5) / 20.0;
    let t = (0.5 + MARGIN_MM) / (libm::tan(15f64.to_radians()) - slope);
    let corner = t / libm::cos(15f64.to_radians());
    let tool = needle();
    for x in [0.1, 0.2, 0.3, 0.6] {
        let wall = floor_and(&[block([x, -150.0, 0.0], [x + 40.0, 150.0, 12.0])]);
        let expected = libm::acos(x / corner).to_degrees() - 75.0;
        let found = least_lean(&wall, Some(&body(&tool)));
        assert!((found - expected).abs() < 1e-3, "x {x}: {found} against {expected}");
    }
    // As a ray: free beside every wall.
    let wall = floor_and(&[block([0.1, -150.0, 0.0], [40.0, 150.0, 12.0])]);
    assert!(BeamInterference::on(&wall).is_free(&Point3::origin(), &lean(0.0)));
}

#[test]
fn an_overhang_asks_for_the_atan_of_the_closed_form() {
    // A ceiling over the spot that begins at −w: the ray must pass its edge, tan τ = w/h.
    for (w, h) in [(3.0, 10.0), (10.0, 10.0), (1.0, 40.0)] {
        let roof = floor_and(&[block([-w, -150.0, h], [60.0, 150.0, h + 0.5])]);
        let found = least_lean(&roof, None);
        // The lower edge of the roof, or its upper one, and 0.02 mm beside it.
        let beside = |z: f64| libm::atan2(w, z) + libm::asin(0.02 / libm::hypot(w, z));
        let expected = beside(h).max(beside(h + 0.5)).to_degrees();
        assert!((found - expected).abs() < 1e-3, "{found} against {expected}");
    }
}

#[test]
fn a_blind_hole_is_reached_as_deep_as_the_cone_allows() {
    // Beyond the focus the beam is 0.05 + 4.95·(t − 20)/200 wide; with the margin it fills the mouth at:
    let deepest = |rho: f64| DEFOCUS_MM + (rho - MARGIN_MM - 0.05) * 200.0 / 4.95;
    let tool = needle();
    for rho in [1.2, 1.6] {
        for (depth, free) in [(deepest(rho) - 0.3, true), (deepest(rho) + 0.3, false)] {
            // 512 sides: the flats are 0.00003 mm nearer than the circle.
            let hole = part(&solids::blind_hole(200.0, rho, depth, 512));
            let body = body(&tool);
            let beam = BeamInterference::with(&hole, Some(&body));
            let (lo, hi) = hole.mesh.bounds();
            let middle = nalgebra::center(&lo, &hi);
            let top = Point3::new(middle.x, middle.y, hi.z);
            let bottom = beam.spot(&(top - Vector3::z() * depth), &Vector3::z(), 0.5);
            assert_eq!(beam.is_free(&bottom, &Vector3::z()), free, "radius {rho}, depth {depth}");
        }
    }
}

#[test]
fn between_fins_the_window_is_as_wide_as_the_closed_form() {
    let p = part(&solids::fin_row(3, 2.0, 4.0, 15.0, 50.0, 7.0));
    let middle = Point3::new(4.0, 25.0, 0.0);
    let half = |body: Option<&ToolGeometry<'_>>| {
        let beam = BeamInterference::with(&p, body);
        let free = |deg: f64| beam.is_free(&middle, &lean(deg));
        let (mut low, mut high) = (0.0, 45.0);
        assert!(free(low) && !free(high));
        while high - low > 1e-6 {
            let deg = 0.5 * (low + high);
            if free(deg) && free(-deg) { low = deg } else { high = deg }
        }
        low
    };
    let gap = 2.0f64;
    let expected = (libm::atan2(gap, 15.0) - libm::asin(0.02 / libm::hypot(gap, 15.0))).to_degrees();
    assert!((half(None) - expected).abs() < 1e-3, "{}", half(None));
    // With the cone: the beam is R(t) wide about t = 15, and its flank passes the fin's edge.
    let tool = needle();
    let at_edge = |deg: f64| {
        let (s, c) = (libm::sin(deg.to_radians()), libm::cos(deg.to_radians()));
        // Of the edge (2, 15) in the beam's frame: along, and beside.
        let (t, beside) = (gap * s + 15.0 * c, gap * c - 15.0 * s);
        // Distance from the flank 0.5 + margin − 0.0225·t, which is a line: the corner lies beside it.
        beside - (1.0 - 0.0225 * t)
    };
    let (mut low, mut high) = (0.0, 7.0);
    while high - low > 1e-9 {
        let deg = 0.5 * (low + high);
        if at_edge(deg) > 0.0 { low = deg } else { high = deg }
    }
    let found = half(Some(&body(&tool)));
    assert!((found - low).abs() < 1e-3, "{found} against {low}");
}

#[test]
fn what_the_spot_stands_on_does_not_count_and_a_wall_beside_it_does() {
    let tool = needle();
    let b = body(&tool);
    let free =
        |p: &Part, at: [f64; 3], a: Vector3<f64>| BeamInterference::with(p, Some(&b)).is_free(&Point3::from(at), &a);
    // A real wall 0.2 mm away, 1 mm high, on a plate and at a plate's rim.
    let wall = |x: f64, h: f64| floor_and(&[block([x, -150.0, 0.0], [x + 5.0, 150.0, h])]);
    assert!(!free(&wall(0.2, 1.0), [0.0; 3], Vector3::z()));
    assert!(!free(&wall(0.2, 60.0), [0.0; 3], Vector3::z()));
    // It stands no higher than the cone of the own neighbourhood there: nothing to tell it from a rounding.
    assert!(free(&wall(0.2, 0.7), [0.0; 3], Vector3::z()));
    assert!(free(&wall(1.1, 30.0), [0.0; 3], Vector3::z()), "farther than spot and margin");
    // The root of a groove of 60°: its bisector is free, its walls' normals are not.
    let groove = part(&solids::v_groove(30.0, 20.0, 10.0, 60.0));
    let (lo, hi) = groove.mesh.bounds();
    let root = |dx: f64| {
        BeamInterference::on(&groove).spot(
            &Point3::new(0.5 * (lo.x + hi.x) + dx, 30.0, hi.z - 20.0),
            &Vector3::z(),
            3.0,
        )
    };
    assert!(free(&groove, root(0.0).into(), Vector3::z()));
    assert!(free(&groove, root(0.3).into(), Vector3::z()));
    let flank = Vector3::new(-libm::cos(30f64.to_radians()), 0.0, libm::sin(30f64.to_radians()));
    assert!(!free(&groove, root(0.3).into(), flank));
    // The bottom of a fillet wider than spot and margin: the lower half of a torus from within.
    let radius = 1.1;
    let ring = part(&solids::torus(20.0, radius, 256, 128));
    let inside: Triangles = (0..ring.mesh.facets.len())
        .map(|f| ring.mesh.corners(f).map(|c| [c.x, c.y, c.z]))
        .filter(|t| t.iter().all(|c| c[2] <= 1e-6))
        .collect();
    let trough = part(&inside);
    let bottom = BeamInterference::on(&trough).spot(&Point3::new(20.0, 0.0, -radius), &Vector3::z(), 0.1);
    assert!(free(&trough, bottom.into(), Vector3::z()));
}

/// Six moves of 5 mm along x with free ends, something thin in the way of the third.
fn refutes_the_third_move_alone(beam: &BeamInterference<'_>) {
    let pose = |x: f64| Pose { p: Point3::new(x, 0.0, 0.0), a: Vector3::z() };
    for k in 0..6 {
        let (from, to) = (5.0 * f64::from(k), 5.0 * f64::from(k + 1));
        assert!([from, to].iter().all(|x| beam.is_free(&pose(*x).p, &pose(*x).a)), "targets are free");
        assert_eq!(motion::is_free(beam, &pose(from), &pose(to), 0.0), k != 2, "{from} to {to}");
    }
}

#[test]
fn a_thin_fin_between_two_free_targets_refutes_that_interval_alone() {
    let tool = needle();
    let b = body(&tool);
    let p = floor_and(&[block([12.4, -4.0, 0.0], [12.6, 4.0, 8.0])]);
    refutes_the_third_move_alone(&BeamInterference::with(&p, Some(&b)));
}

#[test]
fn a_fin_that_only_the_head_touches_refutes_that_interval_alone() {
    let tool = cylinder(15.0);
    let b = body(&tool);
    // Beside the head's widest place, 0.4 mm from it as it passes; the beam is far away.
    let fin = block([12.4, 15.4, 41.0], [12.6, 30.0, 60.0]);
    let p = floor_and(&[fin]);
    let beam = BeamInterference::with(&p, Some(&b));
    refutes_the_third_move_alone(&beam);
    let hit = beam.blocker(&Point3::new(12.5, 0.0, 0.0), &Vector3::z()).expect("in the way");
    assert_eq!(hit.tool_body, ToolBody::Head);
    assert!(
        matches!(hit.obstruction, Obstruction::Facet(f) if f >= 12),
        "the fin's facets come behind the floor's: {hit:?}"
    );
}

#[test]
fn clearance_is_the_distance_to_the_nearest_thing() {
    let tool = cylinder(15.0);
    let b = body(&tool);
    for x in [16.0, 18.5, 40.0] {
        let p = floor_and(&[block([x, -150.0, 0.0], [x + 5.0, 150.0, 90.0])]);
        let clearance =
            BeamInterference::with(&p, Some(&b)).clearance_mm(&Point3::origin(), &Vector3::z()).expect("a head");
        assert!((clearance - (x - 15.0).min(40.0)).abs() < 1e-4, "{x}: {clearance}");
    }
    // Where the beam is nearer than the head: 0.5 − 0.0225·t beside a wall 3 mm high.
    let p = floor_and(&[block([2.0, -150.0, 0.0], [5.0, 150.0, 3.0])]);
    let clearance =
        BeamInterference::with(&p, Some(&b)).clearance_mm(&Point3::origin(), &Vector3::z()).expect("a head");
    // It would touch the wall's edge where the cone of the own neighbourhood reaches it: never.
    assert!(clearance > 30.0, "{clearance}");
    let p = floor_and(&[block([2.0, -150.0, 0.0], [5.0, 150.0, 20.0])]);
    let clearance =
        BeamInterference::with(&p, Some(&b)).clearance_mm(&Point3::origin(), &Vector3::z()).expect("a head");
    // At t = 2/tan 15° the cone is 2 mm wide, and the beam there 0.5 − 0.0225·t.
    let t = 2.0 / libm::tan(15f64.to_radians());
    assert!((clearance - (2.0 - (0.5 - 0.0225 * t))).abs() < 0.01, "{clearance}");
    assert_eq!(BeamInterference::on(&p).clearance_mm(&Point3::origin(), &Vector3::z()), None);
}

#[test]
fn a_clamp_is_in_the_way_like_the_part() {
    let dir = tempfile::tempdir().expect("a folder");
    let bytes = clearbeam::sample::stl_bytes(&block([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]));
    std::fs::write(dir.path().join("clamp.stl"), bytes).expect("written");
    let mut clamp = Obstacle::named("clamp.stl".into());
    clamp.position_mm = [30.0, 0.0, 50.0];
    clamp.load(Some(dir.path())).expect("an STL");
    let plate = floor_and(&[]);
    let at = |x: f64| (Point3::new(x, 0.0, 0.0), Vector3::z());
    // The ray alone.
    let tool = Tool { clamps: vec![clamp.clone()], ..Tool::default() };
    let b = ToolGeometry::new(&tool, &Optics::default(), SPOT_MM, DEFOCUS_MM, MARGIN_MM).expect("a clamp");
    let beam = BeamInterference::with(&plate, Some(&b));
    assert_eq!(beam.blocker(&at(30.0).0, &at(30.0).1).map(|h| h.obstruction), Some(Obstruction::Clamp(0)));
    assert!(beam.is_free(&at(31.1).0, &at(31.1).1) && !beam.is_free(&at(30.9).0, &at(30.9).1));
    assert!(!motion::is_free(&beam, &pose(0.0), &pose(60.0), 0.0), "on the way");
    assert_eq!(beam.clearance_mm(&at(0.0).0, &at(0.0).1), None);
    // And the head.
    let tool = Tool { clamps: vec![clamp], ..cylinder(15.0) };
    let b = body(&tool);
    let beam = BeamInterference::with(&plate, Some(&b));
    assert!(beam.is_free(&at(46.6).0, &at(46.6).1) && !beam.is_free(&at(46.4).0, &at(46.4).1));
    let hit = beam.blocker(&at(46.4).0, &at(46.4).1).expect("in the way");
    assert_eq!((hit.tool_body, hit.obstruction), (ToolBody::Head, Obstruction::Clamp(0)));

    fn pose(x: f64) -> Pose {
        Pose { p: Point3::new(x, 0.0, 0.0), a: Vector3::z() }
    }
}

#[test]
fn what_stands_in_the_cell_is_in_the_way_of_a_carried_head() {
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(dir.path().join("post.stl"), clearbeam::sample::stl_bytes(&block([-2.0; 3], [2.0; 3])))
        .expect("written");
    let mut post = Obstacle::named("post.stl".into());
    post.position_mm = [410.0, 25.0, 80.0];
    post.load(Some(dir.path())).expect("an STL");
    let mut cell = Cell::shipped("mz04").expect("shipped");
    cell.bodies.obstacles.push(post);
    cell.base_from_part = Frame::new([400.0, 0.0, 50.0], [90.0, 0.0, 0.0]);
    for (mount, stands) in [(Mount::ToolInHand, 1), (Mount::PartInHand, 0)] {
        let mut job = Job::default();
        job.cell.mount = Some(mount);
        let setup = set_up(&job, None, cell.clone(), Tool::default()).expect("stands");
        assert_eq!(setup.tool.clamps.len(), stands);
        // In the part's frame: (10, 25, 30) in the base, turned back by a quarter.
        for c in &setup.tool.clamps {
            assert!((c.at().translation.vector - Vector3::new(25.0, -10.0, 30.0)).norm() < 1e-9);
            let body = clearbeam::planning::surface_plan::tool_geometry(&job, &setup);
            let plate = floor_and(&[]);
            let hit =
                BeamInterference::with(&plate, body.as_ref()).blocker(&Point3::new(25.0, -10.0, 0.0), &Vector3::z());
            assert_eq!(hit.map(|b| b.obstruction), Some(Obstruction::Clamp(0)));
        }
    }
}

#[test]
fn a_head_of_facets_counts_as_what_it_sweeps() {
    let dir = tempfile::tempdir().expect("a folder");
    // A box 30 by 30, off the axis: it sweeps a cylinder of the distance to its far corner.
    let file = dir.path().join("head.stl");
    std::fs::write(&file, clearbeam::sample::stl_bytes(&block([-5.0, -5.0, 20.0], [25.0, 25.0, 120.0])))
        .expect("written");
    let solid = Tool { head: Some(Head::load(&file).expect("an STL")), ..Tool::default() };
    let round = cylinder(libm::hypot(25.0, 25.0));
    let (one, two) = (body(&solid), body(&round));
    for x in [30.0, 35.0, 35.8, 35.9, 36.0, 50.0] {
        let p = floor_and(&[block([x, -150.0, 0.0], [x + 5.0, 150.0, 90.0])]);
        let free = |b| BeamInterference::with(&p, Some(b)).is_free(&Point3::origin(), &Vector3::z());
        assert_eq!(free(&one), free(&two), "{x}");
    }
}

fn cones(frusta: &[Frustum]) -> Vec<CutCone> {
    frusta.iter().map(|f| [f.t0_mm, f.t1_mm, f.r0_mm, f.r1_mm]).collect()
}

/// A floor with boxes on it, and the point in the middle of it.
fn cluttered(boxes: &[[f64; 5]]) -> Triangles {
    let mut all = block([-60.0, -60.0, -5.0], [60.0, 60.0, 0.0]);
    for [x, y, w, d, h] in boxes {
        all.extend(block([*x, *y, -1.0], [x + w, y + d, *h]));
    }
    all
}

fn on_floor(boxes: &[[f64; 5]], x: f64, y: f64) -> bool {
    boxes
        .iter()
        .all(|[bx, by, w, d, _]| !(bx - 0.05..=bx + w + 0.05).contains(&x) || !(by - 0.05..=by + d + 0.05).contains(&y))
}

fn clutter() -> impl Strategy<Value = Vec<[f64; 5]>> {
    prop::collection::vec((-20.0..20.0f64, -20.0..20.0f64, 0.2..8.0f64, 0.2..8.0f64, 0.3..45.0f64), 1..5)
        .prop_map(|v| v.into_iter().map(|(x, y, w, d, h)| [x, y, w, d, h]).collect())
}

/// A head with a nozzle near the spot, so that both limbs matter.
fn nozzle() -> Tool {
    let text = "[[part]]\nfrom_mm = -8\nto_mm = 10\nr0_mm = 3\nr1_mm = 9\n[[part]]\nfrom_mm = 10\nto_mm = 60\nr0_mm = 14\nr1_mm = 14\n";
    Tool { head: Some(Head::from_toml(text).expect("a stack")), ..Tool::default() }
}

/// The checker looks for things this near.
const NEAR_MM: f64 = 1.0;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// What is free keeps its distances by the checker's reckoning, and what is blocked by cone or head
    /// does not.
    #[test]
    fn the_checker_agrees_on_poses(boxes in clutter(), x in -20.0..20.0f64, y in -20.0..20.0f64,
                                   lead in -40.0..40.0f64, side in -40.0..40.0f64) {
        prop_assume!(on_floor(&boxes, x, y));
        let triangles = cluttered(&boxes);
        let p = part(&triangles);
        let (tool, at) = (nozzle(), Point3::new(x, y, 0.0));
        let b = body(&tool);
        let a = Tilt { lead_deg: lead, lean_deg: side }.axis(&Vector3::z(), &Vector3::x());
        let check = Checker::new((0..p.mesh.facets.len()).map(|f| p.mesh.corners(f)));
        let least = |frusta: &[Frustum]| {
            cones(frusta).iter().map(|c| check.cone_distance(&at, &a, c, NEAR_MM)).fold(NEAR_MM, f64::min)
        };
        let (head, cone) = (least(&b.head), least(&b.beam));
        let beam = BeamInterference::with(&p, Some(&b));
        if beam.is_free(&at, &a) {
            prop_assert!(head >= MARGIN_MM - 1e-5, "head {head}");
            prop_assert!(cone > 0.0, "cone {cone}");
            prop_assert!(check.hit(&at, &a, 0.03).is_none());
            let clearance = beam.clearance_mm(&at, &a).expect("a head");
            prop_assert!(clearance >= MARGIN_MM && (head >= NEAR_MM || clearance <= head + 1e-5), "{clearance} against {head}");
        } else if beam.body_blocker(&at, &a).is_some() {
            prop_assert!(head <= MARGIN_MM + 1e-5 || cone <= 1e-5, "head {head}, cone {cone}");
        }
    }

    /// A part that is moved and turned gives the same answers.
    #[test]
    fn a_moved_part_gives_the_same(boxes in clutter(), x in -20.0..20.0f64, y in -20.0..20.0f64,
                                   lead in -40.0..40.0f64, turn in prop::array::uniform3(-3.0..3.0f64)) {
        prop_assume!(on_floor(&boxes, x, y));
        let p = part(&cluttered(&boxes));
        let motion = Isometry3::from_parts(Translation3::new(7.0, -3.0, 11.0), Isometry3::rotation(Vector3::from(turn)).rotation);
        let moved: Triangles = (0..p.mesh.facets.len()).map(|f| p.mesh.corners(f).map(|c| (motion * c).into())).collect();
        let q = part(&moved);
        let tool = nozzle();
        let b = body(&tool);
        let at = Point3::new(x, y, 0.0);
        let a = Tilt { lead_deg: lead, lean_deg: 5.0 }.axis(&Vector3::z(), &Vector3::x());
        let (one, two) = (BeamInterference::with(&p, Some(&b)), BeamInterference::with(&q, Some(&b)));
        let here = one.clearance_mm(&at, &a).expect("a head");
        let there = two.clearance_mm(&(motion * at), &(motion * a)).expect("a head");
        prop_assume!(here > 0.02 && there > 0.02);
        prop_assert!((here - there).abs() < 0.01, "{here} against {there}");
        prop_assert!(between_deg(&a, &Vector3::z()) < 41.0);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(120))]

    /// A motion that is proven free is so at every pose that the checker looks at.
    #[test]
    fn the_checker_finds_nothing_on_proven_motions(boxes in clutter(), ends in prop::array::uniform4(-20.0..20.0f64),
                                                   tilts in prop::array::uniform4(-35.0..35.0f64), near in 0.02..1.0f64) {
        let (x0, y0) = (ends[0], ends[1]);
        let (x1, y1) = (x0 + (ends[2] - x0) * near * 0.3, y0 + (ends[3] - y0) * near * 0.3);
        let triangles = cluttered(&boxes);
        let p = part(&triangles);
        let tool = nozzle();
        let b = body(&tool);
        let pose = |x: f64, y: f64, t: [f64; 2]| Pose {
            p: Point3::new(x, y, 0.0),
            a: Tilt { lead_deg: t[0], lean_deg: t[1] }.axis(&Vector3::z(), &Vector3::x()),
        };
        let from = pose(x0, y0, [tilts[0], tilts[1]]);
        let to = pose(x1, y1, [tilts[0] + (tilts[2] - tilts[0]) * near, tilts[1] + (tilts[3] - tilts[1]) * near]);
        prop_assume!(on_floor(&boxes, x0, y0) && on_floor(&boxes, x1, y1));
        let beam = BeamInterference::with(&p, Some(&b));
        prop_assume!(beam.is_free(&from.p, &from.a) && beam.is_free(&to.p, &to.a));
        let proven = motion::is_free(&beam, &from, &to, 0.0);
        let check = Checker::new((0..p.mesh.facets.len()).map(|f| p.mesh.corners(f)));
        let narrow = b.eased(b.short_mm, 0);
        let mut worst = f64::INFINITY;
        for k in 0..=12 {
            let q = from.midway(&to, f64::from(k) / 12.0);
            if !on_floor(&boxes, q.p.x, q.p.y) {
                worst = -1.0;
                continue;
            }
            for c in cones(&b.head) {
                worst = worst.min(check.cone_distance(&q.p, &q.a, &c, NEAR_MM) - MARGIN_MM);
            }
            for c in cones(&narrow.beam) {
                worst = worst.min(if check.cone_distance(&q.p, &q.a, &c, NEAR_MM) > 0.0 { 1.0 } else { -1.0 });
            }
        }
        // A hit that is well inside is found; a proof allows of the margin what it says.
        prop_assert!(!proven || worst >= -b.short_mm - 1e-5, "proven, {worst}");
    }
}

#[test]
fn what_stands_in_a_beam_that_stands_still_is_refused() {
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(dir.path().join("post.stl"), clearbeam::sample::stl_bytes(&block([-2.0; 3], [2.0; 3])))
        .expect("written");
    let job = Job::default();
    let stands = |up_mm: f64, beside_mm: f64, tool: Tool| {
        let mut cell = Cell::shipped("mz04").expect("shipped");
        let laser = cell.base_from_laser.isometry();
        let mut post = Obstacle::named("post.stl".into());
        post.position_mm = (laser * Point3::new(beside_mm, 0.0, up_mm)).coords.into();
        post.load(Some(dir.path())).expect("an STL");
        cell.bodies.obstacles.push(post);
        set_up(&job, None, cell, tool).map(|_| ()).map_err(|e| match e {
            JobError::LaserBlocked { obstacle, by, .. } => (obstacle, by),
            other => panic!("{other}"),
        })
    };
    assert_eq!(stands(50.0, 0.0, Tool::default()), Err(("post.stl".into(), ToolBody::Beam)));
    assert_eq!(stands(50.0, 12.0, Tool::default()), Ok(()));
    // The head's radius and margin reach to 10.5 mm, the post from 8.6 mm (its far corner 2√2 nearer).
    assert_eq!(stands(60.0, 12.0, cylinder(10.0)), Err(("post.stl".into(), ToolBody::Head)));
    assert_eq!(stands(60.0, 14.0, cylinder(10.0)), Ok(()));
    assert_eq!(stands(-60.0, 0.0, cylinder(10.0)), Ok(()), "below the spot nothing counts");
}

/// A slot 30 mm wide whose walls are 42 mm high: the head's lower edge, 40 mm above the spot and 20 mm wide, is 2 mm
/// too low.
#[test]
fn within_the_standoff_window_the_head_is_drawn_back_over_walls() {
    let walls = [[-30.0, -15.0], [15.0, 30.0]].map(|[x0, x1]| block([x0, -30.0, 0.0], [x1, 30.0, 42.0]));
    let mut job = Job::default();
    job.layers.spacing_mm = 4.0;
    job.layers.direction = "x".parse().expect("an axis");
    job.path.max_tilt_deg = 5.0;
    let mut setup = parts::setup();
    setup.tool = cylinder(20.0);
    // Just long enough for the head to stand beyond the walls' ends.
    let all = [&block([-40.0, -80.0, -10.0], [40.0, 80.0, 0.0])[..], &walls[0], &walls[1]].concat();
    let planned = |standoff_mm: f64| {
        let part = part(&all);
        let surfaces = clearbeam::document::segmented(&part, &job);
        let floor = parts::surface_at(&part, &surfaces, [0.0, 0.0, 0.0]);
        let mut job = parts::on(job.clone(), &[floor]);
        job.path.standoff_mm = standoff_mm;
        parts::planned_in(part, job, &setup)
    };
    // Lines between the walls, and between their ends: those are the ones that the head stands over.
    let between = |p: &parts::Planned| {
        let of = |t: &clearbeam::pose::Target| t.p.x.abs() < 14.0 && t.p.y.abs() < 20.0;
        let lines = p.plan.passes.iter().filter(|l| l.targets.iter().any(of));
        lines.cloned().collect::<Vec<_>>()
    };
    let without = planned(0.0);
    assert!(
        between(&without).iter().all(|l| l.settings.defocus_mm == DEFOCUS_MM && l.length_mm(|_, to| !to.laser) > 50.0)
    );
    let with = planned(8.0);
    let lifted = between(&with);
    assert!(!lifted.is_empty());
    for line in &lifted {
        // Half of the window is enough, and the spot is as wide as the optics make it there.
        assert_eq!(line.settings.defocus_mm, DEFOCUS_MM + 4.0);
        let optics = Optics::default();
        let wider = optics.spot_mm(24.0) / optics.spot_mm(20.0);
        assert!((line.settings.spot_mm - wider * SPOT_MM).abs() < 1e-12);
        assert_eq!(line.length_mm(|_, to| !to.laser), 0.0);
    }
    let proof = with.plan.proof.as_ref().expect("swept");
    assert!(proof.lit_moves > 0 && proof.refuted.is_empty() && proof.margin_mm > 0.2);
    let files = with.files_in(&setup);
    let csv = files.iter().find(|f| f.name == "path.csv").map(|f| String::from_utf8_lossy(&f.bytes).into_owned());
    for row in csv.expect("written").lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().expect("a number");
        let pass = &with.plan.passes[number(0) as usize];
        let target = &pass.targets[number(1) as usize];
        let focus = target.focus(pass.settings.defocus_mm);
        for k in 0..3 {
            assert!((number(17 + k) - focus[k]).abs() < 1e-6);
        }
        assert!((number(21) - target.clearance_mm.expect("a head")).abs() < 1e-6, "{row}");
    }
}
