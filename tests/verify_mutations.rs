//! Every change of a program that acts is found, and none that does not: each number and each word of each line changed,
//! each line dropped, doubled, swapped with the next one and given another kind, in a small program of each dialect.

#[path = "common/small_programs.rs"]
mod small_programs;

use clearbeam::program::ProgramFile;
use rayon::prelude::*;
use small_programs::{Case, cases};

/// What a changed line comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Line {
    /// It does something.
    Acts,
    /// A comment, wherever it stands.
    Comment,
    /// Kept by the controller for itself, in its place.
    Attribute,
}

/// What a line is, told by the rules of its language and not by the reader's.
fn kind(case: &Case, file: &ProgramFile, lines: &[String], i: usize) -> Line {
    let text = lines[i].trim_start();
    let is = |starts: &[&str]| starts.iter().any(|s| text.starts_with(s));
    let (comment, attribute) = match case.dialect.name() {
        "nachi" => (is(&["REM"]), false),
        // Of a data list only SIGNALs act, and there are none.
        "kuka" => (is(&[";"]), is(&["&"]) || file.name.ends_with(".dat")),
        "abb" => (is(&["!"]), false),
        "fanuc" => {
            let before = |mark: &str| lines[..i].iter().any(|l| l == mark);
            let is_counted = is(&["DEFAULT_GROUP", "LINE_COUNT"]);
            let code = text.split_once(':').map_or("", |(_, code)| code.trim_start());
            (before("/MN") && code.starts_with('!'), before("/ATTR") && !before("/MN") && !is_counted && text != "/MN")
        }
        "ur" => (is(&["#"]), false),
        "yaskawa" => (is(&["'"]), is(&["///DATE", "///COMM"])),
        "estun" => (is(&["/*"]), false),
        "csv" => (text.starts_with("# a part") || text.starts_with("# clearbeam 0"), false),
        other => panic!("{other}: what are its comments?"),
    };
    match (comment, attribute) {
        (true, _) => Line::Comment,
        (_, true) => Line::Attribute,
        _ => Line::Acts,
    }
}

/// Where runs of such characters stand.
fn runs(text: &str, of: impl Fn(char) -> bool) -> Vec<(usize, usize)> {
    let mut out: Vec<(usize, usize)> = Vec::new();
    for (at, _) in text.char_indices().filter(|(_, c)| of(*c)) {
        match out.last_mut() {
            Some((_, end)) if *end == at => *end += 1,
            _ => out.push((at, at + 1)),
        }
    }
    out
}

/// The line with each of its numbers so much higher that it counts, its digits kept.
fn other_numbers(line: &str) -> Vec<String> {
    let digits = runs(line, |c| c.is_ascii_digit() || c == '.');
    let number = |(from, to): &(usize, usize)| {
        let text = &line[*from..*to];
        let (decimals, width) = (text.split_once('.').map_or(0, |(_, d)| d.len()), text.len());
        let plain = !text.contains('.') && text.starts_with('0');
        // A pulse is a thousandth of a degree.
        let least = if line.starts_with("C0") && decimals == 0 { 100.0 } else { 1.0 };
        let value = 1.1 * text.parse::<f64>().ok()? + least;
        let other = if plain { format!("{value:0width$.0}") } else { format!("{value:.decimals$}") };
        Some(format!("{}{other}{}", &line[..*from], &line[*to..]))
    };
    digits.iter().filter_map(number).collect()
}

/// The line with each of its words one letter longer.
fn other_words(line: &str) -> Vec<String> {
    let words = runs(line, |c| c.is_ascii_alphabetic() || c == '_');
    words.iter().map(|(_, to)| format!("{}x{}", &line[..*to], &line[*to..])).collect()
}

/// The line as a move or signal of another kind.
fn retyped(line: &str, dialect: &str) -> Vec<String> {
    let pairs: &[(&str, &str)] = match dialect {
        "nachi" => &[("M1J", "M1X"), (",P,", ",L,"), (",T=", ",R="), ("RESET", "SET"), ("SET O3", "SET O5")],
        "kuka" => &[("PTP ", "LIN "), ("} C_DIS", "}"), ("TRUE", "FALSE"), ("$OUT[3]", "$OUT[5]"), ("CP", "ORI1")],
        "abb" => {
            &[("MoveAbsJ", "MoveJ"), ("MoveJ", "MoveL"), ("MoveAbsJ", "MoveL"), (",fine,", ",z0,"), (",1;", ",0;")]
        }
        "fanuc" => &[("J P[", "L P["), ("FINE", "CNT100"), ("msec", "sec"), ("=ON", "=OFF"), ("DO[3]", "DO[5]")],
        "ur" => &[("movej", "movel"), ("(p[", "(["), ("True", "False"), (", t=", ", r="), ("_out(3", "_out(5")],
        "yaskawa" => &[("MOVJ", "MOVL"), ("PL=0", "PL=1"), (" V=", " VR="), (") ON", ") OFF"), ("#(3)", "#(5)")],
        "estun" => &[("MovJ", "MovL"), ("APOS", "CPOS"), ("Val=1", "Val=0"), ("DO3", "DO5")],
        _ => &[(",joint,", ",linear,"), ("output,", "group,"), ("wait,", "group,"), (",1,", ",0,")],
    };
    let both = pairs.iter().flat_map(|(a, b)| [(a, b), (b, a)]);
    both.filter(|(a, _)| line.contains(**a)).map(|(a, b)| line.replacen(a, b, 1)).collect()
}

/// Whether the numbers that two names in an instruction stand for are the same: the change then leads nowhere else.
fn names_the_same(case: &Case, file: &ProgramFile, was: &str, is: &str) -> bool {
    // A position itself is no name of one.
    let name = |line: &str| -> Option<String> {
        if line.starts_with("C0") {
            return None;
        }
        match case.dialect.name() {
            "fanuc" => Some(format!("P[{}]{{", line.split_once("P[")?.1.split_once(']')?.0)),
            "yaskawa" => Some(format!("{}=", line.split_whitespace().find(|w| w.starts_with("C0"))?)),
            "estun" => Some(format!("{}=", line.split_once("P=t_l.")?.1.split(',').next()?)),
            _ => None,
        }
    };
    let of = |name: &str| -> Vec<String> {
        let own = case.files.iter().filter(|f| f.name == file.name || f.name.ends_with(".erd"));
        let from = own.flat_map(|f| f.text.lines()).skip_while(|l| !l.starts_with(name));
        let lines: Vec<&str> = from.take(if name.ends_with('{') { 5 } else { 1 }).collect();
        lines.iter().map(|l| l.replace(name, "")).collect()
    };
    match (name(was), name(is)) {
        (Some(a), Some(b)) if a != b => of(&a) == of(&b),
        _ => false,
    }
}

/// Swaps of two lines that are run in the same order all the same.
fn runs_the_same(file: &ProgramFile, a: &str, b: &str) -> bool {
    let (a, b) = (a.trim(), b.trim());
    a == b
        // Points and speeds are called by their names.
        || file.name.ends_with(".erd")
        // The function that is called first, or next, begins around what is run before it.
        || ((a == "end" || a.starts_with("set_tcp")) && b.starts_with("def "))
        || (a == "def Clean1():" && b.starts_with("set_standard_digital_out"))
        // All positions have the same tool.
        || (a.starts_with("C0") && b.starts_with("///TOOL "))
}

/// What says again what counts already.
fn says_nothing_new(line: &str) -> bool {
    // The last of a table's conventions, behind which comments may stand.
    ["///TOOL ", "///RCONF ", "LINE_COUNT", "DEFAULT_GROUP", "# number, value"]
        .iter()
        .any(|word| line.starts_with(word))
}

/// Of Yaskawa's attributes the controller's user sets all but `RJ`; FANUC counts the lines of a program anew whenever it
/// shows or loads it, and `LINE_COUNT` with them.
fn is_the_controllers(case: &Case, was: &str, is: &str) -> bool {
    let code = |t: &str| t.split_once(':').map(|(n, code)| (n.trim().parse::<u32>().is_ok(), code.to_owned()));
    let is_number = || matches!((code(was), code(is)), (Some((true, a)), Some((true, b))) if a == b);
    match case.dialect.name() {
        "yaskawa" => is.starts_with("///ATTR ") && is.ends_with(",RJ"),
        "fanuc" => is.starts_with("LINE_COUNT =") || is_number(),
        _ => false,
    }
}

struct Mutations<'a> {
    case: &'a Case,
    file: usize,
    lines: Vec<String>,
    /// Lines without their digits, of which the words were changed.
    seen: Vec<String>,
    /// What was changed, the files, and whether it has to be found.
    all: Vec<(String, Vec<ProgramFile>, bool)>,
}

impl Mutations<'_> {
    fn of(case: &Case, file: usize) -> Mutations<'_> {
        let lines = case.files[file].text.lines().map(str::to_owned).collect();
        let mut m = Mutations { case, file, lines, seen: Vec::new(), all: Vec::new() };
        (0..m.lines.len()).for_each(|i| m.line(i));
        m
    }

    fn add(&mut self, what: &str, i: usize, with: Vec<String>, acts: bool) {
        let mut files = self.case.files.clone();
        let now: Vec<String> = [&self.lines[..i], &with[..], &self.lines[(i + 1).min(self.lines.len())..]].concat();
        files[self.file].text = now.join("\n") + "\n";
        let place = format!("{}, {}:{}", self.case.name(), files[self.file].name, i + 1);
        self.all.push((format!("{place} {what}: {:?} -> {with:?}", self.lines[i]), files, acts));
    }

    fn line(&mut self, i: usize) {
        let (case, file, line) = (self.case, &self.case.files[self.file], self.lines[i].clone());
        let what = kind(case, file, &self.lines, i);
        // Rows of a table are counted, and a comment in it is one.
        let acts = what == Line::Acts;
        if case.dialect.name() == "csv" && line.contains(",say,") {
            return;
        }
        // Where there are no positions, nothing says where they would begin.
        let is_empty_section = line == "/POS" && self.lines.get(i + 1).is_some_and(|next| next == "/END");
        self.add("dropped", i, Vec::new(), acts && !is_empty_section);
        self.add("doubled", i, vec![line.clone(), line.clone()], acts && !says_nothing_new(&line));
        for other in retyped(&line, case.dialect.name()).into_iter().filter(|_| acts) {
            self.add("retyped", i, vec![other], true);
        }
        // Moves have the same words: those of the first are enough, and with the robot its numbers.
        let shape = line.replace(|c: char| c.is_ascii_digit() || c == '-', "");
        let is_new = !self.seen.contains(&shape);
        self.seen.push(shape);
        for other in other_numbers(&line).into_iter().filter(|_| is_new || case.setup.robot.is_none()) {
            let is_idle = names_the_same(case, file, &line, &other) || is_the_controllers(case, &line, &other);
            self.add("number", i, vec![other], acts && !is_idle);
        }
        for other in other_words(&line).into_iter().filter(|_| is_new) {
            // The word that makes it a comment.
            let was_comment = other.starts_with("REMx");
            let acts = (acts && !is_the_controllers(case, &line, &other)) || was_comment;
            self.add("word", i, vec![other], acts);
        }
        self.swapped(i, what);
    }

    fn swapped(&mut self, i: usize, what: Line) {
        let Some(next) = self.lines.get(i + 1).cloned() else { return };
        let file = &self.case.files[self.file];
        let both = [what, kind(self.case, file, &self.lines, i + 1)];
        // Attributes have their place, and so has what begins a section.
        let is_section = |l: &str| l.starts_with('/') || l == "NOP" || self.case.dialect.name() == "csv";
        let line = self.lines[i].clone();
        if both.contains(&Line::Attribute) || (both != [Line::Acts; 2] && [&line, &next].iter().any(|l| is_section(l)))
        {
            return;
        }
        let acts = both == [Line::Acts; 2] && !runs_the_same(file, &line, &next);
        let mut files = self.case.files.clone();
        let mut lines = self.lines.clone();
        lines.swap(i, i + 1);
        files[self.file].text = lines.join("\n") + "\n";
        let place = format!("{}, {}:{}", self.case.name(), files[self.file].name, i + 1);
        self.all.push((format!("{place} swapped: {line:?} and {next:?}"), files, acts));
    }
}

#[test]
fn every_change_that_acts_is_found_and_none_that_does_not() {
    let wrong: Vec<String> = cases()
        .par_iter()
        .flat_map(|case| {
            let plan = case.as_written();
            assert!(!case.is_found(&plan, &case.files), "{}: {:?}", case.name(), case.differences(&plan, &case.files));
            let all: Vec<_> = (0..case.files.len()).flat_map(|f| Mutations::of(case, f).all).collect();
            assert!(all.len() > 200, "{}: {}", case.name(), all.len());
            let wrong = all.into_iter().filter(|(_, files, acts)| case.is_found(&plan, files) != *acts);
            wrong.map(|(what, _, acts)| format!("{} {what}", if acts { "PASSED" } else { "FOUND" })).collect::<Vec<_>>()
        })
        .collect();
    assert!(wrong.is_empty(), "{} of them:\n{}", wrong.len(), wrong.join("\n"));
}
