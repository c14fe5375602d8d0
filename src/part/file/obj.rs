//! Wavefront OBJ. `tobj` reads numbers and indices; it is given the vertices and faces alone, with the corner's first
//! index, because its other readers panic on indices of normals that are not there, and so that what it would leave
//! out without a word (lines, points, curves, surfaces by formulas) is counted.

use super::number::has_decimal_comma;
use super::polygon;
use super::{ObjFault, PartFileError};
use crate::part::raw_part::{RawPart, UnreadKind};
use crate::progress::Progress;
use std::collections::BTreeMap;
use std::io::{BufRead, Cursor, Read};

/// Vertices and faces of a file, a line each.
#[derive(Default)]
struct Geometry {
    text: String,
    /// The line of the file, from 1, of each line of the text.
    line_of: Vec<usize>,
    /// Where each face begins in the file.
    face_bytes: Vec<usize>,
    vertices: usize,
    unread: BTreeMap<Beside, usize>,
}

/// What is not read, in the order in which it is told.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Beside {
    Lines,
    Points,
    FreeForm,
    Unknown,
}

/// Parses an OBJ file.
///
/// # Errors
/// A line that cannot be read, or points without faces; [`PartFileError::Cancelled`] when `progress` says so.
pub(super) fn read(bytes: &[u8], progress: &Progress) -> Result<RawPart, PartFileError> {
    let mut geometry = Geometry::of(bytes, progress)?;
    let options = tobj::LoadOptions { single_index: true, ..Default::default() };
    let mut lines = Watched { text: Cursor::new(geometry.text.as_bytes()), progress };
    let read = tobj::load_obj_buf(&mut lines, &options, |_| Ok(Default::default()));
    let reached = usize::try_from(lines.text.position()).unwrap_or(usize::MAX);
    progress.check()?;
    let (models, _) = read.map_err(|e| geometry.told(e, reached))?;
    let mut part = RawPart { solids: 1, ..RawPart::default() };
    let face_bytes = std::mem::take(&mut geometry.face_bytes);
    let mut faces = face_bytes.iter();
    for mesh in models.iter().map(|m| &m.mesh) {
        let corner = |i: &u32| -> Option<[f32; 3]> {
            let at = 3 * *i as usize;
            mesh.positions.get(at..at + 3)?.try_into().ok()
        };
        let triangles = vec![3; mesh.indices.len() / 3];
        let arities = if mesh.face_arities.is_empty() { &triangles } else { &mesh.face_arities };
        let mut rest = &mesh.indices[..];
        for (arity, byte) in arities.iter().zip(&mut faces) {
            progress.check()?;
            let (face, behind) = rest.split_at((*arity as usize).min(rest.len()));
            rest = behind;
            match face.len() {
                1 => geometry.count(Beside::Points),
                2 => geometry.count(Beside::Lines),
                _ => polygon::push(&mut part, &face.iter().filter_map(corner).collect::<Vec<_>>(), *byte),
            }
        }
    }
    if part.facets.is_empty() && part.invalid.is_empty() && geometry.vertices > 0 {
        return Err(PartFileError::PointCloud { points: geometry.vertices });
    }
    for (what, count) in geometry.unread {
        let what = match what {
            Beside::Lines => UnreadKind::Lines,
            Beside::Points => UnreadKind::Points,
            Beside::FreeForm => UnreadKind::FreeForm,
            Beside::Unknown => UnreadKind::UnknownLines,
        };
        part.leave_unread(what, count);
    }
    Ok(part)
}

impl Geometry {
    fn of(bytes: &[u8], progress: &Progress) -> Result<Geometry, PartFileError> {
        let mut out = Geometry::default();
        let lines = Lines { bytes, at: if bytes.starts_with(b"\xef\xbb\xbf") { 3 } else { 0 }, number: 0 };
        for line in lines {
            progress.check()?;
            let text = String::from_utf8_lossy(&line.text);
            let mut words = text.split_whitespace();
            match words.next().unwrap_or_default() {
                "" | "vt" | "vn" | "vp" | "o" | "g" | "s" | "mg" | "usemtl" | "mtllib" | "usemap" | "maplib"
                | "lod" | "bevel" | "c_interp" | "d_interp" | "shadow_obj" | "trace_obj" => {}
                "v" => out.vertex(words.collect(), &line)?,
                "f" | "fo" => out.face(words, &line),
                "l" => out.count(Beside::Lines),
                "p" => out.count(Beside::Points),
                "curv" | "curv2" | "surf" => out.count(Beside::FreeForm),
                // What curves and surfaces are made of.
                "cstype" | "deg" | "bmat" | "step" | "parm" | "trim" | "hole" | "scrv" | "sp" | "end" | "con"
                | "ctech" | "stech" => {}
                _ => out.count(Beside::Unknown),
            }
        }
        Ok(out)
    }

    fn count(&mut self, what: Beside) {
        *self.unread.entry(what).or_default() += 1;
    }

    fn push(&mut self, word: &str, rest: &[&str], line: &Line) {
        self.text.push_str(word);
        for part in rest {
            self.text.push(' ');
            self.text.push_str(part);
        }
        self.text.push('\n');
        self.line_of.push(line.number);
    }

    /// Three coordinates, and a weight or a colour, which `tobj` would want of all vertices or none.
    fn vertex(&mut self, mut words: Vec<&str>, line: &Line) -> Result<(), PartFileError> {
        if words.iter().any(|w| has_decimal_comma(w.as_bytes())) {
            return Err(PartFileError::DecimalComma { byte: line.byte });
        }
        if words.len() > 4 {
            words.truncate(3);
        }
        self.vertices += 1;
        self.push("v", &words, line);
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>, line: &Line) {
        let first = |word: &'a str| word.split('/').next().filter(|w| !w.is_empty()).unwrap_or("0");
        self.face_bytes.push(line.byte);
        self.push("f", &words.map(first).collect::<Vec<_>>(), line);
    }

    /// What `tobj` could not read, with its line. `reached`: how far it came in the text.
    fn told(&self, e: tobj::LoadError, reached: usize) -> PartFileError {
        let read = self.text.as_bytes().iter().take(reached).filter(|b| **b == b'\n').count();
        let (fault, line) = match e {
            tobj::LoadError::FaceParseError => (ObjFault::Face, read),
            tobj::LoadError::FaceVertexOutOfBounds => (ObjFault::NoSuchVertex, self.first_out_of_bounds()),
            _ => (ObjFault::Vertex, read),
        };
        PartFileError::Obj { line: self.line_of.get(line.saturating_sub(1)).copied().unwrap_or_default(), fault }
    }

    /// The line of the text, from 1, with the first face that has a vertex that is not there.
    fn first_out_of_bounds(&self) -> usize {
        let (all, mut before) = (self.vertices as i64, 0i64);
        let is_bad = |line: &str| {
            let is_there = |before: i64, word: &str| match word.parse::<i64>() {
                Ok(i) if i < 0 => i >= -before,
                Ok(i) => (1..=all).contains(&i),
                Err(_) => false,
            };
            if line.starts_with('v') {
                before += 1;
                return false;
            }
            !line.split_whitespace().skip(1).all(|w| is_there(before, w))
        };
        self.text.lines().position(is_bad).map_or(0, |k| k + 1)
    }
}

/// A text that ends with an error when its reading should end: `tobj` is not asked otherwise.
struct Watched<'a> {
    text: Cursor<&'a [u8]>,
    progress: &'a Progress,
}

impl Read for Watched<'_> {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        self.progress.check().map_err(|_| std::io::Error::from(std::io::ErrorKind::Other))?;
        self.text.read(into)
    }
}

impl BufRead for Watched<'_> {
    fn fill_buf(&mut self) -> std::io::Result<&[u8]> {
        self.progress.check().map_err(|_| std::io::Error::from(std::io::ErrorKind::Other))?;
        self.text.fill_buf()
    }

    fn consume(&mut self, count: usize) {
        self.text.consume(count);
    }
}

/// A line with those that it goes on in, without comment.
struct Line {
    text: Vec<u8>,
    byte: usize,
    number: usize,
}

struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: usize,
}

impl Iterator for Lines<'_> {
    type Item = Line;

    fn next(&mut self) -> Option<Line> {
        let byte = self.at;
        if byte >= self.bytes.len() {
            return None;
        }
        let mut line = Line { text: Vec::new(), byte, number: self.number + 1 };
        loop {
            let rest = &self.bytes[self.at..];
            let len = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
            let end = if rest[len..].starts_with(b"\r\n") { len + 2 } else { len + 1 };
            self.at = (self.at + end).min(self.bytes.len());
            self.number += 1;
            let text = rest[..len].split(|b| *b == b'#').next().unwrap_or_default();
            let goes_on = text.trim_ascii_end().strip_suffix(b"\\");
            line.text.extend_from_slice(goes_on.unwrap_or(text));
            if goes_on.is_none() || self.at >= self.bytes.len() {
                return Some(line);
            }
            line.text.push(b' ');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::changed_bytes::ChangedBytes;
    use super::super::read;
    use super::*;
    use crate::part::raw_part::{FacetFault, Unread};
    use proptest::prelude::*;

    const TETRAHEDRON: &str = "# made by hand\nmtllib a.mtl\no part\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0 0.5 0.5 0.5\n\
        v 0 0 1\nvn 0 0 1\ng side\nusemtl steel\ns off\nf 1 3 2\nf 1/1/1 2/2/1 4/1/1\n\
         f 1//9 4//1 3//-7\nf -3 -2 \\\n  -1\n";

    #[test]
    fn faces_by_any_index_are_read() {
        let part = read(TETRAHEDRON.as_bytes()).expect("reads");
        let [o, x, y, z] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(part.facets, [[o, y, x], [o, x, z], [o, z, y], [x, y, z]]);
        assert_eq!((part.unread.len(), part.invalid.len()), (0, 0));
        assert_eq!(read(TETRAHEDRON.replace('\n', "\r\n").as_bytes()), Ok(part));
    }

    #[test]
    fn polygons_are_cut_and_what_is_no_face_is_told() {
        let text =
            format!("{TETRAHEDRON}v 1 1 0\nf 1 2 5 3\nf 1 2\nf 1\nl 1 2 3\np 4\ncurv 0 1 1 2\nhello\nf 1 2 5 3 1\nf\n");
        let part = read(text.as_bytes()).expect("reads");
        assert_eq!(part.facets.len(), 4 + 2 + 3);
        assert_eq!(part.invalid.iter().map(|i| i.fault).collect::<Vec<_>>(), [FacetFault::NotThreeVertices]);
        let counts =
            [(UnreadKind::Lines, 2), (UnreadKind::Points, 2), (UnreadKind::FreeForm, 1), (UnreadKind::UnknownLines, 1)];
        assert_eq!(part.unread, counts.map(|(what, count)| Unread { what, count }));
    }

    #[test]
    fn what_cannot_be_read_is_told_with_its_line() {
        let refused = |more: &str| read(format!("{TETRAHEDRON}{more}").as_bytes());
        let at = |fault| Err(PartFileError::Obj { line: 17, fault });
        for index in ["0", "5", "-5", "/1", "9999999999", "-9223372036854775808"] {
            assert_eq!(refused(&format!("f 1 2 {index}\n")), at(ObjFault::NoSuchVertex), "{index}");
        }
        assert_eq!(refused("f 1 two 3\n"), at(ObjFault::Face));
        assert_eq!(refused("v 1 2\n"), at(ObjFault::Vertex));
        assert_eq!(refused("v 1 2 z\n"), at(ObjFault::Vertex));
        assert_eq!(refused("v 1 2 3 0\n"), at(ObjFault::Vertex));
        assert_eq!(refused("v 1,5 2 3\n"), Err(PartFileError::DecimalComma { byte: TETRAHEDRON.len() }));
        assert_eq!(read(b"v 1 2 3\nv 4 5 6\n"), Err(PartFileError::PointCloud { points: 2 }));
        let nan = refused("v nan 0 0\nf 1 2 -1\n").expect("reads");
        assert_eq!((nan.facets.len(), nan.invalid[0].fault), (4, FacetFault::Nan));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn changed_bytes_are_read_or_refused(changed in ChangedBytes::any()) {
            let bytes = changed.of(TETRAHEDRON);
            let (_, _) = (super::read(&bytes, &Progress::default()), read(&bytes));
        }
    }
}
