//! The options of `plan`: what they are, and how they override a job.

use super::Failure;
use super::number_options;
use super::word_options::WordOptions;
use crate::document::files::build_part;
use crate::document::{Edit, Job, Parameter, RecutAnchor, segmented};
use crate::part::Source;
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

/// Words that the help tells behind a number that they belong with; `""`: before all numbers. Others follow all.
const BEHIND: [(&str, &str); 8] = [
    ("units", ""),
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
    /// A number that is out of range; the part cannot be cut by it.
    pub fn apply(&self, job: &mut Job, source: &Source) -> Result<(), Failure> {
        for &(p, value) in &self.numbers {
            p.check(value).map_err(|e| Failure::Usage(refused_option(&e)))?;
            if p.recuts() && job.settings.iter().next().is_some() {
                recut(job, source, p, value)?;
            } else {
                job.set_number(p, value);
            }
        }
        let words = &self.words;
        if let Some(percent) = words.overlap {
            let spacing_mm = job.spacing_of_overlap(percent);
            job.layers.spacing_mm = spacing_mm.map_err(|e| Failure::Usage(e.sentence()))?;
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
        job.cell.mount = words.mount.or(job.cell.mount);
        job.cell.spin = words.spin.unwrap_or(job.cell.spin);
        if let Some(dialect) = &words.dialect {
            job.cell.dialect.clone_from(dialect);
        }
        job.check().map_err(|e| Failure::Usage(e.sentence()))
    }

    /// Key of a shipped robot, or a robot file as seen from the current folder.
    pub fn robot(&self) -> Option<&String> {
        self.words.robot.as_ref()
    }

    /// The head's file, as seen from the current folder.
    pub fn head(&self) -> Option<&PathBuf> {
        self.words.head.as_ref()
    }

    /// The cell file, as seen from the current folder.
    pub fn cell(&self) -> Option<&PathBuf> {
        self.words.cell.as_ref()
    }
}

/// Cuts the surfaces anew as the window does: what the job says of them is carried over to their new numbers.
fn recut(job: &mut Job, source: &Source, p: &Parameter, value: f64) -> Result<(), Failure> {
    let built = build_part(source, &job.part, Path::new(&job.part.file), &Progress::default());
    // Nobody can have cancelled it.
    let part = built.map_err(Failure::failed)?.unwrap_or_default();
    let anchor = RecutAnchor { job: job.clone(), surfaces: Arc::new(segmented(&part, job)) };
    for lost in Edit::recut(&part, &anchor, p, value).apply(job, &[]) {
        eprintln!("{}", lost.sentence());
    }
    Ok(())
}
