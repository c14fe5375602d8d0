//! The dose against closed forms: lines and rasters of every profile, tilted and round surfaces, shadow,
//! rims, the balance of energy, and what must not matter.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::beam::{Obstacle, Optics, ProcessSettings};
use clearbeam::document::{Document, Edit, Job, segmented};
use clearbeam::part::{Part, Placement, SurfaceId, Surfaces};
use clearbeam::planning;
use clearbeam::pose::target::travel;
use clearbeam::pose::{Correction, Obstruction, Pass, Target, TargetState};
use clearbeam::process::{
    DoseInput, DoseMap, DoseSample, Light, Patch, PatchCause, Profile, Spot, Thresholds, WayTime, dose,
};
use clearbeam::progress::Progress;
use clearbeam::sample::{Triangles, solids};
use clearbeam::text::{Naming, Sentence, dose_lines};
use nalgebra::{Point3, Vector3};
use parts::{block, near, part, placed, planned_at, sheet};
use std::collections::BTreeMap;
use std::f64::consts::PI;

const POWER_W: f64 = 300.0;
const SPEED: f64 = 4.0;
const LOW: Thresholds = Thresholds { low_j_cm2: 1.0, high_j_cm2: 1e9, collateral_j_cm2: 1.0 };

fn spot(profile: Profile) -> Spot {
    Spot { profile, line_mm: 3.0, spot_mm: 1.2, defocus_mm: 20.0, optics: optics() }
}

/// Such that the spot is what the optics make it: √(1 + (20/2)²) times the focus.
fn optics() -> Optics {
    Optics { focus_spot_mm: 1.2 / 101f64.sqrt(), ..Optics::default() }
}

/// A straight lit line from one point to another, the beam along `a`.
fn line(from: [f64; 3], to: [f64; 3], a: [f64; 3]) -> Pass {
    let (p, q, a) = (Point3::from(from), Point3::from(to), Vector3::from(a).normalize());
    let o = travel(&(q - p), &a);
    let target = |p: Point3<f64>, laser: bool| Target {
        p,
        n: a,
        foot: p,
        a,
        o,
        state: TargetState::Free,
        laser,
        normal_hits: None,
        clearance_mm: None,
    };
    Pass {
        surface: 1,
        settings: ProcessSettings {
            defocus_mm: 20.0,
            spot_mm: 1.2,
            speed_mm_s: SPEED,
            power_w: POWER_W,
            ..ProcessSettings::default()
        },
        plane_normal: Vector3::z(),
        closed: false,
        targets: vec![target(p, false), target(q, true)],
        splits: Vec::new(),
        line_points: 2,
        dense_points: 2,
        chord_error_mm: 0.0,
    }
}

fn light(passes: &[Pass], spot: Spot) -> Light {
    let settings = |p: &Pass| ProcessSettings { defocus_mm: spot.defocus_mm, spot_mm: spot.spot_mm, ..p.settings };
    let passes: Vec<Pass> = passes.iter().map(|p| Pass { settings: settings(p), ..p.clone() }).collect();
    Light::new(&passes, &spot, |_, _| None)
}

fn map_on(part: &Part, passes: &[Pass], spot: Spot, clamps: &[Obstacle]) -> (DoseMap, Surfaces) {
    let surfaces = segmented(part, &Job::default());
    let chosen = surfaces.list.iter().map(|s| s.number).collect();
    let task = DoseInput { part, surfaces: &surfaces, clamps, chosen, thresholds: LOW, own: BTreeMap::new() };
    let map = dose(&task, light(passes, spot), &Progress::default()).expect("nobody cancels");
    (map, surfaces)
}

/// A sheet 20 by 20 mm in z = 0, its upper side the outer one.
fn plate() -> Triangles {
    sheet(&[[-10.0, 0.0], [10.0, 0.0]], 20.0)
}

fn centre(s: &DoseSample) -> [f64; 3] {
    s.centre.map(f64::from)
}

fn gauss(x: f64, r: f64) -> f64 {
    (2.0 / PI).sqrt() / r * libm::exp(-2.0 * x * x / (r * r))
}

/// Φ scaled to a spot: the share of a Gaussian line's power below x.
fn below(x: f64, r: f64) -> f64 {
    0.5 * (1.0 + libm::erf(2f64.sqrt() * x / r))
}

/// J/cm² of a line along x at y = 10, |x| ≤ 5, at a place on the plate.
fn one_line(profile: Profile, x: f64, y: f64) -> f64 {
    let (r, c) = (0.6, y - 10.0);
    let run = below(x + 5.0, r) - below(x - 5.0, r);
    let per_mm = match profile {
        Profile::Gaussian => gauss(c, r) * run,
        Profile::TopHat if c.abs() >= r => 0.0,
        Profile::TopHat => {
            let half = (r * r - c * c).sqrt();
            ((x + half).min(5.0) - (x - half).max(-5.0)).max(0.0) / (PI * r * r)
        }
        Profile::Line => {
            if c.abs() <= 1.5 {
                run / 3.0
            } else {
                0.0
            }
        }
    };
    100.0 * POWER_W / SPEED * per_mm
}

#[test]
fn one_line_has_the_profile_of_its_spot() {
    for profile in Profile::ALL {
        let (map, _) =
            map_on(&part(&plate()), &[line([-5.0, 10.0, 0.0], [5.0, 10.0, 0.0], [0.0, 0.0, 1.0])], spot(profile), &[]);
        let peak = one_line(profile, 0.0, 10.0);
        assert!(map.sample_mm <= 0.25 * 1.2 + 1e-9 && !map.coarsened);
        for s in &map.samples {
            let [x, y, _] = centre(s);
            let (found, expected) = (f64::from(s.fluence_j_cm2), one_line(profile, x, y));
            assert!((found - expected).abs() < 2e-5 * peak, "{profile:?} at {x}, {y}: {found} instead of {expected}");
            assert_eq!(s.incidence_deg < 0.0, found == 0.0);
            assert!(s.incidence_deg < 1e-3);
            if expected > 1e-4 * peak {
                let corners = map.corners_of(s);
                let wide =
                    corners.iter().flat_map(|a| corners.iter().map(move |b| libm::hypotf(a[0] - b[0], a[1] - b[1])));
                assert!(wide.fold(0.0, f32::max) <= 0.3001);
            }
        }
        let energy: f64 =
            map.samples.iter().map(|s| f64::from(s.fluence_j_cm2) * f64::from(s.area_mm2)).sum::<f64>() / 100.0;
        // The rim of a top-hat runs through samples.
        near("energy", energy, POWER_W * 10.0 / SPEED, if profile == Profile::Gaussian { 2e-4 } else { 0.01 });
    }
}

#[test]
fn a_raster_has_the_mean_and_the_ripple_of_its_spacing() {
    for spacing in [0.3, 0.6, 0.9, 1.2] {
        let passes: Vec<Pass> = (0..40)
            .map(|i| 10.0 + (f64::from(i) - 19.5) * spacing)
            .filter(|y| (0.5..19.5).contains(y))
            .map(|y| line([-9.0, y, 0.0], [9.0, y, 0.0], [0.0, 0.0, 1.0]))
            .collect();
        let (map, _) = map_on(&part(&plate()), &passes, spot(Profile::Gaussian), &[]);
        let mean = 100.0 * POWER_W / (SPEED * spacing);
        let (mut area, mut sum) = (0.0, 0.0);
        let inner = |s: &&DoseSample| centre(s)[0].abs() < 4.0 && (centre(s)[1] - 10.0).abs() < 2.0 * spacing;
        for s in map.samples.iter().filter(inner) {
            let (y, dose, a) = (centre(s)[1], f64::from(s.fluence_j_cm2), f64::from(s.area_mm2));
            // The sum of Gaussians by its harmonics (Poisson): closed form of the ripple.
            let k = |n: f64| 2.0 * libm::exp(-0.5 * (PI * n * 0.6 / spacing) * (PI * n * 0.6 / spacing));
            let phase = 2.0 * PI * (y - (10.0 + 0.5 * spacing)) / spacing;
            let expected =
                mean * (1.0 + (1..4).map(|n| k(f64::from(n)) * libm::cos(f64::from(n) * phase)).sum::<f64>());
            assert!((dose - expected).abs() < 2e-4 * mean, "spacing {spacing}, y {y}: {dose} instead of {expected}");
            (area, sum) = (area + a, sum + a * dose);
            // As many lines as there are within the radius.
            let off = ((y - 10.0) / spacing - 0.5).rem_euclid(1.0) * spacing;
            let lines = |from: f64| (0..5).filter(|n| from + f64::from(*n) * spacing < 0.6).count();
            let close =
                [off, spacing - off].iter().any(|o| ((0.6 - o) / spacing - ((0.6 - o) / spacing).round()).abs() < 0.01);
            assert!(close || usize::from(s.passes) == lines(off) + lines(spacing - off), "{} at {y}", s.passes);
        }
        near("mean", sum / area, mean, 0.02);
    }
}

#[test]
fn a_tilted_plate_gets_the_cosine() {
    for tilt in [20.0f64, 50.0] {
        // The beam leans in the plane across the travel.
        let (s, c) = (libm::sin(tilt.to_radians()), libm::cos(tilt.to_radians()));
        let passes = [line([-9.0, 10.0, 0.0], [9.0, 10.0, 0.0], [0.0, s, c])];
        let wide = Spot { optics: Optics { rayleigh_mm: 1e4, ..Optics::default() }, ..spot(Profile::Gaussian) };
        let (map, _) = map_on(&part(&plate()), &passes, wide, &[]);
        for sample in map.samples.iter().filter(|s| centre(s)[0].abs() < 4.0) {
            let across = (centre(sample)[1] - 10.0) * c;
            let expected = 100.0 * POWER_W / SPEED * gauss(across, 0.6) * c;
            assert!((f64::from(sample.fluence_j_cm2) - expected).abs() < 1e-4 * 100.0 * POWER_W / SPEED);
            assert!(sample.incidence_deg < 0.0 || (f64::from(sample.incidence_deg) - tilt).abs() < 1e-3);
        }
    }
}

/// A wide top-hat from above on a ball and on a cylinder: the angle is that of the place.
#[test]
fn round_surfaces_are_lit_at_the_angle_of_the_place() {
    let wide =
        Spot { spot_mm: 8.0, optics: Optics { rayleigh_mm: 1e5, ..Optics::default() }, ..spot(Profile::Gaussian) };
    let ball = part(&solids::sphere(5.0, 240, 120));
    let (map, _) = map_on(&ball, &[line([-2.0, 0.0, 5.0], [2.0, 0.0, 5.0], [0.0, 0.0, 1.0])], wide, &[]);
    let cylinder = part(&solids::cylinder(5.0, 12.0, 360));
    let (side, _) = map_on(&cylinder, &[line([5.0, 0.0, 3.0], [5.0, 0.0, 9.0], [1.0, 0.0, 0.0])], wide, &[]);
    let check = |s: &DoseSample, cosine: f64, place: [f64; 2], half: f64| {
        if cosine < 0.05 {
            return; // where the facets turn away
        }
        let run = below(place[0] + half, 4.0) - below(place[0] - half, 4.0);
        let expected = 100.0 * POWER_W / SPEED * gauss(place[1], 4.0) * run * cosine;
        let found = f64::from(s.fluence_j_cm2);
        assert!((found - expected).abs() < 0.02 * 100.0 * POWER_W / SPEED * 0.2, "{found} instead of {expected}");
        let angle = libm::acos(cosine).to_degrees();
        assert!((f64::from(s.incidence_deg) - angle).abs() < 1.6, "{} instead of {angle}", s.incidence_deg);
    };
    for s in &map.samples {
        let [x, y, z] = centre(s);
        if z < -0.1 {
            assert_eq!(s.fluence_j_cm2, 0.0, "the far side");
        } else {
            check(s, z / 5.0, [x, y], 2.0);
        }
    }
    for s in side.samples.iter().filter(|s| (3.0..9.0).contains(&centre(s)[2]) && centre(s)[0] > 0.0) {
        let [x, y, z] = centre(s);
        if libm::hypot(x, y) > 4.9 {
            check(s, x / 5.0, [z - 6.0, y], 3.0);
        }
    }
}

/// A roof over half of the plate: its edge at x = 0 in 5 mm height, light straight down along y.
#[test]
fn a_roof_shades_what_lies_under_it() {
    let mut body = plate();
    body.extend(block([-8.0, 2.0, 5.0], [0.0, 18.0, 6.0]));
    let body = part(&body);
    let passes = [line([0.0, 5.0, 0.0], [0.0, 15.0, 0.0], [0.0, 0.0, 1.0])];
    let (map, surfaces) = map_on(&body, &passes, spot(Profile::Gaussian), &[]);
    let plate_surface = surfaces.of_facet[0];
    let peak = 100.0 * POWER_W / SPEED * gauss(0.0, 0.6);
    for s in map.samples.iter().filter(|s| surfaces.of_facet[s.facet as usize] == plate_surface) {
        let [x, y, _] = centre(s);
        if !(8.0..12.0).contains(&y) {
            continue;
        }
        let bare = 100.0 * POWER_W / SPEED * gauss(x, 0.6);
        assert!((f64::from(s.unshaded_j_cm2) - bare).abs() < 1e-4 * peak);
        // Through the focus at (0, 20): light to x < 0 comes over x·(20 − 5)/20 < 0 in 5 mm height.
        let expected = if x > 0.0 { bare } else { 0.0 };
        assert!((f64::from(s.fluence_j_cm2) - expected).abs() < 1e-4 * peak, "{x}: {}", s.fluence_j_cm2);
        if x < 0.0 && bare > 0.1 * peak {
            assert!(
                matches!(s.shaded_by, Some(Obstruction::Facet(f)) if surfaces.of_facet[f as usize] != plate_surface)
            );
        }
    }
    let top: f64 = map
        .samples
        .iter()
        .filter(|s| centre(s)[2] > 5.9)
        .map(|s| f64::from(s.fluence_j_cm2) * f64::from(s.area_mm2))
        .sum::<f64>()
        / 100.0;
    // The spot is narrower there: its radius is two samples.
    near("half of it lands on the roof", top, 0.5 * POWER_W * 10.0 / SPEED, 0.015);
}

/// A spot that runs along a rim, half over it, lights the floor 6 mm beneath with the other half; the
/// spot is wider there.
#[test]
fn half_over_a_rim_lights_the_floor() {
    let mut body = block([-10.0, 0.0, 0.0], [0.0, 20.0, 6.0]);
    body.extend(block([0.0, 0.0, -1.0], [10.0, 20.0, 0.0]));
    let passes = [line([0.0, 5.0, 6.0], [0.0, 15.0, 6.0], [0.0, 0.0, 1.0])];
    let s = spot(Profile::Gaussian);
    let (map, _) = map_on(&part(&body), &passes, s, &[]);
    let r = s.radius_mm(26.0);
    near("wider", r / 0.6, (170.0f64 / 101.0).sqrt(), 1e-9);
    let mut floor = 0.0;
    for sample in map.samples.iter().filter(|s| centre(s)[2].abs() < 1e-3 && centre(s)[0] > 0.0) {
        let [x, y, _] = centre(sample);
        floor += f64::from(sample.fluence_j_cm2) * f64::from(sample.area_mm2) / 100.0;
        if (8.0..12.0).contains(&y) {
            let expected = 100.0 * POWER_W / SPEED * gauss(x, r);
            assert!((f64::from(sample.fluence_j_cm2) - expected).abs() < 1e-3 * expected.max(100.0), "{x}");
        }
    }
    near("the other half", floor, 0.5 * POWER_W * 10.0 / SPEED, 5e-3);
}

/// Light that comes at a moving edge: the shadow moves with the beam, and the energy that passes is
/// what a sum over single moments gives.
#[test]
fn a_crossing_shadow_is_the_sum_of_its_moments() {
    let mut body = plate();
    body.extend(block([-8.0, 2.0, 5.0], [0.0, 18.0, 6.0]));
    // Across the edge: the spot comes out from under the roof.
    let passes = [line([-3.0, 10.0, 0.0], [3.0, 10.0, 0.0], [0.0, 0.0, 1.0])];
    let s = spot(Profile::Gaussian);
    let (map, surfaces) = map_on(&part(&body), &passes, s, &[]);
    let peak = 100.0 * POWER_W / SPEED * gauss(0.0, 0.6);
    for sample in map.samples.iter().filter(|q| surfaces.of_facet[q.facet as usize] == surfaces.of_facet[0]) {
        let [x, y, _] = centre(sample);
        if !(-2.0..2.0).contains(&x) || (y - 10.0).abs() > 0.3 {
            continue;
        }
        // At time t the axis is at t; light to x crosses 5 mm height at x + (t − x)·5/20, in the open if > 0.
        let n = 4000;
        let (mut sum, step) = (0.0, 6.0 / f64::from(n));
        for i in 0..n {
            let t = -3.0 + (f64::from(i) + 0.5) * step;
            let k = 20.0 / 404.0;
            if x - (x - t) * k * 5.0 > 0.0 && x - (x - t) * k * 6.0 > 0.0 {
                sum += gauss(x - t, 0.6) * step;
            }
        }
        let expected = 100.0 * POWER_W / SPEED * gauss(y - 10.0, 0.6) * sum;
        assert!(
            (f64::from(sample.fluence_j_cm2) - expected).abs() < 0.03 * peak,
            "{x}: {} {expected}",
            sample.fluence_j_cm2
        );
    }
}

#[test]
fn a_clamp_shades_as_the_part_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("roof.stl");
    std::fs::write(&file, clearbeam::sample::stl_bytes(&block([-8.0, 2.0, 5.0], [0.0, 18.0, 6.0]))).expect("writes");
    let mut clamp = Obstacle::named(file.display().to_string());
    clamp.load(None).expect("reads");
    let passes = [line([0.0, 5.0, 0.0], [0.0, 15.0, 0.0], [0.0, 0.0, 1.0])];
    let (map, _) = map_on(&part(&plate()), &passes, spot(Profile::Gaussian), &[clamp]);
    let peak = 100.0 * POWER_W / SPEED * gauss(0.0, 0.6);
    for s in map.samples.iter().filter(|s| (8.0..12.0).contains(&centre(s)[1])) {
        let x = centre(s)[0];
        let expected = if x > 0.0 { 100.0 * POWER_W / SPEED * gauss(x, 0.6) } else { 0.0 };
        assert!((f64::from(s.fluence_j_cm2) - expected).abs() < 1e-4 * peak);
        if x > 0.0 || f64::from(s.unshaded_j_cm2) > 1e-3 * peak {
            assert_eq!(s.shaded_by, (x < 0.0).then_some(Obstruction::Clamp(0)), "{x}");
        }
    }
}

/// A line of many short moves is worked out as few pieces, and gives what one move gives; one that bends
/// or turns is not taken for straight.
#[test]
fn short_moves_are_joined_where_they_run_straight() {
    let targets = |stand: &dyn Fn(f64) -> ([f64; 3], f64)| {
        let mut pass = line([-5.0, 10.0, 0.0], [5.0, 10.0, 0.0], [0.0, 0.0, 1.0]);
        let one = pass.targets[1];
        pass.targets = (0..=100)
            .map(|i| {
                let (p, lean_deg) = stand(f64::from(i) / 100.0);
                let a = Vector3::new(0.0, libm::sin(lean_deg.to_radians()), libm::cos(lean_deg.to_radians()));
                Target { p: Point3::from(p), foot: Point3::from(p), a, laser: i > 0, ..one }
            })
            .collect();
        pass
    };
    let straight = light(&[targets(&|t| ([10.0 * t - 5.0, 10.0, 0.0], 0.0))], spot(Profile::Gaussian));
    assert_eq!(straight.pieces.len(), 3, "no longer than three spots");
    let seconds: f64 = straight.pieces.iter().map(|p| p.seconds).sum();
    near("time", seconds, 10.0 / SPEED, 1e-9);
    let bent = |t: f64| [10.0 * t - 5.0, 10.0 + libm::sin(20.0 * t), 0.0];
    let bends = light(&[targets(&|t| (bent(t), 0.0))], spot(Profile::Gaussian));
    for piece in &bends.pieces {
        let t = |p: &Point3<f64>| (p.x + 5.0) / 10.0;
        let (a, b) = (t(&piece.from.p), t(&piece.to.p));
        for k in 1..10 {
            let share = f64::from(k) / 10.0;
            let (on, of) = (piece.from.p + (piece.to.p - piece.from.p) * share, bent(a + (b - a) * share));
            assert!((on.y - of[1]).abs() < 0.02, "{} {}", on.y, of[1]);
        }
    }
    let turns = light(&[targets(&|t| ([10.0 * t - 5.0, 10.0, 0.0], 30.0 * t * t))], spot(Profile::Gaussian));
    assert!(turns.pieces.iter().all(|p| parts::angle_deg(&p.from.a, &p.to.a) <= 4.001));
    for piece in &turns.pieces {
        let (a, b) = ((piece.from.p.x + 5.0) / 10.0, (piece.to.p.x + 5.0) / 10.0);
        let lean = 30.0 * (0.5 * (a + b)) * (0.5 * (a + b));
        let wanted = Vector3::new(0.0, libm::sin(lean.to_radians()), libm::cos(lean.to_radians()));
        assert!(parts::angle_deg(&piece.axis(0.5), &wanted) < 0.25);
    }
}

/// A groove job, planned and computed.
fn groove(placement: &Placement) -> (DoseMap, parts::Planned) {
    let body = placed(&solids::v_groove(30.0, 6.0, 5.0, 12.0), placement);
    let mut job = parts::job("z", 1.0);
    job.layers.direction = clearbeam::path::Direction::Auto;
    let planned = parts::planned(body, job);
    let map = planning::dose(
        &planned.part,
        &planned.surfaces,
        &planned.plan,
        &planned.job,
        &parts::setup(),
        &Progress::default(),
    )
    .expect("a dose");
    (map, planned)
}

#[test]
fn a_moved_or_turned_part_gets_the_same() {
    let (map, one) = groove(&Placement::default());
    let shares = map.shares(&one.surfaces);
    assert!((shares.within + shares.under + shares.over + shares.shaded - 1.0).abs() < 1e-9);
    let whole: f64 = map.histogram(&one.surfaces, 50, 1e5).iter().sum();
    near("the histogram holds all", whole, one.surfaces.list.iter().map(|s| s.area_mm2).sum(), 1e-5);
    for rotation_deg in [[0.0, 0.0, 90.0], [90.0, 0.0, 0.0]] {
        let moved = Placement { rotation_deg, translation_mm: [7.0, -3.0, 50.0], ..Placement::default() };
        let (again, other) = groove(&moved);
        let same = again.shares(&other.surfaces);
        for (a, b) in [
            (shares.within, same.within),
            (shares.under, same.under),
            (shares.over, same.over),
            (shares.shaded, same.shaded),
        ] {
            assert!((a - b).abs() < 5e-3, "{shares:?} and {same:?}");
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same() {
    let maps = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| groove(&Placement::default()).0)
    });
    assert!(maps.iter().all(|m| m.samples == maps[0].samples && m.corners == maps[0].corners));
}

/// Parallel light over a ball: what passes through its disc lands, however wide the spot and however
/// fine the samples.
#[test]
fn samples_add_up_to_what_comes_in() {
    let body = part(&solids::sphere(6.0, 120, 60));
    let lines: Vec<f64> = (-3..=3).map(|i| 2.0 * f64::from(i)).collect();
    let passes: Vec<Pass> = lines.iter().map(|y| line([-12.0, *y, 6.0], [12.0, *y, 6.0], [0.0, 0.0, 1.0])).collect();
    let mut counts = Vec::new();
    for spot_mm in [0.8, 1.6, 3.2] {
        let optics = Optics { rayleigh_mm: 1e5, ..Optics::default() };
        let (map, _) = map_on(&body, &passes, Spot { spot_mm, optics, ..spot(Profile::Gaussian) }, &[]);
        let lit: f64 = map.samples.iter().map(|q| f64::from(q.fluence_j_cm2) * f64::from(q.area_mm2) / 100.0).sum();
        let step = 1e-3;
        let through = |y: f64, at: f64| 2.0 * (36.0 - y * y).sqrt() * gauss(y - at, 0.5 * spot_mm) * step;
        let places = (0..12_000).map(|i| -6.0 + (f64::from(i) + 0.5) * step);
        let expected: f64 = places.map(|y| lines.iter().map(|at| through(y, *at)).sum::<f64>()).sum();
        near("energy", lit, expected * POWER_W / SPEED, 3e-3);
        counts.push(map.samples.len());
    }
    assert!(counts[0] > counts[1] && counts[1] > counts[2], "{counts:?}");
}

#[test]
fn a_click_tells_which_passes_hit_when_and_at_what_angle() {
    let passes: Vec<Pass> = [9.6, 10.0, 14.0].map(|y| line([-5.0, y, 0.0], [5.0, y, 0.0], [0.0, 0.0, 1.0])).to_vec();
    let body = part(&plate());
    let surfaces = segmented(&body, &Job::default());
    let task = DoseInput {
        part: &body,
        surfaces: &surfaces,
        clamps: &[],
        chosen: vec![1],
        thresholds: LOW,
        own: BTreeMap::new(),
    };
    let ends = [2.5, 10.0, 20.0];
    let time = |pass: usize, _| Some(WayTime { seconds: 10.0 / SPEED, ends_s: ends[pass] });
    let light = Light::new(&passes, &spot(Profile::Gaussian), time);
    let map = dose(&task, light, &Progress::default()).expect("a map");
    let q = Point3::new(1.0, 10.1, 0.0);
    let hits = map.hits_at(&body, &[], 0, &q, &Vector3::z());
    assert_eq!(hits.iter().map(|h| h.pass).collect::<Vec<_>>(), [0, 1]);
    for (hit, (y, ends_s)) in hits.iter().zip([(9.6, 2.5), (10.0, 10.0)]) {
        assert!((hit.at_s - (ends_s - 4.0 / SPEED)).abs() < 1e-9 && hit.angle_deg < 1e-6);
        near("dose", hit.j_cm2, 100.0 * POWER_W / SPEED * gauss(10.1 - y, 0.6), 1e-4);
    }
}

#[test]
fn where_the_spot_is_slower_more_lands() {
    let passes: Vec<Pass> = [6.0, 14.0].map(|y| line([-5.0, y, 0.0], [5.0, y, 0.0], [0.0, 0.0, 1.0])).to_vec();
    let body = part(&plate());
    let surfaces = segmented(&body, &Job::default());
    let (clamps, chosen, thresholds, own) = (&[][..], vec![1], LOW, BTreeMap::new());
    let task = DoseInput { part: &body, surfaces: &surfaces, clamps, chosen, thresholds, own };
    // The second line takes two and a half times as long.
    let slower = [1.0, 2.5];
    let time = |pass: usize, _| Some(WayTime { seconds: slower[pass] * 10.0 / SPEED, ends_s: 50.0 });
    let map = dose(&task, Light::new(&passes, &spot(Profile::Gaussian), time), &Progress::default()).expect("a map");
    let at = |y: f64| map.hits_at(&body, &[], 0, &Point3::new(0.0, y, 0.0), &Vector3::z())[0].j_cm2;
    near("dose", at(14.0), 2.5 * at(6.0), 1e-9);
    near("dose", at(6.0), 100.0 * POWER_W / SPEED * gauss(0.0, 0.6), 1e-4);
}

#[test]
fn what_is_not_chosen_and_lit_is_named() {
    // A step: the lower face is cleaned right up to the wall, whose foot is lit as well.
    let body = block([0.0, 0.0, 0.0], [20.0, 20.0, 6.0]);
    let planned = planned_at(&body, &[[10.0, 10.0, 6.0]], parts::job("y", 0.5));
    let map = planning::dose(
        &planned.part,
        &planned.surfaces,
        &planned.plan,
        &planned.job,
        &parts::setup(),
        &Progress::default(),
    )
    .expect("a dose");
    let shares = map.shares(&planned.surfaces);
    assert!(shares.within > 0.93 && shares.over == 0.0 && shares.shaded == 0.0, "{shares:?}");
    assert_eq!(map.collateral(&planned.surfaces), [], "the sides stand along the beam");
    let below = planned.surface_at([10.0, 10.0, 0.0]);
    assert!(
        map.samples
            .iter()
            .filter(|s| planned.surfaces.of_facet[s.facet as usize] == below)
            .all(|s| s.fluence_j_cm2 == 0.0)
    );
}

/// A plate of strips 1 mm wide under a roof of 8 by 16 mm.
fn roofed() -> Triangles {
    let strips: Vec<[f64; 2]> = (-10..=10).map(|x| [f64::from(x), 0.0]).collect();
    let mut body = sheet(&strips, 20.0);
    body.extend(block([-8.0, 2.0, 5.0], [0.0, 18.0, 6.0]));
    body
}

fn patches_of(planned: &parts::Planned) -> Vec<Patch> {
    let (p, setup) = (planned, parts::setup());
    let map = planning::dose(&p.part, &p.surfaces, &p.plan, &p.job, &setup, &Progress::default()).expect("a dose");
    let progress = Progress::default();
    planning::dose::not_cleanable((&p.part, &p.surfaces), &p.plan, &p.job, &map, &progress).expect("patches")
}

#[test]
fn what_stays_unclean_has_its_cause() {
    // Top of a block, planes that lie in it.
    let missed = planned_at(&block([0.0; 3], [10.0, 10.0, 5.0]), &[[5.0, 5.0, 5.0]], parts::job("z", 1.0));
    let [patch] = &patches_of(&missed)[..] else { panic!("one patch") };
    assert_eq!((patch.cause, patch.facets.len()), (PatchCause::Missed, 2));
    near("area", patch.area_mm2, 100.0, 1e-4);
    assert!((patch.centre - Point3::new(5.0, 5.0, 5.0)).norm() < 0.01);

    // Enough lines, too little power.
    let mut job = parts::job("y", 0.5);
    job.dose.low_j_cm2 = 1e6;
    job.dose.high_j_cm2 = 1e7;
    let thin = planned_at(&block([0.0; 3], [10.0, 10.0, 5.0]), &[[5.0, 5.0, 5.0]], job);
    let [patch] = &patches_of(&thin)[..] else { panic!("one patch") };
    assert_eq!(patch.cause, PatchCause::Thin);
    near("area", patch.area_mm2, 100.0, 1e-4);

    // Under a roof: no beam, where none is tilted.
    let mut job = parts::job("y", 0.5);
    job.path.correction = Correction::None;
    let blocked = planned_at(&roofed(), &[[5.0, 10.0, 0.0]], job);
    let patch = &patches_of(&blocked)[0];
    assert_eq!(patch.cause, PatchCause::Blocked);
    assert!((patch.area_mm2 - 128.0).abs() < 10.0, "{}", patch.area_mm2);
    let wall = patch.blocker.map(|b| b.obstruction);
    let plate = blocked.surface_at([5.0, 10.0, 0.0]);
    assert!(matches!(wall, Some(Obstruction::Facet(f)) if blocked.surfaces.of_facet[f as usize] != plate), "{wall:?}");

    // Light that is meant for the plate and falls on the roof.
    let body = part(&roofed());
    let passes: Vec<Pass> = (1..33)
        .map(|i| line([-9.5, 0.6 * f64::from(i), 0.0], [9.5, 0.6 * f64::from(i), 0.0], [0.0, 0.0, 1.0]))
        .map(|pass| Pass { surface: plate, ..pass })
        .collect();
    let surfaces = segmented(&body, &Job::default());
    let thresholds = Thresholds { low_j_cm2: 5000.0, high_j_cm2: 1e6, collateral_j_cm2: 1.0 };
    let task = DoseInput {
        part: &body,
        surfaces: &surfaces,
        clamps: &[],
        chosen: vec![plate],
        thresholds,
        own: BTreeMap::new(),
    };
    let map = dose(&task, light(&passes, spot(Profile::Gaussian)), &Progress::default()).expect("a map");
    let patch = &map.not_cleanable(&body.mesh, &surfaces, &passes, 0.6, &Progress::default()).expect("patches")[0];
    assert_eq!(patch.cause, PatchCause::Shaded);
    near("area", patch.area_mm2, 128.0, 0.05);
    assert!(matches!(patch.shaded_by, Some(Obstruction::Facet(f)) if surfaces.of_facet[f as usize] != plate));
    let shares = map.shares(&surfaces);
    near("shaded", shares.shaded, 128.0 / 400.0, 0.06);
    let top = surface_of(&body, &surfaces, [-4.0, 10.0, 6.0]);
    let [collateral] = &map.collateral(&surfaces)[..] else { panic!("the roof's top alone") };
    assert_eq!(collateral.surface, top);
    near("the roof", collateral.area_mm2, 128.0, 1e-3);
}

fn surface_of(part: &Part, surfaces: &Surfaces, at: [f64; 3]) -> u32 {
    parts::surface_at(part, surfaces, at)
}

/// Lines along x on the top of a block, so far apart that stripes stay between them.
fn striped(spacing_mm: f64) -> parts::Planned {
    planned_at(&block([0.0; 3], [20.0, 20.0, 5.0]), &[[10.0, 10.0, 5.0]], parts::job("y", spacing_mm))
}

#[test]
fn a_gap_between_lines_tells_the_spacing_that_closes_it() {
    let wide = striped(3.0);
    let patches = patches_of(&wide);
    assert!(patches.len() >= 5 && patches.iter().all(|p| p.cause == PatchCause::Thin), "{patches:?}");
    let closer_mm = patches[0].closer_than_mm.expect("a spacing");
    // The first line keeps half a spacing off the rim, where no second one comes.
    let inside = |p: &Patch, spacing_mm: f64| (p.centre.y - 10.0).abs() < 10.0 - spacing_mm;
    assert!(patches.iter().any(|p| inside(p, 3.0)));
    let mut between = patches.iter().filter(|p| inside(p, 3.0));
    assert!(between.all(|p| p.gap_mm <= 3.0 && p.gap_mm > 2.5), "as far as the lines are apart");
    let closed = patches_of(&striped(closer_mm));
    assert!(!closed.iter().any(|p| inside(p, closer_mm)), "{closed:?}");
    assert!(closed.iter().all(|p| p.closer_than_mm.is_none()), "close enough");
    assert!(patches_of(&striped(1.1 * closer_mm)).iter().any(|p| inside(p, closer_mm)), "no closer than needed");

    let (p, setup) = (&wide, parts::setup());
    let map = planning::dose(&p.part, &p.surfaces, &p.plan, &p.job, &setup, &Progress::default()).expect("a dose");
    let report = planning::dose::DoseReport::new(&map, &patches, &p.surfaces);
    let text = dose_lines(&report, &Naming::of(&p.job)).join("\n");
    let told = format!("between lines, spacing too wide: give less than {:.2} mm", (100.0 * closer_mm).floor() / 100.0);
    assert!(text.contains("too little: ") && text.contains(&told) && !text.contains("not cleanable"), "{text}");
    assert_eq!(Edit::aside(&patches, &wide.surfaces), None);
}

#[test]
fn too_little_power_is_put_aside_by_nobody() {
    let mut job = parts::job("y", 0.5);
    job.dose.low_j_cm2 = 1e6;
    job.dose.high_j_cm2 = 1e7;
    let weak = planned_at(&block([0.0; 3], [10.0, 10.0, 5.0]), &[[5.0, 5.0, 5.0]], job);
    let patches = patches_of(&weak);
    assert_eq!((patches.len(), patches[0].facets.len(), patches[0].closer_than_mm), (1, 2, None));
    assert_eq!(Edit::aside(&patches, &weak.surfaces), None);
    // Beside a patch that no light comes to, that one goes alone.
    let blocked = Patch { cause: PatchCause::Blocked, facets: patches[0].facets[..1].to_vec(), ..patches[0].clone() };
    let alone = Edit::aside(std::slice::from_ref(&blocked), &weak.surfaces);
    assert!(alone.is_some());
    assert_eq!(Edit::aside(&[patches[0].clone(), blocked], &weak.surfaces), alone);
}

#[test]
fn what_stays_unclean_can_be_put_aside() {
    let mut job = parts::job("y", 0.5);
    job.path.correction = Correction::None;
    let blocked = planned_at(&roofed(), &[[5.0, 10.0, 0.0]], job);
    let plate = blocked.surface_at([5.0, 10.0, 0.0]);
    let patches = patches_of(&blocked);
    assert_eq!(patches[0].facets.len(), 16, "the strips under the roof");
    let edit = Edit::aside(&patches[..1], &blocked.surfaces).expect("whole facets");
    let new = blocked.surfaces.last_number + 1;
    assert_eq!(edit.sentence(), format!("put surface {new} aside"));
    let all: Vec<SurfaceId> = blocked.surfaces.ids().collect();
    let mut document = Document::new(blocked.job.clone(), None);
    assert!(document.apply(&edit, &all, None));
    let job = document.job().clone();
    let again = segmented(&blocked.part, &job);
    assert_eq!(again.ids().collect::<Vec<_>>(), [&all[..], &[SurfaceId(new)]].concat());
    assert_eq!(again.get(new).map(|s| s.facets.clone()), Some(patches[0].facets.clone()));
    let mut everything = job.clone();
    everything.settings.choose(clearbeam::document::Chosen::All);
    assert!(!everything.chosen(&again).contains(&new));
    let text = toml::to_string(&job).expect("writes");
    assert_eq!(toml::from_str::<Job>(&text).expect("reads"), job);
    // What is left is cleaned, and taking it back cleans all of it.
    let rest = parts::planned(parts::part(&roofed()), job.clone());
    assert!(rest.plan.passes.iter().all(|p| p.surface == plate));
    assert!(rest.report().blocked_mm < 0.35 * blocked.report().blocked_mm);
    document.apply(&Edit::Clean(vec![SurfaceId(new)]), &all, None);
    assert!(!document.job().settings.of(SurfaceId(new)).later);
    document.undo();
    document.undo();
    assert_eq!(document.job(), &blocked.job);
}
