//! What can go wrong before the first picture. Drawing itself does not fail: what cannot be
//! drawn (an empty window, a texture larger than the driver allows) is clamped instead.

use thiserror::Error;

/// Why there is no 3D view; each message says what to do about it.
#[derive(Debug, Error)]
pub enum ViewError {
    /// EGL is missing, or offers no device that can draw without a screen.
    #[error(
        "no OpenGL without a screen ({reason}): install libegl1 libgl1-mesa-dri (Debian, Ubuntu) \
         or mesa-libEGL mesa-dri-drivers (Fedora)"
    )]
    NoHeadlessGl {
        /// What EGL answered, device by device.
        reason: String,
    },
    /// There is a context, but an older one than the shaders need.
    #[error(
        "no OpenGL 3.3: the driver offers {version} on {renderer}; update the graphics driver, or \
         install libegl1 libgl1-mesa-dri and start with LIBGL_ALWAYS_SOFTWARE=1"
    )]
    TooOld {
        /// What `GL_VERSION` says.
        version: String,
        /// What `GL_RENDERER` says.
        renderer: String,
    },
    /// The driver refuses one of our shaders or objects.
    #[error(
        "the graphics driver refuses {what}: {reason}; update it, or start with \
         LIBGL_ALWAYS_SOFTWARE=1"
    )]
    Driver {
        /// The thing that was being made.
        what: &'static str,
        /// The driver's own words.
        reason: String,
    },
}
