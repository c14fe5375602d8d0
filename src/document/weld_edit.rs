//! Changes of the weld of a job, each an [`Edit`](super::Edit) of its own.

use super::model::{AreaChoice, GrindingStrategy, GroundPass, JobWeld, NamedImage, RoughnessReading, WeldFiles};
use crate::weld::masking::BrushStroke;

/// A change of the weld.
#[derive(Clone, Debug, PartialEq)]
pub enum WeldEdit {
    /// Other images; without any the weld is gone. What was painted, chosen and ground on the images before goes with them.
    Images(WeldFiles),
    /// A file of the images is another one by now: it is taken as it is, with the digest `sha256`.
    Changed {
        /// As the job names it.
        file: String,
        /// SHA-256 of its bytes, hexadecimal.
        sha256: String,
    },
    /// A pass was ground: what it was planned from becomes history, and the next images take its place.
    Ground(GroundPass, WeldFiles),
    /// The level of the threshold; `None`: it follows from the histogram.
    Threshold(Option<f64>),
    /// A stroke of the brush, behind the others.
    Paint(BrushStroke),
    /// What was painted goes.
    Unpaint,
    /// How areas without height are ground.
    Strategy(GrindingStrategy),
    /// How beads are ground.
    BeadStrategy(GrindingStrategy),
    /// The areas that are ground.
    Areas(AreaChoice),
    /// The hand-eye file; empty: nobody knows where the camera stood.
    HandEye(String),
    /// The tool's file; empty: the shipped disc.
    Tool(String),
    /// Whether the next pass is given out though the last one took off other than it should.
    GoesOn(bool),
    /// Roughness readings, in place of those there were.
    Roughness(Vec<RoughnessReading>),
}

impl WeldEdit {
    /// Whether two of them change the same thing, so that they are one step within one drag.
    pub(super) fn goes_on_from(&self, earlier: &WeldEdit) -> bool {
        std::mem::discriminant(self) == std::mem::discriminant(earlier)
    }

    /// Applies it.
    pub(super) fn apply(&self, weld: &mut JobWeld) {
        match self {
            WeldEdit::Images(images) => {
                if weld.images != *images {
                    weld.history.clear();
                    seen_anew(weld, images);
                }
            }
            WeldEdit::Changed { file, sha256 } => take_changed(weld, file, sha256),
            WeldEdit::Ground(pass, images) => {
                weld.history.push(pass.clone());
                seen_anew(weld, images);
            }
            WeldEdit::Threshold(level) => weld.threshold = *level,
            WeldEdit::Paint(stroke) => weld.painted.push(stroke.clone()),
            WeldEdit::Unpaint => weld.painted.clear(),
            WeldEdit::Strategy(strategy) => weld.strategy = *strategy,
            WeldEdit::BeadStrategy(strategy) => weld.bead_strategy = *strategy,
            WeldEdit::Areas(choice) => weld.areas.clone_from(choice),
            WeldEdit::HandEye(file) => weld.hand_eye.clone_from(file),
            WeldEdit::Tool(file) => weld.tool.clone_from(file),
            WeldEdit::GoesOn(goes_on) => weld.goes_on = *goes_on,
            WeldEdit::Roughness(readings) => weld.roughness.clone_from(readings),
        }
    }
}

/// Takes an image, named as the job has it, as it is now: what was ground stays, what was painted and chosen on it goes.
pub(crate) fn take_changed(weld: &mut JobWeld, file: &str, sha256: &str) {
    let taken = |of: &NamedImage| match of.file == file {
        true => NamedImage { sha256: sha256.to_owned(), ..of.clone() },
        false => of.clone(),
    };
    let pair = |of: &WeldFiles| WeldFiles { gray: taken(&of.gray), depth: taken(&of.depth), camera: of.camera.clone() };
    for pass in &mut weld.history {
        pass.images = pair(&pass.images);
    }
    let images = pair(&weld.images);
    if weld.images != images {
        seen_anew(weld, &images);
    }
}

/// Other images: pixels of the last ones say nothing of them.
fn seen_anew(weld: &mut JobWeld, images: &WeldFiles) {
    weld.images.clone_from(images);
    weld.painted.clear();
    weld.areas = AreaChoice::All;
    weld.threshold = None;
    weld.goes_on = false;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Document, Edit, Job, job_file};

    fn images(name: &str) -> WeldFiles {
        let file = |kind: &str| NamedImage { file: format!("{name}_{kind}.png"), sha256: "ab".into() };
        WeldFiles {
            gray: file("gray"),
            depth: file("depth"),
            camera: NamedImage { file: "camera.toml".into(), ..NamedImage::default() },
        }
    }

    fn stroke() -> BrushStroke {
        BrushStroke { adds: true, radius_px: 4.0, way_px: vec![[10.0, 20.0], [11.0, 20.5]] }
    }

    fn all_kinds() -> Vec<WeldEdit> {
        vec![
            WeldEdit::Images(images("a")),
            WeldEdit::Paint(stroke()),
            WeldEdit::Threshold(Some(120.0)),
            WeldEdit::Areas(AreaChoice::At(vec![[3.0, 4.0]])),
            WeldEdit::GoesOn(true),
            WeldEdit::Ground(GroundPass { images: images("a"), height_mm: 4.0, planned_mm: 3.5 }, images("b")),
            WeldEdit::Changed { file: "a_gray.png".into(), sha256: "cd".into() },
            WeldEdit::Strategy(GrindingStrategy::Zigzag),
            WeldEdit::BeadStrategy(GrindingStrategy::OneWay),
            WeldEdit::HandEye("camera.toml".into()),
            WeldEdit::Tool("belt.toml".into()),
            WeldEdit::Roughness(vec![RoughnessReading { point: 1, before_um: 2.9, after_um: Some(0.6) }]),
            WeldEdit::Paint(stroke()),
        ]
    }

    #[test]
    fn every_change_is_saved_and_undone_one_by_one() {
        let mut doc = Document::default();
        let mut before = vec![doc.job().clone()];
        for edit in all_kinds() {
            doc.apply(&Edit::Grind(Box::new(edit)), &[], None);
            let text = toml::to_string(doc.job()).expect("writes");
            assert_eq!(&job_file::parse(&text).expect(&text), doc.job());
            before.push(doc.job().clone());
        }
        for job in before.iter().rev().skip(1) {
            doc.undo();
            assert_eq!(doc.job(), job);
        }
    }

    #[test]
    fn a_changed_image_keeps_the_history_and_what_was_said_of_other_pixels() {
        let mut doc = Document::default();
        for edit in all_kinds() {
            doc.apply(&Edit::Grind(Box::new(edit)), &[], None);
        }
        let changed = |file: &str| WeldEdit::Changed { file: file.into(), sha256: "ef".into() };
        doc.apply(&Edit::Grind(Box::new(changed("a_depth.png"))), &[], None);
        let weld = &doc.job().weld;
        assert_eq!((weld.history[0].images.depth.sha256.as_str(), weld.painted.len()), ("ef", 1), "an earlier image");
        doc.apply(&Edit::Grind(Box::new(changed("b_gray.png"))), &[], None);
        let weld = &doc.job().weld;
        assert_eq!((weld.images.gray.sha256.as_str(), weld.images.depth.sha256.as_str()), ("ef", "ab"));
        assert_eq!((weld.history.len(), weld.painted.len()), (1, 0), "what is ground stays, what was painted goes");
    }

    #[test]
    fn other_images_take_along_what_was_said_of_pixels_and_a_ground_pass_becomes_history() {
        let mut doc = Document::default();
        for edit in all_kinds() {
            doc.apply(&Edit::Grind(Box::new(edit)), &[], None);
        }
        let weld = &doc.job().weld;
        assert_eq!((weld.history.len(), weld.images.gray.file.as_str()), (1, "b_gray.png"));
        assert_eq!((weld.painted.len(), &weld.areas, weld.threshold, weld.goes_on), (1, &AreaChoice::All, None, false));
        doc.apply(&Edit::Grind(Box::new(WeldEdit::Images(WeldFiles::default()))), &[], None);
        let weld = &doc.job().weld;
        assert!(!weld.is_there() && weld.history.is_empty() && weld.strategy == GrindingStrategy::Zigzag);
        assert!(!Job::default().weld.is_there());
    }
}
