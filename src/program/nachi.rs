//! NACHI AX/FD text program (SLIM), one file: flange poses `M1X`, linear moves, `T=` for each.
//!
//! The time of a move is what sets the spot's speed on the part: the flange travels otherwise far
//! than the spot. Not verified on a controller: brackets of outputs, and the order of the file's
//! home moves; both are templates in the cell file.

use super::dialect::Program;
use super::lines::{Line, Move};
use super::steps::{Pace, Way};
use super::words::fixed;
use crate::cell::{Cell, rpy};
use nalgebra::Isometry3;
use std::fmt::Write as _;

/// Name of the program file, `<unit>-A.<3-digit number>`.
pub fn file_name(cell: &Cell) -> String {
    format!("{}-A.{:03}", cell.nachi.unit, cell.nachi.number)
}

/// The program's text, ASCII.
pub fn program(program: &Program<'_>) -> String {
    let mut out = Text { cell: &program.setup.cell, text: String::new() };
    for line in &program.head {
        out.say(line);
    }
    for line in &program.lines {
        match line {
            Line::Say(text) => out.say(text),
            Line::Output { number, on } => {
                let n = &out.cell.nachi;
                let template = if *on { &n.output_on } else { &n.output_off };
                let line = template.replace("{n}", &number.to_string());
                out.line(&line);
            }
            Line::Level { .. } => {}
            Line::Wait(seconds) => {
                let line = out.cell.nachi.wait.replace("{s}", &fixed(*seconds, 2));
                out.line(&line);
            }
            Line::Move(m) => out.go(m),
        }
    }
    out.line("END");
    out.text
}

struct Text<'a> {
    cell: &'a Cell,
    text: String,
}

impl Text<'_> {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push_str(if self.cell.nachi.crlf { "\r\n" } else { "\n" });
    }

    fn say(&mut self, text: &str) {
        let plain: String =
            text.chars().map(|c| if c.is_ascii_graphic() && c != '"' || c == ' ' { c } else { '?' }).collect();
        self.line(&self.cell.nachi.comment.replace("{text}", &plain));
    }

    fn go(&mut self, m: &Move) {
        let way = match m.way {
            Way::Joint => "P",
            Way::Linear => "L",
        };
        let speed = match m.pace {
            // T=0 would ask for infinite speed.
            Pace::Seconds(s) => format!("T={}", fixed(s.max(0.001), 4)),
            Pace::Percent(p) => format!("R={}", fixed(p, 1)),
        };
        match (&m.joints_deg, &m.base_from_flange) {
            (Some(joints), _) => {
                let joints: Vec<String> = joints.iter().map(|j| fixed(*j, 4)).collect();
                self.movex("M1J", way, &joints, &speed);
            }
            (None, Some(flange)) => self.movex("M1X", way, &numbers(flange), &speed),
            (None, None) => {}
        }
    }

    fn movex(&mut self, form: &str, way: &str, numbers: &[String], speed: &str) {
        let n = &self.cell.nachi;
        let mut line = String::new();
        let _ = write!(
            line,
            "MOVEX A={},AC=0,SM=0,{form},{way},({}),{speed},H={},MS",
            n.accuracy,
            numbers.join(","),
            n.tool
        );
        self.line(&line);
    }
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

    #[test]
    fn the_file_name_follows_nachis_rule() {
        let cell = Cell::shipped("mz04").expect("valid");
        assert_eq!(file_name(&cell), "MZ04-01-A.001");
    }
}
