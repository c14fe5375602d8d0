//! Which side of each plane is outward: by the cloud's own normals, or handed on from plane to plane along a minimum
//! spanning tree of the turns between them (Hoppe et al., "Surface reconstruction from unorganized points", 1992).
//!
//! What is handed on is one side for all of a connected component; which one is a guess: that on which most of the
//! component faces away from its middle. Right for whatever is closed, and so is its sign: the sum is three times the
//! volume then. A cavity that nothing joins to the outside is taken for a solid.

use super::first_planes::FirstPlane;
use crate::part::union_find::UnionFind;
use crate::progress::{Cancelled, Progress};
use crate::scan::cloud::Cloud;
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;

/// How the mesh's outward side was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Oriented {
    /// The cloud's own normals tell it.
    OwnNormals,
    /// Guessed for each connected component from its shape.
    Propagated,
}

/// Share of the greatest possible sum below which a component faces its middle on neither side: a shallow sheet. A
/// hemisphere has 0.5, a plane 0, a cap of 20° 0.06.
const FACES_NEITHER: f64 = 0.03;

/// Turns the planes' normals outward.
pub(super) fn orient(cloud: &Cloud, planes: &mut [FirstPlane], progress: &Progress) -> Result<Oriented, Cancelled> {
    if cloud.normals.is_some() {
        for (i, plane) in planes.iter_mut().enumerate() {
            if cloud.normal(i).is_some_and(|own| own.dot(&plane.normal) < 0.0) {
                plane.normal = -plane.normal;
            }
        }
        return Ok(Oriented::OwnNormals);
    }
    let tree = Tree::new(planes, progress)?;
    hand_on(planes, &tree, progress)?;
    face_outward(cloud, planes, &tree.component);
    Ok(Oriented::Propagated)
}

/// Edges of the minimum spanning trees, point by point.
struct Tree {
    start: Vec<u32>,
    other: Vec<u32>,
    /// The lowest point of each point's component.
    component: Vec<u32>,
}

impl Tree {
    fn new(planes: &[FirstPlane], progress: &Progress) -> Result<Tree, Cancelled> {
        // How far two normals are from parallel, as bits, which are ordered alike; then the points, lower first.
        let turn = |a: u32, b: u32| {
            let cosine = planes[a as usize].normal.dot(&planes[b as usize].normal).abs();
            ((1.0 - cosine).max(0.0) as f32).to_bits()
        };
        let mut edges: Vec<(u32, u32, u32)> = (0..planes.len() as u32)
            .into_par_iter()
            .flat_map_iter(|i| {
                let plane = &planes[i as usize];
                let beside = &plane.beside[..usize::from(plane.count)];
                beside.iter().map(move |&j| (turn(i, j), i.min(j), i.max(j)))
            })
            .collect();
        progress.check()?;
        edges.par_sort_unstable();
        progress.check()?;
        let mut sets = UnionFind::new(planes.len());
        let mut kept = Vec::with_capacity(planes.len());
        for (at, &(_, a, b)) in edges.iter().enumerate() {
            progress.check_at(at)?;
            if sets.root(a) != sets.root(b) {
                sets.join(a, b);
                kept.push([a, b]);
            }
        }
        let component = (0..planes.len() as u32).map(|i| sets.root(i)).collect();
        Ok(Tree::of_edges(planes.len(), &kept, component))
    }

    fn of_edges(count: usize, edges: &[[u32; 2]], component: Vec<u32>) -> Tree {
        let mut start = vec![0u32; count + 1];
        edges.iter().flatten().for_each(|&i| start[i as usize + 1] += 1);
        (0..count).for_each(|i| start[i + 1] += start[i]);
        let (mut next, mut other) = (start.clone(), vec![0; 2 * edges.len()]);
        for &[a, b] in edges {
            for (from, to) in [(a, b), (b, a)] {
                other[next[from as usize] as usize] = to;
                next[from as usize] += 1;
            }
        }
        Tree { start, other, component }
    }
}

/// Gives all planes of a component the side of its lowest point.
fn hand_on(planes: &mut [FirstPlane], tree: &Tree, progress: &Progress) -> Result<(), Cancelled> {
    let mut seen = vec![false; planes.len()];
    let mut open = Vec::new();
    for root in 0..planes.len() {
        if tree.component[root] as usize != root {
            continue;
        }
        seen[root] = true;
        open.push(root);
        while let Some(i) = open.pop() {
            progress.check_at(i)?;
            let own = planes[i].normal;
            for &j in &tree.other[tree.start[i] as usize..tree.start[i + 1] as usize] {
                let j = j as usize;
                if !seen[j] {
                    seen[j] = true;
                    if planes[j].normal.dot(&own) < 0.0 {
                        planes[j].normal = -planes[j].normal;
                    }
                    open.push(j);
                }
            }
        }
    }
    Ok(())
}

/// Sums over the points of a component.
#[derive(Clone, Copy, Default)]
struct Sums {
    count: f64,
    place: Vector3<f64>,
    normal: Vector3<f64>,
    /// Of place · normal, and of distances from the middle.
    flux: f64,
    distance: f64,
}

/// Turns each component so that it faces away from its middle, or from the cloud's where that says nothing.
fn face_outward(cloud: &Cloud, planes: &mut [FirstPlane], component: &[u32]) {
    let mut sums = vec![Sums::default(); planes.len()];
    let mut whole = Vector3::zeros();
    for (i, plane) in planes.iter().enumerate() {
        let (sum, place) = (&mut sums[component[i] as usize], cloud.point(i) - cloud.origin);
        sum.count += 1.0;
        sum.place += place;
        sum.normal += plane.normal;
        sum.flux += place.dot(&plane.normal);
        whole += place;
    }
    let middle = Point3::from(whole / planes.len().max(1) as f64);
    for (i, root) in component.iter().enumerate() {
        let sum = &mut sums[*root as usize];
        sum.distance += (cloud.point(i) - cloud.origin - sum.place / sum.count).norm();
    }
    let inward: Vec<bool> = sums.iter().map(|s| s.count > 0.0 && s.faces_inward(&middle)).collect();
    for (plane, root) in planes.iter_mut().zip(component) {
        if inward[*root as usize] {
            plane.normal = -plane.normal;
        }
    }
}

impl Sums {
    fn faces_inward(&self, middle_of_all: &Point3<f64>) -> bool {
        let own = self.flux - self.normal.dot(&self.place) / self.count;
        let from_all = self.flux - self.normal.dot(&middle_of_all.coords);
        if own.abs() > FACES_NEITHER * self.distance {
            return own < 0.0;
        }
        let far = (self.place / self.count - middle_of_all.coords).norm() * self.count;
        if from_all.abs() > FACES_NEITHER * (self.distance + far) {
            return from_all < 0.0;
        }
        // A lone flat sheet: up, as one that lies on a table.
        self.normal.z < 0.0 || (self.normal.z == 0.0 && self.normal.x + self.normal.y < 0.0)
    }
}
