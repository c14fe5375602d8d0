//! What an operator should know of a scan's file: what was dropped, left unread or assumed. Data; its sentences stand
//! in `text`.

use serde::Serialize;

/// Something about a scan's file that an operator should know. Counts are of points, if nothing else is said.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "code", rename_all = "snake_case")]
pub enum ScanFinding {
    /// Points whose coordinates are no numbers are missing from the cloud.
    PointsDropped {
        /// With a coordinate that is none (NaN).
        nan: u64,
        /// The others: with an infinite one.
        infinite: u64,
    },
    /// Points that the scanner marked as not measured are missing from the cloud.
    InvalidPoints {
        /// How many.
        count: u64,
    },
    /// The file says another count than it has.
    CountDiffers {
        /// Points by the file.
        promised: u64,
        /// Points that were read, the dropped ones among them.
        read: u64,
    },
    /// Rows with fewer columns than the first were left out.
    ShortRows {
        /// Rows.
        count: u64,
        /// Line of the first, from 1.
        line: u64,
    },
    /// Rows have more columns than the first, and these were not read.
    LongRows {
        /// Rows.
        count: u64,
        /// Line of the first, from 1.
        line: u64,
    },
    /// Lines that are no row of numbers were passed over.
    LinesPassedOver {
        /// Lines.
        count: u64,
        /// The first, from 1.
        line: u64,
    },
    /// Bytes behind the last point belong to nothing that is known.
    BytesPassedOver {
        /// Bytes.
        count: u64,
        /// Where the first of them stands in the file.
        at: u64,
    },
    /// Not every point has it, so none was given it.
    NotForAll {
        /// What.
        what: Attribute,
        /// Points without it.
        without: u64,
    },
    /// No name tells what the columns are: this was taken.
    ColumnsAssumed {
        /// As what.
        columns: Assumed,
    },
    /// Numbers have commas in the place of decimal points.
    DecimalCommas,
    /// Columns that are nothing a cloud keeps.
    ColumnsNotRead {
        /// Their names, or their numbers from 1 where they have none.
        names: Vec<String>,
    },
    /// Something else that the file holds: faces, images.
    NotRead {
        /// Its name in the file.
        element: String,
        /// How many of it.
        count: u64,
    },
    /// Colours below or above what can be were taken as the least or the greatest.
    ColoursClamped {
        /// Single values of red, green or blue.
        count: u64,
    },
    /// The file says where the scanner stood; the points were taken as they are, as is usual.
    ViewpointNotApplied,
    /// Several clouds stand in the file; each was put in its place, and they became one.
    CloudsJoined {
        /// Clouds.
        count: u64,
    },
    /// The file is a mesh: its corners became the points.
    CornersTaken {
        /// Facets that they are of.
        facets: u64,
        /// Facets that could not be used.
        dropped: u64,
    },
}

/// What a point can have beside its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Attribute {
    /// Its normal.
    Normals,
    /// Its colour.
    Colours,
    /// How bright it came back.
    Intensities,
}

/// What the columns of a text without names were taken as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Assumed {
    /// x y z, and more that is not read.
    Xyz,
    /// x y z intensity.
    XyzIntensity,
    /// x y z red green blue.
    XyzRgb,
    /// x y z and the normal.
    XyzNormal,
    /// x y z intensity red green blue.
    XyzIntensityRgb,
}
