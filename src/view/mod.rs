//! Draws 3D: a scene of plain data, seen by a camera, becomes pixels.
//!
//! - [`scene`] says *what* is shown (meshes, lines, dots, a [`cloud`] of points) without knowing OpenGL;
//! - [`camera`] and its [`lens`] say *from where*, [`bounds`] how large the shown things are,
//!   [`flight`] how one view glides into the next;
//! - [`renderer`] draws one into the other with three-d on a glow context that somebody else
//!   owns: eframe's window, or [`headless`] when there is no screen;
//! - [`widget`] puts all of that into egui: the mouse, the triad and the view cube ([`overlay`]).
//!
//! It stops at pictures and gestures: it knows neither parts nor paths nor jobs, and picking
//! is left to whoever owns the geometry ([`camera::Camera::ray_through`] gives the ray).
//! Lengths are millimetres, z is up, pixels are physical and count from the top-left corner.

pub mod bounds;
pub mod camera;
pub mod cloud;
pub mod error;
pub mod flight;
pub mod headless;
pub mod lens;
pub mod overlay;
pub mod renderer;
pub mod scene;
pub mod standard_view;
pub mod viewport_response;
pub mod widget;

mod cloud_pick;
mod coarse;
mod detail;
mod dragging;
mod gl_state;
mod gpu_cache;
mod gpu_cloud;
mod gpu_mesh;
mod gpu_strokes;
mod motion;
mod navigation;
mod projecting;
mod target;
mod thinning;
mod to_three_d;

pub use bounds::Bounds;
pub use camera::Camera;
pub use cloud::{CloudItem, Places};
pub use cloud_pick::{CloudPick, cloud_point_at};
pub use detail::Detail;
pub use error::{DeviceAnswer, DriverObject, NoEgl, ViewError};
pub use flight::Flight;
pub use headless::HeadlessGl;
pub use lens::{Projection, ViewSize};
pub use navigation::Navigation;
pub use overlay::{AXIS_COLORS, CubeLabels};
pub use renderer::Renderer;
pub use scene::{Depth, LineItem, LineSegment, MeshCut, MeshEdges, MeshItem, PointItem, Scene};
pub use standard_view::StandardView;
pub use viewport_response::ViewportResponse;
pub use widget::Viewport;
