//! PTX: clouds of a grid one behind the other, each with the scanner's pose, as Leica's programs write them.
//!
//! Ten lines stand before each cloud: columns, rows, the scanner's place, its three axes, and a matrix of four rows that
//! points are multiplied with from the left, so its last row is a shift. A cell without echo is `0 0 0` and dropped.
//! What is read lies where the matrices put it.

use super::decimal::Comma;
use super::gather::{ColourScale, Gather, Has};
use super::role::Role;
use super::stream::{Lines, Stream};
use super::text::Row;
use super::{Found, PtxFault, ScanFileError, ScanFinding};
use nalgebra::{Matrix3, Vector3};

/// Lines before the points of a cloud.
const HEAD: usize = 10;

/// Numbers of each of them.
const NUMBERS: [usize; HEAD] = [1, 1, 3, 3, 3, 3, 4, 4, 4, 4];

/// The axes of a pose may be so far from a motion: files have them rounded to six digits.
const ROUNDING: f64 = 1e-4;

/// Whether a text begins as PTX files do.
pub(super) fn is_ptx(begin: &[u8]) -> bool {
    let rows = Lines(begin).take(HEAD).map(|line| Row::of(line, Comma::Delimits));
    let fits = rows.zip(NUMBERS).map(|(row, numbers)| row.width == numbers && row.words == 0);
    let fits: Vec<bool> = fits.collect();
    fits.len() == HEAD && fits.into_iter().all(|f| f)
}

/// Where a cloud lies.
#[derive(Clone, Copy)]
struct Pose {
    turn: Matrix3<f64>,
    shift: Vector3<f64>,
}

/// What is read of the file so far.
struct Reading {
    gather: Option<Gather>,
    /// Lines of the head of the next cloud.
    head: Vec<Row>,
    pose: Pose,
    /// Points of the cloud that are still to come.
    left: u64,
    /// Whether the rows of this cloud have colours; `None`: the first is still to come.
    colours: Option<bool>,
    promised: u64,
    read: u64,
    invalid: u64,
    clouds: u64,
    line: u64,
}

/// Reads a PTX file as a cloud.
///
/// # Errors
/// A line is not what has to stand there, or points are missing.
pub(super) fn read(stream: &mut Stream<'_>) -> Result<Found, ScanFileError> {
    let pose = Pose { turn: Matrix3::identity(), shift: Vector3::zeros() };
    let mut reading = Reading {
        gather: None,
        head: Vec::with_capacity(HEAD),
        pose,
        left: 0,
        colours: None,
        promised: 0,
        read: 0,
        invalid: 0,
        clouds: 0,
        line: 0,
    };
    loop {
        let whole = stream.lines()?;
        if whole == 0 {
            break;
        }
        let mut lines = Lines(&stream.bytes()[..whole]);
        while let Some(line) = lines.next() {
            reading.line += 1;
            // No point has fewer characters than `0 0 0 0` and an end.
            let room = (stream.remaining() - (whole - lines.0.len()) as u64 + 1) / 8;
            reading.take(line, room)?;
        }
        stream.take(whole);
    }
    if reading.left > 0 {
        return Err(ScanFileError::CutOff { promised: reading.promised, present: reading.read });
    }
    if !reading.head.is_empty() {
        return Err(reading.fault(PtxFault::Pose));
    }
    let mut findings = Vec::new();
    if reading.clouds > 1 {
        findings.push(ScanFinding::CloudsJoined { count: reading.clouds });
    }
    let gather = reading.gather.ok_or(ScanFileError::NoPoints)?;
    Ok(Found { gather, findings, invalid: reading.invalid, stated_unit: None })
}

impl Reading {
    fn fault(&self, fault: PtxFault) -> ScanFileError {
        ScanFileError::Ptx { line: self.line, fault }
    }

    #[inline]
    fn take(&mut self, line: &[u8], room: u64) -> Result<(), ScanFileError> {
        let row = Row::of(line, Comma::Delimits);
        if row.width == 0 {
            return Ok(());
        }
        if self.left > 0 {
            return self.point(&row);
        }
        let numbers = NUMBERS[self.head.len()];
        let fault = if numbers == 1 { PtxFault::Count } else { PtxFault::Pose };
        if row.width != numbers || row.words != 0 || (numbers == 1 && row.count().is_none()) {
            return Err(self.fault(fault));
        }
        self.head.push(row);
        if self.head.len() == HEAD {
            self.begin(room)?;
            self.head.clear();
        }
        Ok(())
    }

    /// Begins a cloud whose head is read.
    fn begin(&mut self, room: u64) -> Result<(), ScanFileError> {
        let count = |line: usize| self.head[line].count().unwrap_or(0);
        self.left = count(0).saturating_mul(count(1));
        self.promised = self.promised.saturating_add(self.left);
        if self.left > room {
            return Err(ScanFileError::CutOff { promised: self.promised, present: self.read + room });
        }
        let of = |row: usize, column: usize| self.head[6 + row].values[column];
        let turn = Matrix3::from_fn(|r, c| of(c, r));
        let is_motion =
            (turn.transpose() * turn - Matrix3::identity()).abs().max() < ROUNDING && turn.determinant() > 0.0;
        let is_affine = (0..3).all(|r| of(r, 3) == 0.0) && of(3, 3) == 1.0;
        self.pose = Pose { turn, shift: Vector3::new(of(3, 0), of(3, 1), of(3, 2)) };
        if !is_motion || !is_affine || !self.pose.shift.iter().all(|s| s.is_finite()) {
            return Err(self.fault(PtxFault::NoMotion));
        }
        self.clouds += 1;
        self.colours = None;
        Ok(())
    }

    fn point(&mut self, row: &Row) -> Result<(), ScanFileError> {
        let numbers = if row.width >= 7 { 7 } else { 4 };
        if (0..3).any(|k| !row.is_number(k)) || row.width < numbers || self.colours.is_some_and(|c| c && numbers < 7) {
            return Err(self.fault(PtxFault::Point));
        }
        let has_colours = *self.colours.get_or_insert(numbers == 7);
        let gather = self.gather.get_or_insert_with(|| {
            let has = Has { colours: has_colours, intensities: true, normals: false };
            Gather::new(has, ColourScale::Bytes, false)
        });
        if gather.offsets.len() == gather.offsets.capacity() {
            gather.reserve(self.left)?;
        }
        self.left -= 1;
        self.read += 1;
        let place = Vector3::new(row.values[0], row.values[1], row.values[2]);
        if place == Vector3::zeros() {
            self.invalid += 1;
            return Ok(());
        }
        let placed = self.pose.turn * place + self.pose.shift;
        let point = gather.push();
        for axis in 0..3 {
            gather.set(point, Role::Place(axis), placed[axis]);
        }
        if row.is_number(3) {
            gather.set(point, Role::Intensity, row.values[3]);
        }
        for channel in 0..3 {
            if has_colours && row.is_number(4 + channel) {
                gather.set(point, Role::Colour(channel), row.values[4 + channel]);
            }
        }
        Ok(())
    }
}
