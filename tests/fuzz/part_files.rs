//! Files of parts. What is read becomes a part, where it is small enough for that: with its surfaces, shapes and
//! findings. Of a 3MF file both are changed: the archive, and the models in one that is sound.

use crate::bundle::{bundle, unbundled};
use crate::run::{Kind, check_sentence, outline, run};
use clearbeam::document::{Job, segmented};
use clearbeam::part::inspect::InspectReport;
use clearbeam::part::raw_part::RawPart;
use clearbeam::part::topology::FacetDefect;
use clearbeam::part::{Part, PartFinding, Placement, Units, file};
use clearbeam::sample::{Triangles, solids, stl_bytes};
use clearbeam::text::Sentence;
use std::io::{Cursor, Write as _};

/// More facets are read, but no part is made of them.
const MOST_FACETS: usize = 150;

fn read_file(bytes: &[u8]) -> String {
    read(bytes, true)
}

/// `is_plain`: facets stand in the file one by one.
fn read(bytes: &[u8], is_plain: bool) -> String {
    let raw = match file::read(bytes) {
        Ok(raw) => raw,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    check_raw(&raw, if is_plain { bytes.len() } else { usize::MAX });
    assert_eq!(file::read(bytes).as_ref(), Ok(&raw), "read again it is the same");
    let made = if raw.facets.len() <= MOST_FACETS { made(bytes, &raw) } else { "large".into() };
    let size = raw.facets.len().ilog2().min(8);
    let what = [raw.invalid.is_empty(), raw.passed_over.is_none(), raw.count_differs.is_none(), raw.unread.is_empty()];
    format!("{size} {} {what:?} {made}", raw.solids.min(3))
}

fn check_raw(raw: &RawPart, length: usize) {
    assert!(!raw.facets.is_empty() && raw.facets.iter().flatten().flatten().all(|x| x.is_finite()));
    assert!(raw.facets.len() + raw.invalid.len() <= length);
    assert!(raw.invalid.iter().all(|i| i.byte < length && i.facet < raw.facets.len() + raw.invalid.len()));
    assert!(raw.passed_over.is_none_or(|p| p.count > 0 && p.at.checked_add(p.count).is_some_and(|end| end <= length)));
    assert!(raw.unread.iter().all(|u| u.count > 0));
}

/// The part of a file; in which way it came out.
fn made(bytes: &[u8], raw: &RawPart) -> String {
    let part = match Part::from_bytes(bytes, Units::Mm, &Placement::default(), &[]) {
        Ok(part) => part,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    let mesh = &part.mesh;
    assert_eq!(mesh.facets.len(), raw.facets.len());
    assert!(mesh.vertices.iter().all(|v| v.iter().all(|x| x.is_finite())));
    assert!(mesh.facets.iter().flatten().all(|v| (*v as usize) < mesh.vertices.len()));
    for (f, defect) in mesh.defects.iter().enumerate() {
        let (length, area) = (mesh.normals[f].norm(), mesh.areas[f]);
        assert!(area.is_finite() && area >= 0.0 && length.is_finite(), "facet {f}: {area} mm², normal {length}");
        assert!(*defect != FacetDefect::None || ((length - 1.0).abs() < 1e-9 && area > 0.0), "facet {f}: {length}");
    }
    assert!(part.dihedral_deg.iter().all(|d| (0.0..=180.0).contains(d) || *d == f64::INFINITY));
    assert!(part.figures.volume_mm3.is_none_or(f64::is_finite));
    let job = Job::default();
    let surfaces = segmented(&part, &job);
    let listed: usize = surfaces.list.iter().map(|s| s.facets.len()).sum();
    assert_eq!(listed, mesh.facets.len(), "each facet is of one surface");
    assert!(surfaces.list.iter().all(|s| s.area_mm2.is_finite()));
    let report = InspectReport::new(&part, &surfaces, &job.surfaces.rule(), job.beam.spot_area_mm2());
    serde_json::to_string(&report).expect("written");
    let findings = PartFinding::of(&part);
    findings.iter().for_each(|f| check_sentence(&f.sentence()));
    findings.iter().map(outline).collect::<Vec<_>>().join(" ")
}

/// All corners as text, a line each.
fn corners(triangles: &Triangles, start: &str) -> String {
    triangles.iter().flatten().map(|[x, y, z]| format!("{start}{x} {y} {z}\n")).collect()
}

fn stl_text(triangles: &Triangles) -> String {
    let facet = |t: &[[f64; 3]; 3]| {
        format!("facet normal 0 0 1\nouter loop\n{}endloop\nendfacet\n", corners(&vec![*t], "vertex "))
    };
    format!("solid part\n{}endsolid part\n", triangles.iter().map(facet).collect::<String>())
}

fn obj(triangles: &Triangles) -> Vec<u8> {
    let faces: String =
        (0..triangles.len()).map(|t| format!("f {} {} {}\n", 3 * t + 1, 3 * t + 2, 3 * t + 3)).collect();
    format!("# made by hand\no part\n{}vn 0 0 1\ng side\n{faces}f -1//1 -2//1 -3//1\nl 1 2\n", corners(triangles, "v "))
        .into_bytes()
}

/// A PLY file: `encoding` is the word of its format.
fn ply(triangles: &Triangles, encoding: &str) -> Vec<u8> {
    let (vertices, faces) = (3 * triangles.len(), triangles.len());
    let mut out = format!(
        "ply\nformat {encoding} 1.0\ncomment made by hand\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
         property float z\nelement face {faces}\nproperty list uchar int vertex_indices\nelement edge 1\nproperty int a\n\
         end_header\n"
    )
    .into_bytes();
    if encoding == "ascii" {
        out.extend(corners(triangles, "").bytes());
        (0..faces).for_each(|t| out.extend(format!("3 {} {} {}\n", 3 * t, 3 * t + 1, 3 * t + 2).bytes()));
        out.extend(b"7\n");
        return out;
    }
    let ordered = |bits: u32| if encoding.contains("big") { bits.to_be_bytes() } else { bits.to_le_bytes() };
    triangles.iter().flatten().flatten().for_each(|x| out.extend(ordered((*x as f32).to_bits())));
    for t in 0..faces as u32 {
        out.push(3);
        (0..3).for_each(|k| out.extend(ordered(3 * t + k)));
    }
    out.extend(ordered(7));
    out
}

const RELATIONS: &str = "<Relationships><Relationship Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" \
    Target=\"/3D/3dmodel.model\"/></Relationships>\n";

/// The main model of a 3MF file whose objects are used in several ways.
fn model(triangles: &Triangles) -> String {
    let vertex = |[x, y, z]: &[f64; 3]| format!("<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>\n");
    let vertices: String = triangles.iter().flatten().map(vertex).collect();
    let face = |t: usize| format!("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", 3 * t, 3 * t + 1, 3 * t + 2);
    let faces: String = (0..triangles.len()).map(face).collect();
    format!(
        "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" \
         xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" requiredextensions=\"p\">\n\
         <resources>\n<object id=\"1\" type=\"model\"><mesh>\n<vertices>\n{vertices}</vertices>\n<triangles>\n{faces}\
         </triangles>\n</mesh></object>\n<object id=\"2\"><components>\n<component objectid=\"1\"/>\n\
         <component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 -1 20 0 0\"/>\n\
         <component p:path=\"/3D/other.model\" objectid=\"7\"/>\n</components></object>\n\
         <object id=\"3\" type=\"support\"><components><component objectid=\"1\"/></components></object>\n</resources>\n\
         <build>\n<item objectid=\"2\"/>\n<item objectid=\"3\"/>\n</build>\n</model>\n"
    )
}

const OTHER: &str = "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n\
    <resources>\n<object id=\"7\"><mesh><vertices>\n<vertex x=\"0\" y=\"0\" z=\"50\"/>\n<vertex x=\"1\" y=\"0\" z=\"50\"/>\n\
    <vertex x=\"0\" y=\"1\" z=\"50\"/>\n</vertices><triangles>\n<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>\n</triangles></mesh>\
    </object>\n</resources>\n<build/>\n</model>\n";

fn models() -> Vec<u8> {
    let main = model(&solids::cube(1.0)[..4].to_vec());
    bundle([("_rels/.rels", RELATIONS), ("3D/3dmodel.model", &main), ("3D/other.model", OTHER)])
}

/// The archive of a bundle; names that the archive does not take, or has already, are left out.
fn archive(bundled: &[u8]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in unbundled(bundled) {
        if zip.start_file(name, zip::write::SimpleFileOptions::default()).is_ok() {
            zip.write_all(text.as_bytes()).expect("into memory");
        }
    }
    zip.finish().expect("into memory").into_inner()
}

#[test]
fn stl_binary() {
    let cube = stl_bytes(&solids::cube(10.0));
    let more = [cube.clone(), stl_bytes(&solids::cone(3.0, 4.0, 5))].concat();
    let with_attributes = cube.chunks(50).flat_map(|c| [c, b"abc"].concat()).collect();
    let words = ["solid ", "\0\0", "COLOR=", "facet"];
    run(&Kind { name: "stl_binary", own: vec![cube, more, with_attributes], words: &words, read: &read_file });
}

#[test]
fn stl_text_files() {
    let own = [solids::cube(10.0), solids::cylinder(2.0, 5.0, 4)].map(|t| stl_text(&t).into_bytes()).to_vec();
    let words = [
        "solid ",
        "facet ",
        "normal ",
        "outer loop\n",
        "vertex ",
        "endloop\n",
        "endfacet\n",
        "endsolid ",
        "color ",
        "\r",
        "\u{feff}",
    ];
    run(&Kind { name: "stl_text", own, words: &words, read: &read_file });
}

#[test]
fn obj_files() {
    let own = vec![obj(&solids::cube(10.0)), b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .2 0\nf 1 2 3 4 5\n".to_vec()];
    let words =
        ["v ", "f ", "vn ", "vt ", "l ", "p ", "g ", "usemtl ", "mtllib ", "/", "//", "\\\n", "#", "curv ", "-1"];
    run(&Kind { name: "obj", own, words: &words, read: &read_file });
}

#[test]
fn ply_files() {
    let encodings = ["ascii", "binary_little_endian", "binary_big_endian"];
    let own = encodings.map(|encoding| ply(&solids::cube(10.0), encoding)).to_vec();
    let words = [
        "element vertex ",
        "element face ",
        "element tristrips 1\n",
        "property ",
        "property list ",
        "uchar",
        "char",
        "short",
        "ushort",
        "int",
        "uint",
        "float",
        "double",
        "vertex_index",
        "vertex_indices",
        "end_header\n",
        "comment ",
        "ascii",
        "binary_little_endian",
        "binary_big_endian",
        "\r",
    ];
    run(&Kind { name: "ply", own, words: &words, read: &read_file });
}

#[test]
fn archives_of_3mf() {
    let own = vec![archive(&models())];
    run(&Kind {
        name: "archives_of_3mf",
        own,
        words: &["PK\x03\x04", "PK\x01\x02", "PK\x05\x06"],
        read: &|b| read(b, false),
    });
}

#[test]
fn models_of_3mf() {
    let words = [
        "<!--",
        "-->",
        "<![CDATA[",
        "]]>",
        "<!DOCTYPE a [<!ENTITY b \"cc\">]>",
        "&b;",
        "&#10;",
        "&lt;",
        "<a>",
        "</a>",
        "<",
        "/>",
        "<item objectid=\"1\"/>",
        "<component objectid=\"2\"/>",
        "transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"",
        "xmlns=\"\"",
        "p:path=\"/3D/3dmodel.model\"",
        "p:path=\"/3D/other.model\"",
        "unit=\"inch\"",
        "unit=\"foot\"",
        "type=\"support\"",
        "requiredextensions=\"b\"",
        "%%% ",
        "objectid=\"3\"",
        "id=\"2\"",
    ];
    run(&Kind { name: "models_of_3mf", own: vec![models()], words: &words, read: &|b| read(&archive(b), false) });
}
