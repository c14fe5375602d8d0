//! Why a target is left out, in the words of the time strip and of the numbers of the target.

use super::super::super::context::Context;
use crate::planning::report::Problem;
use crate::text::{Sentence as _, id, say};

/// Why a target is left out: pass and point.
pub(in super::super) fn why_left_out(context: Context<'_>, (pass, point): (usize, usize)) -> String {
    let problems = context.derived.plan().into_iter().flat_map(|of| &of.report.problems);
    let mut found = problems.filter(|p| p.pass == Some(pass) && p.point == Some(point));
    found.next().map_or_else(|| say!(problems_left_out), because)
}

fn because(problem: &Problem) -> String {
    if let Some(why) = &problem.why {
        return why.sentence();
    }
    match (problem.by_surface, problem.by_facet) {
        (Some(surface), Some(facet)) => say!(problems_beam_hits, surface = id(surface), facet = id(facet)),
        _ => say!(problems_beam_hits_something),
    }
}
