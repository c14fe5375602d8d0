//! Assumed motions of the whole file: shifts, and turns with shifts, that bring many remembered
//! surfaces onto alike new ones.
//!
//! *Anchors* are remembered surfaces that no edit had touched yet, with all new surfaces that are like
//! them. A shift follows from one pair, a turn from three anchors not on a line whose distances agree.
//! Every anchor votes for a motion that brings it onto one of its candidates; the motion is then
//! fitted to all that voted for it. Those are worth a trial that bring most surfaces onto some alike
//! one, also such as are too common for an anchor: the teeth of a gear tell which of its pin holes is which.

use super::alike::{reach, unlikeness_anywhere, unturned};
use super::fingerprint::{Fingerprint, Landmark};
use super::landmarks::Landmarks;
use super::pairing::Lineup;
use crate::fit::{PlacedPair, rigid};
use crate::progress::{Cancelled, Progress};
use nalgebra::{Isometry3, Point3, Similarity3, Translation3, UnitQuaternion, Vector3};
use std::collections::BTreeSet;

/// Anchors, the most telling first.
const ANCHORS: usize = 64;
/// Candidates of an anchor: what is like so many tells nothing.
const CANDIDATES: usize = 12;
/// Anchors among which triples are looked for, and how many triples: enough that some stay if a few
/// of the surfaces are gone.
const TRIPLE_ANCHORS: usize = 10;
const TRIPLES: usize = 40;
/// Turns after which no further triple is looked at; one alone gives 12³ at most.
const TURNS: usize = 2000;
/// Motions that are compared, surfaces that they are compared by, and motions that are worth a trial.
const COMPARED: usize = 200;
const COMPARED_BY: usize = 512;
const MOTIONS: usize = 8;

/// A remembered surface, and the new ones that are like it.
struct Anchor {
    print: Fingerprint,
    candidates: Vec<Fingerprint>,
}

/// An assumed motion and its votes.
struct Assumed {
    new_from_old: Isometry3<f64>,
    votes: usize,
}

/// Shifts of the file, those first that more anchors agree with.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn shifts(
    landmarks: &Landmarks,
    new: &Lineup,
    progress: &Progress,
) -> Result<Vec<Isometry3<f64>>, Cancelled> {
    let anchors = anchors(landmarks, new, unturned);
    let mut found = Vec::new();
    for (anchor, candidate) in anchors.iter().flat_map(|a| a.candidates.iter().map(move |c| (a, c))) {
        progress.check()?;
        let shift = Isometry3::from(Translation3::from(candidate.centroid - anchor.print.centroid));
        let fitted = |voters: &[PlacedPair]| {
            let weight: f64 = voters.iter().map(|p| p.weight).sum();
            let mean = voters.iter().map(|p| (p.onto - p.from) * p.weight).sum::<Vector3<f64>>() / weight;
            Some(Isometry3::from_parts(Translation3::from(mean), UnitQuaternion::identity()))
        };
        found.extend(assumed(&anchors, &shift, landmarks, fitted));
    }
    best(found, landmarks, new, progress)
}

/// Turns with a shift, those first that more anchors agree with.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn turns(
    landmarks: &Landmarks,
    new: &Lineup,
    progress: &Progress,
) -> Result<Vec<Isometry3<f64>>, Cancelled> {
    let anchors = anchors(landmarks, new, unlikeness_anywhere);
    let mut found = Vec::new();
    for triple in triples(&anchors, landmarks.diagonal) {
        if found.len() > TURNS {
            break;
        }
        for onto in placements(&triple, landmarks.diagonal) {
            progress.check()?;
            let pairs: Vec<PlacedPair> = triple.iter().zip(onto).map(|(a, c)| pair(&a.print, c)).collect();
            if let Some(turn) = rigid(&pairs) {
                found.extend(assumed(&anchors, &turn, landmarks, rigid));
            }
        }
    }
    best(found, landmarks, new, progress)
}

/// Points around the part, by which motions are compared.
pub(super) struct Surround([Point3<f64>; 6]);

impl Surround {
    pub(super) fn new(landmarks: &Landmarks) -> Surround {
        let sum: Vector3<f64> = landmarks.surfaces.iter().map(|l| l.print.centroid.coords).sum();
        let middle = Point3::from(sum / landmarks.surfaces.len().max(1) as f64);
        Surround(std::array::from_fn(|i| {
            let mut p = middle;
            p[i % 3] += landmarks.diagonal * if i < 3 { 0.5 } else { -0.5 };
            p
        }))
    }

    /// The farthest that one motion brings any of it from where another does.
    pub(super) fn apart(&self, a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
        self.0.iter().map(|p| (a * p - b * p).norm()).fold(0.0, f64::max)
    }
}

fn pair(from: &Fingerprint, onto: &Fingerprint) -> PlacedPair {
    PlacedPair { from: from.centroid, onto: onto.centroid, weight: from.area.max(f64::MIN_POSITIVE) }
}

/// Surfaces as they were before the first edit, the largest first.
fn before_edits(landmarks: &Landmarks) -> Vec<&Landmark> {
    let mut prints: Vec<&Landmark> = Vec::new();
    let mut touched: BTreeSet<u32> = BTreeSet::new();
    for operand in landmarks.edits.iter().flat_map(|e| &e.operands) {
        if operand.number <= landmarks.last_number && touched.insert(operand.number) {
            prints.push(operand);
        }
    }
    let rest = |l: &&Landmark| l.number <= landmarks.last_number && !touched.contains(&l.number);
    prints.extend(landmarks.surfaces.iter().filter(rest));
    prints.sort_by(|a, b| b.print.area.total_cmp(&a.print.area).then(a.number.cmp(&b.number)));
    prints
}

/// The largest of them with the new surfaces that are like them.
fn anchors(landmarks: &Landmarks, new: &Lineup, alike: fn(&Fingerprint, &Fingerprint) -> Option<f64>) -> Vec<Anchor> {
    let mut by_area: Vec<&Fingerprint> = new.all().iter().map(|l| &l.print).collect();
    by_area.sort_by(|a, b| a.area.total_cmp(&b.area));
    let mut anchors: Vec<Anchor> = before_edits(landmarks)
        .into_iter()
        .take(ANCHORS)
        .map(|Landmark { print, .. }| {
            let first = by_area.partition_point(|n| n.area < 0.8 * print.area);
            let close = by_area[first..].iter().take_while(|n| n.area <= 1.25 * print.area);
            let like = close.filter(|n| alike(print, n).is_some()).take(CANDIDATES + 1);
            Anchor { print: *print, candidates: like.map(|n| **n).collect() }
        })
        .filter(|a| (1..=CANDIDATES).contains(&a.candidates.len()))
        .collect();
    anchors.sort_by_key(|a| a.candidates.len());
    anchors
}

/// The motion fitted to all anchors that agree with this one.
fn assumed(
    anchors: &[Anchor],
    motion: &Isometry3<f64>,
    landmarks: &Landmarks,
    fitted: impl Fn(&[PlacedPair]) -> Option<Isometry3<f64>>,
) -> Option<Assumed> {
    let voters: Vec<PlacedPair> = anchors
        .iter()
        .filter_map(|a| {
            let (at, normal) = (motion * a.print.centroid, motion.rotation * a.print.mean_normal);
            let near = a
                .candidates
                .iter()
                .filter(|c| (c.mean_normal - normal).norm() < 0.1)
                .map(|c| ((c.centroid - at).norm(), c))
                .min_by(|x, y| x.0.total_cmp(&y.0))?;
            // Twice, because the motion comes of surfaces that are off by as much themselves.
            (near.0 <= 2.0 * reach(&a.print, landmarks.diagonal)).then(|| pair(&a.print, near.1))
        })
        .collect();
    Some(Assumed { new_from_old: fitted(&voters)?, votes: voters.len() })
}

/// The motions that bring the most surfaces onto alike ones, each once: nearer than a five hundredth
/// of the part they are one.
fn best(
    mut found: Vec<Assumed>,
    landmarks: &Landmarks,
    new: &Lineup,
    progress: &Progress,
) -> Result<Vec<Isometry3<f64>>, Cancelled> {
    // Stable: of those with equally many votes the one found first.
    found.sort_by_key(|a| std::cmp::Reverse(a.votes));
    let (mut kept, surround): (Vec<Isometry3<f64>>, _) = (Vec::new(), Surround::new(landmarks));
    for Assumed { new_from_old, .. } in found {
        let other = |k: &Isometry3<f64>| surround.apart(k, &new_from_old) > 0.002 * landmarks.diagonal;
        if kept.len() < COMPARED && kept.iter().all(other) {
            kept.push(new_from_old);
        }
    }
    let prints = before_edits(landmarks);
    let mut held = Vec::with_capacity(kept.len());
    for motion in kept {
        progress.check()?;
        let moved = Similarity3::from_isometry(motion, 1.0);
        let by = prints.iter().take(COMPARED_BY);
        held.push((by.filter(|l| new.holds(&l.print.moved(&moved), landmarks.diagonal)).count(), motion));
    }
    held.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    Ok(held.into_iter().take(MOTIONS).map(|(_, motion)| motion).collect())
}

/// Three anchors each that tell a turn: not on a line by a twentieth of the part.
fn triples(anchors: &[Anchor], diagonal: f64) -> Vec<[&Anchor; 3]> {
    let first = &anchors[..anchors.len().min(TRIPLE_ANCHORS)];
    let mut found = Vec::new();
    for (i, a) in first.iter().enumerate() {
        for (j, b) in first.iter().enumerate().skip(i + 1) {
            for c in &first[j + 1..] {
                let [p, q, r] = [a, b, c].map(|x| x.print.centroid);
                let longest = (q - p).norm().max((r - p).norm()).max((r - q).norm());
                if (q - p).cross(&(r - p)).norm() > 0.05 * diagonal * longest {
                    found.push([a, b, c]);
                }
            }
        }
    }
    found.truncate(TRIPLES);
    found
}

/// The choices of candidates for three anchors that keep their distances.
fn placements<'a>(triple: &[&'a Anchor; 3], diagonal: f64) -> Vec<[&'a Fingerprint; 3]> {
    let agree = |i: usize, j: usize, x: &Fingerprint, y: &Fingerprint| {
        let (a, b) = (&triple[i].print, &triple[j].print);
        let was = (a.centroid - b.centroid).norm();
        ((x.centroid - y.centroid).norm() - was).abs() <= reach(a, diagonal) + reach(b, diagonal)
    };
    let mut found = Vec::new();
    for x in &triple[0].candidates {
        for y in triple[1].candidates.iter().filter(|y| agree(0, 1, x, y)) {
            for z in triple[2].candidates.iter().filter(|z| agree(0, 2, x, z) && agree(1, 2, y, z)) {
                found.push([x, y, z]);
            }
        }
    }
    found
}
