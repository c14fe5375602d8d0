//! A line that is joined over a hole becomes one pass, with the laser off between its pieces.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::beam::{ProcessSettings, ToolConfiguration};
use clearbeam::path::chord::ChordLimits;
use clearbeam::path::ends::joined;
use clearbeam::path::{TransversalLine, dense};
use clearbeam::pose::{Correction, LineOnSurface, LineRules, Pass, Pin, Tilt, TiltRule, plan_line};
use clearbeam::progress::Progress;
use clearbeam::sample::solids;
use nalgebra::Vector3;
use parts::{cut, part};

/// The middle line of a plate of 40 mm with a hole of 10 mm, as one line with a gap.
fn bridged() -> TransversalLine {
    let (_, lines) = cut(&solids::blind_hole(40.0, 5.0, 10.0, 48), [15.0, 15.0, 0.0], "y", 40.0);
    assert_eq!(lines.len(), 2);
    let mut one = joined(lines, 10.5);
    assert_eq!(one.len(), 1);
    one.remove(0)
}

fn rules(correction: Correction, pins: Vec<Pin>) -> LineRules {
    LineRules {
        max_gap_mm: dense::max_gap_mm(1.0),
        max_dense_turn_deg: dense::MAX_TURN_DEG,
        chord: ChordLimits { chord_error_mm: 0.02, max_step_mm: 4.0, max_turn_deg: 5.0 },
        correction,
        max_tilt_deg: 45.0,
        tilt_rate_deg_mm: 5.0,
        tilt: TiltRule::default(),
        pins,
    }
}

fn planned(line: &TransversalLine, rules: &LineRules) -> Pass {
    let plate = part(&solids::blind_hole(40.0, 5.0, 10.0, 48));
    let line = LineOnSurface { line, surface: 1, number: 0, m: Some(Vector3::y()) };
    plan_line(&plate, &[ToolConfiguration::ray(ProcessSettings::default())], &line, rules, &Progress::default())
        .expect("nobody cancels")
}

#[test]
fn a_hole_is_bridged_within_a_pass() {
    let line = bridged();
    for correction in [Correction::None, Correction::SectionPlane, Correction::Clearance] {
        let pass = planned(&line, &rules(correction, Vec::new()));
        let lit: Vec<f64> =
            pass.lit_pieces().iter().map(|&(a, b)| (pass.targets[b].p - pass.targets[a].p).norm()).collect();
        assert_eq!(lit.len(), 2);
        assert!(lit.iter().all(|mm| (mm - 15.0).abs() < 1e-5), "{lit:?}");
        let gap_mm = pass.length_mm(Pass::is_gap);
        assert!((gap_mm - 10.0).abs() < 1e-5 && pass.splits.is_empty() && !pass.closed);
        assert!((pass.length_mm(|_, to| !to.laser) - gap_mm).abs() < 1e-9, "nothing else is dark");
        // Run the other way, the pieces are the same.
        let back = planned(&line.clone().reversed(), &rules(correction, Vec::new()));
        assert_eq!(back.lit_pieces().len(), 2);
        assert!((back.length_mm(Pass::is_gap) - 10.0).abs() < 1e-5);
    }
}

#[test]
fn pins_stand_where_they_were_set_on_the_whole_line() {
    // 15 mm, a gap of 10 mm, and 7 mm on in the second piece.
    let tilt = Tilt { lead_deg: 10.0, lean_deg: 0.0 };
    let pins = vec![Pin { line: 0, at_mm: 32.0, tilt }];
    let line = bridged();
    let pass = planned(&line, &rules(Correction::Clearance, pins));
    let start = pass.targets[0].p;
    let tilted: Vec<f64> = pass.targets.iter().filter(|t| t.tilt_deg() > 5.0).map(|t| (t.p - start).norm()).collect();
    assert!(!tilted.is_empty() && tilted.iter().all(|mm| (mm - 32.0).abs() < 6.0), "{tilted:?}");
    let most = pass.targets.iter().map(|t| t.tilt_deg()).fold(0.0, f64::max);
    assert!((most - 10.0).abs() < 1.0, "{most}");
}
