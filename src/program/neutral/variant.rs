//! Which program of a plan is meant: the whole one or what is left of it behind a stop, to be run or to be tried with
//! every output off. What it does and what it is called differ; how it is written does not.

use super::comment::Comment;
use super::lines::{Move, ProgramLine, lines};
use super::steps::{MoveTiming, Steps};
use crate::cell::Setup;
use serde::{Deserialize, Serialize};

/// Speed of a dry run, per cent of the program's. A quarter of the 100 mm/s of connecting moves is slow enough to stop by
/// hand before anything is touched (controllers allow ten times as much beside an open fence); half of it is not to those
/// who see the program for the first time, and at a tenth nobody watches a run to its end.
pub const DRY_RUN_PERCENT: f64 = 25.0;

/// Which program of a plan is meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Variant {
    /// It makes the program's motion slower and with every output off.
    pub dry_run: bool,
    /// It begins with this pass, those before it are done; `None`: with the first.
    pub from_pass: Option<usize>,
}

impl Variant {
    /// The program itself.
    pub const WHOLE: Variant = Variant { dry_run: false, from_pass: None };

    /// The dry run of the same passes.
    pub fn dry(self) -> Variant {
        Variant { dry_run: true, ..self }
    }

    /// Its lines, of the steps that it has, before any controller's words.
    pub(in super::super) fn lines(self, steps: &Steps, setup: &Setup) -> Vec<ProgramLine> {
        let all = lines(steps, setup);
        if self.dry_run { all.into_iter().filter_map(dry).collect() } else { all }
    }

    /// What a program name has added for it, the long way and the short one, and the shortest, without the pass.
    fn endings(self) -> [String; 3] {
        let pass = self.from_pass.map_or(String::new(), |n| format!("P{n}"));
        let of_pass = if pass.is_empty() { String::new() } else { format!("_{pass}") };
        match (self.dry_run, self.from_pass) {
            (false, None) => Default::default(),
            (false, Some(_)) => [of_pass, pass, "P".into()],
            (true, None) => ["_DRY".into(), "D".into(), "D".into()],
            (true, Some(n)) => [format!("_DRY{of_pass}"), format!("D{n}"), "DP".into()],
        }
    }

    /// The name of the program by that of the whole one, with at most so many letters: shortened where it has to be, and
    /// never the same. `name` is ASCII, as controllers have it.
    pub fn name(self, name: &str, longest: usize) -> String {
        if self == Variant::WHOLE {
            return name.to_owned();
        }
        let mut tries = self.endings().into_iter().flat_map(|ending| {
            let room = longest.saturating_sub(ending.len()).min(name.len());
            (1..=room).rev().filter_map(move |kept| Some(format!("{}{ending}", name.get(..kept)?)))
        });
        tries.find(|own| own != name).unwrap_or_else(|| name.to_owned())
    }

    /// The number of the program by that of the whole one, where programs have numbers up to 999. Each kind has a fifth of
    /// them, so that subprograms, numbered on, stay apart up to 200 files.
    pub fn number(self, number: u32) -> u32 {
        const OF_A_KIND: u32 = 200;
        let kind = u32::from(self.from_pass.is_some()) + 2 * u32::from(self.dry_run);
        (number / OF_A_KIND + kind) % (1000 / OF_A_KIND) * OF_A_KIND + number % OF_A_KIND
    }
}

/// A line as a dry run has it. Where the program switches something on, it switches it off once more: so moves stop and
/// flow on as they do in the program, and nothing that was left on stays so.
fn dry(line: ProgramLine) -> Option<ProgramLine> {
    match line {
        ProgramLine::Output { number, .. } => Some(ProgramLine::Output { number, on: false }),
        ProgramLine::OutputValue { .. }
        | ProgramLine::Force(_)
        | ProgramLine::Wait(_)
        | ProgramLine::Comment(Comment::Set(_)) => None,
        ProgramLine::Move(m) => {
            let timing = slower(m.timing);
            Some(ProgramLine::Move(Box::new(Move { timing, lit: false, ..*m })))
        }
        ProgramLine::Comment(_) => Some(line),
    }
}

/// Some controllers take whole per cent only, and none below one.
fn slower(timing: MoveTiming) -> MoveTiming {
    let share = DRY_RUN_PERCENT / 100.0;
    match timing {
        MoveTiming::Seconds(s) => MoveTiming::Seconds(s / share),
        MoveTiming::Percent(p) => MoveTiming::Percent((p * share).floor().max(1.0).min(p)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::beam::ProcessSettings;
    use crate::program::neutral::steps::{Go, Interpolation, Station, Step};
    use nalgebra::{Point3, Vector3};
    use proptest::prelude::*;

    fn variants() -> [Variant; 3] {
        let from = Variant { dry_run: false, from_pass: Some(12) };
        [Variant::WHOLE.dry(), from, from.dry()]
    }

    #[test]
    fn names_are_the_variants_own_and_as_long_as_they_may_be() {
        let [dry, from, both] = variants();
        let all = |name, longest| [dry, from, both].map(|v| v.name(name, longest));
        assert_eq!(all("clearbeam", 20), ["clearbeam_DRY", "clearbeam_P12", "clearbeam_DRY_P12"]);
        assert_eq!(Variant::WHOLE.name("as_long_as_it_may_be", 5), "as_long_as_it_may_be");
        assert_eq!(all("CLEAN", 5), ["C_DRY", "C_P12", "CLD12"], "eight letters, three of them for parts");
        assert_eq!(dry.name("C_DRY", 5), "C_DRD", "never the name of the whole program");
    }

    proptest! {
        #[test]
        fn no_name_or_number_is_that_of_another_kind(
            name in "[A-Z][A-Z0-9_]{0,19}", longest in prop::sample::select(vec![5usize, 20, 28, 32]), number in 0..1000u32
        ) {
            let name = &name[..name.len().min(longest)];
            let mut seen = vec![Variant::WHOLE.number(number)];
            prop_assert_eq!(seen[0], number);
            for variant in variants() {
                let own = variant.name(name, longest);
                prop_assert!(own != name && own.len() <= longest && own.starts_with(&name[..1]), "{} {}", name, own);
                let own = variant.number(number);
                prop_assert!(own < 1000 && !seen.contains(&own), "{} {:?}", own, seen);
                seen.push(own);
            }
        }
    }

    #[test]
    fn a_dry_run_goes_the_same_way_slower_and_switches_nothing_on() {
        let setup = Setup::shipped().expect("shipped");
        let at = |x: f64| Station { x: Point3::new(x, 0.0, 0.0), a: Vector3::z(), o: Vector3::y() };
        let go = |x, timing| {
            Step::Go(Go { to: at(x), interpolation: Interpolation::Linear, joints_deg: None, timing, target: None })
        };
        let list = vec![
            Step::Home { percent: 10.0 },
            go(0.0, MoveTiming::Percent(10.0)),
            Step::Process(ProcessSettings::default()),
            Step::Laser(true),
            go(3.0, MoveTiming::Seconds(1.0)),
            Step::Laser(false),
            Step::Home { percent: 10.0 },
        ];
        let steps = Steps { list, ..Steps::default() };
        let (whole, dry) = (Variant::WHOLE.lines(&steps, &setup), Variant::WHOLE.dry().lines(&steps, &setup));
        let moves = |lines: &[ProgramLine]| -> Vec<Move> {
            lines.iter().filter_map(|l| if let ProgramLine::Move(m) = l { Some((**m).clone()) } else { None }).collect()
        };
        for (w, d) in moves(&whole).iter().zip(moves(&dry)) {
            let expected = match w.timing {
                MoveTiming::Seconds(s) => MoveTiming::Seconds(4.0 * s),
                MoveTiming::Percent(_) => MoveTiming::Percent(2.0),
            };
            assert_eq!(Move { timing: expected, lit: false, ..w.clone() }, d);
        }
        assert_eq!(moves(&whole).len(), moves(&dry).len());
        assert!(moves(&whole).iter().any(|m| m.lit) && dry.iter().all(|l| !is_on(l)), "{dry:?}");
        assert!(matches!(dry.first(), Some(ProgramLine::Output { on: false, .. })), "the laser is off first of all");
        assert_eq!(slower(MoveTiming::Percent(1.0)), MoveTiming::Percent(1.0), "none is faster than the program's");
        assert_eq!(slower(MoveTiming::Percent(100.0)), MoveTiming::Percent(25.0));
    }

    fn is_on(line: &ProgramLine) -> bool {
        matches!(line, ProgramLine::Output { on: true, .. } | ProgramLine::OutputValue { .. })
    }
}
