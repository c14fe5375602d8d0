//! What the offset lines of a surface start from: as it is said of the surface itself, else of its recipe, else of the
//! job.

use super::model::Job;
use super::start_from::StartFrom;
use crate::part::SurfaceId;
use crate::path::Strategy;

impl Job {
    /// Where the lines of a surface start; `None`: it is not worked in offset lines.
    pub fn offset_start(&self, surface: SurfaceId) -> Option<StartFrom> {
        let recipe = self.recipe_of(surface);
        let strategy = recipe.and_then(|r| r.strategy).unwrap_or(self.layers.strategy);
        let named = self.settings.of(surface).border.or(recipe.and_then(|r| r.border));
        (strategy == Strategy::Offset).then(|| named.unwrap_or(self.layers.border.into()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Recipe;

    #[test]
    fn the_whole_outline_of_a_recipe_goes_before_the_border_of_the_job() {
        let mut job = Job::default();
        assert_eq!(job.offset_start(SurfaceId(1)), None, "planes");
        (job.layers.strategy, job.layers.border) = (Strategy::Offset, Some(2));
        let whole = Recipe { name: "W".into(), border: Some(StartFrom::Whole), ..Recipe::default() };
        let silent = Recipe { name: "S".into(), ..Recipe::default() };
        let raster = Recipe { name: "P".into(), strategy: Some(Strategy::Planes), ..Recipe::default() };
        job.put_recipe(&whole, &[SurfaceId(1)]);
        job.put_recipe(&silent, &[SurfaceId(2)]);
        job.put_recipe(&raster, &[SurfaceId(3)]);
        let starts = |job: &Job| [1, 2, 4].map(|n| job.offset_start(SurfaceId(n)));
        let worked = |job: &Job| [1, 2, 4].map(|n| job.of_surface(SurfaceId(n)).layers.border);
        assert_eq!(starts(&job), [StartFrom::Whole, StartFrom::Border(2), StartFrom::Border(2)].map(Some));
        assert_eq!(worked(&job), [None, Some(2), Some(2)]);
        assert_eq!(job.offset_start(SurfaceId(3)), None);
        assert_eq!(whole.without_places().border, Some(StartFrom::Whole), "that of any part");
        // What is said of the surface itself goes before both.
        job.settings.change(SurfaceId(1), |s| s.border = Some(StartFrom::Border(7)));
        job.settings.change(SurfaceId(3), |s| s.border = Some(StartFrom::Border(7)));
        job.settings.change(SurfaceId(4), |s| (s.border, s.centre_mm) = (Some(StartFrom::Whole), Some([1.0; 3])));
        assert_eq!(starts(&job), [StartFrom::Border(7), StartFrom::Border(2), StartFrom::Whole].map(Some));
        assert_eq!(worked(&job), [Some(7), Some(2), None]);
        assert_eq!(job.offset_start(SurfaceId(3)), None, "it is not worked in offset lines");
        assert_eq!(job.of_surface(SurfaceId(4)).layers.centre_mm, Some([1.0; 3]));
    }
}
