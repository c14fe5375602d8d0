//! Strategies in closed form: spacing on cone, sphere, torus and saddle, nested squares, spirals, and
//! surfaces on which little or nothing can be laid.

use clearbeam::part::distance::{point_segment, point_triangle};
use clearbeam::part::surfaces::Surface;
use clearbeam::part::{Mesh, Surfaces};
use clearbeam::path::normals::VertexNormals;
use clearbeam::path::planes::{Direction, PlaneRaster, planes};
use clearbeam::path::strategy::offset::borders;
use clearbeam::path::strategy::{Achieved, Layout, SurfaceLines, lines, spacing};
use clearbeam::path::{SectionPoint, Strategy, SurfacePlanes, TransversalLine};
use nalgebra::{Point3, Vector3};
use std::f64::consts::TAU;

/// A surface by itself, all facets under number 1.
struct Alone {
    mesh: Mesh,
    surfaces: Surfaces,
}

impl Alone {
    fn new(points: &[[f64; 3]], facets: Vec<[u32; 3]>) -> Alone {
        let mesh = Mesh::from_indexed(points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect(), facets);
        let all =
            Surface { number: 1, facets: (0..mesh.facets.len() as u32).collect(), area_mm2: mesh.areas.iter().sum() };
        let surfaces = Surfaces {
            of_facet: vec![1; mesh.facets.len()],
            list: vec![all],
            normals: mesh.normals.clone(),
            last_number: 1,
            ..Surfaces::default()
        };
        Alone { mesh, surfaces }
    }

    /// A net of `m` by `n` quads over the unit square, `u` closing on itself where `round`.
    fn grid(m: usize, n: usize, round: bool, at: impl Fn(f64, f64) -> [f64; 3]) -> Alone {
        let columns = if round { m } else { m + 1 };
        let mut points = Vec::new();
        for j in 0..=n {
            points.extend((0..columns).map(|i| at(i as f64 / m as f64, j as f64 / n as f64)));
        }
        let v = |i: usize, j: usize| (j * columns + i % columns) as u32;
        let mut facets = Vec::new();
        for j in 0..n {
            for i in 0..m {
                facets.push([v(i, j), v(i + 1, j), v(i + 1, j + 1)]);
                facets.push([v(i, j), v(i + 1, j + 1), v(i, j + 1)]);
            }
        }
        Alone::new(&points, facets)
    }

    fn surface(&self) -> &Surface {
        &self.surfaces.list[0]
    }

    fn family(&self, direction: Direction, spacing: f64) -> SurfacePlanes {
        let raster = PlaneRaster { surface: 1, direction, spacing_mm: spacing, offset_mm: None };
        planes(&self.mesh, &self.surfaces, &[raster], &nalgebra::Rotation3::identity()).pop().unwrap_or(SurfacePlanes {
            surface: 1,
            normal: nalgebra::Vector3::z(),
            heights_mm: Vec::new(),
        })
    }

    fn laid(&self, rule: &Layout, direction: Direction) -> SurfaceLines {
        let normals = VertexNormals::new(&self.mesh, &self.surfaces, self.surface());
        let family = self.family(direction, rule.spacing_mm);
        let merge = 1e-6 * self.mesh.diagonal();
        let made = lines(&self.mesh, self.surface(), &normals, rule, &family, merge);
        let again = lines(&self.mesh, self.surface(), &normals, rule, &family, merge);
        assert_eq!(made, again, "the same twice");
        self.check(&made);
        made
    }

    /// What holds for all lines: points on the surface, apart from each other, ranks ascending.
    fn check(&self, made: &SurfaceLines) {
        assert!(!made.lines.is_empty() || made.finding.is_some(), "lines, or why there are none");
        assert!(made.lines.windows(2).all(|w| w[0].plane <= w[1].plane));
        let count: usize = made.lines.iter().map(|l| l.points.len()).sum();
        for (i, q) in made.lines.iter().flat_map(|l| &l.points).enumerate() {
            assert!((q.n.norm() - 1.0).abs() < 1e-9 && q.p.coords.iter().all(|x| x.is_finite()));
            if i % (count / 300 + 1) == 0 {
                let off = (0..self.mesh.facets.len())
                    .filter(|&f| self.mesh.areas[f] > 0.0)
                    .map(|f| point_triangle(&q.p, &self.mesh.corners(f)))
                    .fold(f64::INFINITY, f64::min);
                assert!(off < 1e-6, "{:?} is {off} mm off the surface", q.p);
            }
        }
        for line in &made.lines {
            assert!(line.points.len() >= 2 && (!line.closed || line.points.len() >= 3));
        }
    }
}

fn achieved(made: &SurfaceLines) -> &Achieved {
    made.achieved.as_ref().expect("neighbours")
}

fn layout(strategy: Strategy, spacing: f64) -> Layout {
    Layout::new(strategy, spacing)
}

/// Index of the border whose points are nearest to `p`.
fn border_at(of: &Alone, p: [f64; 3]) -> usize {
    let found = borders(&of.mesh, of.surface());
    let near = |i: &usize| {
        found[*i].edges.iter().flatten().map(|q| (q - Point3::from(p)).norm()).fold(f64::INFINITY, f64::min)
    };
    (0..found.len()).min_by(|a, b| near(a).total_cmp(&near(b))).expect("a border")
}

/// Frustum of radii 20 and 8, 30 high.
fn frustum() -> Alone {
    Alone::grid(120, 42, true, |u, v| {
        let r = 20.0 - 12.0 * v;
        [r * libm::cos(TAU * u), r * libm::sin(TAU * u), 30.0 * v]
    })
}

/// A cap of 70° about the z axis of a sphere of radius 25, its pole a hole of 4°.
fn cap(from_deg: f64) -> Alone {
    Alone::grid(120, 42, true, |u, v| {
        let t = (70.0 + (from_deg - 70.0) * v).to_radians();
        [25.0 * libm::sin(t) * libm::cos(TAU * u), 25.0 * libm::sin(t) * libm::sin(TAU * u), 25.0 * libm::cos(t)]
    })
}

/// Of a torus of radii 30 and 8 the outer 70° above its middle plane.
fn torus() -> Alone {
    Alone::grid(150, 34, true, |u, v| {
        let t = (70.0 * v).to_radians();
        let (r, z) = (30.0 + 8.0 * libm::cos(t), 8.0 * libm::sin(t));
        [r * libm::cos(TAU * u), r * libm::sin(TAU * u), z]
    })
}

fn saddle() -> Alone {
    Alone::grid(72, 72, false, |u, v| {
        let (x, y) = (40.0 * u - 20.0, 40.0 * v - 20.0);
        [x, y, x * y / 25.0]
    })
}

#[test]
fn adaptive_planes_keep_the_spacing_on_the_surface() {
    let x = Direction::Along([1.0, 0.0, 0.0]);
    let z = Direction::Along([0.0, 0.0, 1.0]);
    for (name, of, m) in [("cone", frustum(), z), ("cap", cap(12.0), z), ("saddle", saddle(), x), ("torus", torus(), z)]
    {
        for spacing in [0.5, 1.3] {
            let made = of.laid(&layout(Strategy::Adaptive, spacing), m);
            let max = achieved(&made).max_mm;
            println!("{name} {spacing}: {:?}..{max} at {:?}", achieved(&made).min_mm, achieved(&made).max_at);
            assert!((max / spacing - 1.0).abs() < 0.01, "{name}: {max} for {spacing}");
        }
    }
}

#[test]
fn offset_lines_keep_the_spacing_from_a_border() {
    let rings = [
        ("cone", frustum(), [20.0, 0.0, 0.0]),
        ("cone from above", frustum(), [8.0, 0.0, 30.0]),
        ("cap", cap(12.0), [25.0, 0.0, 0.0]),
        ("torus", torus(), [38.0, 0.0, 0.0]),
        ("torus from above", torus(), [32.7, 0.0, 7.5]),
        ("saddle", saddle(), [20.0, 0.0, 0.0]),
    ];
    for (name, of, at) in rings {
        for spacing in [0.5, 1.0] {
            let rule = Layout { border: Some(border_at(&of, at)), ..layout(Strategy::Offset, spacing) };
            let made = of.laid(&rule, Direction::Auto);
            let a = achieved(&made);
            // The last line may be one that closes what is left: it is nearer than the others.
            let last = made.lines.last().map_or(0, |l| l.plane);
            let regular: Vec<_> = made.lines.iter().filter(|l| l.plane < last).cloned().collect();
            let regular = spacing::achieved(&regular, None, spacing).expect("neighbours");
            println!("{name} {spacing}: {}..{}", regular.min_mm, a.max_mm);
            assert!(a.max_mm < 1.01 * spacing, "{name}: {} for {spacing} at {}", a.max_mm, a.max_at);
            assert!(regular.min_mm > 0.99 * spacing, "{name}: {} for {spacing} at {}", regular.min_mm, regular.min_at);
        }
    }
}

#[test]
fn two_triangles_give_nested_squares() {
    let square = Alone::grid(1, 1, false, |u, v| [10.0 * u, 10.0 * v, 0.0]);
    let made = square.laid(&layout(Strategy::Offset, 1.0), Direction::Auto);
    assert_eq!(made.lines.len(), 5);
    for (k, line) in made.lines.iter().enumerate() {
        assert!(line.closed && line.plane == k);
        let off = |q: &Point3<f64>| q.x.min(q.y).min(10.0 - q.x).min(10.0 - q.y);
        let wrong = line.points.iter().map(|q| (off(&q.p) - 0.5 - k as f64).abs()).fold(0.0, f64::max);
        assert!(wrong < 1e-6, "square {k} is {wrong} mm off");
        let corner = Point3::new(0.5 + k as f64, 0.5 + k as f64, 0.0);
        let near = line.points.iter().map(|q| (q.p - corner).norm()).fold(f64::INFINITY, f64::min);
        assert!(near < 1e-6, "square {k} has no corner: {near}");
    }
}

#[test]
fn a_sloping_ridge_is_left_nowhere_too_wide() {
    // 100 long, to both sides of its middle 1.45 wide at one end and 1 at the other: the last lines from the sides,
    // half a spacing off, stand up to 1.9 spacings apart, and less and less.
    let wedge = Alone::grid(100, 6, false, |u, v| [100.0 * u, (2.0 * v - 1.0) * (1.45 - 0.45 * u), 0.0]);
    let made = wedge.laid(&layout(Strategy::Offset, 1.0), Direction::Auto);
    for x in (5..=95).map(|x| Point3::new(f64::from(x), 0.0, 0.0)) {
        let sides = made.lines.iter().flat_map(|l| l.sides());
        let off = sides.map(|(a, b)| point_segment(&x, &a.p, &b.p)).fold(f64::INFINITY, f64::min);
        assert!(off < 0.505, "{x} is {off} mm from a line");
    }
}

#[test]
fn spacing_is_measured_between_the_points_of_a_line_too() {
    // Straight, 100 long; the line before bulges to half the distance in the middle.
    let line = |plane: usize, points: &[[f64; 2]]| TransversalLine {
        plane,
        points: points.iter().map(|p| SectionPoint { p: Point3::new(p[0], p[1], 0.0), n: Vector3::z() }).collect(),
        closed: false,
        dark: Vec::new(),
    };
    let lines = [line(0, &[[0.0, 0.0], [50.0, 0.5], [100.0, 0.0]]), line(1, &[[0.0, 1.0], [100.0, 1.0]])];
    let found = spacing::achieved(&lines, None, 1.0).expect("neighbours");
    assert!((found.min_mm - 0.5).abs() < 1e-3 && (found.min_at.x - 50.0).abs() < 0.5, "{found:?}");
    assert!((found.max_mm - 1.0).abs() < 1e-3);
    let along: Vec<f64> = found.samples.iter().map(|s| s.0.x).collect();
    assert_eq!(along.len(), 101);
    assert!(along.windows(2).all(|w| w[1] - w[0] < 1.0 + 1e-9), "no farther apart than the lines");
}

/// A cap of 70° of a sphere of radius 25 with its pole.
fn whole_cap() -> Alone {
    let (m, n) = (110, 45);
    let mut points = vec![[0.0, 0.0, 25.0]];
    for j in 1..=n {
        let t = (70.0 * j as f64 / n as f64).to_radians();
        points.extend((0..m).map(|i| {
            let a = TAU * i as f64 / m as f64;
            [25.0 * libm::sin(t) * libm::cos(a), 25.0 * libm::sin(t) * libm::sin(a), 25.0 * libm::cos(t)]
        }));
    }
    let v = |i: usize, j: usize| (1 + (j - 1) * m + i % m) as u32;
    let mut facets: Vec<[u32; 3]> = (0..m).map(|i| [0, v(i, 1), v(i + 1, 1)]).collect();
    for j in 1..n {
        for i in 0..m {
            facets.push([v(i, j), v(i, j + 1), v(i + 1, j + 1)]);
            facets.push([v(i, j), v(i + 1, j + 1), v(i + 1, j)]);
        }
    }
    Alone::new(&points, facets)
}

/// A sphere of radius 12 as meridians and parallels.
fn ball() -> Alone {
    let part = clearbeam::sample::solids::sphere(12.0, 100, 50);
    let raw: Vec<_> = part.iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect();
    let mesh = Mesh::weld(&raw, 1.0);
    let points: Vec<[f64; 3]> = mesh.vertices.iter().map(|p| [p.x, p.y, p.z]).collect();
    Alone::new(&points, mesh.facets)
}

fn square(n: usize) -> Alone {
    Alone::grid(n, n, false, |u, v| [30.0 * u - 15.0, 30.0 * v - 15.0, 2.0])
}

fn annulus(m: usize, n: usize) -> Alone {
    // Turned so that it looks up.
    Alone::grid(m, n, true, |u, v| {
        let r = 20.0 - 14.0 * v;
        [r * libm::cos(TAU * u), r * libm::sin(TAU * u), 0.0]
    })
}

#[test]
fn turns_of_a_spiral_lie_one_spacing_apart() {
    let surfaces = [
        ("two triangles", square(1)),
        ("plane", square(70)),
        ("cap", whole_cap()),
        ("sphere", ball()),
        ("annulus", annulus(120, 40)),
        ("coarse annulus", annulus(24, 1)),
    ];
    for (name, of) in surfaces {
        for spacing in [0.7, 1.3] {
            let made = of.laid(&layout(Strategy::Spiral, spacing), Direction::Auto);
            let a = achieved(&made);
            let pieces = made.lines.len();
            println!(
                "{name} {spacing}: {}..{} {pieces} pieces, {:?} {} {}",
                a.min_mm, a.max_mm, made.finding, a.min_at, a.max_at
            );
            assert!(a.max_mm < 1.01 * spacing, "{name}: {} for {spacing} at {}", a.max_mm, a.max_at);
            // Next to the far pole of a closed surface the curves run together again.
            let open = a.samples.iter().filter(|s| name != "sphere" || s.0.z > -11.0);
            let min_mm = open.map(|s| s.1).fold(f64::INFINITY, f64::min);
            assert!(min_mm > 0.99 * spacing, "{name}: {min_mm} for {spacing}");
            // As long as the surface is large for its spacing.
            let length: f64 =
                made.lines.iter().flat_map(|l| l.points.windows(2)).map(|w| (w[1].p - w[0].p).norm()).sum();
            let area: f64 = of.mesh.areas.iter().sum();
            assert!((length * spacing / area - 1.0).abs() < 0.02, "{name}: {length} mm of {}", area / spacing);
            let inward = of.laid(&Layout { inward: true, ..layout(Strategy::Spiral, spacing) }, Direction::Auto);
            assert_eq!(inward.lines.last().and_then(|l| l.points.last()), made.lines[0].points.first());
        }
    }
}

/// Every strategy on a surface: lines or a reason, on the surface, twice the same; never a panic.
fn all(of: &Alone, spacing: f64) -> Vec<SurfaceLines> {
    Strategy::ALL.iter().map(|&s| of.laid(&layout(s, spacing), Direction::Auto)).collect()
}

#[test]
fn odd_surfaces_give_lines_or_a_reason() {
    let moebius = {
        let n = 60;
        let mut points = Vec::new();
        for i in 0..n {
            let a = TAU * f64::from(i) / f64::from(n);
            for w in [-4.0, 4.0] {
                let r = 20.0 + w * libm::cos(0.5 * a);
                points.push([r * libm::cos(a), r * libm::sin(a), w * libm::sin(0.5 * a)]);
            }
        }
        let mut facets = Vec::new();
        for i in 0..n as u32 {
            let (a, b) = (2 * i, 2 * i + 1);
            let (c, d) = if i + 1 == n as u32 { (1, 0) } else { (a + 2, b + 2) };
            facets.extend([[a, c, d], [a, d, b]]);
        }
        Alone::new(&points, facets)
    };
    let islands = {
        let one = square(10);
        let mut points: Vec<[f64; 3]> = one.mesh.vertices.iter().map(|p| [p.x, p.y, p.z]).collect();
        let count = points.len() as u32;
        points.extend(points.clone().iter().map(|p| [p[0] + 50.0, p[1], p[2] + 3.0]));
        let mut facets = one.mesh.facets.clone();
        facets.extend(one.mesh.facets.iter().map(|f| f.map(|v| v + count)));
        Alone::new(&points, facets)
    };
    let single = Alone::new(&[[0.0; 3], [10.0, 0.0, 0.0], [2.0, 7.0, 0.0]], vec![[0, 1, 2]]);
    let dead = Alone::new(
        &[[0.0; 3], [10.0, 0.0, 0.0], [2.0, 7.0, 0.0], [5.0, 0.0, 0.0]],
        vec![[0, 1, 2], [0, 3, 1], [0, 0, 1], [0, 1, 2], [1, 2, 0]],
    );
    let only_dead = Alone::new(&[[0.0; 3], [10.0, 0.0, 0.0], [5.0, 0.0, 0.0]], vec![[0, 1, 2], [0, 0, 1]]);
    let fin = Alone::new(
        &[[0.0; 3], [10.0, 0.0, 0.0], [5.0, 8.0, 0.0], [5.0, -8.0, 0.0], [5.0, 0.0, 8.0]],
        vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]],
    );
    let cases = [
        ("ring", annulus(60, 4), 1.0),
        ("moebius", moebius, 0.8),
        ("holes", plate(50), 3.0),
        ("islands", islands, 1.0),
        ("small", square(8), 100.0),
        ("single", single, 0.5),
        ("single small", Alone::new(&[[0.0; 3], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0]], vec![[0, 1, 2]]), 2.0),
        ("dead", dead, 0.5),
        ("only dead", only_dead, 0.5),
        ("fin", fin, 0.5),
        ("tube", Alone::grid(16, 1, true, |u, v| [5.0 * libm::cos(TAU * u), 5.0 * libm::sin(TAU * u), 40.0 * v]), 1.0),
        ("ball", ball(), 2.0),
    ];
    for (name, of, spacing) in cases {
        for (made, strategy) in all(&of, spacing).iter().zip(Strategy::ALL) {
            let figures = made.achieved.as_ref().map(|a| (a.min_mm, a.max_mm, a.min_at, a.max_at));
            println!("{name} {}: {} lines, {figures:?}, {:?}", strategy.word(), made.lines.len(), made.finding);
        }
    }
    let made = square(5).laid(&layout(Strategy::Planes, f64::NAN), Direction::Auto);
    assert!(made.lines.is_empty() && made.finding.is_some());
}

/// A plate of 110 by 60 with so many round holes, of slivers from hole to hole.
fn plate(holes: usize) -> Alone {
    let mut flat: Vec<[f64; 2]> = vec![[0.0, 0.0], [110.0, 0.0], [110.0, 60.0], [0.0, 60.0]];
    let mut starts = Vec::new();
    for h in 0..holes {
        starts.push(flat.len());
        let (x, y) = (10.0 + 10.0 * (h % 10) as f64, 10.0 + 10.0 * (h / 10) as f64);
        flat.extend((0..24).map(|i| {
            let a = TAU * f64::from(i) / 24.0;
            [x + 2.5 * libm::cos(a), y + 2.5 * libm::sin(a)]
        }));
    }
    let mut corners: Vec<usize> = Vec::new();
    earcut::Earcut::new().earcut(flat.iter().copied(), &starts, &mut corners);
    let points: Vec<[f64; 3]> = flat.iter().map(|p| [p[0], p[1], 0.0]).collect();
    let facets = corners.chunks_exact(3).map(|t| {
        let (a, b, c) = (flat[t[0]], flat[t[1]], flat[t[2]]);
        let up = (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]);
        if up { [t[0], t[1], t[2]] } else { [t[0], t[2], t[1]] }.map(|v| v as u32)
    });
    Alone::new(&points, facets.collect())
}

#[test]
fn offset_lines_of_a_pierced_plate_keep_their_distance() {
    let made = plate(50).laid(&layout(Strategy::Offset, 1.0), Direction::Auto);
    let rim = borders(&plate(50).mesh, plate(50).surface());
    assert_eq!(rim.len(), 51);
    assert!((rim[0].length_mm - 340.0).abs() < 1e-9, "the longest first");
    let off = |p: &Point3<f64>| {
        let edges = rim.iter().flat_map(|b| &b.edges);
        edges.map(|[a, b]| point_segment(p, a, b)).fold(f64::INFINITY, f64::min)
    };
    let wrong: Vec<f64> = made
        .lines
        .iter()
        .filter(|l| l.plane < 2)
        .flat_map(|l| l.points.iter().step_by(7).map(|q| (off(&q.p) - 0.5 - l.plane as f64).abs()))
        .collect();
    let beyond = |mm: f64| wrong.iter().filter(|w| **w > mm).count() as f64 / wrong.len() as f64;
    assert!(beyond(0.01) < 1e-3 && beyond(0.02) == 0.0, "{} of {} points", beyond(0.01), wrong.len());
}
