use super::*;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// Without arcs and lifts: what is left is the way on the surface.
const BARE: GrindingMotion = GrindingMotion {
    speed_mm_s: 100.0,
    acceleration_mm_s2: 1000.0,
    arc_radius_mm: 0.0,
    lift_mm: 0.0,
    air_speed_mm_s: 250.0,
    corner_tolerance_mm: 0.1,
};
const WHOLE: GrindingMotion = GrindingMotion { arc_radius_mm: 10.0, lift_mm: 20.0, ..BARE };

fn flat(points: &[[f64; 2]]) -> Vec<Point3<f64>> {
    points.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect()
}

fn total_s(motion: &GrindingMotion, pieces: &[Vec<Point3<f64>>]) -> f64 {
    motion.times(pieces).expect("a time").total_s
}

#[test]
fn a_straight_line_is_a_trapezoid() {
    // s/v + v/a where the speed is reached, 2·√(s/a) where it is not.
    let line = |length: f64| vec![flat(&[[0.0, 0.0], [length, 0.0]])];
    assert!((total_s(&BARE, &line(300.0)) - (3.0 + 0.1)).abs() < 1e-12);
    assert!((total_s(&BARE, &line(4.0)) - 2.0 * (4.0f64 / 1000.0).sqrt()).abs() < 1e-12);
    // Points on the way change nothing.
    let many = vec![(0..=30).map(|k| Point3::new(10.0 * f64::from(k), 0.0, 0.0)).collect()];
    assert!((total_s(&BARE, &many) - 3.1).abs() < 1e-9);
}

#[test]
fn arcs_and_lifts_are_those_of_their_lengths() {
    let times = WHOLE.times(&[flat(&[[0.0, 0.0], [300.0, 0.0]])]).expect("a time");
    // Arcs of 10 mm radius bear √(1000·10) = 100 mm/s: one way of 300 + 10·π, from rest to rest.
    let way = 300.0 + 10.0 * PI;
    assert!((times.contact_s + times.arcs_s - (way / 100.0 + 0.1)).abs() < 1e-12);
    assert!((times.contact_s - 3.0).abs() < 1e-12);
    // 10 mm down and 10 mm up, too short for 250 mm/s.
    assert!((times.air_s - 2.0 * 2.0 * (10.0f64 / 1000.0).sqrt()).abs() < 1e-12);
    let two = WHOLE.times(&[flat(&[[0.0, 0.0], [300.0, 0.0]]), flat(&[[0.0, 5.0], [300.0, 5.0]])]).expect("a time");
    let over = (300.0f64 * 300.0 + 25.0).sqrt();
    assert!((two.total_s - 2.0 * times.total_s - (over / 250.0 + 0.25)).abs() < 1e-12);
    assert_eq!((two.pieces, two.stops), (2, 0));
}

#[test]
fn a_corner_is_passed_as_fast_as_its_arc_bears() {
    let corner = |deg: f64, side: f64| {
        let (s, c) = (libm::sin(deg.to_radians()), libm::cos(deg.to_radians()));
        vec![flat(&[[0.0, 0.0], [side, 0.0], [side + side * c, side * s]])]
    };
    // An L is two lines.
    let l = BARE.times(&corner(90.0, 100.0)).expect("a time");
    assert!((l.total_s - 2.0 * 1.1).abs() < 1e-12 && l.stops == 1);
    // 60°: r = δ·cos 30° / (1 − cos 30°), v² = a·r; braked from 100 mm/s and back.
    let v = (1000.0 * 0.1 * 0.75f64.sqrt() / (1.0 - 0.75f64.sqrt())).sqrt();
    let braked = 2.0 * ((100.0 - v) / 1000.0 - (10_000.0 - v * v) / 2000.0 / 100.0);
    assert!((total_s(&BARE, &corner(60.0, 100.0)) - (2.0 + 0.1 + braked)).abs() < 1e-12);
    // Without a tolerance every corner is a stop.
    let exact = GrindingMotion { corner_tolerance_mm: 0.0, ..BARE };
    assert!((total_s(&exact, &corner(60.0, 100.0)) - 2.2).abs() < 1e-12);
}

#[test]
fn a_circle_of_many_chords_has_no_stops() {
    let circle = |radius: f64, chords: u32| {
        let at = |k: u32| TAU * f64::from(k) / f64::from(chords);
        vec![flat(&(0..=chords).map(|k| [radius * libm::cos(at(k)), radius * libm::sin(at(k))]).collect::<Vec<_>>())]
    };
    for chords in [100, 1000, 10_000] {
        let times = BARE.times(&circle(50.0, chords)).expect("a time");
        assert!((times.total_s - (times.length_mm / 100.0 + 0.1)).abs() < 1e-9 && times.stops == 0);
        // At 2.5 mm radius 1000 mm/s² bear 50 mm/s, however many chords there are.
        let small = BARE.times(&circle(2.5, chords)).expect("a time");
        let slow = small.length_mm / 50.0 + 0.05;
        assert!((small.total_s / slow - 1.0).abs() < 0.03, "{chords}: {} for {slow}", small.total_s);
    }
}

/// P4's three ways over a disc of 60 mm radius, lines 8 mm apart.
fn ways() -> [Vec<Vec<Point3<f64>>>; 3] {
    let (radius, spacing) = (60.0, 8.0);
    let line = |k: u32| {
        let y = -radius + spacing * (f64::from(k) + 0.5);
        let x = (radius * radius - y * y).sqrt();
        [[-x, y], [x, y]]
    };
    let lines: Vec<[[f64; 2]; 2]> = (0..15).map(line).collect();
    let one_way = lines.iter().map(|l| flat(l)).collect();
    let turned = |(k, l): (usize, &[[f64; 2]; 2])| if k % 2 == 0 { *l } else { [l[1], l[0]] };
    let zigzag = vec![flat(&lines.iter().enumerate().flat_map(turned).collect::<Vec<_>>())];
    let outer = radius - 0.5 * spacing;
    let turns = outer / spacing;
    let steps = 2000u32;
    // Out to the rim, and once around it.
    let at = |k: u32| {
        let angle = TAU * (turns + 1.0) * f64::from(k) / f64::from(steps);
        let r = (spacing * angle / TAU).min(outer);
        [r * libm::cos(angle), r * libm::sin(angle)]
    };
    [one_way, zigzag, vec![flat(&(0..=steps).map(at).collect::<Vec<_>>())]]
}

#[test]
fn on_a_disc_the_spiral_is_quickest_and_one_way_slowest() {
    let ways = ways();
    for speed_mm_s in [50.0, 70.0, 90.0, 110.0] {
        let motion = GrindingMotion { speed_mm_s, ..WHOLE };
        let [one_way, zigzag, spiral] = ways.each_ref().map(|way| motion.times(way).expect("a time"));
        println!("{speed_mm_s}: {:.1} {:.1} {:.1} s", one_way.total_s, zigzag.total_s, spiral.total_s);
        assert!(spiral.total_s < zigzag.total_s && zigzag.total_s < one_way.total_s);
        assert_eq!([one_way.pieces, zigzag.pieces, spiral.pieces], [15, 1, 1]);
        assert_eq!(spiral.stops, 0);
    }
}

#[test]
fn what_tells_no_time_is_told() {
    let line = vec![flat(&[[0.0, 0.0], [f64::NAN, 0.0]])];
    assert_eq!(BARE.times(&line), Err(GrindingMotionError::Point { piece: 0, point: 1 }));
    let still = GrindingMotion { speed_mm_s: 0.0, ..BARE };
    assert_eq!(still.times(&[]), Err(GrindingMotionError::Figure { key: "speed_mm_s", value: 0.0 }));
    let dot = vec![Vec::new(), flat(&[[1.0, 1.0]]), flat(&[[1.0, 1.0], [1.0, 1.0]])];
    assert_eq!(BARE.times(&dot), Ok(GrindingTimes::default()));
}

proptest! {
    /// No path is quicker than its length by its speed; more acceleration or speed is never slower; backwards takes as long.
    #[test]
    fn laws_of_any_path(points in prop::collection::vec(prop::array::uniform2(-50.0..50.0f64), 2..12), speed in 20.0..200.0f64,
                        acceleration in 200.0..5000.0f64, tolerance in 0.0..1.0f64) {
        let motion = GrindingMotion { speed_mm_s: speed, acceleration_mm_s2: acceleration, corner_tolerance_mm: tolerance, ..WHOLE };
        let way = vec![flat(&points)];
        let times = motion.times(&way).expect("a time");
        prop_assert!(times.contact_s >= times.length_mm / speed - 1e-9);
        prop_assert!((times.contact_s + times.arcs_s + times.air_s - times.total_s).abs() < 1e-9);
        let more = |m: GrindingMotion| m.times(&way).expect("a time").total_s <= times.total_s + 1e-9;
        let quicker = [
            GrindingMotion { acceleration_mm_s2: 2.0 * acceleration, ..motion },
            GrindingMotion { speed_mm_s: 2.0 * speed, ..motion },
            GrindingMotion { corner_tolerance_mm: 2.0 * tolerance, ..motion },
        ];
        prop_assert!(quicker.into_iter().all(more));
        let back: Vec<Vec<Point3<f64>>> = way.iter().map(|p| p.iter().rev().copied().collect()).collect();
        prop_assert!((total_s(&motion, &back) - times.total_s).abs() < 1e-9);
    }
}
