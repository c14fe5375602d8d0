//! How far what was scanned lies off the model, in colours: of the points, of the model, and of the legend. Orange and
//! red where material is missing, blue where there is too much, pale green within the tolerance, grey where nothing is
//! known. The outlines of patches are in `patches`, the rest of a scan's looks in `scan`.

use super::colormap::along;
use super::legend::{Legend, LegendEntry, Quantity};
use super::palette::{Rgb, scan};
use crate::part::{Hasher, Mesh};
use crate::view::MeshItem;
use nalgebra::{Isometry3, Point3};
use std::sync::Arc;

/// Share of the limit by which a legend reaches beyond it on each side, to show the colours there.
const BEYOND: f64 = 0.12;
/// Marks of a legend that are closer than this share of it would be printed over each other.
const MARKS_APART: f64 = 0.07;
/// Least limit, mm: a scale has two ends.
const LEAST_LIMIT_MM: f64 = 1e-6;

/// The scale of the colours, the same to both sides of nought: equal colours are equal distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeviationScale {
    limit_mm: f64,
    tolerance_mm: f64,
}

impl DeviationScale {
    /// A scale that ends at ± the limit and does not tell apart what is within ± the tolerance. A limit that is no number
    /// or none above 0 becomes the least one; the tolerance is kept within the limit.
    pub fn new(limit_mm: f64, tolerance_mm: f64) -> DeviationScale {
        let limit_mm = if limit_mm.is_finite() { limit_mm.max(LEAST_LIMIT_MM) } else { LEAST_LIMIT_MM };
        // Of a number and none, `max` takes the number.
        DeviationScale { limit_mm, tolerance_mm: tolerance_mm.max(0.0).min(limit_mm) }
    }

    /// The scale on which patches from a depth on are told apart and the farthest one ends it, mm; rounded up to
    /// hundredths, so that the numbers on it are short.
    pub fn of_patches(min_depth_mm: f64, tolerance_mm: f64, farthest_mm: f64) -> DeviationScale {
        let limit_mm = (farthest_mm.max(2.0 * min_depth_mm) * 100.0 - 1e-9).ceil() * 0.01;
        DeviationScale::new(limit_mm, tolerance_mm.min(min_depth_mm))
    }

    /// Where the scale ends, mm.
    pub fn limit_mm(&self) -> f64 {
        self.limit_mm
    }

    /// What counts as the model, mm.
    pub fn tolerance_mm(&self) -> f64 {
        self.tolerance_mm
    }

    /// Colour of a signed distance from the model, outside above 0; NaN is grey.
    pub fn color(&self, deviation_mm: f64) -> Rgb {
        let off_mm = deviation_mm.abs();
        let (ramp, beyond) = match deviation_mm < 0.0 {
            true => (&scan::MISSING, scan::MORE_MISSING),
            false => (&scan::SURPLUS, scan::MORE_SURPLUS),
        };
        if off_mm.is_nan() {
            scan::NOT_SCANNED
        } else if off_mm <= self.tolerance_mm {
            scan::WITHIN
        } else if off_mm > self.limit_mm {
            beyond
        } else {
            along(ramp, (off_mm - self.tolerance_mm) / (self.limit_mm - self.tolerance_mm))
        }
    }

    /// The legend: the scale a little beyond its limits, marked at limits, tolerance and nought.
    pub fn legend(&self) -> Legend {
        let (limit, tolerance) = (self.limit_mm, self.tolerance_mm);
        let end = limit * (1.0 + BEYOND);
        let mut marks: Vec<f64> = Vec::new();
        // The worthiest first.
        for mark in [-limit, limit, -tolerance, tolerance, 0.0] {
            if marks.iter().all(|m| (m - mark).abs() >= MARKS_APART * 2.0 * end) {
                marks.push(mark);
            }
        }
        marks.sort_by(f64::total_cmp);
        let entries = vec![
            (LegendEntry::Surplus, scan::SURPLUS[1]),
            (LegendEntry::Within, scan::WITHIN),
            (LegendEntry::Missing, scan::MISSING[1]),
            (LegendEntry::NotScanned, scan::NOT_SCANNED),
        ];
        let entries =
            entries.into_iter().filter(|(entry, _)| *entry != LegendEntry::Within || tolerance > 0.0).collect();
        let decimals = decimals(&marks);
        Legend { marks, decimals, entries, ..Legend::new(Quantity::Deviation, [-end, end], |mm| self.color(mm)) }
    }
}

/// Digits behind the point that tell all marks exactly; four at most, a tenth of a micrometre.
fn decimals(marks: &[f64]) -> usize {
    let exact = |digits: &usize| {
        let unit = [1.0, 10.0, 100.0, 1e3, 1e4][*digits];
        marks.iter().all(|m| (m * unit - (m * unit).round()).abs() < 1e-6)
    };
    (1..4).find(exact).unwrap_or(4)
}

/// Depths over a finer piece of the model, as [`model_item`] shows it. Depths are above 0 where material is missing.
#[derive(Clone, Copy, Debug)]
pub struct DepthMesh<'a> {
    /// Places of the vertices, part frame, mm.
    pub vertices: &'a [Point3<f64>],
    /// Vertices of each triangle, wound like the facet that it is a piece of.
    pub triangles: &'a [[u32; 3]],
    /// The facet of the part that each triangle is a piece of; a facet that is named is covered by its triangles.
    pub parent: &'a [u32],
    /// Depth at each vertex, mm; NaN where nothing was scanned.
    pub depth_mm: &'a [f64],
}

/// The model in the colours of what is missing or too much: the finer piece with colours that run from vertex to vertex,
/// and all other facets in the colour of their depth (`facet_depth_mm`, one for each facet of the part; what is not there
/// is grey, as NaN is).
pub fn model_item(mesh: &Mesh, fine: DepthMesh<'_>, facet_depth_mm: &[f64], scale: &DeviationScale) -> MeshItem {
    let color = |depth_mm: f64| {
        let [r, g, b] = scale.color(-depth_mm);
        [r, g, b, 255]
    };
    let f32s = |p: &Point3<f64>| [p.x as f32, p.y as f32, p.z as f32];
    let mut is_fine = vec![false; mesh.facets.len()];
    for parent in fine.parent {
        if let Some(covered) = is_fine.get_mut(*parent as usize) {
            *covered = true;
        }
    }
    let (mut positions, mut colors) = (Vec::new(), Vec::new());
    for facet in (0..mesh.facets.len()).filter(|facet| !is_fine[*facet]) {
        positions.extend(mesh.corners(facet).iter().map(f32s));
        colors.extend([color(facet_depth_mm.get(facet).copied().unwrap_or(f64::NAN)); 3]);
    }
    for triangle in fine.triangles {
        let [Some(a), Some(b), Some(c)] = triangle.map(|v| fine.vertices.get(v as usize)) else { continue };
        positions.extend([a, b, c].map(f32s));
        colors.extend(triangle.map(|v| color(fine.depth_mm.get(v as usize).copied().unwrap_or(f64::NAN))));
    }
    let bits: Vec<u32> = positions.as_flattened().iter().map(|x| x.to_bits()).collect();
    MeshItem {
        geometry_key: Hasher::default().u32s(&bits).finish().0 as u64,
        positions: Arc::new(positions),
        colors_key: Hasher::default().bytes(colors.as_flattened()).finish().0 as u64,
        facet_colors: Arc::new(colors),
        edges: None,
        scene_from_item: Isometry3::identity(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::solids;
    use crate::view::Scene;

    #[test]
    fn colours_follow_limits_and_tolerance() {
        let scale = DeviationScale::new(0.2, 0.05);
        let cases = [
            (f64::NAN, scan::NOT_SCANNED),
            (0.0, scan::WITHIN),
            (-0.05, scan::WITHIN),
            (0.05, scan::WITHIN),
            (-0.125, scan::MISSING[1]),
            (0.125, scan::SURPLUS[1]),
            (-0.2, scan::MISSING[2]),
            (0.2, scan::SURPLUS[2]),
            (-0.2001, scan::MORE_MISSING),
            (f64::INFINITY, scan::MORE_SURPLUS),
        ];
        for (mm, color) in cases {
            assert_eq!(scale.color(mm), color, "{mm}");
        }
    }

    #[test]
    fn the_farthest_patch_ends_the_scale_in_a_short_number() {
        for (min_depth, farthest, limit) in [(0.05, 0.1994, 0.2), (0.05, 0.2, 0.2), (0.05, 0.02, 0.1), (0.1, 0.0, 0.2)]
        {
            let scale = DeviationScale::of_patches(min_depth, 0.1, farthest);
            assert!((scale.limit_mm() - limit).abs() < 1e-12, "{}", scale.limit_mm());
            assert_eq!(scale.tolerance_mm(), min_depth.min(0.1), "patches are told apart");
        }
    }

    #[test]
    fn any_numbers_make_a_scale() {
        for (limit, tolerance) in [(f64::NAN, f64::NAN), (0.0, 0.0), (-1.0, 5.0), (0.2, 0.9), (f64::INFINITY, -1.0)] {
            let scale = DeviationScale::new(limit, tolerance);
            assert!(scale.limit_mm() > 0.0 && (0.0..=scale.limit_mm()).contains(&scale.tolerance_mm()));
            let legend = scale.legend();
            assert!(legend.marks.len() >= 2 && legend.marks.windows(2).all(|w| w[0] < w[1]), "{legend:?}");
        }
        // Without a tolerance there is a colour at either side of nought.
        assert_eq!(DeviationScale::new(1.0, 0.0).color(-1e-12), scan::MISSING[0]);
    }

    #[test]
    fn the_legend_marks_what_has_room_with_the_digits_it_needs() {
        let legend = DeviationScale::new(0.2, 0.05).legend();
        assert_eq!((legend.marks, legend.decimals), (vec![-0.2, -0.05, 0.0, 0.05, 0.2], 2));
        assert_eq!(
            DeviationScale::new(0.5, 0.02).legend().marks,
            [-0.5, -0.02, 0.5],
            "no room for three in the middle"
        );
        let fine = DeviationScale::new(0.1, 0.025).legend();
        assert_eq!((fine.marks.len(), fine.decimals), (5, 3));
        let none = DeviationScale::new(2.0, 0.0).legend();
        assert_eq!((none.marks, none.decimals), (vec![-2.0, 0.0, 2.0], 1));
        assert!(none.entries.iter().all(|(entry, _)| *entry != LegendEntry::Within));
        // Beyond both limits the bar has the colours of what is beyond.
        assert_eq!([legend.bar[0], legend.bar[255]], [scan::MORE_MISSING, scan::MORE_SURPLUS]);
    }

    #[test]
    fn the_model_has_its_facets_once_and_the_finer_piece_in_place_of_its_parents() {
        let raw: Vec<[[f32; 3]; 3]> = solids::cube(2.0).iter().map(|t| t.map(|p| p.map(|x| x as f32))).collect();
        let mesh = Mesh::weld(&raw, 1.0);
        let [a, b, c] = mesh.corners(4);
        let middle = a + (b - a) * 0.5;
        let fine = DepthMesh {
            vertices: &[a, b, c, middle],
            triangles: &[[0, 3, 2], [3, 1, 2], [0, 1, 99]],
            parent: &[4, 4, 4],
            depth_mm: &[0.0, 0.125, f64::NAN, -0.125],
        };
        let scale = DeviationScale::new(0.2, 0.05);
        let item = model_item(&mesh, fine, &[0.0; 3], &scale);
        assert_eq!(item.facet_count(), 11 + 2, "a triangle without a vertex is left out");
        assert_eq!(item.facet_colors.len(), 3 * 13);
        let area = |p: &[[f32; 3]]| {
            let [a, b, c] = [p[0], p[1], p[2]].map(|p| Point3::from(p.map(f64::from)));
            (b - a).cross(&(c - a)).norm() / 2.0
        };
        assert!((item.positions.chunks(3).map(area).sum::<f64>() - 24.0).abs() < 1e-6);
        let rgb: Vec<Rgb> = item.facet_colors.iter().map(|c| [c[0], c[1], c[2]]).collect();
        assert_eq!(rgb[..3], [scan::WITHIN; 3]);
        assert_eq!(rgb[9..12], [scan::NOT_SCANNED; 3], "nothing is said of that facet");
        let [within, missing, grey, surplus] = [scan::WITHIN, scan::MISSING[1], scan::NOT_SCANNED, scan::SURPLUS[1]];
        assert_eq!(rgb[33..], [within, surplus, grey, surplus, missing, grey]);
    }

    /// Linear light of an sRGB colour.
    fn linear(c: Rgb) -> [f64; 3] {
        c.map(|c| f64::from(c) / 255.0)
            .map(|c| if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) })
    }

    fn times(m: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
        m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    /// What each kind of eye sees (Machado, Oliveira, Fernandes 2009, severity 1): normal, without red, green, blue cones.
    const EYES: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    ];

    /// Distance in OKLab (Ottosson 2020), hundredths.
    fn apart(a: Rgb, b: Rgb, eye: &[[f64; 3]; 3]) -> f64 {
        const CONES: [[f64; 3]; 3] = [
            [0.4122214708, 0.5363325363, 0.0514459929],
            [0.2119034982, 0.6806995451, 0.1073969566],
            [0.0883024619, 0.2817188376, 0.6299787005],
        ];
        const LAB: [[f64; 3]; 3] = [
            [0.2104542553, 0.7936177850, -0.0040720468],
            [1.9779984951, -2.4285922050, 0.4505937099],
            [0.0259040371, 0.7827717662, -0.8086757660],
        ];
        let lab = |c: Rgb| times(&LAB, times(&CONES, times(eye, linear(c)).map(|x| x.clamp(0.0, 1.0))).map(libm::cbrt));
        let (a, b) = (lab(a), lab(b));
        100.0 * (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f64>().sqrt()
    }

    #[test]
    fn no_eye_takes_one_meaning_for_another() {
        let scale = DeviationScale::new(1.0, 0.1);
        let side = |sign: f64| (11..=110).map(|i| scale.color(sign * 0.01 * f64::from(i))).collect::<Vec<_>>();
        let meanings = [side(-1.0), side(1.0), vec![scan::WITHIN], vec![scan::NOT_SCANNED]];
        for (k, one) in meanings.iter().enumerate() {
            for other in &meanings[k + 1..] {
                for (a, b) in one.iter().flat_map(|a| other.iter().map(move |b| (*a, *b))) {
                    for eye in &EYES {
                        assert!(apart(a, b, eye) > 8.0, "{a:?} {b:?}: {}", apart(a, b, eye));
                    }
                }
            }
        }
    }

    #[test]
    fn every_colour_stands_out_from_the_dark_view() {
        // Contrast as WCAG 2 has it, against the middle of the background.
        let luminance = |c: Rgb| times(&[[0.2126, 0.7152, 0.0722]; 3], linear(c))[0];
        let Scene { background_top, background_bottom, .. } = Scene::default();
        let ground = luminance(super::super::palette::mixed(background_top, background_bottom, 0.5));
        let colors = [scan::MISSING, scan::SURPLUS].concat();
        for color in [scan::MORE_MISSING, scan::MORE_SURPLUS, scan::WITHIN, scan::NOT_SCANNED, scan::DROPPED]
            .into_iter()
            .chain(colors)
        {
            let contrast = (luminance(color) + 0.05) / (ground + 0.05);
            assert!(contrast > 2.5, "{color:?}: {contrast}");
        }
    }
}
