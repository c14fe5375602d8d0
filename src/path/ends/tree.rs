//! Segments in a tree of boxes, so that only the near ones of a long rim are visited.

use crate::part::distance::point_segment;
use nalgebra::Point3;

/// Segments at a leaf.
const LEAF: usize = 4;

type Segment = [Point3<f64>; 2];

/// Segments by their boxes.
#[derive(Clone, Debug, Default)]
pub(super) struct Tree {
    segments: Vec<Segment>,
    /// Box, first segment, number of segments, and the second child (the first follows its parent; 0: a leaf).
    nodes: Vec<(Segment, usize, usize, usize)>,
}

impl Tree {
    pub fn new(segments: impl Iterator<Item = Segment>) -> Tree {
        let mut tree = Tree { segments: segments.collect(), nodes: Vec::new() };
        if !tree.segments.is_empty() {
            tree.build(0, tree.segments.len());
        }
        tree
    }

    fn build(&mut self, from: usize, to: usize) -> usize {
        let own = &mut self.segments[from..to];
        let (lo, hi) = crate::part::topology::bounds_of(own.iter().flatten().copied());
        let node = self.nodes.len();
        self.nodes.push(([lo, hi], from, to - from, 0));
        if to - from > LEAF {
            let axis = (hi - lo).imax();
            own.sort_by(|a, b| (a[0][axis] + a[1][axis]).total_cmp(&(b[0][axis] + b[1][axis])));
            let middle = usize::midpoint(from, to);
            self.build(from, middle);
            self.nodes[node].3 = self.build(middle, to);
        }
        node
    }

    /// Visits the segments whose boxes come within `reach_mm` (per axis) of the box around two points.
    pub fn visit(&self, a: &Point3<f64>, b: &Point3<f64>, reach_mm: f64, mut visit: impl FnMut(&Segment)) {
        let (lo, hi) = (a.inf(b), a.sup(b));
        let mut stack = if self.nodes.is_empty() { vec![] } else { vec![0] };
        while let Some(node) = stack.pop() {
            let ([from, to], first, count, second) = &self.nodes[node];
            if (0..3).any(|k| from[k] > hi[k] + reach_mm || to[k] < lo[k] - reach_mm) {
                continue;
            }
            if *second == 0 {
                self.segments[*first..first + count].iter().for_each(&mut visit);
            } else {
                stack.extend([*second, node + 1]);
            }
        }
    }

    /// Whether a point is within `reach_mm` of a segment.
    pub fn has_within(&self, p: &Point3<f64>, reach_mm: f64) -> bool {
        let mut has = false;
        self.visit(p, p, reach_mm, |[a, b]| has = has || point_segment(p, a, b) <= reach_mm);
        has
    }

    /// The shares of the way from `p` to `q` that are nearer than `radius_mm` to a segment: sorted, apart.
    pub fn shares_within(&self, p: &Point3<f64>, q: &Point3<f64>, radius_mm: f64) -> Vec<(f64, f64)> {
        let mut found = Vec::new();
        self.visit(p, q, radius_mm, |segment| found.extend(share_within(p, q, segment, radius_mm)));
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut apart: Vec<(f64, f64)> = Vec::with_capacity(found.len());
        for (from, to) in found {
            match apart.last_mut() {
                Some(last) if from <= last.1 => last.1 = last.1.max(to),
                _ => apart.push((from, to)),
            }
        }
        apart
    }
}

/// The shares, within 0 to 1, of the way from `p` to `q` nearer than a radius to a segment.
///
/// The places so near to a segment are convex, so it is one stretch: from the first to the last of what lies in
/// the balls about its ends and in the cylinder between.
fn share_within(p: &Point3<f64>, q: &Point3<f64>, [a, b]: &Segment, radius_mm: f64) -> Option<(f64, f64)> {
    let (way, side, off) = (q - p, b - a, p - a);
    let roots = |w: nalgebra::Vector3<f64>, e: nalgebra::Vector3<f64>| -> Option<(f64, f64)> {
        // |w + t e| < radius
        let (ee, we, rest) = (e.norm_squared(), w.dot(&e), w.norm_squared() - radius_mm * radius_mm);
        if ee <= 1e-24 {
            return (rest < 0.0).then_some((f64::NEG_INFINITY, f64::INFINITY));
        }
        let under = we * we - ee * rest;
        (under > 0.0).then(|| ((-we - under.sqrt()) / ee, (-we + under.sqrt()) / ee))
    };
    let length = side.norm();
    let wall = (length > 0.0).then(|| side / length).and_then(|u| {
        let (from, to) = roots(off - u * u.dot(&off), way - u * u.dot(&way))?;
        let (at, per) = (u.dot(&off), u.dot(&way));
        if per.abs() <= 1e-12 {
            return (0.0..=length).contains(&at).then_some((from, to));
        }
        let (s, t) = (-at / per, (length - at) / per);
        let (from, to) = (from.max(s.min(t)), to.min(s.max(t)));
        (from < to).then_some((from, to))
    });
    let all = [roots(off, way), roots(p - b, way), wall];
    let hull = all.into_iter().flatten().reduce(|x, y| (x.0.min(y.0), x.1.max(y.1)))?;
    let (from, to) = (hull.0.max(0.0), hull.1.min(1.0));
    (from < to).then_some((from, to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIDE: std::ops::Range<f64> = -5.0..5.0;

    proptest! {
        /// Within the shares told, and only there, a point of the way is near.
        #[test]
        fn the_shares_are_those_nearer(c in prop::collection::vec(prop::array::uniform6(SIDE), 1..20),
                                       w in prop::array::uniform6(SIDE), radius in 0.1..4.0f64) {
            let segment = |c: &[f64; 6]| [Point3::new(c[0], c[1], c[2]), Point3::new(c[3], c[4], c[5])];
            let segments: Vec<Segment> = c.iter().map(segment).collect();
            let [p, q] = segment(&w);
            let shares = Tree::new(segments.iter().copied()).shares_within(&p, &q, radius);
            prop_assert!(shares.windows(2).all(|w| w[0].1 < w[1].0));
            let distance = |t: f64| {
                let at = p + (q - p) * t;
                segments.iter().map(|[a, b]| point_segment(&at, a, b)).fold(f64::INFINITY, f64::min)
            };
            for i in 1..200 {
                let t = f64::from(i) / 200.0;
                let inside = shares.iter().any(|s| s.0 < t && t < s.1);
                let mm = distance(t);
                prop_assert!(if inside { mm < radius + 1e-9 } else { mm > radius - 1e-9 }, "{t}: {mm} {shares:?}");
            }
            for t in shares.iter().flat_map(|s| [s.0, s.1]).filter(|t| *t > 0.0 && *t < 1.0) {
                prop_assert!((distance(t) - radius).abs() < 1e-9);
            }
        }
    }
}
