//! Programs of every dialect: what a reader takes is finite, and is compared with the plan whose text was changed.

use crate::bundle::{bundle, unbundled};
use crate::run::{Kind, check_sentence, outline, run};
use crate::small_programs::{Case, cases};
use clearbeam::planning::verify::AsWritten;
use clearbeam::program::dialect::{Goal, ReadContext, ReadLine, Statement};
use clearbeam::program::{MoveTiming, ProgramFile, dialects};
use clearbeam::text::Sentence;
use std::sync::LazyLock;

/// A program of each dialect, with a robot and without.
static CASES: LazyLock<Vec<Case>> = LazyLock::new(cases);

/// Words of no dialect in particular.
const WORDS: [&str; 24] = [
    "%%% ", "\n", "\r\n", " ", "\t", ",", ";", "(", ")", "[", "]", "{", "}", "=", "\"", "'", ":", "\u{feff}", "\u{1a}",
    "\0", "ä", "NaN", "INF", "-",
];

fn files(bytes: &[u8]) -> Vec<ProgramFile> {
    let files = unbundled(bytes).into_iter().map(|(name, text)| ProgramFile { name, text }).collect::<Vec<_>>();
    if files.is_empty() { vec![ProgramFile { name: "empty".into(), text: String::new() }] } else { files }
}

/// Nothing that is not finite gets through a reader: a comparison with it would be true of nothing.
fn check_line(line: &ReadLine) {
    let is_finite = match &line.what {
        Statement::Move(m) => {
            let goal = match &m.goal {
                Goal::Joints(joints) => joints.iter().all(|x| x.is_finite()),
                Goal::Flange(pose) | Goal::Focus(pose) => pose.to_matrix().iter().all(|x| x.is_finite()),
            };
            let (MoveTiming::Seconds(pace) | MoveTiming::Percent(pace)) = m.timing;
            goal && pace.is_finite()
        }
        Statement::OutputValue { value, .. } => value.is_finite(),
        Statement::Force(n) => n.is_finite(),
        Statement::Wait(s) => s.is_finite(),
        Statement::Output { .. } | Statement::Comment(_) | Statement::Other(_) => true,
    };
    assert!(is_finite, "{line:?}");
}

fn read_program(bytes: &[u8], case: &Case, plan: &AsWritten<'_>) -> String {
    let files = files(bytes);
    let open = |name: &str| files.iter().find(|f| f.name == name).map(|f| f.text.clone());
    let is_known = dialects::of_text(&files[0].text).is_some();
    let read = match case.dialect.read(&files[0], &ReadContext { setup: &case.setup, open: &open }) {
        Ok(read) => read,
        Err(e) => {
            check_sentence(&e.sentence());
            return format!("{is_known} {}", outline(&e));
        }
    };
    read.iter().for_each(check_line);
    let found = case.differences(plan, &files).expect("what is read once is read again");
    found.iter().take(3).for_each(|f| check_sentence(&f.sentence()));
    let kinds: Vec<String> = found.iter().take(3).map(|f| format!("{:?}", f.kind)).collect();
    format!("{is_known} {} {}", kinds.join(" "), found.len().min(9))
}

fn run_dialect(name: &str, words: &[&str]) {
    let cases: Vec<&Case> = CASES.iter().filter(|c| c.dialect.name() == name).collect();
    let plans: Vec<AsWritten<'_>> = cases.iter().map(|c| c.as_written()).collect();
    let whole = |c: &&Case| bundle(c.files.iter().map(|f| (f.name.as_str(), f.text.as_str())));
    let own: Vec<Vec<u8>> = cases.iter().map(whole).collect();
    for (own, (case, plan)) in own.iter().zip(cases.iter().zip(&plans)) {
        assert_eq!(read_program(own, case, plan), "true  0", "{} as it is written", case.name());
    }
    let read = |bytes: &[u8]| {
        let outcomes: Vec<String> = cases.iter().zip(&plans).map(|(c, plan)| read_program(bytes, c, plan)).collect();
        outcomes.join("; ")
    };
    run(&Kind { name, own, words: &[words, &WORDS].concat(), read: &read });
}

#[test]
fn nachi() {
    run_dialect(
        "nachi",
        &["MOVEX ", "CALLP ", "A=1", "M1J", "M1X", "M1E", "T=", "R=", "SET O", "DELAY ", "REM ", "END"],
    );
}

#[test]
fn kuka() {
    let words =
        ["DEF ", "END", "LIN ", "PTP ", "CIRC ", "C_DIS", "{X ", "{A1 ", "$OUT[", "$VEL.CP", "WAIT SEC ", "GLOBAL "];
    run_dialect("kuka", &words);
}

#[test]
fn abb() {
    let words =
        ["MODULE ", "ENDMODULE", "PROC ", "ENDPROC", "MoveL ", "MoveAbsJ ", "\\T:=", "9E9", "WaitTime ", "SetDO ", "!"];
    run_dialect("abb", &words);
}

#[test]
fn fanuc() {
    let words =
        ["/PROG ", "/ATTR", "/MN", "/POS", "/END", "P[", "L P[", "CALL ", "DO[", "WAIT ", "UF :", "CONFIG : ", "deg"];
    run_dialect("fanuc", &words);
}

#[test]
fn ur() {
    let words =
        ["def ", "end", "movej(", "movel(", "p[", "t=", "a=", "v=", "r=", "sleep(", "set_digital_out(", "True", "#"];
    run_dialect("ur", &words);
}

#[test]
fn yaskawa() {
    let words = [
        "/JOB",
        "//INST",
        "//POS",
        "///NPOS ",
        "MOVL ",
        "MOVJ ",
        "C00000=",
        "CALL JOB:",
        "TIMER ",
        "DOUT ",
        "NOP",
        "END",
    ];
    run_dialect("yaskawa", &words);
}

#[test]
fn estun() {
    let words = ["Start:", "End;", "MovL{", "MovJ{", "P=", "APOS", "CPOS", "Wait{", "SetDO{", "Val=", "call ", "//"];
    run_dialect("estun", &words);
}

#[test]
fn csv() {
    let words = ["joint,", "linear,", "output,", "group,", "analogue,", "wait,", "# ", "1e9", ",,,"];
    run_dialect("csv", &words);
}
