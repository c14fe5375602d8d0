//! stub
use super::*;
use crate::document::model::JobWeld;
#[derive(Clone, Debug, Default)]
pub struct WeldProgress {
    pub passes_left: u32,
    pub held: Option<HeldReason>,
    pub levels: Vec<f64>,
}
impl WeldProgress {
    pub fn new(_m: &MeasuredWeld, _w: &JobWeld) -> WeldProgress {
        WeldProgress::default()
    }
    pub fn levels_mm(&self, n: u32) -> Vec<f64> {
        self.levels.iter().copied().take(n as usize).collect()
    }
}
