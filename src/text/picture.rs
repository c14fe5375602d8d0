//! Words of the scales in pictures.

use super::messages::{
    legend_missing, legend_no_light, legend_not_scanned, legend_over, legend_shaded, legend_surplus, legend_under,
    legend_within,
};
use super::{Language, Message as _, fixed, say};
use crate::picture::spacing::SpacingScale;
use crate::picture::{Legend, LegendEntry, Quantity};

/// What a colour beside a scale stands for.
pub(crate) fn legend_entry(entry: LegendEntry, language: Language) -> String {
    match entry {
        LegendEntry::Over => legend_over {}.text_in(language),
        LegendEntry::Under => legend_under {}.text_in(language),
        LegendEntry::Shaded => legend_shaded {}.text_in(language),
        LegendEntry::NoLight => legend_no_light {}.text_in(language),
        LegendEntry::Surplus => legend_surplus {}.text_in(language),
        LegendEntry::Within => legend_within {}.text_in(language),
        LegendEntry::Missing => legend_missing {}.text_in(language),
        LegendEntry::NotScanned => legend_not_scanned {}.text_in(language),
    }
}

/// A number on a scale, without its unit. What may lie on either side of nought has its sign.
pub(crate) fn legend_mark(legend: &Legend, mark: f64) -> String {
    let told = fixed(mark, legend.decimals);
    if legend.quantity == Quantity::Deviation && mark > 0.0 { format!("+{told}") } else { told }
}

/// The ends and the middle of the scale of the spacing.
pub(crate) fn spacing_labels(scale: &SpacingScale) -> [String; 3] {
    let [low, high] = scale.ends;
    [low, 1.0, high].map(|share| match scale.wanted_mm {
        Some(mm) => say!(legend_spacing, mm = fixed(share * mm, 2)),
        None => say!(legend_spacing_share, percent = fixed(100.0 * share, 0)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::spacing::SpacingSample;
    use nalgebra::Point3;

    #[test]
    fn a_scale_is_told_in_mm_or_in_shares_of_what_each_surface_wants() {
        let place = SpacingSample { surface: 1, at: Point3::origin(), mm: 0.5, wanted_mm: 0.5 };
        let scale = SpacingScale { ends: [0.8, 3.0], wanted_mm: Some(0.5), least: place, greatest: place };
        assert_eq!(spacing_labels(&scale), ["0.40 mm", "0.50 mm", "1.50 mm"]);
        assert_eq!(spacing_labels(&SpacingScale { wanted_mm: None, ..scale }), ["80 %", "100 %", "300 %"]);
    }
}
