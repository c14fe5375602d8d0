//! Clamps cost what they have to: one far away nothing, one nearby as many looks as its distance asks for; and a ray
//! beside one is told by an independent checker.

#[path = "common/parts.rs"]
mod parts;

use clearbeam::beam::{Obstacle, Optics, Tool, ToolGeometry};
use clearbeam::pose::checker::Checker;
use clearbeam::pose::motion::{Motion, swept};
use clearbeam::pose::{BeamInterference, Blocker, Correction, Pose, Tilt, motion};
use clearbeam::sample::{Triangles, solids, stl_bytes};
use nalgebra::{Point3, Vector3};
use parts::{block, cylinder, job, on, part, planned_in, setup, surface_at};
use proptest::prelude::*;
use std::cell::Cell;

/// A clamp of these facets, where it stands in the part frame.
fn clamp(facets: &Triangles, position_mm: [f64; 3], rz_ry_rx_deg: [f64; 3]) -> Obstacle {
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(dir.path().join("clamp.stl"), stl_bytes(facets)).expect("written");
    let mut out = Obstacle::named("clamp.stl".into());
    (out.position_mm, out.rz_ry_rx_deg) = (position_mm, rz_ry_rx_deg);
    out.load(Some(dir.path())).expect("an STL");
    out
}

fn geometry(tool: &Tool) -> ToolGeometry<'_> {
    ToolGeometry::new(tool, &Optics::default(), 1.0, 20.0, 0.5).expect("something stands in the way")
}

fn plate() -> clearbeam::part::Part {
    part(&block([-200.0, -200.0, -10.0], [200.0, 200.0, 0.0]))
}

#[test]
fn a_clamp_far_away_changes_no_target() {
    let facets = solids::fin_row(3, 2.0, 4.0, 15.0, 50.0, 7.0);
    let floor = [4.0, 25.0, 0.0];
    for (correction, head) in [
        (Correction::None, None),
        (Correction::SectionPlane, None),
        (Correction::Clearance, None),
        (Correction::SectionPlane, cylinder(15.0).head),
    ] {
        let planned = |clamps: Vec<Obstacle>| {
            let part = part(&facets);
            let mut job = job("z", 1.0);
            job.layers.direction = "x".parse().expect("a direction");
            job.path.correction = correction;
            let number = surface_at(&part, &clearbeam::document::segmented(&part, &job), floor);
            let mut setup = setup();
            setup.tool = Tool { head: head.clone(), clamps, ..Tool::default() };
            planned_in(part, on(job, &[number]), &setup)
        };
        let block = block([-10.0; 3], [10.0; 3]);
        let far = |p: [f64; 3]| clamp(&block, p, [10.0, 20.0, 30.0]);
        let (alone, beside) = (planned(Vec::new()), planned(vec![far([300.0, 25.0, 0.0]), far([4.0, -900.0, 40.0])]));
        assert!(alone.targets().count() > 10, "something is planned");
        assert_eq!(format!("{:?}", alone.plan.passes), format!("{:?}", beside.plan.passes), "{correction:?}");
        assert_eq!(alone.plan.proof, beside.plan.proof);
    }
}

/// A motion with a straight spot and a constant turn that counts the pieces that it is cut in.
struct Counted(Cell<usize>);

impl Motion for Counted {
    fn between(&self, from: (&Pose, f64), to: (&Pose, f64)) -> Pose {
        self.0.set(self.0.get() + 1);
        from.0.midway(to.0, 0.5)
    }

    fn sag_mm(&self) -> f64 {
        0.0
    }

    fn stray_mm(&self, _share: f64, _reach_mm: f64) -> f64 {
        0.0
    }

    fn blocker(&self, beam: &BeamInterference<'_>, middle: &Pose) -> Option<Blocker> {
        beam.blocker(&middle.p, &middle.a)
    }
}

/// Half of the turn of the motion that is counted, degrees, and half of its length, mm.
const HALF: (f64, f64) = (2.5, 2.5);

/// In how many pieces a motion over a plate is looked at, from a beam that leans to one side to one that leans to the
/// other.
fn pieces(tool: &Tool) -> usize {
    let plate = plate();
    let body = ToolGeometry::new(tool, &Optics::default(), 1.0, 20.0, 0.5);
    let beam = BeamInterference::with(&plate, body.as_ref());
    let pose = |side: f64| Pose {
        p: Point3::new(side * HALF.1, 0.0, 0.0),
        a: Tilt { lead_deg: side * HALF.0, lean_deg: 0.0 }.axis(&Vector3::z(), &Vector3::x()),
    };
    let counted = Counted(Cell::new(0));
    let (from, to) = (pose(-1.0), pose(1.0));
    let found = swept(&beam, &counted, (&from, 0.0), (&to, 1.0)).expect("nobody cancels");
    assert!(found.is_none(), "{found:?}");
    counted.0.get()
}

#[test]
fn a_motion_beside_a_clamp_is_cut_as_its_distance_asks() {
    // A block of 12 facets and a ball of thousands, 10 to 110 mm above the plate, so far from the spot's way.
    let ball: Triangles =
        solids::sphere(50.0, 96, 48).into_iter().map(|t| t.map(|[x, y, z]| [x + 50.0, y, z + 60.0])).collect();
    let bodies = [block([0.0, -50.0, 10.0], [100.0, 50.0, 110.0]), ball];
    // Without a head the ray; with one its cylinder, 15 mm wide from 40 to 140 mm above the spot.
    for (head, radius_mm, reach_mm) in [(None, 0.02, 110.0), (cylinder(15.0).head, 15.5, 141.0)] {
        let alone = pieces(&Tool { head: head.clone(), ..Tool::default() });
        let (turn, half_mm) = (HALF.0.to_radians(), HALF.1);
        let most_mm = half_mm + reach_mm * libm::sin(turn);
        for body in &bodies {
            let mut before = usize::MAX;
            for gap_mm in [0.5, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 10_000.0] {
                // Off the tool where it leans towards the body most.
                let x = half_mm + reach_mm * libm::sin(turn) + radius_mm + gap_mm;
                let clamps = vec![clamp(body, [x, 0.0, 0.0], [0.0; 3])];
                let count = pieces(&Tool { head: head.clone(), clamps, ..Tool::default() });
                // A piece on which nothing moves as far as the gap is clear: halves of halves down to that.
                let bound = alone as f64 + 4.0 * most_mm / gap_mm;
                assert!((count as f64) <= bound && count <= before, "{gap_mm} mm: {count}, {bound}, {before} before");
                assert!(gap_mm < 2.0 * most_mm || count == alone, "{gap_mm} mm: {count} and not {alone}");
                before = count;
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    /// What a ray is proven to miss it misses at every pose that is looked at; and where it keeps a millimetre it is
    /// proven to.
    #[test]
    fn a_ray_beside_a_clamp_is_what_the_checker_says(at in prop::array::uniform3(-12.0..12.0f64),
                                                     turn in prop::array::uniform3(-180.0..180.0f64),
                                                     ends in prop::array::uniform4(-8.0..8.0f64),
                                                     tilts in prop::array::uniform4(-30.0..30.0f64)) {
        let standing = clamp(&block([-4.0, -2.0, -1.0], [4.0, 2.0, 1.0]), [at[0], at[1], at[2] + 30.0], turn);
        let place = standing.at();
        let mesh = standing.solid().mesh.clone();
        let check = Checker::new((0..mesh.facets.len()).map(|f| mesh.corners(f).map(|c| place * c)));
        let tool = Tool { clamps: vec![standing], ..Tool::default() };
        let (plate, body) = (plate(), geometry(&tool));
        let beam = BeamInterference::with(&plate, Some(&body));
        let pose = |x: f64, y: f64, t: [f64; 2]| Pose {
            p: Point3::new(x, y, 0.0),
            a: Tilt { lead_deg: t[0], lean_deg: t[1] }.axis(&Vector3::z(), &Vector3::x()),
        };
        let (from, to) = (pose(ends[0], ends[1], [tilts[0], tilts[1]]), pose(ends[2], ends[3], [tilts[2], tilts[3]]));
        let proven = motion::is_free(&beam, &from, &to, 0.0);
        const LOOKS: i32 = 100;
        let looks: Vec<Pose> = (0..=LOOKS).map(|k| from.midway(&to, f64::from(k) / f64::from(LOOKS))).collect();
        let hit = looks.iter().any(|q| check.hit(&q.p, &q.a, 0.0).is_some());
        prop_assert!(!proven || !hit, "proven, and hit");
        // Between two looks no point up to 60 mm above the spot moves farther than a millimetre.
        let least = || looks.iter().map(|q| check.clearance(&q.p, &q.a, 0.0, 60.0, 30)).fold(f64::INFINITY, f64::min);
        prop_assert!(proven || hit || least() < 1.0, "clear by {}, and not proven", least());
    }
}
