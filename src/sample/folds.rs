//! A folded sheet without thickness: hundreds of narrow faces between two wide ones, as meshes have that shatter.

use super::shell::Triangles;

/// A sheet 20 mm wide along y: a flat face of 20 mm, then `count` narrow faces of `width_mm`, each 30° from the horizontal,
/// up and down in turns, then a flat face again. 2·count + 4 facets, count + 2 faces.
pub fn folded_sheet(count: usize, width_mm: f64) -> Triangles {
    let mut line = vec![[0.0, 0.0], [20.0, 0.0]];
    let (mut x, mut z) = (20.0, 0.0);
    for fold in 0..count {
        x += width_mm * libm::sqrt(0.75);
        z += if fold % 2 == 0 { 0.5 } else { -0.5 } * width_mm;
        line.push([x, z]);
    }
    line.push([x + 20.0, z]);
    line.windows(2)
        .flat_map(|w| {
            let p = |i: usize, y: f64| [w[i][0], y, w[i][1]];
            [[p(0, 0.0), p(1, 0.0), p(1, 20.0)], [p(0, 0.0), p(1, 20.0), p(0, 20.0)]]
        })
        .collect()
}
