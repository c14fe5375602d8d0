//! Winding: neighbours agree, closed shells look outward, closed shells inside an odd number of
//! others look towards their void, open sheets to the side that most of their area has in the file.
//!
//! A *sheet* here is a set of facets connected through edges of exactly two facets; where it cannot be
//! oriented (a Möbius strip) its seam stays a place where two facets disagree. Where a file has both sides of a
//! sheet without thickness, each is a sheet of its own, and looks as it does in the file.

use super::nesting::Nesting;
use super::topology::Mesh;
use super::union_find::UnionFind;
use crate::progress::{Cancelled, Progress};

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
    // Nobody else holds this progress, so it is not cancelled.
    orient_under(&Progress::default(), mesh).unwrap_or_default()
}

/// Orients the facets in place, as long as nobody wants that to end.
///
/// # Errors
/// [`Cancelled`] when `progress` says so; none is turned then.
pub fn orient_under(progress: &Progress, mesh: &mut Mesh) -> Result<Orientation, Cancelled> {
    let (sheet_of, turned, torn) = agree(mesh, progress)?;
    let sheets = gather(&sheet_of);
    progress.check()?;
    let mut flip = turned;
    let closed: Vec<bool> = sheets
        .iter()
        .enumerate()
        .map(|(s, facets)| !torn[s] && facets.iter().all(|&f| is_closed_at(mesh, f)))
        .collect();
    let closed_ones = sheets.iter().enumerate().filter(|(s, _)| closed[*s]).map(|(s, f)| (s as u32, f.as_slice()));
    progress.check()?;
    let mut nesting = Nesting::new(mesh, &sheet_of, closed_ones);
    for (s, facets) in sheets.iter().enumerate() {
        progress.check()?;
        let wrong = if facets.iter().any(|&f| mesh.back_of(f).is_some()) {
            false
        } else if closed[s] {
            // Volume with the turned facets counted as turned.
            let outward = signed_volume(mesh, facets, &flip) > 0.0;
            outward == (nesting.depth(s as u32, facets, progress)? % 2 == 1)
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
    let (shell_of, shells) = shells(mesh, progress)?;
    for (f, &turn) in flip.iter().enumerate() {
        if turn {
            mesh.flip(f);
        }
    }
    Ok(Orientation {
        flipped_facets: flip.iter().filter(|&&t| t).count(),
        shell_of,
        shells,
        watertight: (0..mesh.edges.len() as u32).all(|e| mesh.edge_facets(e).len() == 2),
    })
}

fn is_closed_at(mesh: &Mesh, f: u32) -> bool {
    mesh.facet_edges[f as usize].iter().all(|&e| mesh.across(f, e).is_some())
}

/// Sheet of each facet, whether it must turn, and torn sheets.
type Sheets = (Vec<u32>, Vec<bool>, Vec<bool>);

/// Sheet of each facet, whether it must turn to agree with the sheet's first, and torn sheets.
fn agree(mesh: &Mesh, progress: &Progress) -> Result<Sheets, Cancelled> {
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
            progress.check()?;
            for e in mesh.facet_edges[f as usize] {
                let Some(g) = mesh.across(f, e) else { continue };
                if mesh.is_fold([f, g], e) {
                    torn[sheet as usize] = true;
                    continue;
                }
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
    Ok((sheet_of, turn, torn))
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

/// Shells by union over shared edges.
fn shells(mesh: &Mesh, progress: &Progress) -> Result<(Vec<u32>, usize), Cancelled> {
    let mut sets = UnionFind::new(mesh.facets.len());
    for e in 0..mesh.edges.len() as u32 {
        progress.check_at(e as usize)?;
        for pair in mesh.edge_facets(e).windows(2) {
            sets.join(pair[0], pair[1]);
        }
    }
    let (mut numbers, mut count) = (vec![0u32; mesh.facets.len()], 0);
    let shell_of: Vec<u32> = (0..mesh.facets.len() as u32)
        .map(|f| {
            let number = &mut numbers[sets.root(f) as usize];
            if *number == 0 {
                count += 1;
                *number = count;
            }
            *number
        })
        .collect();
    Ok((shell_of, count as usize))
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
    fn voids_of_one_block_are_told_from_the_bodies_in_them_and_beside_it() {
        let at = |i: u8| [1.0, 11.0, 21.0].map(|x: f32| x)[usize::from(i)];
        let place = |n: u8, by: f32| [at(n % 3) + by, at(n / 3 % 3) + by, at(n / 9) + by];
        let moved = |facets: Vec<RawFacet>, to: [f32; 3]| -> Vec<RawFacet> {
            facets.iter().map(|f| f.map(|p| [0, 1, 2].map(|k| p[k] + to[k]))).collect()
        };
        let mut facets = cube(0.0, 32.0);
        for n in 0..27 {
            facets.extend(moved(cube(0.0, 8.0), place(n, 0.0)));
            facets.extend(moved(cube(0.0, 2.0), place(n, 3.0)));
            facets.extend(moved(cube(0.0, 8.0), [at(n % 3), at(n / 3 % 3), at(n / 9) + 40.0]));
        }
        let mut mesh = Mesh::weld(&facets, 1.0);
        let o = orient(&mut mesh);
        assert_eq!((o.flipped_facets, o.shells), (27 * 12, 1 + 3 * 27));
        assert!((volume(&mesh) - (32768.0 + 27.0 * 8.0)).abs() < 1e-6);
    }

    #[test]
    fn a_skin_with_both_sides_keeps_them() {
        let outside = cube(0.0, 2.0);
        let both: Vec<RawFacet> = outside.iter().copied().chain(turned(outside.clone(), |_| true)).collect();
        let mut mesh = Mesh::weld(&both, 1.0);
        assert_eq!(orient(&mut mesh).flipped_facets, 0);
        assert!((0..12).all(|f| (mesh.normals[f] + mesh.normals[f + 12]).norm() == 0.0));
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
