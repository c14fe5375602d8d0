//! Why there is no 3D view, and the words of the view itself.

use super::{Arg, Sentence, listed_clauses, say};
use crate::view::{CubeLabels, DeviceAnswer, DriverObject, NoEgl, ViewError, Viewport};

/// Gives a view its accessible name, and its cube the words of its faces.
pub(crate) fn name_view(viewport: &mut Viewport) {
    viewport.name = say!(view_name);
    viewport.labels = CubeLabels {
        name: say!(view_cube),
        faces: [
            say!(view_front),
            say!(view_back),
            say!(view_left),
            say!(view_right),
            say!(view_top),
            say!(view_bottom),
        ],
    };
}

impl Sentence for ViewError {
    fn sentence(&self) -> String {
        match self {
            ViewError::NoHeadlessGl(why) => say!(view_no_headless_gl, reason = why.sentence()),
            ViewError::TooOld { version, renderer } => say!(view_too_old, version, renderer),
            ViewError::Driver { what, reason } => say!(view_driver_refuses, what = object(*what), reason),
            ViewError::Framebuffer { status, size_px: [width, height] } => say!(
                view_framebuffer_refused,
                status = format!("0x{status:04x}"),
                width = super::id(width),
                height = super::id(height)
            ),
        }
    }
}

impl Sentence for NoEgl {
    fn sentence(&self) -> String {
        match self {
            NoEgl::NotOnMacOs => say!(view_egl_not_on_macos),
            NoEgl::Failed { answer } => say!(view_egl_failed, answer),
            NoEgl::NoDevice => say!(view_egl_no_device),
            NoEgl::Devices(answers) => listed_clauses(answers.iter().map(Sentence::sentence)),
        }
    }
}

impl Sentence for DeviceAnswer {
    fn sentence(&self) -> String {
        let device = self.device.as_ref().map_or_else(|| say!(view_unnamed_device).into(), Arg::from);
        say!(view_device_answers, device, answer = &self.answer)
    }
}

fn object(what: DriverObject) -> String {
    match what {
        DriverObject::VertexArray => say!(view_vertex_array),
        DriverObject::Framebuffer => say!(view_framebuffer),
        DriverObject::BackgroundShader => say!(view_background_shader),
        DriverObject::FacetShader => say!(view_facet_shader),
        DriverObject::LineShader => say!(view_line_shader),
        DriverObject::DotShader => say!(view_dot_shader),
        DriverObject::CloudShader => say!(view_cloud_shader),
    }
}
