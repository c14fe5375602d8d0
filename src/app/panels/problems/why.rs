//! Why a target is left out, in the words of the time strip and of the numbers of the target.

use super::super::super::context::Context;
use crate::cell::motion::RefusalCause;
use crate::planning::report::{NotDone, Problem};
use crate::text::{Sentence as _, id, say};

/// Why a target is left out: pass and point.
pub(in super::super) fn why_left_out(context: Context<'_>, (pass, point): (usize, usize)) -> String {
    let problems = context.derived.plan().into_iter().flat_map(|of| &of.report.problems);
    let mut found = problems.filter(|p| p.pass == Some(pass) && p.point == Some(point));
    let grinds = context.document.job().weld.is_there();
    found.next().map_or_else(|| say!(problems_left_out), |problem| because(problem, grinds))
}

fn because(problem: &Problem, grinds: bool) -> String {
    if let Some(why) = &problem.why {
        return why.sentence();
    }
    let met = problem.by_surface.zip(problem.by_facet).map(|(surface, facet)| (id(surface), id(facet)));
    let is_head = problem.cause == NotDone::Blocked(RefusalCause::Head);
    match (met, grinds, is_head) {
        (Some((surface, facet)), true, _) => say!(problems_tool_hits, surface, facet),
        (Some((surface, facet)), false, true) => say!(problems_head_hits, surface, facet),
        (Some((surface, facet)), false, false) => say!(problems_beam_hits, surface, facet),
        (None, true, _) => say!(problems_tool_hits_something),
        (None, false, true) => say!(problems_head_hits_something),
        (None, false, false) => say!(problems_beam_hits_something),
    }
}
