//! The tables of a plan: `path.csv` and `joints.csv`, one row a target.

use crate::cell::motion::Choice;
use crate::planning::plan::Plan;
use crate::program::Timeline;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// `path.csv`: one row a target.
pub fn path_csv(plan: &Plan) -> String {
    let mut out = String::from(
        "pass,point,surface,laser,state,px,py,pz,nx,ny,nz,ax,ay,az,ox,oy,oz,x,y,z,tilt_deg,clearance_mm\n",
    );
    for (number, pass) in plan.passes.iter().enumerate() {
        for (point, t) in pass.targets.iter().enumerate() {
            let _ = write!(out, "{number},{point},{},{},{}", pass.surface, u8::from(t.laser), t.state.word());
            let focus = t.focus(pass.settings.defocus_mm);
            let vectors = [&t.p.coords, &t.n, &t.a, &t.o, &focus.coords];
            for value in vectors.into_iter().flat_map(|v| v.iter()).chain([&t.tilt_deg()]) {
                out.push(',');
                push_number(&mut out, *value);
            }
            out.push(',');
            if let Some(mm) = t.clearance_mm {
                push_number(&mut out, mm);
            }
            out.push('\n');
        }
    }
    out
}

/// `joints.csv`: one row for each target that the robot does.
pub(super) fn joints_csv(plan: &Plan, choice: &Choice) -> String {
    let mut out = String::from("pass,point,laser,j1,j2,j3,j4,j5,j6,spin_deg,time_s,singularity,min_limit_margin_deg\n");
    let stops = plan.timeline.iter().flat_map(Timeline::stops);
    let times: BTreeMap<(usize, usize), f64> = stops.filter_map(|s| s.target.map(|t| (t, s.at_s))).collect();
    let mut at_s = 0.0;
    for (number, pass) in plan.passes.iter().enumerate() {
        for (point, t) in pass.targets.iter().enumerate() {
            let Some(c) = &choice.rows[number][point] else { continue };
            // A target between two blocked ones is reachable, but no lit move goes there.
            at_s = times.get(&(number, point)).copied().unwrap_or(at_s);
            let _ = write!(out, "{number},{point},{}", u8::from(t.laser));
            for value in c.joints_deg.iter().chain([&c.spin_deg]) {
                out.push(',');
                push_number(&mut out, *value);
            }
            for value in [at_s, c.singularity, c.limit_margin_deg] {
                out.push(',');
                push_number(&mut out, value);
            }
            out.push('\n');
        }
    }
    out
}

/// Eleven decimals without the zeros at the end: at least nine significant digits for every
/// number that is not below a hundredth.
fn push_number(out: &mut String, value: f64) {
    let start = out.len();
    let _ = write!(out, "{value:.11}");
    while out.ends_with('0') {
        out.pop();
    }
    if out.ends_with('.') {
        out.pop();
    }
    if &out[start..] == "-0" {
        out.replace_range(start.., "0");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_nine_digits_and_no_minus_zero() {
        let text = |v: f64| {
            let mut s = String::from("x,");
            push_number(&mut s, v);
            s
        };
        assert_eq!(text(35.2), "x,35.2");
        assert_eq!(text(-1e-14), "x,0");
        assert_eq!(text(1.0 / 3.0), "x,0.33333333333");
        assert_eq!(text(100.0), "x,100");
    }
}
