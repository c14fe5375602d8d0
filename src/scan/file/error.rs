//! Why a file is no scan that can be read. Sentences of it stand in `text`.

use crate::part::file::{FileKind, PartFileError, PlyFault};
use crate::progress::Cancelled;
use thiserror::Error;

/// Why a file cannot be used as a scan.
#[derive(Debug, Error)]
pub enum ScanFileError {
    /// The reading was cancelled.
    #[error("cancelled")]
    Cancelled,
    /// The system could not read it.
    #[error("not read: {0}")]
    Io(#[from] std::io::Error),
    /// A folder is no file.
    #[error("a folder")]
    Folder,
    /// Nothing in it.
    #[error("empty file")]
    Empty,
    /// It is something else, which is known.
    #[error("{}", .0.word())]
    Other(FileKind),
    /// It is nothing that is known.
    #[error("not a scan")]
    Unknown,
    /// It is read as a part's file, and is no usable one.
    #[error("{0}")]
    Part(PartFileError),
    /// Nothing in it is x, y and z.
    #[error("no x y z among {columns:?}")]
    NoCoordinates {
        /// Names of what it has in their place.
        columns: Vec<String>,
    },
    /// It holds fewer points than its header promises.
    #[error("cut off: {promised} points promised, {present} present")]
    CutOff {
        /// Points by the header.
        promised: u64,
        /// Points that there is room for.
        present: u64,
    },
    /// It promises no point and has none.
    #[error("no points")]
    NoPoints,
    /// It has points, and none can be used.
    #[error("no usable point: {dropped} dropped")]
    AllDropped {
        /// Points dropped: coordinates that are no number, or marked as invalid.
        dropped: u64,
    },
    /// A point lies farther from the first one than single precision can say.
    #[error("point {point} too far")]
    TooFar {
        /// Its number, from 0.
        point: u64,
    },
    /// More points than can be numbered, or than there is memory for.
    #[error("{points} points are too many")]
    TooMany {
        /// How many there would be.
        points: u64,
    },
    /// A PLY file that cannot be read.
    #[error("PLY: {0:?}")]
    Ply(PlyFault),
    /// A number of a PLY text is written with a comma.
    #[error("decimal comma, byte {byte}")]
    DecimalComma {
        /// Where it stands.
        byte: u64,
    },
    /// A PCD file that cannot be read.
    #[error("PCD: {0:?}")]
    Pcd(PcdFault),
    /// A line of a PTX file is not what has to stand there.
    #[error("PTX, line {line}: {fault:?}")]
    Ptx {
        /// The line, from 1.
        line: u64,
        /// What is wrong there.
        fault: PtxFault,
    },
    /// An E57 file that cannot be read.
    #[error("E57: {0:?}")]
    E57(E57Fault),
}

/// What is wrong with a PCD file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PcdFault {
    /// It has no header: the data begin at once.
    NoHeader,
    /// The header has no `DATA`.
    NoData,
    /// A line of the header that cannot be read.
    Line {
        /// The line, from 1.
        line: u64,
    },
    /// A field has numbers of a type that there is none of.
    Type {
        /// Its name.
        field: String,
    },
    /// `POINTS` is not `WIDTH` times `HEIGHT`.
    Counts {
        /// By `POINTS`.
        points: u64,
        /// By the grid.
        grid: u64,
    },
    /// What is compressed promises another size than the header.
    Size {
        /// Bytes by the header.
        header: u64,
        /// Bytes by what is compressed.
        packed: u64,
    },
    /// What is compressed cannot be unpacked.
    Packed {
        /// Where it breaks.
        byte: u64,
    },
    /// A row of a text is no row of numbers.
    Row {
        /// The line, from 1.
        line: u64,
    },
}

/// What is wrong in a line of a PTX file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PtxFault {
    /// It should be a whole number: of columns, or of rows.
    Count,
    /// It should have three or four numbers of the scanner's place or of the cloud's.
    Pose,
    /// The cloud's place is no motion: its axes are not square to each other, or not one long.
    NoMotion,
    /// It should be a point.
    Point,
}

/// What is wrong with an E57 file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum E57Fault {
    /// A page does not fit its checksum.
    Checksum {
        /// The page, from 0.
        page: u64,
    },
    /// The file has not the length that it states.
    Length {
        /// Bytes by its header.
        stated: u64,
        /// Bytes there are.
        present: u64,
    },
    /// Its header is none, or of another version.
    Header,
    /// What it says of itself (its XML) cannot be read, or is none of E57.
    Description,
    /// Points of a scan cannot be read.
    Points {
        /// The scan, from 0.
        scan: usize,
    },
    /// The place of a scan is no motion.
    Pose {
        /// The scan, from 0.
        scan: usize,
    },
    /// It uses something that is not read.
    NotHandled,
}

impl From<Cancelled> for ScanFileError {
    fn from(_: Cancelled) -> Self {
        ScanFileError::Cancelled
    }
}

impl From<PlyFault> for ScanFileError {
    fn from(fault: PlyFault) -> Self {
        ScanFileError::Ply(fault)
    }
}

impl From<PcdFault> for ScanFileError {
    fn from(fault: PcdFault) -> Self {
        ScanFileError::Pcd(fault)
    }
}

impl From<E57Fault> for ScanFileError {
    fn from(fault: E57Fault) -> Self {
        ScanFileError::E57(fault)
    }
}

impl From<PartFileError> for ScanFileError {
    fn from(error: PartFileError) -> Self {
        match error {
            PartFileError::Empty => ScanFileError::Empty,
            PartFileError::Unknown => ScanFileError::Unknown,
            PartFileError::Other(kind) => ScanFileError::Other(kind),
            PartFileError::Ply(fault) => ScanFileError::Ply(fault),
            PartFileError::DecimalComma { byte } => ScanFileError::DecimalComma { byte: byte as u64 },
            other => ScanFileError::Part(other),
        }
    }
}
