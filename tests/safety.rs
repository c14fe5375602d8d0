//! No beam with the laser on hits the part: by the checker, which shares no code with the planner.
//!
//! Looked at are all targets and six poses on the way between two of them: p goes straight, the axis
//! turns at constant rate, and the spot is where that axis meets the part. A facet within 0.03 mm of
//! the spot is one that the spot lies on.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::document::Job;
use clearbeam::part::Part;
use clearbeam::pose::checker::Checker;
use clearbeam::pose::interference::GRAZE_MM;
use clearbeam::pose::{BeamInterference, Correction, Pass, TargetState};
use clearbeam::sample::{Triangles, solids};
use nalgebra::{Point3, Unit, Vector3};
use parts::{Planned, checker, job, on, part, planned, sample, sheet};
use rayon::prelude::*;

const BETWEEN: usize = 6;
const SPOT_MM: f64 = 0.03;

/// Where the line through `p` along `a` meets one of the facets nearest to `p`, within a tenth of a
/// millimetre; `p` itself where it meets none (on a crease, beside a rim).
fn spot(facets: &[[Point3<f64>; 3]], p: Point3<f64>, a: &Vector3<f64>) -> Point3<f64> {
    let meets = |[u, v, w]: &[Point3<f64>; 3]| {
        let n = (v - u).cross(&(w - u));
        let t = n.dot(&(u - p)) / n.dot(a);
        let q = p + a * t;
        let inside = [(u, v), (v, w), (w, u)].iter().all(|(s, e)| (*e - *s).cross(&(q - *s)).dot(&n) >= 0.0);
        (t.abs() < 0.1 && inside).then_some(t)
    };
    let t = facets.iter().filter_map(meets).min_by(|s, t| s.abs().total_cmp(&t.abs()));
    t.map_or(p, |t| p + a * t)
}

/// Poses of a pass with the laser on: number looked at, and the first that hits.
fn looked_at(pass: &Pass, facets: &[[Point3<f64>; 3]], check: &Checker) -> (usize, Option<String>) {
    let mut count = 0;
    for (i, w) in pass.targets.windows(2).enumerate().filter(|(_, w)| w[1].laser) {
        let (from, to) = (&w[0], &w[1]);
        let reach = |c: usize| (from.p[c].min(to.p[c]) - 0.1, from.p[c].max(to.p[c]) + 0.1);
        let is_near = |f: &&[Point3<f64>; 3]| {
            (0..3).all(|c| f.iter().any(|q| q[c] <= reach(c).1) && f.iter().any(|q| q[c] >= reach(c).0))
        };
        let near: Vec<[Point3<f64>; 3]> = facets.iter().filter(is_near).copied().collect();
        let (a, b) = (Unit::new_normalize(from.a), Unit::new_normalize(to.a));
        for k in 0..=BETWEEN + 1 {
            let t = k as f64 / (BETWEEN + 1) as f64;
            let axis = a.slerp(&b, t).into_inner();
            let p = if k == 0 || k > BETWEEN {
                if k == 0 { from.p } else { to.p }
            } else {
                spot(&near, from.p + (to.p - from.p) * t, &axis)
            };
            count += 1;
            if let Some(f) = check.hit(&p, &axis, SPOT_MM) {
                return (
                    count,
                    Some(format!(
                        "surface {} point {i} + {t:.2}: {p} along {axis} hits {:?}\n{from:?}\n{to:?}",
                        pass.surface, facets[f]
                    )),
                );
            }
        }
    }
    (count, None)
}

fn is_safe(name: &str, p: &Planned) {
    // The checker counts the facets with area alone; no part here has others.
    let facets: Vec<_> = (0..p.part.mesh.facets.len()).map(|f| p.part.mesh.corners(f)).collect();
    let check = p.checker();
    let found: Vec<_> = p.plan.passes.par_iter().map(|pass| looked_at(pass, &facets, &check)).collect();
    let hits: Vec<&String> = found.iter().filter_map(|f| f.1.as_ref()).collect();
    assert!(hits.is_empty(), "{name}: {} of {} passes hit the part, first {}", hits.len(), found.len(), hits[0]);
    assert!(found.iter().map(|f| f.0).sum::<usize>() > 100, "{name}: something is lit");
}

fn gear(surfaces: &[u32]) -> Planned {
    let mut job = on(job("z", 0.5), surfaces);
    job.beam.defocus_mm = 3.0;
    planned(part(&sample("worm_gear")), job)
}

#[test]
fn tooth_gaps_are_safe_and_nothing_of_them_stays_blocked() {
    let p = gear(&[1, 3, 5]);
    is_safe("worm_gear", &p);
    assert_eq!((p.report().blocked, p.report().problems.len()), (0, 0));
    assert!(p.report().corrected > 0 && p.report().interfering > 0);
}

#[test]
fn the_crater_is_safe_and_nothing_of_it_stays_blocked() {
    let p = planned(part(&sample("workpiece")), on(job("z", 0.5), &[2]));
    is_safe("crater", &p);
    assert_eq!((p.report().blocked, p.report().problems.len()), (0, 0));
    assert!(p.report().corrected > 0 && p.report().interfering > 0);
}

#[test]
fn plate_lug_and_block_of_the_workpiece_are_safe() {
    is_safe("workpiece", &planned(part(&sample("workpiece")), on(job("z", 1.5), &[1, 4, 6, 7, 8, 9])));
    is_safe("workpiece, upright planes", &planned(part(&sample("workpiece")), on(job("x", 2.3), &[1, 2, 4, 6, 8])));
}

#[test]
fn solids_of_closed_form_are_safe() {
    let wide = |angle_deg: f64| {
        let mut job = job("y", 1.3);
        job.surfaces.angle_deg = angle_deg;
        job
    };
    let step: Triangles = sheet(&[[-3.0, 10.7], [0.0, 10.7], [0.0, 0.0], [11.3, 0.0]], 20.37);
    let cases = [
        ("fins", solids::fin_row(3, 2.0, 4.0, 15.0, 20.0, 7.0), job("y", 1.3)),
        ("fins askew", solids::fin_row(3, 2.0, 4.0, 15.0, 20.0, 7.0), job("0.3,1,0.2", 1.3)),
        ("hole", solids::blind_hole(30.0, 5.0, 12.0, 64), job("y", 1.3)),
        ("groove", solids::v_groove(30.0, 8.0, 6.0, 20.0), job("y", 1.3)),
        ("groove askew", solids::v_groove(30.0, 8.0, 6.0, 20.0), job("0.3,1,0.2", 1.3)),
        ("groove, flanks with their lands", solids::v_groove(30.0, 8.0, 6.0, 20.0), wide(61.0)),
        ("groove, all one", solids::v_groove(30.0, 8.0, 6.0, 20.0), wide(121.0)),
        ("torus", solids::torus(9.0, 3.0, 40, 24), job("z", 0.7)),
        ("torus across", solids::torus(9.0, 3.0, 40, 24), job("x", 0.7)),
        ("step", step.clone(), job("y", 1.3)),
        ("step, one surface", step, wide(95.0)),
    ];
    for (name, triangles, job) in cases {
        is_safe(name, &planned(part(&triangles), job));
    }
}

/// What the correction saves is blocked without it.
#[test]
fn without_correction_the_corrected_rows_are_blocked() {
    let without = |p: Planned| {
        let mut job: Job = p.job.clone();
        job.path.correction = Correction::None;
        (planned(p.part.clone(), job), p)
    };
    for (before, after) in [without(gear(&[1])), without(planned(part(&sample("workpiece")), on(job("z", 1.0), &[2])))]
    {
        is_safe("uncorrected", &before);
        assert!(before.targets().all(|t| t.state != TargetState::Corrected && t.a == t.n));
        assert!(before.targets().all(|t| (t.state == TargetState::Blocked) == t.normal_hits.is_some()));
        assert_eq!(before.plan.passes.len(), after.plan.passes.len());
        let mut rows = 0;
        for (b, a) in before.plan.passes.iter().zip(&after.plan.passes) {
            for t in a.targets.iter().filter(|t| t.state == TargetState::Corrected && t.normal_hits.is_some()) {
                let off =
                    |w: &[clearbeam::pose::Target]| clearbeam::part::distance::point_segment(&t.p, &w[0].p, &w[1].p);
                let on = b.targets.windows(2).min_by(|v, w| off(v).total_cmp(&off(w))).expect("a move");
                // At the run's end two moves are as near.
                let touching = on.iter().any(|q| q.state == TargetState::Blocked && (q.p - t.p).norm() < 1e-9);
                assert!(!on[1].laser || touching, "{t:?} is lit in {on:?}");
                rows += 1;
            }
        }
        assert!(rows > 20, "{rows}");
    }
}

/// The same numbers on every machine.
struct Random(u64);

impl Random {
    /// From −1 to 1.
    fn side(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::new(self.side(), self.side(), self.side())
    }

    fn below(&mut self, n: usize) -> usize {
        ((0.5 + 0.5 * self.side()) * n as f64) as usize % n
    }
}

/// A trough with posts that stand in it, lean over it and hang above it anyhow.
#[test]
fn a_trough_with_random_posts_is_safe() {
    let mut random = Random(7);
    for scene in 0..8 {
        let round = |k: usize| (-70.0 + 7.0 * k as f64).to_radians();
        let profile: Vec<[f64; 2]> =
            (0..=20).map(|k| [20.0 * libm::sin(round(k)), -20.0 * libm::cos(round(k))]).collect();
        let mut all = sheet(&profile, 16.0);
        for _ in 0..5 {
            let low = [12.0 * random.side(), 8.0 + 7.0 * random.side(), -17.0 + 8.0 * random.side()];
            let size = [(); 3].map(|()| 1.6 + 1.5 * random.side());
            all.extend(parts::block(low, std::array::from_fn(|k| low[k] + size[k])));
        }
        let mut job = on(job(["y", "0.2,1,0.1", "z"][scene % 3], 0.9), &[1]);
        job.path.max_step_mm = 20.0;
        job.path.chord_error_mm = 0.1;
        let p = planned(part(&all), job);
        is_safe(&format!("scene {scene}"), &p);
    }
}

/// Rays from the middle parts of random facets: rows of (free by the planner, hit by the checker).
fn agree(part: &Part, rays: usize, wide: bool, random: &mut Random) -> [usize; 2] {
    let (beam, check) = (BeamInterference::on(part), checker(part));
    let mut seen = [0; 2];
    for _ in 0..rays {
        let own = random.below(part.mesh.facets.len());
        let [u, v, w] = part.mesh.corners(own);
        let (x, y) = (0.5 + 0.3 * random.side(), 0.5 + 0.3 * random.side());
        let p = u + (v - u) * (x * y) + (w - u) * (x * (1.0 - y));
        let Some(a) = random.vector().try_normalize(0.1) else { continue };
        let in_own_plane = a.dot(&part.mesh.normals[own]).abs() < 0.05;
        let at_own_edge =
            [(u, v), (v, w), (w, u)].iter().any(|(s, e)| (p - s).cross(&(e - s)).norm() < 0.05 * (e - s).norm());
        if in_own_plane || at_own_edge {
            continue;
        }
        let (free, hit) = (beam.is_free(&p, &a), check.hit(&p, &a, 0.011).is_some());
        assert_eq!(free, beam.blocker(&p, &a).is_none());
        assert!(!(free && hit), "the planner lets through what the checker says hits: {p} {a}");
        seen[usize::from(hit)] += 1;
        if free == hit || (free && !wide) {
            continue;
        }
        let others = Checker::new((0..part.mesh.facets.len()).filter(|f| *f != own).map(|f| part.mesh.corners(f)));
        if free && !hit {
            // Beyond the narrow cone at its own point the beam keeps its distance.
            assert!(others.clearance(&p, &a, 1.146, 60.0, 60) > GRAZE_MM - 1e-9, "{p} {a}");
        } else if !free && !hit {
            assert!(others.clearance(&p, &a, 0.01, 200.0, 60) < GRAZE_MM + 1e-6, "blocked by nothing: {p} {a}");
        }
    }
    seen
}

#[test]
fn planner_and_checker_agree_on_random_rays() {
    let mut random = Random(20_261_122);
    let mut seen = [0; 2];
    for _ in 0..12 {
        let soup: Triangles = (0..70)
            .map(|_| {
                let centre = random.vector() * 10.0;
                [(); 3].map(|()| (centre + random.vector() * 4.0).into())
            })
            .collect();
        let found = agree(&part(&soup), 150, true, &mut random);
        seen = [seen[0] + found[0], seen[1] + found[1]];
    }
    assert!(seen.iter().all(|n| *n > 300), "{seen:?}");
    for name in ["workpiece", "worm_gear", "acetabular_cup", "connecting_rod", "front_shaft"] {
        let found = agree(&part(&sample(name)), 600, false, &mut random);
        assert!(found.iter().all(|n| *n > 30), "{name} {found:?}");
    }
}
