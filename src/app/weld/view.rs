//! What is shown of a weld: the newest of each of its stages, the images on the graphics card, and the points of its bead
//! in the view. While a stage is made again what there was stays in sight.

use super::images::MaskStep;
use super::textures::ImageTextures;
use crate::picture::weld::{WeldPicture, weld_picture};
use crate::planning::welded::{MeasuredWeld, ReadWeld, WeldOnPart, WeldReport, Welded};
use crate::view::{CloudItem, LineItem};
use crate::weld::masking::MaskedImage;
use eframe::egui;
use nalgebra::Isometry3;
use std::sync::Arc;

/// What is shown of a weld, kept while it stays.
#[derive(Default)]
pub(in super::super) struct WeldView {
    read: Option<Arc<ReadWeld>>,
    masked: Option<Arc<MaskedImage>>,
    measured: Option<Arc<MeasuredWeld>>,
    ground: Option<Arc<WeldOnPart>>,
    report: Option<Arc<WeldReport>>,
    textures: Option<ImageTextures>,
    picture: Option<(Arc<MeasuredWeld>, Isometry3<f64>, WeldPicture)>,
}

impl WeldView {
    /// Takes what there is by now. `has_weld`: the job has one; `is_refused`: what is missing does not come.
    pub fn sync(&mut self, welded: Option<Welded>, has_weld: bool, is_refused: bool) {
        if !has_weld {
            *self = WeldView::default();
            return;
        }
        let Some(Welded { read, masked, measured, ground, report }) = welded else {
            if is_refused {
                *self = WeldView::default();
            }
            return;
        };
        if !self.read.as_ref().is_some_and(|known| Arc::ptr_eq(known, &read)) {
            // What was made of other images says nothing of these.
            *self = WeldView { read: Some(read), textures: self.textures.take(), ..WeldView::default() };
        }
        self.masked = masked.or(self.masked.take());
        self.measured = measured.or(self.measured.take().filter(|_| !is_refused));
        self.ground = ground.or(self.ground.take().filter(|_| !is_refused));
        self.report = report.or(self.report.take().filter(|_| !is_refused));
        self.sync_picture();
    }

    fn sync_picture(&mut self) {
        let place = self.ground.as_ref().map(|g| g.on.part_from_camera);
        let (Some(read), Some(measured), Some(place)) = (&self.read, &self.measured, place) else {
            self.picture = None;
            return;
        };
        let is_known =
            |(of, at, _): &(Arc<MeasuredWeld>, Isometry3<f64>, WeldPicture)| Arc::ptr_eq(of, measured) && *at == place;
        if !self.picture.as_ref().is_some_and(is_known) {
            let picture = weld_picture(measured, &read.camera, read.grey.size(), &place);
            self.picture = Some((measured.clone(), place, picture));
        }
    }

    /// Makes the images of a step, if they are not there.
    pub fn sync_textures(&mut self, step: MaskStep, ctx: &egui::Context) {
        let Some(read) = &self.read else {
            self.textures = None;
            return;
        };
        self.textures = Some(ImageTextures::synced(self.textures.take(), read, self.masked.as_ref(), step, ctx));
    }

    /// The images as they were read.
    pub fn read(&self) -> Option<&Arc<ReadWeld>> {
        self.read.as_ref()
    }

    /// The mask, step by step.
    pub fn masked(&self) -> Option<&Arc<MaskedImage>> {
        self.masked.as_ref()
    }

    /// What was measured.
    pub fn measured(&self) -> Option<&Arc<MeasuredWeld>> {
        self.measured.as_ref()
    }

    /// What is reported of it.
    pub fn report(&self) -> Option<&WeldReport> {
        self.report.as_deref()
    }

    /// The images on the graphics card.
    pub fn textures(&self) -> Option<&ImageTextures> {
        self.textures.as_ref()
    }

    /// The points of the beads by their height, on a part that stands there.
    pub fn points(&self, place: &Isometry3<f64>) -> Option<CloudItem> {
        let item = self.picture.as_ref()?.2.points.as_ref()?;
        Some(CloudItem { scene_from_item: place * item.scene_from_item, ..item.clone() })
    }

    /// Centre lines and the camera's frame, part frame.
    pub fn lines(&self) -> impl Iterator<Item = &LineItem> {
        self.picture.iter().flat_map(|(_, _, picture)| &picture.lines)
    }

    /// The height at the end of the points' scale, mm; `None` without a bead.
    pub fn highest_mm(&self) -> Option<f64> {
        self.picture.as_ref().map(|(_, _, picture)| picture.highest_mm).filter(|mm| *mm > 0.0)
    }
}
