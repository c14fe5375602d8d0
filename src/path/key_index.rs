//! Numbers vertices or edges in the order in which they come, and finds the number of each again at once: a hash table
//! with open addressing, whose keys stand in the list of numbers alone.

/// Keys with their numbers.
#[derive(Clone, Debug, Default)]
pub(super) struct KeyIndex {
    /// Numbers by hash; a power of two of them, or none.
    slots: Vec<u32>,
    keys: Vec<u32>,
}

/// A slot without a key.
const EMPTY: u32 = u32::MAX;

impl KeyIndex {
    /// An index with room for so many keys; more of them make it grow.
    pub(super) fn for_keys(count: usize) -> KeyIndex {
        KeyIndex { slots: vec![EMPTY; (2 * count).next_power_of_two().max(8)], keys: Vec::with_capacity(count) }
    }

    /// How many keys there are.
    pub(super) fn len(&self) -> usize {
        self.keys.len()
    }

    /// The keys in the order of their numbers.
    pub(super) fn keys(&self) -> &[u32] {
        &self.keys
    }

    /// The number of a key; a new one gets the next.
    pub(super) fn number(&mut self, key: u32) -> usize {
        if 4 * self.keys.len() >= 3 * self.slots.len() {
            self.grow();
        }
        let slot = self.slot_of(key);
        if self.slots[slot] == EMPTY {
            self.slots[slot] = self.keys.len() as u32;
            self.keys.push(key);
        }
        self.slots[slot] as usize
    }

    /// The number of a key that there is.
    pub(super) fn get(&self, key: u32) -> Option<usize> {
        let number = *self.slots.get(if self.slots.is_empty() { 0 } else { self.slot_of(key) })?;
        (number != EMPTY).then_some(number as usize)
    }

    /// Where a key stands, or would.
    fn slot_of(&self, key: u32) -> usize {
        let mask = self.slots.len() - 1;
        // Fibonacci hashing: neighbours, as numbers of vertices are, land far apart.
        let mut slot = (u64::from(key).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32) as usize & mask;
        while self.slots[slot] != EMPTY && self.keys[self.slots[slot] as usize] != key {
            slot = (slot + 1) & mask;
        }
        slot
    }

    fn grow(&mut self) {
        self.slots = vec![EMPTY; (2 * self.slots.len()).max(8)];
        for number in 0..self.keys.len() {
            let slot = self.slot_of(self.keys[number]);
            self.slots[slot] = number as u32;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    proptest! {
        #[test]
        fn keys_are_numbered_as_they_come(keys in prop::collection::vec(0u32..200, 0..300), room in 0usize..50) {
            let mut index = KeyIndex::for_keys(room);
            let mut expected: BTreeMap<u32, usize> = BTreeMap::new();
            for key in keys {
                let next = expected.len();
                prop_assert_eq!(index.number(key), *expected.entry(key).or_insert(next));
            }
            prop_assert_eq!(index.len(), expected.len());
            for key in 0..220 {
                prop_assert_eq!(index.get(key), expected.get(&key).copied());
            }
        }
    }

    #[test]
    fn an_index_that_was_never_filled_holds_nothing() {
        assert_eq!(KeyIndex::default().get(7), None);
        assert_eq!(KeyIndex::default().number(7), 0);
    }
}
