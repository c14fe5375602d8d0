//! Reads STL files as CAD systems really write them.
//!
//! Binary is told from text by the length, not by the first word: SolidWorks starts binary headers
//! with `solid `. Facets with a NaN or infinite corner are dropped and counted; a file that is cut
//! off is refused. Writing is left to `stl_io`.

use super::stl_text;

pub use super::raw_part::{FacetFault, InvalidFacet, RawFacet, RawPart, StlError, StlFormat};

const HEADER: usize = 84;
const RECORD: usize = 50;

/// Parses the bytes of an STL file.
pub fn read(bytes: &[u8]) -> Result<RawPart, StlError> {
    if bytes.is_empty() {
        return Err(StlError::Empty);
    }
    let promised = bytes.get(80..HEADER).map(|c| u64::from(u32::from_le_bytes([c[0], c[1], c[2], c[3]])));
    let needed = promised.map(|n| HEADER as u64 + RECORD as u64 * n);
    let present = bytes.len() as u64;
    // A text's bytes 80–84, read as a count, promise more than 150 million facets: never fits.
    let part = match (promised, needed) {
        (Some(n), Some(needed)) if needed <= present => read_binary(bytes, n as usize),
        _ if stl_text::looks_like_text(bytes) => stl_text::read(bytes)?,
        (Some(promised), Some(needed)) => return Err(StlError::CutOff { promised, needed, present }),
        _ => return Err(StlError::NotStl),
    };
    if part.facets.is_empty() {
        let first = part.invalid.first().map(|i| i.fault);
        return Err(StlError::NoFacet { dropped: part.invalid.len(), first });
    }
    Ok(part)
}

fn read_binary(bytes: &[u8], count: usize) -> RawPart {
    let end = HEADER + RECORD * count;
    let mut part = RawPart { solids: 1, tail_bytes: bytes.len() - end, ..Default::default() };
    part.facets.reserve_exact(count);
    for (i, record) in bytes[HEADER..end].chunks_exact(RECORD).enumerate() {
        let number = |k: usize| {
            let at = 12 + 4 * k;
            f32::from_le_bytes([record[at], record[at + 1], record[at + 2], record[at + 3]])
        };
        let facet: RawFacet = std::array::from_fn(|v| std::array::from_fn(|c| number(3 * v + c)));
        part.push_checked(facet, i, HEADER + RECORD * i);
    }
    part
}

#[cfg(test)]
mod tests {
    use super::*;

    fn binary(header: &[u8], count: u32, facets: &[RawFacet]) -> Vec<u8> {
        let mut b = vec![0u8; 80];
        b[..header.len()].copy_from_slice(header);
        b.extend(count.to_le_bytes());
        for f in facets {
            b.extend([0u8; 12]);
            b.extend(f.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
            b.extend([0u8; 2]);
        }
        b
    }

    const F: RawFacet = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    #[test]
    fn binary_whose_header_says_solid() {
        let part = read(&binary(b"solid made by a CAD system", 2, &[F, F])).expect("reads");
        assert_eq!((part.format, part.facets), (StlFormat::Binary, vec![F, F]));
    }

    #[test]
    fn a_tail_behind_the_last_facet_is_tolerated() {
        let mut b = binary(b"x", 1, &[F]);
        b.extend([7u8; 33]);
        let part = read(&b).expect("reads");
        assert_eq!((part.facets.len(), part.tail_bytes), (1, 33));
    }

    #[test]
    fn four_billion_promised_facets_are_refused_at_once() {
        let b = binary(b"x", u32::MAX, &[F]);
        assert!(matches!(read(&b), Err(StlError::CutOff { promised: 4_294_967_295, present: 134, .. })));
    }

    #[test]
    fn nan_is_dropped_and_said_and_all_nan_refused() {
        let mut bad = F;
        bad[1][2] = f32::NAN;
        let part = read(&binary(b"x", 2, &[bad, F])).expect("reads");
        assert_eq!(part.facets, vec![F]);
        assert_eq!(part.invalid, vec![InvalidFacet { facet: 0, byte: 84, fault: FacetFault::Nan }]);
        assert!(matches!(read(&binary(b"x", 1, &[bad])), Err(StlError::NoFacet { dropped: 1, .. })));
    }

    #[test]
    fn what_is_no_stl() {
        assert_eq!(read(b""), Err(StlError::Empty));
        assert_eq!(read(b"\xff\xd8\xff\xe0 JFIF"), Err(StlError::NotStl));
        assert!(matches!(read(&binary(b"x", 0, &[])), Err(StlError::NoFacet { .. })));
    }
}
