//! The legend of a scale, painted into a picture: a bar with its marks, and colours beside it. Dots
//! instead of a font, and English, so that the picture is the same everywhere.

use crate::picture::{Legend, Quantity};
use crate::text::{Language, legend_entry, legend_mark};
use image::{Rgba, RgbaImage};

/// Five columns of seven dots, the lowest bit on top.
const GLYPHS: [(char, [u8; 5]); 34] = [
    ('0', [0x3e, 0x51, 0x49, 0x45, 0x3e]),
    ('1', [0x00, 0x42, 0x7f, 0x40, 0x00]),
    ('2', [0x42, 0x61, 0x51, 0x49, 0x46]),
    ('3', [0x21, 0x41, 0x45, 0x4b, 0x31]),
    ('4', [0x18, 0x14, 0x12, 0x7f, 0x10]),
    ('5', [0x27, 0x45, 0x45, 0x45, 0x39]),
    ('6', [0x3c, 0x4a, 0x49, 0x49, 0x30]),
    ('7', [0x01, 0x71, 0x09, 0x05, 0x03]),
    ('8', [0x36, 0x49, 0x49, 0x49, 0x36]),
    ('9', [0x06, 0x49, 0x49, 0x29, 0x1e]),
    ('.', [0x00, 0x60, 0x60, 0x00, 0x00]),
    ('/', [0x20, 0x10, 0x08, 0x04, 0x02]),
    ('+', [0x08, 0x08, 0x3e, 0x08, 0x08]),
    ('-', [0x08, 0x08, 0x08, 0x08, 0x08]),
    ('J', [0x20, 0x40, 0x41, 0x3f, 0x01]),
    ('a', [0x20, 0x54, 0x54, 0x54, 0x78]),
    ('c', [0x38, 0x44, 0x44, 0x44, 0x20]),
    ('d', [0x38, 0x44, 0x44, 0x48, 0x7f]),
    ('e', [0x38, 0x54, 0x54, 0x54, 0x18]),
    ('g', [0x08, 0x54, 0x54, 0x54, 0x3c]),
    ('h', [0x7f, 0x08, 0x04, 0x04, 0x78]),
    ('i', [0x00, 0x44, 0x7d, 0x40, 0x00]),
    ('l', [0x00, 0x41, 0x7f, 0x40, 0x00]),
    ('m', [0x7c, 0x04, 0x18, 0x04, 0x78]),
    ('n', [0x7c, 0x08, 0x04, 0x04, 0x78]),
    ('o', [0x38, 0x44, 0x44, 0x44, 0x38]),
    ('p', [0x7c, 0x14, 0x14, 0x14, 0x08]),
    ('r', [0x7c, 0x08, 0x04, 0x04, 0x08]),
    ('s', [0x48, 0x54, 0x54, 0x54, 0x20]),
    ('t', [0x04, 0x3f, 0x44, 0x40, 0x20]),
    ('u', [0x3c, 0x40, 0x40, 0x20, 0x7c]),
    ('v', [0x1c, 0x20, 0x40, 0x20, 0x1c]),
    ('w', [0x3c, 0x40, 0x30, 0x40, 0x3c]),
    (' ', [0; 5]),
];

const INK: Rgba<u8> = Rgba([232, 234, 238, 255]);
/// Height of a line of text, in dots.
const LINE: u32 = 12;

/// Paints a legend along the right edge; a picture too small for it stays as it is.
pub fn paint(image: &mut RgbaImage, legend: &Legend) {
    // So many pixels a dot.
    let dot = (image.height() / 400).clamp(1, 6);
    let (width, bar, height) = (84 * dot, 12 * dot, 150 * dot);
    let rows = legend.entries.len() as u32 + 2;
    if image.width() < 3 * width || image.height() < height + (rows + 2) * LINE * dot {
        return;
    }
    let (left, top) = (image.width() - width, 2 * LINE * dot);
    write(image, [left, top], dot, unit(legend.quantity));
    let top = top + LINE * dot;
    for y in 0..height {
        let [r, g, b] = legend.color(1.0 - f64::from(y) / f64::from(height));
        fill(image, [left, top + y], [bar, 1], Rgba([r, g, b, 255]));
    }
    let [low, high] = legend.range;
    for mark in &legend.marks {
        let y = top + (f64::from(height) * (high - mark) / (high - low)) as u32;
        fill(image, [left + bar, y], [3 * dot, dot], INK);
        write(image, [left + bar + 5 * dot, y.saturating_sub(3 * dot)], dot, &legend_mark(legend, *mark));
    }
    for (row, (entry, [r, g, b])) in legend.entries.iter().enumerate() {
        let y = top + height + (row as u32 + 1) * LINE * dot;
        fill(image, [left, y], [bar, 8 * dot], Rgba([*r, *g, *b, 255]));
        write(image, [left + bar + 5 * dot, y], dot, &legend_entry(*entry, Language::english()));
    }
}

/// The unit of the numbers, in letters that have a glyph.
fn unit(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Dose => "J/cm2",
        Quantity::Incidence => "deg",
        Quantity::Deviation => "mm",
    }
}

fn fill(image: &mut RgbaImage, [x, y]: [u32; 2], [w, h]: [u32; 2], color: Rgba<u8>) {
    for j in y..(y + h).min(image.height()) {
        for i in x..(x + w).min(image.width()) {
            image.put_pixel(i, j, color);
        }
    }
}

fn write(image: &mut RgbaImage, [mut x, y]: [u32; 2], dot: u32, text: &str) {
    for c in text.chars() {
        let columns = GLYPHS.iter().find(|g| g.0 == c).map_or([0; 5], |g| g.1);
        for (i, column) in columns.into_iter().enumerate() {
            for j in (0..7).filter(|j| column >> j & 1 == 1) {
                fill(image, [x + i as u32 * dot, y + j * dot], [dot, dot], INK);
            }
        }
        x += 6 * dot;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{DeviationScale, LegendEntry};

    fn dose() -> Legend {
        Legend {
            marks: vec![0.0, 16_667.0, 66_667.0],
            entries: vec![(LegendEntry::Over, [226, 58, 38]), (LegendEntry::NoLight, [120, 122, 126])],
            ..Legend::new(Quantity::Dose, [0.0, 66_667.0], |dose| [(dose / 400.0) as u8; 3])
        }
    }

    #[test]
    fn it_stays_inside_and_keeps_out_of_small_pictures() {
        let blank = |w, h| RgbaImage::from_pixel(w, h, Rgba([1, 2, 3, 255]));
        for legend in [dose(), DeviationScale::new(0.25, 0.05).legend()] {
            let mut small = blank(200, 100);
            paint(&mut small, &legend);
            assert_eq!(small, blank(200, 100));
            let mut large = blank(1280, 800);
            paint(&mut large, &legend);
            let touched: Vec<u32> =
                large.enumerate_pixels().filter(|(.., p)| p.0 != [1, 2, 3, 255]).map(|(x, ..)| x).collect();
            assert!(touched.iter().all(|x| *x > 1100) && touched.len() > 5000);
            for [r, g, b] in legend.entries.iter().map(|e| e.1).chain([legend.bar[0], legend.bar[255]]) {
                assert!(large.pixels().any(|p| p.0 == [r, g, b, 255]), "{r} {g} {b}");
            }
            assert!(large.get_pixel(1279, 400).0 == [1, 2, 3, 255], "letters are not cut off");
        }
    }

    #[test]
    fn every_letter_has_a_glyph() {
        use LegendEntry::{Missing, NoLight, NotScanned, Over, Shaded, Surplus, Under, Within};
        let entries = [Over, Under, Shaded, NoLight, Surplus, Within, Missing, NotScanned];
        let words = entries.map(|e| legend_entry(e, Language::english()));
        let units = [Quantity::Dose, Quantity::Incidence, Quantity::Deviation].map(|q| unit(q).to_owned());
        let scale = DeviationScale::new(0.25, 0.05).legend();
        let marks = scale.marks.iter().map(|m| legend_mark(&scale, *m));
        let said: String = words.into_iter().chain(units).chain(marks).collect();
        assert!(said.chars().all(|c| GLYPHS.iter().any(|g| g.0 == c)), "{said}");
    }
}
