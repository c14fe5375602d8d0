//! What is wrong within files of one form: OBJ, PLY and 3MF.

/// What is wrong in a line of an OBJ file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ObjFault {
    /// A vertex is not three numbers.
    Vertex,
    /// A face has something that is no index.
    Face,
    /// A face has a vertex that is not there.
    NoSuchVertex,
}

/// What is wrong with a PLY file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlyFault {
    /// A line of the header that cannot be read.
    HeaderLine {
        /// The line, from 1.
        line: usize,
    },
    /// The header has no end.
    NoHeaderEnd,
    /// Vertices have no x, y and z.
    NoCoordinates,
    /// Faces have no list of vertices.
    NoIndices,
    /// Its faces are strips.
    Strips,
    /// It ends before the rows of an element that its header promises.
    CutOff {
        /// The element.
        element: String,
        /// Rows by the header.
        promised: u64,
    },
    /// Something that should be a number is none, or a list has less than no items.
    Value {
        /// The element.
        element: String,
        /// Its row, from 0.
        row: u64,
    },
    /// A face has a vertex that is not there.
    NoSuchVertex {
        /// The face, from 0.
        face: usize,
        /// Vertices that are there.
        vertices: usize,
    },
}

/// What is wrong with a 3MF file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ThreeMfFault {
    /// The archive is damaged or cut off.
    Archive,
    /// An entry of the archive that is needed is not there.
    NoEntry {
        /// Its name.
        entry: String,
    },
    /// An entry cannot be unpacked: it is damaged, encrypted, or packed in another way than 3MF allows.
    Unreadable {
        /// Its name.
        entry: String,
    },
    /// Unpacked, the models are larger than is read.
    TooLarge {
        /// The most that is read, MiB.
        most_mib: u64,
    },
    /// An entry is no XML.
    Xml {
        /// Its name.
        entry: String,
        /// The line where it is none, from 1.
        line: u32,
    },
    /// A model has a unit that the format does not know.
    Unit {
        /// The word.
        word: String,
    },
    /// Models of one file have different units.
    UnitsDiffer,
    /// The model says that it is not to be read without an extension that is not known here.
    Extension {
        /// Its name.
        name: String,
    },
    /// Something of an object cannot be read: an attribute is missing or no number.
    Value {
        /// The element that has it.
        element: String,
        /// Where it stands in its entry, from 1.
        line: u32,
    },
    /// A triangle has a vertex that is not there.
    NoSuchVertex {
        /// Its object.
        object: u32,
        /// Vertices that are there.
        vertices: usize,
    },
    /// An object is named that is not there.
    NoSuchObject {
        /// Its number.
        object: u32,
    },
    /// Objects are made of each other, or of others in too many steps.
    TooDeep,
    /// Objects are repeated more often than is read.
    TooManyObjects {
        /// The most that are read.
        most: usize,
    },
    /// Objects are repeated so often that the facets are more than are read.
    TooManyFacets {
        /// The most that are read.
        most: usize,
    },
}
