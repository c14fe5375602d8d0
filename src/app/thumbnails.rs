//! Small pictures of files that were opened: the view as it was when they were left, kept in the user's cache and shown
//! on the first page.

use super::App;
use crate::document::files::write_atomic;
use crate::part::digest_of;
use crate::picture::png;
use eframe::egui::{ColorImage, Context, TextureHandle, TextureOptions};
use image::imageops::{self, FilterType};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Pixels of a picture, at most.
const WIDTH: u32 = 240;
const HEIGHT: u32 = 160;

/// The pictures, and where they are kept.
#[derive(Default)]
pub(super) struct Thumbnails {
    folder: Option<PathBuf>,
    /// Those that were asked for; `None`: there is none.
    known: HashMap<PathBuf, Option<TextureHandle>>,
}

impl Thumbnails {
    /// Pictures that are kept in a folder; `None`: none are.
    pub fn in_folder(folder: Option<PathBuf>) -> Thumbnails {
        Thumbnails { folder, known: HashMap::new() }
    }

    /// Reads the pictures of files that were not asked for before.
    pub fn sync(&mut self, files: &[PathBuf], ctx: &Context) {
        let Some(folder) = &self.folder else { return };
        for file in files {
            if !self.known.contains_key(file) {
                self.known.insert(file.clone(), read(&kept_at(folder, file), ctx));
            }
        }
    }

    /// The picture of a file, if there is one.
    pub fn of(&self, file: &Path) -> Option<&TextureHandle> {
        self.known.get(file)?.as_ref()
    }
}

/// Where the picture of a file is kept.
fn kept_at(folder: &Path, file: &Path) -> PathBuf {
    let name = digest_of(file.to_string_lossy().as_bytes());
    folder.join(format!("{name}.png"))
}

fn read(path: &Path, ctx: &Context) -> Option<TextureHandle> {
    let picture = image::open(path).ok()?.into_rgba8();
    let size = [picture.width() as usize, picture.height() as usize];
    let image = ColorImage::from_rgba_unmultiplied(size, picture.as_raw());
    Some(ctx.load_texture(path.to_string_lossy(), image, TextureOptions::LINEAR))
}

impl App {
    /// The window with pictures of files in a folder of the user's cache.
    pub fn with_thumbnails(self, folder: Option<PathBuf>) -> App {
        App { thumbnails: Thumbnails::in_folder(folder), ..self }
    }

    /// Keeps the view of the document that is being left. A picture less is no reason to tell anybody.
    pub(super) fn keep_thumbnail(&mut self) {
        let Some(folder) = self.thumbnails.folder.clone() else { return };
        let (Some(file), Some(picture)) = (self.recent.first().cloned(), self.viewport.picture()) else { return };
        if self.derived.part.is_none() || picture.width() < WIDTH || picture.height() < HEIGHT {
            return;
        }
        // The middle of the view in the shape of the page's pictures.
        let (width, height) = (picture.width(), picture.height());
        let (w, h) = (width.min(height * WIDTH / HEIGHT), height.min(width * HEIGHT / WIDTH));
        let middle = imageops::crop_imm(&picture, (width - w) / 2, (height - h) / 2, w, h).to_image();
        let small = imageops::resize(&middle, WIDTH, HEIGHT, FilterType::Triangle);
        let kept = std::fs::create_dir_all(&folder).is_ok()
            && png(&small).is_ok_and(|png| write_atomic(&kept_at(&folder, &file), &png).is_ok());
        if kept {
            self.thumbnails.known.remove(&file);
        }
    }
}
