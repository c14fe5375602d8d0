//! Tool geometry: the space that beam and head take up at a pose, as cut cones about the axis, from the
//! point on the part upwards; or what a contact tool takes up, from the foot of its axis upwards.
//!
//! # The spot's own neighbourhood
//! A beam of any width touches the surface that it works on. What it is allowed to be near is decided by
//! direction, not by distance: beam and margin together count only within [`OWN_CONE_DEG`] of the axis
//! as seen from the spot. Facets that the spot stands on or beside are outside of that cone as long as
//! the beam stands more steeply on them than the cone's half angle; a wall 0.2 mm away enters it at a
//! height of 0.2/tan 15° = 0.75 mm, and is seen.

use super::HeadPart;
use super::frustum::Frustum;
use super::head::Head;
use super::optics::Optics;
use super::{ContactBody, Obstacle, Standing, Tool};

/// Half angle of the cone within which beam and margin count, degrees.
///
/// Bracketed from below by a wall 1 mm high 0.2 mm beside the spot, which must be seen (11.4°); from
/// above by the root of a V-groove of 60°, which a beam along the bisector must reach (30°), and by a
/// fillet as narrow as spot and margin, whose bottom is no obstacle (45°).
pub const OWN_CONE_DEG: f64 = 15.0;

/// Its tangent.
pub(crate) const OWN_SLOPE: f64 = 0.267_949_192_431_122_7;

/// Its sine.
pub(crate) const OWN_SINE: f64 = 0.258_819_045_102_520_74;

/// Height above the spot from which on the beam is checked, mm: below it even that cone is within the
/// rounding of f32 coordinates on a large part.
pub(crate) const START_MM: f64 = 0.05;

/// Beam and head of a tool, and the clamps that they must miss, prepared for queries at many poses.
#[derive(Clone, Debug)]
pub struct ToolGeometry<'a> {
    /// Defocus distance, mm.
    pub defocus_mm: f64,
    /// Clearance that beam and head keep from everything, mm.
    pub margin_mm: f64,
    /// What of that is the tool's slack: how far the part may lie off where it is taken to be, mm. A contact tool does not
    /// keep it from skin that it is pressed onto, wherever that lies.
    pub slack_mm: f64,
    /// The beam, wider by the margin, within the cone of its own neighbourhood; empty without a head, where the ray is
    /// all there is of it.
    pub beam: Vec<Frustum>,
    /// The head, as it is.
    pub head: Vec<Frustum>,
    /// Clamps on the part, in its frame: they stand in the way, and are no part of the tool.
    pub clamps: Vec<Standing<'a>>,
    /// Whether there is a head, or a contact tool; without one the beam is a ray, and keeps no margin.
    pub has_head: bool,
    /// What grinds: then there is neither beam nor ray, and the head is what is mounted behind it.
    pub contact: Option<ContactBody>,
    /// The beam's radius along t, mm: the corners of a polyline (t, radius).
    profile: Vec<(f64, f64)>,
    own: OwnCone,
    /// A motion on which the tool moves no farther than this to either side is judged by its middle, mm: it may
    /// cost a tenth of the margin. Eased copies keep this value, so that all of them divide a motion alike.
    pub short_mm: f64,
}

/// The cone of the spot's own neighbourhood.
#[derive(Clone, Copy, Debug, PartialEq)]
struct OwnCone {
    /// Tangent of its half angle.
    slope: f64,
    /// Where along t the check of the beam begins, mm.
    start_mm: f64,
}

impl OwnCone {
    const WHOLE: OwnCone = OwnCone { slope: OWN_SLOPE, start_mm: START_MM };
}

impl<'a> ToolGeometry<'a> {
    /// The tool of a job. It keeps `margin_mm`, and the tool's slack on top of it. `spot_mm` is the spot's diameter on the
    /// part at the defocus distance.
    /// `None`: the beam is a ray, and nothing is clamped on. A contact tool takes the place of beam and head; its defocus
    /// distance is that of its `ContactPlace`.
    pub fn new(
        tool: &'a Tool,
        optics: &Optics,
        spot_mm: f64,
        defocus_mm: f64,
        margin_mm: f64,
    ) -> Option<ToolGeometry<'a>> {
        if tool.head.is_none() && tool.contact.is_none() && tool.clamps.is_empty() {
            return None;
        }
        let contact = tool.contact.as_ref().map(ContactBody::new);
        let shifted = |p: &HeadPart| Frustum {
            t0_mm: p.from_mm + defocus_mm,
            t1_mm: p.to_mm + defocus_mm,
            r0_mm: p.r0_mm,
            r1_mm: p.r1_mm,
        };
        let has_head = tool.head.is_some() || contact.is_some();
        // A ray asks for itself: as a thin cone without end it would be as wide on a turn as it gets at that end.
        let has_beam = has_head && contact.is_none();
        let profile = if has_beam { profile(optics, spot_mm, defocus_mm) } else { Vec::new() };
        let stack = match &tool.contact {
            Some(grinding) => &grinding.tool.stack[..],
            None => tool.head.as_ref().map_or(&[][..], Head::stack),
        };
        let margin_mm = if has_head { margin_mm + tool.slack_mm } else { 0.0 };
        Some(ToolGeometry {
            defocus_mm,
            margin_mm,
            slack_mm: if has_head { tool.slack_mm } else { 0.0 },
            beam: widened(&profile, margin_mm, OwnCone::WHOLE),
            own: OwnCone::WHOLE,
            short_mm: (0.1 * margin_mm).max(0.02),
            head: stack.iter().map(shifted).collect(),
            clamps: tool.clamps.iter().map(Obstacle::standing).collect(),
            has_head,
            contact,
            profile,
        })
    }

    /// The head of a tool alone, measured from its focus: what moves with the laser off. Of a contact tool all of it,
    /// measured from its reference point; it may touch the skin, which it comes from. `None` without either.
    pub fn head_alone(tool: &'a Tool, margin_mm: f64) -> Option<ToolGeometry<'a>> {
        if tool.head.is_none() && tool.contact.is_none() {
            return None;
        }
        let mut body = ToolGeometry::new(tool, &Optics::default(), 1.0, 0.0, margin_mm)?;
        if let Some(contact) = &mut body.contact {
            contact.measure_from_reference();
        }
        Some(ToolGeometry { beam: Vec::new(), ..body })
    }

    /// A contact tool that keeps its margin from skin as well, on its way through the air. `None` for all other tools.
    pub fn lifted_off(&self) -> Option<ToolGeometry<'a>> {
        let contact = self.contact.as_ref()?.lifted_off(self.margin_mm);
        Some(ToolGeometry { contact: Some(contact), ..self.clone() })
    }

    /// A geometry that keeps a little less: `less_mm` of its margin (a contact tool may reach so much farther into skin), and
    /// `steps` times half a degree of the cone of its own neighbourhood. So what just passes with the one does not just hit
    /// with the other.
    pub fn eased(&self, less_mm: f64, steps: u8) -> ToolGeometry<'a> {
        let margin_mm = (self.margin_mm - less_mm).max(0.0);
        let own = OwnCone {
            slope: libm::tan((OWN_CONE_DEG - 0.5 * f64::from(steps)).to_radians()),
            start_mm: START_MM * (1.0 + 0.5 * f64::from(steps)),
        };
        let contact = self.contact.as_ref().map(|c| c.eased(less_mm));
        ToolGeometry { margin_mm, beam: widened(&self.profile, margin_mm, own), own, contact, ..self.clone() }
    }

    /// The beam with another margin.
    pub fn beam_with(&self, margin_mm: f64) -> Vec<Frustum> {
        widened(&self.profile, margin_mm, self.own)
    }
}

/// Spot, waist and aperture joined by straight lines: outside of the beam's own curve, which bends
/// outwards.
fn profile(optics: &Optics, spot_mm: f64, defocus_mm: f64) -> Vec<(f64, f64)> {
    let mut out = vec![(0.0, 0.5 * spot_mm)];
    if defocus_mm > 0.0 {
        out.push((defocus_mm, 0.5 * optics.focus_spot_mm));
    }
    out.push((defocus_mm + optics.lens_to_focus_mm, 0.5 * optics.aperture_mm));
    out
}

/// A beam wider by the margin, but no wider than the cone of its own neighbourhood.
fn widened(profile: &[(f64, f64)], margin_mm: f64, own: OwnCone) -> Vec<Frustum> {
    let mut out = Vec::new();
    for w in profile.windows(2) {
        let ((t0, r0), (t1, r1)) = (w[0], w[1]);
        let start = t0.max(own.start_mm);
        if t1 <= start {
            continue;
        }
        let slope = (r1 - r0) / (t1 - t0);
        // Where the widened beam and the cone are equally wide.
        let even = (r0 + margin_mm - slope * t0) / (own.slope - slope);
        let mut stops = vec![start];
        stops.extend([even].into_iter().filter(|t| *t > start && *t < t1));
        stops.push(t1);
        let radius = |t: f64| (r0 + slope * (t - t0) + margin_mm).min(own.slope * t);
        out.extend(stops.windows(2).map(|s| Frustum {
            t0_mm: s[0],
            t1_mm: s[1],
            r0_mm: radius(s[0]),
            r1_mm: radius(s[1]),
        }));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_is_that_of_the_angle() {
        assert_eq!(OWN_SLOPE, libm::tan(OWN_CONE_DEG.to_radians()));
        assert_eq!(OWN_SINE, libm::sin(OWN_CONE_DEG.to_radians()));
    }

    #[test]
    fn the_cone_has_no_gap_and_keeps_to_both_bounds() {
        let tool = Tool { head: Some(Head::Stack(Vec::new())), ..Tool::default() };
        for defocus_mm in [-15.0, 0.0, 20.0] {
            let body = ToolGeometry::new(&tool, &Optics::default(), 1.0, defocus_mm, 0.5).expect("a head");
            assert!(body.beam.windows(2).all(|w| (w[0].t1_mm, w[0].r1_mm) == (w[1].t0_mm, w[1].r0_mm)));
            let last = body.beam[body.beam.len() - 1];
            assert!((last.t1_mm - defocus_mm - 200.0).abs() < 1e-9 && (last.r1_mm - 5.5).abs() < 1e-9);
            for f in &body.beam {
                assert!(f.r0_mm <= OWN_SLOPE * f.t0_mm + 1e-12 && f.r1_mm <= OWN_SLOPE * f.t1_mm + 1e-12);
            }
            let waist = body.beam.iter().map(|f| f.r0_mm).skip(1).fold(f64::INFINITY, f64::min);
            assert!(defocus_mm <= 0.0 || (waist - 0.55).abs() < 1e-9, "{waist}");
        }
    }
}
