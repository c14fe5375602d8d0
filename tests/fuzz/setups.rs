//! Cells, robots and heads. A cell that is read is tried in every dialect, and a robot moves.

use crate::documents::{WORDS, files_of};
use crate::run::{Kind, check_sentence, outline, run};
use clearbeam::beam::Head;
use clearbeam::cell::{Cell, Robot, Setup};
use clearbeam::program::dialects;
use clearbeam::text::Sentence;

const CELL_WORDS: [&str; 30] = [
    "{n}",
    "{v}",
    "{s}",
    "{}",
    "{",
    "}",
    "SET O{n}",
    "as = \"group\"\n",
    "as = \"analogue\"\n",
    "during = \"piece\"\n",
    "on_wait_s = 0.5\n",
    "three_points = ",
    "points = ",
    "tip_poses = ",
    "[outputs.power]\n",
    "[bodies]\n",
    "[[bodies.head]]\nfrom_mm = 0\nto_mm = 9\nradius_mm = 4\n",
    "[[bodies.obstacles]]\nfile = \"none.stl\"\n",
    "table_z_mm = 0.0\n",
    "[timing]\n",
    "[air]\n",
    "[nachi]\n",
    "[kuka]\n",
    "[ur]\n",
    "\"M1X\"",
    "\"tool-in-hand\"",
    "[0.0, 0.0, 0.0]",
    "[1, 2, 3, 4, 5, 6]",
    "max_moves = 1\n",
    "\n",
];

const HEAD: &str = "[[part]]\nfrom_mm = 10\nto_mm = 60\nr0_mm = 4\nr1_mm = 20\n[[part]]\nfrom_mm = 60.5\nto_mm = 90.0\n\
    r0_mm = 20.0\nr1_mm = 0.0\n";

const OUTPUTS: &str = "base_from_laser = { three_points = { origin_mm = [0, 0, 0], on_x_mm = [1, 0, 0], on_xy_mm = [0, 1, 0] } }\n\
    [outputs]\nlaser = { number = 3 }\nshielding_gas = { number = 5, on_wait_s = 0.5, off_wait_s = 1.0, during = \
    \"piece\" }\npower = { as = \"group\", number = 2, scale = 0.255 }\n";

/// Reads by way of a file, as they are given by name.
fn by_file<T>(name: &str, bytes: &[u8], folder: &tempfile::TempDir, load: impl Fn(&std::path::Path) -> T) -> T {
    let file = folder.path().join(name);
    std::fs::write(&file, bytes).expect("writes");
    load(&file)
}

fn read_cell(bytes: &[u8], folder: &tempfile::TempDir, shipped: &Setup) -> String {
    let cell = match by_file("cell.toml", bytes, folder, Cell::load) {
        Ok(cell) => cell,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    for (name, frame) in cell.frames() {
        let pose = frame.isometry();
        assert!(pose.to_matrix().iter().all(|x| x.is_finite()), "{name}: {pose}");
    }
    cell.calibrations().iter().for_each(|note| check_sentence(&note.sentence()));
    let setup = Setup { mount: cell.mount, cell, ..shipped.clone() };
    let placed = setup.check();
    if let Err(e) = &placed {
        check_sentence(&e.sentence());
    }
    let writes: Vec<String> = dialects::names().map(|name| outline(&dialects::check(name, &setup))).collect();
    format!("{} {}", outline(&placed), writes.join(" "))
}

fn read_robot(bytes: &[u8], folder: &tempfile::TempDir) -> String {
    let robot = match by_file("robot.toml", bytes, folder, |file| Robot::load(&file.display().to_string(), None)) {
        Ok(robot) => robot,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    for share in [0.0, 0.3, 0.5, 1.0] {
        let joints = robot.limits_deg.map(|[least, most]| least + share * (most - least));
        let pose = robot.forward(&joints);
        assert!(pose.to_matrix().iter().all(|x| x.is_finite()), "{joints:?}: {pose}");
        let solutions = robot.inverse(&pose);
        assert!(solutions.iter().flatten().flatten().all(|x| x.is_finite()), "{joints:?}: {solutions:?}");
        assert!(robot.singularity(&joints).is_finite() && robot.reach_mm().is_finite());
        let carried_on = robot.nearest_inverse(&pose, &joints);
        assert!(carried_on.is_none_or(|j| robot.beyond(&j).is_none()), "{joints:?}");
    }
    robot.dialect
}

fn read_head(bytes: &[u8], folder: &tempfile::TempDir) -> String {
    match by_file("head.toml", bytes, folder, Head::load) {
        Ok(head) => {
            let is_whole = |mm: f64| mm.abs() <= 10_000.0;
            let parts = head.stack();
            assert!(parts.iter().all(|p| [p.from_mm, p.to_mm, p.r0_mm, p.r1_mm].into_iter().all(is_whole)));
            format!("{} pieces", parts.len().min(9))
        }
        Err(e) => {
            check_sentence(&e.sentence());
            outline(&e)
        }
    }
}

#[test]
fn cells() {
    let (folder, shipped) = (tempfile::tempdir().expect("a folder"), Setup::shipped().expect("shipped"));
    let mut shipped = shipped;
    shipped.robot = Some(Robot::load("mz04", None).expect("shipped"));
    let own = [files_of("assets/cells"), vec![OUTPUTS.into()]].concat();
    let read = |bytes: &[u8]| read_cell(bytes, &folder, &shipped);
    run(&Kind { name: "cell", own, words: &[&CELL_WORDS[..], &WORDS[..24]].concat(), read: &read });
}

#[test]
fn robots() {
    let folder = tempfile::tempdir().expect("a folder");
    let words = ["[opw]\n", "[ur]\n", "[links]\n", "[links.meshes]\n", "signs = ", "limits_deg = "];
    let read = |bytes: &[u8]| read_robot(bytes, &folder);
    run(&Kind { name: "robot", own: files_of("assets/robots"), words: &[&words, &WORDS[..24]].concat(), read: &read });
}

#[test]
fn heads() {
    let folder = tempfile::tempdir().expect("a folder");
    let words = ["[[part]]\n", "from_mm = ", "to_mm = ", "r0_mm = ", "r1_mm = "];
    let read = |bytes: &[u8]| read_head(bytes, &folder);
    run(&Kind { name: "head", own: vec![HEAD.into()], words: &[&words, &WORDS[..24]].concat(), read: &read });
}
