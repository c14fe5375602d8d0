//! STL files as CAD systems really write them: text, binary, and several solids one behind the other in either form.
//!
//! Binary is told from text by the length, not by the first word: SolidWorks starts binary headers with `solid `. A
//! file that is cut off is refused; what is read beside the letter of the format is noted in the [`RawPart`]. Writing
//! is left to `stl_io`.

mod binary;
mod text;
mod words;

use super::PartFileError;
use crate::part::raw_part::RawPart;
use crate::progress::Progress;

/// Whether the bytes are binary solids by their counts, as far as their end or a text.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    binary::solids(bytes, 0).is_some()
}

/// Parses an STL file.
///
/// # Errors
/// It is cut off, or no STL; [`PartFileError::Cancelled`] when `progress` says so.
pub(super) fn read(bytes: &[u8], progress: &Progress) -> Result<RawPart, PartFileError> {
    let mut part = RawPart::default();
    let mut at = 0;
    while at < bytes.len() {
        at = if let Some(found) = binary::solids(bytes, at) {
            binary::read_solids(bytes, &found, &mut part, progress)?;
            found.end
        } else if words::begins(&bytes[at..]) {
            text::read(bytes, at, &mut part, progress)?
        } else if at == 0 {
            binary::read_uneven(bytes, &mut part, progress)?;
            bytes.len()
        } else {
            part.pass_over(bytes.len() - at, at);
            bytes.len()
        };
    }
    Ok(part)
}

#[cfg(test)]
mod tests {
    use super::super::changed_bytes::ChangedBytes;
    use super::super::read;
    use super::*;
    use crate::part::raw_part::{CountDiffers, FacetFault, InvalidFacet, PassedOver, RawFacet};
    use proptest::prelude::*;

    /// A binary file: its header, the facets that it promises, and those there are, each with bytes behind it.
    fn binary(header: &[u8], count: u32, facets: &[RawFacet], attribute: &[u8]) -> Vec<u8> {
        let mut b = vec![0u8; 80];
        b[..header.len()].copy_from_slice(header);
        b.extend(count.to_le_bytes());
        for f in facets {
            b.extend([0u8; 12]);
            b.extend(f.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
            b.extend((attribute.len() as u16).to_le_bytes());
            b.extend(attribute);
        }
        b
    }

    const F: RawFacet = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    const G: RawFacet = [[0.0, 0.0, 5.0], [1.0, 0.0, 5.0], [0.0, 1.0, 5.0]];
    const TEXT: &[u8] = b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 5\nvertex 1 0 5\nvertex 0 1 5\n\
        endloop\nendfacet\nendsolid a\n";

    #[test]
    fn binary_whose_header_says_solid_or_anything() {
        for header in [b"solid made by a CAD system".as_slice(), b"%PDF", b"PK\x03\x04", b"v 1 2 3\n"] {
            let part = read(&binary(header, 2, &[F, G], b"")).expect("reads");
            assert_eq!(part, RawPart { facets: vec![F, G], solids: 1, ..RawPart::default() });
        }
    }

    #[test]
    fn a_tail_behind_the_last_facet_is_told() {
        let mut b = binary(b"x", 1, &[F], b"");
        b.extend([7u8; 33]);
        let part = read(&b).expect("reads");
        assert_eq!((part.facets.len(), part.passed_over), (1, Some(PassedOver { count: 33, at: 134 })));
        // As long as a facet and more, but none: zeros that fill a block, or words.
        for tail in
            [vec![0u8; 378], b"made by a program that ends its files with a line of words about itself".repeat(2)]
        {
            let part = read(&[binary(b"x", 1, &[F], b""), tail.clone()].concat()).expect("reads");
            let over = PassedOver { count: tail.len(), at: 134 };
            assert_eq!((part.facets, part.passed_over, part.count_differs), (vec![F], Some(over), None));
        }
    }

    #[test]
    fn attribute_bytes_may_follow_each_facet_or_be_a_colour() {
        let part = read(&binary(b"x", 2, &[F, G], b"\x11\x22\x33\x44")).expect("reads");
        assert_eq!(part, RawPart { facets: vec![F, G], solids: 1, ..RawPart::default() });
        let mut coloured = binary(b"x", 2, &[F, G], b"");
        (coloured[132], coloured[182]) = (0x1f, 0x7c);
        coloured.extend([9; 5]);
        let part = read(&coloured).expect("reads");
        assert_eq!((part.facets, part.passed_over), (vec![F, G], Some(PassedOver { count: 5, at: 184 })));
        let cut = binary(b"x", 40, &[F; 40], &[5; 30]);
        assert!(matches!(read(&cut[..3000]), Err(PartFileError::CutOff { promised: 40, .. })));
    }

    #[test]
    fn a_count_that_is_too_low_is_told_and_all_is_read() {
        for promised in [0, 1, 5] {
            let part = read(&binary(b"x", promised as u32, &[F, G, F, G, F, G, G], b"")).expect("reads");
            let told = Some(CountDiffers { promised, read: 7 });
            assert_eq!((part.facets.len(), part.count_differs, part.solids), (7, told, 1));
        }
        // More facets, and then something else.
        let mut doubtful = binary(b"x", 2, &[F, G, F, G], b"");
        doubtful.extend([0xc7; 250]);
        assert_eq!(read(&doubtful), Err(PartFileError::CountDoubtful { promised: 2, more: 2 }));
    }

    #[test]
    fn a_count_that_is_too_high_is_refused_at_once() {
        let b = binary(b"x", u32::MAX, &[F], b"");
        assert!(matches!(read(&b), Err(PartFileError::CutOff { promised: 4_294_967_295, present: 134, .. })));
        let b = binary(b"x", 3, &[F, G], b"");
        assert_eq!(read(&b), Err(PartFileError::CutOff { promised: 3, needed: 234, present: 184 }));
    }

    #[test]
    fn solids_one_behind_the_other_in_any_form_are_joined() {
        let (one, two) = (binary(b"solid", 1, &[F], b""), binary(b"second", 2, &[G, F], b""));
        let payload = binary(b"third", 1, &[G], b"\x01\x02\x03");
        let unended = &TEXT[..TEXT.len() - 1];
        let joined: [(Vec<u8>, &[RawFacet], usize); 6] = [
            ([&one[..], &two].concat(), &[F, G, F], 2),
            ([&one[..], &two, &one].concat(), &[F, G, F, F], 3),
            ([&one[..], TEXT].concat(), &[F, G], 2),
            ([TEXT, &two].concat(), &[G, G, F], 2),
            ([unended, &two, TEXT].concat(), &[G, G, F, G], 3),
            ([&payload[..], &payload].concat(), &[G, G], 2),
        ];
        for (bytes, facets, solids) in joined {
            let part = read(&bytes).expect("reads");
            assert_eq!(part, RawPart { facets: facets.to_vec(), solids, ..RawPart::default() });
        }
        // The second one is cut off: what is left of it is passed over, and told.
        let part = read(&[&one[..], &two[..120]].concat()).expect("reads");
        assert_eq!((part.facets.len(), part.passed_over), (1, Some(PassedOver { count: 120, at: 134 })));
    }

    #[test]
    fn nan_is_dropped_and_said_and_all_nan_refused() {
        let mut bad = F;
        bad[1][2] = f32::NAN;
        let part = read(&binary(b"x", 2, &[bad, F], b"")).expect("reads");
        assert_eq!(part.facets, vec![F]);
        assert_eq!(part.invalid, vec![InvalidFacet { facet: 0, byte: 84, fault: FacetFault::Nan }]);
        assert!(matches!(read(&binary(b"x", 1, &[bad], b"")), Err(PartFileError::NoFacet { dropped: 1, .. })));
    }

    #[test]
    fn what_is_no_stl() {
        assert_eq!(read(b""), Err(PartFileError::Empty));
        assert_eq!(read(b"hello"), Err(PartFileError::Unknown));
        assert!(matches!(read(&binary(b"x", 0, &[], b"")), Err(PartFileError::NoFacet { .. })));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// No bytes make a reader panic, and what it reads is finite.
        #[test]
        fn changed_bytes_are_read_or_refused(which in 0..4usize, changed in ChangedBytes::any()) {
            let plain = binary(b"x", 6, &[F, G, F, G, F, G], b"");
            let payload = binary(b"x", 3, &[F, G, F], b"\x01\x02");
            let mixed = [TEXT, &plain, &payload].concat();
            let bytes = changed.of([plain, payload, TEXT.repeat(3), mixed][which].clone());
            if let Ok(part) = read(&bytes) {
                prop_assert!(part.facets.iter().all(|f| f.as_flattened().iter().all(|x| x.is_finite())));
            }
        }
    }
}
