//! Checks for the tests of this folder: exact welding, feature surfaces, brute-force rays.
//!
//! Deliberately simple and sharing no code with the planner. Not compiled into the program.

use super::shell::{Point, Triangles};
use std::collections::BTreeMap;

pub(super) type Facet = [Point; 3];

pub(super) fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn unit(a: Point) -> Point {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

pub(super) fn normal(t: &Facet) -> Point {
    unit(cross(sub(t[1], t[0]), sub(t[2], t[0])))
}

pub(super) fn centroid(t: &Facet) -> Point {
    std::array::from_fn(|c| (t[0][c] + t[1][c] + t[2][c]) / 3.0)
}

/// What exact welding of the stored f32 coordinates says about a mesh.
#[derive(Debug)]
pub(super) struct Skin {
    pub vertices: usize,
    pub edges: usize,
    pub facets: usize,
    /// Edges with one facet only.
    pub open_edges: usize,
    /// Directed edges used more than once: three facets at an edge, wrong winding or duplicates.
    pub bad_edges: usize,
    pub area: f64,
    pub volume: f64,
    /// The least altitude of any facet, mm.
    pub thinnest: f64,
    pub low: Point,
    pub high: Point,
}

fn indices(triangles: &Triangles) -> (usize, Vec<[usize; 3]>) {
    let mut known: BTreeMap<[u32; 3], usize> = BTreeMap::new();
    let facets = triangles
        .iter()
        .map(|t| {
            t.map(|p| {
                for x in p {
                    assert_eq!(f64::from(x as f32).to_bits(), x.to_bits(), "{x} is no f32");
                    assert!(x != 0.0 || x.is_sign_positive(), "minus zero");
                }
                let next = known.len();
                *known.entry(p.map(|x| (x as f32).to_bits())).or_insert(next)
            })
        })
        .collect();
    (known.len(), facets)
}

impl Skin {
    pub(super) fn weld(triangles: &Triangles) -> Skin {
        let (vertices, facets) = indices(triangles);
        let mut directed: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        for f in &facets {
            for k in 0..3 {
                *directed.entry((f[k], f[(k + 1) % 3])).or_insert(0) += 1;
            }
        }
        let mut skin = Skin {
            vertices,
            edges: 0,
            facets: facets.len(),
            open_edges: 0,
            bad_edges: directed.values().filter(|n| **n > 1).count(),
            area: 0.0,
            volume: 0.0,
            thinnest: f64::INFINITY,
            low: [f64::INFINITY; 3],
            high: [f64::NEG_INFINITY; 3],
        };
        for (a, b) in directed.keys() {
            let twin = directed.contains_key(&(*b, *a));
            skin.open_edges += usize::from(!twin);
            skin.edges += usize::from(!twin || a < b);
        }
        for t in triangles {
            let across = cross(sub(t[1], t[0]), sub(t[2], t[0]));
            let twice = dot(across, across).sqrt();
            skin.area += twice / 2.0;
            skin.volume += dot(t[0], cross(t[1], t[2])) / 6.0;
            let side = |k: usize| {
                let e = sub(t[(k + 1) % 3], t[k]);
                dot(e, e).sqrt()
            };
            skin.thinnest = skin.thinnest.min(twice / side(0).max(side(1)).max(side(2)));
            for (p, c) in t.iter().flat_map(|p| (0..3).map(move |c| (p, c))) {
                skin.low[c] = skin.low[c].min(p[c]);
                skin.high[c] = skin.high[c].max(p[c]);
            }
        }
        skin
    }

    pub(super) fn euler(&self) -> i64 {
        self.vertices as i64 - self.edges as i64 + self.facets as i64
    }

    /// Watertight: every edge has two facets that run through it in opposite directions; the skin
    /// encloses a positive volume, and no facet is a needle of less than `thin` mm.
    pub(super) fn assert_closed(&self, name: &str, thin: f64) {
        assert_eq!((self.open_edges, self.bad_edges), (0, 0), "{name}");
        assert!(self.volume > 0.0, "{name}: volume {}", self.volume);
        assert!(self.thinnest > thin, "{name}: thinnest facet {} mm", self.thinnest);
    }
}

/// Closed, and no facet thinner than 1 µm.
pub(super) fn closed(name: &str, triangles: &Triangles) -> Skin {
    let skin = Skin::weld(triangles);
    skin.assert_closed(name, 1e-3);
    skin
}

/// Feature surfaces (P1 2.2): facets joined through edges with dihedral < `angle_deg`; each in
/// rising order, sorted by the lowest facet.
pub(super) fn surfaces(triangles: &Triangles, angle_deg: f64) -> Vec<Vec<usize>> {
    let (_, facets) = indices(triangles);
    let normals: Vec<Point> = triangles.iter().map(normal).collect();
    let mut root: Vec<usize> = (0..facets.len()).collect();
    fn find(root: &mut [usize], mut i: usize) -> usize {
        while root[i] != i {
            root[i] = root[root[i]];
            i = root[i];
        }
        i
    }
    let mut seen: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for (i, f) in facets.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (f[k], f[(k + 1) % 3]);
            let Some(j) = seen.insert((a.min(b), a.max(b)), i) else {
                continue;
            };
            let (m, n) = (normals[i], normals[j]);
            let c = cross(m, n);
            let angle = libm::atan2(dot(c, c).sqrt(), dot(m, n));
            if angle < super::outline::radians(angle_deg) {
                let (i, j) = (find(&mut root, i), find(&mut root, j));
                root[i.max(j)] = i.min(j);
            }
        }
    }
    let mut sets: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for i in 0..facets.len() {
        let lowest = find(&mut root, i);
        sets.entry(lowest).or_default().push(i);
    }
    sets.into_values().collect()
}

/// The first facet that a ray meets from `start` mm on (Möller–Trumbore, all facets, both sides).
pub(super) fn first_hit(triangles: &Triangles, origin: Point, direction: Point, start: f64) -> Option<(f64, usize)> {
    let mut best: Option<(f64, usize)> = None;
    for (i, t) in triangles.iter().enumerate() {
        let (e1, e2) = (sub(t[1], t[0]), sub(t[2], t[0]));
        let p = cross(direction, e2);
        let det = dot(e1, p);
        if det.abs() < 1e-14 {
            continue;
        }
        let s = sub(origin, t[0]);
        let u = dot(s, p) / det;
        let q = cross(s, e1);
        let v = dot(direction, q) / det;
        let along = dot(e2, q) / det;
        let inside = u >= -1e-9 && v >= -1e-9 && u + v <= 1.0 + 1e-9;
        if inside && along > start && best.is_none_or(|(t, _)| along < t) {
            best = Some((along, i));
        }
    }
    best
}
