//! Corners with equal coordinates become one vertex.

use crate::part::raw_part::RawFacet;
use crate::progress::{Cancelled, Progress};

/// Unique points, and those of each facet's corners.
type WeldedCorners = (Vec<[f32; 3]>, Vec<[u32; 3]>);

/// Unique corners by equal coordinates, numbered in order of first appearance.
///
/// # Errors
/// [`Cancelled`] when `progress` says so.
pub(super) fn weld_corners(raw: &[RawFacet], progress: &Progress) -> Result<WeldedCorners, Cancelled> {
    let mut welder = Welder {
        slots: vec![EMPTY; (raw.len() * 2).next_power_of_two().max(16)],
        points: Vec::with_capacity(raw.len() / 2 + 3),
    };
    let index = |(number, corners): (usize, &RawFacet)| {
        progress.check_at(number)?;
        Ok(corners.map(|c| welder.index_of(c)))
    };
    let facets = raw.iter().enumerate().map(index).collect::<Result<_, Cancelled>>()?;
    Ok((welder.points, facets))
}

/// A hash table with open addressing: twice as fast here as the standard map, whose keys would be
/// stored a second time.
struct Welder {
    slots: Vec<u32>,
    points: Vec<[f32; 3]>,
}

/// A slot without a point.
const EMPTY: u32 = u32::MAX;

impl Welder {
    fn index_of(&mut self, corner: [f32; 3]) -> u32 {
        let corner = corner.map(|x| x + 0.0); // −0 + 0 = 0
        let mut slot = hash(corner, self.slots.len());
        loop {
            match self.slots[slot] {
                EMPTY => break,
                v if self.points[v as usize] == corner => return v,
                _ => slot = (slot + 1) & (self.slots.len() - 1),
            }
        }
        let new = self.points.len() as u32;
        self.slots[slot] = new;
        self.points.push(corner);
        // Triangle soup has three points a facet, six times those of a closed surface.
        if self.points.len() * 4 > self.slots.len() * 3 {
            self.grow();
        }
        new
    }

    fn grow(&mut self) {
        let size = self.slots.len() * 2;
        self.slots = vec![EMPTY; size];
        for (i, p) in self.points.iter().enumerate() {
            let mut slot = hash(*p, size);
            while self.slots[slot] != EMPTY {
                slot = (slot + 1) & (size - 1);
            }
            self.slots[slot] = i as u32;
        }
    }
}

/// Slot of a corner in a table whose size is a power of two.
fn hash(corner: [f32; 3], size: usize) -> usize {
    let mut h = 0u64;
    for x in corner {
        h = (h.rotate_left(5) ^ u64::from(x.to_bits())).wrapping_mul(0x517c_c1b7_2722_0a95);
    }
    (h ^ (h >> 32)) as usize & (size - 1)
}
