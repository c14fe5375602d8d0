//! Runs a kind: its own files, those that are kept, and changes of both. What comes out in a way not seen before is
//! changed further.

use crate::mutation::changed;
use crate::random::Random;
use clearbeam::part::digest_of;
use std::collections::BTreeSet;
use std::fmt::Debug;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, mpsc};
use std::time::{Duration, Instant};

/// Changes that are tried where no number is asked for.
const FEW: u64 = 300;

/// One file may take so long: the slowest take some hundredths of it, without optimisation and beside other tests.
const LONGEST_RUN: Duration = Duration::from_secs(30);

/// Files that are changed further; beyond, no more are taken.
const MOST_FILES: usize = 2000;

/// Memory that a kind may take beside what the process had, MiB, and what each thread of the machine may have for
/// itself. A count of four bytes that is believed is tens of thousands.
const MOST_MIB: u64 = 1024;
const MIB_OF_THREAD: u64 = 160;

/// Files of a kind, and what is done with each.
pub struct Kind<'a> {
    /// Its folder in the corpus.
    pub name: &'a str,
    /// What the project writes of it.
    pub own: Vec<Vec<u8>>,
    /// Words of its files.
    pub words: &'a [&'a str],
    /// Reads one and checks what comes of it; in which way it came out.
    pub read: &'a (dyn Fn(&[u8]) -> String + Sync),
}

/// Runs it.
pub fn run(kind: &Kind<'_>) {
    let asked = std::env::var("CLEARBEAM_FUZZ").ok().and_then(|n| n.parse().ok());
    let before_mib = memory_mib();
    let begin = Instant::now();
    let files = [kind.own.clone(), kept(kind.name)].concat();
    assert!(!kind.own.is_empty(), "{} has files of its own", kind.name);
    let now: Mutex<Option<(Instant, Vec<u8>)>> = Mutex::new(None);
    let (end, ended) = mpsc::channel::<()>();
    let mut trial = Trial { kind, now: &now, seen: BTreeSet::new(), slowest: Duration::ZERO, files, before_mib };
    std::thread::scope(|s| {
        let now = &now;
        s.spawn(move || watch(kind.name, now, &ended));
        let result = catch_unwind(AssertUnwindSafe(|| trial.all(asked.unwrap_or(FEW))));
        drop(end);
        if let Err(why) = result {
            std::panic::resume_unwind(why);
        }
    });
    if let Some(count) = asked {
        let (outcomes, slowest_ms, seconds) = (trial.seen.len(), trial.slowest.as_millis(), begin.elapsed().as_secs());
        println!("{}: {count} changes in {seconds} s, {outcomes} outcomes, slowest {slowest_ms} ms", kind.name);
    }
}

struct Trial<'a> {
    kind: &'a Kind<'a>,
    /// What is tried, and since when.
    now: &'a Mutex<Option<(Instant, Vec<u8>)>>,
    /// Outcomes there were.
    seen: BTreeSet<String>,
    slowest: Duration,
    files: Vec<Vec<u8>>,
    before_mib: Option<u64>,
}

impl Trial<'_> {
    fn all(&mut self, count: u64) {
        for file in self.files.clone() {
            self.once(&file);
        }
        self.check_memory("its files");
        let of_kind = self.kind.name.bytes().fold(0u64, |h, b| h.wrapping_mul(131).wrapping_add(u64::from(b)));
        for n in 0..count {
            let mut random = Random(of_kind.wrapping_mul(0x2545_f491_4f6c_dd1d).wrapping_add(n));
            let (file, other) = (random.one(&self.files), random.one(&self.files));
            let new = changed(file, other, self.kind.words, &mut random);
            if self.once(&new) && self.files.len() < MOST_FILES {
                self.files.push(new);
            }
            if n % 1024 == 1023 || n + 1 == count {
                self.check_memory(&format!("changes up to {n}"));
            }
        }
    }

    /// Tries a file; whether it came out as none before.
    fn once(&mut self, file: &[u8]) -> bool {
        let begin = Instant::now();
        *self.now.lock().expect("whole") = Some((begin, file.to_vec()));
        let outcome = catch_unwind(AssertUnwindSafe(|| (self.kind.read)(file)));
        self.slowest = self.slowest.max(begin.elapsed());
        let outcome = outcome.unwrap_or_else(|_| panic!("kept as {}", keep(self.kind.name, file).display()));
        self.seen.insert(outcome)
    }

    fn check_memory(&self, of: &str) {
        let (Some(before), Some(now)) = (self.before_mib, memory_mib()) else { return };
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u64);
        let most = before + MOST_MIB + MIB_OF_THREAD * threads;
        assert!(now <= most, "{} or what runs beside it took {now} MiB, {before} before: {of}", self.kind.name);
    }
}

/// Ends the process where one file takes too long, which nothing else could.
fn watch(kind: &str, now: &Mutex<Option<(Instant, Vec<u8>)>>, ended: &mpsc::Receiver<()>) {
    while ended.recv_timeout(Duration::from_secs(1)) == Err(mpsc::RecvTimeoutError::Timeout) {
        let tried = now.lock().expect("whole").clone();
        if let Some((begin, file)) = tried.filter(|(begin, _)| begin.elapsed() > LONGEST_RUN) {
            let (kept, seconds) = (keep(kind, &file), begin.elapsed().as_secs());
            eprintln!("{kind}: more than {seconds} s; kept as {}", kept.display());
            std::process::exit(1);
        }
    }
}

fn folder(kind: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/corpus").join(kind)
}

/// The files that are kept of a kind, by name.
fn kept(kind: &str) -> Vec<Vec<u8>> {
    let entries = std::fs::read_dir(folder(kind)).into_iter().flatten();
    let mut files: Vec<PathBuf> = entries.map(|e| e.expect("readable").path()).collect();
    files.sort();
    files.iter().map(|f| std::fs::read(f).expect("readable")).collect()
}

/// Keeps a file that failed.
fn keep(kind: &str, file: &[u8]) -> PathBuf {
    let path = folder(kind).join(format!("found-{}", &digest_of(file)[..12]));
    std::fs::create_dir_all(folder(kind)).and_then(|()| std::fs::write(&path, file)).expect("kept");
    path
}

/// The most memory that the process has asked for so far, where the system tells it.
fn memory_mib() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmPeak:"))?;
    line.trim().strip_suffix(" kB")?.parse::<u64>().ok().map(|kib| kib / 1024)
}

/// What something looks like without its numbers and texts: files that come out alike are one outcome.
pub fn outline(of: &impl Debug) -> String {
    let (mut is_quoted, text) = (false, format!("{of:?}"));
    let is_outline = |c: &char| {
        is_quoted ^= *c == '"';
        !is_quoted && (c.is_ascii_alphabetic() || matches!(c, '(' | '{'))
    };
    text.chars().filter(is_outline).take(80).collect()
}

/// Checks what is said of a file: one line, and not nothing.
pub fn check_sentence(said: &str) {
    assert!(said.lines().count() == 1 && !said.trim().is_empty(), "{said:?}");
}
