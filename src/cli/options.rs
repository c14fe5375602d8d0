//! The options of `plan`: what they are, and how they override a job.

use super::CommandFailure;
use super::number_options;
use super::word_options::WordOptions;
use crate::document::files::build_part;
use crate::document::{Edit, Job, Parameter, RecutAnchor, segmented};
use crate::part::{Part, Source, Weld};
use crate::progress::Progress;
use crate::text::Sentence as _;
use crate::text::parameter::refused_option;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What can be overridden; what is not given stays as in the job, or its default.
#[derive(Clone, Debug, Default)]
pub struct PlanOptions {
    numbers: Vec<(&'static Parameter, f64)>,
    words: WordOptions,
}

/// Word options that the help lists after the number that they belong to; `""`: before all numbers. Others follow at the
/// end.
const BEHIND: [(&str, &str); 9] = [
    ("units", ""),
    ("weld", ""),
    ("surfaces", "angle"),
    ("direction", "angle"),
    ("strategy", "spacing"),
    ("overlap", "spacing"),
    ("offset", "passes"),
    ("order", "passes"),
    ("correction", "max-turn"),
];

impl Args for PlanOptions {
    fn augment_args(command: Command) -> Command {
        let numbers: Vec<Arg> = number_options::arguments().collect();
        let options: Vec<&str> = numbers.iter().map(|a| a.get_id().as_str()).collect();
        let rank = |arg: &Arg| {
            let id = arg.get_id().as_str();
            let behind = BEHIND.iter().find(|b| b.0 == id).map_or(id, |b| b.1);
            if behind.is_empty() { 0 } else { options.iter().position(|o| *o == behind).map_or(usize::MAX, |i| i + 1) }
        };
        let words = WordOptions::augment_args(Command::new("words"));
        let mut all: Vec<(usize, Arg)> =
            numbers.iter().chain(words.get_arguments()).map(|a| (rank(a), a.clone())).collect();
        // Numbers come before the words of their rank, because they did.
        all.sort_by_key(|a| a.0);
        command.args(all.into_iter().map(|(_, arg)| arg.display_order(None)))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for PlanOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(PlanOptions { numbers: number_options::given(matches), words: WordOptions::from_arg_matches(matches)? })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        self.words.update_from_arg_matches(matches)?;
        self.numbers.extend(number_options::given(matches));
        Ok(())
    }
}

impl PlanOptions {
    /// Writes the given options into a job on the part that was read from `source`.
    ///
    /// # Errors
    /// A number is out of range, or the part cannot be cut with it.
    pub fn apply(&self, job: &mut Job, source: &Source) -> Result<(), CommandFailure> {
        if let Some(weld) = self.words.weld.filter(|w| *w != job.part.weld) {
            reweld(job, source, weld)?;
        }
        for &(p, value) in &self.numbers {
            p.check(value).map_err(|e| CommandFailure::Usage(refused_option(&e)))?;
            if p.recuts() && job.settings.iter().next().is_some() {
                recut(job, source, p, value)?;
            } else {
                job.set_number(p, value);
            }
        }
        let words = &self.words;
        if let Some(percent) = words.overlap {
            let spacing_mm = job.spacing_of_overlap(percent);
            job.layers.spacing_mm = spacing_mm.map_err(|e| CommandFailure::Usage(e.sentence()))?;
        }
        job.layers.strategy = words.strategy.unwrap_or(job.layers.strategy);
        if let Some(list) = &words.surfaces {
            job.settings.choose(list.clone());
        }
        job.part.units = words.units.unwrap_or(job.part.units);
        job.layers.direction = words.direction.unwrap_or(job.layers.direction);
        job.layers.offset_mm = words.offset.unwrap_or(job.layers.offset_mm);
        job.layers.order = words.order.unwrap_or(job.layers.order);
        job.path.correction = words.correction.unwrap_or(job.path.correction);
        words.robot.apply(job)?;
        job.check().map_err(|e| CommandFailure::Usage(e.sentence()))
    }

    /// The head's file, as seen from the current folder.
    pub fn head(&self) -> Option<&PathBuf> {
        self.words.head.as_ref()
    }
}

/// Cuts the surfaces anew as the window does: their settings are carried over to their new numbers.
fn recut(job: &mut Job, source: &Source, p: &Parameter, value: f64) -> Result<(), CommandFailure> {
    let (part, anchor) = anchored(job, source)?;
    apply_and_tell(&Edit::recut(&part, &anchor, p, value), job);
    Ok(())
}

/// Welds otherwise as the window does, with the settings of surfaces carried over.
fn reweld(job: &mut Job, source: &Source, weld: Weld) -> Result<(), CommandFailure> {
    if !job.says_of_numbers() {
        job.part.weld = weld;
        return Ok(());
    }
    let (part, anchor) = anchored(job, source)?;
    let edit = Edit::weld(source, &part, &anchor, weld, &Progress::default()).map_err(CommandFailure::failed)?;
    // Nobody can have cancelled it.
    edit.iter().for_each(|edit| apply_and_tell(edit, job));
    Ok(())
}

/// The part of a job, and where an edit that changes its surfaces starts.
fn anchored(job: &Job, source: &Source) -> Result<(Part, RecutAnchor), CommandFailure> {
    let built = build_part(source, &job.part, Path::new(&job.part.file), &Progress::default());
    // Nobody can have cancelled it.
    let part = built.map_err(CommandFailure::failed)?.unwrap_or_default();
    let surfaces = Arc::new(segmented(&part, job));
    Ok((part, RecutAnchor { job: job.clone(), surfaces }))
}

/// Makes an edit, and says what surfaces lost by it.
fn apply_and_tell(edit: &Edit, job: &mut Job) {
    for lost in edit.apply(job, &[]) {
        eprintln!("{}", lost.sentence());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn command() -> Command {
        PlanOptions::augment_args(Command::new("plan"))
    }

    fn given(arguments: &[&str]) -> PlanOptions {
        let all = ["plan"].iter().chain(arguments);
        PlanOptions::from_arg_matches(&command().get_matches_from(all)).expect("options")
    }

    #[test]
    fn the_help_tells_every_option_where_it_belongs() {
        command().debug_assert();
        let help = command().render_help().to_string();
        let lines = help.lines().map(str::trim).filter_map(|l| l.strip_prefix("--"));
        let names: Vec<&str> = lines.filter_map(|l| l.split_whitespace().next()).collect();
        let wanted = "units weld angle surfaces direction spacing strategy overlap inset passes offset order defocus \
                      chord-error max-step max-turn correction speed air-speed power spot max-tilt margin min-depth gate head cell \
                      robot mount dialect spin";
        assert_eq!(names, wanted.split_whitespace().collect::<Vec<_>>());
        for default in ["[default: 0.5 mm]", "[default: 20°]", "[default: 1]", "[default: 3 mm/s]", "[default: 500 W]"]
        {
            assert!(help.contains(default), "{default} in {help}");
        }
    }

    #[test]
    fn numbers_go_where_their_row_says_and_are_checked() {
        let stl = crate::sample::stl_bytes(&crate::sample::solids::cube(10.0));
        let source = Source::from_bytes(&stl).expect("a cube");
        let mut job = Job::default();
        let options =
            given(&["--passes", "2", "--inset", "-1.5", "--angle=30", "--order", "one-way", "--overlap", "25"]);
        assert!(options.apply(&mut job, &source).is_ok());
        assert_eq!((job.layers.passes, job.layers.inset_mm, job.surfaces.angle_deg), (2, -1.5, 30.0));
        assert_eq!((job.layers.order, job.layers.spacing_mm), (crate::path::Order::OneWay, 0.75));
        for (refused, said) in [
            (["--passes", "1.5"], "--passes = 1.5: give a whole number from 1 to 1000"),
            (["--spacing", "-2"], "--spacing = -2: give a number above 0, up to 1000 mm"),
            (["--overlap", "96"], "overlap = 96: give a number from 0 to 95 %"),
            (["--dialect", "karel"], "dialect = \"karel\": give one of nachi, "),
        ] {
            let Err(CommandFailure::Usage(why)) = given(&refused).apply(&mut Job::default(), &source) else {
                panic!("{refused:?} is no usage error");
            };
            assert!(why.starts_with(said), "{why}");
        }
    }
}
