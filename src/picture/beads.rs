//! The section of beads side by side, layer on layer, as polylines for a drawing: across the passes to the
//! right, away from the ground upwards, mm.

use crate::process::bead::Bead;

/// Chords of one bead's arc.
const STEPS: usize = 32;

/// The lines of the drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BeadSection {
    /// The ground, as wide as the beads.
    pub ground: Vec<[f64; 2]>,
    /// The arc of each bead, those of the lowest layer first.
    pub arcs: Vec<Vec<[f64; 2]>>,
    /// What stands above it all: the outline of the highest layer.
    pub outline: Vec<[f64; 2]>,
    /// Greatest less least height from one centre to the next, mm.
    pub ripple_mm: f64,
}

/// The section of `count` beads in each of `layers`, their centres `spacing_mm` apart. As they are planned, a
/// layer lies on ground that is one bead's height above that of the layer before.
pub fn section(bead: &Bead, count: usize, layers: usize, spacing_mm: f64) -> BeadSection {
    let lifted = |layer: usize, points: Vec<(f64, f64)>, by_mm: f64| -> Vec<[f64; 2]> {
        points.into_iter().map(|(y, z)| [y + by_mm, z + layer as f64 * bead.height_mm()]).collect()
    };
    let arcs = (0..layers)
        .flat_map(|layer| (0..count).map(move |i| (layer, i)))
        .map(|(layer, i)| lifted(layer, bead.profile(1, spacing_mm, STEPS), i as f64 * spacing_mm))
        .collect();
    let outline = match layers.checked_sub(1) {
        Some(top) => lifted(top, bead.profile(count, spacing_mm, STEPS), 0.0),
        None => Vec::new(),
    };
    let (radius_mm, half_mm) = (bead.radius_mm(), 0.5 * bead.width_mm());
    // Higher than half a circle a bead is wider than its foot.
    let reach_mm = if bead.height_mm() > radius_mm { radius_mm } else { half_mm };
    let last_mm = count.saturating_sub(1) as f64 * spacing_mm;
    BeadSection {
        ground: vec![[-reach_mm, 0.0], [last_mm + reach_mm, 0.0]],
        arcs,
        outline,
        ripple_mm: bead.ripple_mm(spacing_mm),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beads_stand_side_by_side_and_on_each_other() {
        let bead = Bead::new(3.0, 0.9).expect("a bead");
        let spacing_mm = bead.spacing_mm();
        let drawn = section(&bead, 4, 2, spacing_mm);
        assert_eq!(drawn.arcs.len(), 8);
        for (k, arc) in drawn.arcs.iter().enumerate() {
            let (layer, i) = (k / 4, k % 4);
            let (first, last) = (arc[0], arc[arc.len() - 1]);
            let centre = i as f64 * spacing_mm;
            assert!((first[0] - centre + 1.5).abs() < 1e-9 && (last[0] - centre - 1.5).abs() < 1e-9);
            let ground = layer as f64 * 0.9;
            assert!((first[1] - ground).abs() < 1e-9);
            let top = arc.iter().map(|p| p[1]).fold(0.0, f64::max);
            assert!((top - ground - 0.9).abs() < 1e-9, "{top}");
        }
        // The valleys of the outline are where neighbours meet.
        let between = |p: &&[f64; 2]| (0.0..=3.0 * spacing_mm).contains(&p[0]);
        let least = drawn.outline.iter().filter(between).map(|p| p[1]).fold(9.0, f64::min);
        assert!((2.0 * 0.9 - least - drawn.ripple_mm).abs() < 1e-9);
        assert!((drawn.ground[1][0] - 3.0 * spacing_mm - 1.5).abs() < 1e-9);
    }

    #[test]
    fn nothing_is_drawn_of_nothing() {
        let bead = Bead::new(1.0, 1.0).expect("a bead");
        assert!(section(&bead, 0, 1, 1.0).arcs.is_empty() && section(&bead, 3, 0, 1.0).outline.is_empty());
        assert_eq!(section(&bead, 1, 1, 1.0).ground, [[-0.625, 0.0], [0.625, 0.0]]);
    }
}
