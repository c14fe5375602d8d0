//! A target of another kind, a move of another way, another configuration: found in every dialect at the line
//! where it stands, with a robot and without one, and where the arm would come to the same place.

#[path = "common/parts.rs"]
mod parts;
#[path = "common/retarget.rs"]
mod retarget;

use clearbeam::cell::controllers::NachiForm;
use clearbeam::cell::{Robot, Setup};
use clearbeam::planning::verify::{DifferenceKind, Finding, check};
use clearbeam::program::dialect::{Goal, ReadContext, ReadLine, ReadMove, Statement};
use clearbeam::program::{Dialect, Interpolation, Program, ProgramFile, dialects, lines};
use clearbeam::text::{Sentence as _, program_comment};
use parts::{Planned, job, on, part, planned_in, sample};
use retarget::retargeted;

struct Case {
    dialect: &'static dyn Dialect,
    planned: Planned,
    setup: Setup,
    files: Vec<ProgramFile>,
}

/// A move of a program, and whether the laser is on.
struct Place {
    line: ReadLine,
    to: ReadMove,
    lit: bool,
}

/// Every dialect with a robot and without; NACHI with the robot in its other form too.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for robot in ["", "mz04"] {
        let mut setup = Setup::shipped().expect("shipped");
        setup.robot = (!robot.is_empty()).then(|| Robot::load(robot, None).expect("shipped"));
        // Without them a job for Yaskawa has no words for joints.
        setup.cell.yaskawa.pulses_per_deg = Some([1000.0; 6]);
        for &dialect in dialects::DIALECTS {
            cases.push(case(dialect, &setup));
        }
        if setup.robot.is_some() {
            setup.cell.nachi.form = NachiForm::Pose;
            cases.push(case(dialects::by_name("nachi").expect("a dialect"), &setup));
        }
    }
    cases
}

fn case(dialect: &'static dyn Dialect, setup: &Setup) -> Case {
    let setup = setup.clone();
    let mut job = on(job("z", 20.0), &[1]);
    job.cell.dialect = dialect.name().into();
    let planned = planned_in(part(&sample("workpiece")), job, &setup);
    let lines = lines(&planned.plan.steps, &setup);
    let program = Program { head: Vec::new(), lines, setup: &setup, wording: program_comment };
    let files = dialect.write(&program).unwrap_or_else(|e| panic!("{}: {e}", dialect.name()));
    Case { dialect, planned, setup, files }
}

impl Case {
    fn name(&self) -> String {
        format!("{} {}", self.dialect.name(), self.setup.robot.as_ref().map_or("", |r| &r.name))
    }

    fn findings(&self, files: &[ProgramFile]) -> Vec<Finding> {
        let p = &self.planned;
        let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
        let verdict = check(&p.part, &p.plan, &self.setup, &p.job, &files[0], &open, false).expect("a dialect").1;
        verdict.findings
    }

    fn places(&self) -> Vec<Place> {
        let open = |name: &str| self.files.iter().find(|f| f.name == name).map(|f| f.text.clone());
        let read = self.dialect.read(&self.files[0], &ReadContext { setup: &self.setup, open: &open }).expect("reads");
        let laser = self.setup.cell.outputs.laser.number;
        let (mut lit, mut out) = (false, Vec::new());
        for line in read {
            match line.what.clone() {
                Statement::Output { number, on } if number == laser => lit = on,
                Statement::Move(to) => out.push(Place { line, to, lit }),
                _ => {}
            }
        }
        out
    }

    /// A target of the other kind; with a robot at the same place.
    fn other(&self, place: &Place, places: &[Place]) -> Goal {
        let flange = |goal: &Goal| match goal {
            Goal::Flange(at) => Some(*at),
            Goal::Focus(focus) => Some(self.setup.flange_for(focus)),
            Goal::Joints(joints) => self.setup.robot.as_ref().map(|r| r.forward(joints)),
        };
        let home = self.setup.home_joints_deg();
        match (&place.to.goal, &self.setup.robot) {
            (Goal::Joints(_), _) => {
                let near = flange(&place.to.goal).or(places.iter().find_map(|p| flange(&p.to.goal)));
                Goal::Flange(near.expect("some pose"))
            }
            (goal, Some(robot)) => {
                let at = flange(goal).expect("a pose");
                Goal::Joints(robot.nearest_inverse(&at, &home).expect("within reach"))
            }
            (_, None) => Goal::Joints(home),
        }
    }
}

/// The moves that are changed: home and the way back to it, the approach, a straight move in the air, two lit ones.
fn chosen(places: &[Place]) -> Vec<usize> {
    let dark = (2..places.len()).find(|i| !places[*i].lit && places[*i].to.interpolation == Interpolation::Linear);
    let lit = (0..places.len()).filter(|i| places[*i].lit).take(2);
    [0, 1, places.len() - 1].into_iter().chain(dark).chain(lit).collect()
}

#[test]
fn a_target_of_another_kind_is_found_where_it_stands() {
    for case in cases() {
        assert_eq!(case.findings(&case.files), [], "{}", case.name());
        let places = case.places();
        for i in chosen(&places) {
            let (place, other) = (&places[i], case.other(&places[i], &places));
            let (files, line) = retargeted(case.dialect.name(), &case.setup, &case.files, &place.line, &other);
            let findings = case.findings(&files);
            let found = findings.iter().find(|f| (&f.file, f.line) == (&place.line.file, line));
            let what = format!("{}, move {i}: {:?} to {other:?}", case.name(), place.to);
            let found = found.unwrap_or_else(|| panic!("{what}: {findings:?}"));
            let said = found.sentence();
            if found.kind == DifferenceKind::Setting {
                assert!(said.contains("joint angles") && said.contains(" pose "), "{what}: {said}");
                assert!(said.contains(" where the plan has "), "{what}: {said}");
            } else {
                assert_eq!(found.kind, DifferenceKind::Unreadable, "{what}: {said}");
                assert!(said.contains("expected") || said.contains("robot"), "{what}: {said}");
            }
        }
    }
}

#[test]
fn a_move_of_another_way_is_found_where_it_stands() {
    for case in cases() {
        let (by_joints, straight) = match case.dialect.name() {
            "nachi" => (",P,", ",L,"),
            "kuka" => ("PTP ", "LIN "),
            "abb" => ("MoveJ ", "MoveL "),
            "fanuc" => ("J P[", "L P["),
            "ur" => ("movej(", "movel("),
            "yaskawa" => ("MOVJ ", "MOVL "),
            "estun" => ("MovJ{", "MovL{"),
            "csv" => (",joint,", ",linear,"),
            other => panic!("{other}: what does it call its moves?"),
        };
        let places = case.places();
        for i in chosen(&places) {
            let place = &places[i];
            let (from, to) = if place.to.interpolation == Interpolation::Joint {
                (by_joints, straight)
            } else {
                (straight, by_joints)
            };
            let mut files = case.files.clone();
            let file = files.iter_mut().find(|f| f.name == place.line.file).expect("its file");
            let mut lines: Vec<String> = file.text.lines().map(str::to_owned).collect();
            let line = &mut lines[place.line.line - 1];
            *line = if line.contains("MoveAbsJ ") { line.replace("MoveAbsJ ", to) } else { line.replacen(from, to, 1) };
            file.text = lines.join("\n") + "\n";
            let findings = case.findings(&files);
            // Straight on from joint angles: told at these, and both lines are named.
            let both = format!("{}, line {} goes straight on", place.line.file, place.line.line);
            let is_there = |f: &Finding| (&f.file, f.line) == (&place.line.file, place.line.line);
            let found = findings.iter().any(|f| is_there(f) || f.sentence().contains(&both));
            assert!(found, "{}, move {i}: {findings:?}", case.name());
        }
    }
}

#[test]
fn another_configuration_is_found() {
    let changes = [
        ("nachi", "H=1,MS", "H=1,CONF=1,MS"),
        ("abb", "[0,0,0,0]", "[0,1,0,0]"),
        ("fanuc", "CONFIG : 'N", "CONFIG : 'F"),
        ("yaskawa", "///RCONF 0,0", "///RCONF 0,1"),
        ("estun", "cf1=0", "cf1=1"),
    ];
    let cases: Vec<Case> = cases().into_iter().filter(|c| c.setup.robot.is_none()).collect();
    for (dialect, was, is) in changes {
        let case = cases.iter().find(|c| c.dialect.name() == dialect).expect("a dialect");
        let mut files = case.files.clone();
        let file = files.iter_mut().find(|f| f.text.contains(was)).unwrap_or_else(|| panic!("{dialect}: no {was}"));
        file.text = file.text.replacen(was, is, 1);
        let findings = case.findings(&files);
        assert!(!findings.is_empty() && findings.iter().all(|f| f.line > 0), "{dialect}: {findings:?}");
    }
    // KRL's status and turn are not written: poses of a PTP that have them are another target.
    let kuka = cases.iter().find(|c| c.dialect.name() == "kuka").expect("a dialect");
    let places = kuka.places();
    let mut files = kuka.files.clone();
    let mut lines: Vec<String> = files[0].text.lines().map(str::to_owned).collect();
    let line = &mut lines[places[1].line.line - 1];
    *line = line.replace('}', ",S 2,T 10}");
    files[0].text = lines.join("\n") + "\n";
    let found: Vec<usize> = kuka.findings(&files).iter().map(|f| f.line).collect();
    assert_eq!(found, [places[1].line.line]);
}
