//! What keeps the code livable: rooms import one way, files run in no circle, every file says what it is for.
//!
//! `use` declarations and paths that begin with `crate` or `super` are read as text; a name that a `mod.rs` passes on
//! is followed to its file. Test modules do not count, since tests of a room may use samples made above it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms of ARCHITECTURE.md, the lowest first. What stands beside them may be used by all.
const ROOMS: [&str; 17] = [
    "part", "sample", "scan", "weld", "path", "beam", "pose", "process", "cell", "program", "document", "planning",
    "view", "picture", "text", "cli", "app",
];

/// A module's path, such as `["part", "stl"]`.
type Module = Vec<String>;

/// Every module below `src` with its text, comments and test modules left out.
fn modules() -> BTreeMap<Module, String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut out = BTreeMap::new();
    for file in rust_files(&root) {
        let name = file.strip_prefix(&root).expect("below src").with_extension("");
        let mut module: Module = name.iter().map(|p| p.to_string_lossy().into_owned()).collect();
        let last = module.last().expect("named").clone();
        if last.ends_with("tests") || module.contains(&"tests".into()) || last == "main" || last == "lib" {
            continue;
        }
        if last == "mod" {
            module.pop();
        }
        let text = fs::read_to_string(&file).expect("readable");
        let without = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
        let bare: Vec<&str> = without.lines().map(|l| l.split("//").next().unwrap_or_default()).collect();
        out.insert(module, bare.join("\n"));
    }
    out
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut out = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            out.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            out.push(path);
        }
    }
    out.sort();
    out
}

/// `a::{b, c::{d, e}}` as `a::b`, `a::c::d`, `a::c::e`.
fn expanded(tree: &str) -> Vec<String> {
    let Some(open) = tree.find('{') else {
        return vec![tree.split(" as ").next().unwrap_or_default().trim().to_owned()];
    };
    let (before, rest) = (tree[..open].trim(), &tree[open + 1..]);
    let (mut depth, mut parts) = (0, vec![String::new()]);
    for c in rest.chars() {
        match c {
            '}' if depth == 0 => break,
            ',' if depth == 0 => parts.push(String::new()),
            _ => {
                depth += i32::from(c == '{') - i32::from(c == '}');
                parts.last_mut().expect("one at least").push(c);
            }
        }
    }
    let parts = parts.iter().filter(|p| !p.trim().is_empty());
    parts.flat_map(|p| expanded(p)).map(|p| format!("{before}{p}")).collect()
}

/// What a module names: the path, and whether it is passed on.
fn named(text: &str) -> Vec<(String, bool)> {
    let mut out = Vec::new();
    let mut rest = String::new();
    for statement in text.split_inclusive(';') {
        let begin =
            statement.rfind("use ").filter(|i| statement[..*i].chars().next_back().is_none_or(char::is_whitespace));
        let Some(begin) = begin.filter(|i| !statement[*i..].contains('(')) else {
            rest.push_str(statement);
            continue;
        };
        let line = statement[..begin].rsplit('\n').next().unwrap_or_default().trim();
        let paths = expanded(statement[begin + 4..].trim_end_matches(';'));
        out.extend(paths.into_iter().map(|p| (p, line.starts_with("pub"))));
        rest.push_str(&statement[..begin]);
    }
    for start in ["crate::", "super::"] {
        for (at, _) in rest.match_indices(start) {
            let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
            let preceded = rest[..at].chars().next_back().is_some_and(is_path);
            let path: String = rest[at..].chars().take_while(|c| is_path(*c)).collect();
            if !preceded {
                out.push((path.trim_end_matches(':').to_owned(), false));
            }
        }
    }
    out
}

/// A path as it is from the crate's root; `None`: it leads out of the crate.
fn from_root(module: &Module, path: &str, modules: &BTreeMap<Module, String>) -> Option<Module> {
    let mut parts: Vec<String> = path.split("::").map(str::to_owned).collect();
    let mut base = module.clone();
    match parts[0].as_str() {
        "crate" => base.clear(),
        "self" => {}
        "super" => {
            while parts.first().is_some_and(|p| p == "super") {
                base.pop();
                parts.remove(0);
            }
            return Some([base, parts].concat());
        }
        first => {
            let child = [base.clone(), vec![first.to_owned()]].concat();
            return modules.contains_key(&child).then(|| [base, parts].concat());
        }
    }
    parts.remove(0);
    Some([base, parts].concat())
}

/// Which module uses which others.
fn imports() -> BTreeMap<Module, BTreeSet<Module>> {
    let modules = modules();
    let names: BTreeMap<&Module, Vec<(String, bool)>> = modules.iter().map(|(m, t)| (m, named(t))).collect();
    let mut passed_on: BTreeMap<Module, Module> = BTreeMap::new();
    for (module, list) in &names {
        for to in list.iter().filter(|n| n.1).filter_map(|n| from_root(module, &n.0, &modules)) {
            let name = to.last().expect("named").clone();
            passed_on.insert([(*module).clone(), vec![name]].concat(), to);
        }
    }
    let file_of = |mut path: Module| {
        for _ in 0..path.len() + 8 {
            // A function may have the name of a module beside it.
            let is_passed_on = |n: &usize| passed_on.contains_key(&path[..*n]) && !modules.contains_key(&path[..*n]);
            let known = (1..=path.len()).rev().find(is_passed_on);
            let Some(n) = known else { break };
            path = [passed_on[&path[..n]].clone(), path[n..].to_vec()].concat();
        }
        (1..=path.len()).rev().map(|n| path[..n].to_vec()).find(|m| modules.contains_key(m))
    };
    let mut out: BTreeMap<Module, BTreeSet<Module>> = BTreeMap::new();
    for (module, list) in &names {
        let used = list.iter().filter(|n| !n.1).filter_map(|n| from_root(module, &n.0, &modules)).filter_map(file_of);
        out.insert((*module).clone(), used.filter(|u| u != *module).collect());
    }
    out
}

#[test]
fn rooms_import_only_from_rooms_below() {
    let rank = |m: &Module| ROOMS.iter().position(|r| *r == m[0]);
    let mut upwards = Vec::new();
    for (module, used) in imports() {
        for other in used {
            if let (Some(a), Some(b)) = (rank(&module), rank(&other))
                && b > a
            {
                upwards.push(format!("{} uses {}", module.join("/"), other.join("/")));
            }
        }
    }
    assert!(upwards.is_empty(), "{upwards:#?}");
}

#[test]
fn files_import_each_other_in_no_circle_but_through_their_folder() {
    let all = imports();
    // A folder's own file and what lies below it may know each other.
    let is_own = |a: &Module, b: &Module| a.starts_with(b) || b.starts_with(a);
    let next = |m: &Module| all[m].iter().filter(|o| !is_own(m, o)).cloned().collect::<Vec<_>>();
    let reached = |from: &Module| {
        let (mut seen, mut open) = (BTreeSet::new(), next(from));
        while let Some(m) = open.pop() {
            if seen.insert(m.clone()) {
                open.extend(next(&m));
            }
        }
        seen
    };
    let circle: Vec<String> = all.keys().filter(|m| reached(m).contains(*m)).map(|m| m.join("/")).collect();
    assert!(circle.is_empty(), "files in a circle: {circle:#?}");
}

#[test]
fn every_file_says_what_it_is_for_and_stays_a_room() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut sizes = Vec::new();
    for file in rust_files(&root) {
        let text = fs::read_to_string(&file).expect("readable");
        assert!(text.starts_with("//! "), "{}: say what it is for", file.display());
        let lines = text.lines().count();
        assert!(lines <= 600, "{}: {lines} lines; cut it", file.display());
        // What only lists others is no room.
        if file.file_name().is_some_and(|n| n != "mod.rs") {
            sizes.push(lines);
        }
    }
    sizes.sort_unstable();
    let median = sizes[sizes.len() / 2];
    assert!((90..=250).contains(&median), "the median file has {median} lines");
}
