//! Files of all kinds, written and read back, and files that are none.

use super::*;
use image::{DynamicImage, ImageBuffer, ImageFormat, Luma, Rgb};
use std::io::Cursor;
use tiff::encoder::{TiffEncoder, colortype::Gray32Float};

fn file(image: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, format).expect("writes");
    bytes.into_inner()
}

fn words() -> DynamicImage {
    ImageBuffer::<Luma<u16>, _>::from_fn(5, 3, |u, v| Luma([257 * (10 * u + v) as u16])).into()
}

fn grey(bytes: &[u8]) -> Result<GreyImage, ImageFileError> {
    grey_from_bytes(bytes, "grey", &Progress::default())
}

fn depth(bytes: &[u8]) -> Result<DepthImage, ImageFileError> {
    depth_from_bytes(bytes, "depth", &Progress::default())
}

#[test]
fn sixteen_bits_are_levels_or_depths() {
    for format in [ImageFormat::Png, ImageFormat::Tiff, ImageFormat::Pnm] {
        let bytes = file(&words(), format);
        let levels = grey(&bytes).expect("an image");
        assert_eq!(levels.size(), [5, 3]);
        assert!(levels.pixels().all(|([u, v], x)| (x - (10 * u + v) as f32).abs() < 1e-4), "{format:?}");
        let depths = depth(&bytes).expect("an image");
        assert!(depths.pixels().all(|([u, v], x)| *x == (257 * (10 * u + v)) as f32), "{format:?}");
    }
}

#[test]
fn eight_bits_and_colour_are_levels_and_no_depths() {
    let colour: DynamicImage = ImageBuffer::from_fn(64, 32, |u, _| Rgb([200u8, 100, (u / 32 * 50) as u8])).into();
    for (format, within) in [(ImageFormat::Png, 1e-3), (ImageFormat::Tiff, 1e-3), (ImageFormat::Jpeg, 2.0)] {
        let bytes = file(&colour, format);
        let level = *grey(&bytes).expect("an image").at(2, 2).expect("inside");
        assert!((level - (0.2126 * 200.0 + 0.7152 * 100.0)).abs() < within, "{format:?} {level}");
        assert!(matches!(depth(&bytes), Err(ImageFileError::Pixels { kind: WrongPixels::DepthInColour, .. })));
    }
    let plain = file(&words().to_luma8().into(), ImageFormat::Png);
    assert!(matches!(depth(&plain), Err(ImageFileError::Pixels { kind: WrongPixels::EightBitDepth, .. })));
}

#[test]
fn floats_are_depths_as_they_stand() {
    let mut bytes = Cursor::new(Vec::new());
    let values = [0.0f32, 501.25, f32::NAN, f32::INFINITY, 3.5, 1e-3];
    TiffEncoder::new(&mut bytes).and_then(|mut t| t.write_image::<Gray32Float>(3, 2, &values)).expect("writes");
    let bytes = bytes.into_inner();
    let bits = |v: &[f32]| v.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&depth(&bytes).expect("an image").values), bits(&values));
    assert!(matches!(grey(&bytes), Err(ImageFileError::Pixels { kind: WrongPixels::FloatGrey, .. })));
}

#[test]
fn depths_of_a_pgm_are_not_stretched() {
    let binary = [b"P5\n# from a camera\n2 2 4095\n".as_slice(), &[1, 0, 0, 7, 15, 255, 0, 0]].concat();
    let expected = vec![256.0, 7.0, 4095.0, 0.0];
    assert_eq!(depth(&binary).expect("an image").values, expected);
    assert_eq!(depth(b"P2 2 2\n4095\n256 7 #x\n4095 0").expect("an image").values, expected);
    assert!((grey(&binary).expect("an image").values[2] - 255.0).abs() < 1e-3, "levels are of the greatest");
    let narrow = [b"P5 2 1 255\n".as_slice(), &[1, 2]].concat();
    assert!(matches!(depth(&narrow), Err(ImageFileError::Pixels { kind: WrongPixels::EightBitDepth, .. })));
    for torn in [&binary[..binary.len() - 1], b"P5 2 2 70000\n        ", b"P2 2 2 300 1 2 3", b"P5", b"P2 9 9 300 1"] {
        assert!(matches!(depth(torn), Err(ImageFileError::Broken { .. })), "{torn:?}");
    }
}

#[test]
fn what_is_no_image_is_refused_without_decoding() {
    assert!(matches!(grey(b""), Err(ImageFileError::NoImage { .. })));
    assert!(matches!(grey(b"GIF89a\x01\x00\x01\x00\x00\x00\x00;"), Err(ImageFileError::NoImage { .. })));
    assert!(matches!(depth(b"P5 0 0 65535\n"), Err(ImageFileError::NoImage { .. })));
    assert!(matches!(
        depth(b"P5 60000 60000 65535\n"),
        Err(ImageFileError::TooLarge { size: Some([60_000, 60_000]), .. })
    ));
    // Heads of PNG that promise much: sides in bytes 16 to 24, their checksum made good.
    let png = file(&words(), ImageFormat::Png);
    let sized = |width: u32, height: u32| {
        let mut bytes = png.clone();
        bytes[16..20].copy_from_slice(&width.to_be_bytes());
        bytes[20..24].copy_from_slice(&height.to_be_bytes());
        let sum = crc(&bytes[12..29]);
        bytes[29..33].copy_from_slice(&sum.to_be_bytes());
        bytes
    };
    assert!(matches!(grey(&sized(60_000, 60_000)), Err(ImageFileError::TooLarge { .. })));
    assert!(grey(&sized(0, 0)).is_err() && grey(&sized(5, 300)).is_err());
    for end in 0..png.len() {
        assert!(grey(&png[..end]).is_err() || end > png.len() - 16, "{end}");
    }
    let jpeg = file(&words().to_luma8().into(), ImageFormat::Jpeg);
    let tiff = file(&words(), ImageFormat::Tiff);
    for bytes in [&jpeg, &tiff, &png] {
        for i in 0..bytes.len() {
            let mut torn = bytes.clone();
            torn[i] ^= 0xff;
            // Whatever comes of it: it is an image, or an error.
            let _ = (grey(&torn), depth(&torn), grey(&bytes[..i]), depth(&bytes[..i]));
        }
    }
}

/// The checksum of PNG, bit by bit.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0u32, |sum, b| {
        (0..8).fold(sum ^ u32::from(*b), |s, _| if s & 1 == 1 { (s >> 1) ^ 0xedb8_8320 } else { s >> 1 })
    })
}

#[test]
fn images_on_which_nothing_can_be_found_are_told() {
    let fault = |bytes: &[u8]| match grey(bytes) {
        Err(ImageFileError::Fault { fault, .. }) => Some(fault),
        _ => None,
    };
    let of = |level: &dyn Fn(u32) -> u8| {
        file(&ImageBuffer::<Luma<u8>, _>::from_fn(10, 10, |u, _| Luma([level(u)])).into(), ImageFormat::Png)
    };
    assert_eq!(fault(&of(&|_| 40)), Some(ImageFault::OneLevel { level: 40.0 }));
    assert_eq!(fault(&of(&|u| if u < 6 { 255 } else { 90 })), Some(ImageFault::Saturated { share: 0.6 }));
    assert_eq!(fault(&of(&|u| if u < 5 { 255 } else { 90 })), None);
    let empty = file(&ImageBuffer::<Luma<u16>, _>::new(4, 4).into(), ImageFormat::Png);
    assert!(matches!(depth(&empty), Err(ImageFileError::Fault { fault: ImageFault::NoDepth, .. })));
    let sizes = check_pair(&Raster::filled(4, 3, 0.0), &Raster::filled(3, 4, 0.0));
    assert_eq!(sizes, Err(ImageFault::SizesDiffer { grey: [4, 3], depth: [3, 4] }));
    assert_eq!(
        (check_grey(&Raster::default()), check_depth(&Raster::default())),
        (Err(ImageFault::NoPixels), Err(ImageFault::NoPixels))
    );
}

#[test]
fn a_file_is_told_by_what_it_holds() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("depth.jpg");
    let bytes = file(&words(), ImageFormat::Png);
    std::fs::write(&path, &bytes).expect("writes");
    let read = read_depth(&path, &Progress::default()).expect("a PNG, whatever its name");
    assert_eq!((read.sha256, read.image.size()), (digest_of(&bytes), [5, 3]));
    let progress = Progress::default();
    progress.cancel();
    assert!(matches!(read_grey(&path, &progress), Err(ImageFileError::Cancelled)));
    assert!(matches!(read_grey(&folder.path().join("none.png"), &Progress::default()), Err(ImageFileError::File(_))));
}
