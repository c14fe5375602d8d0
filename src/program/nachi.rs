//! NACHI AX/FD text program (SLIM): `MOVEX` with joints (`M1J`) or flange poses (`M1X`), and the
//! time `T=` of each move.
//!
//! The time is what sets the spot's speed on the part: the flange travels otherwise far than the
//! spot. Not verified on a controller: brackets of outputs, how long a program may be, and how many
//! decimals are kept; the cell file has them. The reader is in `nachi_reader`.

use super::dialect::{Dialect, Program, ProgramFile, ReadError, ReadLine, Reading, WriteError};
use super::lines::{Line, Move};
use super::nachi_reader;
use super::pages::{moves, pages};
use super::steps::{Pace, Way};
use crate::cell::Cell;
use crate::cell::controllers::words::{check_template, filled, fixed, plain, text};
use crate::cell::controllers::{Nachi as Words, NachiForm};
use crate::part::rpy;
use nalgebra::Isometry3;

/// The dialect.
pub struct Nachi;

/// Name of the program file, `<unit>-A.<3-digit number>`.
pub fn file_name(cell: &Cell) -> String {
    numbered(&cell.nachi, cell.nachi.number)
}

fn numbered(words: &Words, number: u32) -> String {
    format!("{}-A.{number:03}", words.unit)
}

impl Dialect for Nachi {
    fn name(&self) -> &'static str {
        "nachi"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        let cell = &program.setup.cell;
        let words = &cell.nachi;
        check(words)?;
        let head: Vec<String> = program.head.iter().map(|t| said(words, t)).collect();
        let pages = pages(&program.lines, cell.outputs.laser.number, words.max_moves as usize, moves);
        let file = |number: u32, mut lines: Vec<String>| {
            lines.push("END".into());
            ProgramFile { name: numbered(words, number), text: text(&lines, words.crlf) }
        };
        if let [only] = pages[..] {
            return Ok(vec![file(words.number, head.into_iter().chain(written(words, only)?).collect())]);
        }
        let numbers: Vec<u32> = (words.number + 1..).take(pages.len()).collect();
        if let Some(last) = numbers.last().filter(|n| **n > 999) {
            return Err(WriteError::Rule(format!(
                "nachi.number = {}: {} sub-programs would go up to {last}, and 999 is the last; \
                 give a lower number, or raise nachi.max_moves",
                words.number,
                pages.len()
            )));
        }
        let calls = numbers.iter().map(|n| filled(&words.call, &[("n", &n.to_string())]));
        let mut files = vec![file(words.number, head.into_iter().chain(calls).collect())];
        for (number, page) in numbers.iter().zip(pages) {
            files.push(file(*number, written(words, page)?));
        }
        Ok(files)
    }

    fn claims(&self, text: &str) -> bool {
        text.lines().any(|l| l.trim_start().starts_with("MOVEX ") || l.trim_start().starts_with("CALLP "))
    }

    fn read(&self, file: &ProgramFile, reading: &Reading<'_>) -> Result<Vec<ReadLine>, ReadError> {
        nachi_reader::read(file, reading)
    }
}

/// Whether the templates can be written and told apart.
fn check(words: &Words) -> Result<(), WriteError> {
    let levels = [("nachi.analogue", &words.analogue), ("nachi.group", &words.group)];
    for (name, template) in levels.into_iter().filter(|(_, t)| !t.is_empty()) {
        check_template(name, template, &["n", "v"])?;
    }
    check_template("nachi.output_on", &words.output_on, &["n"])?;
    check_template("nachi.output_off", &words.output_off, &["n"])?;
    check_template("nachi.wait", &words.wait, &["s"])?;
    check_template("nachi.call", &words.call, &["n"])?;
    check_template("nachi.comment", &words.comment, &["text"])?;
    if words.output_on == words.output_off {
        return Err(WriteError::Rule(
            "nachi.output_off is the same as nachi.output_on; the laser would stay on".into(),
        ));
    }
    Ok(())
}

fn said(words: &Words, text: &str) -> String {
    filled(&words.comment, &[("text", &plain(text, &['"']))])
}

fn written(words: &Words, lines: &[Line]) -> Result<Vec<String>, WriteError> {
    lines.iter().map(|line| one(words, line)).collect()
}

fn one(words: &Words, line: &Line) -> Result<String, WriteError> {
    match line {
        Line::Say(text) => Ok(said(words, text)),
        Line::Output { number, on } => {
            let template = if *on { &words.output_on } else { &words.output_off };
            Ok(filled(template, &[("n", &number.to_string())]))
        }
        Line::Level { number, value, group } => {
            let (name, template) =
                if *group { ("nachi.group", &words.group) } else { ("nachi.analogue", &words.analogue) };
            if template.is_empty() {
                return Err(WriteError::Rule(format!(
                    "{name} is empty, and outputs.power needs it; give the controller's line with {{n}} and {{v}}"
                )));
            }
            let value = fixed(*value, if *group { 0 } else { 3 });
            Ok(filled(template, &[("n", &number.to_string()), ("v", &value)]))
        }
        Line::Wait(seconds) => Ok(filled(&words.wait, &[("s", &fixed(*seconds, 3))])),
        Line::Move(m) => go(words, m),
    }
}

fn go(words: &Words, m: &Move) -> Result<String, WriteError> {
    let way = match m.way {
        Way::Joint => "P",
        Way::Linear => "L",
    };
    let speed = match m.pace {
        // T=0 would ask for infinite speed.
        Pace::Seconds(s) => format!("T={}", fixed(s.max(0.001), 4)),
        Pace::Percent(p) => format!("R={}", fixed(p, 1)),
    };
    // Home is known by its joints, whatever the form.
    let pose = m.base_from_flange.filter(|_| words.form == NachiForm::Pose && m.part_from_focus.is_some());
    let (form, numbers) = match (pose.or(m.base_from_flange), &m.joints_deg) {
        (_, Some(joints)) if pose.is_none() => ("M1J", joints.map(|j| fixed(j, 4)).to_vec()),
        (Some(flange), _) => ("M1X", numbers(&flange)),
        (None, _) => return Err(WriteError::NoRobot("NACHI")),
    };
    let (accuracy, tool) = (words.accuracy, words.tool);
    Ok(format!("MOVEX A={accuracy},AC=0,SM=0,{form},{way},({}),{speed},H={tool},MS", numbers.join(",")))
}

/// X, Y, Z in mm with 3 decimals, RZ, RY, RX in degrees with 4: 2 decimals of a degree would cost
/// 0.16 mm at 650 mm.
fn numbers(base_from_flange: &Isometry3<f64>) -> Vec<String> {
    let position = base_from_flange.translation.vector.iter().map(|v| fixed(*v, 3));
    let angles = rpy::from_rotation(&base_from_flange.rotation.to_rotation_matrix());
    position.chain(angles.into_iter().map(|a| fixed(a, 4))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::controllers::words::TemplateFault;

    #[test]
    fn the_file_name_follows_nachis_rule() {
        let cell = Cell::shipped("mz04").expect("valid");
        assert_eq!(file_name(&cell), "MZ04-01-A.001");
    }

    #[test]
    fn templates_that_cannot_work_are_refused() {
        let words = |change: fn(&mut Words)| {
            let mut words = Words::default();
            change(&mut words);
            check(&words)
        };
        assert_eq!(words(|_| {}), Ok(()));
        let refused = |refused: Result<(), WriteError>| match refused.expect_err("refused") {
            WriteError::Template(e) => (e.key, e.fault),
            other => panic!("{other}"),
        };
        let same = words(|w| w.output_off = w.output_on.clone());
        assert!(same.is_err_and(|e| matches!(e, WriteError::Rule(said) if said.contains("stay on"))));
        let lacks = |key: &str, name| (key.to_owned(), TemplateFault::Lacks(name));
        assert_eq!(refused(words(|w| w.comment = "REM".into())), lacks("nachi.comment", "text"));
        assert_eq!(refused(words(|w| w.analogue = "AO {n}".into())), lacks("nachi.analogue", "v"));
    }
}
