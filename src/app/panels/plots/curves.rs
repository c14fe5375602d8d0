//! Which diagrams there are, and what their curves show.

use super::super::super::clearance::ClearanceCurve;
use super::super::super::theme;
use super::diagram::{Curve, Diagram};
use crate::cell::Robot;
use crate::cell::collision::CLEARANCE_REACH_MM;
use crate::program::{Clearance, CurveSample, Timeline};
use crate::text::{Sentence as _, fixed, id, say};
use eframe::egui::Color32;

/// Six colours that colour-blind people tell apart (after Okabe and Ito).
const COLORS: [Color32; 6] = [
    Color32::from_rgb(46, 134, 222),
    Color32::from_rgb(230, 159, 0),
    Color32::from_rgb(0, 158, 115),
    Color32::from_rgb(204, 121, 167),
    Color32::from_rgb(86, 190, 233),
    Color32::from_rgb(213, 94, 0),
];

/// The diagrams of P2's Fig. 16, and those of what limits the motion.
pub(super) fn diagrams<'a>(timeline: &'a Timeline, samples: &[CurveSample]) -> Vec<Diagram<'a, CurveSample>> {
    let robot = timeline.robot();
    let six = |value: fn(&'a Robot, &CurveSample, usize) -> f64| -> Vec<Curve<'a, CurveSample>> {
        (0..6)
            .map(|i| Curve { name: joint(i), color: COLORS[i], value: Box::new(move |s| value(robot, s, i)) })
            .collect()
    };
    let margin_deg = samples.iter().map(|s| s.limit_margin_deg).fold(f64::INFINITY, f64::min);
    let (peak, which) = (0..6)
        .map(|i| (samples.iter().map(|s| share_of_full(robot, s, i).abs()).fold(0.0, f64::max), i))
        .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
    let singular = samples.iter().map(|s| s.singularity).fold(f64::INFINITY, f64::min);
    let limits = robot.limits_deg.iter().zip(COLORS).flat_map(|(l, color)| l.map(|deg| (deg, color)));
    let red = theme::WRONG;
    vec![
        Diagram {
            key: "joints",
            name: say!(plots_joints_name),
            title: say!(plots_joints, margin = fixed(margin_deg, 1)),
            curves: six(|_, s, i| s.joints_deg[i]),
            words: None,
            bounds: limits.collect(),
            decimals: 1,
            least: 10.0,
        },
        Diagram {
            key: "joint speeds",
            name: say!(plots_speeds_name),
            title: say!(plots_speeds, percent = fixed(peak, 0), joint = joint(which)),
            curves: six(share_of_full),
            words: None,
            bounds: vec![(100.0, red), (-100.0, red)],
            decimals: 0,
            least: 10.0,
        },
        Diagram {
            key: "flange angles",
            name: say!(plots_angles_name),
            title: say!(plots_angles),
            curves: vec![turn("RZ", 0, COLORS[0]), turn("RY", 1, COLORS[2]), turn("RX", 2, COLORS[5])],
            words: None,
            bounds: Vec::new(),
            decimals: 1,
            least: 10.0,
        },
        Diagram {
            key: "singularity",
            name: say!(plots_singularity_name),
            title: say!(plots_singularity, distance = fixed(singular, 2)),
            curves: vec![Curve { name: say!(plots_distance), color: COLORS[1], value: Box::new(|s| s.singularity) }],
            words: None,
            bounds: vec![(0.0, red)],
            decimals: 2,
            least: 0.2,
        },
    ]
}

/// The diagram of the clearance; empty while it is being measured.
pub(super) fn clearance_diagram(curve: Option<&ClearanceCurve>) -> Diagram<'static, Clearance> {
    let nearest = curve.iter().flat_map(|c| &c.samples).filter_map(|s| s.nearest.as_ref());
    let least = nearest.min_by(|a, b| a.0.total_cmp(&b.0));
    let title = match (curve, least) {
        (None, _) => say!(plots_clearance_none),
        (_, None) => say!(plots_clearance_beyond, reach = fixed(CLEARANCE_REACH_MM, 0)),
        (_, Some((mm, pair))) => say!(plots_clearance, least = fixed(*mm, 1), pair = pair.sentence()),
    };
    let mm = |s: &Clearance| s.nearest.as_ref().map_or(CLEARANCE_REACH_MM, |n| n.0);
    let words: fn(&Clearance) -> String = |s| match &s.nearest {
        Some((_, pair)) => pair.sentence(),
        None => say!(plots_or_more),
    };
    Diagram {
        key: "clearance",
        name: say!(plots_clearance_name),
        title,
        curves: vec![Curve { name: say!(plots_nearest), color: COLORS[2], value: Box::new(mm) }],
        words: Some(words),
        bounds: vec![(curve.map_or(0.0, |c| c.margin_mm), theme::WRONG)],
        decimals: 1,
        least: 10.0,
    }
}

/// One of the three angles of the flange, by its place among them.
fn turn(name: &str, place: usize, color: Color32) -> Curve<'static, CurveSample> {
    Curve { name: name.into(), color, value: Box::new(move |s| s.rz_ry_rx_deg[place]) }
}

/// Name of a joint, counted from 0.
fn joint(index: usize) -> String {
    say!(plots_joint, joint = id(index + 1))
}

fn share_of_full(robot: &Robot, s: &CurveSample, joint: usize) -> f64 {
    100.0 * s.speeds_deg_s[joint] / robot.speeds_deg_s[joint]
}
