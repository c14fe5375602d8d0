//! A program that is killed at any moment loses nothing that it has acknowledged.
//!
//! The test runs itself as a child that works on a job as the window does: edits and undo with the
//! journal, saves, exports. It says before and after each step what it does; the parent kills it, does
//! the same steps on a mirror, and compares what lies on the disk with the state behind the last
//! acknowledged step, or behind the one that was in flight.

#[path = "common/random.rs"]
mod random;

use clearbeam::document::journal::{Journal, left_behind};
use clearbeam::document::save::backup_of;
use clearbeam::document::{Chosen, Document, Edit, IfChanged, Job, files, save, segmented};
use clearbeam::part::{SurfaceId, digest_of};
use clearbeam::planning::export::{ExportInput, ExportOptions, write as export_into};
use clearbeam::planning::{self, PlanCache};
use clearbeam::progress::Progress;
use clearbeam::sample::{solids, stl_bytes};
use clearbeam::text::program_comment;
use random::Random;
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const KILLS: u64 = 100;
const FOLDER: &str = "CLEARBEAM_KILLS_FOLDER";
const SEED: &str = "CLEARBEAM_KILLS_SEED";
/// Opens the child's lines among those of the test harness.
const MARK: &str = "@kills ";

/// What the operator does.
enum Step {
    Edit(Edit),
    Undo,
    Redo,
    Save,
    Export,
}

impl Step {
    fn random(random: &mut Random) -> Step {
        let figure = |random: &mut Random, from: f64| from + random.below(1000) as f64 / 1024.0;
        match random.below(24) {
            0..=5 => Step::Edit(Edit::Set("beam.power_w", figure(random, 300.0))),
            6..=9 => Step::Edit(Edit::Set("layers.spacing_mm", figure(random, 2.0))),
            10..=12 => Step::Edit(Edit::Set("beam.speed_mm_s", figure(random, 5.0))),
            13..=15 => Step::Edit(Edit::Rename(SurfaceId(1), format!("side {}", random.below(1000)))),
            16..=18 => Step::Undo,
            19 => Step::Redo,
            20..=22 => Step::Save,
            _ => Step::Export,
        }
    }
}

/// Where everything is: `job.toml` on `part.stl`, the journal, and what was exported.
struct Desk(PathBuf);

impl Desk {
    fn job(&self) -> PathBuf {
        self.0.join("job.toml")
    }

    fn journal(&self) -> PathBuf {
        self.0.join("journal")
    }

    fn exported(&self) -> PathBuf {
        self.0.join("exported")
    }

    /// A part that is planned in no time, and a job on it.
    fn set_up(&self) {
        std::fs::create_dir_all(&self.0).expect("makes a folder");
        let stl = stl_bytes(&solids::cube(4.0));
        std::fs::write(self.0.join("part.stl"), &stl).expect("writes");
        let mut job = Job::default();
        (job.part.file, job.part.sha256) = ("part.stl".into(), digest_of(&stl));
        job.settings.choose(Chosen::All);
        (job.layers.spacing_mm, job.beam.spot_mm) = (2.0, 4.0);
        save::save(&job, None, &self.job(), IfChanged::Refuse).expect("saves");
    }

    /// Does a step on a document, but for the journal.
    fn take(&self, step: &Step, document: &mut Document) {
        match step {
            Step::Edit(edit) => drop(document.apply(edit, &[], None)),
            Step::Undo => document.undo(),
            Step::Redo => document.redo(),
            Step::Save => document.save(&self.job(), IfChanged::Refuse).expect("saves"),
            Step::Export => export(&self.exported(), document),
        }
    }
}

/// Writes the files of a plan, as the window does.
fn export(folder: &Path, document: &Document) {
    let job = document.job();
    let part = files::load_part(job, document.file()).expect("the part is there");
    let setup = files::load_setup(job, document.file()).expect("a shipped cell");
    let surfaces = segmented(&part, job);
    let plan =
        planning::plan(&part, &surfaces, job, &setup, &PlanCache::default(), &Progress::default()).expect("plans");
    let input = ExportInput {
        job,
        part: &part,
        surfaces: &surfaces,
        setup: &setup,
        plan: &plan,
        findings: &[],
        wording: program_comment,
        options: ExportOptions::default(),
        page: None,
    };
    export_into(folder, &input, document.file(), false, &Progress::default()).expect("writes");
}

/// What an export must have left: each file is whole by itself, and the job is one that was exported.
fn check_export(folder: &Path, before: Option<&Job>, after: Option<&Job>) {
    let path = folder.join("job.toml");
    if before.is_some() || path.exists() {
        let found = files::read(&path).expect("an exported job is whole");
        assert!([before, after].contains(&Some(&found)), "the exported job is one that was exported");
    }
}

/// The child: works until it is killed.
#[test]
#[ignore = "run by the test of kills"]
fn child() {
    let (Ok(folder), Ok(seed)) = (std::env::var(FOLDER), std::env::var(SEED)) else { return };
    let desk = Desk(folder.into());
    let mut random = Random(seed.parse().expect("a number"));
    let mut journal = Journal::open(Some(&desk.journal())).expect("opens");
    let mut document = match left_behind(&desk.journal()).leftovers.pop() {
        Some(leftover) => {
            let document = leftover.restored();
            leftover.take_over(&mut journal).expect("takes over");
            document
        }
        None => {
            let (job, file) = save::open(&desk.job()).expect("opens");
            Document::new(job, Some(file))
        }
    };
    loop {
        let step = Step::random(&mut random);
        say("begin");
        desk.take(&step, &mut document);
        journal.record(&document).expect("records");
        say("done");
    }
}

/// Past the test harness, which would keep it; ends the child when nobody listens any more.
fn say(what: &str) {
    let mut out = std::io::stdout().lock();
    if writeln!(out, "\n{MARK}{what}").and_then(|()| out.flush()).is_err() {
        std::process::exit(1);
    }
}

/// Steps begun and steps done of a child that was killed some time after it had said `lines` lines.
fn killed(desk: &Desk, seed: u64, lines: usize, pause: Duration) -> (u64, u64) {
    let mut child = Command::new(std::env::current_exe().expect("this file"))
        .args(["--exact", "child", "--ignored", "--nocapture", "--test-threads=1"])
        .envs([(FOLDER, desk.0.as_os_str()), (SEED, seed.to_string().as_ref())])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("runs itself");
    let mut said = BufReader::new(child.stdout.take().expect("piped")).lines().map_while(Result::ok);
    let (mut begun, mut done) = (0, 0);
    let mut count = |line: &str| match line.strip_prefix(MARK) {
        Some("begin") => begun += 1,
        Some(_) => done += 1,
        None => {}
    };
    if lines > 0 {
        said.by_ref().filter(|l| l.starts_with(MARK)).inspect(|l| count(l)).take(lines).for_each(drop);
    }
    let until = Instant::now() + pause;
    while Instant::now() < until {
        std::hint::spin_loop();
    }
    child.kill().expect("it runs until it is killed");
    said.for_each(|l| count(&l));
    let status = child.wait_with_output().expect("ends");
    assert_eq!(status.status.code(), None, "it was killed: {}", String::from_utf8_lossy(&status.stderr));
    (begun, done)
}

/// What must lie on the disk.
#[derive(Clone)]
struct Expected {
    document: Document,
    backup: Option<Job>,
    exported: Option<Job>,
}

impl Expected {
    /// What there is when a program starts, with what was left behind or without it.
    fn started(&mut self, mirror: &Desk, unsaved: Option<&Job>) {
        let (saved, file) = save::open(&mirror.job()).expect("opens");
        let unsaved = unsaved.cloned().unwrap_or_else(|| saved.clone());
        self.document = Document::restored(saved, Some(file), unsaved);
    }

    /// The same steps on the mirror, where nothing is killed; exports are noted only.
    fn take(&mut self, mirror: &Desk, step: &Step) {
        match step {
            Step::Export => {
                let moved =
                    files::rebased(self.document.job(), self.document.file(), &mirror.exported().join("job.toml"));
                self.exported = Some(moved.expect("rebases"));
            }
            _ => mirror.take(step, &mut self.document),
        }
        self.backup = backup_of(&mirror.job()).exists().then(|| files::read(&backup_of(&mirror.job())).expect("reads"));
    }

    /// Unsaved changes, if there are any.
    fn unsaved(&self) -> Option<&Job> {
        self.document.is_dirty().then(|| self.document.job())
    }
}

/// What lies on the disk.
struct Found {
    saved: Job,
    backup: Option<Job>,
    unsaved: Option<Job>,
}

impl Found {
    fn on(desk: &Desk) -> Found {
        let left = left_behind(&desk.journal());
        assert!(left.unreadable.is_empty(), "{:?}", left.unreadable);
        assert!(left.leftovers.len() <= 1, "one program was killed");
        let unsaved = left.leftovers.first().map(|leftover| {
            assert_eq!(leftover.job_file(), Some(desk.job().as_path()));
            assert_eq!(leftover.part_file(), desk.0.join("part.stl"));
            assert_eq!(leftover.restored().job(), leftover.job());
            leftover.job().clone()
        });
        let backup = backup_of(&desk.job());
        Found {
            saved: files::read(&desk.job()).expect("the job file is whole"),
            backup: backup.exists().then(|| files::read(&backup).expect("the backup is whole")),
            unsaved,
        }
    }
}

#[test]
fn a_program_killed_at_any_moment_loses_nothing_that_it_has_acknowledged() {
    let folder = tempfile::tempdir().expect("a folder");
    let (desk, mirror) = (Desk(folder.path().join("desk")), Desk(folder.path().join("mirror")));
    desk.set_up();
    mirror.set_up();
    let mut now = Expected { document: Document::default(), backup: None, exported: None };
    let mut random = Random(1);
    let (mut steps, mut dirty, mut in_flight, mut writing, mut unsaved) = (0, 0, 0, 0, None);
    for seed in 0..KILLS {
        let (lines, pause) = (random.below(160), Duration::from_micros(random.below(4000) as u64));
        let (begun, done) = killed(&desk, seed, if seed == 0 { 0 } else { lines }, pause);
        now.started(&mirror, unsaved.as_ref());
        let mut theirs = Random(seed);
        (0..done).for_each(|_| now.take(&mirror, &Step::random(&mut theirs)));
        let acknowledged = now.clone();
        let saved_before = files::read(&mirror.job()).expect("reads");
        let found = Found::on(&desk);
        if begun > done {
            let step = Step::random(&mut theirs);
            now.take(&mirror, &step);
            in_flight += 1;
            writing += u32::from(matches!(step, Step::Save | Step::Export));
        }
        let saved_after = files::read(&mirror.job()).expect("reads");
        let on_disk = (&found.saved, found.unsaved.as_ref());
        let allowed = [(&saved_before, acknowledged.unsaved()), (&saved_after, now.unsaved())];
        assert!(allowed.contains(&on_disk), "kill {seed}: {begun} steps begun, {done} done: something is lost");
        assert!([&acknowledged.backup, &now.backup].contains(&&found.backup), "kill {seed}: backup of no save");
        check_export(&desk.exported(), acknowledged.exported.as_ref(), now.exported.as_ref());
        steps += done;
        dirty += u32::from(found.unsaved.is_some());
        follow(&desk, &mirror, &found, &mut now, &acknowledged);
        unsaved = found.unsaved;
    }
    println!(
        "{KILLS} kills, {steps} steps done; {dirty} left changes, {in_flight} fell within a step, {writing} of them within a save or an export"
    );
    assert!(steps >= 10 * KILLS && dirty >= 25 && in_flight >= 25 && writing >= 3, "the kills must hit work");
}

/// The mirror goes on from what the kill has left.
fn follow(desk: &Desk, mirror: &Desk, found: &Found, now: &mut Expected, acknowledged: &Expected) {
    std::fs::copy(desk.job(), mirror.job()).expect("copies");
    if found.backup.is_some() {
        std::fs::copy(backup_of(&desk.job()), backup_of(&mirror.job())).expect("copies");
    } else {
        assert!(!backup_of(&mirror.job()).exists() || std::fs::remove_file(backup_of(&mirror.job())).is_ok());
    }
    now.backup.clone_from(&found.backup);
    let exported = files::read(&desk.exported().join("job.toml")).ok();
    if exported != now.exported {
        now.exported.clone_from(&acknowledged.exported);
    }
}
