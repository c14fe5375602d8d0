//! Exports that are broken off behind every single step, and what the next one makes of the folder.

use super::commit::{intended, put_in_place};
use super::conflict::{ConflictReason, ExportOf, FileConflict, MayReplace};
use super::error::ExportError;
use super::folder::ExportFolder;
use super::intent::{CommitStep, ExportIntent};
use super::output_file::OutputFile;
use super::output_file::REPORT;
use super::recovery::Pending;
use crate::planning::report::{FileDigest, WrittenFiles};
use crate::progress::Progress;
use std::collections::BTreeMap;
use std::path::Path;
use tempfile::TempDir;

const NOTES: &str = "notes.txt";

const NOTHING: MayReplace = MayReplace { reads_job: false, overwrite: false };

fn of() -> ExportOf {
    ExportOf { job: "gear".into(), part: "gear.stl".into() }
}

fn written(files: Vec<FileDigest>) -> WrittenFiles {
    let ExportOf { job, part } = of();
    let (plan_sha256, programs) = (String::new(), Vec::new());
    WrittenFiles { job, part, from_pass: None, dry_run: None, plan_sha256, programs, files }
}

fn export_into(dir: &Path, files: &[OutputFile], overwrite: bool) -> Result<Vec<String>, ExportError> {
    put_in_place(dir, files, &of(), MayReplace { reads_job: false, overwrite }, &Progress::default())
}

/// An export whose main program is `first`, and calls the programs behind it. `said`: what the main program says.
fn export(tag: &str, said: &str, programs: std::ops::Range<u32>, tables: &[&str]) -> Vec<OutputFile> {
    let file = |name: &str, text: String| OutputFile { name: name.into(), bytes: text.into_bytes() };
    let program = |n: u32| format!("A.{n:03}");
    let mut out = vec![file("job.toml", format!("job {tag}"))];
    let calls: Vec<String> = programs.clone().skip(1).map(program).collect();
    let main = programs.clone().next().map(|n| file(&program(n), format!("main {said} {}", calls.join(" "))));
    out.extend(main);
    out.extend(calls.iter().map(|name| file(name, format!("sub {tag} {name}"))));
    out.extend(tables.iter().map(|name| file(name, format!("{tag} {name}"))));
    let list = out.iter().map(OutputFile::digest).collect();
    let written = written(list);
    out.push(file(REPORT, serde_json::to_string(&written).expect("JSON")));
    out
}

/// The export before, and the one that is broken off.
fn cases() -> Vec<(Option<Vec<OutputFile>>, Vec<OutputFile>)> {
    let tables = ["path.csv", "joints.csv", "dose.ply"];
    let old = |programs| Some(export("old", "old", programs, &tables));
    let new = |programs| export("new", "new", programs, &tables[..1]);
    vec![
        (None, new(1..4)),
        (old(1..6), new(1..4)),
        (old(1..3), new(1..6)),
        (old(1..4), new(0..0)),
        (old(0..0), new(1..4)),
        (old(1..2), new(1..2)),
        // The old main program has the name of a new subprogram.
        (old(2..6), new(1..5)),
        (old(5..8), new(1..3)),
        // Main programs that are the same, letter by letter, and call others.
        (Some(export("old", "same", 1..4, &tables)), export("new", "same", 1..4, &tables)),
    ]
}

fn files_on_disk(dir: &Path) -> BTreeMap<String, String> {
    let entries = std::fs::read_dir(dir).expect("a folder").map(|e| e.expect("an entry"));
    let one = |e: std::fs::DirEntry| {
        (e.file_name().into_string().expect("a name"), std::fs::read_to_string(e.path()).expect("text"))
    };
    entries.map(one).collect()
}

fn expected(files: &[OutputFile]) -> BTreeMap<String, String> {
    let text = |f: &OutputFile| (f.name.clone(), String::from_utf8(f.bytes.clone()).expect("text"));
    files.iter().map(text).chain([(NOTES.to_owned(), "mine".to_owned())]).collect()
}

/// No main program calls what is not there, or what is of different exports.
fn assert_sound(dir: &Path, when: &str) {
    let files = files_on_disk(dir);
    assert_eq!(files.get(NOTES).map(String::as_str), Some("mine"), "{when}");
    for (name, text) in files.iter().filter(|(name, text)| !name.starts_with('.') && text.starts_with("main")) {
        let mut words = text.split(' ').skip(1);
        let said = words.next().expect("what it says");
        let calls: Vec<&str> = words.filter(|w| !w.is_empty()).collect();
        let tag = |call: &&str| {
            let sub = files.get(*call).unwrap_or_else(|| panic!("{when}: {name} calls {call}: {files:?}"));
            sub.split(' ').nth(1).expect("a tag").to_owned()
        };
        let tags: Vec<String> = calls.iter().map(tag).collect();
        let own = if said == "same" { tags.first().map_or(said, String::as_str) } else { said };
        assert!(tags.iter().all(|t| t == own), "{when}: {name} calls others' programs: {files:?}");
    }
}

/// A folder in which an export was broken off behind so many steps; `None`: it has no more.
fn broken_off(old: Option<&[OutputFile]>, new: &[OutputFile], taken: usize) -> Option<TempDir> {
    let dir = tempfile::tempdir().expect("a folder");
    std::fs::write(dir.path().join(NOTES), "mine").expect("writes");
    if let Some(old) = old {
        export_into(dir.path(), old, false).expect("the old export");
    }
    let folder = ExportFolder::open(dir.path()).expect("opens");
    let intent: ExportIntent = intended(&folder, new, &of(), NOTHING).expect("nothing in the way");
    let steps: Vec<CommitStep> = intent.staging(new).into_iter().chain(intent.steps()).collect();
    if taken > steps.len() {
        return None;
    }
    for step in &steps[..taken] {
        intent.apply(&folder, new, step).expect("a step");
    }
    Some(dir)
}

/// Every case, broken off everywhere, with so many exports that come next, each time in a folder of its own.
fn everywhere(count: usize, mut look: impl FnMut(&TempDir, &[OutputFile], &str)) {
    let next = [export("next", "next", 1..3, &["path.csv"]), export("next", "same", 2..4, &[])];
    for (number, (old, new)) in cases().iter().enumerate() {
        let again = old.clone().unwrap_or_else(|| new.clone());
        let next: Vec<&Vec<OutputFile>> = next.iter().chain([new, &again]).collect();
        'steps: for taken in 0.. {
            for turn in 0..count {
                let Some(dir) = broken_off(old.as_deref(), new, taken) else { break 'steps };
                let when = format!("case {number} behind {taken} steps");
                assert_sound(dir.path(), &when);
                look(&dir, next[(number + taken + turn) % next.len()], &when);
            }
        }
    }
}

fn assert_becomes(dir: &Path, next: &[OutputFile], when: &str) {
    export_into(dir, next, false).unwrap_or_else(|e| panic!("{when}: {e}"));
    assert_eq!(files_on_disk(dir), expected(next), "{when}");
}

#[test]
fn the_next_export_ends_right_wherever_one_was_broken_off() {
    everywhere(2, |dir, next, when| assert_becomes(dir.path(), next, when));
}

#[test]
fn ending_a_broken_export_can_be_broken_off_as_well() {
    everywhere(1, |dir, next, when| {
        let folder = ExportFolder::open(dir.path()).expect("opens");
        // One step each time: the next one begins from what is left.
        for _ in 0..100 {
            let pending = Pending::in_folder(&folder, false).expect("reads");
            let Some(step) = pending.steps.iter().find(|s| **s != CommitStep::Sync) else { break };
            pending.apply(&folder, step).expect("a step");
            assert_sound(dir.path(), when);
        }
        drop(folder);
        assert_becomes(dir.path(), next, when);
    });
}

#[test]
fn an_export_whose_new_files_are_gone_leaves_no_mixed_program() {
    everywhere(1, |dir, next, when| {
        let staged: Vec<String> =
            files_on_disk(dir.path()).into_keys().filter(|n| n.starts_with(".clearbeam-export-")).collect();
        let Some(gone) = staged.get(when.len() % staged.len().max(1)) else { return };
        std::fs::remove_file(dir.path().join(gone)).expect("removes");
        let folder = ExportFolder::open(dir.path()).expect("opens");
        super::recovery::recover(&folder, NOTHING).expect("nothing in the way");
        assert_sound(dir.path(), when);
        drop(folder);
        assert_becomes(dir.path(), next, when);
    });
}

#[test]
fn what_was_changed_since_a_crash_is_named_and_kept() {
    everywhere(1, |dir, next, when| {
        let names: Vec<String> = files_on_disk(dir.path()).into_keys().collect();
        let mine = names.iter().filter(|n| !n.starts_with('.') && *n != NOTES && *n != REPORT);
        let Some(name) = mine.max_by_key(|n| (n.starts_with("A."), n.len() * when.len() % 7)) else { return };
        let file = dir.path().join(name);
        std::fs::write(&file, "changed").expect("writes");
        let said = export_into(dir.path(), next, false).expect_err(when);
        let named = |e: &ExportError| matches!(e, ExportError::Conflicts { conflicts, .. } if conflicts.iter().any(|c| c.name == *name));
        assert!(named(&said), "{when}: {said}");
        assert_eq!(std::fs::read_to_string(&file).expect("kept"), "changed", "{when}");
        export_into(dir.path(), next, true).unwrap_or_else(|e| panic!("{when}: {e}"));
        assert_eq!(files_on_disk(dir.path()), expected(next), "{when}");
    });
}

#[test]
fn a_job_that_was_changed_since_a_crash_is_not_put_back() {
    let (old, new) = &cases()[1];
    for taken in 0.. {
        let Some(dir) = broken_off(old.as_deref(), new, taken) else { break };
        let job = dir.path().join("job.toml");
        std::fs::write(&job, "changed").expect("writes");
        let folder = ExportFolder::open(dir.path()).expect("opens");
        super::recovery::recover(&folder, MayReplace { reads_job: true, overwrite: false })
            .expect("nothing in the way");
        assert_sound(dir.path(), &format!("behind {taken} steps"));
        assert_eq!(std::fs::read_to_string(&job).expect("kept"), "changed");
        drop(folder);
        put_in_place(dir.path(), new, &of(), MayReplace { reads_job: true, overwrite: false }, &Progress::default())
            .expect("the job may be replaced");
        assert_eq!(files_on_disk(dir.path()), expected(new));
    }
}

#[test]
fn a_cancelled_export_leaves_the_folder_as_it_was() {
    let dir = tempfile::tempdir().expect("a folder");
    let (old, new) = (export("old", "old", 1..4, &[]), export("new", "new", 1..3, &[]));
    std::fs::write(dir.path().join(NOTES), "mine").expect("writes");
    export_into(dir.path(), &old, false).expect("the old export");
    let cancelled = Progress::default();
    cancelled.cancel();
    let inner = dir.path().join("inner");
    for into in [dir.path(), &inner] {
        let said = put_in_place(into, &new, &of(), NOTHING, &cancelled);
        assert!(matches!(said, Err(ExportError::Cancelled)), "{said:?}");
    }
    assert_eq!(files_on_disk(dir.path()), expected(&old));
}

#[cfg(unix)]
#[test]
fn two_exports_into_one_folder_wait_for_each_other() {
    let dir = tempfile::tempdir().expect("a folder");
    let held = ExportFolder::open(dir.path()).expect("opens");
    assert!(matches!(export_into(dir.path(), &cases()[0].1, false), Err(ExportError::Busy { .. })));
    drop(held);
    export_into(dir.path(), &cases()[0].1, false).expect("free again");
}

#[test]
fn a_list_that_leads_out_of_the_folder_is_none() {
    let outer = tempfile::tempdir().expect("a folder");
    let (victim, dir) = (outer.path().join("victim"), outer.path().join("inner"));
    std::fs::create_dir(&dir).expect("makes");
    std::fs::write(&victim, "mine").expect("writes");
    let sha256 = crate::part::digest_of(b"mine");
    let list = vec![FileDigest { name: "../victim".into(), sha256 }];
    let written = written(list);
    let report = serde_json::to_string(&written).expect("JSON");
    std::fs::write(dir.join(REPORT), &report).expect("writes");
    std::fs::write(dir.join(NOTES), "mine").expect("writes");
    let new = export("new", "new", 1..3, &[]);
    let why = export_into(&dir, &new, false).expect_err("not ours");
    let of_none = FileConflict { name: REPORT.into(), reason: ConflictReason::NoExports };
    assert!(matches!(&why, ExportError::Conflicts { conflicts, .. } if conflicts.contains(&of_none)), "{why:?}");
    export_into(&dir, &new, true).expect("replaced");
    assert_eq!((files_on_disk(&dir), victim.exists()), (expected(&new), true));
}
