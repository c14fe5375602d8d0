//! How far the part as it is lies off the model (P3): signed distances of a scan's points, and what follows from them.
//!
//! The cloud has been moved into the part frame. Distances are signed by the pseudonormal of the facet, edge or vertex
//! that is nearest: above 0 outside of the model (surplus), below it inside (missing). Depths are the other way round:
//! above 0 where material is missing. What a single point says is noise; [`smoothing`] makes depths of them, and
//! [`patches`] areas with a depth and a volume. Which registration the cloud went through is not known here.

mod contour;
pub mod depth_field;
mod local_fit;
mod order;
mod outline;
pub mod patches;
pub mod refined;
pub mod section;
pub mod smoothing;
pub mod statistics;
#[cfg(test)]
mod tests;
pub mod unscanned;

pub use depth_field::DepthField;
pub use patches::{Patch, PatchKind, PatchRules, Patches};
pub use section::{Plane, SectionPoint};
pub use smoothing::SmoothedDepths;
pub use statistics::DeviationStatistics;

use super::Cloud;
use crate::part::bvh::closest::foot_on;
use crate::part::bvh::closest_search::{ClosestHint, ClosestSearch};
use crate::part::{Part, PseudoNormals};
use crate::progress::{Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;

/// Points that are one piece of work: half a millisecond.
const PIECE: usize = 1024;

/// What counts as a point of the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeviationRules {
    /// How far off the model a point may lie, mm; above 0, infinity for any distance.
    pub within_mm: f64,
}

/// What a point of a scan has to do with the model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Footing {
    /// The model is near, and has two sides there.
    OnModel,
    /// The nearest point of the model lies on a rim: beyond it there is no model to be off.
    NoModel,
    /// The model is not near, or the point is no place.
    #[default]
    Far,
}

/// How far each point of a cloud lies off the model: 9 bytes a point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Deviation {
    /// Distance to the model, mm, above 0 outside; NaN but for points on the model.
    pub signed_mm: Vec<f32>,
    /// The facet that is nearest, the lowest of several; that of no facet ([`u32::MAX`]) for points far off.
    pub facet: Vec<u32>,
    /// What each point has to do with the model.
    pub footing: Vec<Footing>,
}

#[derive(Clone, Copy)]
struct Row {
    signed_mm: f32,
    facet: u32,
    footing: Footing,
}

impl Deviation {
    /// Measures every point of a cloud that was moved into the part frame. Exact to rounding in f64; distances are kept
    /// in f32.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn new(
        part: &Part,
        cloud_in_part: &Cloud,
        rules: &DeviationRules,
        progress: &Progress,
    ) -> Result<Deviation, Cancelled> {
        let (order, normals) = rayon::join(|| order::spatial(cloud_in_part), || PseudoNormals::new(&part.mesh));
        progress.check()?;
        let search = ClosestSearch::new(&part.bvh);
        progress.check()?;
        let measure = |index: u32, hint: &mut ClosestHint| {
            let point = cloud_in_part.point(index as usize);
            let Some(closest) = search.closest(&point, rules.within_mm, hint) else {
                return Row { signed_mm: f32::NAN, facet: u32::MAX, footing: Footing::Far };
            };
            if normals.is_on_rim(&part.mesh, &closest) {
                return Row { signed_mm: f32::NAN, facet: closest.facet, footing: Footing::NoModel };
            }
            let signed_mm = normals.signed_mm(&part.mesh, &point, &closest) as f32;
            Row { signed_mm, facet: closest.facet, footing: Footing::OnModel }
        };
        let rows: Vec<Vec<Row>> = order
            .par_chunks(PIECE)
            .map(|piece| {
                progress.check()?;
                let mut hint = ClosestHint::default();
                Ok(piece.iter().map(|&index| measure(index, &mut hint)).collect())
            })
            .collect::<Result<_, Cancelled>>()?;
        let count = cloud_in_part.len();
        let mut deviation = Deviation {
            signed_mm: vec![f32::NAN; count],
            facet: vec![u32::MAX; count],
            footing: vec![Footing::Far; count],
        };
        for (&index, row) in order.iter().zip(rows.iter().flatten()) {
            let i = index as usize;
            (deviation.signed_mm[i], deviation.facet[i], deviation.footing[i]) =
                (row.signed_mm, row.facet, row.footing);
        }
        Ok(deviation)
    }

    /// Number of points measured.
    pub fn len(&self) -> usize {
        self.signed_mm.len()
    }

    /// Whether no point was measured.
    pub fn is_empty(&self) -> bool {
        self.signed_mm.is_empty()
    }

    /// The points on the model, ascending.
    pub fn on_model(&self) -> impl Iterator<Item = u32> + '_ {
        (0u32..).zip(&self.footing).filter(|(_, footing)| **footing == Footing::OnModel).map(|(index, _)| index)
    }

    /// The point of the model that is nearest to a point of the cloud, part frame; `None` for points far off.
    pub fn foot(&self, part: &Part, cloud_in_part: &Cloud, index: u32) -> Option<Point3<f64>> {
        let facet = *self.facet.get(index as usize)? as usize;
        (facet < part.mesh.facets.len())
            .then(|| foot_on(&part.mesh.corners(facet), &cloud_in_part.point(index as usize)).0)
    }
}
