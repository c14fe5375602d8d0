//! Still pictures without a screen: of `render`, of a report's page, and of a package.

use super::{PartLook, PartPicture, PathLook, paths};
use crate::planning::PlannedJob;
use crate::view::{Bounds, Camera, HeadlessGl, Renderer, Scene, StandardView, ViewError, ViewSize};
use image::RgbaImage;
use std::io::Cursor;

/// A scene as it looks from a side, as large as fits.
///
/// # Errors
/// The driver refuses something.
pub fn still(
    gl: &HeadlessGl,
    scene: &Scene,
    bounds: Bounds,
    (view, size): (StandardView, [u32; 2]),
) -> Result<RgbaImage, ViewError> {
    let pixels = ViewSize::new(f64::from(size[0]), f64::from(size[1]));
    let mut camera = Camera::fitted(bounds, pixels);
    camera.look(view);
    camera.fit(&bounds, pixels);
    let mut renderer = Renderer::new(gl.gl())?;
    renderer.draw(scene, &camera, size)?;
    Ok(renderer.read_rgba())
}

/// A picture as the bytes of a PNG file.
///
/// # Errors
/// It cannot be packed.
pub fn png(image: &RgbaImage) -> image::ImageResult<Vec<u8>> {
    let mut png = Cursor::new(Vec::new());
    image.write_to(&mut png, image::ImageFormat::Png)?;
    Ok(png.into_inner())
}

/// A planned part with its lines, and its bounds.
pub fn part_with_lines(planned: &PlannedJob) -> (Scene, Bounds) {
    let PlannedJob { part, surfaces, plan, job, .. } = planned;
    let chosen = job.chosen(surfaces);
    let path_look = PathLook { lines: true, frame_mm: 0.02 * part.mesh.diagonal(), ..PathLook::default() };
    let mut scene = Scene { lines: paths(plan, &path_look, 1), ..Scene::default() };
    scene
        .meshes
        .push(PartPicture::new(part, surfaces, None).item(surfaces, &PartLook { chosen, ..PartLook::default() }));
    let (min, max) = part.mesh.bounds();
    (scene, Bounds { min, max })
}
