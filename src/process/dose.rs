//! The dose that really lands: energy per area on every sample of the surface, from all lit moves, with
//! spot profile, defocus, incidence, and the shadow of the part and of clamps.
//!
//! Every sample is worked out by itself, from the light that comes near it in the order of the program,
//! so the result is the same on any number of threads.

use super::light::Light;
use super::parameters::Thresholds;
use super::reach::{NearPiece, lit_facets};
use super::samples::{DoseSample, MOST_SAMPLES, Plot, cut_plot, split_plot};
use super::shade::{LastShade, Shade};
use crate::beam::Obstacle;
use crate::part::{Part, Surfaces, topology::FacetDefect};
use crate::pose::Obstruction;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Greatest width of a sample, corner to corner, as a share of the spot.
const SAMPLE_SPOTS: f64 = 0.25;
/// Greatest width of a sample on chosen surfaces where no light comes, in spots.
const DARK_SPOTS: f64 = 1.0;
/// Width of the plots that large facets are divided into, in samples.
const PLOT_SIDES: f64 = 32.0;
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

/// The dose on all samples.
#[derive(Clone, Debug)]
pub struct DoseMap {
    /// Facet by facet.
    pub samples: Vec<DoseSample>,
    /// Their corners, mm, part frame.
    pub corners: Vec<[f32; 3]>,
    /// Where the samples of each facet begin; one more than there are facets.
    starts: Vec<u32>,
    /// Greatest width of a sample in the light, corner to corner, mm.
    pub sample_mm: f64,
    /// The part was so large that samples are larger than a quarter of the spot.
    pub coarsened: bool,
    /// Which doses are too little and too much.
    pub thresholds: Thresholds,
    /// Thresholds of facets whose surfaces have their own, by facet.
    pub(super) own: BTreeMap<u32, Thresholds>,
    /// The surfaces that are to be cleaned.
    pub chosen: Vec<u32>,
    /// The light that it was made by.
    pub light: Light,
}

/// What one pass leaves at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotHit {
    /// Number of the pass.
    pub pass: u32,
    /// When most of it lands, s from the program's start.
    pub at_s: f64,
    /// Angle between light and normal, degrees, weighed by energy.
    pub angle_deg: f64,
    /// What lands, J/cm².
    pub j_cm2: f64,
}

/// Energy that lands at one point, summed over pieces of the light.
#[derive(Default)]
struct DoseSum {
    j_mm2: f64,
    unshaded_j_mm2: f64,
    angle_j: f64,
    last_pass: Option<u32>,
    passes: u16,
    /// What shades it, and how much energy each keeps off, J/mm².
    walls: Vec<(Obstruction, f64)>,
}

impl DoseSum {
    fn add(&mut self, landed: &Landed) {
        self.unshaded_j_mm2 += landed.unshaded_j_mm2;
        self.j_mm2 += landed.j_mm2;
        self.angle_j += landed.j_mm2 * landed.angle_deg;
        if landed.covered && landed.j_mm2 > 0.0 && self.last_pass != Some(landed.pass) {
            self.last_pass = Some(landed.pass);
            self.passes = self.passes.saturating_add(1);
        }
        if let Some(wall) = landed.by {
            let lost = landed.unshaded_j_mm2 - landed.j_mm2;
            match self.walls.iter_mut().find(|(w, _)| *w == wall) {
                Some((_, j)) => *j += lost,
                None => self.walls.push((wall, lost)),
            }
        }
    }
}

/// The energy of one piece of the light that lands at a point.
struct Landed {
    pass: u32,
    at_s: f64,
    unshaded_j_mm2: f64,
    j_mm2: f64,
    angle_deg: f64,
    /// The spot itself went over it.
    covered: bool,
    by: Option<Obstruction>,
}

fn landed(
    light: &Light,
    shade: &Shade<'_>,
    near: &NearPiece,
    (q, normal, own): (&Point3<f64>, &Vector3<f64>, u32),
    last: &mut LastShade,
) -> Option<Landed> {
    let piece = light.pieces.get(near.piece as usize)?;
    let passing = light.passing(piece, q)?;
    let when = passing.seen.nearest.clamp(passing.window[0], passing.window[1]);
    let axis = piece.axis(when);
    let cosine = axis.dot(normal);
    if cosine <= 0.0 {
        return None;
    }
    let (share, by) = if near.clear {
        (1.0, None)
    } else {
        let l = shade.landing(light, piece, (q, own), &passing, last);
        (l.share, l.by)
    };
    let unshaded_j_mm2 = passing.j_mm2 * cosine;
    Some(Landed {
        pass: piece.pass,
        at_s: piece.ends_s - piece.seconds * (1.0 - when),
        unshaded_j_mm2,
        j_mm2: unshaded_j_mm2 * share,
        angle_deg: libm::atan2(axis.cross(normal).norm(), cosine).to_degrees(),
        covered: light.spot(piece).covers(passing.seen.at(when), passing.seen.z_mm),
        by,
    })
}

/// 1 J/mm² in J/cm².
pub const J_CM2: f64 = 100.0;

/// Computes the dose. `step` is called once for every share of `steps` work done, and ends it by
/// returning false; then there is no map.
pub fn dose(input: &DoseInput<'_>, light: Light, step: &(dyn Fn() -> bool + Sync)) -> Option<DoseMap> {
    let shade = Shade::new(input.part, input.clamps);
    let near = near_facets(input, &light, &shade, step)?;
    let (pitch_mm, coarsened, plots) = plots(input, &light, near, step)?;
    let chunks: Vec<(Vec<DoseSample>, Vec<[f32; 3]>)> = plots
        .par_chunks(CHUNK)
        .map(|plots| step().then(|| samples_of(input, &light, &shade, pitch_mm, plots)))
        .collect::<Option<_>>()?;
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
    Some(DoseMap {
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
    step: &(dyn Fn() -> bool + Sync),
) -> Option<Vec<Vec<NearPiece>>> {
    let lit: Vec<Vec<(u32, bool)>> = (0..light.runs.len())
        .into_par_iter()
        .map(|i| step().then(|| lit_of_run(input, light, shade, i)))
        .collect::<Option<_>>()?;
    let mut of_facet: Vec<Vec<NearPiece>> = vec![Vec::new(); input.part.mesh.facets.len()];
    for (i, facets) in lit.into_iter().enumerate() {
        let (first, run) = light.run(i);
        for (facet, clear) in facets {
            of_facet[facet as usize].extend((first..first + run.len() as u32).map(|piece| NearPiece { piece, clear }));
        }
    }
    Some(of_facet)
}

/// The facets that a run lights. All pieces of a run belong to one pass.
fn lit_of_run(input: &DoseInput<'_>, light: &Light, shade: &Shade<'_>, index: usize) -> Vec<(u32, bool)> {
    let run = light.run(index).1;
    let Some(piece) = run.first() else { return Vec::new() };
    lit_facets(input.part, input.surfaces, shade, light.spot(piece), run)
}

/// The pitch at which the facets can be sampled, whether it is coarser than wanted, and all live facets as plots,
/// large ones divided.
fn plots(
    input: &DoseInput<'_>,
    light: &Light,
    near: Vec<Vec<NearPiece>>,
    step: &(dyn Fn() -> bool + Sync),
) -> Option<(f64, bool, Vec<Plot>)> {
    let spot_mm = light.least_spot_mm();
    let mut pitch_mm = SAMPLE_SPOTS * spot_mm / 2f64.sqrt();
    let mesh = &input.part.mesh;
    let size_mm = input.part.bvh.diagonal_mm();
    // Not below this share of the part, however small the spot, so that there are not too many.
    let dark_mm = (DARK_SPOTS * spot_mm).max(size_mm / 500.0);
    let plot_mm = (PLOT_SIDES * pitch_mm).max(size_mm / 500.0);
    let whole: Vec<Plot> = near
        .into_iter()
        .enumerate()
        .filter(|(f, _)| mesh.defects[*f] == FacetDefect::None)
        .map(|(f, near)| {
            let is_chosen = input.surfaces.of_facet.get(f).is_some_and(|n| input.chosen.contains(n));
            Plot::of(f as u32, &mesh.corners(f), near, if is_chosen { dark_mm } else { f64::INFINITY })
        })
        .collect();
    let plots: Vec<Plot> = whole.into_par_iter().flat_map_iter(|plot| split_plot(light, plot_mm, plot)).collect();
    let mut coarsened = false;
    loop {
        let count: Option<usize> = plots
            .par_chunks(CHUNK)
            .map(|plots| step().then(|| plots.iter().map(|p| count(light, pitch_mm, p)).sum::<usize>()))
            .sum();
        let count = count?;
        // The facets alone may be more: then each is one sample.
        if count <= MOST_SAMPLES || pitch_mm > size_mm {
            return Some((pitch_mm, coarsened, plots));
        }
        coarsened = true;
        pitch_mm *= (1.02 * (count as f64 / MOST_SAMPLES as f64).sqrt()).max(1.1);
    }
}

/// How many samples a plot gives.
fn count(light: &Light, pitch_mm: f64, plot: &Plot) -> usize {
    let mut n = 0;
    cut_plot(light, pitch_mm, plot, |_, _| n += 1);
    n
}

/// The samples of some plots, and their corners.
fn samples_of(
    input: &DoseInput<'_>,
    light: &Light,
    shade: &Shade<'_>,
    pitch_mm: f64,
    plots: &[Plot],
) -> (Vec<DoseSample>, Vec<[f32; 3]>) {
    let (mut out, mut all_corners) = (Vec::new(), Vec::new());
    let mut last = LastShade::default();
    let stored = |p: Point3<f64>| [p.x as f32, p.y as f32, p.z as f32];
    for plot in plots {
        let normal = input.surfaces.normals[plot.facet as usize];
        let flips = input.part.mesh.normals[plot.facet as usize].dot(&normal) < 0.0;
        cut_plot(light, pitch_mm, plot, |cell, near| {
            let (area_mm2, middle) = cell.area();
            if area_mm2 <= 1e-9 * pitch_mm * pitch_mm {
                return; // a corner that a line of the grid has just touched
            }
            let q = plot.plane.place(middle);
            let mut sum = DoseSum::default();
            last.next_point();
            for n in near {
                if let Some(l) = landed(light, shade, n, (&q, &normal, plot.facet), &mut last) {
                    sum.add(&l);
                }
            }
            let first_corner = all_corners.len() as u32;
            let corners = cell.corners().iter().map(|c| stored(plot.plane.place(*c)));
            if flips {
                all_corners.extend(corners.rev())
            } else {
                all_corners.extend(corners)
            }
            out.push(DoseSample {
                centre: stored(q),
                area_mm2: area_mm2 as f32,
                facet: plot.facet,
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
    (out, all_corners)
}

impl DoseMap {
    /// The samples of a facet: none where it has no area.
    pub fn of_facet(&self, facet: u32) -> &[DoseSample] {
        let at = |f: usize| self.starts.get(f).map_or(self.samples.len(), |s| *s as usize);
        &self.samples[at(facet as usize)..at(facet as usize + 1)]
    }

    /// The corners of a sample, counter-clockwise seen from the side that is worked on.
    pub fn corners_of(&self, sample: &DoseSample) -> &[[f32; 3]] {
        let first = sample.first_corner as usize;
        self.corners.get(first..first + usize::from(sample.corner_count)).unwrap_or_default()
    }

    /// Which passes come to a point of a facet, when, and at what angle, in the order of the program.
    pub fn hits_at(
        &self,
        part: &Part,
        clamps: &[Obstacle],
        facet: u32,
        q: &Point3<f64>,
        normal: &Vector3<f64>,
    ) -> Vec<SpotHit> {
        let shade = Shade::new(part, clamps);
        let mut last = LastShade::default();
        let mut hits: Vec<(SpotHit, f64)> = Vec::new();
        for piece in 0..self.light.pieces.len() as u32 {
            let near = NearPiece { piece, clear: false };
            let Some(l) = landed(&self.light, &shade, &near, (q, normal, facet), &mut last) else { continue };
            if l.j_mm2 <= 0.0 {
                continue;
            }
            let j_cm2 = l.j_mm2 * J_CM2;
            match hits.last_mut().filter(|(h, _)| h.pass == l.pass) {
                Some((h, most)) => {
                    h.angle_deg = (h.angle_deg * h.j_cm2 + l.angle_deg * j_cm2) / (h.j_cm2 + j_cm2);
                    h.j_cm2 += j_cm2;
                    if j_cm2 > *most {
                        (h.at_s, *most) = (l.at_s, j_cm2);
                    }
                }
                None => {
                    let hit = SpotHit { pass: l.pass, at_s: l.at_s, angle_deg: l.angle_deg, j_cm2 };
                    hits.push((hit, j_cm2));
                }
            }
        }
        hits.into_iter().map(|(h, _)| h).collect()
    }
}
