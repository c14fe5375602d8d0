//! What of a cleaning step its result depends on: all of it.

use crate::part::{Hasher, Keyed, keyed_words};
use crate::scan::cleaning::{Keep, Step};

keyed_words!(Keep: Inside, Outside);

impl Keyed for Step {
    fn feed(&self, into: &mut Hasher) {
        match self {
            Step::Outliers { neighbours, sigma } => {
                "outliers".feed(into);
                neighbours.feed(into);
                sigma.feed(into);
            }
            Step::Thin { voxel_mm } => {
                "thin".feed(into);
                voxel_mm.feed(into);
            }
            Step::Smooth { radius_mm, noise_mm } => {
                "smooth".feed(into);
                radius_mm.feed(into);
                noise_mm.feed(into);
            }
            Step::CutBox { min, max, keep } => {
                "cut box".feed(into);
                min.feed(into);
                max.feed(into);
                keep.feed(into);
            }
            Step::CutPlane { point, normal } => {
                "cut plane".feed(into);
                point.feed(into);
                normal.feed(into);
            }
            Step::Erase { centres, radius_mm } => {
                "erase".feed(into);
                centres.feed(into);
                radius_mm.feed(into);
            }
        }
    }
}
