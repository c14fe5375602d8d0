//! Frames from what was measured: how well they fit, and why there is none.

use super::{Sentence, exact, fixed, listed, say};
use crate::cell::calibration::{CalibrationNote, CalibrationSide, FitError};
use crate::cell::frame::{FrameError, FrameFault};

impl Sentence for CalibrationNote {
    fn sentence(&self) -> String {
        let (frame, method) = (self.frame, self.method);
        let (rms, worst) = (fixed(self.rms_mm, 3), fixed(self.worst_mm, 3));
        if self.residuals_mm.is_empty() {
            return say!(calibration, frame, method, rms, worst);
        }
        let each = listed(self.residuals_mm.iter().map(|r| fixed(*r, 3)));
        say!(calibration_each, frame, method, rms, worst, each)
    }
}

impl Sentence for FrameError {
    fn sentence(&self) -> String {
        say!(frame_wrong, frame = self.frame, what = self.fault.sentence())
    }
}

impl Sentence for FrameFault {
    fn sentence(&self) -> String {
        match self {
            FrameFault::Keys => say!(frame_keys),
            FrameFault::Range { key, value, most } => {
                say!(frame_range, key = *key, value = exact(*value), most = exact(*most))
            }
            FrameFault::Fit(e) => e.sentence(),
        }
    }
}

impl Sentence for FitError {
    fn sentence(&self) -> String {
        match *self {
            FitError::Figure { value } => say!(fit_figure, value = exact(value)),
            FitError::XNearOrigin { off_mm } => say!(fit_x_near_origin, off = fixed(off_mm, 1)),
            FitError::XyNearAxis { off_mm } => say!(fit_xy_near_axis, off = fixed(off_mm, 1)),
            FitError::FewPoses { count } => say!(fit_few_poses, count),
            FitError::OneDirection { direction: [x, y, z] } => {
                say!(fit_one_direction, x = fixed(x, 2), y = fixed(y, 2), z = fixed(z, 2))
            }
            FitError::NoTip => say!(fit_no_tip),
            FitError::FewPairs { count } => say!(fit_few_pairs, count),
            FitError::OneLine { side: CalibrationSide::Model, width_mm } => {
                say!(fit_model_on_line, width = fixed(width_mm, 1))
            }
            FitError::OneLine { side: CalibrationSide::Measured, width_mm } => {
                say!(fit_measured_on_line, width = fixed(width_mm, 1))
            }
            FitError::NoFrame => say!(fit_no_frame),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fit_is_told_with_each_residual() {
        let note = CalibrationNote::new("base_from_part", "points", vec![0.3, 0.4]);
        assert_eq!(note.sentence(), "base_from_part from points: 0.354 mm rms, 0.400 mm at worst (0.300, 0.400)");
        let exact = CalibrationNote::new("base_from_part", "three_points", Vec::new());
        assert_eq!(exact.sentence(), "base_from_part from three_points: 0.000 mm rms, 0.000 mm at worst");
        assert!(FitError::FewPoses { count: 1 }.sentence().starts_with("tip_poses has 1 pose: "));
    }
}
