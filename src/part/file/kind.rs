//! What a file is by its first bytes: one that is read as a part, or one of those that people take for one. STL has no
//! mark of its own and is what is left.

/// Kinds of files that are known by their beginning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A PLY file.
    Ply,
    /// An OBJ file.
    Obj,
    /// An archive: a 3MF file is one.
    Zip,
    /// What Git keeps in the place of a large file.
    GitLfsPointer,
    /// Compressed by gzip.
    Gzip,
    /// Another archive, by its name.
    Archive(&'static str),
    /// A web page.
    WebPage,
    /// A model of a CAD or drawing program that is no mesh, or a mesh in another form, by its name.
    OtherModel(&'static str),
    /// Something else that is no model, by its name.
    NoModel(&'static str),
}

impl FileKind {
    /// Its name; names of formats are the same in every language.
    pub fn word(self) -> &'static str {
        match self {
            FileKind::Ply => "PLY",
            FileKind::Obj => "OBJ",
            FileKind::Zip => "ZIP",
            FileKind::GitLfsPointer => "Git LFS",
            FileKind::Gzip => "gzip",
            FileKind::WebPage => "HTML",
            FileKind::Archive(word) | FileKind::OtherModel(word) | FileKind::NoModel(word) => word,
        }
    }
}

/// Beginnings that tell a kind.
const BEGINNINGS: [(&[u8], FileKind); 24] = [
    (b"PK\x03\x04", FileKind::Zip),
    (b"PK\x05\x06", FileKind::Zip),
    (b"version https://git-lfs", FileKind::GitLfsPointer),
    (b"\x1f\x8b", FileKind::Gzip),
    (b"7z\xbc\xaf\x27\x1c", FileKind::Archive("7z")),
    (b"Rar!\x1a\x07", FileKind::Archive("RAR")),
    (b"BZh", FileKind::Archive("bzip2")),
    (b"\xfd7zXZ\0", FileKind::Archive("xz")),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", FileKind::OtherModel("SolidWorks / Inventor / Office (OLE)")),
    (b"ISO-10303-21", FileKind::OtherModel("STEP")),
    (b"AutoCAD Binary DXF", FileKind::OtherModel("DXF")),
    (b"AC10", FileKind::OtherModel("DWG")),
    (b"**ABCDEFGHIJKLMNOPQRSTUVWXYZ", FileKind::OtherModel("Parasolid")),
    (b"3D Geometry File Format", FileKind::OtherModel("Rhino 3DM")),
    (b"glTF", FileKind::OtherModel("glTF")),
    (b"Kaydara FBX Binary", FileKind::OtherModel("FBX")),
    (b"BLENDER", FileKind::OtherModel("Blender")),
    (b"#VRML", FileKind::OtherModel("VRML")),
    (b"OFF\n", FileKind::OtherModel("OFF")),
    (b"OFF\r", FileKind::OtherModel("OFF")),
    (b"%PDF", FileKind::NoModel("PDF")),
    (b"\x89PNG\r\n\x1a\n", FileKind::NoModel("PNG")),
    (b"\xff\xd8\xff", FileKind::NoModel("JPEG")),
    (b"GIF8", FileKind::NoModel("GIF")),
];

/// So many bytes of the beginning are looked at for words.
const LOOKED_AT: usize = 4096;

/// The kind of a file by its beginning; `None`: it has no mark.
pub(super) fn of(bytes: &[u8]) -> Option<FileKind> {
    let text = trimmed(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes));
    let begin = &text[..text.len().min(LOOKED_AT)];
    let told = BEGINNINGS.iter().find(|(mark, _)| bytes.starts_with(mark) || text.starts_with(mark)).map(|b| b.1);
    told.or_else(|| (first_line(text) == b"ply").then_some(FileKind::Ply))
        .or_else(|| marked_up(begin))
        .or_else(|| is_json(begin).then_some(FileKind::NoModel("JSON")))
        .or_else(|| is_dxf(begin).then_some(FileKind::OtherModel("DXF")))
        .or_else(|| is_iges(bytes).then_some(FileKind::OtherModel("IGES")))
        .or_else(|| is_obj(bytes).then_some(FileKind::Obj))
}

fn trimmed(bytes: &[u8]) -> &[u8] {
    let start = bytes.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(bytes.len());
    &bytes[start..]
}

fn lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    bytes.split(|b| matches!(b, b'\n' | b'\r')).map(<[u8]>::trim_ascii)
}

fn first_line(bytes: &[u8]) -> &[u8] {
    lines(bytes).next().unwrap_or_default()
}

fn holds(bytes: &[u8], word: &[u8]) -> bool {
    bytes.windows(word.len()).any(|w| w.eq_ignore_ascii_case(word))
}

/// HTML, XML, or a model written in it.
fn marked_up(begin: &[u8]) -> Option<FileKind> {
    let [b'<', next, ..] = begin else { return None };
    if !(next.is_ascii_alphabetic() || matches!(next, b'?' | b'!')) {
        return None;
    }
    Some(if holds(begin, b"<!doctype html") || holds(begin, b"<html") {
        FileKind::WebPage
    } else if holds(begin, b"<amf") {
        FileKind::OtherModel("AMF")
    } else if holds(begin, b"<collada") {
        FileKind::OtherModel("COLLADA")
    } else if holds(begin, b"<x3d") {
        FileKind::OtherModel("X3D")
    } else {
        FileKind::NoModel("XML")
    })
}

/// A brace, or brackets, and then what may follow them in JSON; the name of a table of TOML begins with a letter.
fn is_json(begin: &[u8]) -> bool {
    let inside = begin.iter().position(|b| *b != b'[' && !b.is_ascii_whitespace()).unwrap_or(begin.len());
    match (inside, begin[inside..].split_first()) {
        (_, Some((b'{', rest))) => matches!(trimmed(rest).first(), Some(b'"' | b'}')),
        (1.., Some((b']' | b'"' | b'-' | b'0'..=b'9', _))) => true,
        _ => false,
    }
}

/// Group codes stand alone on their lines: a comment (999) or the first section (0).
fn is_dxf(begin: &[u8]) -> bool {
    let mut lines = lines(begin).filter(|l| !l.is_empty());
    match (lines.next(), lines.next()) {
        (Some(b"0"), Some(word)) => word.eq_ignore_ascii_case(b"SECTION"),
        (Some(b"999"), Some(_)) => holds(begin, b"SECTION"),
        _ => false,
    }
}

/// Lines of 80 columns with the section's letter in the 73rd.
fn is_iges(bytes: &[u8]) -> bool {
    let Some(line) = bytes.get(..80) else { return false };
    let is_number = line[73..].trim_ascii().iter().all(u8::is_ascii_digit) && !line[73..].trim_ascii().is_empty();
    line[72] == b'S' && is_number && line.iter().all(|b| b.is_ascii_graphic() || *b == b' ')
}

/// Words that lines of an OBJ file begin with, before its first face.
const OBJ_WORDS: [&[u8]; 17] = [
    b"v", b"vt", b"vn", b"vp", b"f", b"l", b"p", b"o", b"g", b"s", b"mg", b"usemtl", b"mtllib", b"cstype", b"deg",
    b"bmat", b"step",
];

/// OBJ has no mark: its first lines but comments all begin with words of its own, a vertex among them, or at least a
/// name of materials or of an object and vertices further on.
fn is_obj(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let words = lines(bytes)
        .filter(|l| !l.is_empty() && l[0] != b'#')
        .map(|l| l.split(u8::is_ascii_whitespace).next().unwrap_or_default());
    for word in words.take(LOOKED_AT) {
        if word == b"v" {
            return true;
        }
        if !OBJ_WORDS.contains(&word) {
            return false;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::super::{PartFileError, read};
    use super::*;

    #[test]
    fn what_people_take_for_a_part_is_named() {
        let iges = format!("{:<72}S{:>7}\n", "exported by a CAD system", 1);
        let known: [(&[u8], FileKind); 16] = [
            (b"version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12\n", FileKind::GitLfsPointer),
            (b"\x1f\x8b\x08\0\0\0\0\0", FileKind::Gzip),
            (b"\n<!DOCTYPE html><html><body>Sign in</body></html>", FileKind::WebPage),
            (b"ISO-10303-21;\nHEADER;\n", FileKind::OtherModel("STEP")),
            (iges.as_bytes(), FileKind::OtherModel("IGES")),
            (b"  0\r\nSECTION\r\n  2\r\nHEADER\r\n", FileKind::OtherModel("DXF")),
            (b"999\nmade by\n0\nSECTION\n", FileKind::OtherModel("DXF")),
            (b"%PDF-1.7\n", FileKind::NoModel("PDF")),
            (b"{ \"asset\": { \"version\": \"2.0\" } }", FileKind::NoModel("JSON")),
            (b"[[1, 2], [3]]", FileKind::NoModel("JSON")),
            (b"<?xml version=\"1.0\"?>\n<note/>", FileKind::NoModel("XML")),
            (b"<?xml version=\"1.0\"?><amf unit=\"inch\">", FileKind::OtherModel("AMF")),
            (b"\x89PNG\r\n\x1a\n\0\0", FileKind::NoModel("PNG")),
            (b"\xff\xd8\xff\xe0\x00\x10JFIF", FileKind::NoModel("JPEG")),
            (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0", FileKind::OtherModel("SolidWorks / Inventor / Office (OLE)")),
            (b"PK\x03\x04 no archive", FileKind::Zip),
        ];
        for (bytes, kind) in known {
            assert_eq!(of(bytes), Some(kind));
            let is_archive = kind == FileKind::Zip;
            assert!(is_archive || read(bytes) == Err(PartFileError::Other(kind)), "{kind:?}");
        }
        let none: [&[u8]; 5] = [
            b"solid a\nfacet",
            b"[part]\nfile = \"a.stl\"",
            b"[[part]]\nr0_mm = 1",
            b"vertex 1 2 3",
            b"hello\nv 1 2 3",
        ];
        for bytes in none {
            assert_eq!(of(bytes), None);
        }
    }
}
