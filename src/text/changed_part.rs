//! What becomes of a job whose part's file has changed.

use super::{Sentence, fixed, id, say};
use crate::document::{CarriedOver, LostSurface};
use crate::part::identity::LostReason;
use nalgebra::Isometry3;

/// Turns below this are not mentioned, degrees.
const LEAST_TURN_DEG: f64 = 1e-3;

/// What there is to know, a line each.
pub fn carried_lines(carried: &CarriedOver) -> Vec<String> {
    let renumbered = carried.kept.iter().filter(|(old, new)| old != new).count();
    let count = carried.kept.len();
    let mut lines: Vec<String> = carried.motion.iter().map(moved).collect();
    lines.extend(carried.scale.map(|scale| say!(carried_scaled, scale = fixed(scale, 4))));
    if carried.knows_no_surface {
        lines.push(say!(carried_all_unknown));
    }
    lines.push(match renumbered {
        0 => say!(carried_found, count),
        _ => say!(carried_found_renumbered, count, renumbered),
    });
    lines.extend(carried.lost.iter().map(|lost| say!(carried_not_found, surface = lost.sentence())));
    if carried.lost_edits > 0 {
        lines.push(say!(carried_edits_lost, count = carried.lost_edits));
    }
    if carried.lost_shells > 0 {
        lines.push(say!(carried_shells_lost, count = carried.lost_shells));
    }
    lines
}

/// How the whole part has moved, in the file's unit.
fn moved(motion: &Isometry3<f64>) -> String {
    let [x, y, z] = <[f64; 3]>::from(motion.translation.vector).map(|c| fixed(c, 3));
    let turn_deg = motion.rotation.angle().to_degrees();
    if turn_deg > LEAST_TURN_DEG {
        say!(carried_moved_and_turned, x, y, z, turn_deg = fixed(turn_deg, 2))
    } else {
        say!(carried_moved, x, y, z)
    }
}

/// `surface 4 (Rim): nothing like it is there`.
impl Sentence for LostSurface {
    fn sentence(&self) -> String {
        let (surface, why) = (id(self.surface), why(self.why));
        match self.name.as_str() {
            "" => say!(lost_surface, surface, why),
            name => say!(lost_named_surface, surface, name, why),
        }
    }
}

fn why(why: LostReason) -> String {
    match why {
        LostReason::NothingAlike => say!(lost_nothing_alike),
        LostReason::SeveralAlike => say!(lost_several_alike),
        LostReason::EditNotRepeated => say!(lost_edit_not_repeated),
        LostReason::OtherFacets => say!(lost_other_facets),
        LostReason::NotRemembered => say!(lost_not_remembered),
        LostReason::SeveralMotions => say!(lost_several_motions),
        LostReason::PartMoved => say!(lost_part_moved),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Job;
    use crate::part::SurfaceId;
    use nalgebra::{Translation3, UnitQuaternion, Vector3};

    #[test]
    fn what_becomes_of_a_job_is_told_line_by_line() {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 30f64.to_radians());
        let (surface, name) = (SurfaceId(1204), "Rim".to_owned());
        let lost = LostSurface { surface, name, is_chosen: true, why: LostReason::NothingAlike };
        let carried = CarriedOver {
            job: Job::default(),
            kept: vec![(SurfaceId(1), SurfaceId(1)), (SurfaceId(2), SurfaceId(3))],
            lost: vec![lost.clone(), LostSurface { name: String::new(), why: LostReason::NotRemembered, ..lost }],
            lost_edits: 1,
            lost_shells: 2,
            knows_no_surface: false,
            motion: Some(Isometry3::from_parts(Translation3::new(0.0, 250.0, -1e-9), turn)),
            scale: Some(25.4),
            was: String::new(),
            is: String::new(),
        };
        let lines = [
            "the whole part has moved by (0.000, 250.000, 0.000) in its file and turned by 30.00°",
            "everything is 25.4000 times as large: another unit?",
            "found again: 2 surfaces, 1 of them under another number",
            "not found: surface 1204 (Rim): nothing like it is there",
            "not found: surface 1204: the job does not say what it looked like; it was saved by an earlier version",
            "not repeated: 1 merge, split or cut",
            "not found: 2 flipped shells",
        ];
        assert_eq!(carried_lines(&carried), lines);
        let one = CarriedOver { kept: vec![(SurfaceId(1), SurfaceId(1))], motion: None, scale: None, ..carried };
        assert_eq!(carried_lines(&one)[0], "found again: 1 surface");
    }
}
