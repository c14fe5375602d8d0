//! What is left of a bead that was measured before: after a pass too little may stand to find it anew, so the sections are
//! those of before, and only the heights in them are new.
//!
//! The camera has to stand as it did then: places are in its frame, and the outline's pixels are covered again when the
//! parent surface is fitted.

use super::edges::{self, ALONG_MM};
use super::feet::{bead_points, feet, is_in, local_feet};
use super::histogram::HeightHistogram;
use super::line::{Placed, between};
use super::measure::OUTLINED_MARGIN_PX;
use super::model::{BeadPoint, WeldBead, WeldSection};
use super::traced::HISTOGRAM_BIN_MM;
use super::{crest, line};
use crate::scan::SIGMA_OF_MEDIAN;
use crate::weld::parent::{ParentError, ParentSurface};
use crate::weld::points::PixelPoint;
use crate::weld::raster::Mask;
use rayon::prelude::*;

/// A median is this much less certain than a mean (√(π/2)), and three times its uncertainty is no chance.
const MEDIAN_UNCERTAINTY: f64 = 1.2533;
const CERTAIN: f64 = 3.0;
/// Width of the strips in which ground below the parent surface is looked for, mm.
const STRIP_MM: f64 = 2.0;

/// What a measurement says of a bead.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BeadState {
    /// Greatest height above the parent surface, mm.
    pub height_mm: f64,
    /// How far the lowest place lies below the parent surface, mm, less three times its uncertainty; 0: none does.
    pub below_mm: f64,
}

/// What is left of a bead.
#[derive(Clone, Debug, PartialEq)]
pub struct RemainingBead {
    /// In short.
    pub state: BeadState,
    /// The sections of before, with the heights of now.
    pub sections: Vec<WeldSection>,
    /// Its points of now.
    pub points: Vec<BeadPoint>,
    /// The surface they stand on, fitted anew.
    pub parent: ParentSurface,
}

impl WeldBead {
    /// The bead as it is by now: its line, outline and widths of before, with the heights that are left.
    pub fn ground_down(&self, left: RemainingBead) -> WeldBead {
        let points = left.points;
        WeldBead {
            heights: HeightHistogram::new(points.iter().map(|p| p.height_mm), HISTOGRAM_BIN_MM),
            points,
            parent: left.parent,
            sections: left.sections,
            max_height_mm: left.state.height_mm,
            outline: self.outline.clone(),
            ..*self
        }
    }

    /// Measures again what is left of it. `points`: all of the new depth image, row by row; `covered`: all masked areas.
    ///
    /// # Errors
    /// There is no parent surface around it.
    pub fn remaining(&self, points: &[PixelPoint], covered: &Mask) -> Result<RemainingBead, ParentError> {
        let parent = ParentSurface::fit(points, &self.outline, covered, OUTLINED_MARGIN_PX)?;
        let near: Vec<&PixelPoint> = points.iter().filter(|p| is_in(&self.outline, p)).collect();
        let found = feet(&parent, &near);
        let local = |s: &WeldSection| parent.camera_from_local.inverse_transform_point(&s.centre).xy().coords;
        let stations = line::stations(&parent, &self.sections.iter().map(local).collect::<Vec<_>>());
        let placed = line::placed(&stations, &local_feet(&found), self.width_mm);
        let ends_mm = [0.0, stations.last().map_or(0.0, |s| s.along_mm)];
        let measured = |s: &WeldSection| {
            // Stations begin at the first section, ways along the bead at its end.
            let along_mm = s.along_mm - self.sections.first().map_or(0.0, |first| first.along_mm);
            let height =
                crest::height_mm(&placed, along_mm, ends_mm, [0.0, s.width_mm], parent.noise_mm).unwrap_or(0.0);
            let near = between(&placed, along_mm - ALONG_MM, along_mm + ALONG_MM);
            let profile_mm = edges::binned(near.iter().map(|p| (p.left_mm, p.height_mm)));
            let profile_mm = profile_mm.iter().filter(|b| b.at_mm.abs() <= 0.5 * s.width_mm);
            let section = WeldSection {
                height_mm: height,
                profile_mm: profile_mm.map(|b| [b.at_mm, b.height_mm]).collect(),
                ..s.clone()
            };
            (section, lowest_mm(near, s.width_mm))
        };
        let all: Vec<(WeldSection, f64)> = self.sections.par_iter().map(measured).collect();
        let state = BeadState {
            height_mm: all.iter().map(|(s, _)| s.height_mm).fold(0.0, f64::max),
            below_mm: all.iter().map(|(_, low)| -low).fold(0.0, f64::max),
        };
        let points = bead_points(&found, &self.outline);
        Ok(RemainingBead { state, sections: all.into_iter().map(|(s, _)| s).collect(), points, parent })
    }
}

/// The least height of the strips of a section that is certain, mm; above 0 where all stand.
fn lowest_mm(near: &[Placed], width_mm: f64) -> f64 {
    let inside = near.iter().filter(|p| p.left_mm.abs() <= 0.5 * width_mm);
    let mut all: Vec<(f64, f64)> = inside.map(|p| ((p.left_mm / STRIP_MM).floor(), p.height_mm)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let of_strip = |strip: &[(f64, f64)]| {
        let count = strip.len();
        let middle = strip.get(count / 2).filter(|_| count >= 5)?.1;
        let mut offs: Vec<f64> = strip.iter().map(|(_, h)| (h - middle).abs()).collect();
        offs.sort_by(f64::total_cmp);
        let sigma = SIGMA_OF_MEDIAN * offs.get(count / 2)?;
        Some(middle + CERTAIN * MEDIAN_UNCERTAINTY * sigma / (count as f64).sqrt())
    };
    all.chunk_by(|a, b| a.0 == b.0).filter_map(of_strip).fold(f64::INFINITY, f64::min)
}
