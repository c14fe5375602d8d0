//! An arm against itself: a fold in closed form, which pairs count, and bodies of facets beside their capsules.

use super::*;
use crate::beam::Tool;
use crate::cell::collision::{CLEARANCE_REACH_MM, Collision, Contact};
use crate::cell::robot::meshed;
use crate::cell::{Cell, Mount, Setup};
use crate::part::{Part, Placement, Units};
use crate::sample::{solids, stl_bytes};
use proptest::prelude::*;
use std::ops::ControlFlow;

/// An arm that carries nothing and stands alone.
fn alone(robot: Robot) -> Setup {
    let mut cell = Cell::shipped("mz04").expect("shipped");
    cell.bodies = Default::default();
    cell.base_from_part.position_mm = [1e4, 0.0, 0.0];
    Setup { cell, robot: Some(robot), mount: Mount::ToolInHand, tool: Tool::default() }
}

fn shipped(key: &str) -> Robot {
    Robot::load(key, None).expect("shipped")
}

fn part() -> Part {
    let bytes = stl_bytes(&solids::cube(20.0));
    Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]).expect("a part")
}

/// The forearm of the MZ04 is folded down beside its upright upper arm. Elbow and shoulder stand 260 mm apart, so the
/// shoulder is 260·sin φ from the axis of the forearm, φ being the angle between the two; the forearm's axis, from
/// elbow to wrist, leans against joint 3 by atan(25 / 280).
fn folded(phi_deg: f64) -> Joints {
    let lean_deg = libm::atan2(25.0, 280.0).to_degrees();
    [0.0, 90.0, 90.0 - (180.0 - phi_deg + lean_deg), 0.0, 0.0, 0.0]
}

#[test]
fn a_forearm_folds_until_it_meets_the_shoulder() {
    let mut robot = shipped("mz04");
    // The column ends in the shoulder, and the thicker of the two is met first.
    for (base_mm, shoulder_mm, met) in [(85.0, 75.0, Link::Base), (20.0, 75.0, Link::Shoulder)] {
        (robot.links.base_mm, robot.links.shoulder_mm) = (base_mm, shoulder_mm);
        for margin_mm in [5.0, 2.0, 50.0] {
            let mut setup = alone(robot.clone());
            setup.cell.bodies.margin_mm = margin_mm;
            let part = part();
            let collision = Collision::new(&setup, &part).expect("a robot");
            // However wide the margin is, links of one arm keep 5 mm.
            let apart = base_mm.max(shoulder_mm) + robot.links.forearm_mm + f64::min(margin_mm, 5.0);
            let phi_deg = libm::asin(apart / 260.0).to_degrees();
            let contact = Contact { a: BodyId::Link(Link::Forearm), b: BodyId::Link(met) };
            assert_eq!(collision.first_contact(&folded(phi_deg + 0.001)), None, "{met:?}, {margin_mm} mm");
            assert_eq!(collision.first_contact(&folded(phi_deg - 0.001)), Some(contact.clone()));
            let (mm, pair) = collision.clearance(&folded(phi_deg + 2.0)).expect("near");
            let off = 260.0 * libm::sin((phi_deg + 2.0).to_radians()) - apart + f64::min(margin_mm, 5.0);
            assert!((mm - off).abs() < 1e-9 && pair == contact, "{mm} mm for {off}, {pair:?}");
            // On the way there it is met where it is, no later than the margin after.
            let (t, between) = collision.first_contact_between(&folded(90.0), &folded(15.0)).expect("met");
            let met_deg = 90.0 - 75.0 * t;
            assert!(met_deg <= phi_deg && met_deg > phi_deg - 3.0, "{met_deg} for {phi_deg}");
            assert_eq!(between, contact);
            let along = collision.first_contact_along(|t| folded(90.0 - 75.0 * t)).expect("met");
            assert_eq!(along.1, contact);
            assert_eq!(collision.first_contact_between(&folded(90.0), &folded(phi_deg + 0.001)), None);
        }
    }
}

/// All pairs but neighbours are looked at, and base with upper arm where their capsules share the shoulder; no other
/// pair is near at more than a third or so of all poses, so the rule leaves out what it is meant to and nothing else.
#[test]
fn links_that_always_touch_are_no_pair() {
    for key in Robot::shipped() {
        let (robot, home) = (shipped(key), Cell::shipped(key).expect("a cell").air.home_joints_deg);
        let arm = ArmBodies::new(&robot);
        let pairs = arm.own_pairs(&home, 5.0);
        assert_eq!(pairs, [[0, 3], [0, 4], [1, 3], [1, 4], [2, 4]], "{key}");
        for [i, j] in pairs {
            let near = |k: u32| {
                let at = arm.at(&pose(&robot.limits_deg, k));
                at.links[i].is_near(&at.links[j], 5.0)
            };
            let count = (1000..1400).filter(|k| near(*k)).count();
            assert!(count < 160, "{key}: links {i} and {j} are near at {count} of 400 poses");
        }
    }
    // An upper arm beside the column, as a UR has it, counts as soon as the two keep apart.
    let mut thin = shipped("ur5e");
    thin.links.base_mm = 60.0;
    assert_eq!(ArmBodies::new(&thin).own_pairs(&[0.0; 6], 5.0)[0], [0, 2]);
}

/// What a look at one pose costs: of an arm of capsules with a part in hand over a table, four links and the part with
/// the table, the part with four links, and five pairs of links.
#[test]
fn a_pose_is_fourteen_looks() {
    let mut setup = alone(shipped("mz04"));
    (setup.mount, setup.cell.bodies.table_z_mm) = (Mount::PartInHand, Some(0.0));
    let part = part();
    let collision = Collision::new(&setup, &part).expect("a robot");
    let mut looks = 0;
    let _: ControlFlow<()> = collision.visit_pairs(&folded(90.0), &mut |_, _, _| {
        looks += 1;
        ControlFlow::Continue(())
    });
    assert_eq!(looks, 4 + 1 + 4 + 5);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    /// Facets of the capsules' own shape are as near as the capsules are, but for the hundredth of the radius that they lack.
    #[test]
    fn bodies_of_facets_touch_where_their_capsules_do(seed in 0..10_000u32, drawn in 0..10_000u32, is_in_hand in prop::bool::ANY) {
        let robot = shipped("mz04");
        let drawn = pose(&robot.limits_deg, drawn);
        let mount = if is_in_hand { Mount::PartInHand } else { Mount::ToolInHand };
        let setups = [robot, meshed("mz04", drawn)].map(|robot| {
            let mut setup = Setup { mount, ..alone(robot) };
            setup.cell.base_from_part.position_mm = [250.0, -100.0, 300.0];
            setup.cell.bodies.table_z_mm = Some(-100.0);
            setup
        });
        let part = part();
        let [capsules, facets] = setups.each_ref().map(|s| Collision::new(s, &part).expect("a robot"));
        prop_assert_eq!(&capsules.own_pairs, &facets.own_pairs);
        let limits = setups[0].robot.as_ref().expect("one").limits_deg;
        for joints in (0..8).map(|i| pose(&limits, seed + i)) {
            let mm = |c: &Collision<'_>| c.clearance(&joints).map_or(CLEARANCE_REACH_MM, |(mm, _)| mm);
            let (round, flat) = (mm(&capsules), mm(&facets));
            prop_assert!((round - flat).abs() < 1.5, "{round} mm, in facets {flat} mm");
            if (round - 5.0).abs() > 1.5 {
                prop_assert_eq!(capsules.first_contact(&joints).is_some(), facets.first_contact(&joints).is_some());
            }
        }
        let ends = [pose(&limits, seed), pose(&limits, seed + 1)];
        prop_assert!(facets.travel_mm(&ends[0], &ends[1]) >= capsules.travel_mm(&ends[0], &ends[1]));
    }
}
