//! Connected areas of a mask, eight neighbours to a pixel, the one with the greatest area × contrast first.

use crate::part::union_find::UnionFind;
use crate::weld::raster::{GreyImage, Mask, Raster};

/// Pixels count as squares when their spread is summed up: variance of one along each axis.
const PIXEL_VARIANCE: f64 = 1.0 / 12.0;

/// A connected area.
#[derive(Clone, Debug, PartialEq)]
pub struct DefectArea {
    /// Number of its pixels.
    pub pixels: usize,
    /// Levels above the threshold, summed over its pixels: area × mean contrast. What lies below it counts nothing.
    pub contrast_sum: f64,
    /// Its first column and row, and its last ones, pixels.
    pub box_px: [[usize; 2]; 2],
    /// Its middle, u and v, pixels.
    pub centroid_px: [f64; 2],
    /// Length by width of the ellipse with the same second moments; 1 or more.
    pub aspect: f64,
    /// Whether it touches the image's border: the rest of it may not be seen.
    pub is_cut_off: bool,
}

/// Areas, and whose each pixel is.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AreaMap {
    /// The areas, by area × contrast.
    pub list: Vec<DefectArea>,
    /// Of each pixel the number of its area, from 1; 0: of none.
    pub labels: Raster<u32>,
}

impl AreaMap {
    /// The pixels of the areas at these places of the list, from 0.
    pub fn mask(&self, chosen: &[usize]) -> Mask {
        let mut is_chosen = vec![false; self.list.len() + 1];
        for place in chosen {
            if let Some(flag) = is_chosen.get_mut(place.saturating_add(1)) {
                *flag = true;
            }
        }
        self.labels.map(|label| is_chosen.get(*label as usize) == Some(&true))
    }

    /// The pixels of all areas.
    pub fn mask_of_all(&self) -> Mask {
        self.labels.map(|label| *label != 0)
    }

    /// The place in the list of the area that a pixel belongs to.
    pub fn at(&self, u: usize, v: usize) -> Option<usize> {
        self.labels.at(u, v).and_then(|label| (*label as usize).checked_sub(1))
    }
}

/// Pixels of a row that lie side by side.
struct Run {
    row: usize,
    /// First pixel, and the one after the last.
    first: usize,
    end: usize,
}

/// What is summed up over an area.
#[derive(Clone)]
struct Sums {
    pixels: usize,
    contrast: f64,
    box_px: [[usize; 2]; 2],
    /// Of u, v, u², uv, v².
    moments: [f64; 5],
}

/// The areas of a mask that have at least so many pixels; contrast is what the image has above the threshold.
pub fn areas(mask: &Mask, image: &GreyImage, threshold: f64, least_px: usize) -> AreaMap {
    let runs = runs(mask);
    let mut sets = joined(&runs);
    let mut sums: Vec<Option<Sums>> = vec![None; runs.len()];
    let roots: Vec<usize> = (0..runs.len()).map(|i| sets.root(i as u32) as usize).collect();
    for (run, root) in runs.iter().zip(&roots) {
        if let Some(sum) = sums.get_mut(*root) {
            let of = sum.get_or_insert_with(|| Sums {
                pixels: 0,
                contrast: 0.0,
                box_px: [[run.first, run.row], [run.first, run.row]],
                moments: [0.0; 5],
            });
            of.add(run, image, threshold);
        }
    }
    let large = |(root, sum): (usize, Option<Sums>)| sum.filter(|s| s.pixels >= least_px).map(|s| (root, s));
    let mut found: Vec<(usize, Sums)> = sums.into_iter().enumerate().filter_map(large).collect();
    found.sort_by(|(a, x), (b, y)| y.contrast.total_cmp(&x.contrast).then(a.cmp(b)));
    let mut label_of = vec![0u32; runs.len()];
    for (label, (root, _)) in (1..).zip(&found) {
        if let Some(own) = label_of.get_mut(*root) {
            *own = label;
        }
    }
    let mut labels = Raster::filled(mask.width, mask.height, 0u32);
    for (run, root) in runs.iter().zip(&roots) {
        let label = label_of.get(*root).copied().unwrap_or_default();
        let row = run.row * mask.width;
        if let Some(pixels) = labels.values.get_mut(row + run.first..row + run.end) {
            pixels.fill(label);
        }
    }
    let size = [mask.width, mask.height];
    AreaMap { list: found.iter().map(|(_, sums)| sums.area(size)).collect(), labels }
}

impl Sums {
    fn add(&mut self, run: &Run, image: &GreyImage, threshold: f64) {
        let (v, count) = (run.row as f64, (run.end - run.first) as f64);
        self.pixels += run.end - run.first;
        let levels = image.row(run.row).get(run.first..run.end).unwrap_or_default();
        self.contrast += levels.iter().map(|x| (f64::from(*x) - threshold).max(0.0)).sum::<f64>();
        let [first, last] = &mut self.box_px;
        *first = [first[0].min(run.first), first[1].min(run.row)];
        *last = [last[0].max(run.end - 1), last[1].max(run.row)];
        let middle = 0.5 * (run.first + run.end - 1) as f64;
        let squares = count * (middle * middle + (count * count - 1.0) / 12.0);
        let terms = [count * middle, count * v, squares, count * middle * v, count * v * v];
        self.moments.iter_mut().zip(terms).for_each(|(m, t)| *m += t);
    }

    fn area(&self, [width, height]: [usize; 2]) -> DefectArea {
        let [u, v, uu, uv, vv] = self.moments.map(|m| m / self.pixels as f64);
        let [xx, xy, yy] = [uu - u * u + PIXEL_VARIANCE, uv - u * v, vv - v * v + PIXEL_VARIANCE];
        let (mean, apart) = (0.5 * (xx + yy), (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt());
        let [first, last] = self.box_px;
        let is_cut_off = first.contains(&0) || last[0] + 1 >= width || last[1] + 1 >= height;
        DefectArea {
            pixels: self.pixels,
            contrast_sum: self.contrast,
            box_px: self.box_px,
            centroid_px: [u, v],
            aspect: ((mean + apart) / (mean - apart).max(PIXEL_VARIANCE)).sqrt(),
            is_cut_off,
        }
    }
}

fn runs(mask: &Mask) -> Vec<Run> {
    let mut runs = Vec::new();
    for row in 0..mask.height {
        let values = mask.row(row);
        let mut first = 0;
        while let Some(ahead) = values.get(first..).and_then(|rest| rest.iter().position(|m| *m)) {
            let start = first + ahead;
            let length = values[start..].iter().position(|m| !m).unwrap_or(values.len() - start);
            runs.push(Run { row, first: start, end: start + length });
            first = start + length;
        }
    }
    runs
}

/// Runs of neighbouring rows that touch, corners included.
fn joined(runs: &[Run]) -> UnionFind {
    let mut sets = UnionFind::new(runs.len());
    let mut above = 0;
    for (i, run) in runs.iter().enumerate() {
        // Runs above that end before this one begins touch none of those to come.
        while runs[above].row + 1 < run.row || (runs[above].row + 1 == run.row && runs[above].end < run.first) {
            above += 1;
        }
        let touching = (above..i).take_while(|j| runs[*j].row + 1 == run.row && runs[*j].first <= run.end);
        touching.for_each(|j| sets.join(i as u32, j as u32));
    }
    sets
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::FixedNumbers;

    fn drawn(rows: &[&str]) -> Mask {
        let values: Vec<bool> = rows.iter().flat_map(|r| r.bytes().map(|b| b == b'#')).collect();
        Raster::new(rows[0].len(), rows.len(), values).expect("rows of one length")
    }

    #[test]
    fn corners_connect_and_contrast_orders() {
        let mask = drawn(&["..........", ".##....#..", "...##...#.", ".......#..", ".....#....", ".........."]);
        let level = |([u, _], _): ([usize; 2], &bool)| if u > 6 { 90.0 } else { 30.0 };
        let image = Raster { width: 10, height: 6, values: mask.pixels().map(level).collect() };
        let map = areas(&mask, &image, 20.0, 2);
        let at_border = areas(&drawn(&["..#", "#.."]), &GreyImage::filled(3, 2, 1.0), 0.0, 1);
        assert!(at_border.list.len() == 2 && at_border.list.iter().all(|a| a.is_cut_off));
        let told: Vec<_> = map.list.iter().map(|a| (a.pixels, a.contrast_sum, a.box_px, a.is_cut_off)).collect();
        assert_eq!(told, [(3, 210.0, [[7, 1], [8, 3]], false), (4, 40.0, [[1, 1], [4, 2]], false)]);
        assert_eq!((map.at(1, 1), map.at(5, 4), map.at(7, 3)), (Some(1), None, Some(0)));
        assert_eq!((map.mask(&[1]).count(), map.mask(&[0, 1, 7]), map.mask(&[]).count()), (4, map.mask_of_all(), 0));
    }

    /// Labels by flooding from pixel to pixel part the image as the runs do.
    #[test]
    fn areas_are_those_of_flooding() {
        for seed in 0..20 {
            let mut numbers = FixedNumbers::new(seed);
            let mask = Raster { width: 31, height: 17, values: (0..527).map(|_| numbers.share() < 0.4).collect() };
            let map = areas(&mask, &GreyImage::filled(31, 17, 1.0), 0.0, 1);
            let mut flooded = vec![0usize; 527];
            let mut count = 0;
            for start in 0..527 {
                if !mask.values[start] || flooded[start] != 0 {
                    continue;
                }
                count += 1;
                let mut stack = vec![start];
                while let Some(i) = stack.pop() {
                    if std::mem::replace(&mut flooded[i], count) == count {
                        continue;
                    }
                    let near =
                        mask.pixels().filter(|([u, v], m)| **m && u.abs_diff(i % 31) < 2 && v.abs_diff(i / 31) < 2);
                    stack.extend(near.map(|([u, v], _)| v * 31 + u).filter(|j| flooded[*j] == 0));
                }
            }
            assert_eq!(map.list.len(), count);
            for (i, j) in (0..527).flat_map(|i| [(i, (i * 7 + 3) % 527), (i, (i + 1) % 527)]) {
                let same = map.labels.values[i] == map.labels.values[j];
                assert_eq!(same, flooded[i] == flooded[j], "{seed}: {i} {j}");
            }
        }
    }

    #[test]
    fn an_ellipse_has_its_middle_and_its_aspect() {
        let inside = |u: f64, v: f64| {
            let (x, y) = (u - 60.0, v - 50.0);
            let (a, b) = (0.8 * x + 0.6 * y, -0.6 * x + 0.8 * y);
            (a / 40.0) * (a / 40.0) + (b / 20.0) * (b / 20.0) < 1.0
        };
        let values = (0..12_000).map(|i| inside((i % 120) as f64, (i / 120) as f64)).collect();
        let map = areas(&Raster { width: 120, height: 100, values }, &GreyImage::filled(120, 100, 1.0), 0.0, 1);
        let [area] = &map.list[..] else { panic!("{:?}", map.list) };
        assert!((area.aspect - 2.0).abs() < 0.01, "{}", area.aspect);
        assert!((area.centroid_px[0] - 60.0).abs() < 1e-9 && (area.centroid_px[1] - 50.0).abs() < 1e-9);
    }
}
