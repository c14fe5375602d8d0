//! Damaged files of every form: they are read or refused, and nothing panics.

use super::*;
use ::e57::{E57Writer, Record, RecordDataType, RecordName, RecordValue};
use proptest::prelude::*;
use std::io::Cursor;
use std::sync::OnceLock;

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty float z\n\
    property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n\
    property list uchar int vertex_indices\nend_header\n1 2 3 4 5 6\n7 8 9 1 2 3\n4 5 6 7 8 9\n3 0 1 2\n";

const PTX: &str =
    "1\n3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n1 2 3 0.5\n0 0 0 0\n4 5 6 0.5\n";

fn pcd(form: &str, body: &[u8]) -> Vec<u8> {
    let header = format!(
        "VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 8 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 4\nHEIGHT 1\nPOINTS 4\nDATA {form}\n"
    );
    [header.as_bytes(), body].concat()
}

fn e57() -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let mut writer = E57Writer::new(&mut file, "file").expect("begins");
    let names = [RecordName::CartesianX, RecordName::CartesianY, RecordName::CartesianZ];
    let data_type = RecordDataType::ScaledInteger { min: 0, max: 100, scale: 0.1, offset: 0.0 };
    let prototype = names.map(|name| Record { name, data_type: data_type.clone() }).to_vec();
    let mut scan = writer.add_pointcloud("scan", prototype).expect("begins");
    for i in 0..20 {
        scan.add_point([i, 2 * i, 3].map(RecordValue::ScaledInteger).to_vec()).expect("fits");
    }
    scan.finalize().expect("ends");
    writer.finalize().expect("ends");
    drop(writer);
    file.into_inner()
}

/// A small valid file of each form.
fn files() -> Vec<Vec<u8>> {
    let numbers: Vec<u8> = (0..80u8).map(|b| b % 61).collect();
    let packed = super::super::pcd::pack(&numbers);
    let compressed = [&(packed.len() as u32).to_le_bytes(), &80u32.to_le_bytes(), &packed[..]].concat();
    let binary = PLY.split_at(PLY.find("1 2 3 4").expect("there")).0.replace("ascii", "binary_big_endian");
    vec![
        PLY.into(),
        [binary.as_bytes(), &[1; 70]].concat(),
        PTX.into(),
        b"3\n1 2 3 4 5 6 7\n2 3 4 5 6 7 8\n3 4 5 6 7 8 9\n".into(),
        b"X;Y;Z;Intensity\n1,5;2;3;4\n2;3,25;4;5\n".into(),
        pcd("ascii", b"1 2 3 4\n2 3 4 5\n3 4 5 6\n4 5 6 7\n"),
        pcd("binary", &numbers),
        pcd("binary_compressed", &compressed),
        e57(),
        crate::sample::stl_bytes(&crate::sample::solids::cube(1.0)),
    ]
}

/// Checksums of an E57 file as they have to be, so that damage reaches what is behind them.
fn mend(bytes: &mut [u8]) {
    for page in bytes.chunks_exact_mut(1024) {
        let (data, sum) = page.split_at_mut(1020);
        let rest = data.iter().fold(!0u32, |rest, byte| {
            (0..8).fold(rest ^ u32::from(*byte), |r, _| if r & 1 == 1 { (r >> 1) ^ 0x82f6_3b78 } else { r >> 1 })
        });
        sum.copy_from_slice(&(!rest).to_be_bytes());
    }
}

#[test]
fn the_files_are_whole() {
    for (i, bytes) in files().iter().enumerate() {
        let found = scan("a", bytes);
        assert!(found.cloud.len() >= 2, "{i}");
    }
    let mut mended = e57();
    mend(&mut mended);
    assert_eq!(mended, e57());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn changed_bytes_are_read_or_refused(
        which in 0..10usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), prop_oneof![any::<u8>(), prop::sample::select(b"0919 .,;-ex\n\xff\0".to_vec())]), 0..6),
        cut in prop::option::weighted(0.3, any::<prop::sample::Index>()),
        name in prop::sample::select(vec!["a", "a.stl", "a.pcd", "a.xyzn"]),
    ) {
        static FILES: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
        let mut bytes = FILES.get_or_init(files)[which].clone();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(bytes.len()) + 1);
        }
        if which == 8 {
            mend(&mut bytes);
        }
        let read = from_bytes(name, &bytes, &Progress::default());
        if let Ok(found) = read {
            prop_assert!(!found.cloud.is_empty());
            prop_assert!(found.cloud.points().all(|p| p.iter().all(|c| c.is_finite())));
        }
    }
}
