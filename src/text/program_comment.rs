//! The words of comments in programs: English, whatever the language of the window.

use super::list::joined;
use super::{Arg, Message, exact, id, messages};
use crate::program::{ByHand, Caveat, Comment, FileNote, GrindingFigures, ProcessFigures};

/// The words of a message in English.
macro_rules! english {
    ($key:ident $(, $name:ident = $value:expr)* $(,)?) => {
        messages::$key { $($name: Arg::from($value)),* }.english()
    };
}

/// The words of a comment.
pub fn program_comment(comment: &Comment) -> String {
    match comment {
        Comment::Part(part) => english!(comment_part, version = env!("CARGO_PKG_VERSION"), part = part),
        Comment::Surfaces { shown, more } => surfaces(shown, *more),
        Comment::WorkedWith(figures) => process_figures(figures),
        Comment::GroundWith(figures) => grinding_figures(figures),
        Comment::LineLayout { direction, spacing_mm, order } => english!(
            comment_laid,
            direction = direction.to_string(),
            spacing = exact(*spacing_mm),
            order = order.word()
        ),
        Comment::Targets { all, corrected, blocked } => {
            english!(comment_targets, all = id(all), corrected = id(corrected), blocked = id(blocked))
        }
        Comment::WithoutRobot(mount) => english!(comment_without_robot, mount = mount.word()),
        Comment::Robot { name, mount } => english!(comment_robot, name = name, mount = mount.word()),
        Comment::Unchecked(figures) => english!(
            comment_unchecked,
            figures = joined(figures, |list, next| english!(list_and_next, list = list, next = next))
        ),
        Comment::PartFile(note) => file_note(*note),
        Comment::NeverRun { dialect, dry_run } => english!(comment_never_run, dialect = dialect, dry_run = dry_run),
        Comment::DryRun { percent } => english!(comment_dry_run, percent = exact(*percent)),
        Comment::FromPass(number) => english!(comment_from_pass, number = id(number)),
        Comment::Caveat(Caveat::Rapid) => english!(comment_caveat_rapid),
        Comment::Caveat(Caveat::Erp) => english!(comment_caveat_erp),
        Comment::Caveat(Caveat::Krl) => english!(comment_caveat_krl),
        Comment::Caveat(Caveat::Inform) => english!(comment_caveat_inform),
        Comment::Pass { number, surface, layer: 0 } => {
            english!(comment_pass, number = id(number), surface = id(surface))
        }
        Comment::Pass { number, surface, layer } => {
            english!(comment_pass_of_layer, number = id(number), surface = id(surface), layer = id(layer + 1))
        }
        Comment::Force(force_n) if *force_n > 0.0 => english!(comment_force_on, force = exact(*force_n)),
        Comment::Force(_) => english!(comment_force_off),
        Comment::Set(ByHand::PowerW(value)) => english!(comment_set_power, value = exact(*value)),
        Comment::Set(ByHand::FrequencyKhz(value)) => english!(comment_set_frequency, value = exact(*value)),
    }
}

fn file_note(note: FileNote) -> String {
    match note {
        FileNote::UnitOverridden { stated, units } => {
            english!(comment_file_unit, stated = stated.word(), units = units.word())
        }
        FileNote::FacetsDropped(count) => english!(comment_file_dropped, count = id(count)),
        FileNote::CountDiffers { promised, read } => {
            english!(comment_file_count, promised = id(promised), read = id(read))
        }
        FileNote::NotRead(count) => english!(comment_file_not_read, count = id(count)),
        FileNote::BytesPassedOver { count, at } => {
            english!(comment_file_passed_over, count = id(count), at = id(at))
        }
        FileNote::SolidsJoined(count) => english!(comment_file_joined, count = id(count)),
    }
}

fn surfaces(shown: &[u32], more: usize) -> String {
    let list = shown.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
    match more {
        0 => english!(comment_surfaces, list = list),
        more => english!(comment_surfaces_and_more, list = list, more = id(more)),
    }
}

fn process_figures(w: &ProcessFigures) -> String {
    let [power, spot, defocus, speed] = [w.power_w, w.spot_mm, w.defocus_mm, w.speed_mm_s].map(exact);
    if w.frequency_khz > 0.0 {
        let frequency = exact(w.frequency_khz);
        return english!(
            comment_worked_with_pulses,
            power = power,
            frequency = frequency,
            spot = spot,
            defocus = defocus,
            speed = speed
        );
    }
    english!(comment_worked_with, power = power, spot = spot, defocus = defocus, speed = speed)
}

fn grinding_figures(w: &GrindingFigures) -> String {
    let [force, speed] = [w.force_n, w.speed_mm_s].map(exact);
    match (w.is_belt, w.force_n > 0.0) {
        (false, false) => english!(comment_ground_disc, speed = speed),
        (false, true) => english!(comment_ground_disc_force, force = force, speed = speed),
        (true, false) => english!(comment_ground_belt, speed = speed),
        (true, true) => english!(comment_ground_belt_force, force = force, speed = speed),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_lines_of_ascii() {
        let caveats = [Caveat::Rapid, Caveat::Erp, Caveat::Krl, Caveat::Inform];
        let widths = [100, 100, 100, 28];
        for (caveat, width) in caveats.into_iter().zip(widths) {
            let text = program_comment(&Comment::Caveat(caveat));
            assert!(text.is_ascii() && text.lines().all(|l| (1..=width).contains(&l.len())), "{text}");
            assert!(text.lines().count() > 2, "{text}");
        }
    }

    #[test]
    fn numbers_stay_together_and_as_short_as_they_can() {
        let of = |comment| program_comment(&comment);
        assert_eq!(of(Comment::Pass { number: 1234, surface: 5678, layer: 0 }), "pass 1234, surface 5678");
        assert_eq!(of(Comment::Pass { number: 0, surface: 7, layer: 1 }), "pass 0, surface 7, layer 2");
        assert_eq!(of(Comment::Set(ByHand::PowerW(1500.0))), "set power to 1500 W by hand");
        assert_eq!(of(Comment::Set(ByHand::FrequencyKhz(0.25))), "set frequency to 0.25 kHz by hand");
        assert_eq!(of(Comment::Force(25.0)), "press with 25 N");
        let figures = GrindingFigures { is_belt: false, force_n: 12.5, speed_mm_s: 50.0 };
        assert_eq!(of(Comment::GroundWith(figures)), "grinding disc, force 12.5 N, speed 50 mm/s");
        assert_eq!(of(Comment::Surfaces { shown: vec![3, 1], more: 0 }), "surfaces 3 1");
        assert_eq!(of(Comment::Surfaces { shown: vec![3, 1], more: 1200 }), "surfaces 3 1 and 1200 more");
    }
}
