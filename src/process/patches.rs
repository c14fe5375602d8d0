//! What a plan leaves unclean: connected pieces of the chosen surfaces that get too little, and why.

use super::dose_map::DoseMap;
use super::statistics::DoseVerdict;
use crate::part::{Mesh, Surfaces, union_find::UnionFind};
use crate::pose::{Blocker, Obstruction, Pass, TargetState};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;

/// Why a patch gets too little.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PatchCause {
    /// The targets nearest to it are blocked.
    Blocked,
    /// Something stands in the way of the light that would be enough.
    Shaded,
    /// No line comes near.
    Missed,
    /// Lines come near, but too little lands: other process settings would clean it.
    Thin,
}

impl PatchCause {
    /// The word in the report.
    pub fn word(self) -> &'static str {
        match self {
            PatchCause::Blocked => "blocked",
            PatchCause::Shaded => "shaded",
            PatchCause::Missed => "missed",
            PatchCause::Thin => "thin",
        }
    }

    /// Whether the plan cannot bring light here, whatever its spacing, power and speed.
    pub fn keeps_light_away(self) -> bool {
        self != PatchCause::Thin
    }
}

/// A patch that stays unclean.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Its surface.
    pub surface: u32,
    /// Its area, mm².
    pub area_mm2: f64,
    /// Its middle, mm, part frame; on a bent surface it lies beside it.
    pub centre: Point3<f64>,
    /// Why, for most of its area.
    pub cause: PatchCause,
    /// What is in the way of a blocked target's beam or head, most often. None where the robot cannot
    /// go there.
    pub blocker: Option<Blocker>,
    /// What shades it, for most of its area.
    pub shaded_by: Option<Obstruction>,
    /// Twice as far as any of it lies from the nearest line, mm: between two lines that is their distance here.
    /// Infinite where there is no line.
    pub gap_mm: f64,
    /// A spacing below this would bring enough to the gap between lines, mm; `None` if it is not such a gap, or no
    /// spacing was looked for.
    pub closer_than_mm: Option<f64>,
    /// The facets that lie in it by more than half: what the list for later takes over.
    pub facets: Vec<u32>,
}

/// A stretch of a line of the plan.
struct PassStretch {
    from: Point3<f64>,
    to: Point3<f64>,
    /// The laser is off because a target at one end is blocked, by this.
    blocked: Option<Option<Blocker>>,
}

impl DoseMap {
    /// Patches larger than a spot, the largest first. A line nearer than `spacing_mm` reaches a sample.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn not_cleanable(
        &self,
        mesh: &Mesh,
        surfaces: &Surfaces,
        passes: &[Pass],
        spacing_mm: f64,
        progress: &Progress,
    ) -> Result<Vec<Patch>, Cancelled> {
        let low: Vec<(usize, u32)> = self
            .chosen_samples(surfaces)
            .filter(|(_, s, _)| matches!(self.verdict(s), DoseVerdict::Under | DoseVerdict::Shaded))
            .map(|(i, _, surface)| (i, surface))
            .collect();
        progress.check()?;
        let mut stretches: BTreeMap<u32, Vec<PassStretch>> = BTreeMap::new();
        for pass in passes {
            stretches.entry(pass.surface).or_default().extend(stretches_of_pass(pass));
        }
        let spot_mm = self.light.least_spot_mm();
        let spot_mm2 = 0.25 * std::f64::consts::PI * spot_mm * spot_mm;
        let reach_mm = spacing_mm.max(0.5 * spot_mm);
        let mut patches: Vec<Patch> = self
            .connected(&low, progress)?
            .into_iter()
            .filter(|group| group.iter().map(|i| f64::from(self.samples[*i].area_mm2)).sum::<f64>() >= spot_mm2)
            .map(|group| {
                let surface = surfaces.of_facet[self.samples[group[0]].facet as usize];
                let lines = stretches.get(&surface).map_or(&[][..], Vec::as_slice);
                self.patch((mesh, surface), &group, lines, reach_mm, progress)
            })
            .collect::<Result<_, Cancelled>>()?;
        patches.sort_by(|a, b| b.area_mm2.total_cmp(&a.area_mm2));
        Ok(patches)
    }

    /// Groups of samples of one surface that hang together: none of a group has its middle further from
    /// another's than their widths.
    fn connected(&self, low: &[(usize, u32)], progress: &Progress) -> Result<Vec<Vec<usize>>, Cancelled> {
        // Large samples are where no light comes; they are as wide as the widest of them.
        let width = |i: usize| f64::from(self.samples[i].area_mm2).sqrt().max(0.5 * self.sample_mm);
        let widest = low.iter().map(|(i, _)| width(*i)).fold(self.sample_mm, f64::max);
        let pitch = 1.6 * widest;
        let place = |i: usize| self.samples[i].centre.map(|x| (f64::from(x) / pitch).floor() as i64);
        let mut grid: BTreeMap<(u32, [i64; 3]), Vec<u32>> = BTreeMap::new();
        for (k, (i, surface)) in low.iter().enumerate() {
            progress.check_at(k)?;
            grid.entry((*surface, place(*i))).or_default().push(k as u32);
        }
        let mut sets = UnionFind::new(low.len());
        for ((surface, [x, y, z]), members) in &grid {
            progress.check()?;
            for step in 0..27 {
                let next = [x + step % 3 - 1, y + step / 3 % 3 - 1, z + step / 9 - 1];
                let Some(others) = grid.get(&(*surface, next)).filter(|_| next >= [*x, *y, *z]) else { continue };
                for &a in members {
                    for &b in others.iter().filter(|b| (next, **b) > ([*x, *y, *z], a)) {
                        let (i, j) = (low[a as usize].0, low[b as usize].0);
                        let near = 0.8 * (width(i) + width(j));
                        if sets.root(a) != sets.root(b)
                            && (self.middle(i) - self.middle(j)).norm_squared() <= near * near
                        {
                            sets.join(a, b);
                        }
                    }
                }
            }
        }
        let mut groups: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (k, (i, _)) in low.iter().enumerate() {
            groups.entry(sets.root(k as u32)).or_default().push(*i);
        }
        Ok(groups.into_values().collect())
    }

    fn middle(&self, i: usize) -> Point3<f64> {
        Point3::from(Vector3::from(self.samples[i].centre.map(f64::from)))
    }

    fn patch(
        &self,
        (mesh, surface): (&Mesh, u32),
        group: &[usize],
        lines: &[PassStretch],
        reach_mm: f64,
        progress: &Progress,
    ) -> Result<Patch, Cancelled> {
        let mut causes: BTreeMap<PatchCause, f64> = BTreeMap::new();
        let mut walls: BTreeMap<Obstruction, f64> = BTreeMap::new();
        let mut blockers: Vec<(Option<Blocker>, f64)> = Vec::new();
        let mut of_facet: BTreeMap<u32, f64> = BTreeMap::new();
        let (mut area_mm2, mut sum, mut gap_mm) = (0.0, Vector3::zeros(), 0.0f64);
        // A large patch is judged by some of its samples.
        let stride = group.len().div_ceil(MOST_JUDGED).max(1);
        for (k, &i) in group.iter().enumerate() {
            let s = &self.samples[i];
            let area = f64::from(s.area_mm2);
            area_mm2 += area;
            sum += self.middle(i).coords * area;
            *of_facet.entry(s.facet).or_default() += area;
            progress.check_at(k)?;
            if k % stride != 0 {
                continue;
            }
            progress.check()?;
            let near = nearest(&self.middle(i), lines);
            gap_mm = gap_mm.max(near.map_or(f64::INFINITY, |(mm, _)| 2.0 * mm));
            let (cause, blocker) = self.cause(i, near.filter(|(mm, _)| *mm <= reach_mm).map(|(_, line)| line));
            *causes.entry(cause).or_default() += area;
            match (cause, s.shaded_by) {
                (PatchCause::Shaded, Some(wall)) => *walls.entry(wall).or_default() += area,
                (PatchCause::Blocked, _) => match blockers.iter_mut().find(|(b, _)| same(b, &blocker)) {
                    Some((_, a)) => *a += area,
                    None => blockers.push((blocker, area)),
                },
                _ => {}
            }
        }
        let cause = causes.iter().max_by(|a, b| a.1.total_cmp(b.1)).map_or(PatchCause::Thin, |c| *c.0);
        let half = |f: &u32, a: &f64| *a >= 0.5 * mesh.areas.get(*f as usize).copied().unwrap_or(f64::INFINITY);
        Ok(Patch {
            surface,
            area_mm2,
            centre: Point3::from(sum / area_mm2),
            cause,
            blocker: blockers
                .iter()
                .filter(|_| cause == PatchCause::Blocked)
                .max_by(|a, b| a.1.total_cmp(&b.1))
                .and_then(|b| b.0),
            shaded_by: walls
                .iter()
                .filter(|_| cause == PatchCause::Shaded)
                .max_by(|a, b| a.1.total_cmp(b.1))
                .map(|w| *w.0),
            gap_mm,
            closer_than_mm: None,
            facets: of_facet.iter().filter(|(f, a)| half(f, a)).map(|(f, _)| *f).collect(),
        })
    }

    /// Why a sample gets too little, by the line that it lies near.
    fn cause(&self, i: usize, near: Option<&PassStretch>) -> (PatchCause, Option<Blocker>) {
        match near {
            Some(PassStretch { blocked: Some(by), .. }) => (PatchCause::Blocked, *by),
            _ if self.verdict(&self.samples[i]) == DoseVerdict::Shaded => (PatchCause::Shaded, None),
            None => (PatchCause::Missed, None),
            Some(_) => (PatchCause::Thin, None),
        }
    }
}

/// Number of samples of a patch that its cause is judged by.
const MOST_JUDGED: usize = 2000;

fn same(a: &Option<Blocker>, b: &Option<Blocker>) -> bool {
    a.map(|b| (b.tool_body, b.obstruction)) == b.map(|b| (b.tool_body, b.obstruction))
}

fn stretches_of_pass(pass: &Pass) -> impl Iterator<Item = PassStretch> {
    pass.targets.windows(2).filter(|w| !Pass::is_gap(&w[0], &w[1])).map(|w| {
        let blocked = w.iter().find(|t| t.state == TargetState::Blocked).filter(|_| !w[1].laser);
        PassStretch { from: w[0].p, to: w[1].p, blocked: blocked.map(|t| t.normal_hits) }
    })
}

/// The stretch nearest to a point, and how far it is, mm.
fn nearest<'a>(q: &Point3<f64>, lines: &'a [PassStretch]) -> Option<(f64, &'a PassStretch)> {
    lines.iter().map(|s| (distance(q, s), s)).min_by(|a, b| a.0.total_cmp(&b.0))
}

fn distance(q: &Point3<f64>, s: &PassStretch) -> f64 {
    let (d, w) = (s.to - s.from, q - s.from);
    let t = (w.dot(&d) / d.norm_squared().max(1e-300)).clamp(0.0, 1.0);
    (w - d * t).norm()
}
