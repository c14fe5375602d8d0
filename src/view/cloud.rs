//! A cloud of measured points as plain data: places, a colour each, and how large and how far in front they are drawn.
//! How it gets onto the graphics card is in `gpu_cloud`.

use nalgebra::Isometry3;
use std::fmt::Debug;
use std::sync::Arc;

/// Places of points, wherever they are kept: millions of them are not copied to be shown.
pub trait Places: Debug + Send + Sync {
    /// All places in the item's frame, mm; near its origin, so that f32 resolves them.
    fn places(&self) -> &[[f32; 3]];
}

impl Places for Vec<[f32; 3]> {
    fn places(&self) -> &[[f32; 3]] {
        self
    }
}

/// Square dots, hidden behind meshes. While the camera moves, some stand for all.
#[derive(Debug, Clone)]
pub struct CloudItem {
    /// Names `places`.
    pub geometry_key: u64,
    /// Where the points are.
    pub places: Arc<dyn Places>,
    /// Names `colors` for these places; a new key uploads colours only.
    pub colors_key: u64,
    /// One colour per point, as [`Rgba`](super::scene::Rgba). Alpha 0 hides the point; any other draws it whole.
    pub colors: Arc<Vec<[u8; 4]>>,
    /// Side of a dot in points of the display (pixels at a scale of 1), while the cloud is no larger than the view. It
    /// grows as the square root of the zoom from there on.
    pub size_points: f32,
    /// How far in front of its place a dot is drawn, mm. What is measured lies below a model's surface half of the time:
    /// so much of it is seen all the same.
    pub lift_mm: f32,
    /// The farther, the darker: gives its shape to a cloud whose colours tell nothing of it.
    pub fades: bool,
    /// Where it stands.
    pub scene_from_item: Isometry3<f64>,
}

impl CloudItem {
    /// Number of points, as many as a drawing can count.
    pub fn count(&self) -> u32 {
        self.places.places().len().min(i32::MAX as usize) as u32
    }

    /// One number per thing that decides how it looks.
    pub(super) fn stamp(&self) -> [u64; 4] {
        let sizes = u64::from(self.size_points.to_bits()) << 32 | u64::from(self.lift_mm.to_bits());
        [self.geometry_key, self.colors_key, sizes, u64::from(self.fades)]
    }
}
