//! Lead-in and lead-out: straight on along the line at the speed of the work, the laser off, so that the spot
//! has its speed when the laser goes on and keeps it until it is off. A contact tool comes to its line and leaves it by
//! a quarter arc in the plane of travel and normal, so that it leaves no dent where it sets down.
//!
//! The beam keeps its direction. A lead on which beam or head would touch something is left out, and counted.

use super::transfer_space::TransferSpace;
use crate::beam::WorkingMedium;
use crate::pose::Pass;
use crate::program::neutral::steps::Station;
use nalgebra::Vector3;

/// A lead, seen from the end of the lit piece that it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lead {
    /// The far end of the lead: where a lead-in begins, or a lead-out ends.
    pub at: Station,
    /// How long it takes, s.
    pub seconds: f64,
    /// How it goes there from the end of the piece; `None`: straight.
    pub arc: Option<QuarterArc>,
}

/// A quarter arc that begins along the line and ends square to it, off the part. The tool keeps its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuarterArc {
    /// Away from the piece, along the line, unit.
    pub along: Vector3<f64>,
    /// Off the part, unit, square to it.
    pub up: Vector3<f64>,
    /// Its radius, mm.
    pub radius_mm: f64,
}

/// Straight pieces that an arc is made of: 10° each. Their chords lie off the part.
const ARC_PIECES: u32 = 9;

impl QuarterArc {
    /// Where it leads after so many of its pieces, from the end of the line.
    fn after(&self, piece: u32) -> Vector3<f64> {
        let angle = f64::from(piece) / f64::from(ARC_PIECES) * std::f64::consts::FRAC_PI_2;
        (self.along * libm::sin(angle) + self.up * (1.0 - libm::cos(angle))) * self.radius_mm
    }

    /// Its length as it is gone, mm.
    fn length_mm(&self) -> f64 {
        f64::from(ARC_PIECES) * self.after(1).norm()
    }
}

/// How far from the end of the line each station of an arc is, from the nearest to the far end, mm.
pub fn arc_reaches_mm(radius_mm: f64) -> impl Iterator<Item = f64> {
    let arc = QuarterArc { along: Vector3::x(), up: Vector3::y(), radius_mm };
    (1..=ARC_PIECES).map(move |piece| arc.after(piece).norm())
}

impl Lead {
    /// Stations from the piece's end `from` out to the far end, which is the last, each with the time of its move, s.
    pub fn stations(&self, from: &Station) -> Vec<(Station, f64)> {
        let Some(arc) = &self.arc else { return vec![(self.at, self.seconds)] };
        let station = |piece| Station { x: from.x + arc.after(piece), ..*from };
        (1..=ARC_PIECES).map(|piece| (station(piece), self.seconds / f64::from(ARC_PIECES))).collect()
    }
}

/// The two leads of a lit piece, where they are wanted and free.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Leads {
    /// Before the laser goes on.
    pub before: Option<Lead>,
    /// After it went off.
    pub behind: Option<Lead>,
    /// How many of the two are wanted but not free.
    pub left_out: usize,
}

/// The leads of the lit piece of a pass from target `first` to `last`, which the beam stands at as given.
pub fn leads(
    space: &TransferSpace<'_>,
    pass: &Pass,
    (first, last): (usize, usize),
    [start, end]: [&Station; 2],
) -> Leads {
    let before = lead(space, pass, (first, first + 1), start, pass.settings.lead_in_mm);
    let behind = lead(space, pass, (last, last.saturating_sub(1)), end, pass.settings.lead_out_mm);
    let left_out = [&before, &behind].iter().filter(|l| matches!(l, Some(Err(())))).count();
    Leads { before: before.and_then(Result::ok), behind: behind.and_then(Result::ok), left_out }
}

/// The arc by which a contact tool leaves target `at`, away from target `inner`.
/// `None`: none is wanted; an error: it is not free.
fn arc_lead(
    space: &TransferSpace<'_>,
    pass: &Pass,
    (at, inner): (usize, usize),
    station: &Station,
) -> Option<Result<Lead, ()>> {
    let (end, radius_mm) = (pass.targets.get(at)?, pass.settings.arc_mm);
    let way = (end.p - pass.targets.get(inner)?.p).try_normalize(1e-9)?;
    let along = (way - end.n * end.n.dot(&way)).try_normalize(1e-9).filter(|_| radius_mm > 0.0)?;
    let arc = QuarterArc { along, up: end.n, radius_mm };
    let there = Station { x: station.x + arc.after(ARC_PIECES), ..*station };
    let lead = Lead { at: there, seconds: arc.length_mm() / pass.settings.speed_mm_s, arc: Some(arc) };
    let mut here = *station;
    let is_free = lead.stations(station).iter().all(|(next, _)| {
        let from = std::mem::replace(&mut here, *next);
        space.is_lead_free(&from, next, pass.settings.defocus_mm)
    });
    Some(if is_free { Ok(lead) } else { Err(()) })
}

/// The lead that goes straight on beyond target `at`, away from target `inner`.
/// `None`: none is wanted; an error: it is not free.
fn lead(
    space: &TransferSpace<'_>,
    pass: &Pass,
    (at, inner): (usize, usize),
    station: &Station,
    length_mm: f64,
) -> Option<Result<Lead, ()>> {
    if pass.settings.medium != WorkingMedium::Light {
        return arc_lead(space, pass, (at, inner), station);
    }
    let way = pass.targets.get(at)?.p - pass.targets.get(inner)?.p;
    let direction = way.try_normalize(1e-9).filter(|_| length_mm > 0.0)?;
    let there = Station { x: station.x + direction * length_mm, ..*station };
    let is_free = space.is_lead_free(station, &there, pass.settings.defocus_mm);
    Some(if is_free {
        Ok(Lead { at: there, seconds: length_mm / pass.settings.speed_mm_s, arc: None })
    } else {
        Err(())
    })
}
