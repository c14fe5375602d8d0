//! The dose that really lands: energy per area on every sample of the surface, from all lit moves, with
//! spot profile, defocus, incidence, and the shadow of the part and of clamps.
//!
//! Every sample is worked out by itself, from the light that comes near it in the order of the program,
//! so the result is the same on any number of threads.

use super::dose_map::DoseMap;
use super::landed::{DoseSum, J_CM2, landed};
use super::light::Light;
use super::lit_facets::{NearPiece, lit_facets};
use super::parameters::Thresholds;
use super::samples::{DoseSample, FacetPiece, MOST_SAMPLES, cut_facet_piece, split_facet_piece};
use super::shade::{LastShade, Shade, SurfacePoint};
use crate::beam::Obstacle;
use crate::part::{Part, Surfaces, topology::FacetDefect};
use crate::progress::{Activity, Cancelled, Progress};
use nalgebra::Point3;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Greatest width of a sample, corner to corner, as a share of the spot.
const SAMPLE_SPOTS: f64 = 0.25;
/// Greatest width of a sample on chosen surfaces where no light comes, in spots.
const DARK_SPOTS: f64 = 1.0;
/// Width of the pieces that large facets are divided into, in samples.
const FACET_PIECE_SIDES: f64 = 32.0;
/// Plots per parallel job.
const CHUNK: usize = 64;

/// What a dose is computed from.
#[derive(Clone, Debug)]
pub struct DoseInput<'a> {
    /// The part.
    pub part: &'a Part,
    /// Its surfaces: which side of a facet is worked on.
    pub surfaces: &'a Surfaces,
    /// What stands on it, in its frame.
    pub clamps: &'a [Obstacle],
    /// The surfaces that are to be cleaned.
    pub chosen: Vec<u32>,
    /// Which doses are too little and too much.
    pub thresholds: Thresholds,
    /// Thresholds of surfaces that have their own, by their numbers.
    pub own: BTreeMap<u32, Thresholds>,
}

/// Computes the dose.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub fn dose(input: &DoseInput<'_>, light: Light, progress: &Progress) -> Result<DoseMap, Cancelled> {
    progress.begin(Activity::SummingDose, 2 * light.runs.len());
    let shade = Shade::new(input.part, input.clamps);
    let near = near_facets(input, &light, &shade, progress)?;
    let (pitch_mm, coarsened, facet_pieces) = facet_pieces(input, &light, near, progress)?;
    let chunks: Vec<(Vec<DoseSample>, Vec<[f32; 3]>)> = facet_pieces
        .par_chunks(CHUNK)
        .map(|facet_pieces| {
            progress.step()?;
            samples_of(input, &light, &shade, (pitch_mm, facet_pieces), progress)
        })
        .collect::<Result<_, Cancelled>>()?;
    let mut samples: Vec<DoseSample> = Vec::with_capacity(chunks.iter().map(|c| c.0.len()).sum());
    let mut corners: Vec<[f32; 3]> = Vec::with_capacity(chunks.iter().map(|c| c.1.len()).sum());
    for (mut some, their) in chunks {
        some.iter_mut().for_each(|s| s.first_corner += corners.len() as u32);
        samples.append(&mut some);
        corners.extend(their);
    }
    let mut starts = vec![0u32; input.part.mesh.facets.len() + 1];
    for s in &samples {
        starts[s.facet as usize + 1] += 1;
    }
    for f in 1..starts.len() {
        starts[f] += starts[f - 1];
    }
    Ok(DoseMap {
        samples,
        corners,
        starts,
        sample_mm: pitch_mm * 2f64.sqrt(),
        coarsened,
        thresholds: input.thresholds,
        own: own_of_facets(input),
        chosen: input.chosen.clone(),
        light,
    })
}

fn own_of_facets(input: &DoseInput<'_>) -> BTreeMap<u32, Thresholds> {
    let facets = |(n, t): (&u32, &Thresholds)| {
        let (facets, t) = (input.surfaces.get(*n).map_or(&[][..], |s| &s.facets), *t);
        facets.iter().map(move |f| (*f, t)).collect::<Vec<_>>()
    };
    input.own.iter().flat_map(facets).collect()
}

/// The light near each facet, in the order of the program.
fn near_facets(
    input: &DoseInput<'_>,
    light: &Light,
    shade: &Shade<'_>,
    progress: &Progress,
) -> Result<Vec<Vec<NearPiece>>, Cancelled> {
    let lit: Vec<Vec<(u32, bool)>> = (0..light.runs.len())
        .into_par_iter()
        .map(|i| progress.step().map(|()| lit_of_run(input, light, shade, i)))
        .collect::<Result<_, Cancelled>>()?;
    let mut of_facet: Vec<Vec<NearPiece>> = vec![Vec::new(); input.part.mesh.facets.len()];
    for (i, facets) in lit.into_iter().enumerate() {
        let (first, run) = light.run(i);
        for (facet, clear) in facets {
            of_facet[facet as usize].extend((first..first + run.len() as u32).map(|piece| NearPiece { piece, clear }));
        }
    }
    Ok(of_facet)
}

/// The facets that a run lights. All pieces of a run belong to one pass.
fn lit_of_run(input: &DoseInput<'_>, light: &Light, shade: &Shade<'_>, index: usize) -> Vec<(u32, bool)> {
    let run = light.run(index).1;
    let Some(piece) = run.first() else { return Vec::new() };
    lit_facets(input.part, input.surfaces, shade, light.spot(piece), run)
}

/// The pitch at which the facets can be sampled, whether it is coarser than wanted, and all live facets as pieces,
/// large ones divided.
fn facet_pieces(
    input: &DoseInput<'_>,
    light: &Light,
    near: Vec<Vec<NearPiece>>,
    progress: &Progress,
) -> Result<(f64, bool, Vec<FacetPiece>), Cancelled> {
    let spot_mm = light.least_spot_mm();
    let mut pitch_mm = SAMPLE_SPOTS * spot_mm / 2f64.sqrt();
    let mesh = &input.part.mesh;
    let size_mm = input.part.bvh.diagonal_mm();
    // Not below this share of the part, however small the spot, so that there are not too many.
    let dark_mm = (DARK_SPOTS * spot_mm).max(size_mm / 500.0);
    let facet_piece_mm = (FACET_PIECE_SIDES * pitch_mm).max(size_mm / 500.0);
    let whole: Vec<FacetPiece> = near
        .into_iter()
        .enumerate()
        .filter(|(f, _)| mesh.defects[*f] == FacetDefect::None)
        .map(|(f, near)| {
            let is_chosen = input.surfaces.of_facet.get(f).is_some_and(|n| input.chosen.contains(n));
            progress.check()?;
            Ok(FacetPiece::of(f as u32, &mesh.corners(f), near, if is_chosen { dark_mm } else { f64::INFINITY }))
        })
        .collect::<Result<_, Cancelled>>()?;
    let split = |facet_piece: FacetPiece| {
        if progress.goes_on() { split_facet_piece(light, facet_piece_mm, facet_piece) } else { Vec::new() }
    };
    let facet_pieces: Vec<FacetPiece> = whole.into_par_iter().flat_map_iter(split).collect();
    progress.check()?;
    let mut coarsened = false;
    loop {
        let counts: Vec<usize> = facet_pieces
            .par_chunks(CHUNK)
            .map(|facet_pieces| {
                progress.step()?;
                facet_pieces.iter().try_fold(0, |sum, p| progress.check().map(|()| sum + count(light, pitch_mm, p)))
            })
            .collect::<Result<_, Cancelled>>()?;
        let count: usize = counts.into_iter().sum();
        // The facets alone may be more: then each is one sample.
        if count <= MOST_SAMPLES || pitch_mm > size_mm {
            return Ok((pitch_mm, coarsened, facet_pieces));
        }
        coarsened = true;
        pitch_mm *= (1.02 * (count as f64 / MOST_SAMPLES as f64).sqrt()).max(1.1);
    }
}

/// How many samples a piece of a facet gives.
fn count(light: &Light, pitch_mm: f64, facet_piece: &FacetPiece) -> usize {
    let mut n = 0;
    cut_facet_piece(light, pitch_mm, facet_piece, |_, _| n += 1);
    n
}

/// The samples of some pieces, and their corners.
fn samples_of(
    input: &DoseInput<'_>,
    light: &Light,
    shade: &Shade<'_>,
    (pitch_mm, facet_pieces): (f64, &[FacetPiece]),
    progress: &Progress,
) -> Result<(Vec<DoseSample>, Vec<[f32; 3]>), Cancelled> {
    let (mut out, mut all_corners) = (Vec::new(), Vec::new());
    let mut last = LastShade::default();
    let stored = |p: Point3<f64>| [p.x as f32, p.y as f32, p.z as f32];
    for facet_piece in facet_pieces {
        // A thousand samples, each with rays of its own.
        progress.check()?;
        let normal = input.surfaces.normals[facet_piece.facet as usize];
        let flips = input.part.mesh.normals[facet_piece.facet as usize].dot(&normal) < 0.0;
        cut_facet_piece(light, pitch_mm, facet_piece, |cell, near| {
            let (area_mm2, middle) = cell.area();
            if area_mm2 <= 1e-9 * pitch_mm * pitch_mm {
                return; // a corner that a line of the grid has just touched
            }
            let q = facet_piece.plane.place(middle);
            let mut sum = DoseSum::default();
            last.next_point();
            for n in near {
                if let Some(l) =
                    landed(light, shade, n, &SurfacePoint { p: q, facet: facet_piece.facet }, &normal, &mut last)
                {
                    sum.add(&l);
                }
            }
            let first_corner = all_corners.len() as u32;
            let corners = cell.corners().iter().map(|c| stored(facet_piece.plane.place(*c)));
            if flips {
                all_corners.extend(corners.rev())
            } else {
                all_corners.extend(corners)
            }
            out.push(DoseSample {
                centre: stored(q),
                area_mm2: area_mm2 as f32,
                facet: facet_piece.facet,
                first_corner,
                corner_count: cell.corners().len() as u8,
                passes: sum.passes,
                fluence_j_cm2: (sum.j_mm2 * J_CM2) as f32,
                unshaded_j_cm2: (sum.unshaded_j_mm2 * J_CM2) as f32,
                incidence_deg: if sum.j_mm2 > 0.0 { (sum.angle_j / sum.j_mm2) as f32 } else { -1.0 },
                shaded_by: sum.walls.iter().max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0))).map(|w| w.0),
            });
        });
    }
    Ok((out, all_corners))
}
