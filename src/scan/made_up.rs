//! Numbers that look random, the same each time: for made-up clouds of tests.

/// A fixed sequence (Knuth's 64-bit linear congruential generator, upper bits).
pub struct Sequence(u64);

impl Sequence {
    /// One sequence for each seed.
    pub fn new(seed: u64) -> Sequence {
        Sequence(seed)
    }

    /// The next number, evenly in 0..1.
    pub fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// The next number, normally distributed but for its far ends: sum of twelve.
    pub fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}
