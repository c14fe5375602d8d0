//! The clipping plane: a part that is cut open, so that one sees and picks inside its bores.

use super::context::Context;
use super::shown::PartCut;
use super::toggle::Toggle;
use crate::view::MeshCut;
use nalgebra::{Point3, Vector3};

impl Context<'_> {
    /// Normal and distance of the plane in the part's frame, mm; what is below it is cut away. `None`: nothing is.
    fn cut_plane(self) -> Option<(Vector3<f64>, f64)> {
        let part = self.derived.part.as_ref().filter(|_| self.session.show.is_on(Toggle::Cut))?;
        let PartCut { axis, share, is_flipped } = self.session.cut;
        let (min, max) = part.mesh.bounds();
        let at_mm = min[axis] + f64::from(share) * (max[axis] - min[axis]);
        let side = if is_flipped { -1.0 } else { 1.0 };
        Some((Vector3::ith(axis, side), -side * at_mm))
    }

    /// Whether a place of the part is cut away.
    pub fn is_cut_away(self, at: &Point3<f64>) -> bool {
        self.cut_plane().is_some_and(|(normal, distance_mm)| normal.dot(&at.coords) + distance_mm < 0.0)
    }

    /// The plane for the part's mesh.
    pub fn cut_of(self, geometry_key: u64) -> Option<MeshCut> {
        let (n, distance_mm) = self.cut_plane()?;
        Some(MeshCut { geometry_key, plane: [n.x as f32, n.y as f32, n.z as f32, distance_mm as f32] })
    }
}
