//! A scan's points under a look: as the scanner saw them, what cleaning keeps and drops, how far they lie off the model.
//! An item is as large as its cloud; whoever shows it keeps it until the look changes.

use super::deviation::DeviationScale;
use super::palette::{Rgb, mixed, scan};
use crate::part::Hasher;
use crate::scan::Cloud;
use crate::view::{Bounds, CloudItem, Places};
use nalgebra::{Isometry3, Translation3, Vector3};
use std::sync::Arc;

/// Side of a dot, points of the display: a million of them cover a part that fills the window, and the part's shape is
/// still seen between fewer.
const SIZE_POINTS: f32 = 2.0;
/// Greatest lift of deviating points, share of the cloud's diagonal: beyond it they would shine through walls.
const LARGEST_LIFT: f64 = 0.02;
/// The darkest grey of an intensity, which the dark view still shows, and the brightest.
const GREYS: [Rgb; 2] = [[74, 76, 80], [244, 246, 248]];
/// Intensities looked at for the ends of the greys.
const INTENSITIES: usize = 20_000;

/// How a scan is shown.
#[derive(Clone, Copy, Debug)]
pub enum ScanLook<'a> {
    /// The scanner's colours; without them its intensities; without those one colour.
    Own,
    /// One colour, shaded by the scanner's normals, without them darker the farther away it is.
    Plain,
    /// What cleaning drops in a warning colour.
    Cleaned {
        /// Whether each point stays.
        kept: &'a [bool],
        /// Dropped points are seen.
        shows_dropped: bool,
    },
    /// Signed distance of each point from the model.
    Deviation {
        /// Outside above 0, mm; NaN: no model near.
        deviation_mm: &'a [f32],
        /// Its colours.
        scale: DeviationScale,
    },
}

/// A cloud that is shown.
#[derive(Clone, Debug)]
pub struct ScanPicture {
    key: u64,
    cloud: Arc<Cloud>,
    bounds: Option<Bounds>,
}

/// The cloud's own places, not a copy.
#[derive(Debug)]
struct OfCloud(Arc<Cloud>);

impl Places for OfCloud {
    fn places(&self) -> &[[f32; 3]] {
        &self.0.offsets
    }
}

impl ScanPicture {
    /// Looks at all points once. `key` changes with their places.
    pub fn new(cloud: Arc<Cloud>, key: u64) -> ScanPicture {
        let bounds = cloud.bounds().map(|(min, max)| Bounds { min, max });
        ScanPicture { key, cloud, bounds }
    }

    /// A box around the points, mm; `None` without points.
    pub fn bounds(&self, scene_from_scan: &Isometry3<f64>) -> Option<Bounds> {
        Bounds::around(self.bounds?.corners().map(|corner| scene_from_scan * corner))
    }

    /// The points under a look. What a look has no value for is as if it had none there (kept; grey).
    pub fn item(&self, look: ScanLook<'_>, scene_from_scan: &Isometry3<f64>) -> CloudItem {
        let colors: Vec<[u8; 4]> = match look {
            ScanLook::Own => self.own_colors(),
            ScanLook::Plain => (0..self.cloud.len()).map(|i| opaque(self.shaded(i))).collect(),
            ScanLook::Cleaned { kept, shows_dropped } => {
                let [r, g, b] = scan::DROPPED;
                let dropped = [r, g, b, if shows_dropped { 255 } else { 0 }];
                let is_kept = |i: usize| kept.get(i).copied().unwrap_or(true);
                (0..self.cloud.len()).map(|i| if is_kept(i) { opaque(self.shaded(i)) } else { dropped }).collect()
            }
            ScanLook::Deviation { deviation_mm, scale } => {
                let of = |i: usize| deviation_mm.get(i).copied().unwrap_or(f32::NAN);
                (0..self.cloud.len()).map(|i| opaque(scale.color(f64::from(of(i))))).collect()
            }
        };
        CloudItem {
            geometry_key: self.key,
            places: Arc::new(OfCloud(self.cloud.clone())),
            colors_key: Hasher::default().bytes(colors.as_flattened()).finish().0 as u64,
            colors: Arc::new(colors),
            size_points: SIZE_POINTS,
            lift_mm: self.lift_mm(look) as f32,
            fades: self.fades(look),
            scene_from_item: scene_from_scan * Translation3::from(self.cloud.origin),
        }
    }

    /// So much that the deepest point still shows on the model.
    fn lift_mm(&self, look: ScanLook<'_>) -> f64 {
        let ScanLook::Deviation { deviation_mm, .. } = look else { return 0.0 };
        let deepest_mm = deviation_mm.iter().fold(0.0_f32, |deepest, mm| deepest.max(-mm));
        f64::from(deepest_mm).min(LARGEST_LIFT * self.cloud.diagonal())
    }

    /// Where nothing else shows the shape: neither the scanner's eye nor normals.
    fn fades(&self, look: ScanLook<'_>) -> bool {
        let has_own = self.cloud.colours.is_some() || self.cloud.intensities.is_some();
        self.cloud.normals.is_none()
            && match look {
                ScanLook::Own => !has_own,
                ScanLook::Plain | ScanLook::Cleaned { .. } => true,
                ScanLook::Deviation { .. } => false,
            }
    }

    fn own_colors(&self) -> Vec<[u8; 4]> {
        let cloud = &self.cloud;
        match (&cloud.colours, &cloud.intensities) {
            (Some(colours), _) => colours.iter().copied().map(opaque).collect(),
            (None, Some(intensities)) => {
                let [low, high] = grey_ends(intensities);
                let share = |i: f32| ((i - low) / (high - low)).clamp(0.0, 1.0);
                // A point without a number is dark.
                let grey = |i: f32| mixed(GREYS[0], GREYS[1], if share(i).is_nan() { 0.0 } else { share(i) });
                intensities.iter().map(|i| opaque(grey(*i))).collect()
            }
            (None, None) => (0..cloud.len()).map(|i| opaque(self.shaded(i))).collect(),
        }
    }

    /// The one colour, lighter towards a light that stands over the viewer's shoulder in the iso view.
    fn shaded(&self, index: usize) -> Rgb {
        let Some(normal) = self.cloud.normal(index) else { return scan::POINTS };
        let facing = normal.dot(&Vector3::new(0.2, -0.6, 0.77)) as f32;
        let share = 0.5 - 0.5 * facing.clamp(-1.0, 1.0);
        mixed(scan::POINTS, [52, 56, 64], if share.is_nan() { 0.0 } else { 0.85 * share })
    }
}

fn opaque([r, g, b]: Rgb) -> [u8; 4] {
    [r, g, b, 255]
}

/// The intensities that become the darkest and the brightest grey: all but a hundredth at each end, since single glints
/// would make the rest black.
fn grey_ends(intensities: &[f32]) -> [f32; 2] {
    let step = intensities.len().div_ceil(INTENSITIES).max(1);
    let mut some: Vec<f32> = intensities.iter().step_by(step).copied().filter(|i| i.is_finite()).collect();
    some.sort_by(f32::total_cmp);
    let at = |share: f64| some.get((share * some.len().saturating_sub(1) as f64).round() as usize).copied();
    let (Some(low), Some(high)) = (at(0.01), at(0.99)) else { return [0.0, 1.0] };
    if high > low { [low, high] } else { [low - 1.0, low] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Point3;

    fn cloud() -> Cloud {
        Cloud::of_points(&[[1e6, 0.0, 0.0], [1e6 + 4.0, 0.0, 0.0], [1e6, 8.0, 1.0]].map(Point3::from))
    }

    fn colors(cloud: Cloud, look: ScanLook<'_>) -> Vec<[u8; 4]> {
        ScanPicture::new(Arc::new(cloud), 1).item(look, &Isometry3::identity()).colors.to_vec()
    }

    #[test]
    fn points_stand_where_they_were_measured_in_the_scene() {
        let cloud = cloud();
        let place = Isometry3::new(Vector3::new(-1e6, 5.0, 0.0), Vector3::z() * std::f64::consts::FRAC_PI_2);
        let picture = ScanPicture::new(Arc::new(cloud.clone()), 7);
        let item = picture.item(ScanLook::Plain, &place);
        for (offset, point) in item.places.places().iter().zip(cloud.points()) {
            let shown = item.scene_from_item * Point3::from(offset.map(f64::from));
            assert!((shown - place * point).norm() < 1e-5);
        }
        let bounds = picture.bounds(&place).expect("it has points");
        assert!(cloud.points().all(|p| (place * p) >= bounds.min && (place * p) <= bounds.max));
        assert!((bounds.max - bounds.min - Vector3::new(8.0, 4.0, 1.0)).norm() < 1e-5);
    }

    #[test]
    fn own_colours_go_before_intensities_and_those_before_one_colour() {
        let opaque_of = |rgb: [u8; 3]| [rgb[0], rgb[1], rgb[2], 255];
        assert_eq!(colors(cloud(), ScanLook::Own), [opaque_of(scan::POINTS); 3]);
        let bright = Cloud { intensities: Some(vec![900.0, f32::NAN, 100.0]), ..cloud() };
        assert_eq!(colors(bright.clone(), ScanLook::Own), [GREYS[1], GREYS[0], GREYS[0]].map(opaque_of));
        let coloured = Cloud { colours: Some(vec![[1, 2, 3], [4, 5, 6], [7, 8, 9]]), ..bright };
        assert_eq!(colors(coloured, ScanLook::Own), [[1, 2, 3, 255], [4, 5, 6, 255], [7, 8, 9, 255]]);
    }

    #[test]
    fn a_glint_does_not_make_the_rest_black() {
        let mut intensities: Vec<f32> = (0..1000).map(|i| 100.0 + i as f32 * 0.1).collect();
        intensities[500] = 1e9;
        let [low, high] = grey_ends(&intensities);
        assert!((100.0..102.0).contains(&low) && (198.0..200.0).contains(&high), "{low} {high}");
        assert_eq!(grey_ends(&[5.0; 9]), [4.0, 5.0], "all alike are bright");
        assert_eq!(grey_ends(&[f32::NAN]), [0.0, 1.0]);
    }

    #[test]
    fn what_is_dropped_warns_or_is_not_seen() {
        let kept = [true, false];
        let look = |shows_dropped| ScanLook::Cleaned { kept: &kept, shows_dropped };
        let [r, g, b] = scan::DROPPED;
        assert_eq!(colors(cloud(), look(true))[1], [r, g, b, 255]);
        let hidden = colors(cloud(), look(false));
        assert_eq!((hidden[1][3], hidden[0][3]), (0, 255));
        assert_eq!(hidden[2], hidden[0], "of what nothing is said, it is kept");
    }

    #[test]
    fn normals_shade_the_one_colour() {
        let up = Cloud { normals: Some(vec![[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [f32::NAN; 3]]), ..cloud() };
        let shown = colors(up, ScanLook::Plain);
        assert!(shown[0][0] > shown[1][0] + 60);
        assert_eq!(shown[2][..3], scan::POINTS);
    }

    #[test]
    fn deviating_points_are_lifted_by_the_deepest_but_not_through_walls() {
        let scale = DeviationScale::new(0.2, 0.05);
        let lift_mm = |deviation_mm: &[f32]| {
            let picture = ScanPicture::new(Arc::new(cloud()), 1);
            picture.item(ScanLook::Deviation { deviation_mm, scale }, &Isometry3::identity()).lift_mm
        };
        assert_eq!(lift_mm(&[0.1, -0.125, f32::NAN]), 0.125);
        assert_eq!(lift_mm(&[0.1]), 0.0);
        // The cloud's diagonal is 9 mm.
        assert!((lift_mm(&[-50.0]) - 0.18).abs() < 1e-6);
        let shown = colors(cloud(), ScanLook::Deviation { deviation_mm: &[0.0, f32::NAN], scale });
        assert_eq!(
            shown.iter().map(|c| [c[0], c[1], c[2]]).collect::<Vec<_>>(),
            [scan::WITHIN, scan::NOT_SCANNED, scan::NOT_SCANNED]
        );
    }
}
