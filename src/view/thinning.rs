//! The order in which the points of a cloud lie on the graphics card: such that the first of them stand evenly for all.
//!
//! Neighbours in a scan's file are neighbours on the part. So the points are taken in passes: each takes one point out of
//! every block of so many that follow each other, and the next one a point far from it in the same block. Which one is
//! scrambled from block to block, or the rows of a scan would show as stripes.

/// Points of one pass, about: what a thinned cloud is rounded to. Fewer make blocks longer, and points that are far
/// apart in memory are slow to gather.
const PASS: u32 = 1 << 15;

/// A fixed order of so many points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Order {
    count: u32,
    /// Points that follow each other in the file and of which each pass takes one; a power of 2, and the number of
    /// passes.
    block: u32,
}

impl Order {
    pub fn of(count: u32) -> Self {
        Self { count, block: (count / PASS).max(1).next_power_of_two() }
    }

    /// Each index once, pass after pass.
    pub fn indices(self) -> impl Iterator<Item = u32> {
        let blocks = self.count.div_ceil(self.block);
        let of_pass = move |pass| (0..blocks).map(move |block| block * self.block + self.within(pass, block));
        (0..self.block).flat_map(of_pass).filter(move |index| *index < self.count)
    }

    /// How many points whole passes have, as many of them as fit into a number; one at least.
    pub fn prefix(self, at_most: u32) -> u32 {
        let (full, rest) = (self.count / self.block, self.count % self.block);
        let of_pass = |pass| full + u32::from(self.within(pass, full) < rest);
        let mut taken = of_pass(0);
        for pass in 1..self.block {
            match taken + of_pass(pass) {
                more if more > at_most => break,
                more => taken = more,
            }
        }
        taken
    }

    /// Which point of a block a pass takes.
    fn within(self, pass: u32, block: u32) -> u32 {
        // Bits from behind: the second pass is half a block away from the first, the third a quarter.
        let spread = pass.reverse_bits().checked_shr(32 - self.block.trailing_zeros()).unwrap_or(0);
        spread ^ (scrambled(block) & (self.block - 1))
    }
}

/// The finalizer of MurmurHash3 (Appleby, public domain): every bit of the number moves every bit of this.
fn scrambled(mut bits: u32) -> u32 {
    bits ^= bits >> 16;
    bits = bits.wrapping_mul(0x85eb_ca6b);
    bits ^= bits >> 13;
    bits = bits.wrapping_mul(0xc2b2_ae35);
    bits ^ bits >> 16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_comes_once() {
        for count in [0, 1, 2, PASS - 1, PASS, 3 * PASS + 17, 300_001] {
            let mut seen = vec![false; count as usize];
            for index in Order::of(count).indices() {
                assert!(!std::mem::replace(&mut seen[index as usize], true), "{index} of {count} twice");
            }
            assert!(seen.into_iter().all(|seen| seen), "all of {count}");
        }
    }

    #[test]
    fn whole_passes_are_an_even_thinning() {
        let count = 1_000_003;
        let order = Order::of(count);
        for at_most in [0, 40_000, 100_000, 333_333, count, u32::MAX] {
            let prefix = order.prefix(at_most);
            assert!(prefix <= at_most.max(2 * PASS) && prefix > at_most.min(count) - at_most.min(count).min(2 * PASS));
            // So many points in each hundredth of the file as in any other, but for one a pass.
            let mut hundredths = [0_u32; 100];
            for index in order.indices().take(prefix as usize) {
                hundredths[(u64::from(index) * 100 / u64::from(count)) as usize] += 1;
            }
            for taken in hundredths {
                assert!(taken.abs_diff(prefix / 100) <= order.block, "{taken} of {prefix}");
            }
        }
    }

    #[test]
    fn rows_of_a_scan_are_not_taken_whole() {
        // Columns of a grid whose rows are as long as a block, in the first pass: about as many of each.
        let order = Order::of(1 << 20);
        let mut columns = vec![0_u32; order.block as usize];
        for index in order.indices().take(order.prefix(0) as usize) {
            columns[(index % order.block) as usize] += 1;
        }
        let mean = (order.prefix(0) / order.block) as f64;
        // Five standard deviations of a binomial count.
        assert!(columns.iter().all(|taken| (f64::from(*taken) - mean).abs() < 5.0 * mean.sqrt()), "{columns:?}");
    }
}
