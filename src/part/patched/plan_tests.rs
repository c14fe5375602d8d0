//! What is planned on a patch alone ends at its outline.

use super::tests::{Worn, rim_mm};
use crate::cell::Setup;
use crate::document::{Edit, Job};
use crate::part::SurfaceId;
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
