//! OpenGL without a screen, a window or an X server: for `clearbeam render` and for tests.
//!
//! A surfaceless EGL context of OpenGL 3.3 core on Mesa's software device if there is one (the
//! same picture on every machine), else on any device. Drawing goes to framebuffer objects;
//! framebuffer 0 does not exist.

use super::error::{NoEgl, ViewError};
use std::sync::Arc;
use three_d::context as gl;

/// A context that is current on the thread that made it. It stays on that thread (not `Send`);
/// other threads make their own.
///
/// Drop what was made with [`Self::gl`] first. The other order works as well (EGL keeps a context
/// that is current until the thread takes another), but not once a second context is current: it
/// would lose its own objects of the same number.
#[derive(Debug)]
pub struct HeadlessGl {
    gl: Arc<gl::Context>,
    #[cfg(not(target_vendor = "apple"))]
    context: egl::Current,
}

impl HeadlessGl {
    /// Makes a context and makes it current.
    ///
    /// # Errors
    /// Without EGL, or without a device that serves OpenGL 3.3.
    #[cfg(not(target_vendor = "apple"))]
    pub fn new() -> Result<Self, ViewError> {
        let (context, gl) = egl::open()?;
        Ok(Self { gl: Arc::new(gl), context })
    }

    /// macOS has no EGL.
    ///
    /// # Errors
    /// Always.
    #[cfg(target_vendor = "apple")]
    pub fn new() -> Result<Self, ViewError> {
        Err(ViewError::NoHeadlessGl(NoEgl::NotOnMacOs))
    }

    /// For three-d, egui_glow and [`super::Renderer`].
    pub fn gl(&self) -> Arc<gl::Context> {
        Arc::clone(&self.gl)
    }

    /// Makes it current again, after another context was current on this thread.
    ///
    /// # Errors
    /// When the driver has lost the context.
    pub fn make_current(&self) -> Result<(), ViewError> {
        #[cfg(not(target_vendor = "apple"))]
        egl::make_current(&self.context)?;
        Ok(())
    }
}

#[cfg(not(target_vendor = "apple"))]
mod egl {
    //! The conversation with EGL.

    use super::{NoEgl, ViewError, gl};
    use crate::view::error::DeviceAnswer;
    use glutin::api::egl::config::Config;
    use glutin::api::egl::context::PossiblyCurrentContext;
    use glutin::api::egl::device::Device;
    use glutin::api::egl::display::Display;
    use glutin::config::{ConfigSurfaceTypes, ConfigTemplateBuilder};
    use glutin::context::{ContextApi, ContextAttributesBuilder, GlProfile, Version};
    use glutin::display::GlDisplay as _;
    use glutin::error::Error;
    use std::sync::{Mutex, PoisonError};

    pub type Current = PossiblyCurrentContext;

    /// EGL promises that displays may be opened from several threads; not every driver keeps
    /// that promise while it loads. Opening is rare, so it queues. Drawing does not.
    static OPENING: Mutex<()> = Mutex::new(());

    pub fn open() -> Result<(Current, gl::Context), ViewError> {
        let _queue = OPENING.lock().unwrap_or_else(PoisonError::into_inner);
        let mut devices: Vec<Device> = Device::query_devices().map_err(failed)?.collect();
        // Stable: among equals, EGL's own order.
        devices.sort_by_key(|device| !device.extensions().contains("EGL_MESA_device_software"));
        let mut answers = Vec::new();
        for device in &devices {
            match open_on(device) {
                Ok(opened) => return Ok(opened),
                Err(error) => {
                    answers.push(DeviceAnswer { device: device.name().map(str::to_owned), answer: error.to_string() })
                }
            }
        }
        Err(ViewError::NoHeadlessGl(if answers.is_empty() { NoEgl::NoDevice } else { NoEgl::Devices(answers) }))
    }

    fn failed(error: Error) -> ViewError {
        ViewError::NoHeadlessGl(NoEgl::Failed { answer: error.to_string() })
    }

    fn open_on(device: &Device) -> Result<(Current, gl::Context), Error> {
        // SAFETY: no native display is passed, so there is none to outlive.
        let display = unsafe { Display::with_device(device, None) }?;
        let config = any_config(&display)?;
        let attributes = ContextAttributesBuilder::new()
            .with_context_api(ContextApi::OpenGl(Some(Version::new(3, 3))))
            .with_profile(GlProfile::Core)
            .build(None);
        // SAFETY: the attributes name no native window.
        let context = unsafe { display.create_context(&config, &attributes) }?;
        let context = context.make_current_surfaceless()?;
        // SAFETY: the context is current, and EGL's loader answers for its functions.
        let gl = unsafe { gl::Context::from_loader_function_cstr(|name| display.get_proc_address(name).cast()) };
        Ok((context, gl))
    }

    /// Any will do: without a surface, none of its buffers exist.
    fn any_config(display: &Display) -> Result<Config, Error> {
        let template = ConfigTemplateBuilder::new().with_surface_type(ConfigSurfaceTypes::empty()).build();
        // SAFETY: the template names no native window.
        let mut configs = unsafe { display.find_configs(template) }?;
        configs.next().ok_or_else(|| glutin::error::ErrorKind::BadConfig.into())
    }

    pub fn make_current(context: &Current) -> Result<(), ViewError> {
        context.make_current_surfaceless().map_err(failed)
    }
}
