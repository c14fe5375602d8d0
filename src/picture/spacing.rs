//! The spacing that lines really have, as coloured dots on them, with the scale of their colours.

use super::colormap::viridis;
use super::palette::Rgb;
use crate::document::Job;
use crate::part::{Hasher, SurfaceId};
use crate::planning::Plan;
use crate::view::{Depth, PointItem};
use nalgebra::{Isometry3, Point3};
use std::sync::Arc;

/// Least half width of the scale, as a share of the wanted spacing: smaller deviations do not matter.
const AS_WANTED: f64 = 0.02;

/// A sample: a place, and the spacing measured there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpacingSample {
    /// Surface number.
    pub surface: u32,
    /// Where, mm, part frame.
    pub at: Point3<f64>,
    /// Distance of the lines, mm.
    pub mm: f64,
    /// What was wanted, mm.
    pub wanted_mm: f64,
}

impl SpacingSample {
    fn ratio(&self) -> f64 {
        self.mm / self.wanted_mm
    }
}

/// The colour scale of a plan: dark is narrow, bright is wide, the wanted spacing is in the middle.
#[derive(Clone, Debug, PartialEq)]
pub struct SpacingScale {
    /// Its ends, as shares of what is wanted.
    pub ends: [f64; 2],
    /// What is wanted, where all surfaces want the same, mm.
    pub wanted_mm: Option<f64>,
    /// Where lines are closest together for what is wanted there.
    pub least: SpacingSample,
    /// Where they are farthest apart.
    pub greatest: SpacingSample,
}

impl SpacingScale {
    /// Share of the colour map for a share of what is wanted.
    pub fn share(&self, ratio: f64) -> f64 {
        let [low, high] = self.ends;
        if ratio < 1.0 { 0.5 * (ratio - low) / (1.0 - low) } else { 0.5 + 0.5 * (ratio - 1.0) / (high - 1.0) }
    }
}

/// All places of a plan that were measured; `job` is what it was made for.
fn places<'a>(plan: &'a Plan, job: &'a Job) -> impl Iterator<Item = SpacingSample> + 'a {
    plan.surfaces.iter().flat_map(|s| {
        let (surface, wanted_mm) =
            (s.toolpath.surface, job.of_surface(SurfaceId(s.toolpath.surface)).layers.spacing_mm);
        let samples = s.toolpath.achieved.iter().flat_map(|a| &a.samples);
        samples.map(move |&(at, mm)| SpacingSample { surface, at, mm, wanted_mm })
    })
}

/// The scale; `None`: no two lines are neighbours.
pub fn scale(plan: &Plan, job: &Job) -> Option<SpacingScale> {
    let least = places(plan, job).min_by(|a, b| a.ratio().total_cmp(&b.ratio()))?;
    let greatest = places(plan, job).max_by(|a, b| a.ratio().total_cmp(&b.ratio()))?;
    let wanted_mm = Some(least.wanted_mm).filter(|mm| {
        let own = plan.surfaces.iter().filter(|s| s.toolpath.achieved.is_some());
        own.map(|s| job.of_surface(SurfaceId(s.toolpath.surface)).layers.spacing_mm).all(|other| other == *mm)
    });
    let ends = [least.ratio().min(1.0 - AS_WANTED), greatest.ratio().max(1.0 + AS_WANTED)];
    Some(SpacingScale { ends, wanted_mm, least, greatest })
}

/// The dots of all places, and the two marked ones on top. `key` changes with the plan.
pub fn items(plan: &Plan, job: &Job, scale: &SpacingScale, key: u64) -> Vec<PointItem> {
    let color = |p: &SpacingSample| viridis(scale.share(p.ratio()));
    let item = |part: u32, places: Vec<(SpacingSample, Rgb)>, size_px: f32, depth: Depth| PointItem {
        key: Hasher::default().u32s(&[key as u32, (key >> 32) as u32, part]).finish().0 as u64,
        points: Arc::new(places.into_iter().map(|(p, rgb)| dot(p.at, rgb)).collect()),
        size_px,
        depth,
        scene_from_item: Isometry3::identity(),
    };
    let marked = [scale.least, scale.greatest];
    vec![
        item(1, places(plan, job).map(|p| (p, color(&p))).collect(), 6.0, Depth::Tested),
        item(2, marked.map(|p| (p, [20, 22, 26])).to_vec(), 19.0, Depth::OnTop),
        item(3, marked.map(|p| (p, [255; 3])).to_vec(), 16.0, Depth::OnTop),
        item(4, marked.map(|p| (p, color(&p))).to_vec(), 11.0, Depth::OnTop),
    ]
}

fn dot(at: Point3<f64>, [r, g, b]: Rgb) -> ([f32; 3], [u8; 4]) {
    ([at.x as f32, at.y as f32, at.z as f32], [r, g, b, 255])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(least: f64, greatest: f64) -> SpacingScale {
        let place = |mm: f64| SpacingSample { surface: 1, at: Point3::origin(), mm, wanted_mm: 0.5 };
        let ends = [(least / 0.5_f64).min(1.0 - AS_WANTED), (greatest / 0.5_f64).max(1.0 + AS_WANTED)];
        SpacingScale { ends, wanted_mm: Some(0.5), least: place(least), greatest: place(greatest) }
    }

    #[test]
    fn what_is_wanted_stands_in_the_middle() {
        let scale = of(0.4, 1.5);
        assert_eq!([0.8, 1.0, 3.0].map(|r| scale.share(r)), [0.0, 0.5, 1.0]);
        // Next to nothing is not blown up to the whole scale.
        let even = of(0.4999, 0.5001);
        assert!((even.share(0.9998) - 0.5).abs() < 0.01 && even.share(1.0002) < 0.51);
    }
}
