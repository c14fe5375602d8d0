//! 3MF archives made here: units, transforms, several models, and what is refused.

use super::super::changed_bytes::ChangedBytes;
use super::super::{FileKind, ThreeMfFault, read};
use super::*;
use crate::part::raw_part::{Unread, UnreadKind};
use crate::part::units::{StatedUnit, Units};
use crate::part::{Placement, Source, Weld};
use crate::progress::Progress;
use proptest::prelude::*;
use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;

const RELS: &str = r#"<?xml version="1.0"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="a" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" Target="/3D/part.model"/>
</Relationships>"#;

/// A tetrahedron of this number with corners at the origin and one along each axis.
fn object(id: u32, more: &str) -> String {
    format!(
        r#"<object id="{id}" {more}><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/>
<triangle v1="0" v2="1" v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles>
</mesh></object>"#
    )
}

fn model(attributes: &str, resources: &str, build: &str) -> String {
    format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<model {attributes} xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" xmlns:b="http://example.com/booleans">
<resources>{resources}</resources><build>{build}</build></model>"#
    )
}

fn archive(entries: &[(&str, &str)]) -> Vec<u8> {
    let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
    for (name, text) in entries {
        zip.start_file(*name, options).expect("begins");
        zip.write_all(text.as_bytes()).expect("writes");
    }
    zip.finish().expect("ends").into_inner()
}

fn file(model: &str) -> Vec<u8> {
    archive(&[("[Content_Types].xml", "<Types/>"), ("_rels/.rels", RELS), ("3D/part.model", model)])
}

#[test]
fn units_are_those_of_the_file() {
    for (word, unit, mm, units) in [
        ("micron", StatedUnit::Micron, 0.001, Units::Mm),
        ("millimeter", StatedUnit::Millimeter, 1.0, Units::Mm),
        ("centimeter", StatedUnit::Centimeter, 10.0, Units::Mm),
        ("inch", StatedUnit::Inch, 25.4, Units::Inch),
        ("foot", StatedUnit::Foot, 304.8, Units::Mm),
        ("meter", StatedUnit::Meter, 1000.0, Units::M),
    ] {
        let item = r#"<item objectid="1"/>"#;
        let part = read(&file(&model(&format!("unit=\"{word}\""), &object(1, ""), item))).expect("reads");
        assert_eq!((part.facets.len(), part.solids, part.stated_unit), (4, 1, Some(unit)));
        let source = Source { raw: part, sha256: String::new() };
        let size = |units| {
            let built =
                source.part(units, Weld::Exact, &Placement::default(), &[], &Progress::default()).expect("area");
            built.expect("not cancelled").mesh.bounds().1.z
        };
        assert_eq!((source.units(), size(units)), (units, mm));
        // Another unit than the file's takes the numbers as they stand.
        let other = if units == Units::Inch { Units::M } else { Units::Inch };
        assert_eq!(size(other), other.mm());
    }
    let unstated = read(&file(&model("", &object(1, ""), r#"<item objectid="1"/>"#))).expect("reads");
    assert_eq!(unstated.stated_unit, Some(StatedUnit::Millimeter));
}

#[test]
fn items_and_components_stand_where_their_transforms_put_them() {
    // Turned about z by a quarter, which makes y of x; then moved; then mirrored in x by the item.
    let placed = r#"<component objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 20 30"/>"#;
    let group = format!(r#"<object id="2"><components>{placed}</components></object>"#);
    let items = r#"<item objectid="2" transform="-1 0 0 0 1 0 0 0 1 100 0 0"/><item objectid="1"/>"#;
    let part = read(&file(&model("", &format!("{}{group}", object(1, "")), items))).expect("reads");
    assert_eq!((part.facets.len(), part.solids, part.unread.len()), (8, 2, 0));
    let [o, x, y, z] = [[90.0, 20.0, 30.0], [90.0, 21.0, 30.0], [91.0, 20.0, 30.0], [90.0, 20.0, 31.0]];
    // The mirror turns the winding, so outside stays outside.
    assert_eq!(part.facets[..4], [[o, x, y], [o, z, x], [o, y, z], [x, z, y]]);
}

#[test]
fn what_is_not_built_is_told() {
    let lattice =
        object(4, "").replace("</mesh>", "<b:beamlattice><b:beams><b:beam/><b:beam/></b:beams></b:beamlattice></mesh>");
    let resources = [object(1, ""), object(2, ""), object(3, "type=\"support\""), lattice].concat();
    let items = r#"<item objectid="1"/><item objectid="3"/><item objectid="4"/>"#;
    let part = read(&file(&model("", &resources, items))).expect("reads");
    assert_eq!((part.facets.len(), part.solids), (8, 2));
    let told = [(UnreadKind::ObjectsNotBuilt, 1), (UnreadKind::Supports, 1), (UnreadKind::LatticeBeams, 2)];
    assert_eq!(part.unread, told.map(|(what, count)| Unread { what, count }));
}

#[test]
fn objects_may_stand_in_other_models() {
    let main = model(
        "requiredextensions=\"p\"",
        r#"<object id="7"><components><component objectid="1" p:path="/3D/Objects/one.model"/></components></object>"#,
        r#"<item objectid="7"/>"#,
    );
    let one = model("", &object(1, ""), "");
    let with = |one: &str| archive(&[("_RELS/.rels", RELS), ("3d/Part.model", &main), ("3D/Objects/one.model", one)]);
    assert_eq!(read(&with(&one)).expect("reads").facets.len(), 4);
    let inch = one.replace("<model ", "<model unit=\"inch\" ");
    assert_eq!(read(&with(&inch)), Err(ThreeMfFault::UnitsDiffer.into()));
    let without = archive(&[("_rels/.rels", RELS), ("3D/part.model", &main)]);
    assert_eq!(read(&without), Err(ThreeMfFault::NoEntry { entry: "3D/Objects/one.model".into() }.into()));
}

#[test]
fn what_cannot_be_read_is_told_by_name() {
    let item = r#"<item objectid="1"/>"#;
    let refused =
        |attributes: &str, resources: &str, build: &str| match read(&file(&model(attributes, resources, build))) {
            Err(PartFileError::ThreeMf(fault)) => fault,
            other => panic!("{other:?}"),
        };
    let one = object(1, "");
    assert_eq!(refused("unit=\"yard\"", &one, item), ThreeMfFault::Unit { word: "yard".into() });
    let name = "http://example.com/booleans".to_owned();
    assert_eq!(refused("requiredextensions=\"b\"", &one, item), ThreeMfFault::Extension { name });
    assert_eq!(refused("", &one, r#"<item objectid="5"/>"#), ThreeMfFault::NoSuchObject { object: 5 });
    let far = one.replace("v3=\"3\"", "v3=\"4\"");
    assert_eq!(refused("", &far, item), ThreeMfFault::NoSuchVertex { object: 1, vertices: 4 });
    let word = one.replace("x=\"1\"", "x=\"one\"");
    assert_eq!(refused("", &word, item), ThreeMfFault::Value { element: "vertex".into(), line: 4 });
    assert_eq!(refused("", "<object id=\"1\">", item), ThreeMfFault::Xml { entry: "3D/part.model".into(), line: 4 });
    let of = |id: u32, of: u32| {
        format!(
            r#"<object id="{id}"><components>{}</components></object>"#,
            format!("<component objectid=\"{of}\"/>").repeat(60)
        )
    };
    assert_eq!(refused("", &of(1, 1), item), ThreeMfFault::TooDeep);
    let tower: String = (1..6).map(|id| of(id, id + 1)).collect();
    assert_eq!(refused("", &format!("{tower}{}", object(6, "")), item), ThreeMfFault::TooManyObjects { most: 100_000 });
    assert!(matches!(read(&file(&model("", "", ""))), Err(PartFileError::NoFacet { .. })));
}

#[test]
fn archives_that_are_no_3mf_damaged_or_far_too_large() {
    let other = archive(&[("word/document.xml", "<document/>")]);
    assert_eq!(read(&other), Err(PartFileError::Other(FileKind::Zip)));
    let whole = file(&model("", &object(1, ""), r#"<item objectid="1"/>"#));
    assert_eq!(read(&whole[..whole.len() / 2]), Err(ThreeMfFault::Archive.into()));
    // Blanks pack to a thousandth; the second time nothing is left to unpack.
    let (packed, progress) = (file(&" ".repeat(600 << 10)), Progress::default());
    let mut package = Package::open(&packed, 1, &progress).expect("opens");
    assert_eq!(package.text("3D/part.model").map(|t| t.len()), Ok(600 << 10));
    assert_eq!(package.text("3D/part.model"), Err(ThreeMfFault::TooLarge { most_mib: 1 }.into()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn changed_bytes_are_read_or_refused(changed in ChangedBytes::any(), packed: bool) {
        let model = model("", &object(1, ""), r#"<item objectid="1"/>"#);
        let whole = if packed {
            changed.of(file(&model))
        } else {
            file(&String::from_utf8_lossy(&changed.of(model)))
        };
        let (_, _) = (super::read(&whole, &Progress::default()), read(&whole));
    }
}
