//! The `[weld]` table of a job (P4): the images that show a weld, how areas are found in them, what is taken off in each
//! pass and how the grinding tool is led. A job without images grinds nothing. What it decides beside numbers stands in
//! `weld_choices`; what the images say is `weld`'s.

use super::declare::{count, parameters};
use super::weld_choices::{AreaChoice, GrindingStrategy, GroundPass, NamedImage, RoughnessReading, WeldFiles};
use crate::weld::masking::BrushStroke;
use serde::{Deserialize, Serialize};

parameters! {
    /// The weld of a job.
    ///
    /// Pixels count from the upper left of the image, their centres at whole numbers.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(default, deny_unknown_fields)]
    pub struct JobWeld in "weld" {
        /// Width of the window that tells the light around a pixel; 0: the light is even, px.
        pub even_light_px: f64,
        /// Standard deviation of the smoothing before the threshold, px.
        pub smoothing_px: f64,
        /// How many standard deviations above the main mode of the histogram an area begins.
        pub sigmas: f64,
        /// What is narrower than this is no area, px.
        pub opening_px: f64,
        /// Gaps narrower than this are closed, px.
        pub closing_px: f64,
        /// Areas of fewer pixels are left out.
        pub least_area_px: f64,
        /// What one pass takes off, mm.
        pub pass_depth_mm: f64,
        /// How many passes the program has: one, where the next images are to be taken behind it.
        #[serde(deserialize_with = "count")]
        pub at_once: u32,
        /// The height at which grinding stops, mm.
        pub residual_mm: f64,
        /// So far below the parent surface nothing may be ground, mm.
        pub below_mm: f64,
        /// Where what a pass took off differs by more than this share from what it should, the next one waits for the
        /// operator's word, per cent.
        pub removal_share: f64,
        /// Lead of a disc that grinds with its rim, degrees.
        pub lead_deg: f64,
        /// Radius of the arcs on which the tool enters and leaves, mm.
        pub arc_mm: f64,
        /// Force on the part, N.
        pub force_n: f64,
        /// So far the tool may dip into the part beside its contact, mm.
        pub gouge_mm: f64,
        /// What the tool accelerates by, for the times of the strategies, mm/s².
        pub acceleration_mm_s2: f64,
        /// Level of the threshold in the evened image, 0 to 255, set by hand; else it follows from the histogram.
        #[serde(skip_serializing_if = "Option::is_none")]
        pub threshold: Option<f64> = None,
        /// How areas without height are ground.
        pub strategy: GrindingStrategy = GrindingStrategy::Spiral,
        /// How beads are ground.
        pub bead_strategy: GrindingStrategy = GrindingStrategy::Along,
        /// Which areas are ground.
        #[serde(skip_serializing_if = "AreaChoice::is_all")]
        pub areas: AreaChoice = AreaChoice::All,
        /// The images, and the camera that took them.
        #[serde(skip_serializing_if = "WeldFiles::is_none")]
        pub images: WeldFiles = WeldFiles::default(),
        /// Where the camera stood: a hand-eye file, relative to the job file; empty: nobody knows.
        #[serde(skip_serializing_if = "String::is_empty")]
        pub hand_eye: String = String::new(),
        /// The grinding tool's file, relative to the job file; empty: a disc as it is shipped.
        #[serde(skip_serializing_if = "String::is_empty")]
        pub tool: String = String::new(),
        /// What was painted onto the mask, in order.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub painted: Vec<BrushStroke> = Vec::new(),
        /// The passes that were ground, each with the images before it.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub history: Vec<GroundPass> = Vec::new(),
        /// The operator has seen that the last pass took off other than it should, and goes on.
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        pub goes_on: bool = false,
        /// Roughness at numbered points.
        #[serde(skip_serializing_if = "Vec::is_empty")]
        pub roughness: Vec<RoughnessReading> = Vec::new(),
    }
}

impl JobWeld {
    /// Whether the job grinds a weld.
    pub fn is_there(&self) -> bool {
        !self.images.is_none()
    }

    /// The files that it names, each with its digest, if it has one.
    pub fn files(&self) -> impl Iterator<Item = &NamedImage> {
        let before = self.history.iter().flat_map(|pass| [&pass.images.gray, &pass.images.depth]);
        let now = [&self.images.gray, &self.images.depth, &self.images.camera];
        now.into_iter().chain(before).filter(|f| !f.file.is_empty())
    }

    /// How a bead is ground, or an area without height. Only beads have a centre line.
    pub fn strategy_of(&self, is_bead: bool) -> GrindingStrategy {
        match (is_bead, self.strategy) {
            (true, _) => self.bead_strategy,
            (false, GrindingStrategy::Along) => GrindingStrategy::Spiral,
            (false, strategy) => strategy,
        }
    }

    /// Every path that it has, those that are empty as well.
    pub fn paths_mut(&mut self) -> impl Iterator<Item = &mut String> {
        let before = self.history.iter_mut().map(|pass| &mut pass.images);
        let images = std::iter::once(&mut self.images).chain(before);
        let of_images = images.flat_map(|i| [&mut i.gray.file, &mut i.depth.file, &mut i.camera.file]);
        of_images.chain([&mut self.hand_eye, &mut self.tool])
    }
}
