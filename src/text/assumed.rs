//! What a plan takes for granted: frames, words and figures that nobody has measured or tried.

use super::{listed, say};
use crate::planning::report::PlanFinding;

/// A row for each: what it is, and which.
pub(crate) fn assumed(findings: &[PlanFinding]) -> Vec<Vec<String>> {
    let told = |finding: &PlanFinding| match finding {
        PlanFinding::UnverifiedFrame { cell, frames } => {
            Some(vec![say!(page_frames_unmeasured, cell), listed(frames.iter().map(|f| (*f).to_owned()))])
        }
        PlanFinding::UnverifiedWord { words, .. } => {
            Some(vec![say!(page_words_unchecked), listed(words.iter().cloned())])
        }
        _ => None,
    };
    let rows: Vec<Vec<String>> = findings.iter().filter_map(told).collect();
    if rows.is_empty() { vec![vec![say!(page_nothing_assumed)]] } else { rows }
}
