//! A table of the program for whatever reads tables: `program.csv`, one row a line of the program, its conventions in
//! its own head.

mod read;
mod write;

use super::pace;
use crate::cell::controllers::templates::non_blank_lines;
use crate::cell::{Cell, Setup};
use crate::program::dialect::{Dialect, Program, ProgramFile, ReadContext, ReadLine};
use crate::program::neutral::lines::ProgramLine;
use crate::program::neutral::steps::MoveTiming;
use crate::program::neutral::variant::Variant;
use crate::program::read_error::ReadError;
use crate::program::write_error::WriteError;

/// The dialect.
pub struct CsvDialect;

/// What the numbers mean; a reader that finds other words here must not take the numbers.
const CONVENTIONS: [&str; 10] = [
    "# clearbeam program, format 1",
    "# lengths in mm, angles in degrees, times in s, '.' decimals, one row a line of the program, in order",
    "# what: move, output, analogue, group, wait or say; way: joint (all joints in proportion) or linear",
    "# x y z qw qx qy qz: the flange in the robot's base",
    "# fx fy fz fqw fqx fqy fqz: the focus in the part; its z points along the beam against the light, its y along the travel",
    "# rotations: unit quaternions, scalar first, that turn vectors of the frame named first into the second; no Euler angles (those of the cell file are Rz*Ry*Rx)",
    "# j1 to j6: as in the robot file; empty without a robot",
    "# seconds: duration of the move; percent: share of the joints' full speed; one of them is given",
    "# laser: 1 if the move is made with the laser on",
    "# number, value: an output and 1 or 0, an analogue output or a group and its level; of a wait the value is its seconds",
];
/// The columns.
const COLUMNS: &str = "index,what,way,x,y,z,qw,qx,qy,qz,fx,fy,fz,fqw,fqx,fqy,fqz,\
                                  j1,j2,j3,j4,j5,j6,seconds,percent,laser,number,value,text";
/// How many.
const COUNT: usize = 29;
/// What the last line begins with; the number of rows follows.
const END: &str = "# end of rows: ";

impl Dialect for CsvDialect {
    fn name(&self) -> &'static str {
        "csv"
    }

    fn write(&self, program: &Program<'_>) -> Result<Vec<ProgramFile>, WriteError> {
        Ok(vec![write::write(program)])
    }

    fn rename(&self, cell: &mut Cell, variant: Variant) {
        cell.csv.name = variant.name(&cell.csv.name, 32);
    }

    fn paces(&self, lines: &[ProgramLine], _setup: &Setup) -> Vec<MoveTiming> {
        pace::each(lines, |m| match m.timing {
            MoveTiming::Seconds(s) => MoveTiming::Seconds(pace::at_least(s, 9)),
            percent @ MoveTiming::Percent(_) => percent,
        })
    }

    /// A table: no controller has words for it.
    fn unverified(&self, _setup: &Setup) -> Vec<&'static str> {
        Vec::new()
    }

    fn claims(&self, text: &str) -> bool {
        non_blank_lines(text).next().is_some_and(|(_, l)| l == CONVENTIONS[0])
    }

    fn read(&self, file: &ProgramFile, reading: &ReadContext<'_>) -> Result<Vec<ReadLine>, ReadError> {
        read::read(file, reading)
    }
}
