//! What stands in the hall for one job: the cell, the robot in it, and what the robot carries.

use super::mount::Spin;
use super::mounting::Mounted;
use super::{Cell, CellError, Joints, Mount, PlaceError, Robot};
use crate::beam::{Abrasive, Grinding, Tool};
use crate::part::distance::segments;
use nalgebra::{Isometry3, Point3};

/// Cell, robot and mount.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Frames, bodies, outputs, templates.
    pub cell: Cell,
    /// The robot; `None`: poses only, nothing is known of reach.
    pub robot: Option<Robot>,
    /// What it carries.
    pub mount: Mount,
    /// Head and clamps of the job.
    pub tool: Tool,
}

impl Setup {
    /// Whether the tool presses with a force that the controller keeps.
    pub fn keeps_force(&self) -> bool {
        self.tool.contact.as_ref().is_some_and(|grinding| grinding.force_n > 0.0)
    }

    /// The spin that a tool takes where this one is wanted: a belt runs along the travel, whatever is wanted.
    pub fn spin(&self, wanted: Spin) -> Spin {
        let is_belt = |grinding: &Grinding| matches!(grinding.tool.abrasive, Abrasive::Belt { .. });
        if self.tool.contact.as_ref().is_some_and(is_belt) { Spin::Travel } else { wanted }
    }

    /// The cell that is taken when none is named, without a robot.
    ///
    /// # Errors
    /// Never, as shipped.
    pub fn shipped() -> Result<Setup, CellError> {
        Ok(Setup { cell: Cell::shipped("mz04")?, robot: None, mount: Mount::PartInHand, tool: Tool::default() })
    }

    /// Whether the robot can stand in the cell.
    ///
    /// # Errors
    /// Home is beyond its joints, or the laser or the table stands inside its base.
    pub fn check(&self) -> Result<(), CellError> {
        let refused = |what| CellError::Place { cell: self.cell.name.clone(), what };
        self.robot.as_ref().map_or(Ok(()), |robot| self.check_place(robot).map_err(refused))
    }

    /// Checks joints that the cell names, the table and the laser against the robot.
    fn check_place(&self, robot: &Robot) -> Result<(), PlaceError> {
        let (air, home) = (&self.cell.air, self.home_joints_deg());
        let named_joints = [
            ("air.home_joints_deg", Some(home)),
            ("air.entry_joints_deg", air.entry_joints_deg),
            ("air.exit_joints_deg", air.exit_joints_deg),
        ];
        for (key, joints) in named_joints.into_iter().filter_map(|(key, joints)| Some((key, joints?))) {
            if let Some(j) = robot.beyond(&joints) {
                let (range_deg, robot) = (robot.limits_deg[j], robot.name.clone());
                return Err(PlaceError::BeyondJoint { key, joint: j + 1, deg: joints[j], range_deg, robot });
            }
        }
        let [base, ..] = robot.capsules(&home);
        let bodies = &self.cell.bodies;
        if let Some(table_z_mm) = bodies.table_z_mm.filter(|z| *z > base.to.z - base.radius_mm) {
            return Err(PlaceError::HighTable { table_z_mm });
        }
        let at = self.cell.base_from_laser.isometry();
        let inside = |from_mm: f64, to_mm: f64, radius_mm: f64| {
            let [from, to] = [from_mm, to_mm].map(|z| at * Point3::new(0.0, 0.0, z));
            segments(&base.from, &base.to, &from, &to) < base.radius_mm + radius_mm
        };
        let head = bodies.head.iter().any(|h| inside(h.from_mm, h.to_mm, h.radius_mm));
        if self.mount == Mount::PartInHand && (head || inside(0.0, 0.0, 0.0)) {
            return Err(PlaceError::LaserInBase { base_mm: 2.0 * base.radius_mm });
        }
        Ok(())
    }

    /// Pose of the flange in the base for a path frame of the part.
    pub fn flange_for(&self, part_from_focus: &Isometry3<f64>) -> Isometry3<f64> {
        self.mounted().flange_for(part_from_focus)
    }

    /// The path frame at a pose of the flange.
    pub fn focus_for(&self, base_from_flange: &Isometry3<f64>) -> Isometry3<f64> {
        self.mounted().focus_for(base_from_flange)
    }

    /// The frames in use, ready to be asked for many poses.
    pub fn mounted(&self) -> Mounted {
        self.cell.mounted(self.mount)
    }

    /// Where programs begin and end.
    pub fn home_joints_deg(&self) -> Joints {
        self.cell.air.home_joints_deg
    }

    /// The robot's name for people, or `no robot`.
    pub fn robot_name(&self) -> &str {
        self.robot.as_ref().map_or("no robot", |r| &r.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::bodies::HeadCapsule;
    use crate::cell::motion::Arm;
    use crate::cell::{Collision, Frame, Spin};
    use crate::part::{Part, Placement, Units};
    use crate::pose::target::frame;
    use crate::sample::{SAMPLES, stl_bytes};
    use nalgebra::Vector3;

    #[test]
    fn what_cannot_stand_is_refused() {
        let robot = Robot::load("mz04", None).expect("shipped");
        let base_mm = robot.links.base_mm;
        let good = Setup { robot: Some(robot), ..Setup::shipped().expect("shipped") };
        good.check().expect("the shipped cell stands");
        let refused = |change: &dyn Fn(&mut Setup)| {
            let mut setup = good.clone();
            change(&mut setup);
            match setup.check() {
                Ok(()) => None,
                Err(CellError::Place { what, .. }) => Some(what),
                Err(other) => panic!("{other}"),
            }
        };
        let laser = |x: f64| Frame::new([x, 0.0, 100.0], [0.0; 3]);
        let inside = Some(PlaceError::LaserInBase { base_mm: 2.0 * base_mm });
        assert_eq!(refused(&|s| s.cell.base_from_laser = laser(base_mm - 0.1)), inside);
        assert_eq!(
            refused(&|s| {
                s.cell.bodies.head.clear();
                s.cell.base_from_laser = laser(base_mm + 0.1)
            }),
            None
        );
        let head = HeadCapsule { from_mm: 20.0, to_mm: 100.0, radius_mm: 30.0 };
        let headed = |s: &mut Setup, x: f64| {
            s.cell.bodies.head = vec![head];
            s.cell.base_from_laser = laser(x)
        };
        assert_eq!(refused(&|s| headed(s, base_mm + 29.9)), inside);
        assert_eq!(refused(&|s| headed(s, base_mm + 30.1)), None);
        assert_eq!(
            refused(&|s| {
                headed(s, 0.0);
                s.mount = Mount::ToolInHand
            }),
            None,
            "it hangs on the flange"
        );
        let table = refused(&|s| s.cell.bodies.table_z_mm = Some(300.0));
        assert_eq!(table, Some(PlaceError::HighTable { table_z_mm: 300.0 }));
        let home = refused(&|s| s.cell.air.home_joints_deg[1] = 200.0);
        assert!(matches!(home, Some(PlaceError::BeyondJoint { joint: 2, deg: 200.0, .. })), "{home:?}");
        assert_eq!(
            refused(&|s| {
                s.robot = None;
                s.cell.base_from_laser = laser(0.0)
            }),
            None,
            "nothing stands there"
        );
    }

    /// Home is free, and the middle of the sample workpiece's front is in reach without a touch.
    #[test]
    fn every_shipped_cell_reaches_the_workpiece() {
        let workpiece = SAMPLES.iter().find(|s| s.name == "workpiece").expect("a sample");
        let bytes = stl_bytes(&(workpiece.triangles)());
        let part = Part::from_bytes(&bytes, Units::Mm, &Placement::default(), &[]).expect("a part");
        let (a, o) = (-Vector3::y(), Vector3::x());
        let middle = frame(&Point3::new(0.0, -6.0 - 20.0, 40.0), &a, &o);
        for key in Robot::shipped() {
            let robot = Robot::load(key, None).expect("shipped");
            for mount in [Mount::PartInHand, Mount::ToolInHand] {
                let cell = Cell::shipped(key).expect("a cell for every robot");
                let setup = Setup { cell, robot: Some(robot.clone()), mount, tool: Tool::default() };
                setup.check().expect("home in range, the laser out of the base");
                let collision = Collision::new(&setup, &part).expect("a robot");
                assert_eq!(collision.first_contact(&setup.home_joints_deg()), None, "{key}, {mount:?}, home");
                let states = Arm::new(&setup, Spin::Free).expect("a robot").states(&middle).expect("in reach");
                let clear = |j: &Joints| robot.limit_margin_deg(j) > 5.0 && robot.singularity(j) > 0.05;
                let free =
                    states.iter().any(|s| clear(&s.joints_deg) && collision.first_contact(&s.joints_deg).is_none());
                assert!(free, "{key}, {mount:?}");
            }
        }
    }
}
