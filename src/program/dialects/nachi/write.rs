//! NACHI programs as they are written.

use super::{numbered, templates};
use crate::cell::controllers::templates::{check_template, filled, fixed, text};
use crate::cell::controllers::{Nachi, NachiForm};
use crate::program::dialect::{Program, ProgramFile};
use crate::program::dialects::flange::{SHORTEST_S, printed};
use crate::program::dialects::subprograms::{moves, subprograms};
use crate::program::neutral::comment::Wording;
use crate::program::neutral::lines::{Move, ProgramLine};
use crate::program::neutral::steps::{Interpolation, MoveTiming};
use crate::program::write_error::WriteError;

/// The program, or a main program that calls subprograms.
pub fn write(program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
    let cell = &program.setup.cell;
    let nachi = &cell.nachi;
    templates(nachi).check()?;
    check_template("nachi.call", &nachi.call, &["n"])?;
    let mut main = templates(nachi).head(&program.head, program.wording);
    let subprograms = subprograms(&program.lines, cell.outputs.laser.number, nachi.max_moves as usize, moves);
    let file = |number: u32, mut lines: Vec<String>| {
        lines.push("END".into());
        ProgramFile { name: numbered(nachi, number), text: text(&lines, nachi.crlf) }
    };
    if let [only] = subprograms[..] {
        main.extend(subprogram_text(nachi, only, program.wording)?);
        return Ok(vec![file(nachi.number, main)]);
    }
    let numbers: Vec<u32> = (nachi.number + 1..).take(subprograms.len()).collect();
    if let Some(&last) = numbers.last().filter(|n| **n > 999) {
        return Err(WriteError::ProgramNumbers { number: nachi.number, subprograms: subprograms.len(), last });
    }
    main.extend(numbers.iter().map(|n| filled(&nachi.call, &[("n", &n.to_string())])));
    let mut files = vec![file(nachi.number, main)];
    for (number, subprogram) in numbers.iter().zip(subprograms) {
        files.push(file(*number, subprogram_text(nachi, subprogram, program.wording)?));
    }
    Ok(files)
}

fn subprogram_text(nachi: &Nachi, lines: &[ProgramLine], wording: Wording) -> Result<Vec<String>, WriteError> {
    let mut out = Vec::new();
    for line in lines {
        match line {
            ProgramLine::Move(m) => out.push(movex(nachi, m)?),
            _ => out.extend(templates(nachi).write(line, wording)?),
        }
    }
    Ok(out)
}

fn movex(nachi: &Nachi, m: &Move) -> Result<String, WriteError> {
    let interpolation = match m.interpolation {
        Interpolation::Joint => "P",
        Interpolation::Linear => "L",
    };
    let speed = match m.timing {
        MoveTiming::Seconds(s) => format!("T={}", fixed(s.max(SHORTEST_S), 4)),
        MoveTiming::Percent(p) => format!("R={}", fixed(p, 1)),
    };
    // Home is known by its joints, whatever the form.
    let pose = m.base_from_flange.filter(|_| nachi.form == NachiForm::Pose && m.part_from_focus.is_some());
    let (form, numbers) = match (pose.or(m.base_from_flange), &m.joints_deg) {
        (_, Some(joints)) if pose.is_none() => ("M1J", joints.map(|j| fixed(j, 4)).to_vec()),
        (Some(flange), _) => ("M1X", printed(&flange).to_vec()),
        (None, _) => return Err(WriteError::NoRobot("nachi")),
    };
    let (accuracy, tool) = (nachi.accuracy, nachi.tool);
    Ok(format!("MOVEX A={accuracy},AC=0,SM=0,{form},{interpolation},({}),{speed},H={tool},MS", numbers.join(",")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::Cell;
    use crate::cell::controllers::templates::{TemplateError, TemplateFault};
    use crate::program::dialects::nachi::file_name;

    #[test]
    fn the_file_name_follows_nachis_rule() {
        let cell = Cell::shipped("mz04").expect("valid");
        assert_eq!(file_name(&cell), "MZ04-01-A.001");
    }

    #[test]
    fn templates_that_cannot_work_are_refused() {
        let checked = |change: fn(&mut Nachi)| {
            let mut nachi = Nachi::default();
            change(&mut nachi);
            templates(&nachi).check()
        };
        assert_eq!(checked(|_| {}), Ok(()));
        assert_eq!(checked(|n| n.output_off = n.output_on.clone()), Err(WriteError::OffIsOn("nachi")));
        let lacks = |key: &str, template: &str, name| {
            let fault = TemplateFault::Lacks(name);
            Err(WriteError::Template(TemplateError { key: key.into(), template: template.into(), fault }))
        };
        assert_eq!(checked(|n| n.comment = "REM".into()), lacks("nachi.comment", "REM", "text"));
        assert_eq!(checked(|n| n.analogue = "AO {n}".into()), lacks("nachi.analogue", "AO {n}", "v"));
    }
}
