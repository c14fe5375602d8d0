//! What the images of a weld show: which masked areas stand above the metal around them, and how high. Areas that cannot be
//! measured are told, and left alone.

use super::masking::masked_by;
use super::{ReadWeld, WeldError};
use crate::document::model::{AreaChoice, JobWeld};
use crate::progress::Progress;
use crate::weld::bead::{AreaKind, SeenArea, WeldBead, WeldBeadError};
use crate::weld::masking::{DefectArea, MaskedImage};
use crate::weld::parent::{ParentError, ParentSurface};
use crate::weld::points::points;
use crate::weld::raster::{DepthImage, Mask};
use nalgebra::Point3;
use serde::{Serialize, Serializer};

/// An area of the mask, measured.
#[derive(Clone, Debug)]
pub struct MeasuredArea {
    /// As the grey image shows it.
    pub seen: DefectArea,
    /// Its pixels: a bead's by its height, any other area's by the grey image.
    pub outline: Mask,
    /// The metal around it.
    pub parent: ParentSurface,
    /// Where it was measured, on that metal, camera frame, mm.
    pub places: Vec<Point3<f64>>,
    /// The bead that it is; `None`: nothing stands there.
    pub bead: Option<WeldBead>,
}

/// An area that could not be measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct UnmeasuredArea {
    /// Column and row of its middle, px.
    pub centre_px: [f64; 2],
    /// Why; in reports a few English words.
    #[serde(rename = "cause", serialize_with = "in_words")]
    pub why: WeldBeadError,
}

fn in_words<S: Serializer>(why: &WeldBeadError, s: S) -> Result<S::Ok, S::Error> {
    s.collect_str(why)
}

/// What was measured.
#[derive(Clone, Debug, Default)]
pub struct MeasuredWeld {
    /// The areas, beads first, each kind by area × contrast.
    pub areas: Vec<MeasuredArea>,
    /// What could not be measured.
    pub unmeasured: Vec<UnmeasuredArea>,
    /// How far the ground lies below the metal around the bead by now, mm; 0 before anything was ground.
    pub below_mm: f64,
}

impl MeasuredArea {
    /// What it is.
    pub fn kind(&self) -> AreaKind {
        if self.bead.is_some() { AreaKind::Bead } else { AreaKind::Flat }
    }

    /// Whether it is one of those that are chosen.
    pub fn is_chosen(&self, choice: &AreaChoice) -> bool {
        match choice {
            AreaChoice::All => true,
            AreaChoice::At(places) => places.iter().any(|[u, v]| {
                let is_place = u.round() >= 0.0 && v.round() >= 0.0;
                is_place && self.outline.at(u.round() as usize, v.round() as usize) == Some(&true)
            }),
        }
    }

    /// A pixel that it is chosen by: column and row of the one nearest to its middle, which itself may lie beside it.
    pub fn place_px(&self) -> Option<[f64; 2]> {
        let [u, v] = self.seen.centroid_px;
        let inside = self.outline.pixels().filter(|(_, on)| **on).map(|(at, _)| at.map(|x| x as f64));
        let off = |[x, y]: &[f64; 2]| (x - u) * (x - u) + (y - v) * (y - v);
        inside.min_by(|a, b| off(a).total_cmp(&off(b)))
    }
}

impl MeasuredWeld {
    /// The bead that is told of first: the one with the greatest area × contrast.
    pub fn bead(&self) -> Option<&WeldBead> {
        self.areas.iter().find_map(|area| area.bead.as_ref())
    }
}

/// Measures every area of a mask. Once something was ground that is the mask before the first pass, and what is left of its
/// bead is measured in the depths of now.
///
/// # Errors
/// There is no area, the greatest one cannot be measured, or the work was cancelled.
pub fn measure_weld(
    read: &ReadWeld,
    masked: &MaskedImage,
    weld: &JobWeld,
    progress: &Progress,
) -> Result<MeasuredWeld, WeldError> {
    let Some((grey, depth)) = &read.before else { return measured_in(masked, &read.depth, read, progress) };
    let first = masked_by(grey, weld, progress)?;
    let mut measured = measured_in(&first, depth, read, progress)?;
    let now = points(&read.depth, &read.camera, None);
    let covered = first.areas.mask_of_all();
    for area in &mut measured.areas {
        let Some(bead) = &area.bead else { continue };
        let left = bead.remaining(&now, &covered).map_err(|e| WeldError::Bead(e.into()))?;
        measured.below_mm = measured.below_mm.max(left.state.below_mm);
        let bead = bead.ground_down(left);
        area.places = bead.points.iter().map(|p| p.foot).collect();
        (area.parent, area.bead) = (bead.parent.clone(), Some(bead));
    }
    Ok(measured)
}

fn measured_in(
    masked: &MaskedImage,
    depth: &DepthImage,
    read: &ReadWeld,
    progress: &Progress,
) -> Result<MeasuredWeld, WeldError> {
    if masked.areas.list.is_empty() {
        return Err(WeldError::NoArea);
    }
    let all = points(depth, &read.camera, None);
    let covered = masked.areas.mask_of_all();
    let (mut beads, mut flat, mut unmeasured) = (Vec::new(), Vec::new(), Vec::new());
    for (place, seen) in masked.areas.list.iter().enumerate() {
        progress.check()?;
        let area = masked.areas.mask(&[place]);
        let of_area = |outline, parent: ParentSurface, bead: Option<WeldBead>| {
            let places = match &bead {
                Some(bead) => bead.points.iter().map(|p| p.foot).collect(),
                None => points(depth, &read.camera, Some(&area)).iter().map(|p| parent.foot(&p.point).foot).collect(),
            };
            MeasuredArea { seen: seen.clone(), outline, parent, places, bead }
        };
        let measured =
            SeenArea::new(&all, &area, &covered).map_err(WeldBeadError::from).and_then(|at| match at.kind() {
                AreaKind::Bead => {
                    at.measure(&read.camera).map(|bead| of_area(bead.outline.clone(), bead.parent.clone(), Some(bead)))
                }
                AreaKind::Flat => Ok(of_area(area.clone(), at.parent, None)),
            });
        match measured {
            Ok(area) if area.bead.is_some() => beads.push(area),
            Ok(area) => flat.push(area),
            Err(why) if place == 0 => return Err(WeldError::Bead(why)),
            Err(why) => unmeasured.push(UnmeasuredArea { centre_px: seen.centroid_px, why }),
        }
    }
    beads.append(&mut flat);
    if beads.is_empty() {
        return Err(WeldError::Bead(ParentError::NothingCovered.into()));
    }
    Ok(MeasuredWeld { areas: beads, unmeasured, below_mm: 0.0 })
}
