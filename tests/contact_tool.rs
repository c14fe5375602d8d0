//! A grinding disc on skins of closed form, beside walls and clamps, and as a program.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::beam::{ContactTool, Grinding, Obstacle, Optics, ProcessSettings, Tool, ToolGeometry};
use clearbeam::cell::motion::{Refusal, RefusalReason};
use clearbeam::cell::{Mount, Robot, Setup};
use clearbeam::document::segmented;
use clearbeam::part::Part;
use clearbeam::planning::verify::{DifferenceKind, Verdict, check};
use clearbeam::pose::checker::KeptByContact;
use clearbeam::pose::{BeamInterference, Blocker, Obstruction, Target, TargetState, ToolBody};
use clearbeam::program::{ProgramFile, Step, dialects};
use nalgebra::{Point3, Vector3};
use parts::{Planned, block, sheet};
use proptest::prelude::*;

const GOUGE_MM: f64 = 0.05;
const MARGIN_MM: f64 = 0.5;

fn grinding(radius_mm: f64, edge_mm: f64, lead_deg: f64) -> Grinding {
    let text = format!(
        "kind = \"disc\"\nradius_mm = {radius_mm}\nedge_mm = {edge_mm}\nthickness_mm = {}\ncontact = \"rim\"\n\
         [[part]]\nfrom_mm = {}\nto_mm = 60\nr0_mm = 6\nr1_mm = 6\n",
        2.5 * edge_mm,
        3.0 * edge_mm
    );
    let tool = ContactTool::from_toml(&text).expect("a disc");
    Grinding { tool, lead_deg, arc_mm: 0.0, force_n: 0.0, gouge_mm: GOUGE_MM }
}

fn tool(grinding: Grinding) -> Tool {
    Tool { contact: Some(grinding), ..Tool::default() }
}

fn geometry(tool: &Tool) -> ToolGeometry<'_> {
    let place = tool.contact.as_ref().expect("a contact tool").place();
    ToolGeometry::new(tool, &Optics::default(), 1.0, place.defocus_mm, MARGIN_MM).expect("a tool")
}

/// What a tool hits that touches in `p`, the surface's normal along z, and goes along `t`.
fn hit(part: &Part, tool: &Tool, p: [f64; 3], t: Vector3<f64>) -> Option<Blocker> {
    let geometry = geometry(tool);
    let place = tool.contact.as_ref().expect("a contact tool").place();
    let (p, n) = (Point3::from(p), Vector3::z());
    let a = place.axis(&n, &t);
    let foot = place.foot(&p, &n, &a);
    let beam = BeamInterference::with(part, Some(&geometry));
    let blocker = beam.blocker(&foot, &a);
    assert_eq!(beam.is_free(&foot, &a), blocker.is_none());
    // The second opinion looks at disc or belt alone.
    let contact = geometry.contact.as_ref().expect("it grinds");
    let kept = KeptByContact {
        cones: contact.core.iter().map(|f| [f.t0_mm, f.t1_mm, f.r0_mm, f.r1_mm]).collect(),
        skin_mm: contact.skin_mm,
        wall_mm: contact.round_mm + geometry.margin_mm,
    };
    let is_abrasive = |b: &Blocker| matches!(b.tool_body, ToolBody::Abrasive | ToolBody::Gouge);
    if blocker.is_none_or(|b| is_abrasive(&b) && b.obstruction.facet().is_some()) {
        assert_eq!(parts::checker(part).touched(&foot, &a, &kept).is_some(), blocker.is_some(), "{blocker:?}");
    }
    blocker
}

/// A trough (or, for a negative radius, a ridge) along y whose bottom (or top) lies along the y axis.
fn trough(radius_mm: f64, half_width_mm: f64) -> Part {
    let count = 80;
    let at = |k: i32| {
        let x = half_width_mm * f64::from(k) / f64::from(count);
        let rise = radius_mm.abs() - (radius_mm * radius_mm - x * x).sqrt();
        [x, rise * radius_mm.signum()]
    };
    let profile: Vec<[f64; 2]> = (-count..=count).map(at).collect();
    parts::part(&sheet(&profile, 120.0))
}

/// How deep the rim of a disc that touches in the bottom of a trough reaches into it: its ring point by point, with the
/// ball of its edge about each.
fn depth_mm(g: &Grinding, r: f64, edge: f64, trough_mm: f64, half_width_mm: f64) -> f64 {
    let tau = g.lead_deg.to_radians();
    let ring = r - edge;
    (0..20_000)
        .map(|k| f64::from(k) / 20_000.0 * std::f64::consts::TAU)
        .map(|angle| {
            // Seen along the trough: an ellipse whose lowest point is the contact's.
            let (x, z) = (ring * libm::sin(angle), edge + ring * libm::sin(tau) * (1.0 - libm::cos(angle)));
            let from_axis = libm::hypot(x, trough_mm - z);
            if x.abs() < half_width_mm { from_axis + edge - trough_mm } else { f64::NEG_INFINITY }
        })
        .fold(f64::NEG_INFINITY, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]
    /// It touches a trough beside its contact just where the trough is narrower than (r − ρ) / sin τ + ρ, and is found
    /// to do so just where it goes deeper than it may.
    #[test]
    fn it_gouges_where_the_skin_is_narrower_than_its_effective_radius(
        r in 15.0..60.0f64, edge in 1.0..4.0f64, lead in 5.0..28.0f64, share in 0.55..1.6f64
    ) {
        let g = grinding(r, edge, lead);
        let fits_mm = g.effective_radius_mm().expect("a rim");
        let trough_mm = share * fits_mm;
        let half_width_mm = 0.95 * r.min(trough_mm);
        let depth_mm = depth_mm(&g, r, edge, trough_mm, half_width_mm);
        prop_assume!((share - 1.0).abs() > 1e-3 && (depth_mm - GOUGE_MM).abs() > 0.01);
        prop_assert_eq!(depth_mm > 1e-9, trough_mm < fits_mm, "{}", depth_mm);
        let part = trough(trough_mm, half_width_mm);
        let found = hit(&part, &tool(g), [0.0, 60.0, 0.0], Vector3::y());
        prop_assert_eq!(found.is_some(), depth_mm > GOUGE_MM, "{:?} {}", found, depth_mm);
        prop_assert!(found.is_none_or(|b| b.tool_body == ToolBody::Gouge));
    }

    /// A plane, a ridge, and a ball's worth of leads: touching is allowed, and a hair deeper is not.
    #[test]
    fn it_touches_a_plane_and_a_ridge(
        r in 15.0..60.0f64, edge in 1.0..4.0f64, lead in 3.0..28.0f64, back in any::<bool>(), ridge in 20.0..500.0f64
    ) {
        let t = tool(grinding(r, edge, if back { -lead } else { lead }));
        let plane = parts::part(&block([-100.0, -100.0, -10.0], [100.0, 100.0, 0.0]));
        for part in [&plane, &trough(-ridge, 15.0)] {
            let y = if std::ptr::eq(part, &plane) { 0.0 } else { 60.0 };
            prop_assert_eq!(hit(part, &t, [0.0, y, 0.0], Vector3::y()), None);
            prop_assert_eq!(hit(part, &t, [0.0, y, 0.9 * -GOUGE_MM], Vector3::y()), None);
            let deeper = hit(part, &t, [0.0, y, 1.1 * -GOUGE_MM], Vector3::y());
            prop_assert!(deeper.is_some_and(|b| b.tool_body == ToolBody::Gouge), "{deeper:?}");
        }
    }

    /// A wall beside the line is as near as the margin where the disc's own side is. Its side swings out by r − √…: at
    /// the height of the ring the disc is widest, at r beside its axis. A part that may lie off by some slack keeps its walls
    /// so much farther away, and its skin no farther from what stands over it.
    #[test]
    fn a_wall_beside_the_line_keeps_the_margin(
        r in 15.0..40.0f64,
        edge in 1.0..4.0f64,
        lead in 3.0..28.0f64,
        gap in -0.4..0.4f64,
        slack_mm in prop_oneof![Just(0.0), 0.0..20.0f64],
    ) {
        prop_assume!(gap.abs() > 0.02);
        let t = Tool { slack_mm, ..tool(grinding(r, edge, lead)) };
        let x = r + MARGIN_MM + slack_mm + gap;
        let mut all = block([-100.0, -100.0, -10.0], [100.0, 100.0, 0.0]);
        all.extend(block([x, -90.0, 0.0], [x + 5.0, 90.0, 60.0]));
        let found = hit(&parts::part(&all), &t, [0.0, 0.0, 0.0], Vector3::y());
        prop_assert_eq!(found.is_some(), gap < 0.0, "{:?}", found);
        prop_assert!(found.is_none_or(|b| b.tool_body == ToolBody::Abrasive));
    }
}

#[test]
fn it_may_stick_out_over_a_rim_and_not_into_a_clamp() {
    let t = tool(grinding(20.0, 2.0, 15.0));
    let plate = parts::part(&block([-60.0, -30.0, -10.0], [60.0, 30.0, 0.0]));
    // Along a rim, right at it, and at both ends of the plate.
    for (p, along) in [
        ([0.0, 30.0, 0.0], Vector3::x()),
        ([0.0, 29.5, 0.0], Vector3::x()),
        ([60.0, 0.0, 0.0], Vector3::x()),
        ([-60.0, 0.0, 0.0], Vector3::x()),
        ([-59.0, -29.0, 0.0], Vector3::y()),
    ] {
        assert_eq!(hit(&plate, &t, p, along), None, "{p:?}");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("clamp.stl");
    std::fs::write(&file, clearbeam::sample::stl_bytes(&block([-5.0, -5.0, -5.0], [5.0, 5.0, 5.0]))).expect("writes");
    let beside = |x: f64| {
        let mut clamp = Obstacle::of_file("clamp.stl".into(), &file);
        clamp.position_mm = [x, -17.0, 5.0];
        clamp.load(Some(folder.path())).expect("reads");
        let t = Tool { clamps: vec![clamp], ..t.clone() };
        hit(&plate, &t, [0.0, 0.0, 0.0], Vector3::y())
    };
    // The clamp begins 5 mm before its middle, and stands where the disc is widest, r beside the line.
    assert_eq!(beside(25.0 + MARGIN_MM + 0.05), None);
    let found = beside(25.0 + MARGIN_MM - 0.05).expect("too near");
    assert_eq!((found.tool_body, found.obstruction), (ToolBody::Abrasive, Obstruction::Clamp(0)));
}

#[test]
fn what_is_behind_the_disc_is_a_head() {
    let mut g = grinding(20.0, 2.0, 15.0);
    // Its leading edge sinks by 60 sin 15° = 15.5 mm, from 12.4 mm above the plate.
    g.tool.stack[0].r0_mm = 60.0;
    g.tool.stack[0].r1_mm = 60.0;
    let plate = parts::part(&block([-60.0, -60.0, -10.0], [60.0, 60.0, 0.0]));
    let found = hit(&plate, &tool(g), [0.0, 0.0, 0.0], Vector3::y()).expect("the guard is too wide");
    assert_eq!(found.tool_body, ToolBody::Head);
}

/// A plate along x with lines along it, ground by a disc.
fn ground(more: &[clearbeam::sample::Triangles], change: impl FnOnce(&mut Grinding), setup: &mut Setup) -> Planned {
    let mut all = block([-40.0, -12.0, -10.0], [40.0, 12.0, 0.0]);
    all.extend(more.iter().flatten());
    let part = parts::part(&all);
    let mut job = parts::job("y", 6.0);
    job.layers.inset_mm = 2.0;
    job.beam.speed_mm_s = 20.0;
    let mut g = grinding(20.0, 2.0, 15.0);
    (g.arc_mm, g.force_n, g.gouge_mm) = (8.0, 25.0, 0.05 + job.path.chord_error_mm);
    change(&mut g);
    setup.tool = tool(g);
    let surfaces = segmented(&part, &job);
    let top = parts::surface_at(&part, &surfaces, [-35.0, 0.0, 0.0]);
    parts::planned_in(part, parts::on(job, &[top]), setup)
}

fn verified(p: &Planned, setup: &Setup, files: &[ProgramFile]) -> Verdict {
    let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    check(&p.part, &p.plan, setup, &p.job, &files[0], &open, true).expect("reads").1
}

/// The program's files in a dialect.
fn program(p: &mut Planned, setup: &Setup, dialect: &str) -> Vec<ProgramFile> {
    p.job.cell.dialect = dialect.into();
    let own = p.files_in(setup);
    let names = dialects::known(dialect).expect("known").file_names(setup, clearbeam::program::Variant::WHOLE);
    let of_program = own.iter().filter(|f| names.contains(&f.name));
    of_program
        .map(|f| ProgramFile { name: f.name.clone(), text: String::from_utf8(f.bytes.clone()).expect("text") })
        .collect()
}

#[test]
fn a_plate_is_ground_and_its_program_read_back() {
    let mut setup = parts::setup();
    let mut p = ground(&[], |_| {}, &mut setup);
    assert!(p.plan.passes.len() >= 3, "{}", p.plan.passes.len());
    assert!(p.targets().all(|t| t.state == TargetState::Free));
    let place = setup.tool.contact.as_ref().expect("it grinds").place();
    for t in p.targets() {
        let tcp = t.p + t.a * place.defocus_mm - t.o * place.behind_mm;
        assert!((t.focus(place.defocus_mm) - tcp).norm() < 1e-9);
        assert!((t.tilt_deg() - 15.0).abs() < 1e-9);
        assert!(t.a.dot(&t.tangent()) > 0.0, "it leans forward");
    }
    // Each piece is come to and left by an arc: nine moves before the tool runs, and nine after it.
    let list = &p.plan.steps.list;
    let go = |i: usize| if let Some(Step::Go(go)) = list.get(i) { Some(go) } else { None };
    let mut arcs = 0;
    for (i, _) in list.iter().enumerate().filter(|(_, s)| **s == Step::Laser(false)) {
        let end = go(i - 1).expect("it came from somewhere").to;
        for k in 1..=9 {
            let to = go(i + k).expect("an arc").to;
            let angle = (10.0 * k as f64).to_radians();
            let told = [8.0 * libm::sin(angle), 8.0 * (1.0 - libm::cos(angle))];
            let way = to.x - end.x;
            assert!((libm::hypot(way.x, way.y) - told[0]).abs() < 1e-9 && (way.z - told[1]).abs() < 1e-9, "{way}");
            assert!((to.a - end.a).norm() < 1e-12);
        }
        arcs += 1;
    }
    assert_eq!(arcs, p.plan.passes.len());
    assert!(p.plan.steps.shortfalls.is_empty(), "{:?}", p.plan.steps.shortfalls);
    for dialect in ["abb", "ur", "kuka", "csv"] {
        let files = program(&mut p, &setup, dialect);
        let text: String = files.iter().map(|f| f.text.to_lowercase()).collect();
        assert!(!text.contains("power") && !text.contains("spot "), "{dialect} speaks of a laser");
        assert!(text.contains("grinding disc, force 25 n, speed 20 mm/s"), "{dialect}");
        let verdict = verified(&p, &setup, &files);
        assert!(verdict.findings.is_empty(), "{dialect}: {:?}", verdict.findings);
        assert!(verdict.lit_moves > 0 && verdict.proof.proven == verdict.lit_moves);
        match dialect {
            "abb" => assert!(text.contains("fcrefforce \\fz:=25.00; fcrefstart;") && text.contains("fcrefstop;")),
            "ur" => assert!(text.contains("[0, 0, 25.00, 0, 0, 0]") && text.contains("end_force_mode()")),
            "kuka" => assert!(text.contains("; press with 25 n") && text.contains("; press no more")),
            _ => assert!(text.contains("force,")),
        }
    }
}

#[test]
fn a_changed_force_is_found() {
    let mut setup = parts::setup();
    let mut p = ground(&[], |_| {}, &mut setup);
    for (dialect, was, is) in
        [("abb", "Fz:=25.00", "Fz:=52.00"), ("ur", "0, 25.00,", "0, 52.00,"), ("csv", "25.0", "52.0")]
    {
        let mut files = program(&mut p, &setup, dialect);
        let changed = match dialect {
            "csv" => files[0]
                .text
                .lines()
                .map(|l| if l.contains(",force,") { l.replacen(was, is, 1) } else { l.into() })
                .collect::<Vec<_>>()
                .join("\n"),
            _ => files[0].text.replacen(was, is, 1),
        };
        assert_ne!(changed, files[0].text, "{dialect}");
        files[0].text = changed;
        let verdict = verified(&p, &setup, &files);
        assert!(
            verdict.findings.iter().any(|f| f.kind == DifferenceKind::Setting),
            "{dialect}: {:?}",
            verdict.findings
        );
    }
}

#[test]
fn a_wall_across_the_lines_blocks_them_and_is_named() {
    let mut setup = parts::setup();
    let wall = block([20.0, -12.0, 0.0], [22.0, 12.0, 30.0]);
    let p = ground(&[wall], |_| {}, &mut setup);
    let blocked: Vec<_> = p.targets().filter(|t| t.state == TargetState::Blocked).collect();
    assert!(!blocked.is_empty() && p.targets().any(|t| t.state == TargetState::Free));
    // What cannot be drawn back along its axis, which leans towards the wall, is refused as a whole piece.
    let is_refused = |t: &Target| {
        let of = |r: &&Refusal| p.plan.passes[r.pass].targets[r.point].p == t.p;
        p.plan.refusals.iter().find(of).is_some_and(|r| matches!(r.why, RefusalReason::HitDrawnBack { .. }))
    };
    assert!(blocked.iter().all(|t| t.normal_hits.is_some() || is_refused(t)), "{:?}", p.plan.refusals.first());
    let by_wall = |t: &&&Target| t.normal_hits.is_some_and(|b| b.tool_body == ToolBody::Abrasive);
    assert!(blocked.iter().filter(by_wall).count() > 4);
}

#[test]
fn a_robot_grinds_with_the_tool_in_hand() {
    let mut setup = parts::setup();
    setup.robot = Some(Robot::load("mz04", None).expect("shipped"));
    setup.mount = Mount::ToolInHand;
    let mut p = ground(&[], |_| {}, &mut setup);
    p.job.cell.robot = "mz04".into();
    let lit = p.plan.steps.list.iter().filter(|s| **s == Step::Laser(true)).count();
    assert_eq!((lit, p.plan.refusals.first()), (p.plan.passes.len(), None));
    for dialect in ["abb", "ur"] {
        let files = program(&mut p, &setup, dialect);
        let verdict = verified(&p, &setup, &files);
        assert!(verdict.findings.is_empty(), "{dialect}: {:?}", verdict.findings);
    }
}

#[test]
fn settings_of_a_laser_have_no_arc_and_no_force() {
    let light = ProcessSettings::default();
    assert_eq!((light.arc_mm, light.force_n), (0.0, 0.0));
}
