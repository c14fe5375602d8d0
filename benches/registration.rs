//! Scans of parts, laid on them from anywhere: how many are found, how far off, what it takes.
//!
//! `cargo bench --bench registration -- PART.stl…` prints a table; without a file the sample parts. Options: `--poses N`
//! (20), `--points N` (200000), `--others`: each part's scan on each other part instead, all of which have to be refused.
//! Each pose once with 30 % missing and once with half, noise 0.02 % of the diagonal, 1 % outliers.

use clearbeam::part::{Part, Placement, Units};
use clearbeam::progress::Progress;
use clearbeam::sample::scan_maker::{ScanRecipe, made_scan};
use clearbeam::sample::{SAMPLES, Triangles, solids, stl_bytes};
use clearbeam::scan::Cloud;
use clearbeam::scan::registration::{
    Registration, RegistrationError, RegistrationOptions, SlidingKind, SurfaceNormals, most_moved_mm, register,
};
use nalgebra::{Isometry3, Point3};
use std::time::Instant;

/// Noise, and within what a pose counts as found, as shares of the part's diagonal: 0.03 and 0.5 mm on 150 mm.
const NOISE: f64 = 2e-4;
const FOUND: f64 = 3.3e-3;

/// A part by name.
struct Named {
    name: String,
    part: Part,
    normals: SurfaceNormals,
}

/// What was asked for.
struct Asked {
    parts: Vec<Named>,
    poses: u64,
    points: usize,
    others: bool,
}

fn main() {
    let Some(asked) = asked() else { return };
    if asked.others {
        on_others(&asked);
    } else {
        on_themselves(&asked);
    }
}

fn asked() -> Option<Asked> {
    let mut asked = Asked { parts: Vec::new(), poses: 20, points: 200_000, others: false };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--poses" => asked.poses = words.next()?.parse().ok()?,
            "--points" => asked.points = words.next()?.parse().ok()?,
            "--others" => asked.others = true,
            // Cargo's own.
            "--bench" => {}
            path => match std::fs::read(path) {
                Ok(bytes) => asked.parts.extend(named(path, &bytes)),
                Err(error) => eprintln!("{path}: {error}"),
            },
        }
    }
    if asked.parts.is_empty() {
        asked.parts.extend(SAMPLES.iter().filter_map(|s| named(s.name, &stl_bytes(&(s.triangles)()))));
        asked.parts.extend(named("gear", &stl_bytes(&solids::helical_gear(40, 8, 15, 4))));
    }
    Some(asked)
}

fn named(path: &str, bytes: &[u8]) -> Option<Named> {
    let part = Part::from_bytes(bytes, Units::Mm, &Placement::default(), &[]).ok()?;
    let normals = SurfaceNormals::at_usual_creases(&part);
    let name = path.rsplit('/').next().unwrap_or(path).to_owned();
    Some(Named { name, part, normals })
}

fn scan(part: &Part, seed: u64, missing_share: f64, points: usize) -> (Cloud, Isometry3<f64>) {
    let facets: Triangles =
        (0..part.mesh.facets.len()).map(|f| part.mesh.corners(f).map(|p| [p.x, p.y, p.z])).collect();
    let noise_mm = NOISE * part.mesh.diagonal();
    let made = made_scan(&facets, &ScanRecipe { noise_mm, missing_share, ..ScanRecipe::of(points, seed) });
    (Cloud::of_points(&made.points), made.model_from_scan)
}

fn found(of: &Named, cloud: &Cloud) -> Result<Registration, RegistrationError> {
    register(&of.part, &of.normals, cloud, &RegistrationOptions::default(), &Progress::default())
}

/// How far the pose is off: by the corners of the box, or on a symmetric part by how far vertices, laid on the model by the
/// difference, lie off it.
fn least_off_mm(part: &Part, found: &Isometry3<f64>, truth: &Isometry3<f64>) -> f64 {
    let between = found * truth.inverse();
    let off = |v: &Point3<f64>| part.bvh.closest(&(between * v), f64::INFINITY).map_or(f64::NAN, |c| c.distance_mm);
    let by_symmetry = part.mesh.vertices.iter().map(off).fold(0.0, f64::max);
    most_moved_mm(part, &between).min(by_symmetry)
}

fn on_themselves(asked: &Asked) {
    println!(
        "| part | facets | missing | found | as rival | worst mm | sigma mm | noise mm | overlap | slides, weak | s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for of in &asked.parts {
        let limit_mm = FOUND * of.part.mesh.diagonal();
        for missing in [0.3, 0.5] {
            let (mut hits, mut as_rival, mut worst, mut seconds) = (0, 0, 0.0f64, 0.0f64);
            let (mut slides, mut weak, mut last) = (0, 0, None);
            for pose in 0..asked.poses {
                let (cloud, truth) = scan(&of.part, pose, missing, asked.points);
                let begun = Instant::now();
                let outcome = found(of, &cloud);
                seconds = seconds.max(begun.elapsed().as_secs_f64());
                match outcome {
                    Ok(r) => {
                        let off = least_off_mm(&of.part, &r.model_from_scan, &truth);
                        let is_rival = |r: &&clearbeam::scan::registration::Rival| {
                            least_off_mm(&of.part, &r.model_from_scan, &truth) < limit_mm
                        };
                        slides += usize::from(r.sliding.iter().any(|s| s.kind == SlidingKind::Slides));
                        weak += usize::from(r.sliding.iter().any(|s| s.kind == SlidingKind::WeaklyHeld));
                        if off < limit_mm {
                            hits += 1;
                            worst = worst.max(off);
                        } else if r.rivals.iter().any(|r| is_rival(&r)) {
                            as_rival += 1;
                        } else {
                            let score = (r.rms_mm, r.sigma_mm, r.rivals.len());
                            eprintln!(
                                "{} {missing} pose {pose}: off {off:.3} mm, rms, sigma, rivals {score:?}",
                                of.name
                            );
                        }
                        last = Some(r);
                    }
                    Err(error) => eprintln!("{} {missing} pose {pose}: {error}", of.name),
                }
            }
            let [sigma, noise, overlap] = last.map_or([f64::NAN; 3], |r| [r.sigma_mm, r.noise_mm, r.overlap]);
            println!(
                "| {} | {} | {missing} | {hits}/{} | {as_rival} | {worst:.4} | {sigma:.4} | {noise:.4} | {overlap:.3} | {slides}, {weak} | {seconds:.2} |",
                of.name,
                of.part.mesh.facets.len(),
                asked.poses
            );
        }
    }
}

fn on_others(asked: &Asked) {
    println!("| scan of | on | outcome |\n|---|---|---|");
    for of in &asked.parts {
        for pose in 0..asked.poses.min(2) {
            let (cloud, _) = scan(&of.part, pose, 0.3, asked.points);
            for on in asked.parts.iter().filter(|on| on.name != of.name) {
                let outcome = match found(on, &cloud) {
                    Ok(r) => format!("TAKEN: sigma {:.4} noise {:.4} overlap {:.3}", r.sigma_mm, r.noise_mm, r.overlap),
                    Err(error) => error.to_string(),
                };
                println!("| {} | {} | {outcome} |", of.name, on.name);
            }
        }
    }
}
