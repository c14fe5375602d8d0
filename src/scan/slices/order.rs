//! Orders the carried points of a band into chains: from a point along the curve both ways, a step of a spacing and a
//! half at a time to the middle of the points ahead, until there are none.
//!
//! The curve is found from the points' places alone, so it goes round corners, where normals are none; only where their
//! signs are trusted do they keep it on its own side of a thin wall. Chains are cut where no point is for five
//! spacings (`chain`): nothing is bridged where nothing was scanned.

use super::band::BandPoint;
use super::chain::{Chain, GAP, sorted};
use super::grid::PlaneGrid;
use super::scale::median;
use nalgebra::Vector2;

/// Length of a step in spacings: with three points a spacing each step has four or five.
const STEP: f64 = 1.5;
/// How far beside a chain points belong to it, in spacings: 4.5 standard deviations of the noise at the least.
const BESIDE: f64 = 1.5;
/// Points ahead are those within 78° of the way. Where there are none, as close before a corner, a few within 114° are the
/// next face; fewer are strays beside the end of the curve.
const AHEAD: f64 = 0.2;
const ROUND_A_CORNER: f64 = -0.4;
const FEWEST_ROUND_A_CORNER: usize = 3;
/// Cosine between outward normals below which two points are on two faces of a wall, and not on two of an edge.
const OTHER_FACE: f64 = -0.3;
/// Fewest steps of a closed chain.
const FEWEST_ROUND: usize = 4;

/// The chains of a band. `signed`: whether the sides of normals are trusted.
pub(super) fn chains(band: &[BandPoint], signed: bool) -> Vec<Chain> {
    let cell_mm = STEP * median(band.iter().map(|p| p.scale_mm));
    let grid = PlaneGrid::new(band.iter().map(|p| p.at), cell_mm);
    let mut tracer = Tracer { band, grid, signed, free: vec![true; band.len()] };
    let mut out = Vec::new();
    for seed in 0..band.len() {
        if tracer.free[seed] {
            out.extend(tracer.chain_from(seed).into_iter().flat_map(|chain| chain.cut_at_gaps(band)));
        }
    }
    out
}

struct Tracer<'a> {
    band: &'a [BandPoint],
    grid: PlaneGrid,
    signed: bool,
    free: Vec<bool>,
}

/// Where a walk stands.
#[derive(Clone, Copy)]
struct Stand {
    at: Vector2<f64>,
    /// Unit direction of the way.
    ahead: Vector2<f64>,
    /// Mean outward normal in the plane, of any length.
    outward: Vector2<f64>,
    scale_mm: f64,
}

/// A point that a walk may go on to.
struct Beyond {
    far_mm: f64,
    cosine: f64,
    point: u32,
}

/// A walk one way: its length, and the points on it by their way.
struct Walk {
    end: Stand,
    length_mm: f64,
    steps: usize,
    points: Vec<(f64, u32)>,
}

impl Tracer<'_> {
    fn chain_from(&mut self, seed: usize) -> Option<Chain> {
        let first = &self.band[seed];
        let outward = first.normal.xy();
        let ahead = Vector2::new(outward.y, -outward.x).try_normalize(0.0)?;
        let start = Stand { at: first.at, ahead, outward, scale_mm: first.scale_mm };
        let around: Vec<u32> = self.free_near(&start, BESIDE * start.scale_mm).map(|n| n.1).collect();
        let start = self.stand_on(&around, &start).map(|s| Stand { ahead, ..s })?;
        let there = self.walk(start);
        if let Some(closing_mm) = self.closing_mm(&start, &there) {
            let mut points = there.points;
            let length_mm = there.length_mm;
            self.take(&there.end, &start.at, 0.0, |along, i| points.push((length_mm + along, i)));
            let round_mm = length_mm + closing_mm;
            points.iter_mut().for_each(|p| p.0 = p.0.rem_euclid(round_mm));
            return Some(Chain { points: sorted(points), round_mm: Some(round_mm) });
        }
        let back = self.walk(Stand { ahead: -start.ahead, ..start });
        let points = back.points.iter().map(|p| (-p.0, p.1)).chain(there.points).collect();
        // Whatever the walks left beside the seed is of no other chain.
        self.free[seed] = false;
        Some(Chain { points: sorted(points), round_mm: None })
    }

    fn walk(&mut self, start: Stand) -> Walk {
        let mut walk = Walk { end: start, length_mm: 0.0, steps: 0, points: Vec::new() };
        while let Some(next) = self.next(&walk.end) {
            let before = walk.points.len();
            let (end, length_mm) = (walk.end, walk.length_mm);
            // What is behind the first is the other way's.
            let behind_mm = if walk.steps == 0 { 0.0 } else { 0.5 * BESIDE * end.scale_mm };
            self.take(&end, &next.at, behind_mm, |along, i| walk.points.push((length_mm + along, i)));
            if walk.points.len() == before {
                break;
            }
            walk.length_mm += (next.at - end.at).norm();
            walk.steps += 1;
            walk.end = next;
            if self.closing_mm(&start, &walk).is_some_and(|mm| mm <= STEP * start.scale_mm) {
                return walk;
            }
        }
        if self.closing_mm(&start, &walk).is_none() {
            // What is left of the last step.
            let (end, length_mm) = (walk.end, walk.length_mm);
            let beyond = end.at + end.ahead * (STEP * end.scale_mm);
            self.take(&end, &beyond, 0.0, |along, i| walk.points.push((length_mm + along, i)));
        }
        walk
    }

    /// How far the end of a walk is from its start, where it has come round to it.
    fn closing_mm(&self, start: &Stand, walk: &Walk) -> Option<f64> {
        let back = start.at - walk.end.at;
        let is_round = walk.steps >= FEWEST_ROUND
            && back.norm() <= GAP * start.scale_mm
            && back.dot(&walk.end.ahead) > 0.0
            && back.dot(&start.ahead) > 0.0;
        is_round.then(|| back.norm())
    }

    /// Free points within a reach that are of the same face.
    fn free_near<'s>(&'s self, stand: &Stand, reach_mm: f64) -> impl Iterator<Item = (f64, u32)> + 's {
        let (at, outward) = (stand.at, stand.outward);
        self.grid.near(at, reach_mm).filter_map(move |i| {
            let point = &self.band[i as usize];
            let normal = point.normal.xy();
            let is_of_face = !self.signed || normal.dot(&outward) >= OTHER_FACE * normal.norm() * outward.norm();
            let far = (point.at - at).norm();
            (self.free[i as usize] && is_of_face && far <= reach_mm).then_some((far, i))
        })
    }

    /// A step on: to the middle of the points ahead, about the one that is most so; `None` where there are none.
    fn next(&self, stand: &Stand) -> Option<Stand> {
        let step_mm = STEP * stand.scale_mm;
        let [ahead, beside] = [AHEAD, ROUND_A_CORNER].map(|least| self.beyond(stand, 1.5 * step_mm, least));
        if !ahead.is_empty() {
            return self.stand_on(&self.group(&ahead, stand), stand);
        }
        let group = self.group(&beside, stand);
        if group.len() >= FEWEST_ROUND_A_CORNER {
            return self.stand_on(&group, stand);
        }
        let mut far = self.beyond(stand, GAP * stand.scale_mm, AHEAD);
        let nearest = far.iter().map(|f| f.far_mm).fold(f64::INFINITY, f64::min);
        far.retain(|f| f.far_mm <= nearest + step_mm);
        self.stand_on(&self.group(&far, stand), stand)
    }

    /// Free points at half a step or more whose direction has this cosine with the way or a greater one.
    fn beyond(&self, stand: &Stand, reach_mm: f64, least_cosine: f64) -> Vec<Beyond> {
        let beyond = |(far_mm, point): (f64, u32)| {
            let cosine = (self.band[point as usize].at - stand.at).dot(&stand.ahead) / far_mm;
            (far_mm >= 0.5 * STEP * stand.scale_mm && cosine >= least_cosine).then_some(Beyond {
                far_mm,
                cosine,
                point,
            })
        };
        self.free_near(stand, reach_mm).filter_map(beyond).collect()
    }

    /// Those about the one that is most ahead, within half a step of it.
    fn group(&self, found: &[Beyond], stand: &Stand) -> Vec<u32> {
        let order = |a: &&Beyond, b: &&Beyond| a.cosine.total_cmp(&b.cosine).then(b.point.cmp(&a.point));
        let Some(most) = found.iter().max_by(order) else { return Vec::new() };
        let most = self.band[most.point as usize].at;
        let is_about = |i: &u32| (self.band[*i as usize].at - most).norm() <= 0.5 * STEP * stand.scale_mm;
        found.iter().map(|f| f.point).filter(is_about).collect()
    }

    /// In the middle of some points, come from another place.
    fn stand_on(&self, group: &[u32], from: &Stand) -> Option<Stand> {
        let share = 1.0 / group.len() as f64;
        let points = || group.iter().map(|&i| &self.band[i as usize]);
        let at = points().fold(Vector2::zeros(), |s, p| s + p.at * share);
        let outward = points().fold(Vector2::zeros(), |s, p| s + p.normal.xy() * share);
        let scale_mm = points().map(|p| p.scale_mm).sum::<f64>() * share;
        (!group.is_empty()).then_some(())?;
        Some(Stand { at, ahead: (at - from.at).try_normalize(0.0).unwrap_or(from.ahead), outward, scale_mm })
    }

    /// Takes the free points beside the way to a place, and tells each with its way along it.
    /// `behind_mm`: so far behind the way's start as well: at the outside of a bend points come out there.
    fn take(&mut self, from: &Stand, to: &Vector2<f64>, behind_mm: f64, mut tell: impl FnMut(f64, u32)) {
        // A little more, so that a point that is the next place by itself is not behind it by rounding.
        let length_mm = (to - from.at).norm() * (1.0 + 1e-9);
        let Some(along) = (to - from.at).try_normalize(0.0) else { return };
        let beside_mm = BESIDE * from.scale_mm;
        let beside: Vec<(f64, u32)> = self
            .free_near(from, length_mm + beside_mm)
            .filter_map(|(_, i)| {
                let d = self.band[i as usize].at - from.at;
                let way_mm = d.dot(&along);
                let is_beside = (d - along * way_mm).norm() <= beside_mm;
                (is_beside && way_mm >= -behind_mm && way_mm <= length_mm).then_some((way_mm.max(0.0), i))
            })
            .collect();
        for (way_mm, i) in beside {
            self.free[i as usize] = false;
            tell(way_mm, i);
        }
    }
}
