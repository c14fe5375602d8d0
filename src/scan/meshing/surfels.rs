//! All pieces of the surface: which points of a cloud have one, and what they say together of a place.
//!
//! A place is judged by the pieces nearest to it whose normals agree, so that of a thin sheet only the near side counts.

use super::cell_size::Grain;
use super::first_planes::{FirstPlane, first_planes};
use super::orientation::{Oriented, orient};
use super::surfel::{Counted, Seen, Surfel};
use crate::progress::{Cancelled, Progress};
use crate::scan::cleaning::{VoxelMeans, voxel_means};
use crate::scan::cloud::Cloud;
use crate::scan::neighbours::{Neighbour, Neighbours};
use nalgebra::{Point3, Vector3};

/// Side of the voxels that points are thinned to, in cells: then there are about three points to the square of a cell
/// however dense the cloud is.
const VOXEL: f64 = 0.6;
/// Neighbours of a quadric. Weights that fade leave the worth of 18 of them, and three of those go into the height:
/// 0.4 σ; with the voxels' means and the pieces around it, less.
const NEIGHBOURS: usize = 32;
/// What is further off than so many cells is no neighbour; sheets this far apart are told apart.
const REACH: f64 = 4.0;
/// Fewer neighbours than these are no support: what a quadric has to tell, and as many again.
const FEWEST: usize = 12;
/// Points that stand so much more thinly than the middle ones are strays. At a corner of the thinnest region (a
/// quarter of the density) there is a sixteenth.
const THINNER: f64 = 24.0;
/// Normals whose cosine is less do not belong to one surface: the far side of a sheet, the other face of an edge.
/// Up to the second one they count more and more.
const AGREEING: [f64; 2] = [0.3, 0.8];
/// How far the surface goes on around a point, as a share of the reach of its neighbours, and at least a cell. Of
/// points scattered at random one place in a million has none so near; with 0.55 a plate with a quarter of the density
/// on one side has holes there. Holes of up to three cells close with it.
const GOES_ON: f64 = 0.65;
/// So near to a piece, in cells, the surface is sure to go on.
const SURELY_ON: f64 = 0.5;
/// Further off, pieces have to stand on more than one side: the middle of the nearest ones lies off the place by less
/// than this share of the way to the last. It is 0.42 on a straight rim, and rises beyond it. Of 16 scattered pieces
/// around a place it is above 0.6 once in 100 000 times.
const ONE_SIDED: f64 = 0.6;
/// Pieces that are asked whether they stand on more than one side.
const AROUND: usize = 16;
/// Pieces that are asked of a place.
const ASKED: usize = 10;

/// The pieces of a cloud's surface.
pub(super) struct Surfels {
    pub all: Vec<Surfel>,
    pub oriented: Oriented,
    /// Points of the cloud that no piece stands for.
    pub dropped: usize,
    /// Points of the cloud at which pieces stand, one of each voxel, ascending.
    pub stand_for: Vec<u32>,
    feet: Neighbours,
}

/// Room that one thread uses again and again.
#[derive(Default)]
pub(super) struct Room {
    near: Vec<Neighbour>,
}

impl Surfels {
    /// The pieces of a cloud of finite points. `None` where it is far too wide for its cells.
    pub fn new(cloud: &Cloud, grain: &Grain, progress: &Progress) -> Result<Option<Surfels>, Cancelled> {
        let Some(means) = voxel_means(cloud, VOXEL * grain.cell_mm, progress)? else { return Ok(None) };
        let neighbours = Neighbours::new(&means.cloud, progress)?;
        let mut planes = first_planes(&means, &neighbours, REACH * grain.cell_mm, progress)?;
        let oriented = orient(&means.cloud, &mut planes, progress)?;
        let fitted = fitted(&means, &planes, &neighbours, grain.cell_mm, progress)?;
        let mut thinness: Vec<f64> = fitted.iter().flatten().map(|f| f.1).collect();
        let half = thinness.len() / 2;
        let least = match thinness.get(half) {
            Some(_) => *thinness.select_nth_unstable_by(half, f64::total_cmp).1 / THINNER,
            None => 0.0,
        };
        let mut surfels =
            Surfels { all: Vec::new(), oriented, dropped: 0, stand_for: Vec::new(), feet: Neighbours::default() };
        for (i, fit) in fitted.iter().enumerate() {
            match fit.filter(|f| f.1 >= least) {
                Some((surfel, _)) => {
                    surfels.all.push(surfel);
                    surfels.stand_for.push(means.first[i]);
                }
                None => surfels.dropped += means.count[i] as usize,
            }
        }
        let feet: Vec<Point3<f64>> = surfels.all.iter().map(Surfel::foot).collect();
        surfels.feet = Neighbours::new(&Cloud::of_points(&feet), progress)?;
        Ok(Some(surfels))
    }

    /// The foot of a place on the surface; `None` where no points were measured: beyond a rim, or in a hole.
    pub fn landed(&self, p: &Point3<f64>, cell_mm: f64, room: &mut Room) -> Option<Point3<f64>> {
        self.feet.nearest(p, AROUND, &mut room.near);
        let seen = self.together(p, &room.near[..room.near.len().min(ASKED)])?;
        let landed = p - seen.normal * seen.off_mm.clamp(-cell_mm, cell_mm);
        let (mut sum, mut last_mm, mut nearest) = (Vector3::zeros(), 0.0f64, (f64::INFINITY, 0.0));
        for n in &room.near {
            let surfel = &self.all[n.index as usize];
            let way = surfel.foot() - landed;
            sum += way;
            last_mm = last_mm.max(way.norm());
            if way.norm() < nearest.0 {
                nearest = (way.norm(), surfel.reach_mm);
            }
        }
        let (distance_mm, reach_mm) = nearest;
        let on_both_sides = sum.norm() < ONE_SIDED * last_mm * room.near.len() as f64;
        let is_measured = distance_mm <= SURELY_ON * cell_mm || (distance_mm <= reach_mm && on_both_sides);
        is_measured.then_some(landed)
    }

    /// How the pieces around a place see it, those nearer counting more; `None` where the nearest is further off.
    pub fn seen(&self, p: &Point3<f64>, within_mm: f64, room: &mut Room) -> Option<Seen> {
        self.feet.nearest(p, ASKED, &mut room.near);
        let is_near = f64::from(room.near.first()?.squared) <= within_mm * within_mm;
        is_near.then(|| self.together(p, &room.near))?
    }

    fn together(&self, p: &Point3<f64>, near: &[Neighbour]) -> Option<Seen> {
        let first = self.all[near.first()?.index as usize].seen(p);
        let last = f64::from(near.last()?.squared) * 1.02 + f64::MIN_POSITIVE;
        let (mut whole, mut off_mm, mut normal) = (0.0, 0.0, Vector3::zeros());
        for n in near {
            let seen = self.all[n.index as usize].seen(p);
            let near = 1.0 - f64::from(n.squared) / last;
            let weight = near * near * agreement(&first.normal, &seen.normal);
            whole += weight;
            off_mm += weight * seen.off_mm;
            normal += seen.normal * weight;
        }
        let normal = crate::part::angle::unit(normal)?;
        (whole > 0.0).then(|| Seen { off_mm: off_mm / whole, normal })
    }
}

/// How much two normals are of one surface, 0 to 1.
fn agreement(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    ((a.dot(b) - AGREEING[0]) / (AGREEING[1] - AGREEING[0])).clamp(0.0, 1.0)
}

/// The quadric at each point of a thinned cloud with the density of the points around it, per mm²; `None` where they
/// are too few, or the point is a stray.
fn fitted(
    means: &VoxelMeans,
    planes: &[FirstPlane],
    neighbours: &Neighbours,
    cell_mm: f64,
    progress: &Progress,
) -> Result<Vec<Option<(Surfel, f64)>>, Cancelled> {
    let reach2 = (REACH * cell_mm * REACH * cell_mm) as f32;
    neighbours.map_nearest(NEIGHBOURS, progress, |index, near| {
        let mut order: Vec<Neighbour> = near.iter().copied().filter(|n| n.squared <= reach2).collect();
        if order.len() < FEWEST {
            return None;
        }
        order.sort_unstable_by(|a, b| a.squared.total_cmp(&b.squared).then(a.index.cmp(&b.index)));
        let own = planes[index as usize].normal;
        let radius2 = 1.02 * f64::from(order.last()?.squared);
        // The point itself has no say: its fit has to tell whether it is a stray.
        let mut points = f64::from(means.count[index as usize]);
        let counted = order.iter().map(|n| {
            let (i, share) = (n.index as usize, 1.0 - f64::from(n.squared) / radius2);
            let count = f64::from(means.count[i]);
            points += count;
            let weight = count * share * share * agreement(&own, &planes[i].normal);
            Counted { place: means.cloud.point(i), weight }
        });
        let counted: Vec<Counted> = counted.collect();
        let (radius_mm, density) = (radius2.sqrt(), points / radius2);
        let middle = means.cloud.point(index as usize);
        let mut surfel = Surfel::fitted(middle, own, &counted, radius_mm, &mut Vec::new())?;
        surfel.reach_mm = (GOES_ON * radius_mm).max(cell_mm);
        Some((surfel, density))
    })
}
