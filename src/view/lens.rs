//! How a camera projects: the size of its picture, and whether distance makes things smaller.

/// Size of the view in physical pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewSize {
    /// Width.
    pub width_px: f64,
    /// Height.
    pub height_px: f64,
}

/// How depth looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Projection {
    /// What is farther is smaller.
    #[default]
    Perspective,
    /// Parallel edges stay parallel, for judging lines and gaps.
    Parallel,
}

impl ViewSize {
    /// At least one pixel each way, so that nothing divides by zero.
    pub fn new(width_px: f64, height_px: f64) -> Self {
        Self { width_px: width_px.max(1.0), height_px: height_px.max(1.0) }
    }

    /// Width over height.
    pub fn aspect(&self) -> f64 {
        self.width_px / self.height_px
    }
}
