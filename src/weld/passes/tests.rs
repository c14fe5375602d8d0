//! Passes by their laws, and areas above a level by the chord of a cap.

use super::*;
use proptest::prelude::*;

const NO_AREA: fn(f64) -> f64 = |_| 0.0;

fn rules(depth_per_pass_mm: f64, residual_mm: f64) -> GrindingRules {
    GrindingRules { depth_per_pass_mm, residual_mm }
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
}
