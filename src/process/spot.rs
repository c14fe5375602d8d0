//! The spot: how the power is spread over the plane square to the beam, and what a point gets while
//! the spot goes past it in a straight line.
//!
//! Densities are of one watt: their integral over the plane is 1, their unit 1/mm². Places are given
//! as (x, y) from the axis, x along the travel direction o and y along n = o × a.

use super::parameters::Profile;
use crate::beam::Optics;
use std::f64::consts::PI;

/// Radius at which a Gaussian spot is cut off, in radii at 1/e²: 3.7e-6 of its power lies beyond.
const GAUSSIAN_REACH: f64 = 2.5;

/// The spot of a job at any height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// How the power is spread.
    pub profile: Profile,
    /// Width of a scanned line, mm. It is the same at every height, as behind a telecentric lens.
    pub line_mm: f64,
    /// Diameter at the defocus distance, mm.
    pub spot_mm: f64,
    /// D, mm.
    pub defocus_mm: f64,
    /// How the diameter changes with the height.
    pub optics: Optics,
}

impl Spot {
    /// Radius at `z_mm` below the focus, mm: the job's spot where the job wants it, elsewhere as the
    /// optics widen it. A spot wider than the optics make it is drawn by something that shifts the beam,
    /// and widens by as much as theirs; a narrower one in proportion.
    pub fn radius_mm(&self, z_mm: f64) -> f64 {
        let (own, here) = (self.optics.spot_mm(self.defocus_mm), self.optics.spot_mm(z_mm));
        if self.spot_mm >= own { 0.5 * (self.spot_mm + here - own) } else { 0.5 * self.spot_mm * here / own }
    }

    /// By how much the radius changes per mm of depth.
    fn widening(&self, z_mm: f64) -> f64 {
        let o = &self.optics;
        let own = 0.5 * o.focus_spot_mm * o.focus_spot_mm * z_mm / (o.rayleigh_mm * o.rayleigh_mm * o.spot_mm(z_mm));
        own * (self.spot_mm / o.spot_mm(self.defocus_mm)).min(1.0)
    }

    /// Half sides of the rectangle, along travel and across, outside of which nothing lands, mm.
    pub fn reach_mm(&self, z_mm: f64) -> [f64; 2] {
        let r = self.radius_mm(z_mm);
        match self.profile {
            Profile::Gaussian => [GAUSSIAN_REACH * r; 2],
            Profile::TopHat => [r; 2],
            Profile::Line => [GAUSSIAN_REACH * r, 0.5 * self.line_mm],
        }
    }

    /// Whether a place is within the spot's diameter, or within the scanned line.
    pub fn covers(&self, [x, y]: [f64; 2], z_mm: f64) -> bool {
        let r = self.radius_mm(z_mm);
        match self.profile {
            Profile::Gaussian | Profile::TopHat => x * x + y * y <= r * r,
            Profile::Line => x.abs() <= r && y.abs() <= 0.5 * self.line_mm,
        }
    }

    /// How the light that lands at `[x, y]` leans against the axis: its slope along o and n. Light runs
    /// towards the focus far from it and along the axis in it, as the beam's rim does.
    pub fn slope(&self, [x, y]: [f64; 2], z_mm: f64) -> [f64; 2] {
        let k = -self.widening(z_mm) / self.radius_mm(z_mm);
        match self.profile {
            Profile::Gaussian | Profile::TopHat => [k * x, k * y],
            Profile::Line => [k * x, 0.0],
        }
    }

    /// No light within reach leans more, at any height.
    pub fn greatest_slope(&self) -> f64 {
        let rim = 0.5 * self.optics.focus_spot_mm / self.optics.rayleigh_mm;
        let corner = if self.profile == Profile::Line { 1.0 } else { 2f64.sqrt() };
        let reach = if self.profile == Profile::TopHat { 1.0 } else { GAUSSIAN_REACH };
        rim * corner * reach * (self.spot_mm / self.optics.spot_mm(self.defocus_mm)).min(1.0)
    }

    /// From when to when, as shares of a straight way past the axis, a place is within reach.
    pub fn window(&self, from: [f64; 2], to: [f64; 2], z_mm: f64) -> Option<[f64; 2]> {
        let reach = self.reach_mm(z_mm);
        let mut window = [0.0f64, 1.0f64];
        for k in 0..2 {
            window = between(window, from[k], to[k] - from[k], reach[k])?;
        }
        (self.profile != Profile::TopHat).then_some(window).or_else(|| {
            // Within the circle: |from + d·t| ≤ r.
            let (r, [x, y]) = (reach[0], from);
            let d = [to[0] - x, to[1] - y];
            let (dd, fd) = (d[0] * d[0] + d[1] * d[1], x * d[0] + y * d[1]);
            let short = r * r - (x * x + y * y);
            if dd <= 1e-24 * r * r {
                return (short >= 0.0).then_some(window);
            }
            let root = (fd * fd + dd * short).max(0.0).sqrt();
            let (a, b) = (((-fd - root) / dd).max(window[0]), ((-fd + root) / dd).min(window[1]));
            (b > a).then_some([a, b])
        })
    }

    /// Integral of the density over a window of the way, the whole way counting 1: times power and
    /// duration it is the energy per area. Closed form.
    pub fn density_integral(&self, from: [f64; 2], to: [f64; 2], z_mm: f64, [t0, t1]: [f64; 2]) -> f64 {
        let r = self.radius_mm(z_mm);
        match self.profile {
            Profile::TopHat => (t1 - t0) / (PI * r * r),
            Profile::Gaussian => {
                let d = [to[0] - from[0], to[1] - from[1]];
                let length = libm::hypot(d[0], d[1]);
                let u = if length > 0.0 { [d[0] / length, d[1] / length] } else { [1.0, 0.0] };
                let (along, across) = (from[0] * u[0] + from[1] * u[1], from[0] * u[1] - from[1] * u[0]);
                line_of_gauss(across, r) * run_of_gauss(along, length, r, t0, t1)
            }
            Profile::Line => run_of_gauss(from[0], to[0] - from[0], r, t0, t1) / self.line_mm,
        }
    }
}

/// The share of `window` in which `|x + d·t| ≤ reach`.
fn between([t0, t1]: [f64; 2], x: f64, d: f64, reach: f64) -> Option<[f64; 2]> {
    if d.abs() <= 1e-12 * reach {
        return (x.abs() <= reach).then_some([t0, t1]);
    }
    let (a, b) = ((-reach - x) / d, (reach - x) / d);
    let (a, b) = (a.min(b).max(t0), a.max(b).min(t1));
    (b > a).then_some([a, b])
}

/// Gaussian density in one direction at `x`, 1/mm; `r` is where 1/e² is left.
fn line_of_gauss(x: f64, r: f64) -> f64 {
    (2.0 / PI).sqrt() / r * libm::exp(-2.0 * x * x / (r * r))
}

/// Integral of that density at `x + d·t` over t from t0 to t1.
fn run_of_gauss(x: f64, d: f64, r: f64, t0: f64, t1: f64) -> f64 {
    // Below this the difference of two erf is rounding alone; the density hardly changes on the way.
    if d.abs() * (t1 - t0) <= 1e-6 * r {
        return line_of_gauss(x + 0.5 * d * (t0 + t1), r) * (t1 - t0);
    }
    let k = 2f64.sqrt() / r;
    0.5 * (libm::erf(k * (x + d * t1)) - libm::erf(k * (x + d * t0))) / d
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn spot(profile: Profile) -> Spot {
        Spot { profile, line_mm: 3.0, spot_mm: 1.2, defocus_mm: 20.0, optics: Optics::default() }
    }

    /// The density at a place, from the way that is none.
    fn density(s: &Spot, at: [f64; 2], z: f64) -> f64 {
        s.window(at, at, z).map_or(0.0, |w| s.density_integral(at, at, z, w))
    }

    #[test]
    fn every_profile_holds_one_watt_at_every_height() {
        for profile in Profile::ALL {
            for z in [-30.0, 0.0, 20.0, 50.0] {
                let s = spot(profile);
                let [rx, ry] = s.reach_mm(z);
                let n = 400;
                let cell = |i: i32, r: f64| (f64::from(i) + 0.5) * r / f64::from(n);
                let sum: f64 = (-n..n)
                    .flat_map(|i| (-n..n).map(move |j| [cell(i, rx), cell(j, ry)]))
                    .map(|at| density(&s, at, z))
                    .sum();
                let whole = sum * rx * ry / f64::from(n * n);
                let off = if profile == Profile::TopHat { 1e-3 } else { 1e-5 };
                assert!((whole - 1.0).abs() < off, "{profile:?} at {z}: {whole}");
            }
        }
    }

    /// The rim's light leans as the beam widens, whether the optics make the spot or something else.
    #[test]
    fn the_rim_widens_by_its_slope() {
        for spot_mm in [0.4, 1.0, 3.0] {
            let s = Spot { spot_mm, ..spot(Profile::TopHat) };
            assert!((s.radius_mm(20.0) - 0.5 * spot_mm).abs() < 1e-12);
            for z in [-150.0, -3.0, 0.0, 1.0, 20.0, 60.0] {
                let step = 1e-4;
                let slope = (s.radius_mm(z + step) - s.radius_mm(z - step)) / (2.0 * step);
                assert!((s.slope([s.radius_mm(z), 0.0], z)[0] + slope).abs() < 1e-6);
                assert!(slope.abs() <= s.greatest_slope());
            }
        }
    }

    proptest! {
        /// The closed form is the sum over short pieces of the way.
        #[test]
        fn the_closed_form_is_the_integral(x in prop::array::uniform4(-1.5..1.5f64), z in -40.0..40.0f64, which in 0..3usize) {
            let s = spot(Profile::ALL[which]);
            let (from, to) = ([x[0], x[1]], [x[2], x[3]]);
            let exact = s.window(from, to, z).map_or(0.0, |w| s.density_integral(from, to, z, w));
            let n = 20_000;
            let at = |i: i32| {
                let t = (f64::from(i) + 0.5) / f64::from(n);
                [0, 1].map(|k| from[k] + (to[k] - from[k]) * t)
            };
            let sum: f64 = (0..n).map(|i| density(&s, at(i), z)).sum::<f64>() / f64::from(n);
            let peak = density(&s, [0.0; 2], z);
            // A top-hat jumps at its rim: one step of the sum at either end.
            prop_assert!((exact - sum).abs() < peak * 2.0e-4, "{exact} against {sum}");
        }
    }
}
