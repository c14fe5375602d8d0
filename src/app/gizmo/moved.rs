//! What the handles move: where it stands in the scene, and the edit that puts it elsewhere.

use super::super::actions::Actions;
use super::super::context::Context;
use super::state::Moved;
use crate::cell::{Frame, Mount};
use crate::document::Edit;
use crate::part::rpy;
use nalgebra::{Isometry3, Point3, Translation3, UnitQuaternion, Vector3};

/// Figures of a pose, rounded to what a person would set: mm and degrees.
fn figures(pose: &Isometry3<f64>) -> ([f64; 3], [f64; 3]) {
    let rounded = |v: f64| libm::round(v * 1000.0) / 1000.0 + 0.0;
    let angles_deg = rpy::from_rotation(&pose.rotation.to_rotation_matrix());
    (<[f64; 3]>::from(pose.translation.vector).map(rounded), angles_deg.map(rounded))
}

impl Context<'_> {
    /// Where it stands in the scene; `None`: it is not there, or not seen.
    pub fn pose_of(self, what: Moved) -> Option<Isometry3<f64>> {
        match what {
            Moved::Clamp(i) => {
                let clamp = self.document.job().clamps.get(i)?;
                let rotation = rpy::to_rotation(clamp.rz_ry_rx_deg);
                let at = Isometry3::from_parts(Translation3::from(clamp.position_mm), rotation.into());
                Some(self.scene_from_part() * at)
            }
            // The scene of the cell is the base.
            Moved::Laser | Moved::Part => {
                let setup = self.derived.pipeline.setup()?.ok().filter(|_| self.is_in_cell())?;
                let is_there = (setup.mount == Mount::PartInHand) == (what == Moved::Laser);
                let frame = if what == Moved::Laser { &setup.cell.base_from_laser } else { &setup.cell.base_from_part };
                is_there.then(|| frame.isometry())
            }
        }
    }

    /// Puts it elsewhere in the scene; one drag is one step of undo.
    pub fn move_to(self, what: Moved, pose: &Isometry3<f64>, actions: &mut Actions) {
        match what {
            Moved::Clamp(i) => {
                let mut clamps = self.document.job().clamps.clone();
                let Some(clamp) = clamps.get_mut(i) else { return };
                (clamp.position_mm, clamp.rz_ry_rx_deg) = figures(&(self.scene_from_part().inverse() * pose));
                actions.drag(Edit::Clamps(clamps), "clamps");
            }
            Moved::Laser | Moved::Part => {
                let (position_mm, angles_deg) = figures(pose);
                let frame = Some(Frame::new(position_mm, angles_deg));
                let mut cell = self.document.job().cell.clone();
                match what {
                    Moved::Laser => cell.base_from_laser = frame,
                    _ => cell.base_from_part = frame,
                }
                actions.drag(Edit::Frames(Box::new(cell)), "frame by hand");
            }
        }
    }
}

/// Puts a clamp with its origin on a place of the part, its z axis out of the face there: upright over a hole, flat on a
/// face. The turn about that axis stays as near as may be to what it was.
pub(in super::super) fn put_clamp(
    context: Context<'_>,
    i: usize,
    at: &Point3<f64>,
    outward: &Vector3<f64>,
    actions: &mut Actions,
) {
    let mut clamps = context.document.job().clamps.clone();
    let Some(clamp) = clamps.get_mut(i) else { return };
    let now = UnitQuaternion::from(rpy::to_rotation(clamp.rz_ry_rx_deg));
    let up = now * Vector3::z();
    let turn = UnitQuaternion::rotation_between(&up, outward)
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&(now * Vector3::x_axis()), std::f64::consts::PI));
    let pose = Isometry3::from_parts(at.coords.into(), turn * now);
    (clamp.position_mm, clamp.rz_ry_rx_deg) = figures(&pose);
    actions.edit(Edit::Clamps(clamps));
}
