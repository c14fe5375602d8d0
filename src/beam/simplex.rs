//! The simplex of Gilbert, Johnson and Keerthi's algorithm: the points of a difference of two bodies that the point
//! nearest to the origin needs.

use nalgebra::Vector3;

/// One to three points of the difference of two bodies.
#[derive(Clone, Copy, Default)]
pub(super) struct Simplex {
    points: [Vector3<f64>; 4],
    pub(super) count: usize,
}

impl Simplex {
    /// Whether a point is one of its own, to rounding.
    pub(super) fn has(&self, w: &Vector3<f64>) -> bool {
        self.points[..self.count].iter().any(|p| (p - w).norm_squared() <= 1e-24 * (1.0 + w.norm_squared()))
    }

    /// Adds a point, keeps those that the point nearest to the origin needs, and returns it; `None`:
    /// the origin is inside.
    pub(super) fn added(&mut self, w: Vector3<f64>) -> Option<Vector3<f64>> {
        self.points[self.count] = w;
        self.count += 1;
        let p = self.points;
        let (nearest, kept): (Vector3<f64>, [bool; 4]) = match self.count {
            1 => (p[0], [true, false, false, false]),
            2 => nearest_on_segment(&p[0], &p[1], [0, 1]),
            3 => nearest_on_triangle(&p[0], &p[1], &p[2], [0, 1, 2]),
            _ => nearest_on_tetrahedron(&p)?,
        };
        let mut count = 0;
        for i in 0..self.count {
            if kept[i] {
                self.points[count] = p[i];
                count += 1;
            }
        }
        self.count = count;
        Some(nearest)
    }
}

fn only<const N: usize>(which: [usize; N]) -> [bool; 4] {
    std::array::from_fn(|i| which.contains(&i))
}

fn nearest_on_segment(a: &Vector3<f64>, b: &Vector3<f64>, [i, j]: [usize; 2]) -> (Vector3<f64>, [bool; 4]) {
    let ab = b - a;
    let t = -a.dot(&ab);
    let whole = ab.norm_squared();
    if t <= 0.0 {
        (*a, only([i]))
    } else if t >= whole {
        (*b, only([j]))
    } else {
        (a + ab * (t / whole), only([i, j]))
    }
}

/// By Voronoi regions (Ericson, Real-Time Collision Detection, 5.1.5), for the origin.
fn nearest_on_triangle(
    a: &Vector3<f64>,
    b: &Vector3<f64>,
    c: &Vector3<f64>,
    [i, j, k]: [usize; 3],
) -> (Vector3<f64>, [bool; 4]) {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (-ab.dot(a), -ac.dot(a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (*a, only([i]));
    }
    let (d3, d4) = (-ab.dot(b), -ac.dot(b));
    if d3 >= 0.0 && d4 <= d3 {
        return (*b, only([j]));
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return (a + ab * (d1 / (d1 - d3)), only([i, j]));
    }
    let (d5, d6) = (-ab.dot(c), -ac.dot(c));
    if d6 >= 0.0 && d5 <= d6 {
        return (*c, only([k]));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return (a + ac * (d2 / (d2 - d6)), only([i, k]));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        let t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return (b + (c - b) * t, only([j, k]));
    }
    let sum = va + vb + vc;
    (a + ab * (vb / sum) + ac * (vc / sum), only([i, j, k]))
}

fn nearest_on_tetrahedron(p: &[Vector3<f64>; 4]) -> Option<(Vector3<f64>, [bool; 4])> {
    let mut best: Option<(Vector3<f64>, [bool; 4])> = None;
    for [i, j, k, l] in [[0, 1, 2, 3], [0, 3, 1, 2], [0, 2, 3, 1], [1, 3, 2, 0]] {
        let n = (p[j] - p[i]).cross(&(p[k] - p[i]));
        let (origin, other) = (-p[i].dot(&n), (p[l] - p[i]).dot(&n));
        // The origin is on the fourth corner's side of this face, so it is not nearest. Flat ones are checked too.
        if origin * other > 0.0 && other.abs() > 1e-14 * n.norm() {
            continue;
        }
        let found = nearest_on_triangle(&p[i], &p[j], &p[k], [i, j, k]);
        if best.is_none_or(|b| found.0.norm_squared() < b.0.norm_squared()) {
            best = Some(found);
        }
    }
    best
}
