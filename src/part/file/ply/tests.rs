//! PLY in all encodings, and what of it is refused.

use super::super::changed_bytes::ChangedBytes;
use super::super::read;
use super::*;
use crate::part::raw_part::{FacetFault, PassedOver, RawFacet, Unread};
use proptest::prelude::*;

/// Two triangles and a square over four points, with properties and elements that are no mesh's.
const TEXT: &str = "ply\nformat ascii 1.0\ncomment made by hand\nobj_info none\nelement camera 1\nproperty double x\n\
    element vertex 4\nproperty uchar red\nproperty double x\nproperty float y\nproperty list uchar short names\n\
    property int z\nelement face 3\nproperty float quality\nproperty list uchar int vertex_indices\n\
    property uchar flag\nelement edge 0\nproperty int vertex1\nend_header\n\
    4.5\n255 0 0 2 7 8 0\n255 1 0 0 0\n0 1 1 0 0\n0 0 1 1 3 0\n0.5 3 0 1 2 0\n0.5 3 0 2 3 1\n0.25 4 3 2 1 0 1\n";

const P: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

fn expected() -> Vec<RawFacet> {
    vec![[P[0], P[1], P[2]], [P[0], P[2], P[3]], [P[3], P[2], P[1]], [P[3], P[1], P[0]]]
}

/// The file in binary form. `big`: bytes the highest first.
fn binary(big: bool) -> Vec<u8> {
    let (header, _) = TEXT.split_at(TEXT.find("4.5\n").expect("there"));
    let word = if big { "binary_big_endian" } else { "binary_little_endian" };
    let mut out = header.replace("ascii", word).into_bytes();
    macro_rules! put {
        ($value:expr) => {
            out.extend(if big { $value.to_be_bytes() } else { $value.to_le_bytes() })
        };
    }
    put!(4.5f64);
    let names: [&[i16]; 4] = [&[7, 8], &[], &[], &[3]];
    for (p, names) in P.iter().zip(names) {
        put!(255u8);
        put!(f64::from(p[0]));
        put!(p[1]);
        put!(names.len() as u8);
        for name in names {
            put!(*name);
        }
        put!(p[2] as i32);
    }
    for face in [&[0i32, 1, 2][..], &[0, 2, 3], &[3, 2, 1, 0]] {
        put!(0.5f32);
        put!(face.len() as u8);
        for index in face {
            put!(*index);
        }
        put!(1u8);
    }
    out
}

#[test]
fn all_encodings_hold_the_same_mesh() {
    let camera = Unread { what: UnreadKind::Element("camera".into()), count: 1 };
    for bytes in
        [TEXT.into(), TEXT.replace('\n', "\r\n").into(), TEXT.replace('\n', "\r").into(), binary(false), binary(true)]
    {
        let bytes: Vec<u8> = bytes;
        let part = read(&bytes).expect("reads");
        assert_eq!((&part.facets, &part.unread, part.passed_over), (&expected(), &vec![camera.clone()], None));
        // Cut off anywhere it is refused: the shortest that is whole has no end of line.
        for cut in bytes.len() / 2..bytes.len() - 2 {
            assert!(read(&bytes[..cut]).is_err(), "cut at {cut} of {}", bytes.len());
        }
        let longer = [&bytes[..], b" more"].concat();
        let told = read(&longer).expect("reads").passed_over.map(|o| o.at);
        assert_eq!(told, Some(longer.len() - 4));
    }
}

#[test]
fn types_of_any_size_count_faces() {
    for (count, index) in [("char", "uint"), ("ushort", "short"), ("int32", "uint8"), ("uint", "double")] {
        let text = TEXT.replace("list uchar int", &format!("list {count} {index}"));
        assert_eq!(read(text.as_bytes()).expect("reads").facets, expected());
    }
}

#[test]
fn what_is_no_mesh_is_told_by_name() {
    let refused = |from: &str, to: &str| read(TEXT.replace(from, to).as_bytes()).expect_err("refused");
    let ply = PartFileError::Ply;
    assert_eq!(refused("end_header", "end"), ply(PlyFault::HeaderLine { line: 19 }));
    assert_eq!(refused("property int z", "property int128 z"), ply(PlyFault::HeaderLine { line: 12 }));
    assert_eq!(refused("int z", "int height"), ply(PlyFault::NoCoordinates));
    assert_eq!(refused("vertex_indices", "corners"), ply(PlyFault::NoIndices));
    assert_eq!(refused("3 0 2 3 1", "3 0 2 4 1"), ply(PlyFault::NoSuchVertex { face: 1, vertices: 4 }));
    assert_eq!(refused("3 0 2 3 1", "3 0 2 -1 1"), ply(PlyFault::NoSuchVertex { face: 1, vertices: 4 }));
    assert_eq!(refused("3 0 2 3 1", "-3 0 2 3 1"), ply(PlyFault::Value { element: "face".into(), row: 1 }));
    let cut = |element: &str, promised| ply(PlyFault::CutOff { element: element.into(), promised });
    assert_eq!(refused("face 3", "face 4"), cut("face", 4));
    assert_eq!(refused("vertex 4", "vertex 9000000000000000000"), cut("vertex", 9_000_000_000_000_000_000));
    let byte = TEXT.find("0.5 3").expect("there");
    assert_eq!(refused("0.5 3 0 1 2 0", "0.5 3 0 1,5 2 0"), PartFileError::DecimalComma { byte: byte + 8 });
    let cloud = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n\
        end_header\n1 2 3\n4 5 6\n";
    assert_eq!(read(cloud.as_bytes()), Err(PartFileError::PointCloud { points: 2 }));
    let strips = cloud.replace("end_header", "element tristrips 1\nproperty list int int vertex_indices\nend_header");
    assert_eq!(read(format!("{strips}3 0 1 0\n").as_bytes()), Err(ply(PlyFault::Strips)));
    assert_eq!(read(b"ply\n\x01\x02"), Err(ply(PlyFault::NoHeaderEnd)));
}

#[test]
fn a_bad_face_among_good_ones_is_dropped_and_told() {
    let text = TEXT.replace("3 0 2 3 1", "2 0 2 1").replace("0 1 1 0 0\n", "0 nan 1 0 0\n");
    let part = read(text.as_bytes()).expect_err("all have the corner that is no number, but the one of two");
    assert_eq!(part, PartFileError::NoFacet { dropped: 3, first: Some(FacetFault::Nan) });
    let text = TEXT.replace("3 0 2 3 1", "2 0 2 1");
    let part = read(text.as_bytes()).expect("reads");
    let byte = text.find("\n0.5 2 0 2").expect("there");
    assert_eq!(part.facets.len(), 3);
    assert_eq!((part.invalid[0].fault, part.invalid[0].byte), (FacetFault::NotThreeVertices, byte));
    assert_eq!(
        read(format!("{text} 17").as_bytes()).expect("reads").passed_over,
        Some(PassedOver { count: 2, at: text.len() + 1 })
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn changed_bytes_are_read_or_refused(which in 0..3usize, changed in ChangedBytes::any()) {
        let bytes = changed.of([TEXT.into(), binary(false), binary(true)][which].clone());
        let (_, _) = (super::read(&bytes, &Progress::default()), read(&bytes));
    }
}
