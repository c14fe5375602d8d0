//! The lines of a job before anything is asked of the beam: what is shown while a plan is being made.

use super::build_up::{LayerInput, layer_toolpaths};
use super::prepared::prepare;
use super::surface_plan::PlanCache;
use super::toolpath::Toolpath;
use crate::document::model::Job;
use crate::part::{Part, Surfaces};
use crate::planning::error::PlanError;
use crate::progress::Progress;
use std::sync::Arc;

/// The lines of the lowest layer, as the plan of the same job will have them; it takes them from the cache.
///
/// # Errors
/// Those of [`crate::planning::plan()`].
pub fn preview(
    part: &Part,
    surfaces: &Surfaces,
    job: &Job,
    cache: &PlanCache,
    progress: &Progress,
) -> Result<Vec<Arc<Toolpath>>, PlanError> {
    let (list, own) = prepare(part, surfaces, job)?;
    let toolpaths =
        layer_toolpaths(&LayerInput { part, surfaces, list: &list, jobs: &own, layer: 0 }, cache, progress)?;
    cache.add_toolpaths(&toolpaths);
    Ok(toolpaths.into_iter().map(|l| l.1).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Setup;
    use crate::document::{Recipe, segmented};
    use crate::part::{Placement, SurfaceId, Units};
    use crate::planning::plan;
    use crate::sample::{solids, stl_bytes};

    #[test]
    fn the_plan_takes_the_lines_that_were_shown() {
        let part =
            Part::from_bytes(&stl_bytes(&solids::cube(20.0)), Units::Mm, &Placement::default(), &[]).expect("ok");
        let mut job = Job::default();
        job.settings.choose([5, 2]);
        (job.layers.spacing_mm, job.bead.width_mm, job.bead.height_mm, job.bead.layers) = (2.0, 3.0, 0.9, 2);
        let strategy = Some(crate::path::Strategy::Offset);
        job.recipes.push(Recipe { name: "Around".into(), strategy, ..Recipe::default() });
        job.settings.change(SurfaceId(2), |s| s.recipe = Some("Around".into()));
        let (surfaces, setup, cache) =
            (segmented(&part, &job), Setup::shipped().expect("shipped"), PlanCache::default());
        let shown = preview(&part, &surfaces, &job, &cache, &Progress::default()).expect("lines");
        assert_eq!(shown.iter().map(|l| l.surface).collect::<Vec<_>>(), [5, 2]);
        assert!(shown.iter().all(|l| !l.lines.is_empty()) && shown[1].planes.is_empty());
        let plan = plan(&part, &surfaces, &job, &setup, &cache, &Progress::default()).expect("a plan");
        assert_eq!(plan.surfaces.len(), 4, "two layers");
        for (shown, made) in shown.iter().zip(&plan.surfaces) {
            assert!(Arc::ptr_eq(shown, &made.toolpath));
        }
        job.layers.spacing_mm = 200.0;
        let too_large = preview(&part, &surfaces, &job, &cache, &Progress::default());
        assert!(matches!(too_large, Err(PlanError::SpacingTooLarge { .. })));
    }
}
