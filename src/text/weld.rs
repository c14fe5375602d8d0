//! A weld that is ground: why its images say nothing, and what was measured and planned.

use super::number::percent;
use super::scan::how_it_lies;
use super::{Sentence, exact, fixed, id, say};
use crate::cell::hand_eye::HandEyeError;
use crate::cell::hand_eye::file::HandEyeFileError;
use crate::planning::welded::{AreaTimes, HeldReason, UnmeasuredArea, WeldError, WeldReport};
use crate::weld::bead::{AreaKind, WeldBeadError};
use crate::weld::camera::CameraFault;
use crate::weld::camera_file::{CameraFileError, IntrinsicMatrixFault};
use crate::weld::image_file::{ImageFault, ImageFileError, WrongPixels};
use crate::weld::masking::MaskError;
use crate::weld::parent::ParentError;

impl Sentence for WeldError {
    fn sentence(&self) -> String {
        match self {
            WeldError::Image(e) => e.sentence(),
            WeldError::Changed { file, .. } => say!(weld_changed, file),
            WeldError::Pair(fault) => fault.sentence(),
            WeldError::OtherSize { before, now } => {
                let ([width, height], [now_width, now_height]) = (before.map(id), now.map(id));
                say!(weld_other_size, width, height, now_width, now_height)
            }
            WeldError::CameraFile(e) => e.sentence(),
            WeldError::DepthCamera { file, fault } => say!(in_file, file, what = fault.sentence()),
            WeldError::HandEye(e) => e.sentence(),
            WeldError::Mask(MaskError::NoImage { .. }) => say!(image_no_pixels),
            WeldError::Mask(MaskError::Cancelled) | WeldError::Cancelled => say!(text_cancelled),
            WeldError::NoArea => say!(weld_no_area),
            WeldError::Bead(e) => e.sentence(),
            WeldError::Passes(_) => say!(weld_too_many_passes),
            WeldError::NoSkin => say!(weld_no_skin),
            WeldError::Registration(e) => say!(weld_not_on_part, what = e.sentence()),
        }
    }
}

impl Sentence for ImageFileError {
    fn sentence(&self) -> String {
        let of = |file: &str, what: String| say!(in_file, file, what);
        match self {
            ImageFileError::File(e) => e.sentence(),
            ImageFileError::TooLarge { file, size: Some([width, height]), .. } => {
                of(file, say!(image_too_large, width = id(*width), height = id(*height)))
            }
            ImageFileError::TooLarge { file, size: None, .. } => of(file, say!(image_file_too_large)),
            ImageFileError::NoImage { file } => of(file, say!(image_no_image)),
            ImageFileError::Broken { file, reason } => of(file, say!(image_broken, reason)),
            ImageFileError::Pixels { file, kind } => of(file, kind.sentence()),
            ImageFileError::Fault { file, fault } => of(file, fault.sentence()),
            ImageFileError::Cancelled => say!(text_cancelled),
        }
    }
}

impl Sentence for WrongPixels {
    fn sentence(&self) -> String {
        match self {
            WrongPixels::EightBitDepth => say!(image_eight_bit_depth),
            WrongPixels::DepthInColour => say!(image_depth_in_colour),
            WrongPixels::FloatGrey => say!(image_float_grey),
            WrongPixels::Other => say!(image_other_pixels),
        }
    }
}

impl Sentence for ImageFault {
    fn sentence(&self) -> String {
        match self {
            ImageFault::NoPixels => say!(image_no_pixels),
            ImageFault::OneLevel { level } => say!(image_one_level, level = fixed(f64::from(*level), 0)),
            ImageFault::Saturated { share } => say!(image_saturated, share = percent(*share, 0)),
            ImageFault::NoDepth => say!(image_no_depth),
            ImageFault::SizesDiffer { grey, depth } => {
                let [gray_width, gray_height] = grey.map(id);
                let [depth_width, depth_height] = depth.map(id);
                say!(image_sizes_differ, gray_width, gray_height, depth_width, depth_height)
            }
        }
    }
}

impl Sentence for CameraFileError {
    fn sentence(&self) -> String {
        let at = |line: usize, what: String| say!(in_line, line = id(line), what);
        match self {
            CameraFileError::File(e) => e.sentence(),
            CameraFileError::Json { file, line, reason } => {
                say!(in_file, file, what = at(*line, say!(camera_json, reason)))
            }
            CameraFileError::Matrix { file, fault: IntrinsicMatrixFault::RowByRow } => {
                say!(in_file, file, what = say!(camera_row_by_row))
            }
            CameraFileError::Matrix { file, fault: IntrinsicMatrixFault::NotPinhole } => {
                say!(in_file, file, what = say!(camera_not_pinhole))
            }
            CameraFileError::Figure { file, line, fault } => {
                let what = fault.sentence();
                say!(in_file, file, what = line.map_or(what.clone(), |line| at(line, what)))
            }
        }
    }
}

impl Sentence for CameraFault {
    fn sentence(&self) -> String {
        match self {
            CameraFault::Figure { key, value } => say!(camera_figure, key = *key, value = exact(*value)),
            CameraFault::Size { camera, image } => {
                let ([width, height], [image_width, image_height]) = (camera.map(id), image.map(id));
                say!(camera_size, width, height, image_width, image_height)
            }
            CameraFault::OffMiddle { principal_px: [u, v], image } => {
                let [width, height] = image.map(id);
                say!(camera_off_middle, u = fixed(*u, 0), v = fixed(*v, 0), width, height)
            }
            CameraFault::Focal { focal_px, width } => {
                say!(camera_focal, focal = fixed(*focal_px, 0), width = id(*width))
            }
        }
    }
}

impl Sentence for HandEyeFileError {
    fn sentence(&self) -> String {
        let of = |file: &str, what: String| say!(in_file, file, what);
        let named = |key: &str, pose: &Option<usize>| match pose {
            Some(pose) => say!(hand_eye_key_of_pose, pose = id(*pose), key),
            None => key.to_owned(),
        };
        match self {
            HandEyeFileError::File(e) => e.sentence(),
            HandEyeFileError::Keys { file } => of(file, say!(hand_eye_keys)),
            HandEyeFileError::NoFlange { file } => of(file, say!(hand_eye_no_flange)),
            HandEyeFileError::Count { file, key, pose, count } => {
                of(file, say!(hand_eye_count, key = named(key, pose), count = *count))
            }
            HandEyeFileError::Matrix { file, key, pose, fault } => {
                of(file, say!(hand_eye_matrix, key = named(key, pose), fault = fault.sentence()))
            }
            HandEyeFileError::Poses { file, source } => of(file, source.sentence()),
        }
    }
}

impl Sentence for HandEyeError {
    fn sentence(&self) -> String {
        match self {
            HandEyeError::FewPoses { count } => say!(hand_eye_few_poses, count = *count),
            HandEyeError::SmallTurns { most_deg } => say!(hand_eye_small_turns, most = fixed(*most_deg, 1)),
            HandEyeError::OneAxis { axis: [x, y, z] } => {
                say!(hand_eye_one_axis, x = fixed(*x, 2), y = fixed(*y, 2), z = fixed(*z, 2))
            }
            HandEyeError::NoFit => say!(hand_eye_no_fit),
        }
    }
}

impl Sentence for WeldBeadError {
    fn sentence(&self) -> String {
        match self {
            WeldBeadError::Parent(e) => e.sentence(),
            WeldBeadError::NothingStands { threshold_mm } => {
                say!(weld_nothing_stands, threshold = fixed(*threshold_mm, 2))
            }
            WeldBeadError::LeavesImage => say!(weld_leaves_image),
            WeldBeadError::Short { length_mm } => say!(weld_short, length = fixed(*length_mm, 1)),
            WeldBeadError::NoEdges => say!(weld_no_edges),
        }
    }
}

impl Sentence for ParentError {
    fn sentence(&self) -> String {
        match self {
            ParentError::Sizes { .. } | ParentError::NothingCovered => say!(weld_no_depth_there),
            ParentError::FewPoints { count, least } => say!(weld_few_points, count = *count, least = *least),
            ParentError::OneSide { share } => say!(weld_one_side, share = percent(*share, 0)),
            ParentError::NoSurface => say!(weld_no_surface),
        }
    }
}

impl Sentence for UnmeasuredArea {
    fn sentence(&self) -> String {
        let [u, v] = self.centre_px.map(|c| fixed(c, 0));
        say!(weld_unmeasured, u, v, what = self.why.sentence())
    }
}

impl Sentence for HeldReason {
    fn sentence(&self) -> String {
        match self {
            HeldReason::Removal { removed_mm, planned_mm } => {
                say!(weld_held_removal, removed = fixed(*removed_mm, 2), planned = fixed(*planned_mm, 2))
            }
            HeldReason::Place { slack_mm: Some(mm) } => say!(weld_held_slack, slack = fixed(*mm, 1)),
            HeldReason::Place { slack_mm: None } => say!(weld_held_place),
            HeldReason::Below { below_mm } => say!(weld_held_below, below = fixed(*below_mm, 2)),
        }
    }
}

/// What was measured of a weld and what its grinding comes to, a line each.
pub fn weld_lines(weld: &WeldReport) -> Vec<String> {
    let mut out = Vec::new();
    if weld.has_bead() {
        let (height, width) = (fixed(weld.max_height_mm, 2), fixed(weld.width_mm, 1));
        out.push(say!(weld_bead, height, width, length = fixed(weld.length_mm, 0), passes = u64::from(weld.passes)));
        let (rms, noise) = (fixed(weld.parent_rms_mm, 3), fixed(weld.noise_mm, 3));
        out.push(say!(weld_parent, rms, noise));
    } else {
        out.push(say!(weld_no_bead));
    }
    let defects = weld.areas.iter().filter(|a| a.area == AreaKind::Flat);
    out.extend(defects.map(|a| say!(weld_defect, area = fixed(a.area_mm2, 0), aspect = fixed(a.aspect, 2))));
    out.extend(weld.registration.iter().flat_map(how_it_lies));
    if weld.slack_mm > 0.0 {
        out.push(say!(weld_slack, slack = fixed(weld.slack_mm, 2)));
    }
    out.extend(weld.unmeasured.iter().map(Sentence::sentence));
    out.extend(weld.times.iter().map(times_line));
    out.extend(weld.held.iter().map(Sentence::sentence));
    if let Some(r) = &weld.roughness {
        let (before, after) = (fixed(r.before_um, 2), fixed(r.after_um, 2));
        out.push(say!(weld_roughness, points = r.points, before, after, fell = fixed(r.fell_percent, 1)));
    }
    out
}

/// How long each strategy takes for an area at a speed.
fn times_line(t: &AreaTimes) -> String {
    let [one_way, zigzag, spiral] = [t.one_way_s, t.zigzag_s, t.spiral_s].map(|s| fixed(s, 1));
    say!(weld_times, area = area_word(t.area), speed = exact(t.speed_mm_s), one_way, zigzag, spiral)
}

/// The word for what an area is.
pub fn area_word(kind: AreaKind) -> String {
    match kind {
        AreaKind::Bead => say!(weld_area_bead),
        AreaKind::Flat => say!(weld_area_defect),
    }
}
