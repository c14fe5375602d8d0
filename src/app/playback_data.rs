//! What is needed to watch a plan: the program over time, its curves, the trail on the part, and the program's text
//! with the line of each move. Made on a thread, once for each plan.

use crate::cell::Setup;
use crate::picture::Trail;
use crate::planning::{Plan, PlannedJob, export};
use crate::pose::TargetState;
use crate::program::dialect::{ReadContext, Statement};
use crate::program::{CurveSample, ProgramFile, ProgramLine, Timeline, curves, dialects, lines};
use crate::progress::{Cancelled, Progress};
use crate::text::{Sentence as _, program_comment};
use std::collections::BTreeMap;

/// What the window plays back of a plan.
pub struct PlaybackData {
    /// Without a robot nothing is known of times.
    pub timeline: Option<Timeline>,
    /// Curves over the timeline.
    pub curves: Vec<CurveSample>,
    /// Where the spot goes.
    pub trail: Option<Trail>,
    /// Number of the move that ends at a target: of those with the same target, the first.
    pub move_to: BTreeMap<(usize, usize), usize>,
    /// The program as it would be written.
    pub text: Vec<TextFile>,
    /// Where on the timeline something is left out.
    pub marks: Vec<Mark>,
    /// Why there is no text.
    pub why_none: Option<String>,
    /// File and line, from 0, of each move.
    pub line_of_move: Vec<(usize, usize)>,
}

/// A run of neighbouring targets that are left out, at the time at which they would come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mark {
    /// The move before them.
    pub after: Option<usize>,
    /// The first of them: pass and point.
    pub first: (usize, usize),
    /// How many.
    pub count: usize,
}

/// A file of the program.
pub struct TextFile {
    /// Its name.
    pub name: String,
    text: String,
    /// Where each line begins.
    starts: Vec<usize>,
}

impl TextFile {
    fn new(name: String, text: String) -> TextFile {
        let starts = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1));
        let starts = starts.filter(|&at| at < text.len()).collect();
        TextFile { name, text, starts }
    }

    /// Number of lines.
    pub fn count(&self) -> usize {
        self.starts.len()
    }

    /// A line without its end.
    pub fn line(&self, number: usize) -> &str {
        let Some(&from) = self.starts.get(number) else { return "" };
        self.text[from..].lines().next().unwrap_or_default()
    }
}

impl PlaybackData {
    /// Everything of a plan.
    ///
    /// # Errors
    /// [`Cancelled`] when `progress` says so.
    pub fn new(of: &PlannedJob, part_name: &str, progress: &Progress) -> Result<PlaybackData, Cancelled> {
        let PlannedJob { job, setup, plan, report, .. } = of;
        let timeline = plan.timeline.clone();
        let moves = lines(&plan.steps, setup).into_iter().filter_map(|l| match l {
            ProgramLine::Move(m) => Some(m.target),
            _ => None,
        });
        let mut move_to = BTreeMap::new();
        for (number, target) in moves.enumerate() {
            if let Some(target) = target {
                move_to.entry(target).or_insert(number);
            }
        }
        let marks = marks(plan, &move_to);
        progress.check()?;
        let (files, why_none) = match export::program(job, part_name, setup, plan, report, program_comment) {
            Ok(files) => (files, None),
            Err(why) => (Vec::new(), Some(why.sentence())),
        };
        progress.check()?;
        let line_of_move = lines_of_moves(&files, setup, &job.cell.dialect);
        progress.check()?;
        let text = files.into_iter().map(|f| TextFile::new(f.name, f.text)).collect();
        let curves = timeline.as_ref().map(curves).unwrap_or_default();
        progress.check()?;
        Ok(PlaybackData {
            curves,
            trail: timeline.as_ref().map(|t| Trail::new(t, &plan.passes, of.picture_key())),
            timeline,
            move_to,
            marks,
            line_of_move,
            text,
            why_none,
        })
    }

    /// When a target is reached; for one that is left out, when the last before it is.
    pub fn time_of(&self, target: (usize, usize)) -> f64 {
        let number = before(&self.move_to, target);
        let stop = number.and_then(|n| self.timeline.as_ref()?.stops().get(n));
        stop.map_or(0.0, |s| s.at_s)
    }

    /// The line of the program that is being done: at a time, or without one at a target.
    pub fn current_line(&self, time_s: f64, target: (usize, usize)) -> Option<(usize, usize)> {
        let number = match &self.timeline {
            Some(t) => Some(t.stop_at(time_s)),
            None => before(&self.move_to, target),
        };
        self.line_of_move.get(number?).copied()
    }

    /// The move that a line of a file is, or the next one after it.
    pub fn move_of_line(&self, place: (usize, usize)) -> Option<usize> {
        // A main program calls others between its own lines: the moves do not go from file to file.
        self.line_of_move.iter().position(|p| p.0 == place.0 && p.1 >= place.1)
    }
}

/// The move that ends at a target, or for one that is left out, at the last before it.
fn before(move_to: &BTreeMap<(usize, usize), usize>, target: (usize, usize)) -> Option<usize> {
    move_to.range(..=target).next_back().map(|(_, number)| *number)
}

/// Runs of targets that are left out.
fn marks(plan: &Plan, move_to: &BTreeMap<(usize, usize), usize>) -> Vec<Mark> {
    let mut out: Vec<Mark> = Vec::new();
    for (number, pass) in plan.passes.iter().enumerate() {
        for (point, _) in pass.targets.iter().enumerate().filter(|(_, t)| t.state == TargetState::Blocked) {
            let (first, after) = ((number, point), before(move_to, (number, point)));
            match out.last_mut() {
                Some(m) if m.after == after && m.first.0 == number => m.count += 1,
                _ => out.push(Mark { after, first, count: 1 }),
            }
        }
    }
    out
}

/// File and line of each move, as the dialect's own reader finds them.
fn lines_of_moves(files: &[ProgramFile], setup: &Setup, dialect: &str) -> Vec<(usize, usize)> {
    let number = |name: &str| files.iter().position(|f| f.name == name);
    let open = |name: &str| files.get(number(name)?).map(|f| f.text.clone());
    let (Some(first), Some(dialect)) = (files.first(), dialects::by_name(dialect)) else { return Vec::new() };
    let read = dialect.read(first, &ReadContext { setup, open: &open }).unwrap_or_default();
    let moves = read.iter().filter(|l| matches!(l.what, Statement::Move(_)));
    moves.filter_map(|l| Some((number(&l.file)?, l.line.saturating_sub(1)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_cut_whatever_their_ends() {
        let file = TextFile::new("a".into(), "REM \"x\"\r\nMOVEX A=1\r\n\nEND\n".into());
        let all: Vec<&str> = (0..file.count()).map(|i| file.line(i)).collect();
        assert_eq!(all, ["REM \"x\"", "MOVEX A=1", "", "END"]);
        assert_eq!(file.line(99), "");
    }

    #[test]
    fn moves_are_found_where_they_are_called() {
        let move_line = "MOVEX A=1,AC=0,SM=0,M1J,P,(0,90,0,0,0,0),R=10.0,H=1,MS";
        let file = |name: &str, text: String| ProgramFile { name: name.into(), text };
        let files = [
            file("MZ04-01-A.001", "REM \"x\"\nCALLP 2\nEND\n".into()),
            file("MZ04-01-A.002", format!("REM \"y\"\n{move_line}\nEND\n")),
        ];
        let setup = Setup::shipped().expect("shipped");
        assert_eq!(lines_of_moves(&files, &setup, "nachi"), [(1, 1)]);
    }
}
