//! How long a tool takes over a path of several pieces (P4 Table 1): it comes down onto each piece by an arc, follows it as
//! fast as its corners and bends allow, leaves by an arc, and goes to the next piece through the air.
//!
//! Speeds go up and down at one acceleration. A corner is rounded by no more than [`CORNER_MM`], as a controller blends it,
//! which gives the speed through it (junction deviation), and where it turns back it stops; on a bend the acceleration
//! across is held to the same value. A robot's joints may be slower in places: this knows nothing of them, and the time of
//! a program is `program`'s.

use nalgebra::Point3;

/// Corners are rounded by so much, mm: the finest blending zones of robot controllers are 0.3 to 1 mm.
pub const CORNER_MM: f64 = 0.5;

/// Where a path turns by a right angle or more the tool stops: at the ends of a zigzag it leans the other way then. Corners
/// of 90° that are computed come out a little below.
const STOP_COSINE: f64 = 1e-3;

/// How a tool moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolMotion {
    /// Speed on the surface, mm/s.
    pub speed_mm_s: f64,
    /// Acceleration along the path and across it, mm/s².
    pub acceleration_mm_s2: f64,
    /// Radius of the quarter arcs on which it enters and leaves a piece, mm; 0: it goes straight down and up.
    pub arc_mm: f64,
    /// How far it is lifted between pieces, where the arcs do not lift it so far already, mm.
    pub lift_mm: f64,
    /// Speed through the air, mm/s.
    pub air_speed_mm_s: f64,
}

/// How long a path takes, s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PathTime {
    /// On the pieces, with the arcs of entry and exit.
    pub work_s: f64,
    /// Between pieces.
    pub air_s: f64,
}

impl PathTime {
    /// All of it.
    pub fn total_s(&self) -> f64 {
        self.work_s + self.air_s
    }
}

/// The time of a path. Pieces of fewer than two points, speeds and accelerations that are not above 0 take none.
pub fn path_time(pieces: &[Vec<Point3<f64>>], by: &ToolMotion) -> PathTime {
    let is_moving = [by.speed_mm_s, by.acceleration_mm_s2, by.air_speed_mm_s].iter().all(|x| x.is_finite() && *x > 0.0);
    let pieces: Vec<Vec<Point3<f64>>> = pieces.iter().filter(|_| is_moving).map(|p| evened(p)).collect();
    let pieces: Vec<&Vec<Point3<f64>>> = pieces.iter().filter(|p| p.len() > 1).collect();
    let work_s = pieces.iter().map(|piece| piece_s(piece, by)).fold(0.0, |a, b| a + b);
    let between = |w: &[&Vec<Point3<f64>>]| match (w[0].last(), w[1].first()) {
        (Some(from), Some(to)) => air_s((to - from).norm(), by),
        _ => 0.0,
    };
    PathTime { work_s, air_s: pieces.windows(2).map(between).fold(0.0, |a, b| a + b) }
}

/// Points between corners, so far apart, mm: lines that cross facets have points a few hundredths of a millimetre apart whose
/// chords turn by degrees, which no controller follows.
const STEP_MM: f64 = 1.0;
/// What turns more sharply at one point is a corner: lines over facets turn by less, and a circle of 3 mm in steps.
const CORNER_COSINE: f64 = 0.94;

/// The path with its corners, and points at even steps between them.
fn evened(points: &[Point3<f64>]) -> Vec<Point3<f64>> {
    let mut apart: Vec<Point3<f64>> = points.to_vec();
    apart.dedup_by(|b, a| (*b - *a).norm() < 1e-6);
    let is_corner = |w: &[Point3<f64>]| {
        let (into, out) = (w[1] - w[0], w[2] - w[1]);
        into.dot(&out) < CORNER_COSINE * into.norm() * out.norm()
    };
    let (Some(&first), Some(last)) = (apart.first(), apart.len().checked_sub(1)) else { return Vec::new() };
    let corners = apart.windows(3).enumerate().filter(|(_, w)| is_corner(w)).map(|(i, _)| i + 1);
    let mut out = vec![first];
    let mut from = 0;
    for to in corners.chain([last]).filter(|to| *to > 0).collect::<Vec<_>>() {
        let run = &apart[from..=to];
        let length_mm: f64 = run.windows(2).map(|w| (w[1] - w[0]).norm()).sum();
        let steps = (length_mm / STEP_MM).ceil().max(1.0);
        let (mut walked_mm, mut next) = (0.0, 1.0);
        for w in run.windows(2) {
            let way = w[1] - w[0];
            while next < steps && next * length_mm / steps <= walked_mm + way.norm() {
                out.push(w[0] + way * ((next * length_mm / steps - walked_mm) / way.norm()));
                next += 1.0;
            }
            walked_mm += way.norm();
        }
        out.push(apart[to]);
        from = to;
    }
    out
}

/// From rest at the beginning of the arc of entry to rest at the end of that of exit.
fn piece_s(points: &[Point3<f64>], by: &ToolMotion) -> f64 {
    let arc_mm = 0.5 * std::f64::consts::PI * by.arc_mm.max(0.0);
    let arc_speed = by.speed_mm_s.min((by.acceleration_mm_s2 * by.arc_mm.max(0.0)).sqrt());
    let mut lengths = vec![arc_mm];
    lengths.extend(points.windows(2).map(|w| (w[1] - w[0]).norm()));
    lengths.push(arc_mm);
    // Most at each joint: at rest, onto the line, at its corners, off the line, at rest.
    let mut most = vec![0.0, if arc_mm > 0.0 { arc_speed } else { 0.0 }];
    most.extend(points.windows(3).map(|w| corner_speed(w, by)));
    most.extend([if arc_mm > 0.0 { arc_speed } else { 0.0 }, 0.0]);
    // Between two points of a bend no more than at them; from stop to stop it is straight.
    let bends: Vec<f64> = most.windows(2).map(|w| w[0].max(w[1])).collect();
    let on_line = |i: usize| if bends[i] > 0.0 { bends[i] } else { by.speed_mm_s };
    let limit = |i: usize| if i == 0 || i + 1 == lengths.len() { arc_speed } else { on_line(i) };
    let reached = |from: f64, length: f64| (from * from + 2.0 * by.acceleration_mm_s2 * length).sqrt();
    for i in 0..lengths.len() {
        most[i + 1] = f64::min(most[i + 1], reached(most[i], lengths[i]));
    }
    for i in (0..lengths.len()).rev() {
        most[i] = f64::min(most[i], reached(most[i + 1], lengths[i]));
    }
    let times = lengths.iter().enumerate().map(|(i, &length)| {
        trapezoid_s(length, [most[i], most[i + 1]], limit(i).max(most[i]).max(most[i + 1]), by.acceleration_mm_s2)
    });
    times.fold(0.0, |a, b| a + b)
}

/// The speed through the middle one of three points, mm/s.
fn corner_speed(points: &[Point3<f64>], by: &ToolMotion) -> f64 {
    let (into, out) = (points[1] - points[0], points[2] - points[1]);
    let (before, behind) = (into.norm(), out.norm());
    if before <= 0.0 || behind <= 0.0 {
        return by.speed_mm_s;
    }
    let cosine = (into.dot(&out) / (before * behind)).clamp(-1.0, 1.0);
    if cosine <= STOP_COSINE {
        return 0.0;
    }
    let half = (0.5 * (1.0 + cosine)).sqrt();
    if half >= 1.0 {
        return by.speed_mm_s;
    }
    // A circle that touches both sides and passes CORNER_MM from the corner.
    let corner = (by.acceleration_mm_s2 * CORNER_MM * half / (1.0 - half)).sqrt();
    // Chords of a bend: half the way to both neighbours turns by the angle between them.
    let turn = 2.0 * libm::acos(half);
    let bend = (by.acceleration_mm_s2 * 0.5 * (before + behind) / turn).sqrt();
    by.speed_mm_s.min(corner.min(bend))
}

/// The time of a straight stretch between two speeds.
fn trapezoid_s(length_mm: f64, [from, to]: [f64; 2], limit: f64, acceleration: f64) -> f64 {
    if length_mm <= 0.0 {
        return 0.0;
    }
    let peak = (0.5 * (from * from + to * to) + acceleration * length_mm).sqrt().min(limit);
    let ramp = |speed: f64| (peak * peak - speed * speed).max(0.0) / (2.0 * acceleration);
    let even_mm = (length_mm - ramp(from) - ramp(to)).max(0.0);
    (2.0 * peak - from - to).max(0.0) / acceleration + if peak > 0.0 { even_mm / peak } else { 0.0 }
}

/// Through the air over a distance: up, across and down, each from rest to rest.
fn air_s(distance_mm: f64, by: &ToolMotion) -> f64 {
    let lift_mm = (by.lift_mm - by.arc_mm).max(0.0);
    let way = |mm: f64| trapezoid_s(mm, [0.0, 0.0], by.air_speed_mm_s, by.acceleration_mm_s2);
    2.0 * way(lift_mm) + way(distance_mm)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: ToolMotion =
        ToolMotion { speed_mm_s: 50.0, acceleration_mm_s2: 500.0, arc_mm: 0.0, lift_mm: 0.0, air_speed_mm_s: 100.0 };

    fn at(x: f64, y: f64) -> Point3<f64> {
        Point3::new(x, y, 0.0)
    }

    #[test]
    fn straight_ways_take_what_a_trapezoid_takes() {
        let long = path_time(&[vec![at(0.0, 0.0), at(30.0, 0.0), at(100.0, 0.0)]], &PLAIN);
        assert!((long.work_s - (100.0 / 50.0 + 50.0 / 500.0)).abs() < 1e-12, "{long:?}");
        let short = path_time(&[vec![at(0.0, 0.0), at(1.0, 0.0)]], &PLAIN);
        assert!((short.work_s - 2.0 * (1.0f64 / 500.0).sqrt()).abs() < 1e-12, "{short:?}");
        let arc = ToolMotion { arc_mm: 10.0, ..PLAIN };
        let entered = path_time(&[vec![at(0.0, 0.0), at(100.0, 0.0)]], &arc).work_s;
        let arc_mm = 5.0 * std::f64::consts::PI;
        assert!((entered - ((100.0 + 2.0 * arc_mm) / 50.0 + 50.0 / 500.0)).abs() < 1e-12, "{entered}");
        let two = path_time(&[vec![at(0.0, 0.0), at(100.0, 0.0)], vec![at(100.0, 80.0), at(0.0, 80.0)]], &PLAIN);
        assert!((two.air_s - (80.0 / 100.0 + 100.0 / 500.0)).abs() < 1e-12, "{two:?}");
        assert_eq!(path_time(&[vec![at(0.0, 0.0)]], &PLAIN), PathTime::default());
        assert_eq!(
            path_time(&[vec![at(0.0, 0.0), at(9.0, 0.0)]], &ToolMotion { speed_mm_s: 0.0, ..PLAIN }).total_s(),
            0.0
        );
    }

    #[test]
    fn a_bend_of_many_chords_costs_no_stop_and_a_tight_one_costs_speed() {
        let circle = |radius: f64, chords: i32| -> Vec<Point3<f64>> {
            let turn = |k: i32| std::f64::consts::TAU * f64::from(k) / f64::from(chords);
            (0..=chords).map(|k| at(radius * libm::cos(turn(k)), radius * libm::sin(turn(k)))).collect()
        };
        let way = std::f64::consts::TAU;
        let wide = path_time(&[circle(40.0, 360)], &PLAIN).work_s;
        assert!((wide - (way * 40.0 / 50.0 + 0.1)).abs() < 0.01, "{wide}");
        // √(500·5) = 50 mm/s is all that 5 mm of radius allow.
        let tight = path_time(&[circle(5.0, 144)], &ToolMotion { speed_mm_s: 100.0, ..PLAIN }).work_s;
        assert!((tight - way * 5.0 / 50.0 - 50.0 / 500.0).abs() < 0.02, "{tight}");
    }

    #[test]
    fn a_corner_is_slower_the_sharper_it_is() {
        let corner = |degrees: f64| {
            let turn = degrees.to_radians();
            let end = at(100.0 + 100.0 * libm::cos(turn), 100.0 * libm::sin(turn));
            path_time(&[vec![at(0.0, 0.0), at(100.0, 0.0), end]], &PLAIN).work_s
        };
        let all: Vec<f64> = [0.0, 10.0, 30.0, 60.0, 89.0, 90.0, 150.0, 180.0].into_iter().map(corner).collect();
        assert!(all.windows(2).all(|w| w[0] <= w[1]), "{all:?}");
        assert!((all[0] - 4.1).abs() < 1e-12 && all[5..].iter().all(|s| (s - 4.2).abs() < 1e-9), "{all:?}");
    }

    #[test]
    fn points_beside_a_line_by_less_than_anyone_follows_cost_nothing() {
        let jagged: Vec<Point3<f64>> =
            (0..=2000).map(|i| at(f64::from(i) * 0.05, if i % 3 == 0 { 0.004 } else { 0.0 })).collect();
        let straight = path_time(&[vec![at(0.0, 0.0), at(100.0, 0.0)]], &PLAIN).work_s;
        let found = path_time(&[jagged], &PLAIN).work_s;
        assert!((found - straight).abs() < 0.02, "{found} for {straight}");
    }

    #[test]
    fn on_a_disc_the_spiral_is_quicker_than_the_zigzag_and_that_than_one_way() {
        let (radius, spacing) = (60.0f64, 8.0);
        let rows: Vec<[Point3<f64>; 2]> = (-7..=7)
            .map(|k| f64::from(k) * spacing)
            .map(|y| [at(-(radius * radius - y * y).sqrt(), y), at((radius * radius - y * y).sqrt(), y)])
            .collect();
        let one_way: Vec<Vec<Point3<f64>>> = rows.iter().map(|r| r.to_vec()).collect();
        let turned = |(k, r): (usize, &[Point3<f64>; 2])| if k % 2 == 0 { *r } else { [r[1], r[0]] };
        let zigzag = vec![rows.iter().enumerate().flat_map(turned).collect::<Vec<_>>()];
        let last = (radius / spacing * 72.0) as i32;
        let spiral = (0..=last).map(|k| (std::f64::consts::TAU * f64::from(k) / 72.0, spacing * f64::from(k) / 72.0));
        let spiral = vec![spiral.map(|(turn, r)| at(r * libm::cos(turn), r * libm::sin(turn))).collect::<Vec<_>>()];
        for speed_mm_s in [50.0, 70.0, 90.0, 110.0] {
            let by = ToolMotion { speed_mm_s, arc_mm: 10.0, lift_mm: 10.0, ..PLAIN };
            let [one_way, zigzag, spiral] = [&one_way, &zigzag, &spiral].map(|p| path_time(p, &by).total_s());
            assert!(spiral < zigzag && zigzag < one_way, "{spiral} {zigzag} {one_way} at {speed_mm_s}");
        }
    }
}
