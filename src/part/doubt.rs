//! Which findings of a file cast doubt on the part, and come before all others.

use super::PartFinding;

impl PartFinding {
    /// Findings with one more, which casts doubt on the part as little as one of them may.
    pub fn with(mut found: Vec<PartFinding>, shattered: Option<PartFinding>) -> Vec<PartFinding> {
        let at = found.iter().take_while(|f| f.casts_doubt()).count();
        found.splice(at..at, shattered);
        found
    }

    /// Whether it may not be the part that is meant, or not cut as it is meant: somebody has to look at it before
    /// anything is chosen. All others are no news to whoever has such parts.
    pub fn casts_doubt(&self) -> bool {
        match self {
            PartFinding::ImplausibleSize { .. }
            | PartFinding::FarFromOrigin(_)
            | PartFinding::UnitOverridden { .. }
            | PartFinding::FacetsDropped { .. }
            | PartFinding::CountDiffers { .. }
            | PartFinding::NotRead { .. }
            | PartFinding::BytesPassedOver { .. }
            | PartFinding::Shattered { .. } => true,
            PartFinding::OpenEdges { .. }
            | PartFinding::NonManifoldEdges { .. }
            | PartFinding::FlippedFacets { .. }
            | PartFinding::DuplicateFacets { .. }
            | PartFinding::TwoSidedFacets { .. }
            | PartFinding::DegenerateFacets { .. }
            | PartFinding::JoinedCorners { .. }
            | PartFinding::SolidsJoined { .. }
            | PartFinding::Meshed { .. }
            | PartFinding::UnitTaken { .. } => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::{Part, Placement, Units};
    use crate::sample::{solids, stl_bytes};

    #[test]
    fn what_casts_doubt_stands_before_what_does_not() {
        // Without a facet, and a tail: both in a unit that makes it 2 m, and in one that makes it 2 mm.
        let mut bytes = stl_bytes(&solids::cube(2.0)[1..].to_vec());
        bytes.extend([7; 5]);
        let shattered = PartFinding::Shattered {
            surfaces: 483,
            smaller: 440,
            smaller_than_mm2: 0.785,
            absorb_below_mm2: 1.0,
            surfaces_then: 36,
        };
        for (units, doubts) in [(Units::M, 1), (Units::Mm, 2)] {
            let part = Part::from_bytes(&bytes, units, &Placement::default(), &[]).expect("a part");
            let found = PartFinding::of(&part);
            assert!(found.is_sorted_by_key(|f| !f.casts_doubt()), "{found:?}");
            let with = PartFinding::with(found.clone(), Some(shattered.clone()));
            assert!(with.is_sorted_by_key(|f| !f.casts_doubt()), "{with:?}");
            assert_eq!(with.iter().position(|f| *f == shattered), Some(doubts));
            assert_eq!(PartFinding::with(found.clone(), None), found);
        }
    }
}
