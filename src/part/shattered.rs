//! Files that shatter into hundreds of surfaces smaller than the spot, and from which area on absorbing islands brings
//! them to order. It only tells; what is absorbed is the operator's choice.

use super::numbering::Numbering;
use super::{Part, PartFinding, SurfaceRule, Surfaces};
use crate::progress::{Cancelled, Progress};

/// So many surfaces smaller than the spot are more than anyone puts on a list by hand. Bracketing cases: an IMU housing
/// with 76 of them, all letters and pins that are there; a robot's base with 529.
const MANY: usize = 100;
/// One of so many may be left.
const LEFT_ONE_IN: usize = 10;
/// Areas that are tried, mm²: such as a person would type.
const LADDER_MM2: [f64; 22] = [
    0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0,
    2000.0, 5000.0, 10000.0,
];

impl PartFinding {
    /// Whether so many surfaces are smaller than the spot that [`PartFinding::shattered`] is worth asking. In a unit in
    /// which the part is implausibly small all of them may be.
    pub fn may_be_shattered(part: &Part, surfaces: &Surfaces, spot_mm2: f64) -> bool {
        part.figures.has_plausible_size && surfaces.list.iter().filter(|s| s.area_mm2 < spot_mm2).count() >= MANY
    }

    /// What is to be said of a part with hundreds of surfaces smaller than the spot. The least area of the ladder is
    /// offered that leaves hardly any of them; islands that have no neighbour stay, and where those are too many
    /// there is nothing to say. `rule`: what the surfaces follow from.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn shattered(
        part: &Part,
        surfaces: &Surfaces,
        rule: &SurfaceRule,
        spot_mm2: f64,
        progress: &Progress,
    ) -> Result<Option<PartFinding>, Cancelled> {
        if !PartFinding::may_be_shattered(part, surfaces, spot_mm2) {
            return Ok(None);
        }
        let smaller = surfaces.list.iter().filter(|s| s.area_mm2 < spot_mm2).count();
        let most_left = smaller / LEFT_ONE_IN;
        let mut least = None;
        // Down from the first area that leaves none but islands without neighbours: below it few are worth trying.
        let top = LADDER_MM2.iter().position(|mm2| *mm2 >= spot_mm2).map_or(LADDER_MM2.len(), |at| at + 1);
        for &absorb_below_mm2 in LADDER_MM2[..top].iter().rev().filter(|mm2| **mm2 > rule.min_area_mm2) {
            progress.check()?;
            let areas = areas(part, &SurfaceRule { min_area_mm2: absorb_below_mm2, ..*rule });
            if areas.iter().filter(|mm2| **mm2 < spot_mm2).count() > most_left {
                break;
            }
            least = Some((absorb_below_mm2, areas.len()));
        }
        Ok(least.map(|(absorb_below_mm2, surfaces_then)| PartFinding::Shattered {
            surfaces: surfaces.list.len(),
            smaller,
            smaller_than_mm2: spot_mm2,
            absorb_below_mm2,
            surfaces_then,
        }))
    }
}

/// Areas of the surfaces by a rule, in the order of their numbers, mm².
fn areas(part: &Part, rule: &SurfaceRule) -> Vec<f64> {
    let Numbering { of_facet, last_number } = Numbering::new(&part.mesh, &part.tree, &part.dihedral_deg, rule);
    let mut areas = vec![0.0; last_number as usize];
    for (number, mm2) in of_facet.iter().zip(&part.mesh.areas) {
        areas[*number as usize - 1] += mm2;
    }
    areas
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{Placement, Units};
    use crate::sample::solids::folded_sheet;
    use crate::sample::{Triangles, stl_bytes};
    use std::f64::consts::PI;

    const RULE: SurfaceRule = SurfaceRule { angle_deg: 20.0, min_area_mm2: 0.0, hysteresis_deg: 0.0 };
    const SPOT_MM2: f64 = 0.25 * PI;

    fn told(triangles: &Triangles, rule: &SurfaceRule, spot_mm2: f64) -> (usize, Option<PartFinding>) {
        let part = Part::from_bytes(&stl_bytes(triangles), Units::Mm, &Placement::default(), &[]).expect("a part");
        let surfaces = Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, rule, &[], &[]);
        let told = PartFinding::shattered(&part, &surfaces, rule, spot_mm2, &Progress::default());
        (surfaces.list.len(), told.expect("not cancelled"))
    }

    #[test]
    fn it_takes_a_hundred_surfaces_smaller_than_the_spot() {
        // Fields of 20 mm × 0.03 mm have 0.6 mm², and 0.8 mm² with 0.04 mm.
        for (count, width, is_told) in [(99, 0.03, false), (100, 0.03, true), (150, 0.04, false)] {
            let (surfaces, told) = told(&folded_sheet(count, width), &RULE, SPOT_MM2);
            assert_eq!((surfaces, told.is_some()), (count + 2, is_told), "{count} of {width}");
        }
    }

    #[test]
    fn the_value_that_is_offered_leaves_hardly_any_and_the_one_below_it_does_not() {
        // 0.06 mm² each: at 0.05 mm² nothing is an island.
        let strip = folded_sheet(300, 0.003);
        let (surfaces, finding) = told(&strip, &RULE, SPOT_MM2);
        let Some(PartFinding::Shattered { smaller, absorb_below_mm2, surfaces_then, .. }) = finding else {
            panic!("{finding:?}");
        };
        assert_eq!((surfaces, smaller), (302, 300));
        let left = |absorb_below_mm2: f64| {
            let rule = SurfaceRule { min_area_mm2: absorb_below_mm2, ..RULE };
            let part = Part::from_bytes(&stl_bytes(&strip), Units::Mm, &Placement::default(), &[]).expect("a part");
            let then = Surfaces::new(&part.mesh, &part.tree, &part.dihedral_deg, &rule, &[], &[]);
            (then.list.len(), then.list.iter().filter(|s| s.area_mm2 < SPOT_MM2).count())
        };
        let (then, tiny) = left(absorb_below_mm2);
        assert!(then == surfaces_then && tiny <= 30, "{absorb_below_mm2}: {then} surfaces, {tiny} tiny");
        let at = LADDER_MM2.iter().position(|mm2| *mm2 == absorb_below_mm2).expect("on the ladder");
        assert!(left(LADDER_MM2[at - 1]).1 > 30, "the least of its kind");
        assert!(absorb_below_mm2 > 0.05 && LADDER_MM2[at - 1] < SPOT_MM2);
        // Once it is taken there is nothing more to say.
        let taken = SurfaceRule { min_area_mm2: absorb_below_mm2, ..RULE };
        assert_eq!(told(&strip, &taken, SPOT_MM2).1, None);
    }

    #[test]
    fn crumbs_without_neighbours_cannot_be_absorbed() {
        let crumb = |i: usize| [[i as f64, 0.0, 0.0], [i as f64 + 0.5, 0.0, 0.0], [i as f64, 0.5, 0.0]];
        let crumbs: Triangles = (0..200).map(crumb).collect();
        assert_eq!(told(&crumbs, &RULE, SPOT_MM2), (200, None));
    }
}
