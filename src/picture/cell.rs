//! The robot cell: arm, laser head, beam, floor. All in the base. Solids are made once for a setup; a moment only says
//! where they stand.

use super::arm::ArmPicture;
use super::palette::Rgb;
use super::solid::{ColoredSolid, along};
use crate::cell::bodies::HeadCapsule;
use crate::cell::{Joints, Mount, Robot, Setup};
use crate::part::Hasher;
use crate::view::{Bounds, Depth, LineItem, LineSegment, MeshItem, PointItem};
use nalgebra::{Isometry3, Point3, Vector3};
use std::sync::Arc;

const METAL: Rgb = [134, 142, 154];
const HEAD: Rgb = [52, 58, 70];
const LIGHT: Rgb = [255, 92, 20];

/// Length of a fixed head: the head of an installation is not known here.
const FIXED_HEAD_MM: f64 = 220.0;
/// What is held nearer to the flange than this has no holder.
const LEAST_HOLDER_MM: f64 = 1.0;

/// What stands in the cell.
#[derive(Clone, Debug)]
pub struct CellPicture {
    robot: Robot,
    arm: ArmPicture,
    /// From the flange to the part or the head.
    holder: Option<(ColoredSolid, Isometry3<f64>)>,
    /// In the focus frame.
    head: Vec<(ColoredSolid, Isometry3<f64>)>,
    obstacles: Vec<MeshItem>,
    cone: ColoredSolid,
    /// Of the head, above the focus.
    tip_mm: f64,
    top_mm: f64,
    floor: Arc<Vec<LineSegment>>,
    /// Of the table, or of the base.
    floor_z_mm: f64,
    reach_mm: f64,
}

impl CellPicture {
    /// The solids of a setup; `None` without a robot.
    pub fn new(setup: &Setup) -> Option<CellPicture> {
        let robot = setup.robot.clone()?;
        let capsules = robot.capsules(&setup.home_joints_deg());
        let wrist_mm = capsules[4].radius_mm;
        let hand = match setup.mount {
            Mount::PartInHand => setup.cell.flange_from_part.isometry(),
            Mount::ToolInHand => setup.cell.flange_from_tool.isometry(),
        };
        // What is held ends where the part's frame is, or at the top of the head.
        let (head_mm, held) = match setup.mount {
            Mount::PartInHand => (FIXED_HEAD_MM, hand * Point3::origin()),
            Mount::ToolInHand => {
                let head_mm = hand.translation.vector.norm().clamp(40.0, FIXED_HEAD_MM);
                (head_mm, hand * Point3::new(0.0, 0.0, -head_mm))
            }
        };
        let holder = (held.coords.norm() > LEAST_HOLDER_MM).then(|| {
            let rod = ColoredSolid::rod(0.3 * wrist_mm.max(10.0), held.coords.norm(), [false, false], METAL);
            (rod, along(&Point3::origin(), &held))
        });
        let bodies = &setup.cell.bodies.head;
        let nozzle_mm = 0.2 * head_mm;
        let (tip_mm, top_mm) = ends(bodies).unwrap_or((nozzle_mm, head_mm));
        let profile = [
            [0.0, nozzle_mm],
            [0.018 * head_mm, nozzle_mm],
            [0.085 * head_mm, 0.52 * head_mm],
            [0.12 * head_mm, 0.56 * head_mm],
            [0.12 * head_mm, head_mm],
            [0.0, head_mm],
        ];
        let reach_mm = capsules.iter().map(|c| (c.to - c.from).norm()).sum::<f64>() + wrist_mm;
        Some(CellPicture {
            arm: ArmPicture::new(&robot, &capsules),
            holder,
            head: head(bodies, &profile),
            obstacles: setup.cell.bodies.obstacles.iter().map(super::tool::obstacle).collect(),
            cone: ColoredSolid::turned(&[[0.0, 0.0], [0.018 * head_mm, tip_mm]], LIGHT, 150),
            tip_mm,
            top_mm,
            floor: Arc::new(floor(reach_mm)),
            floor_z_mm: setup.cell.bodies.table_z_mm.unwrap_or(0.0),
            reach_mm,
            robot,
        })
    }

    /// Arm and head at these joints.
    pub fn solids(&self, joints_deg: &Joints, base_from_focus: Isometry3<f64>) -> Vec<MeshItem> {
        let base_from_flange = self.robot.forward(joints_deg);
        let mut items = self.arm.solids(&self.robot, joints_deg);
        items.extend(self.holder.iter().map(|(rod, place)| rod.at(base_from_flange * place)));
        items.extend(self.head.iter().map(|(body, place)| body.at(base_from_focus * place)));
        items.extend(self.obstacles.iter().cloned());
        items
    }

    /// Where the beam leaves the head, above the focus, mm.
    pub fn tip_mm(&self) -> f64 {
        self.tip_mm
    }

    /// The beam from the head, `length_mm` long, or the line it would take.
    pub fn beam(
        &self,
        base_from_focus: Isometry3<f64>,
        length_mm: f64,
        lit: bool,
    ) -> (Option<MeshItem>, LineItem, Option<PointItem>) {
        let end = [0.0, 0.0, (self.tip_mm - length_mm) as f32];
        let [r, g, b] = LIGHT;
        let color = if lit { [r, g, b, 255] } else { [150, 156, 166, 150] };
        let key = Hasher::default().f64s(&[self.tip_mm, length_mm]).u32s(&[u32::from(lit)]).finish().0 as u64;
        let line = LineItem {
            key,
            segments: Arc::new(vec![LineSegment { a: [0.0, 0.0, self.tip_mm as f32], b: end, color }]),
            width_px: if lit { 4.0 } else { 1.5 },
            depth: Depth::Tested,
            scene_from_item: base_from_focus,
        };
        let spot = lit.then(|| PointItem {
            key,
            points: Arc::new(vec![(end, [255, 214, 120, 255])]),
            size_px: 9.0,
            depth: Depth::OnTop,
            scene_from_item: base_from_focus,
        });
        (lit.then(|| self.cone.at(base_from_focus)), line, spot)
    }

    /// The floor, in squares of 100 mm.
    pub fn floor(&self) -> LineItem {
        LineItem {
            key: Hasher::default().f64s(&[self.reach_mm]).finish().0 as u64,
            segments: self.floor.clone(),
            width_px: 1.0,
            depth: Depth::Tested,
            scene_from_item: Isometry3::translation(0.0, 0.0, self.floor_z_mm),
        }
    }

    /// The box around arm and head at these joints.
    pub fn bounds(&self, joints_deg: &Joints, base_from_focus: &Isometry3<f64>) -> Bounds {
        let capsules = self.robot.capsules(joints_deg);
        let around = capsules.iter().flat_map(|c| {
            let r = Vector3::repeat(c.radius_mm);
            [c.from - r, c.from + r, c.to - r, c.to + r]
        });
        let head = [0.0, self.top_mm].map(|z| base_from_focus * Point3::new(0.0, 0.0, z));
        let mut bounds = Bounds::around(around.chain(head)).unwrap_or_default();
        bounds.min.z = bounds.min.z.max(self.floor_z_mm.min(0.0));
        bounds
    }

    /// The box that the arm can reach into, with something in its hand.
    pub fn reachable(&self, hand_mm: f64) -> Bounds {
        let reach = Vector3::repeat(self.reach_mm + hand_mm);
        Bounds { min: Point3::from(-reach), max: Point3::from(reach) }
    }
}

/// Lowest and highest point of a head on the beam's axis; a beam begins above its focus.
fn ends(capsules: &[HeadCapsule]) -> Option<(f64, f64)> {
    let low = capsules.iter().map(|c| c.from_mm - c.radius_mm).reduce(f64::min)?;
    let high = capsules.iter().map(|c| c.to_mm + c.radius_mm).reduce(f64::max)?;
    let tip_mm = low.max(1.0);
    Some((tip_mm, high.max(tip_mm)))
}

/// The head as the cell file gives it; a nozzle where it does not.
fn head(capsules: &[HeadCapsule], nozzle: &[[f64; 2]]) -> Vec<(ColoredSolid, Isometry3<f64>)> {
    if capsules.is_empty() {
        return vec![(ColoredSolid::turned(nozzle, HEAD, 255), Isometry3::identity())];
    }
    let body = |c: &HeadCapsule| {
        let (low, high) = (c.from_mm.min(c.to_mm), c.from_mm.max(c.to_mm));
        (ColoredSolid::rod(c.radius_mm, high - low, [true, true], HEAD), Isometry3::translation(0.0, 0.0, low))
    };
    capsules.iter().map(body).collect()
}

fn floor(reach_mm: f64) -> Vec<LineSegment> {
    let squares = (reach_mm / 100.0).ceil() as i32;
    let end = (squares * 100) as f32;
    (-squares..=squares)
        .flat_map(|k| {
            let at = (k * 100) as f32;
            let color = if k == 0 { [128, 138, 152, 150] } else { [128, 138, 152, 62] };
            [
                LineSegment { a: [at, -end, 0.0], b: [at, end, 0.0], color },
                LineSegment { a: [-end, at, 0.0], b: [end, at, 0.0], color },
            ]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_beam_begins_where_the_head_ends() {
        let mut setup = Setup::shipped().expect("valid");
        setup.robot = Some(Robot::load("mz04", None).expect("shipped"));
        let capsule = |from_mm, to_mm, radius_mm| HeadCapsule { from_mm, to_mm, radius_mm };
        setup.cell.bodies.head = vec![capsule(160.0, 300.0, 50.0), capsule(90.0, 160.0, 12.0)];
        let picture = CellPicture::new(&setup).expect("a robot");
        assert_eq!((picture.tip_mm(), picture.top_mm), (78.0, 350.0));
        let (_, line, _) = picture.beam(Isometry3::identity(), 58.0, true);
        assert_eq!((line.segments[0].a[2], line.segments[0].b[2]), (78.0, 20.0));
        // A head that reaches down to the focus.
        setup.cell.bodies.head = vec![capsule(5.0, 50.0, 20.0)];
        assert_eq!(CellPicture::new(&setup).expect("a robot").tip_mm(), 1.0);
    }

    #[test]
    fn every_shipped_robot_has_an_arm_that_moves_without_new_data() {
        for key in Robot::shipped() {
            let mut setup = Setup::shipped().expect("valid");
            setup.robot = Some(Robot::load(key, None).expect("shipped"));
            let picture = CellPicture::new(&setup).expect("a robot");
            let focus = setup.cell.base_from_laser.isometry();
            let (home, away) = (setup.home_joints_deg(), [40.0, 60.0, 20.0, -30.0, 50.0, 10.0]);
            let (a, b) = (picture.solids(&home, focus), picture.solids(&away, focus));
            assert!(a.iter().zip(&b).all(|(a, b)| a.geometry_key == b.geometry_key && a.colors_key == b.colors_key));
            assert!(a.iter().zip(&b).any(|(a, b)| a.scene_from_item != b.scene_from_item), "{key}");
            let keys: Vec<_> = a.iter().map(|i| (i.geometry_key, i.positions.len())).collect();
            for (key, corners) in &keys {
                assert!(keys.iter().all(|(k, c)| k != key || c == corners), "one key, one geometry");
            }
        }
        assert!(CellPicture::new(&Setup::shipped().expect("valid")).is_none());
    }
    /// Bodies that have files are drawn in place of rods and balls, and move with their joints.
    #[test]
    fn bodies_of_the_arm_take_the_place_of_its_rods() {
        let mut setup = Setup::shipped().expect("valid");
        let focus = setup.cell.base_from_laser.isometry();
        let home = setup.home_joints_deg();
        let mut drawn = |robot: Robot| {
            setup.robot = Some(robot);
            CellPicture::new(&setup).expect("a robot").solids(&home, focus)
        };
        let rods = drawn(Robot::load("mz04", None).expect("shipped"));
        let bodies = drawn(crate::cell::robot::meshed("mz04", [10.0; 6]));
        // Plate, five links, three joints and the flange make way for seven bodies.
        assert_eq!(bodies.len(), rods.len() - 10 + 7);
        let places =
            |items: &[MeshItem]| items.iter().map(|i| i.scene_from_item.translation.vector).collect::<Vec<_>>();
        let still = places(&bodies);
        let moved = places(&drawn(crate::cell::robot::meshed("mz04", home)));
        // As they were drawn they stand where they were drawn.
        // What moves with joint 1 turns about the base's own axis.
        assert!(moved[..7].iter().all(|p| p.norm() < 1e-9) && still[2..7].iter().all(|p| p.norm() > 1.0));
    }
}
