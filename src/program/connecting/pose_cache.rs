//! Poses of the arm, and a cache of what was worked out from them: when targets are refused or others are chosen, most
//! results stay valid. A pose is told by its joints, to the last bit.

use crate::cell::Joints;
use crate::program::neutral::steps::Station;
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Where the arm stands: the focus in the part, and the joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmStand {
    /// Focus, beam and spin in the part.
    pub at: Station,
    /// Degrees.
    pub joints_deg: Joints,
}

/// Joints as a key.
pub type JointBits = [u64; 6];

/// The key of joints.
pub fn bits(joints_deg: &Joints) -> JointBits {
    joints_deg.map(f64::to_bits)
}

/// Values that were worked out, by what they follow from.
pub struct PoseCache<K, V>(Mutex<BTreeMap<K, V>>);

impl<K, V> Default for PoseCache<K, V> {
    fn default() -> Self {
        PoseCache(Mutex::default())
    }
}

impl<K: Ord, V: Clone> PoseCache<K, V> {
    /// The value that was worked out before, or is now.
    pub fn get(&self, key: K, make: impl FnOnce() -> V) -> V {
        if let Some(value) = self.0.lock().ok().and_then(|all| all.get(&key).cloned()) {
            return value;
        }
        let value = make();
        if let Ok(mut all) = self.0.lock() {
            all.insert(key, value.clone());
        }
        value
    }
}
