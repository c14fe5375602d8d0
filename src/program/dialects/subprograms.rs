//! A long program in subprograms: cut only where the laser is off, because a call
//! takes the controller a moment that the spot must not spend burning.

use crate::program::neutral::lines::ProgramLine;

/// Cuts lines into subprograms of at most `most` by `count`. A lit piece that is longer stays whole, and
/// so does the subprogram that holds it.
pub fn subprograms(
    lines: &[ProgramLine],
    laser: u32,
    most: usize,
    count: impl Fn(&ProgramLine) -> usize,
) -> Vec<&[ProgramLine]> {
    let mut out = Vec::new();
    let (mut lit, mut start, mut cut) = (false, 0, 0);
    // Counted since `start`, and of that up to `cut`.
    let (mut sum, mut before_cut) = (0, 0);
    for (i, line) in lines.iter().enumerate() {
        // A dry run is cut where its program is.
        lit |= matches!(line, ProgramLine::Move(m) if m.at_work);
        if !lit {
            (cut, before_cut) = (i, sum);
        }
        sum += count(line);
        if sum > most && cut > start {
            out.push(&lines[start..cut]);
            sum -= before_cut;
            (start, before_cut) = (cut, 0);
        }
        if let ProgramLine::Output { number, on } = line
            && *number == laser
        {
            lit = *on;
        }
    }
    out.push(&lines[start..]);
    out
}

/// Counts moves.
pub fn moves(line: &ProgramLine) -> usize {
    usize::from(matches!(line, ProgramLine::Move(_)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Comment;
    use proptest::prelude::*;

    fn count(line: &ProgramLine) -> usize {
        usize::from(matches!(line, ProgramLine::Comment(_)))
    }

    proptest! {
        #[test]
        fn subprograms_hold_everything_and_never_cut_a_lit_piece(
            kinds in prop::collection::vec(0..5u32, 0..60), most in 1..9usize
        ) {
            let lines: Vec<ProgramLine> = kinds
                .iter()
                .map(|k| match k {
                    0 => ProgramLine::Output { number: 3, on: true },
                    1 => ProgramLine::Output { number: 3, on: false },
                    2 => ProgramLine::Output { number: 4, on: true },
                    _ => ProgramLine::Comment(Comment::Part(String::new())),
                })
                .collect();
            let subprograms = subprograms(&lines, 3, most, count);
            prop_assert_eq!(&subprograms.concat(), &lines);
            let mut lit = false;
            for subprogram in &subprograms {
                prop_assert!(!lit, "a subprogram begins dark");
                for line in *subprogram {
                    if let ProgramLine::Output { number: 3, on } = line {
                        lit = *on;
                    }
                }
                let is_on = |l: &ProgramLine| matches!(l, ProgramLine::Output { number: 3, on: true });
                if subprogram.iter().map(count).sum::<usize>() > most {
                    prop_assert!(is_on(&subprogram[0]), "only a lit piece makes a subprogram too long");
                    let off = subprogram.iter().position(|l| matches!(l, ProgramLine::Output { number: 3, on: false }));
                    prop_assert!(off.is_none_or(|i| i + 1 == subprogram.len()), "and then stands alone in it");
                }
            }
        }
    }
}
