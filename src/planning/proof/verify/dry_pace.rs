//! How fast a dry run may be. Its speeds are so low that some controllers write them with one digit: that is no fault, as
//! long as no move is faster than in the program itself.

use super::likeness::is_same_pace;
use crate::program::dialect::{ReadLine, Statement};
use crate::program::{DRY_RUN_PERCENT, MoveTiming, ProgramLine};

/// Gives the moves of a dry run the times that its dialect's words make of them, as far as they may have them. `written`:
/// the dry run as it is written, and read again.
pub(super) fn take_written_pace(lines: &mut [ProgramLine], written: &[ReadLine]) {
    let moves = lines.iter_mut().filter_map(|l| if let ProgramLine::Move(m) = l { Some(m) } else { None });
    let written = written.iter().filter_map(|l| if let Statement::Move(m) = &l.what { Some(m.timing) } else { None });
    for (m, timing) in moves.zip(written) {
        if let (MoveTiming::Seconds(dry_s), MoveTiming::Seconds(written_s)) = (m.timing, timing) {
            let program_s = dry_s * DRY_RUN_PERCENT / 100.0;
            if written_s >= program_s || is_same_pace(&MoveTiming::Seconds(program_s), &timing) {
                m.timing = timing;
            }
        }
    }
}
