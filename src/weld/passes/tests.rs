use super::history::{GrindingHistory, HoldReason, NextPass};
use super::*;
use crate::weld::bead::BeadState;
use proptest::prelude::*;

const NO_AREA: fn(f64) -> f64 = |_| 0.0;

fn rules(depth_per_pass_mm: f64, residual_mm: f64) -> GrindingRules {
    GrindingRules { depth_per_pass_mm, residual_mm, ..GrindingRules::default() }
}

fn state(height_mm: f64) -> BeadState {
    BeadState { height_mm, below_mm: 0.0 }
}

#[test]
fn passes_are_the_height_by_the_depth_rounded_up() {
    for (height, depth, residual, count, last_infeed) in [
        (15.0, 0.5, 0.0, 30, 0.5),
        (15.01, 0.5, 0.0, 31, 0.01),
        (3.0, 1.0, 0.5, 3, 0.5),
        (0.2, 0.5, 0.3, 0, 0.0),
        (0.3, 0.1, 0.0, 3, 0.1),
    ] {
        let passes = schedule(height, &rules(depth, residual), NO_AREA).expect("a plan").passes;
        assert_eq!(passes.len(), count, "{height} by {depth}");
        if let Some(last) = passes.last() {
            assert!((last.infeed_mm - last_infeed).abs() < 1e-9);
            assert_eq!(last.level_mm, residual);
        }
    }
    assert!(matches!(schedule(1e9, &rules(0.1, 0.0), NO_AREA), Err(PassError::ManyPasses { .. })));
    assert!(matches!(schedule(f64::NAN, &rules(0.1, 0.0), NO_AREA), Err(PassError::Height { .. })));
    assert!(matches!(schedule(1.0, &rules(0.0, 0.0), NO_AREA), Err(PassError::Rule { key: "depth_per_pass_mm", .. })));
    assert!(matches!(schedule(1.0, &rules(1.0, -0.1), NO_AREA), Err(PassError::Rule { key: "residual_mm", .. })));
}

#[test]
fn the_width_of_a_cap_above_a_level_is_its_chord() {
    let (height, width) = (5.0, 12.0);
    let corner = |k: i32| {
        let t = f64::from(k) / 1000.0;
        [0.5 * width * t, height * (1.0 - t * t)]
    };
    let corners: Vec<[f64; 2]> = (-1000..=1000).map(corner).collect();
    for level in [0.0, 1.0, 2.5, 4.9, 5.0, 6.0] {
        let found: f64 = corners.windows(2).map(|w| above(w[0], w[1], level)).sum();
        let chord = width * (1.0 - level / height).max(0.0).sqrt();
        assert!((found - chord).abs() < 1e-3, "{level}: {found} for {chord}");
    }
}

proptest! {
    /// Levels go down to the residual height, no pass takes more than its depth, together they take all there is.
    #[test]
    fn levels_go_down_to_the_residual(height in 0.0..20.0f64, depth in 0.05..3.0f64, residual in 0.0..2.0f64) {
        let passes = schedule(height, &rules(depth, residual), |level| 20.0 - level).expect("a plan").passes;
        let mut level = height;
        for pass in &passes {
            prop_assert!(pass.infeed_mm > 0.0 && pass.infeed_mm <= depth + 1e-9);
            prop_assert!((level - pass.infeed_mm - pass.level_mm).abs() < 1e-9);
            level = pass.level_mm;
        }
        prop_assert!(passes.is_empty() == (height <= residual + 1e-9));
        prop_assert!(passes.is_empty() || level == residual);
        prop_assert!(passes.windows(2).all(|w| w[0].area_mm2 <= w[1].area_mm2));
        prop_assert!((passes.len() as f64 - 1.0) * depth <= (height - residual).max(0.0) + 1e-9);
    }

    /// Whatever passes take, what is left is planned from the measurement alone; held or not is told by the shares.
    #[test]
    fn what_is_left_follows_from_the_last_measurement(height in 2.0..15.0f64, removals in prop::collection::vec(0.2..1.8f64, 1..8)) {
        let rules = rules(1.0, 0.1);
        let mut history = GrindingHistory::begin(rules, state(height), NO_AREA).expect("a plan");
        let mut now = height;
        for share in removals {
            let Some(pass) = history.left().passes.first().copied() else { break };
            now -= share * pass.infeed_mm;
            history.measured(state(now), NO_AREA).expect("a plan");
            prop_assert_eq!(history.left(), &schedule(now, &rules, NO_AREA).expect("a plan"));
            let last = history.ground().last().expect("one");
            prop_assert!((last.off_share() - (share - 1.0)).abs() < 1e-6);
            match history.next() {
                NextPass::Done => prop_assert!(now <= 0.1 + 1e-9),
                NextPass::Grind(_) => prop_assert!((share - 1.0).abs() <= 0.3 + 1e-6),
                NextPass::Held { reasons, .. } => {
                    prop_assert!((share - 1.0).abs() >= 0.3 - 1e-6);
                    prop_assert_eq!(reasons.len(), 1);
                }
            }
        }
    }
}

#[test]
fn what_lies_below_the_parent_holds_the_next_pass() {
    let mut history = GrindingHistory::begin(rules(1.0, 0.0), state(3.0), NO_AREA).expect("a plan");
    assert!(matches!(history.next(), NextPass::Grind(GrindingPass { level_mm: 2.0, .. })));
    history.measured(BeadState { height_mm: 2.0, below_mm: 0.25 }, NO_AREA).expect("a plan");
    let NextPass::Held { reasons, pass } = history.next() else { panic!("{:?}", history.next()) };
    assert_eq!((reasons, pass.level_mm), (vec![HoldReason::BelowParent { below_mm: 0.25 }], 1.0));
    // Twice the planned depth, and below: both are told.
    history.measured(BeadState { height_mm: 0.5, below_mm: 0.3 }, NO_AREA).expect("a plan");
    let NextPass::Held { reasons, pass } = history.next() else { panic!("{:?}", history.next()) };
    assert_eq!((reasons.len(), pass.infeed_mm), (2, 0.5));
    history.measured(state(0.0), NO_AREA).expect("a plan");
    assert_eq!((history.next(), history.ground().len()), (NextPass::Done, 3));
    let before = history.clone();
    assert!(history.measured(state(f64::NAN), NO_AREA).is_err());
    assert_eq!(history, before);
}
