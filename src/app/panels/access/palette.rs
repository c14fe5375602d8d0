//! The colours of what can be reached, and of what stands in the way.

use crate::pose::access::Access;
use crate::pose::{Obstruction, ToolBody};
use eframe::egui::Color32;

/// Free; it differs from the others in lightness as well.
pub(super) const FREE: Color32 = Color32::from_rgb(126, 200, 196);
/// The beam hits something.
pub(super) const BY_BEAM: Color32 = Color32::from_rgb(198, 90, 17);
/// The head hits something.
pub(super) const BY_HEAD: Color32 = Color32::from_rgb(122, 62, 132);
/// A clamp is hit.
pub(super) const BY_CLAMP: Color32 = Color32::from_rgb(70, 74, 82);
/// The surface's tilt rule does not allow it.
pub(super) const FORBIDDEN: Color32 = Color32::from_rgb(150, 150, 150);

/// The colour of a direction.
pub(super) fn color(a: Access) -> Color32 {
    match a {
        Access::Free => FREE,
        Access::Forbidden => FORBIDDEN,
        Access::Blocked(b) => match (b.obstruction, b.tool_body) {
            (Obstruction::Clamp(_) | Obstruction::Unscanned, _) => BY_CLAMP,
            (_, ToolBody::Head | ToolBody::Abrasive | ToolBody::Gouge) => BY_HEAD,
            (_, ToolBody::Beam) => BY_BEAM,
        },
    }
}

/// Darker, and still opaque: neighbours overlap.
pub(super) fn dimmed(c: Color32) -> Color32 {
    let [r, g, b] = [c.r(), c.g(), c.b()].map(|x| (u16::from(x) * 3 / 4) as u8);
    Color32::from_rgb(r, g, b)
}
