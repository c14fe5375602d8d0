//! Winding: neighbours agree, closed shells look outward, closed shells inside an odd number of
//! others look towards their void, open sheets to the side that most of their area has in the file.
//!
//! A *sheet* here is a set of facets connected through edges of exactly two facets; where it cannot be
//! oriented (a Möbius strip) its seam stays a place where two facets disagree.

use super::topology::{Mesh, NO_EDGE, bounds_of};
use nalgebra::{Point3, Vector3};
use std::collections::BTreeMap;

/// What was found and turned.
#[derive(Clone, Debug, Default)]
pub struct Orientation {
    /// Facets whose winding differs from the file's.
    pub flipped_facets: usize,
    /// Shell (counted from 1 in the order of their lowest facet) of each facet: facets connected
    /// through shared edges of any kind.
    pub shell_of: Vec<u32>,
    /// Number of shells.
    pub shells: usize,
    /// Every edge has exactly two facets.
    pub watertight: bool,
}

/// Orients the facets in place.
pub fn orient(mesh: &mut Mesh) -> Orientation {
    let (sheet_of, turned, torn) = agree(mesh);
    let sheets = gather(&sheet_of);
    let mut flip = turned;
    let closed: Vec<bool> = sheets
        .iter()
        .enumerate()
        .map(|(s, facets)| !torn[s] && facets.iter().all(|&f| is_closed_at(mesh, f)))
        .collect();
    for (s, facets) in sheets.iter().enumerate() {
        let wrong = if closed[s] {
            // Volume with the turned facets counted as turned.
            let outward = signed_volume(mesh, facets, &flip) > 0.0;
            outward == (depth(mesh, &sheets, &closed, s) % 2 == 1)
        } else {
            let area = |want: bool| -> f64 {
                facets.iter().filter(|&&f| flip[f as usize] == want).map(|&f| mesh.areas[f as usize]).sum()
            };
            area(true) > area(false)
        };
        if wrong {
            for &f in facets {
                flip[f as usize] = !flip[f as usize];
            }
        }
    }
    for (f, &turn) in flip.iter().enumerate() {
        if turn {
            mesh.flip(f);
        }
    }
    let (shell_of, shells) = shells(mesh);
    Orientation {
        flipped_facets: flip.iter().filter(|&&t| t).count(),
        shell_of,
        shells,
        watertight: (0..mesh.edges.len() as u32).all(|e| mesh.edge_facets(e).len() == 2),
    }
}

fn is_closed_at(mesh: &Mesh, f: u32) -> bool {
    mesh.facet_edges[f as usize].iter().all(|&e| e != NO_EDGE && mesh.two_facets(e).is_some())
}

/// Sheet of each facet, whether it must turn to agree with the sheet's first, and torn sheets.
fn agree(mesh: &Mesh) -> (Vec<u32>, Vec<bool>, Vec<bool>) {
    let count = mesh.facets.len();
    let (mut sheet_of, mut turn, mut torn) = (vec![u32::MAX; count], vec![false; count], Vec::new());
    let mut stack = Vec::new();
    for first in 0..count as u32 {
        if sheet_of[first as usize] != u32::MAX {
            continue;
        }
        let sheet = torn.len() as u32;
        torn.push(false);
        sheet_of[first as usize] = sheet;
        stack.push(first);
        while let Some(f) = stack.pop() {
            for e in mesh.facet_edges[f as usize] {
                if e == NO_EDGE {
                    continue;
                }
                let Some([a, b]) = mesh.two_facets(e).filter(|&pair| !mesh.is_fold(pair, e)) else {
                    torn[sheet as usize] |= mesh.two_facets(e).is_some();
                    continue;
                };
                let g = if a == f { b } else { a };
                let same_way = mesh.runs_forward(f, e) == mesh.runs_forward(g, e);
                let wanted = turn[f as usize] != same_way;
                if sheet_of[g as usize] == u32::MAX {
                    sheet_of[g as usize] = sheet;
                    turn[g as usize] = wanted;
                    stack.push(g);
                } else if turn[g as usize] != wanted {
                    torn[sheet as usize] = true;
                }
            }
        }
    }
    (sheet_of, turn, torn)
}

fn gather(sheet_of: &[u32]) -> Vec<Vec<u32>> {
    let count = sheet_of.iter().max().map_or(0, |&m| m as usize + 1);
    let mut sheets = vec![Vec::new(); count];
    for (f, &s) in sheet_of.iter().enumerate() {
        sheets[s as usize].push(f as u32);
    }
    sheets
}

/// Volume enclosed by facets, mm³; positive when they look outward. `flip` marks facets to count
/// the other way round.
fn signed_volume(mesh: &Mesh, facets: &[u32], flip: &[bool]) -> f64 {
    // About a point of the sheet itself: far from the origin the sum would lose its digits.
    let Some(origin) = facets.first().map(|&f| mesh.corners(f as usize)[0]) else { return 0.0 };
    facets
        .iter()
        .map(|&f| {
            let [a, b, c] = mesh.corners(f as usize).map(|p| p - origin);
            let v = a.dot(&b.cross(&c)) / 6.0;
            if flip[f as usize] { -v } else { v }
        })
        .sum()
}

/// Volume of the oriented mesh, mm³: shells in voids count as missing.
pub fn volume(mesh: &Mesh) -> f64 {
    let all: Vec<u32> = (0..mesh.facets.len() as u32).collect();
    signed_volume(mesh, &all, &vec![false; mesh.facets.len()])
}

/// Number of other closed sheets around sheet `s`.
fn depth(mesh: &Mesh, sheets: &[Vec<u32>], closed: &[bool], s: usize) -> usize {
    if closed.iter().filter(|&&c| c).count() < 2 {
        return 0;
    }
    let boxed = |t: usize| bounds_of(sheets[t].iter().flat_map(|&f| mesh.corners(f as usize)));
    let (lo, hi) = boxed(s);
    let point = mesh.centroid(sheets[s][0] as usize);
    (0..sheets.len())
        .filter(|&t| t != s && closed[t] && sheets[t].len() >= 4)
        .filter(|&t| {
            let (outer_lo, outer_hi) = boxed(t);
            (0..3).all(|k| outer_lo[k] <= lo[k] && hi[k] <= outer_hi[k])
        })
        .filter(|&t| is_inside(mesh, &sheets[t], &point))
        .count()
}

/// Whether a point is inside a closed sheet: crossings of three rays, two of which decide where
/// one happens to run through an edge.
fn is_inside(mesh: &Mesh, facets: &[u32], point: &Point3<f64>) -> bool {
    let rays = [Vector3::new(0.36, 0.48, 0.8), Vector3::new(-0.6, 0.64, 0.48), Vector3::new(0.28, -0.96, 0.1)];
    let votes = rays.iter().filter(|ray| {
        let crossings = facets.iter().filter(|&&f| crosses(mesh.corners(f as usize), point, ray)).count();
        crossings % 2 == 1
    });
    votes.count() >= 2
}

fn crosses([a, b, c]: [Point3<f64>; 3], point: &Point3<f64>, ray: &Vector3<f64>) -> bool {
    let (e1, e2, s) = (b - a, c - a, point - a);
    let p = ray.cross(&e2);
    let det = e1.dot(&p);
    let (u, q) = (s.dot(&p) / det, s.cross(&e1));
    let v = ray.dot(&q) / det;
    u >= 0.0 && v >= 0.0 && u + v <= 1.0 && e2.dot(&q) / det > 0.0
}

/// Shells by union over shared edges.
fn shells(mesh: &Mesh) -> (Vec<u32>, usize) {
    let mut sets = super::merge_tree::UnionFind::new(mesh.facets.len());
    for e in 0..mesh.edges.len() as u32 {
        for pair in mesh.edge_facets(e).windows(2) {
            sets.join(pair[0], pair[1]);
        }
    }
    let mut numbers = BTreeMap::new();
    let shell_of: Vec<u32> = (0..mesh.facets.len() as u32)
        .map(|f| {
            let next = numbers.len() as u32 + 1;
            *numbers.entry(sets.root(f)).or_insert(next)
        })
        .collect();
    (shell_of, numbers.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::raw_part::RawFacet;

    /// A cube's facets, outward, edge `size`, one corner at `at`.
    fn cube(at: f32, size: f32) -> Vec<RawFacet> {
        let p = |i: usize| [0, 1, 2].map(|k| at + if i >> k & 1 == 1 { size } else { 0.0 });
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
            .iter()
            .flat_map(|q| [[p(q[0]), p(q[1]), p(q[2])], [p(q[0]), p(q[2]), p(q[3])]])
            .collect()
    }

    fn turned(mut facets: Vec<RawFacet>, which: impl Fn(usize) -> bool) -> Vec<RawFacet> {
        for (i, f) in facets.iter_mut().enumerate() {
            if which(i) {
                f.swap(1, 2);
            }
        }
        facets
    }

    #[test]
    fn a_cube_ends_outward_however_it_starts() {
        for (seed, expected) in [(0, 0), (12, 12), (5, 5)] {
            let mut mesh = Mesh::weld(&turned(cube(0.0, 2.0), |i| i < seed), 1.0);
            let o = orient(&mut mesh);
            assert_eq!((o.flipped_facets, o.shells, o.watertight), (expected, 1, true));
            assert!((volume(&mesh) - 8.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_void_looks_inward_and_an_island_in_it_outward() {
        let mut facets = cube(0.0, 10.0);
        facets.extend(cube(2.0, 6.0));
        facets.extend(cube(4.0, 2.0));
        let mut mesh = Mesh::weld(&facets, 1.0);
        let o = orient(&mut mesh);
        assert_eq!((o.flipped_facets, o.shells), (12, 3));
        assert!((volume(&mesh) - (1000.0 - 216.0 + 8.0)).abs() < 1e-9);
    }

    #[test]
    fn an_open_sheet_keeps_the_side_of_most_of_its_area() {
        let open: Vec<RawFacet> = cube(0.0, 1.0).into_iter().skip(2).collect();
        let mut mesh = Mesh::weld(&turned(open.clone(), |i| i < 3), 1.0);
        assert_eq!(orient(&mut mesh).flipped_facets, 3);
        let mut mesh = Mesh::weld(&turned(open, |i| i < 8), 1.0);
        let o = orient(&mut mesh);
        assert_eq!((o.flipped_facets, o.watertight), (2, false));
    }

    #[test]
    fn a_face_covered_twice_is_not_turned_into_the_part() {
        let sheet: Vec<RawFacet> = vec![
            [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
            [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 0.5, 0.0]],
        ];
        let mut mesh = Mesh::weld(&sheet, 1.0);
        assert_eq!(orient(&mut mesh).flipped_facets, 0);
        assert!(mesh.normals.iter().all(|n| n.z > 0.9));
    }

    #[test]
    fn a_moebius_strip_keeps_a_seam() {
        let ring: Vec<[[f32; 3]; 2]> = (0..8)
            .map(|i| {
                let (a, h) = (f64::from(i) * 45.0f64.to_radians(), f64::from(i) * 22.5f64.to_radians());
                let at = |s: f64| {
                    let r = 4.0 + s * libm::cos(h);
                    [r * libm::cos(a), r * libm::sin(a), s * libm::sin(h)].map(|x| x as f32)
                };
                [at(1.0), at(-1.0)]
            })
            .collect();
        let facets: Vec<RawFacet> = (0..8)
            .flat_map(|i| {
                let (p, q) = (ring[i], if i < 7 { ring[i + 1] } else { [ring[0][1], ring[0][0]] });
                [[p[0], p[1], q[0]], [p[1], q[1], q[0]]]
            })
            .collect();
        let mut mesh = Mesh::weld(&facets, 1.0);
        orient(&mut mesh);
        let seams = (0..mesh.edges.len() as u32)
            .filter(|&e| mesh.edge_facets(e).len() == 2 && mesh.smooth_pair(e).is_none())
            .count();
        assert_eq!(seams, 1);
    }
}
