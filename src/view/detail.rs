//! How much of a scene is drawn: all of it, or so much as can be drawn again at once while the camera moves.

use super::scene::{MeshItem, Scene};
use three_d::Context;
use three_d::context::{self as gl, HasContext as _};

/// How a scene is drawn this time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Detail {
    /// Pixels a point of the display.
    pub px_per_point: f32,
    /// Only so many points and facets as can be drawn again at once, because the camera moves; the whole picture is
    /// coarser then.
    pub thinned: bool,
}

impl Default for Detail {
    /// Everything, at a scale of 1.
    fn default() -> Self {
        Self { px_per_point: 1.0, thinned: false }
    }
}

/// What a moving camera may see of a scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    /// Points of all clouds.
    pub points: u32,
    /// Facets of one mesh.
    pub facets: usize,
    /// Facets of all meshes that are drawn with smooth edges.
    pub smoothed: usize,
    /// Crease lines of all meshes, each as much work as two facets.
    pub creases: usize,
}

impl Budget {
    /// Where a processor stands in for the graphics card: on two cores a picture of 1600 × 1000 takes 37 ms with so many
    /// points, and 380 ms with a million (`figures` in `tests/cloud.rs`). 100 000 facets take 31 ms in one of 1440 × 900,
    /// and 86 ms with smooth edges (`benches/window.rs`); the window around them takes 20 ms.
    const SOFTWARE: Self = Self { points: 125_000, facets: 60_000, smoothed: 30_000, creases: 10_000 };
    /// Any card of the last ten years draws so many twenty times a second.
    const HARDWARE: Self = Self { points: 4_000_000, facets: 4_000_000, smoothed: 4_000_000, creases: 2_000_000 };

    pub fn of(context: &Context) -> Self {
        // SAFETY: a query only.
        let name = unsafe { context.get_parameter_string(gl::RENDERER) }.to_lowercase();
        let in_software = ["llvmpipe", "softpipe", "swiftshader", "gdi generic", "basic render"];
        let is_software = in_software.iter().any(|renderer| name.contains(renderer));
        if is_software { Self::SOFTWARE } else { Self::HARDWARE }
    }

    /// Whether a moving camera sees the crease lines of this scene.
    pub fn shows_creases(&self, scene: &Scene) -> bool {
        let lines = scene.meshes.iter().filter_map(|mesh| Some(mesh.edges.as_ref()?.lines.len()));
        lines.sum::<usize>() <= self.creases
    }

    /// Whether a moving camera sees less of this scene than one at rest.
    pub fn thins(&self, scene: &Scene) -> bool {
        scene.cloud_points() > u64::from(self.points)
            || scene.meshes.iter().map(MeshItem::facet_count).sum::<usize>() > self.smoothed
    }
}
