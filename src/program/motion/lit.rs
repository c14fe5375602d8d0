//! Stations between targets: between two of them the controller moves the flange straight, and the spot a little
//! beside its line.

use super::spot::planned_spot;
use super::sweep::{LitMove, Prover};
use crate::beam::ProcessSettings;
use crate::cell::motion::{RefusalCause, RefusalReason};
use crate::pose::motion::Swept;
use crate::program::neutral::steps::Station;
use nalgebra::Isometry3;

/// What keeps a lit move of the flange to the planned line of the spot.
#[derive(Clone, Debug)]
pub struct StraightFlange<'a> {
    /// Part and frames, and what sweeps a move that keeps to its line.
    pub prover: Prover<'a>,
    /// How far the spot may leave its line, mm.
    pub deviation_mm: f64,
    /// What a move should take at least, s.
    pub least_move_s: f64,
}

/// A move is cut in halves at most so often: 64 pieces.
const MOST_HALVINGS: usize = 6;

impl StraightFlange<'_> {
    /// Stations to be put between two targets, with their shares of the way that takes so many seconds: none where
    /// the flange may go straight.
    ///
    /// # Errors
    /// Even the shortest pieces leave the line, or hit something.
    pub fn stations_between(
        &self,
        from: &Station,
        to: &Station,
        settings: &ProcessSettings,
        seconds: f64,
    ) -> Result<Vec<(f64, Station)>, (RefusalCause, RefusalReason)> {
        let mut out = Vec::new();
        self.push_stations((from, 0.0), (to, 1.0), (settings, MOST_HALVINGS), &mut out)?;
        let ends: Vec<f64> = std::iter::once(0.0).chain(out.iter().map(|s| s.0)).chain([1.0]).collect();
        let shortest = ends.windows(2).map(|w| w[1] - w[0]).fold(1.0, f64::min);
        // Halves of halves may be shorter than pieces of one length need be.
        let alike = if out.is_empty() || shortest * seconds >= self.least_move_s {
            None
        } else {
            self.stations_alike(from, to, settings, (seconds / self.least_move_s).min(out.len() as f64) as usize)
        };
        Ok(alike.unwrap_or(out))
    }

    /// Stations that make so many pieces of one length; `None` where even these leave the line, or hit something.
    fn stations_alike(
        &self,
        from: &Station,
        to: &Station,
        settings: &ProcessSettings,
        pieces: usize,
    ) -> Option<Vec<(f64, Station)>> {
        let share = |k: usize| k as f64 / pieces as f64;
        let between: Vec<(f64, Station)> =
            (1..pieces).map(|k| (share(k), self.between(from, to, share(k), settings))).collect();
        let all: Vec<&Station> = std::iter::once(from).chain(between.iter().map(|s| &s.1)).chain([to]).collect();
        let keeps = |w: &[&Station]| {
            self.deviation(w[0], w[1], settings) <= self.deviation_mm && self.beam_hits(w[0], w[1], settings).is_none()
        };
        (pieces > 1 && all.windows(2).all(keeps)).then_some(between)
    }

    fn push_stations(
        &self,
        from: (&Station, f64),
        to: (&Station, f64),
        (settings, halvings): (&ProcessSettings, usize),
        out: &mut Vec<(f64, Station)>,
    ) -> Result<(), (RefusalCause, RefusalReason)> {
        let off_mm = self.deviation(from.0, to.0, settings);
        let keeps = off_mm <= self.deviation_mm;
        let met = if keeps { self.beam_hits(from.0, to.0, settings) } else { None };
        if keeps && met.is_none() {
            return Ok(());
        }
        if halvings == 0 {
            return Err(match met {
                Some(Swept { pose, blocker: hit, .. }) => {
                    (RefusalCause::of_blocker(&hit), RefusalReason::HitOnMove { spot_mm: pose.p.into(), hit })
                }
                // Only from far away does the turn of the flange move the spot so much.
                None => (RefusalCause::Reach, RefusalReason::OffLine { off_mm }),
            });
        }
        let (middle, t) = (self.between(from.0, to.0, 0.5, settings), 0.5 * (from.1 + to.1));
        self.push_stations(from, (&middle, t), (settings, halvings - 1), out)?;
        out.push((t, middle));
        self.push_stations((&middle, t), to, (settings, halvings - 1), out)
    }

    /// What beam or head hits on a lit move, as the flange goes.
    fn beam_hits(&self, from: &Station, to: &Station, settings: &ProcessSettings) -> Option<Swept> {
        let [from, to] = [from, to].map(|s| self.prover.mounted.flange_for(&s.frame()));
        // Who cancels takes no stations.
        self.prover.hit(&LitMove { from, to, by_focus: false, settings: *settings }).unwrap_or(None)
    }

    /// At a share of the planned motion: the spot straight, the frame turned at constant rate.
    fn between(&self, from: &Station, to: &Station, share: f64, settings: &ProcessSettings) -> Station {
        let (a, b) = (from.frame(), to.frame());
        let [start, end] = [&a, &b].map(|frame| planned_spot(frame, settings.defocus_mm));
        let mut station = Station::at(&Isometry3::from_parts(a.translation, a.rotation.slerp(&b.rotation, share)));
        station.x = start + (end - start) * share + station.a * settings.defocus_mm;
        station
    }

    /// How far the spot leaves the straight line where the flange goes straight, mm.
    fn deviation(&self, from: &Station, to: &Station, settings: &ProcessSettings) -> f64 {
        let (a, b) = (self.prover.mounted.flange_for(&from.frame()), self.prover.mounted.flange_for(&to.frame()));
        let (start, end) =
            (planned_spot(&from.frame(), settings.defocus_mm), planned_spot(&to.frame(), settings.defocus_mm));
        let line = end - start;
        let length2 = line.norm_squared();
        [0.25, 0.5, 0.75]
            .into_iter()
            .map(|t| {
                let spot = planned_spot(&self.prover.mounted.focus_for(&a.lerp_slerp(&b, t)), settings.defocus_mm);
                let along = if length2 > 0.0 { ((spot - start).dot(&line) / length2).clamp(0.0, 1.0) } else { 0.0 };
                (spot - (start + line * along)).norm()
            })
            .fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Setup;
    use crate::document::Job;
    use crate::part::{Part, Placement, Units};
    use crate::planning::proof::prover;
    use crate::sample::{solids, stl_bytes};
    use nalgebra::{Point3, Vector3};

    /// A station above a place of the part, with the path turned about the beam.
    fn station([x, y]: [f64; 2], deg: f64, settings: &ProcessSettings) -> Station {
        let (sin, cos) = libm::sincos(deg.to_radians());
        Station { x: Point3::new(x, y, 20.0 + settings.defocus_mm), a: Vector3::z(), o: Vector3::new(-sin, cos, 0.0) }
    }

    #[test]
    fn far_from_the_flange_the_spot_leaves_its_line_and_nothing_is_singular() {
        let bytes = stl_bytes(&solids::cube(20.0));
        let part = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]).expect("ok");
        let (setup, job) = (Setup::shipped().expect("shipped"), Job::default());
        let prover = prover(&part, &setup, &job);
        let straight = StraightFlange { prover, deviation_mm: 0.1, least_move_s: 1e-4 };
        let settings = ProcessSettings { defocus_mm: job.beam.defocus_mm, ..ProcessSettings::default() };
        // Even of a 64th of the turn the middle is 5e6 mm · (8°/64)²/8 = 3 mm off.
        let [from, to] = [0.0, 8.0].map(|deg| station([5e6, 5e6], deg, &settings));
        let refused = straight.stations_between(&from, &to, &settings, 1.0);
        assert!(
            matches!(refused, Err((RefusalCause::Reach, RefusalReason::OffLine { off_mm })) if off_mm > 1.0),
            "{refused:?}"
        );
    }

    /// A turn about the beam of the part in hand: the flange stands far from the spot, which so leaves its line.
    fn stations(least_move_s: f64, turn_deg: f64, seconds: f64) -> (Vec<f64>, Option<Vec<(f64, Station)>>) {
        let bytes = stl_bytes(&solids::cube(20.0));
        let part = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]).expect("ok");
        let (setup, job) = (Setup::shipped().expect("shipped"), Job::default());
        let straight = StraightFlange { prover: prover(&part, &setup, &job), deviation_mm: 0.1, least_move_s };
        let settings = ProcessSettings { defocus_mm: job.beam.defocus_mm, ..ProcessSettings::default() };
        let (from, to) = (station([8.0, 5.0], 0.0, &settings), station([9.0, 5.0], turn_deg, &settings));
        let between = straight.stations_between(&from, &to, &settings, seconds).expect("free");
        let ends: Vec<f64> = std::iter::once(0.0).chain(between.iter().map(|s| s.0)).chain([1.0]).collect();
        let alike = straight.stations_alike(&from, &to, &settings, (seconds / least_move_s) as usize);
        (ends.windows(2).map(|w| (w[1] - w[0]) * seconds).collect(), alike)
    }

    #[test]
    fn pieces_are_as_long_as_a_move_should_take_where_the_spot_keeps_to_its_line() {
        let (mut shorter, mut alike) = (0, 0);
        for turn_deg in [20.0, 26.0, 32.0, 40.0] {
            let halves = stations(1e-4, turn_deg, 1.0).0.len();
            assert!(halves.is_power_of_two() && halves > 1, "an even turn is halved evenly: {halves}");
            for pieces in 2..=halves {
                // So long that just so many moves fit in.
                let (seconds, fits) = stations(1.0 / (pieces as f64 + 0.5), turn_deg, 1.0);
                let is_short = seconds.iter().any(|s| *s < 1.0 / (pieces as f64 + 0.5));
                assert_eq!(is_short, fits.is_none() && pieces < halves, "{turn_deg} in {pieces} of {halves}");
                (shorter, alike) = (shorter + usize::from(is_short), alike + usize::from(seconds.len() < halves));
            }
        }
        assert!(shorter > 0 && alike > 0, "{shorter} {alike}");
    }
}
