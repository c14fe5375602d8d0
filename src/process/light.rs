//! The light of a plan: moves of the spot with the laser on, cut into pieces on which the beam hardly turns, and
//! the energy that a piece brings to a point if nothing shades it.
//!
//! On a piece the spot goes straight and the axis turns evenly. Seen from a point, the axis then goes
//! by in a straight line, at every height above and below the spot, and neighbouring pieces join.

use super::light_piece::{BeamFrame, LightPiece, SeenPoint};
use super::spot::Spot;
use super::way_time::{WayTime, lit_way_times};
use crate::beam::ProcessSettings;
use crate::part::angle;
use crate::pose::Pass;
use nalgebra::Point3;

/// Greatest turn of the beam on a piece, degrees: 30 mm from the spot the path of its axis then bends by
/// 0.02 mm.
const TURN_DEG: f64 = 4.0;
/// Moves that follow one another are one piece as long as the targets between lie on the way, to this
/// share of the spot, and the axes there to this angle.
const STRAIGHT_SPOTS: f64 = 0.005;
/// That angle, degrees: 0.1 mm at 30 mm from the spot.
const EVEN_DEG: f64 = 0.2;
/// Moves of one piece are as fast as each other, to this share.
const EVEN_SPEED: f64 = 0.01;
/// Greatest length of a piece, in spots, so that what is near a piece is not far from its middle.
const LENGTH_SPOTS: f64 = 3.0;
/// Pieces are not cut shorter than this for that reason, mm.
const LENGTH_MM: f64 = 1.0;
/// Greatest turn of the beam over a run of successive pieces that are processed together, degrees.
const RUN_TURN_DEG: f64 = 8.0;
/// Share of the energy in the middle of one line below which a piece is neglected at a point.
const NEGLIGIBLE: f64 = 1e-5;

/// The energy that one piece brings to a point if nothing shades it.
#[derive(Clone, Copy, Debug)]
pub struct Passing {
    /// The point as seen.
    pub seen: SeenPoint,
    /// From when to when it is in the light, as shares of the way.
    pub window: [f64; 2],
    /// Energy per area square to the beam, J/mm².
    pub j_mm2: f64,
}

/// All lit moves of a plan.
#[derive(Clone, Debug)]
pub struct Light {
    /// In the order of the program.
    pub pieces: Vec<LightPiece>,
    /// Pieces that follow one another and lie near together: where each such run ends in `pieces`.
    pub runs: Vec<u32>,
    /// Spots and powers of the passes.
    pub spots: Vec<SpotAndPower>,
}

/// A spot and its power.
#[derive(Clone, Debug)]
pub struct SpotAndPower {
    settings: ProcessSettings,
    /// The spot.
    pub spot: Spot,
    /// Below this, J/mm², a piece is neglected at a point.
    negligible_j_mm2: f64,
}

impl SpotAndPower {
    fn new(settings: ProcessSettings, spot: &Spot) -> SpotAndPower {
        let spot = Spot { spot_mm: settings.spot_mm, defocus_mm: settings.defocus_mm, ..*spot };
        SpotAndPower {
            settings,
            negligible_j_mm2: NEGLIGIBLE * settings.power_w / (settings.speed_mm_s * settings.spot_mm),
            spot,
        }
    }
}

impl Light {
    /// The light of these passes. `spot` tells profile and optics, each pass its width, power and speed;
    /// `way_time` when the spot goes to a target (pass, point); `None`: at the speed of the pass, from 0 s on.
    pub fn new(passes: &[Pass], spot: &Spot, way_time: impl Fn(usize, usize) -> Option<WayTime>) -> Light {
        let mut pieces = Vec::new();
        let mut spots: Vec<SpotAndPower> = Vec::new();
        let longest = |spot: &Spot| (LENGTH_SPOTS * spot.spot_mm).max(LENGTH_MM);
        for (number, pass) in passes.iter().enumerate() {
            let spot_and_power = spots.iter().position(|l| l.settings == pass.settings).unwrap_or_else(|| {
                spots.push(SpotAndPower::new(pass.settings, spot));
                spots.len() - 1
            });
            let (spot, speed_mm_s) = (&spots[spot_and_power].spot, pass.settings.speed_mm_s);
            let longest_mm = longest(spot);
            for (start, end) in pass.lit_pieces() {
                let Some(lit) = pass.targets.get(start..=end) else { continue };
                let frames: Vec<BeamFrame> = lit.iter().map(|t| BeamFrame::new(t.p, t.a, t.o)).collect();
                let times: Vec<WayTime> = lit_way_times(&frames, speed_mm_s, |i| way_time(number, start + i));
                let mut at = 0;
                while at + 1 < frames.len() {
                    let off_mm = STRAIGHT_SPOTS * spot.spot_mm;
                    let last = at + count_even_moves(&frames[at..], &times[at..], longest_mm, off_mm);
                    let whole_s: f64 = times[at..last].iter().map(|t| t.seconds).sum();
                    let starts_s = times[last - 1].ends_s - whole_s;
                    let count = piece_count(&frames[at], &frames[last], longest_mm);
                    let mut from = frames[at];
                    for k in 1..=count {
                        let share = f64::from(k) / f64::from(count);
                        let to = if k < count {
                            BeamFrame::between(&frames[at], &frames[last], share)
                        } else {
                            frames[last]
                        };
                        pieces.push(LightPiece {
                            pass: number as u32,
                            spot_and_power: spot_and_power as u32,
                            from,
                            to,
                            seconds: whole_s / f64::from(count),
                            ends_s: starts_s + whole_s * share,
                        });
                        from = to;
                    }
                    at = last;
                }
            }
        }
        let runs = ends_of_runs(&pieces, |piece| {
            spots.get(piece.spot_and_power as usize).map_or(LENGTH_MM, |l| longest(&l.spot))
        });
        Light { pieces, runs, spots }
    }

    /// Spot and power of a piece.
    #[inline]
    pub fn spot_and_power(&self, piece: &LightPiece) -> &SpotAndPower {
        &self.spots[piece.spot_and_power as usize]
    }

    /// Its spot.
    #[inline]
    pub fn spot(&self, piece: &LightPiece) -> &Spot {
        &self.spot_and_power(piece).spot
    }

    /// The least spot of all passes, mm; 1 where there are none.
    pub fn least_spot_mm(&self) -> f64 {
        self.spots.iter().map(|l| l.spot.spot_mm).reduce(f64::min).unwrap_or(1.0)
    }

    /// About what the middle of a line gets, J/mm².
    pub fn line_j_mm2(&self, piece: &LightPiece) -> f64 {
        self.spot_and_power(piece).negligible_j_mm2 / NEGLIGIBLE
    }

    /// The pieces of a run: number of the first, and all of them.
    pub fn run(&self, index: usize) -> (u32, &[LightPiece]) {
        let end = |i: usize| self.runs.get(i).map_or(self.pieces.len(), |e| *e as usize);
        let start = index.checked_sub(1).map_or(0, end);
        (start as u32, self.pieces.get(start..end(index)).unwrap_or_default())
    }

    /// Whether any light of a piece may come within `radius_mm` of a point.
    #[inline]
    pub fn reaches(&self, piece: &LightPiece, centre: &Point3<f64>, radius_mm: f64) -> bool {
        let spot = self.spot(piece);
        let seen = piece.sees(centre, spot.defocus_mm);
        let reach = spot.reach_mm(seen.z_mm.abs() + radius_mm);
        (0..2).all(|k| {
            let (x, y, r) = (seen.from[k], seen.to[k], reach[k] + radius_mm);
            x.min(y) <= r && x.max(y) >= -r
        })
    }

    /// The energy that a piece brings to a point; `None` where it is negligible.
    #[inline]
    pub fn passing(&self, piece: &LightPiece, q: &Point3<f64>) -> Option<Passing> {
        let spot_and_power = self.spot_and_power(piece);
        let seen = piece.sees(q, spot_and_power.spot.defocus_mm);
        if seen.z_mm + spot_and_power.spot.optics.lens_to_focus_mm <= 0.0 {
            return None; // behind the lens
        }
        let window = spot_and_power.spot.window(seen.from, seen.to, seen.z_mm)?;
        let j_mm2 = self.energy(piece, &seen, window);
        (j_mm2 > spot_and_power.negligible_j_mm2).then_some(Passing { seen, window, j_mm2 })
    }

    /// Energy per area square to the beam within a window, J/mm².
    pub fn energy(&self, piece: &LightPiece, seen: &SeenPoint, window: [f64; 2]) -> f64 {
        let spot_and_power = self.spot_and_power(piece);
        spot_and_power.settings.power_w
            * piece.seconds
            * spot_and_power.spot.density_integral(seen.from, seen.to, seen.z_mm, window)
    }
}

/// Into how many pieces a way has to be cut.
fn piece_count(from: &BeamFrame, to: &BeamFrame, longest_mm: f64) -> u32 {
    let turn_deg = angle::between_deg(&from.a, &to.a).max(angle::between_deg(&from.o, &to.o));
    ((to.p - from.p).norm() / longest_mm).max(turn_deg / TURN_DEG).ceil().max(1.0) as u32
}

/// How many moves from the first frame on go straight, turn evenly, and are as fast as each other enough to be one
/// piece; at least one. `times`: of those moves.
fn count_even_moves(frames: &[BeamFrame], times: &[WayTime], longest_mm: f64, off_mm: f64) -> usize {
    let Some(first) = frames.first() else { return 0 };
    let slowness = |i: usize| times[i].seconds / (frames[i + 1].p - frames[i].p).norm().max(1e-9);
    let mut way_mm = vec![0.0];
    let mut count = 1;
    for (i, to) in frames.iter().enumerate().skip(1) {
        way_mm.push(way_mm[i - 1] + (to.p - frames[i - 1].p).norm());
        let is_even = |k: usize| {
            let t = way_mm[k] / way_mm[i];
            let frame = BeamFrame::between(first, to, t);
            (frame.p - frames[k].p).norm() <= off_mm && angle::between_deg(&frame.a, &frames[k].a) <= EVEN_DEG
        };
        let is_as_fast = (slowness(i - 1) / slowness(0) - 1.0).abs() <= EVEN_SPEED;
        let fits = way_mm[i] > 0.0 && is_as_fast && piece_count(first, to, longest_mm) == 1 && (1..i).all(is_even);
        if i > 1 && !fits {
            break;
        }
        count = i;
    }
    count
}

fn ends_of_runs(pieces: &[LightPiece], longest_mm: impl Fn(&LightPiece) -> f64) -> Vec<u32> {
    let mut ends = Vec::new();
    let mut first: Option<&LightPiece> = None;
    let mut length_mm = 0.0;
    for (i, piece) in pieces.iter().enumerate() {
        let own_mm = (piece.to.p - piece.from.p).norm();
        let goes_on = first.is_some_and(|f| {
            let follows = i > 0 && pieces[i - 1].to.p == piece.from.p && f.pass == piece.pass;
            follows
                && length_mm + own_mm <= longest_mm(piece) * (1.0 + 1e-9)
                && angle::between_deg(&f.from.a, &piece.to.a) <= RUN_TURN_DEG
        });
        if !goes_on {
            if i > 0 {
                ends.push(i as u32);
            }
            (first, length_mm) = (Some(piece), 0.0);
        }
        length_mm += own_mm;
    }
    if !pieces.is_empty() {
        ends.push(pieces.len() as u32);
    }
    ends
}
