//! What a saved job remembers of its part's surfaces, so that they are found again when the part's file changes.
//! What that is follows from job and part in `landmarks`.

use crate::part::identity::Landmarks;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::sync::Arc;

/// Landmarks, shared between copies of a job.
///
/// They follow from part and job, and say nothing that an operator decided: jobs are equal whatever is remembered.
#[derive(Clone, Debug, Default)]
pub struct Remembered(Option<Arc<Landmarks>>);

impl PartialEq for Remembered {
    fn eq(&self, _: &Remembered) -> bool {
        true
    }
}

impl Serialize for Remembered {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        self.0.as_deref().serialize(s)
    }
}

impl<'de> Deserialize<'de> for Remembered {
    fn deserialize<D: Deserializer<'de>>(d: D) -> Result<Self, D::Error> {
        Ok(Remembered(Some(Arc::new(Landmarks::deserialize(d)?))))
    }
}

impl Remembered {
    /// Whether nothing is remembered.
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// Keeps landmarks.
    pub(super) fn new(landmarks: Landmarks) -> Remembered {
        Remembered(Some(Arc::new(landmarks)))
    }

    /// The landmarks, if there are any.
    pub(super) fn landmarks(&self) -> Option<&Landmarks> {
        self.0.as_deref()
    }
}
