//! One target of a written program put in other words of its dialect, as a pendant would after teaching it anew.

use clearbeam::cell::Setup;
use clearbeam::part::rpy;
use clearbeam::program::ProgramFile;
use clearbeam::program::dialect::{Goal, ReadLine};

/// Joint angles, or X, Y, Z in mm and the angles about Z, Y and X in degrees, printed.
enum Six {
    Joints([String; 6]),
    Pose([String; 6]),
}

impl Six {
    fn of(setup: &Setup, goal: &Goal) -> Six {
        let printed = |n: [f64; 6]| n.map(|v| format!("{v:.4}"));
        let flange = match goal {
            Goal::Joints(joints) => return Six::Joints(printed(*joints)),
            Goal::Flange(at) => *at,
            Goal::Focus(focus) => setup.flange_for(focus),
        };
        let [x, y, z]: [f64; 3] = flange.translation.vector.into();
        let [rz, ry, rx] = rpy::from_rotation(&flange.rotation.to_rotation_matrix());
        Six::Pose(printed([x, y, z, rz, ry, rx]))
    }

    /// Each with its name before it.
    fn named(&self, joints: [&str; 6], pose: [&str; 6], between: &str) -> String {
        let (names, numbers) = match self {
            Six::Joints(n) => (joints, n),
            Six::Pose(n) => (pose, n),
        };
        let fields: Vec<String> = names.iter().zip(numbers).map(|(name, n)| format!("{name}{between}{n}")).collect();
        fields.join(",")
    }
}

/// The program with the move of one line going to `goal`, and the line that it then stands in.
pub fn retargeted(
    dialect: &str,
    setup: &Setup,
    files: &[ProgramFile],
    at: &ReadLine,
    goal: &Goal,
) -> (Vec<ProgramFile>, usize) {
    let mut files = files.to_vec();
    let main = files.iter().position(|f| f.name == at.file).expect("its file");
    let mut lines: Vec<String> = files[main].text.lines().map(str::to_owned).collect();
    let i = at.line - 1;
    let six = Six::of(setup, goal);
    match dialect {
        "nachi" => lines[i] = nachi(&lines[i], &six),
        "kuka" => {
            let axes = ["A1", "A2", "A3", "A4", "A5", "A6"];
            let (head, rest) = lines[i].split_once('{').expect("a target");
            let (_, tail) = rest.split_once('}').expect("a target");
            lines[i] = format!("{head}{{{}}}{tail}", six.named(axes, ["X", "Y", "Z", "A", "B", "C"], " "));
        }
        "abb" => lines[i] = abb(&lines[i], setup, goal),
        "ur" => lines[i] = ur(&lines[i], setup, goal),
        "csv" => lines[i] = csv(&lines[i], setup, goal),
        "fanuc" => fanuc(&mut lines, i, &six),
        "yaskawa" => yaskawa(&mut lines, i, setup, goal, &six),
        "estun" => {
            let data = files.iter_mut().find(|f| f.name.ends_with(".erd")).expect("points");
            data.text = estun(&data.text, &lines[i], &six);
        }
        other => panic!("{other}: how does it say a target?"),
    }
    let more = lines.len() - files[main].text.lines().count();
    files[main].text = lines.join("\n") + "\n";
    (files, at.line + more)
}

fn nachi(line: &str, six: &Six) -> String {
    let (head, rest) = line.split_once("M1").expect("a move");
    let (way, rest) = rest[1..].split_once('(').expect("numbers");
    let (_, tail) = rest.split_once(')').expect("numbers");
    match six {
        Six::Joints(n) => format!("{head}M1J{way}({}){tail}", n.join(",")),
        Six::Pose(n) => format!("{head}M1X{way}({}){tail}", n.join(",")),
    }
}

fn abb(line: &str, setup: &Setup, goal: &Goal) -> String {
    let none = ["9E9"; 6].join(",");
    let (head, tail) = line.split_once("]],").expect("a target");
    let word = head.trim_start().split(' ').next().expect("a word");
    let focus = match goal {
        Goal::Joints(joints) => {
            return format!("MoveAbsJ [[{}],[{none}]],{tail}", joints.map(|j| format!("{j:.4}")).join(","));
        }
        Goal::Flange(flange) => setup.focus_for(flange),
        Goal::Focus(focus) => *focus,
    };
    let (t, q) = (focus.translation.vector, focus.rotation);
    let word = if word == "MoveAbsJ" { "MoveJ" } else { word };
    format!(
        "{word} [[{:.4},{:.4},{:.4}],[{:.9},{:.9},{:.9},{:.9}],[0,0,0,0],[{none}]],{tail}",
        t.x, t.y, t.z, q.w, q.i, q.j, q.k
    )
}

fn ur(line: &str, setup: &Setup, goal: &Goal) -> String {
    let (head, rest) = line.split_once('(').expect("a move");
    let (_, tail) = rest.split_once(']').expect("a target");
    let list = |n: [f64; 6]| n.map(|v| format!("{v:.7}")).join(", ");
    let flange = match goal {
        Goal::Joints(joints) => return format!("{head}([{}]{tail}", list(joints.map(f64::to_radians))),
        Goal::Flange(at) => *at,
        Goal::Focus(focus) => setup.flange_for(focus),
    };
    let (t, r) = (flange.translation.vector / 1000.0, flange.rotation.scaled_axis());
    format!("{head}(p[{}]{tail}", list([t.x, t.y, t.z, r.x, r.y, r.z]))
}

/// Columns 3 to 9 are the flange, to 16 the focus, to 22 the joints.
fn csv(line: &str, setup: &Setup, goal: &Goal) -> String {
    let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
    let mut flange = vec![String::new(); 7];
    let mut joints = vec![String::new(); 6];
    match goal {
        Goal::Joints(j) => joints = j.map(|v| format!("{v:.9}")).to_vec(),
        Goal::Flange(_) | Goal::Focus(_) => {
            let at = if let Goal::Focus(focus) = goal { setup.flange_for(focus) } else { flange_of(goal) };
            let (t, q) = (at.translation.vector, at.rotation);
            flange = [t.x, t.y, t.z, q.w, q.i, q.j, q.k].map(|v| format!("{v:.9}")).to_vec();
        }
    }
    cells.splice(3..10, flange);
    cells.splice(10..17, vec![String::new(); 7]);
    cells.splice(17..23, joints);
    cells.join(",")
}

fn flange_of(goal: &Goal) -> nalgebra::Isometry3<f64> {
    let Goal::Flange(at) = goal else { panic!("a flange pose") };
    *at
}

/// The position behind `/POS` that the instruction names.
fn fanuc(lines: &mut [String], i: usize, six: &Six) {
    let number = lines[i].split_once("P[").and_then(|(_, t)| t.split_once(']')).expect("a position").0.to_owned();
    let at = lines.iter().position(|l| *l == format!("P[{number}]{{")).expect("among the positions");
    let frames = lines[at + 2].split("\tCONFIG").next().expect("frames").to_owned();
    let deg = |names: [&str; 3], n: &[String]| {
        let fields: Vec<String> = names.iter().zip(n).map(|(name, n)| format!("\t{name}= {n} deg")).collect();
        fields.join(",")
    };
    match six {
        Six::Joints(n) => {
            lines[at + 2] = frames;
            lines[at + 3] = deg(["J1", "J2", "J3"], &n[..3]) + ",";
            lines[at + 4] = deg(["J4", "J5", "J6"], &n[3..]);
        }
        Six::Pose([x, y, z, rz, ry, rx]) => {
            lines[at + 2] = format!("{frames}\tCONFIG : 'N U T, 0, 0, 0',");
            lines[at + 3] = format!("\tX = {x} mm,\tY = {y} mm,\tZ = {z} mm,");
            lines[at + 4] = deg(["W", "P", "R"], &[rx.clone(), ry.clone(), rz.clone()]);
        }
    }
}

/// The position that the instruction names, with what has to stand before and behind a change of kind; the
/// instructions go down by so many lines.
fn yaskawa(lines: &mut Vec<String>, i: usize, setup: &Setup, goal: &Goal, six: &Six) {
    let name = lines[i].split_whitespace().nth(1).expect("a position").to_owned();
    let at = lines.iter().position(|l| l.starts_with(&format!("{name}="))).expect("among the positions");
    let tool = format!("///TOOL {}", setup.cell.yaskawa.tool);
    let per_deg = setup.cell.yaskawa.pulses_per_deg.expect("pulses");
    let base = |figure: &str| [&tool, "///POSTYPE BASE", "///RECTAN", figure].map(str::to_owned).to_vec();
    let pulse = [&tool, "///POSTYPE PULSE", "///PULSE"].map(str::to_owned).to_vec();
    let figure = lines[..at].iter().rfind(|l| l.starts_with("///RCONF")).cloned();
    let figure = figure.unwrap_or("///RCONF 0,0,0,0,0,0,0,0".into());
    let (before, said, behind) = match (goal, six) {
        (Goal::Joints(joints), _) => {
            let pulses: Vec<String> = (0..6).map(|j| format!("{:.0}", joints[j] * per_deg[j])).collect();
            (pulse, pulses.join(","), base(&figure))
        }
        (_, Six::Pose([x, y, z, rz, ry, rx])) => {
            (base(&figure), [x, y, z, rx, ry, rz].map(String::as_str).join(","), pulse)
        }
        (_, Six::Joints(_)) => panic!("a pose is none"),
    };
    let follows = lines.get(at + 1).is_some_and(|l| l.starts_with('C'));
    let mut with = before;
    with.push(format!("{name}={said}"));
    with.extend(behind.into_iter().filter(|_| follows));
    lines.splice(at..=at, with);
}

/// The point that the instruction names.
fn estun(data: &str, instruction: &str, six: &Six) -> String {
    let name = instruction.split_once("P=t_l.").and_then(|(_, t)| t.split_once(',')).expect("a point").0;
    let axes = ["a1", "a2", "a3", "a4", "a5", "a6"];
    let none: String = (7..=16).map(|k| format!(",a{k}=0.0000000")).collect();
    let numbers = six.named(axes, ["x", "y", "z", "a", "b", "c"], "=");
    let kind = match six {
        Six::Joints(_) => "_type=\"APOS\"".to_owned(),
        Six::Pose(_) => {
            "_type=\"CPOS\",confdata={_type=\"POSCFG\",mode=0,cf1=0,cf2=0,cf3=0,cf4=0,cf5=0,cf6=0}".to_owned()
        }
    };
    let line = format!("{name}={{{kind},{numbers}{none}}}");
    let lines: Vec<&str> =
        data.lines().map(|l| if l.starts_with(&format!("{name}=")) { line.as_str() } else { l }).collect();
    lines.join("\n") + "\n"
}
