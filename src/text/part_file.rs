//! What is wrong with a file that cannot be read as a part: what it is instead, or where it is damaged, and what to do.

use super::{Sentence, id, quoted, say};
use crate::part::file::{FileKind, ObjFault, PartFileError, PlyFault, ThreeMfFault};

impl Sentence for PartFileError {
    fn sentence(&self) -> String {
        match self {
            PartFileError::Cancelled => say!(text_cancelled),
            PartFileError::Empty => say!(part_file_empty),
            PartFileError::Other(kind) => kind.sentence(),
            PartFileError::Unknown => say!(part_file_unknown),
            PartFileError::CutOff { promised, needed, present } => {
                say!(stl_cut_off, promised = *promised, needed = *needed, present = *present)
            }
            PartFileError::CountDoubtful { promised, more } => {
                say!(stl_count_doubtful, promised = *promised, more = *more)
            }
            PartFileError::TextCutOff { facets, byte } => say!(stl_text_cut_off, facets = *facets, byte = id(*byte)),
            PartFileError::DecimalComma { byte } => say!(part_file_decimal_comma, byte = id(*byte)),
            PartFileError::NoFacet { first: None, .. } => say!(part_file_no_facets),
            PartFileError::NoFacet { dropped, first: Some(first) } => {
                say!(part_file_all_dropped, dropped = *dropped, first = first.sentence())
            }
            PartFileError::PointCloud { points } => say!(part_file_point_cloud, points = *points),
            PartFileError::Obj { line, fault: ObjFault::Vertex } => say!(obj_vertex, line = id(*line)),
            PartFileError::Obj { line, fault: ObjFault::Face } => say!(obj_face, line = id(*line)),
            PartFileError::Obj { line, fault: ObjFault::NoSuchVertex } => {
                say!(obj_no_such_vertex, line = id(*line))
            }
            PartFileError::Ply(fault) => fault.sentence(),
            PartFileError::ThreeMf(fault) => fault.sentence(),
        }
    }
}

impl Sentence for FileKind {
    fn sentence(&self) -> String {
        let kind = self.word();
        match self {
            FileKind::GitLfsPointer => say!(part_file_lfs),
            FileKind::Zip | FileKind::Gzip | FileKind::Archive(_) => say!(part_file_packed, kind),
            FileKind::WebPage => say!(part_file_web_page),
            FileKind::OtherModel(_) => say!(part_file_other_model, kind),
            FileKind::NoModel(_) | FileKind::Ply | FileKind::Obj => say!(part_file_no_model, kind),
        }
    }
}

impl Sentence for PlyFault {
    fn sentence(&self) -> String {
        match self {
            PlyFault::HeaderLine { line } => say!(ply_header_line, line = id(*line)),
            PlyFault::NoHeaderEnd => say!(ply_no_header_end),
            PlyFault::NoCoordinates => say!(ply_no_coordinates),
            PlyFault::NoIndices => say!(ply_no_indices),
            PlyFault::Strips => say!(ply_strips),
            PlyFault::CutOff { element, promised } => {
                say!(ply_cut_off, element = quoted(element), promised = *promised)
            }
            PlyFault::Value { element, row } => say!(ply_value, element = quoted(element), row = id(*row)),
            PlyFault::NoSuchVertex { face, vertices } => {
                say!(ply_no_such_vertex, face = id(*face), vertices = *vertices)
            }
        }
    }
}

impl Sentence for ThreeMfFault {
    fn sentence(&self) -> String {
        match self {
            ThreeMfFault::Archive => say!(threemf_archive),
            ThreeMfFault::NoEntry { entry } => say!(threemf_no_entry, entry),
            ThreeMfFault::Unreadable { entry } => say!(threemf_unreadable, entry),
            ThreeMfFault::TooLarge { most_mib } => say!(threemf_too_large, most = id(*most_mib)),
            ThreeMfFault::Xml { entry, line } => say!(threemf_xml, entry, line = id(*line)),
            ThreeMfFault::Unit { word } => say!(threemf_unit, word = quoted(word)),
            ThreeMfFault::UnitsDiffer => say!(threemf_units_differ),
            ThreeMfFault::Extension { name } => say!(threemf_extension, name),
            ThreeMfFault::Value { element, line } => say!(threemf_value, element, line = id(*line)),
            ThreeMfFault::NoSuchVertex { object, vertices } => {
                say!(threemf_no_such_vertex, object = id(*object), vertices = *vertices)
            }
            ThreeMfFault::NoSuchObject { object } => say!(threemf_no_such_object, object = id(*object)),
            ThreeMfFault::TooDeep => say!(threemf_too_deep),
            ThreeMfFault::TooManyObjects { most } => say!(threemf_too_many_objects, most = *most),
            ThreeMfFault::TooManyFacets { most } => say!(threemf_too_many_facets, most = *most),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_it_is_and_what_to_do() {
        let said = |bytes: &[u8]| crate::part::file::read(bytes).expect_err("no part").sentence();
        let lfs = said(b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n");
        assert!(lfs.contains("a Git LFS pointer") && lfs.contains("git lfs pull"), "{lfs}");
        assert!(said(b"ISO-10303-21;").contains("a STEP file"));
        assert!(said(b"\x1f\x8b\x08").contains("a gzip archive: unpack it"));
        assert!(said(b"<html></html>").contains("a web page"));
        assert!(said(b"\xff\xd8\xff\xe0").contains("a JPEG file, not a part"));
        assert!(said(b"PK\x03\x04").contains("3MF"));
        assert!(said(b"hello").contains("STL"));
        assert!(said(b"v 1 2 3\nv 4 5 6\n").contains("a point cloud of 2 points, not a mesh"));
        assert!(said(b"v 1 2 3\nf 1 2 3\n").starts_with("line 2: "));
    }
}
