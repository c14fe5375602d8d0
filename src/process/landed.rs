//! The energy that lands at a point: of one piece of the light, and summed over pieces.

use super::light::Light;
use super::lit_facets::NearPiece;
use super::shade::{LastShade, Shade, SurfacePoint};
use crate::pose::Obstruction;
use nalgebra::Vector3;

/// 1 J/mm² in J/cm².
pub const J_CM2: f64 = 100.0;

/// Energy that lands at one point, summed over pieces of the light.
#[derive(Default)]
pub(super) struct DoseSum {
    pub(super) j_mm2: f64,
    pub(super) unshaded_j_mm2: f64,
    pub(super) angle_j: f64,
    last_pass: Option<u32>,
    pub(super) passes: u16,
    /// What shades it, and how much energy each keeps off, J/mm².
    pub(super) walls: Vec<(Obstruction, f64)>,
}

impl DoseSum {
    /// Adds the energy of one piece.
    pub(super) fn add(&mut self, landed: &Landed) {
        self.unshaded_j_mm2 += landed.unshaded_j_mm2;
        self.j_mm2 += landed.j_mm2;
        self.angle_j += landed.j_mm2 * landed.angle_deg;
        if landed.covered && landed.j_mm2 > 0.0 && self.last_pass != Some(landed.pass) {
            self.last_pass = Some(landed.pass);
            self.passes = self.passes.saturating_add(1);
        }
        if let Some(wall) = landed.by {
            let lost = landed.unshaded_j_mm2 - landed.j_mm2;
            match self.walls.iter_mut().find(|(w, _)| *w == wall) {
                Some((_, j)) => *j += lost,
                None => self.walls.push((wall, lost)),
            }
        }
    }
}

/// The energy of one piece of the light that lands at a point.
pub(super) struct Landed {
    pub(super) pass: u32,
    pub(super) at_s: f64,
    pub(super) unshaded_j_mm2: f64,
    pub(super) j_mm2: f64,
    pub(super) angle_deg: f64,
    /// The spot itself went over it.
    pub(super) covered: bool,
    pub(super) by: Option<Obstruction>,
}

/// The energy of one piece that lands at a point, `normal` towards the side that is worked on; `None` where none comes.
pub(super) fn landed(
    light: &Light,
    shade: &Shade<'_>,
    near: &NearPiece,
    at: &SurfacePoint,
    normal: &Vector3<f64>,
    last: &mut LastShade,
) -> Option<Landed> {
    let piece = light.pieces.get(near.piece as usize)?;
    let passing = light.passing(piece, &at.p)?;
    let when = passing.seen.nearest.clamp(passing.window[0], passing.window[1]);
    let axis = piece.axis(when);
    let cosine = axis.dot(normal);
    if cosine <= 0.0 {
        return None;
    }
    let (share, by) = if near.clear {
        (1.0, None)
    } else {
        let l = shade.landing(light, piece, at, &passing, last);
        (l.share, l.by)
    };
    let unshaded_j_mm2 = passing.j_mm2 * cosine;
    Some(Landed {
        pass: piece.pass,
        at_s: piece.ends_s - piece.seconds * (1.0 - when),
        unshaded_j_mm2,
        j_mm2: unshaded_j_mm2 * share,
        angle_deg: libm::atan2(axis.cross(normal).norm(), cosine).to_degrees(),
        covered: light.spot(piece).covers(passing.seen.at(when), passing.seen.z_mm),
        by,
    })
}
