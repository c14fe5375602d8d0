//! Access maps: from which directions a spot can be reached, at one place over all tilts, and along a line over
//! one part of the tilt.
//!
//! For display only: the search for clearance asks the interference queries directly.

use super::interference::{BeamInterference, Blocker};
use super::target::{Pass, TargetState};
use super::tilt::{Tilt, TiltRule};
use nalgebra::{Point3, Vector3};

/// What becomes of the beam at a tilt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Access {
    /// It is free.
    Free,
    /// Something is in the way.
    Blocked(Blocker),
    /// The surface's rule does not allow it.
    Forbidden,
}

/// A map over lead and lean, a square of cells about the normal; those beyond the greatest tilt are
/// not looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct AccessMap {
    /// Step from one cell to the next, degrees.
    pub step_deg: f64,
    /// Cells from the middle to a side.
    pub half: usize,
    /// Row by row: lean from left to right, lead from behind to ahead.
    pub cells: Vec<Option<Access>>,
}

impl AccessMap {
    /// The map at one place of a line. `tangent`: the travel direction.
    pub fn at(
        beam: &BeamInterference<'_>,
        p: &Point3<f64>,
        n: &Vector3<f64>,
        tangent: &Vector3<f64>,
        rule: &TiltRule,
        max_tilt_deg: f64,
        step_deg: f64,
    ) -> AccessMap {
        let half = (max_tilt_deg / step_deg).floor() as usize;
        let mut map = AccessMap { step_deg, half, cells: Vec::with_capacity((2 * half + 1) * (2 * half + 1)) };
        for i in 0..(2 * half + 1) * (2 * half + 1) {
            let tilt = map.tilt(i);
            let cell = (tilt.angle_deg() <= max_tilt_deg + 1e-9).then(|| access(beam, p, n, tangent, rule, tilt));
            map.cells.push(cell);
        }
        map
    }

    /// Cells in a row.
    pub fn side(&self) -> usize {
        2 * self.half + 1
    }

    /// The tilt in the middle of a cell.
    pub fn tilt(&self, cell: usize) -> Tilt {
        let off = |i: usize| (i as f64 - self.half as f64) * self.step_deg;
        Tilt { lead_deg: off(cell / self.side()), lean_deg: off(cell % self.side()) }
    }

    /// The cell of a tilt.
    pub fn cell(&self, tilt: Tilt) -> Option<Access> {
        let index = |deg: f64| {
            let i = (deg / self.step_deg).round() + self.half as f64;
            (i >= 0.0 && i < self.side() as f64).then_some(i as usize)
        };
        self.cells.get(index(tilt.lead_deg)? * self.side() + index(tilt.lean_deg)?).copied().flatten()
    }

    /// Share of the cells that are free.
    pub fn free_share(&self) -> f64 {
        let looked = self.cells.iter().flatten().count().max(1);
        self.cells.iter().flatten().filter(|c| **c == Access::Free).count() as f64 / looked as f64
    }
}

fn access(
    beam: &BeamInterference<'_>,
    p: &Point3<f64>,
    n: &Vector3<f64>,
    tangent: &Vector3<f64>,
    rule: &TiltRule,
    tilt: Tilt,
) -> Access {
    if !rule.allows(tilt) {
        return Access::Forbidden;
    }
    let a = tilt.axis(n, tangent);
    if beam.is_free(p, &a) {
        return Access::Free;
    }
    beam.blocker(p, &a).map_or(Access::Free, Access::Blocked)
}

/// Which part of the tilt a strip varies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TiltPart {
    /// Over lead; the lean stays as chosen.
    #[default]
    Lead,
    /// Over lean; the lead stays as chosen.
    Lean,
}

impl TiltPart {
    /// The value of this part of a tilt, degrees.
    pub fn of(self, tilt: Tilt) -> f64 {
        match self {
            TiltPart::Lead => tilt.lead_deg,
            TiltPart::Lean => tilt.lean_deg,
        }
    }

    /// A tilt with this part changed.
    pub fn with(self, tilt: Tilt, deg: f64) -> Tilt {
        match self {
            TiltPart::Lead => Tilt { lead_deg: deg, ..tilt },
            TiltPart::Lean => Tilt { lean_deg: deg, ..tilt },
        }
    }
}

/// One place of a strip.
#[derive(Clone, Debug, PartialEq)]
pub struct AccessColumn {
    /// Index of the target in the pass.
    pub point: usize,
    /// Place on the line, mm from its start.
    pub at_mm: f64,
    /// The chosen tilt; `None`: blocked.
    pub chosen: Option<Tilt>,
    /// Access at each value, ascending.
    pub cells: Vec<Option<Access>>,
}

/// One part of the tilt over the length of a pass: what is free beside what was chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct AccessStrip {
    /// Which part.
    pub over: TiltPart,
    /// Step from one cell to the next, degrees.
    pub step_deg: f64,
    /// Cells from 0 to either end.
    pub half: usize,
    /// Along the line.
    pub columns: Vec<AccessColumn>,
}

impl AccessStrip {
    /// The tilt that was chosen nearest to a place on the line.
    pub fn chosen_at(&self, at_mm: f64) -> Option<Tilt> {
        let known = self.columns.iter().filter_map(|c| Some(((c.at_mm - at_mm).abs(), c.chosen?)));
        known.min_by(|x, y| x.0.total_cmp(&y.0)).map(|(_, tilt)| tilt)
    }

    /// The strip of a pass, at no more than `most` of its targets.
    pub fn along(
        beam: &BeamInterference<'_>,
        pass: &Pass,
        rule: &TiltRule,
        over: TiltPart,
        max_tilt_deg: f64,
        step_deg: f64,
        most: usize,
    ) -> AccessStrip {
        let half = (max_tilt_deg / step_deg).floor() as usize;
        let every = pass.targets.len().div_ceil(most.max(1)).max(1);
        let mut at_mm = 0.0;
        let mut columns = Vec::new();
        for (point, t) in pass.targets.iter().enumerate() {
            if let Some(before) = point.checked_sub(1).and_then(|i| pass.targets.get(i)) {
                at_mm += (t.p - before.p).norm();
            }
            if point % every != 0 && point + 1 != pass.targets.len() {
                continue;
            }
            let chosen = (t.state != TargetState::Blocked).then(|| t.tilt());
            let tangent = t.tangent();
            let around = chosen.unwrap_or_default();
            let cell = |i: usize| {
                let tilt = over.with(around, (i as f64 - half as f64) * step_deg);
                (tilt.angle_deg() <= max_tilt_deg + 1e-9).then(|| access(beam, &t.p, &t.n, &tangent, rule, tilt))
            };
            columns.push(AccessColumn { point, at_mm, chosen, cells: (0..=2 * half).map(cell).collect() });
        }
        AccessStrip { over, step_deg, half, columns }
    }
}
