//! What can go wrong before the first picture. Drawing itself does not fail: what cannot be
//! drawn (an empty window, a texture larger than the driver allows) is clamped instead.

use thiserror::Error;

/// Why there is no 3D view.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ViewError {
    /// There is nothing that draws without a screen.
    #[error("no OpenGL without a screen: {0:?}")]
    NoHeadlessGl(NoEgl),
    /// There is a context, but an older one than the shaders need.
    #[error("OpenGL too old: {version} on {renderer}")]
    TooOld {
        /// What `GL_VERSION` says.
        version: String,
        /// What `GL_RENDERER` says.
        renderer: String,
    },
    /// The driver refuses one of our shaders or objects.
    #[error("{what:?} refused: {reason}")]
    Driver {
        /// The thing that was being made.
        what: DriverObject,
        /// The driver's own words.
        reason: String,
    },
    /// The driver makes a framebuffer that cannot be drawn into.
    #[error("framebuffer status 0x{status:04x} at {size_px:?} px")]
    Framebuffer {
        /// What `glCheckFramebufferStatus` says.
        status: u32,
        /// Its width and height.
        size_px: [u32; 2],
    },
}

/// Why EGL gives no context.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoEgl {
    /// macOS has none.
    NotOnMacOs,
    /// EGL answers with an error.
    Failed {
        /// Its own words.
        answer: String,
    },
    /// EGL knows no device that draws without a screen.
    NoDevice,
    /// No device gives a context.
    Devices(Vec<DeviceAnswer>),
}

/// What a device of EGL answers when it is asked for a context.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DeviceAnswer {
    /// The device, where it has a name.
    pub device: Option<String>,
    /// Its answer, in EGL's own words.
    pub answer: String,
}

/// What a driver is asked to make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DriverObject {
    /// A vertex array.
    VertexArray,
    /// A framebuffer.
    Framebuffer,
    /// The shader that fills the background.
    BackgroundShader,
    /// The shader that draws facets.
    FacetShader,
    /// The shader that draws lines.
    LineShader,
    /// The shader that draws dots.
    DotShader,
    /// The shader that draws clouds.
    CloudShader,
}
