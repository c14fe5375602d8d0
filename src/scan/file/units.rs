//! Whether a cloud was taken in the wrong unit, by its size beside the part's. Nothing is scaled here: it is asked.

use crate::part::Units;
use serde::Serialize;

/// Sizes of cloud and part that speak for another unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct UnitDoubt {
    /// Diagonal of the part's box by that of the cloud's.
    pub ratio: f64,
    /// The unit in which the cloud would be as large as the part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cloud_units: Option<Units>,
    /// The unit in which the part would be as large as the cloud.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part_units: Option<Units>,
}

/// Sizes that differ by less are taken for the same. A scan sees a share of the part, and its box's diagonal is that
/// of the part within this in all cases with half of it missing; the nearest other factors of units, 25.4 and 39.4,
/// are more than this apart.
const SAME: f64 = 1.5;

/// Looks at the diagonals, mm, of a cloud and a part that were taken in these units. `None`: their sizes go together,
/// or no unit would bring them together.
pub fn unit_doubt(
    [cloud_diagonal_mm, part_diagonal_mm]: [f64; 2],
    [cloud_units, part_units]: [Units; 2],
) -> Option<UnitDoubt> {
    let ratio = part_diagonal_mm / cloud_diagonal_mm;
    if !(ratio.is_finite() && ratio > 0.0) {
        return None;
    }
    // How far a unit leaves the sizes apart: 1 is not at all.
    let apart = |ratio: f64| ratio.max(1.0 / ratio);
    let better = |taken: Units, ratio: f64| {
        let with = |u: &Units| apart(ratio * taken.mm() / u.mm());
        let others = Units::ALL.into_iter().filter(|u| *u != taken && with(u) <= SAME);
        others.min_by(|a, b| with(a).total_cmp(&with(b)))
    };
    if apart(ratio) <= SAME {
        return None;
    }
    let (cloud_units, part_units) = (better(cloud_units, ratio), better(part_units, 1.0 / ratio));
    (cloud_units.is_some() || part_units.is_some()).then_some(UnitDoubt { ratio, cloud_units, part_units })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metres_and_inches_taken_for_millimetres_are_asked_about() {
        let doubt = |cloud: f64, part: f64| unit_doubt([cloud, part], [Units::Mm; 2]);
        let metres = doubt(0.17, 200.0).expect("1176 times");
        assert_eq!((metres.cloud_units, metres.part_units), (Some(Units::M), None));
        assert!((metres.ratio - 200.0 / 0.17).abs() < 1e-9);
        assert_eq!(doubt(6.0, 200.0).and_then(|d| d.cloud_units), Some(Units::Inch));
        assert_eq!(doubt(200.0, 0.2).map(|d| (d.cloud_units, d.part_units)), Some((None, Some(Units::M))));
        for (cloud, part) in [(200.0, 200.0), (120.0, 200.0), (60.0, 200.0), (2.0, 200.0), (0.0, 5.0), (f64::NAN, 1.0)]
        {
            assert_eq!(doubt(cloud, part), None, "{cloud} {part}");
        }
    }

    #[test]
    fn a_cloud_in_metres_that_holds_millimetres_is_asked_about() {
        let doubt = unit_doubt([200_000.0, 210.0], [Units::M, Units::Mm]).expect("a thousandth");
        assert_eq!((doubt.cloud_units, doubt.part_units), (Some(Units::Mm), Some(Units::M)));
    }
}
