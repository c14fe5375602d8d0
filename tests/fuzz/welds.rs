//! What a weld is read from: grey and depth images, cameras, where they stood, grinding tools. Images that are read are
//! masked, and a camera that is read carries its pixels into space.

use crate::run::{Kind, check_sentence, outline, run};
use clearbeam::beam::ContactTool;
use clearbeam::cell::hand_eye;
use clearbeam::progress::Progress;
use clearbeam::text::Sentence;
use clearbeam::weld::masking::{MaskRules, masked};
use clearbeam::weld::{DepthCamera, camera_file, image_file, points};
use image::{DynamicImage, ImageFormat};
use std::io::Cursor;

const WIDTH: u32 = 24;
const HEIGHT: u32 = 16;

fn packed(image: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, format).expect("packs");
    bytes.into_inner()
}

/// A bright band on a gradient, in every form that is read.
fn grey_files() -> Vec<Vec<u8>> {
    let level = |x: u32, y: u32| (60 + 2 * x + if (6..10).contains(&y) { 120 } else { 0 }) as u8;
    let grey = image::GrayImage::from_fn(WIDTH, HEIGHT, |x, y| image::Luma([level(x, y)]));
    let deep = image::ImageBuffer::from_fn(WIDTH, HEIGHT, |x, y| image::Luma([u16::from(level(x, y)) * 257]));
    let colour = image::RgbImage::from_fn(WIDTH, HEIGHT, |x, y| image::Rgb([level(x, y), 40, level(x, y) / 2]));
    let [grey, deep, colour] =
        [DynamicImage::ImageLuma8(grey), DynamicImage::ImageLuma16(deep), DynamicImage::ImageRgb8(colour)];
    vec![
        packed(&grey, ImageFormat::Png),
        packed(&deep, ImageFormat::Png),
        packed(&colour, ImageFormat::Jpeg),
        packed(&deep, ImageFormat::Tiff),
    ]
}

fn depth_files() -> Vec<Vec<u8>> {
    let mm = |x: u32, y: u32| if (x + y).is_multiple_of(7) { 0 } else { (3500 - 10 * y) as u16 };
    let deep = DynamicImage::ImageLuma16(image::ImageBuffer::from_fn(WIDTH, HEIGHT, |x, y| image::Luma([mm(x, y)])));
    let mut pgm = format!("P5\n{WIDTH} {HEIGHT}\n65535\n").into_bytes();
    pgm.extend((0..HEIGHT).flat_map(|y| (0..WIDTH).flat_map(move |x| mm(x, y).to_be_bytes())));
    vec![packed(&deep, ImageFormat::Png), packed(&deep, ImageFormat::Tiff), pgm]
}

fn read_grey(bytes: &[u8]) -> String {
    let image = match image_file::grey_from_bytes(bytes, "gray.png", &Progress::default()) {
        Ok(image) => image,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    assert!(image.is_whole() && image.values.iter().all(|x| (0.0..=255.0).contains(x)));
    if image.values.len() > 4096 {
        return "large".into();
    }
    let mask = masked(&image, &MaskRules::default(), &Progress::default()).expect("an image");
    assert!(mask.areas.labels.is_whole() && mask.threshold.is_finite());
    format!("{} areas", mask.areas.list.len().min(4))
}

fn read_depth(bytes: &[u8]) -> String {
    match image_file::depth_from_bytes(bytes, "depth.png", &Progress::default()) {
        Ok(image) => {
            assert!(image.is_whole());
            let all = points(&image, &DepthCamera::pinhole(30.0, 30.0, 11.5, 7.5), None);
            assert!(all.iter().all(|p| p.point.iter().all(|c| c.is_finite()) && p.point.z > 0.0));
            format!("{} points", all.len().checked_ilog2().unwrap_or(0))
        }
        Err(e) => {
            check_sentence(&e.sentence());
            outline(&e)
        }
    }
}

fn read_camera(bytes: &[u8]) -> String {
    let camera = match camera_file::from_bytes(bytes, "camera.toml") {
        Ok(camera) => camera,
        Err(e) => {
            check_sentence(&e.sentence());
            return outline(&e);
        }
    };
    let fits = camera.fits(640, 480);
    for [u, v] in [[0.0, 0.0], [320.0, 240.0], [639.0, 479.0]] {
        let Some(ray) = camera.ray(u, v) else { continue };
        assert!(ray.iter().all(|c| c.is_finite()), "{camera:?}");
        if let Some([x, y]) = camera.pixel_of(&(ray * 300.0).into()).filter(|_| fits.is_ok()) {
            assert!((x - u).abs() + (y - v).abs() < 1e-3, "{camera:?}: {x} {y} for {u} {v}");
        }
    }
    outline(&fits)
}

fn read_hand_eye(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    match hand_eye::file::parse(&text, "camera_stand.toml") {
        Ok(stand) => {
            let place = stand.base_from_camera.map(|m| m.to_matrix());
            assert!(place.is_none_or(|m| m.iter().all(|x| x.is_finite())));
            format!("{} {}", place.is_some(), stand.calibration.is_some_and(|c| c.is_of_few_poses()))
        }
        Err(e) => {
            check_sentence(&e.sentence());
            outline(&e)
        }
    }
}

fn read_grinder(bytes: &[u8]) -> String {
    match ContactTool::from_toml(&String::from_utf8_lossy(bytes)) {
        Ok(tool) => format!("{} pieces", tool.stack.len().min(9)),
        Err(e) => {
            check_sentence(&e.sentence());
            outline(&e)
        }
    }
}

#[test]
fn grey_images() {
    run(&Kind { name: "grey_image", own: grey_files(), words: &["IHDR", "IDAT", "\u{fffd}"], read: &read_grey });
}

#[test]
fn depth_images() {
    let words = ["P5\n", "65535\n", "IHDR", "# a comment\n"];
    run(&Kind { name: "depth_image", own: depth_files(), words: &words, read: &read_depth });
}

#[test]
fn cameras() {
    let words = [
        "k1 = -0.3\n",
        "k3 = 1e9\n",
        "s = 0\n",
        "width = 640\n",
        "nan",
        "inf",
        "1e308",
        "\"intrinsic_matrix\"",
        "[",
        "]",
    ];
    let plain =
        "fx = 600\nfy = 600.0\ncx = 319.5\ncy = 239.5\ns = 10\nk1 = 0.1\nk2 = -0.05\np1 = 0.001\np2 = 0\nk3 = 0\n";
    let open3d = "{\"width\": 640, \"height\": 480, \"intrinsic_matrix\": [525.0, 0, 0, 0, 525.0, 0, 319.5, 239.5, 1]}";
    run(&Kind { name: "camera", own: vec![plain.into(), open3d.into()], words: &words, read: &read_camera });
}

#[test]
fn hand_eyes() {
    let turned = [
        "[1,0,0,10, 0,1,0,20, 0,0,1,30, 0,0,0,1]",
        "[0,-1,0,10, 1,0,0,20, 0,0,1,35, 0,0,0,1]",
        "[1,0,0,14, 0,0,-1,20, 0,1,0,30, 0,0,0,1]",
        "[0,0,1,10, 0,1,0,27, -1,0,0,30, 0,0,0,1]",
    ];
    let pose = |m: &&str| format!("[[pose]]\nbase_from_flange = {m}\ncamera_from_target = {m}\n");
    let poses: String = turned.iter().map(pose).collect();
    let own = vec![
        format!("camera = \"hand\"\nbase_from_flange = {}\n{poses}", turned[0]).into_bytes(),
        format!("base_from_camera = {}\n", turned[1]).into_bytes(),
        format!("flange_from_camera = {}\nbase_from_flange = {}\n", turned[1], turned[2]).into_bytes(),
    ];
    let words = ["camera = \"fixed\"\n", "[[pose]]\n", turned[3], "base_from_camera = ", "nan", "1e300", "-1", ", 0"];
    run(&Kind { name: "hand_eye", own, words: &words, read: &read_hand_eye });
}

#[test]
fn grinders() {
    let disc = include_str!("../../assets/tools/disc.toml");
    let own = vec![disc.into(), b"kind = \"belt\"\nradius_mm = 40\nwidth_mm = 20\n".to_vec()];
    let words = ["contact = \"face\"\n", "kind = \"disc\"\n", "edge_mm = 0.1\n", "[[part]]\n", "nan", "1e9", "-3"];
    run(&Kind { name: "grinder", own, words: &words, read: &read_grinder });
}
