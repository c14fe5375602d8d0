//! What a program does with the laser off: leads along the line, and the head in the air, which is looked at again
//! by the checker.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::beam::Tool;
use clearbeam::cell::motion::RefusalReason;
use clearbeam::document::{Job, segmented};
use clearbeam::planning::remark::Remark;
use clearbeam::planning::report::Report;
use clearbeam::pose::checker::CutCone;
use clearbeam::pose::{Obstruction, ToolBody};
use clearbeam::program::{Go, MoveTiming, Shortfall, Station, Step};
use clearbeam::sample::Triangles;
use clearbeam::text::Sentence;
use nalgebra::{Point3, Vector3};
use parts::{Planned, block, cylinder};
use proptest::prelude::*;

const SPEED_MM_S: f64 = 20.0;

/// A plate 60 mm long along x, and more; lines along it.
fn plate_and(more: &[Triangles], half_width_mm: f64, job: &Job, setup: &clearbeam::cell::Setup) -> Planned {
    let mut all = block([-30.0, -half_width_mm, -10.0], [30.0, half_width_mm, 0.0]);
    all.extend(more.iter().flatten());
    let part = parts::part(&all);
    let surfaces = segmented(&part, job);
    let top = parts::surface_at(&part, &surfaces, [-25.0, 0.0, 0.0]);
    parts::planned_in(part, parts::on(job.clone(), &[top]), setup)
}

fn rows(spacing_mm: f64) -> Job {
    let mut job = parts::job("y", spacing_mm);
    job.layers.inset_mm = 1.0;
    job
}

/// Each lit piece: the two moves before the laser goes on, and the one after it went off.
fn around_pieces(p: &Planned) -> Vec<([Go; 3], Go)> {
    let list = &p.plan.steps.list;
    let go = |i: usize, back: bool| {
        let mut rest: Box<dyn Iterator<Item = &Step>> =
            if back { Box::new(list[..i].iter().rev()) } else { Box::new(list[i..].iter()) };
        rest.find_map(|s| if let Step::Go(go) = s { Some(*go) } else { None })
    };
    let place = |i: usize| list[..i].iter().rposition(|s| matches!(s, Step::Go(_))).expect("a move");
    let mut out = Vec::new();
    let mut last_before = None;
    for (i, step) in list.iter().enumerate() {
        match step {
            Step::Laser(true) => {
                let start = place(i);
                last_before = Some([go(start, true).expect("a move"), go(i, true).expect("a move")]);
            }
            Step::Laser(false) => {
                let [from, start] = last_before.take().expect("it was on");
                out.push(([from, start, go(i, true).expect("a move")], go(i, false).expect("a move")));
            }
            _ => {}
        }
    }
    out
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// So far before the first target and behind the last, at the speed of the work: on a plate, and on a cup in a
    /// robot's hand.
    #[test]
    fn leads_go_straight_on_at_the_speed_of_the_work(in_mm in 0.5..30.0f64, out_mm in 0.5..30.0f64, robot in any::<bool>()) {
        let planned = |in_mm: f64, out_mm: f64| {
            let mut setup = parts::setup();
            let mut job = if robot { parts::job("y", 6.0) } else { rows(5.0) };
            (job.path.lead_in_mm, job.path.lead_out_mm, job.beam.speed_mm_s) = (in_mm, out_mm, SPEED_MM_S);
            if !robot {
                return plate_and(&[], 10.0, &job, &setup);
            }
            setup.robot = Some(clearbeam::cell::Robot::load("mz04", None).expect("shipped"));
            parts::planned_in(parts::part(&parts::sample("acetabular_cup")), job, &setup)
        };
        let p = planned(in_mm, out_mm);
        let pieces = around_pieces(&p);
        let lit = p.plan.passes.iter().enumerate().flat_map(|(n, pass)| pass.lit_pieces().into_iter().map(move |ends| (n, ends)));
        let lit: Vec<_> = lit.collect();
        prop_assert!(lit.len() > 3 && pieces.len() == lit.len());
        let seconds = |go: &Go| if let MoveTiming::Seconds(s) = go.timing { s } else { f64::NAN };
        let mut left_out = 0;
        for (([from, start, end], to), (number, (first, last))) in pieces.iter().zip(&lit) {
            let targets = &p.plan.passes[*number].targets;
            prop_assert_eq!((start.target, end.target), (Some((*number, *first)), Some((*number, *last))));
            prop_assert_eq!((from.target, to.target), (None, None));
            prop_assert_eq!(start.joints_deg.is_some(), robot);
            let along = |i: usize| (targets[i + 1].p - targets[i].p).normalize();
            for (inner, outer, go, way, mm) in [(start, from, start, -along(*first), in_mm), (end, to, to, along(last - 1), out_mm)] {
                let is_lead = (outer.to.x - inner.to.x - way * mm).norm() < 1e-9;
                left_out += usize::from(!is_lead);
                if is_lead {
                    prop_assert_eq!((outer.to.a, outer.to.o), (inner.to.a, inner.to.o));
                    // NACHI's T= has four decimals.
                    let over_s = seconds(go) - mm / SPEED_MM_S;
                    prop_assert!((-1e-8..1e-4).contains(&over_s));
                }
            }
        }
        let told = p.plan.steps.shortfalls.iter().map(|s| match s.1 {
            Shortfall::LeadsLeftOut { leads } => leads,
            Shortfall::SetByHand(_) | Shortfall::ShortMoves { .. } => 0,
        });
        prop_assert_eq!(told.sum::<usize>(), left_out);
        prop_assert!(robot || left_out == 0);
        // What is lit stays as it was.
        let without = planned(0.0, 0.0);
        let targets = |p: &Planned| p.plan.passes.iter().map(|pass| pass.targets.clone()).collect::<Vec<_>>();
        prop_assert!(robot || targets(&without) == targets(&p));
        let proven = |p: &Planned| p.plan.proof.as_ref().map(|p| p.proven == p.lit_moves);
        prop_assert_eq!((proven(&without), proven(&p)), (Some(true), Some(true)));
    }
}

/// A wall stands 1 mm behind the lines' ends on one side.
#[test]
fn a_lead_into_a_wall_is_left_out_and_told() {
    let wall = block([30.0, -12.0, -10.0], [34.0, 12.0, 50.0]);
    let mut job = rows(5.0);
    (job.path.lead_in_mm, job.path.lead_out_mm) = (3.0, 3.0);
    let p = plate_and(std::slice::from_ref(&wall), 10.0, &job, &parts::setup());
    let lines = p.plan.passes.len();
    assert!(lines >= 4);
    let reach = |go: &Go| go.to.x.x.abs();
    for ([from, ..], to) in around_pieces(&p) {
        let leads: Vec<f64> = [from, to].iter().map(reach).filter(|x| (x - 32.0).abs() < 1e-6).collect();
        assert_eq!(leads.len(), 1, "one of the two: {leads:?}");
    }
    let left_out = Shortfall::LeadsLeftOut { leads: lines };
    assert_eq!(p.plan.steps.shortfalls, [(p.plan.passes[0].surface, left_out)]);
    assert_eq!(Report::new(&p.plan, &p.surfaces).surfaces[0].remarks, [Remark::Program(left_out)]);
    let said = format!("{lines} lead-ins and lead-outs are left out: something would be touched on them");
    assert_eq!(left_out.sentence(), said);
    // Half a millimetre of lead stays in front of it.
    (job.path.lead_in_mm, job.path.lead_out_mm) = (0.5, 0.5);
    assert!(plate_and(&[wall], 10.0, &job, &parts::setup()).plan.steps.shortfalls.is_empty());
}

/// Moves with the laser off between the first lit piece and the last.
fn dark(p: &Planned) -> Vec<(Station, Station)> {
    let (mut at, mut lit, mut begun) = (None, false, false);
    let mut out = Vec::new();
    for step in &p.plan.steps.list {
        match step {
            Step::Laser(on) => (lit, begun) = (*on, true),
            Step::Go(go) => {
                out.extend(at.filter(|_| begun && !lit).map(|from| (from, go.to)));
                at = Some(go.to);
            }
            _ => {}
        }
    }
    out
}

/// What the checker finds between a cylinder 20 to 120 mm from the focus and the part, mm, at most 5.
fn head_to_part_mm(p: &Planned, x: &Point3<f64>, a: &Vector3<f64>, radius: f64) -> f64 {
    let cone: CutCone = [20.0, 120.0, radius, radius];
    p.checker().cone_distance(x, a, &cone, 5.0)
}

/// A post in the middle of the plate, which the head cannot come near and the beam can: with the laser off the head
/// goes around it as well.
#[test]
fn in_the_air_the_head_keeps_clear_of_a_post_beside_the_beam() {
    let post = block([-1.0, -1.0, 0.0], [1.0, 1.0, 90.0]);
    let mut job = rows(4.0);
    job.path.max_tilt_deg = 2.0;
    let mut setup = parts::setup();
    setup.tool = cylinder(9.0);
    let p = plate_and(&[post], 8.0, &job, &setup);
    let pieces = around_pieces(&p);
    assert!(pieces.len() > p.plan.passes.len(), "lines are cut by the post");
    let at = |s: &Station, e: &Station, t: f64| s.x + (e.x - s.x) * t;
    // Straight over, as far as the beam is concerned, the head would hit it.
    let straight = pieces.windows(2).filter(|w| {
        let (end, start) = (w[0].0[2].to, w[1].0[1].to);
        let up = |s: &Station| Station { x: s.x + s.a * 10.0, ..*s };
        (end.x.y - start.x.y).abs() < 1e-6
            && head_to_part_mm(&p, &at(&up(&end), &up(&start), 0.5), &Vector3::z(), 9.0) == 0.0
    });
    assert!(straight.count() >= 2);
    for (from, to) in dark(&p) {
        for k in 0..=40 {
            let t = f64::from(k) / 40.0;
            let a = clearbeam::part::angle::slerp(&from.a, &to.a, t);
            let x = at(&from, &to, t);
            assert!(head_to_part_mm(&p, &x, &a, 9.0) > 0.1, "at {x}");
        }
    }
}

/// Two roofs with a slot between them, through which the beam passes and the head does not.
#[test]
fn what_the_head_cannot_be_drawn_back_from_is_refused() {
    let roofs = [[8.0, 40.0], [-40.0, -8.0]].map(|[y0, y1]| block([-60.0, y0, 170.0], [60.0, y1, 175.0]));
    let mut setup = parts::setup();
    setup.tool = cylinder(9.0);
    let mut job = rows(4.0);
    job.path.max_tilt_deg = 2.0;
    let p = plate_and(&roofs, 3.0, &job, &setup);
    assert!(!p.plan.refusals.is_empty());
    for r in &p.plan.refusals {
        let RefusalReason::HitDrawnBack { hit } = &r.why else { panic!("{:?}", r.why) };
        assert!(matches!((hit.tool_body, hit.obstruction), (ToolBody::Head, Obstruction::Facet(_))), "{hit:?}");
    }
    assert!(!p.plan.steps.list.contains(&Step::Laser(true)), "nothing is lit");
    let free = plate_and(&roofs, 3.0, &job, &clearbeam::cell::Setup { tool: Tool::default(), ..setup });
    assert!(free.plan.steps.list.contains(&Step::Laser(true)), "without a head it goes");
}
