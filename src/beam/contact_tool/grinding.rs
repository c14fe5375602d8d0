//! A contact tool as it is led over a surface: its lead, its force, its arcs, and where its reference point stands at a
//! point of contact.
//!
//! # Where the disc touches
//! Surface normal n, travel t, lead τ: the axis is `a = n cos τ + t sin τ`, and `o = t cos τ − n sin τ` is square to it.
//! The disc's edge is rounded with ρ about a ring of radius r − ρ. Of that ring, in the plane square to a, the point
//! farthest along −n is the one along +o for τ > 0, since `−n·o = sin τ > 0`: the disc leans forward and touches with
//! its *leading* rim. (A tool that is to touch on its trailing side leans back: τ < 0.) So for the contact p the ring's
//! centre is `C = p + ρ·n − (r − ρ)·o = p + ρ·n + (r − ρ)·(n sin τ − t cos τ)`, the formula of P4's tool, and with
//! `n = a cos τ − o sin τ`
//!
//! `C = p + D·a − B·o`, `D = ρ cos τ`, `B = r − ρ + ρ sin τ`.
//!
//! For τ < 0 the same holds with the ring's opposite point: `B = −(r − ρ) + ρ sin τ`. D and B do not depend on where
//! p is; `p − B·o` is the *foot* of the tool's axis. It is told by n and a alone, since `o sin τ` is what is left of −n
//! square to a, and a turn about the axis leaves it where it is.

use super::{Abrasive, ContactSide, ContactTool};
use crate::part::{angle, keyed};
use nalgebra::{Point3, Vector3};

/// A contact tool and how it is led.
#[derive(Clone, Debug, PartialEq)]
pub struct Grinding {
    /// The tool.
    pub tool: ContactTool,
    /// Lead τ, degrees: how far the axis leans forward from the surface normal. A disc that touches with its rim needs
    /// one; all others stand upright, and it is not looked at. Up to 30°, so that a wall square to the surface ahead is
    /// told from the skin.
    pub lead_deg: f64,
    /// Radius of the quarter arcs by which it comes to a line and leaves it, mm; 0: none.
    pub arc_mm: f64,
    /// Force against the surface, N; 0: the controller keeps none.
    pub force_n: f64,
    /// How far it may reach into the skin beside its contact, mm: 0.05 mm for the facets that stand for a curved
    /// surface, and the chord error of its lines, since on a chord the tool runs that deep in a convex surface.
    pub gouge_mm: f64,
}

keyed!(Grinding { tool, lead_deg, arc_mm, force_n, gouge_mm });

/// Where the reference point of a contact tool stands, in the frame of contact, axis and travel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactPlace {
    /// τ, degrees.
    pub lead_deg: f64,
    /// D: from the foot to the reference point along the axis, mm.
    pub defocus_mm: f64,
    /// B: the foot of the axis lies so far behind the contact, against o, mm.
    pub behind_mm: f64,
}

impl Grinding {
    /// Where the reference point stands.
    pub fn place(&self) -> ContactPlace {
        let Abrasive::Disc { radius_mm, edge_mm, side: ContactSide::Rim, .. } = self.tool.abrasive else {
            return ContactPlace::default();
        };
        let lead = self.lead_deg.to_radians();
        let ring_mm = if lead < 0.0 { edge_mm - radius_mm } else { radius_mm - edge_mm };
        ContactPlace {
            lead_deg: self.lead_deg,
            defocus_mm: edge_mm * libm::cos(lead),
            behind_mm: ring_mm + edge_mm * libm::sin(lead),
        }
    }

    /// The radius of a concave skin, across the travel, that a disc's rim just fits into, mm: seen along the travel the
    /// ring is an ellipse of half axes R = r − ρ and R sin τ, whose widest curvature is R / sin τ, and the edge adds ρ.
    /// `None`: its contact is flat, or a line.
    pub fn effective_radius_mm(&self) -> Option<f64> {
        let Abrasive::Disc { radius_mm, edge_mm, side: ContactSide::Rim, .. } = self.tool.abrasive else { return None };
        let sine = libm::sin(self.lead_deg.to_radians()).abs();
        Some((radius_mm - edge_mm) / sine + edge_mm)
    }
}

impl ContactPlace {
    /// The tool's axis where it touches a surface of unit normal `n`, going along the unit `t` square to it.
    pub fn axis(&self, n: &Vector3<f64>, t: &Vector3<f64>) -> Vector3<f64> {
        let lead = self.lead_deg.to_radians();
        n * libm::cos(lead) + t * libm::sin(lead)
    }

    /// The foot of the axis `a` for a contact at `p` on a surface of normal `n`.
    pub fn foot(&self, p: &Point3<f64>, n: &Vector3<f64>, a: &Vector3<f64>) -> Point3<f64> {
        if self.behind_mm == 0.0 {
            return *p;
        }
        // Both lead and B change their sign together, so that the foot lies up the normal from the contact.
        angle::unit(n - a * a.dot(n)).map_or(*p, |up| p + up * self.behind_mm.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn disc(radius_mm: f64, edge_mm: f64, lead_deg: f64) -> Grinding {
        let side = ContactSide::Rim;
        let abrasive = Abrasive::Disc { radius_mm, edge_mm, thickness_mm: 2.0 * edge_mm, side };
        let tool = ContactTool { abrasive, stack: Vec::new() };
        Grinding { tool, lead_deg, arc_mm: 0.0, force_n: 0.0, gouge_mm: 0.05 }
    }

    proptest! {
        /// The ring's centre by the formula, and a torus about it that touches the plane in the contact and nowhere else.
        #[test]
        fn the_disc_touches_the_plane_in_its_contact(
            r in 10.0..100.0f64, edge in 0.5..5.0f64, lead in 2.0..30.0f64, back in prop::bool::ANY, turn in 0.0..std::f64::consts::TAU
        ) {
            let grinding = disc(r, edge, if back { -lead } else { lead });
            let place = grinding.place();
            let (n, t) = (Vector3::z(), Vector3::new(libm::cos(turn), libm::sin(turn), 0.0));
            let p = Point3::new(3.0, -2.0, 7.0);
            let a = place.axis(&n, &t);
            let tau = grinding.lead_deg.to_radians();
            let o = t * libm::cos(tau) - n * libm::sin(tau);
            let centre = place.foot(&p, &n, &a) + a * place.defocus_mm;
            prop_assert!((centre - (p + a * place.defocus_mm - o * place.behind_mm)).norm() < 1e-9);
            if !back {
                let told = p + n * edge + (n * libm::sin(tau) - t * libm::cos(tau)) * (r - edge);
                prop_assert!((centre - told).norm() < 1e-9, "{centre} {told}");
            }
            // The ring, point by point: its edge's lowest points are ρ below it.
            let b = a.cross(&o);
            let ring = |angle: f64| centre + (o * libm::cos(angle) + b * libm::sin(angle)) * (r - edge);
            let touching = if back { std::f64::consts::PI } else { 0.0 };
            prop_assert!((ring(touching).z - edge - p.z).abs() < 1e-9);
            prop_assert!((ring(touching) - n * edge - p).norm() < 1e-9, "it touches in p itself");
            for k in 1..36 {
                let height = ring(touching + f64::from(k) * std::f64::consts::PI / 18.0).z - edge - p.z;
                prop_assert!(height > 0.0, "{height}");
            }
            // The contact lies ahead of the centre for a lead forward, behind it for one backward.
            prop_assert_eq!((p - centre).dot(&t) > 0.0, !back);
        }
    }

    #[test]
    fn what_touches_flat_stands_in_its_contact() {
        let mut grinding = disc(50.0, 3.0, 15.0);
        grinding.tool.abrasive = Abrasive::Belt { radius_mm: 40.0, width_mm: 20.0 };
        assert_eq!((grinding.place(), grinding.effective_radius_mm()), (ContactPlace::default(), None));
        assert_eq!(grinding.place().axis(&Vector3::z(), &Vector3::x()), Vector3::z());
    }
}
