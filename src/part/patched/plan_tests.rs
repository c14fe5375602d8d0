//! What is planned on a patch alone ends at its outline, and beads fill it layer by layer.

use super::tests::{Worn, rim_mm};
use crate::cell::Setup;
use crate::document::{Edit, Job};
use crate::part::SurfaceId;
use crate::part::patched::{Lowered, ScannedShape, shaped};
use crate::planning::{PlanCache, plan};
use crate::progress::Progress;

#[test]
fn all_targets_of_a_patch_lie_within_its_outline_and_lines_end_at_it() {
    let patched = Worn::new(0.4).patched();
    let mut job = Job::default();
    Edit::Reorder(vec![SurfaceId(7)]).apply(&mut job, &[]);
    let setup = Setup::shipped().expect("shipped");
    let (cache, progress) = (PlanCache::default(), Progress::default());
    let made = plan(&patched.part, &patched.surfaces, &job, &setup, &cache, &progress).expect("a plan");
    let rim_mm = rim_mm();
    // Spacing 0.5 mm: planes at most so far apart over the patch's width.
    assert!(made.passes.len() >= (2.0 * rim_mm / 0.5) as usize, "{}", made.passes.len());
    for pass in &made.passes {
        assert_eq!(pass.surface, 7);
        for t in &pass.targets {
            let from_centre_mm = (t.p - Worn::CENTRE).norm();
            assert!((t.p.z - Worn::CENTRE.z).abs() < 1e-9 && from_centre_mm < rim_mm + 0.03, "{}", t.p);
        }
        for end in [pass.targets.first(), pass.targets.last()].into_iter().flatten() {
            let from_centre_mm = (end.p - Worn::CENTRE).norm();
            assert!((from_centre_mm - rim_mm).abs() < 0.04, "{from_centre_mm}, not {rim_mm}");
        }
    }
}

#[test]
fn beads_fill_a_patch_in_as_many_layers_as_its_depth_takes() {
    let patched = Worn::new(0.4).filled(0.06);
    let shape = ScannedShape { raised_from_mm: 0.05, lowered: Lowered::Patches };
    let (part, mut surfaces) = shaped(&patched, &shape, &Progress::default()).expect("nobody cancels");
    surfaces.worked = Some(vec![SurfaceId(7)]);
    let mut job = Job::default();
    (job.layers.spacing_mm, job.bead.width_mm, job.bead.height_mm, job.bead.layers) = (0.5, 0.8, 0.06, 1);
    let setup = Setup::shipped().expect("shipped");
    let made = plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default()).expect("a plan");
    let layers: Vec<u32> = made.passes.iter().map(|p| p.settings.layer).collect();
    assert_eq!(layers.last(), Some(&3), "0.2 mm take four beads of 0.06 mm: {layers:?}");
    let count = |layer: u32| layers.iter().filter(|l| **l == layer).count();
    assert!(count(0) >= count(1) && count(1) > count(2) && count(2) > count(3) && count(3) > 0, "{layers:?}");
    for pass in &made.passes {
        let filled_mm = 0.06 * f64::from(pass.settings.layer);
        for t in &pass.targets {
            let from_centre_mm = (t.p - Worn::CENTRE).xy().norm();
            let share = 1.0 - (from_centre_mm / 3.0).min(1.0).powi(2);
            let floor_mm = (0.2 * share * share - filled_mm).max(0.0);
            let off_mm = Worn::CENTRE.z - t.p.z - floor_mm;
            assert!(off_mm.abs() < 0.012, "layer {}: {off_mm} off its floor at {from_centre_mm}", pass.settings.layer);
        }
    }
    assert!(made.proof.as_ref().is_some_and(|p| p.proven == p.lit_moves && p.lit_moves > 0));
}
