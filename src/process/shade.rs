//! What stands between a point and the light: the part itself, and clamps.
//!
//! The light that lands beside the axis comes along its own ray, through the focus and on to the lens.

use super::light::{Light, Passing};
use super::light_piece::LightPiece;
use crate::beam::Obstacle;
use crate::part::{Bvh, Part, bvh::ray_hit_mm};
use crate::pose::Obstruction;
use nalgebra::{Isometry3, Point3, Vector3};

/// Rays start so far above their point, mm. From below: twenty times the rounding of f32 coordinates
/// on a metre (6e-5 mm), so that a face that a dirty export covers twice does not shade itself. From
/// above: nothing that shades is nearer to what it shades, but at a crease, where the light comes by
/// anyway.
const START_MM: f64 = 1e-3;
/// Greatest number of places at which a window is tested.
const MOST_LOOKS: usize = 7;
/// Distance of those places in radii of the spot, the ends among them: what shades for a shorter way is
/// overlooked. A way shorter than that is tested once, in the middle.
const LOOK_RADII: f64 = 0.5;
/// Share of the energy in the middle of one line below which a passing is faint: then the last test decides.
const FAINT: f64 = 1e-3;
/// Bisections for the edge of a shadow between two places that differ.
const HALVINGS: usize = 4;

/// A point of a facet; the facet does not shade it.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint {
    /// The point, mm, part frame.
    pub p: Point3<f64>,
    /// Its facet.
    pub facet: u32,
}

/// The bodies that shade.
pub struct Shade<'a> {
    part: &'a Bvh,
    clamps: Vec<(&'a Part, Isometry3<f64>, Obstruction)>,
}

/// The last results: light and shade change little from one piece to the next, and from one point to its
/// neighbour.
#[derive(Clone, Copy, Default)]
pub struct LastShade {
    /// The facet that shaded is likely to shade the next point too.
    facet: Option<(u32, [Point3<f64>; 3])>,
    /// What stood in the way at this point: of which pass, at which place about the axis.
    look: Option<(u32, [f64; 2], Option<Obstruction>)>,
}

impl LastShade {
    /// Moves on to another point.
    pub fn next_point(&mut self) {
        self.look = None;
    }
}

/// The part of a passing's energy that lands.
#[derive(Clone, Copy, Debug)]
pub struct Landing {
    /// Share of the passing's energy.
    pub share: f64,
    /// What keeps the rest off.
    pub by: Option<Obstruction>,
}

impl<'a> Shade<'a> {
    /// Part and clamps, all in the part frame.
    pub fn new(part: &'a Part, clamps: &'a [Obstacle]) -> Shade<'a> {
        let clamp =
            |(i, c): (usize, &'a Obstacle)| (c.solid(), c.at().inverse(), Obstruction::of_clamp(i, c.is_unscanned()));
        Shade { part: &part.bvh, clamps: clamps.iter().enumerate().map(clamp).collect() }
    }

    /// Whether a clamp is within reach of a segment.
    pub fn clamp_near(&self, from: &Point3<f64>, to: &Point3<f64>, reach_mm: f64) -> bool {
        self.clamps.iter().any(|(solid, at, _)| solid.bvh.near_segment(&(at * from), &(at * to), reach_mm))
    }

    /// The part of a passing's energy that lands at a point of a facet.
    pub fn landing(
        &self,
        light: &Light,
        piece: &LightPiece,
        at: &SurfacePoint,
        passing: &Passing,
        last: &mut LastShade,
    ) -> Landing {
        let [t0, t1] = passing.window;
        let way = [0, 1].map(|k| (passing.seen.to[k] - passing.seen.from[k]) * (t1 - t0));
        let apart = LOOK_RADII * light.spot(piece).radius_mm(passing.seen.z_mm);
        let stretches = (libm::hypot(way[0], way[1]) / apart).min((MOST_LOOKS - 1) as f64) as usize;
        let middle = passing.seen.at(0.5 * (t0 + t1));
        if let Some((_, place, wall)) = last.look.filter(|l| l.0 == piece.pass) {
            let is_near = stretches == 0 && libm::hypot(middle[0] - place[0], middle[1] - place[1]) <= 0.5 * apart;
            if is_near || passing.j_mm2 < FAINT * light.line_j_mm2(piece) {
                return Landing { share: if wall.is_none() { 1.0 } else { 0.0 }, by: wall };
            }
        }
        let mut look = |t: f64| self.wall(light, piece, at, passing, t, last);
        let time =
            |k: usize| if stretches == 0 { 0.5 * (t0 + t1) } else { t0 + (t1 - t0) * k as f64 / stretches as f64 };
        let mut looks: [Option<Obstruction>; MOST_LOOKS] = [None; MOST_LOOKS];
        let looks = &mut looks[..=stretches];
        for (k, found) in looks.iter_mut().enumerate() {
            *found = look(time(k));
        }
        let by = looks.iter().flatten().next().copied();
        let end = looks.last().copied().flatten();
        let kept = Some((piece.pass, passing.seen.at(time(stretches)), end));
        if by.is_none() || looks.iter().all(Option::is_some) {
            last.look = kept;
            return Landing { share: if by.is_none() { 1.0 } else { 0.0 }, by };
        }
        let (mut lit, mut since) = (0.0, t0);
        for k in 0..looks.len() {
            let is_free = looks[k].is_none();
            let until = match looks.get(k + 1) {
                None => t1,
                Some(next) if next.is_none() == is_free => continue,
                Some(_) => {
                    let (mut a, mut b) = (time(k), time(k + 1));
                    for _ in 0..HALVINGS {
                        let middle = 0.5 * (a + b);
                        if look(middle).is_none() == is_free { a = middle } else { b = middle }
                    }
                    0.5 * (a + b)
                }
            };
            if is_free {
                lit += light.energy(piece, &passing.seen, [since, until]);
            }
            since = until;
        }
        last.look = kept;
        Landing { share: (lit / passing.j_mm2).min(1.0), by }
    }

    /// What is in the way of the light at one moment.
    fn wall(
        &self,
        light: &Light,
        piece: &LightPiece,
        at: &SurfacePoint,
        passing: &Passing,
        t: f64,
        last: &mut LastShade,
    ) -> Option<Obstruction> {
        let (q, own) = (&at.p, at.facet);
        let z_mm = passing.seen.z_mm;
        let [along, across] = light.spot(piece).slope(passing.seen.at(t), z_mm);
        let mix = |u: &Vector3<f64>, v: &Vector3<f64>| u * (1.0 - t) + v * t;
        let ray = mix(&piece.from.a, &piece.to.a)
            + mix(&piece.from.o, &piece.to.o) * along
            + mix(&piece.from.n, &piece.to.n) * across;
        let length = ray.norm();
        let dir = ray / length;
        let until = (z_mm + light.spot(piece).optics.lens_to_focus_mm) * length;
        let stops =
            |corners: &[Point3<f64>; 3]| ray_hit_mm(corners, q, &dir).is_some_and(|s| s > START_MM && s < until);
        if let Some((facet, corners)) = last.facet
            && facet != own
            && stops(&corners)
        {
            return Some(Obstruction::Facet(facet));
        }
        let mut wall = None;
        self.part.visit_ray(q, &dir, START_MM, until, 0.0, |facet, corners| {
            if facet != own && stops(corners) {
                wall = Some(Obstruction::Facet(facet));
                last.facet = Some((facet, *corners));
                return -1.0;
            }
            until
        });
        wall.or_else(|| {
            self.clamps.iter().find_map(|(solid, at, what)| {
                solid.bvh.nearest_hit(&(at * q), &(at * dir), START_MM, until).map(|_| *what)
            })
        })
    }
}
