//! Why a file is no scan that can be read, what was found in one that is, and whether its unit is in doubt.

use super::{Sentence, id, listed, quoted, rough, say};
use crate::part::file::FileKind;
use crate::scan::file::{
    Assumed, Attribute, E57Fault, PcdFault, PtxFault, ScanFileError, ScanFinding, UnitDoubt, UnitFit,
};

impl Sentence for ScanFileError {
    fn sentence(&self) -> String {
        match self {
            ScanFileError::Cancelled => say!(text_cancelled),
            ScanFileError::Io(source) => say!(scan_file_not_read, reason = source.to_string()),
            ScanFileError::Folder => say!(scan_file_folder),
            ScanFileError::Empty => say!(part_file_empty),
            ScanFileError::Other(kind) => other(*kind),
            ScanFileError::Unknown => say!(scan_file_unknown),
            ScanFileError::Part(error) => error.sentence(),
            ScanFileError::NoCoordinates { columns } => say!(scan_file_no_coordinates, columns = names(columns)),
            ScanFileError::CutOff { promised, present } => {
                say!(scan_file_cut_off, promised = *promised, present = *present)
            }
            ScanFileError::NoPoints => say!(scan_file_no_points),
            ScanFileError::AllDropped { dropped } => say!(scan_file_all_dropped, dropped = *dropped),
            ScanFileError::TooFar { point } => say!(scan_file_too_far, point = id(*point)),
            ScanFileError::TooMany { points } => say!(scan_file_too_many, points = *points),
            ScanFileError::Ply(fault) => fault.sentence(),
            ScanFileError::DecimalComma { byte } => say!(scan_file_decimal_comma, byte = id(*byte)),
            ScanFileError::Pcd(fault) => fault.sentence(),
            ScanFileError::Ptx { line, fault } => say!(in_line, line = id(*line), what = fault.sentence()),
            ScanFileError::E57(fault) => fault.sentence(),
        }
    }
}

/// What a file is that is no scan, and what to do.
fn other(kind: FileKind) -> String {
    let word = kind.word();
    match kind {
        FileKind::GitLfsPointer => say!(scan_file_lfs),
        FileKind::Zip | FileKind::Gzip | FileKind::Archive(_) => say!(scan_file_packed, kind = word),
        FileKind::WebPage => say!(scan_file_web_page),
        FileKind::OtherModel(_) | FileKind::NoModel(_) | FileKind::Ply | FileKind::Obj => {
            say!(scan_file_other, kind = word)
        }
    }
}

/// So many names of columns are listed.
const LISTED: usize = 12;

fn names(columns: &[String]) -> String {
    let more = (columns.len() > LISTED).then(|| "…".to_owned());
    listed(columns.iter().take(LISTED).map(|c| quoted(c)).chain(more))
}

impl Sentence for PcdFault {
    fn sentence(&self) -> String {
        match self {
            PcdFault::NoHeader => say!(pcd_no_header),
            PcdFault::NoData => say!(pcd_no_data),
            PcdFault::Line { line } => say!(pcd_line, line = id(*line)),
            PcdFault::Type { field } => say!(pcd_type, field = quoted(field)),
            PcdFault::Counts { points, grid } => say!(pcd_counts, points = *points, grid = *grid),
            PcdFault::Size { header, packed } => say!(pcd_size, header = *header, packed = *packed),
            PcdFault::Packed { byte } => say!(pcd_packed, byte = id(*byte)),
            PcdFault::Row { line } => say!(pcd_row, line = id(*line)),
        }
    }
}

impl Sentence for PtxFault {
    fn sentence(&self) -> String {
        match self {
            PtxFault::Count => say!(ptx_count),
            PtxFault::Pose => say!(ptx_pose),
            PtxFault::NoMotion => say!(ptx_no_motion),
            PtxFault::Point => say!(ptx_point),
        }
    }
}

impl Sentence for E57Fault {
    fn sentence(&self) -> String {
        match self {
            E57Fault::Checksum { page } => say!(e57_checksum, page = id(*page)),
            E57Fault::Length { stated, present } => say!(e57_length, stated = *stated, present = *present),
            E57Fault::Description => say!(e57_description),
            E57Fault::Points { scan } => say!(e57_points, scan = id(*scan)),
            E57Fault::Pose { scan } => say!(e57_pose, scan = id(*scan)),
            E57Fault::NotHandled => say!(e57_not_handled),
        }
    }
}

impl Sentence for ScanFinding {
    fn sentence(&self) -> String {
        match self {
            ScanFinding::PointsDropped { nan, infinite } => {
                say!(scan_points_dropped, count = nan + infinite)
            }
            ScanFinding::InvalidPoints { count } => say!(scan_invalid_points, count = *count),
            ScanFinding::CountDiffers { promised, read } => {
                say!(scan_count_differs, promised = *promised, read = *read)
            }
            ScanFinding::ShortRows { count, line } => say!(scan_short_rows, count = *count, line = id(*line)),
            ScanFinding::LongRows { count, line } => say!(scan_long_rows, count = *count, line = id(*line)),
            ScanFinding::LinesPassedOver { count, line } => {
                say!(scan_lines_passed_over, count = *count, line = id(*line))
            }
            ScanFinding::BytesPassedOver { count, at } => say!(scan_bytes_passed_over, count = *count, at = id(*at)),
            ScanFinding::NotForAll { what: Attribute::Normals, without } => {
                say!(scan_normals_not_for_all, without = *without)
            }
            ScanFinding::NotForAll { what: Attribute::Colours, without } => {
                say!(scan_colours_not_for_all, without = *without)
            }
            ScanFinding::NotForAll { what: Attribute::Intensities, without } => {
                say!(scan_intensities_not_for_all, without = *without)
            }
            ScanFinding::ColumnsAssumed { columns } => say!(scan_columns_assumed, columns = columns.sentence()),
            ScanFinding::DecimalCommas => say!(scan_decimal_commas),
            ScanFinding::ColumnsNotRead { names: columns } => say!(scan_columns_not_read, names = names(columns)),
            ScanFinding::NotRead { element, count } => {
                say!(scan_element_not_read, count = *count, name = quoted(element))
            }
            ScanFinding::ColoursClamped { count } => say!(scan_colours_clamped, count = *count),
            ScanFinding::ViewpointNotApplied => say!(scan_viewpoint),
            ScanFinding::CloudsJoined { count } => say!(scan_clouds_joined, count = *count),
            ScanFinding::CornersTaken { facets, dropped: 0 } => say!(scan_corners_taken, facets = *facets),
            ScanFinding::CornersTaken { facets, dropped } => {
                say!(scan_corners_taken_but, facets = *facets, dropped = *dropped)
            }
        }
    }
}

impl Sentence for Assumed {
    fn sentence(&self) -> String {
        match self {
            Assumed::Xyz => say!(scan_assumed_xyz),
            Assumed::XyzIntensity => say!(scan_assumed_intensity),
            Assumed::XyzRgb => say!(scan_assumed_rgb),
            Assumed::XyzNormal => say!(scan_assumed_normal),
            Assumed::XyzIntensityRgb => say!(scan_assumed_intensity_rgb),
        }
    }
}

impl Sentence for UnitDoubt {
    fn sentence(&self) -> String {
        let ratio = rough(self.ratio);
        match self.fits {
            UnitFit::Either { cloud, part } => say!(scan_unit_either, ratio, cloud = cloud.word(), part = part.word()),
            UnitFit::Cloud(unit) => say!(scan_unit_of_cloud, ratio, unit = unit.word()),
            UnitFit::Part(unit) => say!(scan_unit_of_part, ratio, unit = unit.word()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;
    use crate::scan::file::from_bytes;

    #[test]
    fn what_is_wrong_where_and_what_to_do() {
        let said =
            |name: &str, bytes: &[u8]| from_bytes(name, bytes, &Progress::default()).expect_err("no scan").sentence();
        assert!(said("a.pcd", b"1 2 3\n").contains("no PCD header"));
        assert!(said("a.las", b"LASF\x01\x02").contains("LAS / LAZ"));
        assert!(said("a.csv", b"t,r\n1,2,3\n").contains("no x, y and z: \"t\", \"r\""));
        assert!(said("a.txt", b"hello").contains("PLY, PCD, E57"));
    }

    #[test]
    fn findings_are_counted_and_placed() {
        let read = from_bytes("a.pts", b"3\n0 0 0 1\n1 1 nan 2\n1\t1\n", &Progress::default()).expect("a scan");
        let said: Vec<String> = read.findings.iter().map(Sentence::sentence).collect();
        assert!(said[0].starts_with("1 point was dropped"), "{said:?}");
        assert!(said.iter().any(|s| s.contains("line 4")), "{said:?}");
        let doubt = UnitDoubt { ratio: 1000.0, fits: UnitFit::Cloud(crate::part::Units::M) };
        assert!(doubt.sentence().contains("1000 times"), "{}", doubt.sentence());
    }
}
