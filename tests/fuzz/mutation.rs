//! Changes of a file: bits and bytes, chunks, lines, words and numbers, and pieces of another file of its kind.

use crate::random::Random;
use std::ops::Range;

/// No changed file is longer, bytes: what is wrong with a long file is wrong with a short one, and many are tried.
pub const LONGEST: usize = 1 << 14;

/// Numbers as words at which readers go wrong.
const ODD_WORDS: [&str; 36] = [
    "0",
    "-0",
    "1",
    "-1",
    "2",
    "3",
    "+5",
    ".5",
    "5.",
    "007",
    "0x10",
    "1_000",
    "1,5",
    "0.1",
    "0.0005",
    "255",
    "256",
    "65535",
    "65536",
    "2147483648",
    "4294967295",
    "4294967296",
    "9007199254740993",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551615",
    "18446744073709551616",
    "99999999999999999999999999",
    "1e10",
    "3.4028236e38",
    "1e-46",
    "1e308",
    "-1e308",
    "1e999",
    "nan",
    "-inf",
];

/// The same as bytes: counts, and what is infinite, no number, the largest or the least of single precision.
const ODD_BYTES: [u32; 14] = [
    0,
    1,
    2,
    0xff,
    0xffff,
    0x1_0000,
    0x7fff_ffff,
    0x8000_0000,
    0xffff_ffff,
    0x3f80_0000,
    0x7f80_0000,
    0x7fc0_0000,
    0x7f7f_ffff,
    0x0080_0000,
];

impl Random {
    /// One of a list that is not empty.
    pub fn one<'l, T>(&mut self, list: &'l [T]) -> &'l T {
        &list[self.below(list.len())]
    }

    /// A stretch of so many bytes, mostly a short one.
    fn stretch(&mut self, length: usize) -> Range<usize> {
        let begin = self.below(length);
        let most = if self.below(4) == 0 { length } else { 32 };
        begin..(begin + 1 + self.below(most)).min(length)
    }
}

/// A file changed in some places; `words` are those of its kind, `other` another file of it.
pub fn changed(file: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let mut bytes = file.to_vec();
    let most = 1 << random.below(5);
    for _ in 0..=random.below(most) {
        match random.below(4) {
            0 => change_bytes(&mut bytes, random),
            1 => change_chunks(&mut bytes, other, random),
            2 => change_lines(&mut bytes, other, random),
            _ => change_words(&mut bytes, other, words, random),
        }
        bytes.truncate(LONGEST);
    }
    bytes
}

fn change_bytes(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len());
    match random.below(4) {
        0 => bytes.iter_mut().skip(at).take(1).for_each(|b| *b ^= 1 << random.below(8)),
        1 => bytes.iter_mut().skip(at).take(1).for_each(|b| *b = random.draw() as u8),
        2 => bytes.insert(at, *random.one(b"\0\t\n\r \"'#,;:.(){}[]<>&%-+=/\\|\x1a\x7f\xc3\xe4\xff")),
        _ => {
            let odd = *random.one(&ODD_BYTES);
            let size = *random.one(&[1, 2, 4]);
            let ordered = if random.below(4) == 0 { odd.swap_bytes() } else { odd }.to_le_bytes();
            bytes.iter_mut().skip(at).zip(&ordered[..size]).for_each(|(b, new)| *b = *new);
        }
    }
}

fn change_chunks(bytes: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let chunk = random.stretch(bytes.len());
    match random.below(6) {
        0 => drop(bytes.drain(chunk)),
        1 => {
            let times = *random.one(&[1, 1, 2, 7, 400]);
            let copy = bytes[chunk.clone()].repeat(times);
            insert(bytes, chunk.end, &copy);
        }
        2 => {
            let (copy, at) = (bytes[chunk].to_vec(), random.below(bytes.len()));
            insert(bytes, at, &copy);
        }
        3 => bytes.truncate(chunk.start),
        4 => {
            let from = random.stretch(other.len());
            insert(bytes, chunk.start, &other[from]);
        }
        _ => {
            let from = random.below(other.len());
            bytes.truncate(chunk.start);
            bytes.extend_from_slice(&other[from..]);
        }
    }
}

fn change_lines(bytes: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let line = line_at(bytes, random.below(bytes.len()));
    match random.below(4) {
        0 => drop(bytes.drain(line)),
        1 => {
            let copy = bytes[line.clone()].to_vec();
            insert(bytes, line.end, &copy);
        }
        2 => {
            let moved: Vec<u8> = bytes.drain(line).collect();
            let to = line_at(bytes, random.below(bytes.len()));
            insert(bytes, to.start, &moved);
        }
        _ => {
            let from = line_at(other, random.below(other.len()));
            insert(bytes, line.start, &other[from]);
        }
    }
}

fn change_words(bytes: &mut Vec<u8>, other: &[u8], words: &[&str], random: &mut Random) {
    let is_of_number = |b: u8| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+');
    let is_of_word = |b: u8| b.is_ascii_alphanumeric() || b == b'_' || b == b'.';
    let at = random.below(bytes.len());
    let (place, new): (Range<usize>, Vec<u8>) = match random.below(6) {
        0 => (run_at(bytes, at, |b| b.is_ascii_digit()), vec![b'0' + random.below(10) as u8]),
        1 | 2 => (run_at(bytes, at, is_of_number), random.one(&ODD_WORDS).as_bytes().to_vec()),
        3 => (at..at, random.one(words).as_bytes().to_vec()),
        4 => (run_at(bytes, at, is_of_word), random.one(words).as_bytes().to_vec()),
        _ => {
            let from = run_at(other, random.below(other.len()), is_of_word);
            (run_at(bytes, at, is_of_word), other[from].to_vec())
        }
    };
    drop(bytes.splice(place, new));
}

fn insert(bytes: &mut Vec<u8>, at: usize, new: &[u8]) {
    drop(bytes.splice(at..at, new.iter().copied().take(LONGEST)));
}

/// The line that a byte stands in, with its end.
fn line_at(bytes: &[u8], at: usize) -> Range<usize> {
    let begin = bytes[..at].iter().rposition(|b| *b == b'\n').map_or(0, |n| n + 1);
    let end = bytes[at..].iter().position(|b| *b == b'\n').map_or(bytes.len(), |n| at + n + 1);
    begin..end
}

/// The first run of such bytes from `at` on, whole; nothing at the end, where there is none.
fn run_at(bytes: &[u8], at: usize, is_in: impl Fn(u8) -> bool) -> Range<usize> {
    let Some(first) = bytes[at..].iter().position(|b| is_in(*b)) else { return bytes.len()..bytes.len() };
    let first = at + first;
    let begin = bytes[..first].iter().rposition(|b| !is_in(*b)).map_or(0, |n| n + 1);
    let end = bytes[first..].iter().position(|b| !is_in(*b)).map_or(bytes.len(), |n| first + n);
    begin..end
}

/// Changes are the same in every run, no longer than they may be, and go wrong on no file, an empty one included.
#[test]
fn changes_are_the_same_in_every_run() {
    let (file, other) = (b"solid a\nvertex 1.5 -2 3e4\nendsolid a\n".as_slice(), b"\xff\0\n12".as_slice());
    let of = |seed: u64| changed(file, other, &["facet"], &mut Random(seed));
    let first: Vec<Vec<u8>> = (0..2000).map(of).collect();
    assert_eq!(first, (0..2000).map(of).collect::<Vec<_>>());
    assert!(first.iter().all(|f| f.len() <= LONGEST));
    assert!(first.iter().filter(|f| *f != file).count() > 1900);
    for seed in 0..2000 {
        let empty = changed(b"", b"", &[""], &mut Random(seed));
        changed(&empty, b"", &["x"], &mut Random(seed));
    }
}
