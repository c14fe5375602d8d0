//! P2's acetabular cup: its topology, the five transversals, and what the arch height reduction promises.

use clearbeam::document::{self, files, segmented};
use clearbeam::part::distance::point_segment;
use clearbeam::part::{Part, angle};
use clearbeam::path::chord::ChordLimits;
use clearbeam::path::dense::{self, dense};
use clearbeam::path::reduce::simplify;
use clearbeam::path::{SectionPoint, TransversalLine};
use clearbeam::planning::report::Report;
use clearbeam::planning::toolpath::ordered;
use clearbeam::planning::{self, Plan, PlanCache};
use clearbeam::progress::Progress;
use nalgebra::{Point3, Vector3};
use std::path::PathBuf;

fn planned() -> (Part, document::Job, Plan, Report) {
    let file = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("assets/samples/acetabular_cup.toml");
    let job = files::read(&file).expect("reads");
    let part = files::load_part(&job, Some(&file)).expect("loads");
    let setup = files::load_setup(&job, Some(&file)).expect("a cell");
    let surfaces = segmented(&part, &job);
    let plan =
        planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()).expect("plans");
    let report = Report::new(&plan, &surfaces);
    (part, job, plan, report)
}

/// Chords that a circle needs.
fn least(radius_mm: f64, error_mm: f64) -> usize {
    (std::f64::consts::PI / libm::acos(1.0 - error_mm / radius_mm)).ceil() as usize
}

#[test]
fn the_cup_is_what_p2_counts() {
    let (part, _, plan, report) = planned();
    let (v, e, f) = (part.mesh.vertices.len() as i64, part.mesh.edges.len() as i64, part.mesh.facets.len() as i64);
    assert_eq!(v - e + f, 1, "an open sheet");
    // P2 Table 4: 3656 facets, 5527 edges, 1872 vertices.
    for (own, theirs) in [(f, 3656), (e, 5527), (v, 1872)] {
        assert!((own - theirs).abs() * 100 <= theirs, "{own} beside {theirs}");
    }
    assert_eq!((plan.passes.len(), report.line_points), (5, 850));
    assert!(plan.passes.iter().all(|p| p.closed && p.line_points == 170 && p.dense_points > 170));
    assert_eq!(report.dense_points, plan.passes.iter().map(|p| p.dense_points).sum::<usize>());
    // P2 keeps 74 of 850; the closed form for these five circles is 70.
    let chords: usize = plan.passes.iter().map(|p| p.targets.len() - 1).sum();
    let radius = |z: f64| (23f64.powi(2) - (z - 5.0).max(0.0).powi(2)).sqrt();
    let best: usize = [2.0, 8.0, 14.0, 20.0, 26.0].map(|z| least(radius(z), 0.5)).iter().sum();
    assert_eq!(best, 70);
    assert!((chords as f64 / best as f64 - 1.0).abs() <= 0.05, "{chords} beside {best}");
}

#[test]
fn every_dropped_point_is_near_its_chord() {
    let (_, job, plan, _) = planned();
    let toolpath = &plan.surfaces[0].toolpath;
    let lines = ordered(toolpath, &job.layers, None).lines;
    assert_eq!(lines.len(), plan.passes.len());
    for (line, pass) in lines.iter().zip(&plan.passes) {
        let points = dense(line, dense::max_gap_mm(job.layers.spacing_mm), dense::MAX_TURN_DEG);
        assert_eq!(points.len(), pass.dense_points);
        // Each target is found on the line behind the one before; what lies between is spanned by their chord.
        let mut at = 0;
        for chord in pass.targets.windows(2) {
            let (a, b) = (chord[0].p, chord[1].p);
            let is_here = |i: usize| point_segment(&b, &points[i].p, &points[i + 1].p) < 1e-9;
            let end = (at..points.len() - 1).find(|&i| is_here(i)).expect("a target stands on its line");
            for q in &points[at + 1..=end] {
                let off_mm = point_segment(&q.p, &a, &b);
                assert!(off_mm <= 0.5, "{off_mm} mm");
                assert!(off_mm <= pass.chord_error_mm + 1e-12, "the pass knows its worst");
            }
            assert!(angle::between_deg(&chord[0].n, &chord[1].n) <= 90.0);
            at = end;
        }
        assert!(points.len() - at <= 2, "the last target is the end of the line");
    }
}

#[test]
fn a_circle_needs_what_the_closed_form_says() {
    for radius_mm in [5.0, 9.38, 17.4, 23.0, 80.0, 250.0] {
        for error_mm in [0.02, 0.1, 0.5] {
            // As true a circle as would be told from one: its own sag is a thousandth of the error.
            let count = 32 * least(radius_mm, error_mm);
            let point = |i: usize| {
                let turn = i as f64 / count as f64 * std::f64::consts::TAU;
                let n = Vector3::new(libm::cos(turn), libm::sin(turn), 0.0);
                SectionPoint { p: Point3::from(n * radius_mm), n }
            };
            let line =
                TransversalLine { plane: 0, points: (0..count).map(point).collect(), closed: true, dark: vec![] };
            let points = dense(&line, 0.5, 2.0);
            let limits = ChordLimits { chord_error_mm: error_mm, max_step_mm: 1e4, max_turn_deg: 90.0 };
            let chords = simplify(&points, &vec![false; points.len()], &limits, |_, _| true).len() - 1;
            let best = least(radius_mm, error_mm);
            let off = (chords as f64 / best as f64 - 1.0).abs();
            assert!(off <= 0.05, "R {radius_mm}, error {error_mm}: {chords} chords beside {best}");
        }
    }
}
