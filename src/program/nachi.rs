//! NACHI AX/FD text program (SLIM), one file: flange poses `M1X`, linear moves, `T=` for each.
//!
//! The time of a move is what sets the spot's speed on the part: the flange travels otherwise far
//! than the spot. Not verified on a controller: brackets of outputs, and the order of the file's
//! home moves; both are templates in the cell file.

use super::steps::{Station, Step, Steps};
use crate::cell::{Cell, rpy};
use nalgebra::Isometry3;
use std::fmt::Write as _;

/// Name of the program file, `<unit>-A.<3-digit number>`.
pub fn file_name(cell: &Cell) -> String {
    format!("{}-A.{:03}", cell.nachi.unit, cell.nachi.number)
}

/// The program's text, ASCII.
pub fn program(cell: &Cell, head: &[String], steps: &Steps) -> String {
    let mut out = Text { cell, text: String::new() };
    for line in head {
        out.say(line);
    }
    out.line(&cell.nachi.laser_off);
    out.home();
    let mut last_seconds = None;
    for step in &steps.list {
        match step {
            Step::Say(text) => out.say(text),
            Step::Laser(true) => out.line(&cell.nachi.laser_on),
            Step::Laser(false) => out.line(&cell.nachi.laser_off),
            Step::Go { to, seconds, .. } => {
                // From home the arm goes by joints: how far is not known here.
                out.go(to, last_seconds.is_some().then_some(*seconds));
                last_seconds = Some(*seconds);
            }
        }
    }
    out.line(&cell.nachi.laser_off);
    out.home();
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

    fn home(&mut self) {
        let joints: Vec<String> = self.cell.air.home_joints_deg.iter().map(|j| fixed(*j, 4)).collect();
        self.movex("M1J", "P", &joints, &format!("R={}", fixed(self.cell.air.home_percent, 1)));
    }

    fn go(&mut self, to: &Station, seconds: Option<f64>) {
        let numbers = numbers(&self.cell.flange_for(&to.frame()));
        match seconds {
            // T=0 would ask for infinite speed.
            Some(s) => self.movex("M1X", "L", &numbers, &format!("T={}", fixed(s.max(0.001), 4))),
            None => self.movex("M1X", "P", &numbers, &format!("R={}", fixed(self.cell.air.home_percent, 1))),
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

/// Fixed decimals, '.' always, never `-0.000`.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| matches!(b, b'0' | b'.')) => rest.into(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn never_minus_zero() {
        assert_eq!(fixed(-0.00004, 4), "0.0000");
        assert_eq!(fixed(-0.00006, 4), "-0.0001");
        assert_eq!(fixed(12.0, 3), "12.000");
    }

    #[test]
    fn the_file_name_follows_nachis_rule() {
        let cell = Cell::shipped().expect("valid");
        assert_eq!(file_name(&cell), "MZ04-01-A.001");
    }
}
