//! Why there is no 3D view.

use super::Sentence;
use crate::view::ViewError;

impl Sentence for ViewError {
    fn sentence(&self) -> String {
        self.to_string()
    }
}
