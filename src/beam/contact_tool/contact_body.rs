//! The space that disc or belt take up, from the foot of the tool's axis: a core of cut cones, and by how much the tool
//! is larger all round.
//!
//! A disc whose edge is rounded with ρ is a flat disc of radius r − ρ, widened by ρ: so its distance from a facet is
//! the core's less ρ, to rounding, and no cone has to stand for the round edge.
//!
//! # What it may touch
//! A contact tool rests on the skin that it works on, so touching is no interference. It rests on a facet if the shortest
//! way from the facet to it goes up within 60° of the axis ([`REST_COSINE`]): into these it may reach by `gouge_mm` and
//! no farther, which is how it is found to touch beside its contact. All others, and clamps, stand beside it: from these
//! it keeps the margin. The way decides, and not the facet's own slope: the side of a plate, over whose rim a disc
//! sticks out, begins at that rim, which the disc rests on.

use super::grinding::{ContactPlace, Grinding};
use super::{Abrasive, ContactSide};
use crate::beam::Frustum;

/// A contact tool rests on a facet if the cosine between its axis and the shortest way from there to it is this at least.
/// Bracketed by a wall square to the skin straight ahead, which a disc of 30° lead meets at a cosine of 0.5, and by a
/// skin that slopes by 30° more than that lead within the disc's reach.
pub const REST_COSINE: f64 = 0.5;

/// A flat disc is given this height, mm: a cut cone needs one.
const FLAT_MM: f64 = 1e-3;

/// By how much a belt's core stands above its contact, mm. The core widened by that holds the belt.
const BELT_ROUND_MM: f64 = 0.5;

/// Cut cones that the round of a contact wheel is taken for; the lowest are the shortest. A wheel of 50 mm and a belt of
/// 20 mm are taken 0.5 mm too wide at most.
const BELT_CONES: u32 = 8;

/// Of what the tool is larger than its core, this share at most may be given away to gouging and to what a proof loses.
const MOST_GIVEN: f64 = 0.9;

/// Disc or belt at a pose of its foot.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactBody {
    /// Where the reference point stands.
    pub place: ContactPlace,
    /// The core, t measured from the foot along the axis.
    pub core: Vec<Frustum>,
    /// By how much the tool is larger, mm.
    pub round_mm: f64,
    /// What the core keeps from skin, mm.
    pub skin_mm: f64,
}

impl ContactBody {
    /// The body of a contact tool.
    pub fn new(grinding: &Grinding) -> ContactBody {
        let place = grinding.place();
        let (core, round_mm) = match grinding.tool.abrasive {
            Abrasive::Disc { radius_mm, edge_mm, thickness_mm, side } => {
                let low_mm = match side {
                    ContactSide::Rim => place.defocus_mm,
                    ContactSide::Face => edge_mm,
                };
                let high_mm = low_mm + (thickness_mm - 2.0 * edge_mm).max(FLAT_MM);
                let flat_mm = radius_mm - edge_mm;
                (vec![Frustum { t0_mm: low_mm, t1_mm: high_mm, r0_mm: flat_mm, r1_mm: flat_mm }], edge_mm)
            }
            Abrasive::Belt { radius_mm, width_mm } => (wheel(radius_mm, 0.5 * width_mm), BELT_ROUND_MM),
        };
        let skin_mm = round_mm - grinding.gouge_mm.clamp(0.0, MOST_GIVEN * round_mm);
        ContactBody { place, core, round_mm, skin_mm }
    }

    /// A body that keeps a little less from skin.
    pub fn eased(&self, less_mm: f64) -> ContactBody {
        let skin_mm = (self.skin_mm - less_mm).max((1.0 - MOST_GIVEN) * self.round_mm);
        ContactBody { skin_mm, ..self.clone() }
    }

    /// Measured from the reference point from now on, in place of the foot.
    pub fn measure_from_reference(&mut self) {
        let up_mm = std::mem::take(&mut self.place.defocus_mm);
        for cone in &mut self.core {
            (cone.t0_mm, cone.t1_mm) = (cone.t0_mm - up_mm, cone.t1_mm - up_mm);
        }
    }

    /// A body that touches nothing: it keeps a margin from skin.
    pub fn lifted_off(&self, margin_mm: f64) -> ContactBody {
        ContactBody { skin_mm: self.round_mm + margin_mm, ..self.clone() }
    }

    /// The greatest distance of any of its points from the axis, mm.
    pub fn radius_mm(&self) -> f64 {
        self.core.iter().map(|f| f.r0_mm.max(f.r1_mm)).fold(0.0, f64::max) + self.round_mm
    }
}

/// What a wheel sweeps that is turned about the normal through its contact: its travel is free. At the height h it
/// reaches `√(2 r h − h² + (w/2)²)` far, up to its axle, and no less above. That bends outwards, so tangents hold it.
fn wheel(radius_mm: f64, half_mm: f64) -> Vec<Frustum> {
    let reach = |h: f64| (2.0 * radius_mm * h - h * h + half_mm * half_mm).max(0.0).sqrt();
    let height = |i: u32| {
        let share = f64::from(i) / f64::from(BELT_CONES);
        radius_mm * share * share
    };
    let mut out: Vec<Frustum> = (0..BELT_CONES)
        .map(|i| {
            let (h0, h1) = (height(i), height(i + 1));
            let middle = 0.5 * (h0 + h1);
            let slope = (radius_mm - middle) / reach(middle);
            let tangent = |h: f64| reach(middle) + slope * (h - middle);
            let (t0_mm, t1_mm) = (h0 + BELT_ROUND_MM, h1 + BELT_ROUND_MM);
            Frustum { t0_mm, t1_mm, r0_mm: tangent(h0), r1_mm: tangent(h1) }
        })
        .collect();
    let widest = reach(radius_mm);
    let (t0_mm, t1_mm) = (radius_mm + BELT_ROUND_MM, 2.0 * radius_mm + BELT_ROUND_MM);
    out.push(Frustum { t0_mm, t1_mm, r0_mm: widest, r1_mm: widest });
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cones_of_a_wheel_hold_it_and_little_more() {
        let (r, half) = (50.0, 10.0);
        let cones = wheel(r, half);
        assert!(cones.windows(2).all(|w| w[0].t1_mm == w[1].t0_mm));
        for i in 0..=1000 {
            let h = 2.0 * r * f64::from(i) / 1000.0;
            let around = cones.iter().filter(|f| (f.t0_mm..=f.t1_mm).contains(&(h + BELT_ROUND_MM)));
            let at = |f: &Frustum| {
                let share = (h + BELT_ROUND_MM - f.t0_mm) / (f.t1_mm - f.t0_mm);
                f.r0_mm + (f.r1_mm - f.r0_mm) * share
            };
            let wide = around.map(at).fold(0.0, f64::max);
            let reach = (2.0 * r * h - h * h + half * half).max(0.0).sqrt();
            assert!(wide >= reach - 1e-9, "{h}: {wide} {reach}");
            assert!(h > r || wide <= reach + 0.5, "{h}: {wide} {reach}");
        }
    }
}
