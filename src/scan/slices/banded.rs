//! Least squares whose unknowns meet only their neighbours, on a line or on a circle: a band of normal equations, solved
//! by Cholesky's way. On a circle the last unknowns meet the first; they stand in a border beside the band.

use nalgebra::{Matrix3, SVector};

/// Unknowns that meet: each one and the three behind it.
pub(super) const REACH: usize = 3;
/// Columns of the right-hand side: a place in the plane and a normal.
pub(super) type Columns = SVector<f64, 5>;
/// What is added to the diagonal, as a share of its greatest entry, so that a root is always there.
const RIDGE: f64 = 1e-12;

/// Normal equations.
#[derive(Clone, Debug)]
pub(super) struct Banded {
    /// Row i: entries (i, i), (i, i − 1) and so on.
    band: Vec<[f64; REACH + 1]>,
    /// Entries of the band's rows with the last three unknowns of a circle.
    border: Vec<[f64; REACH]>,
    corner: Matrix3<f64>,
    right: Vec<Columns>,
    is_round: bool,
}

impl Banded {
    /// Of so many unknowns; on a circle more than six.
    pub(super) fn new(count: usize, is_round: bool) -> Banded {
        let inner = if is_round { count.saturating_sub(REACH) } else { count };
        Banded {
            band: vec![[0.0; REACH + 1]; inner],
            border: vec![[0.0; REACH]; if is_round { inner } else { 0 }],
            corner: Matrix3::zeros(),
            right: vec![Columns::zeros(); count],
            is_round,
        }
    }

    /// Adds an observation: some neighbouring unknowns with their factors make the values.
    pub(super) fn add(&mut self, unknowns: [usize; 4], factors: [f64; 4], values: &Columns, weight: f64) {
        let inner = self.band.len();
        for (&i, &fi) in unknowns.iter().zip(&factors) {
            self.right[i] += values * (fi * weight);
            for (&j, &fj) in unknowns.iter().zip(&factors).filter(|(j, _)| **j <= i) {
                let product = fi * fj * weight;
                match (i < inner, j < inner) {
                    (true, _) => self.band[i][i - j] += product,
                    (false, true) => self.border[j][i - inner] += product,
                    (false, false) => {
                        self.corner[(i - inner, j - inner)] += product;
                        self.corner[(j - inner, i - inner)] = self.corner[(i - inner, j - inner)];
                    }
                }
            }
        }
    }

    /// The unknowns, one for each column.
    pub(super) fn solved(mut self) -> Vec<Columns> {
        let inner = self.band.len();
        let greatest = self.band.iter().map(|r| r[0]).fold(f64::MIN_POSITIVE, f64::max);
        let ridge = RIDGE * greatest;
        for i in 0..inner {
            let from = i.saturating_sub(REACH);
            for j in from..=i {
                let known: f64 =
                    (from.max(j.saturating_sub(REACH))..j).map(|m| self.band[i][i - m] * self.band[j][j - m]).sum();
                let rest = self.band[i][i - j] - known;
                self.band[i][i - j] = if i == j { (rest + ridge).max(ridge).sqrt() } else { rest / self.band[j][0] };
            }
        }
        let mut x = std::mem::take(&mut self.right);
        let last = x.split_off(inner);
        self.backed(&mut x);
        if !self.is_round {
            return x;
        }
        // Three columns of the border at once.
        let mut y: Vec<Columns> = self.border.iter().map(|b| Columns::new(b[0], b[1], b[2], 0.0, 0.0)).collect();
        self.backed(&mut y);
        let mut corner = self.corner + Matrix3::from_diagonal_element(ridge);
        let mut rest = [last[0], last[1], last[2]];
        for (i, border) in self.border.iter().enumerate() {
            for (r, &b) in border.iter().enumerate().filter(|(_, b)| **b != 0.0) {
                rest[r] -= x[i] * b;
                for c in 0..REACH {
                    corner[(r, c)] -= b * y[i][c];
                }
            }
        }
        let inverse = corner.try_inverse().unwrap_or_else(Matrix3::zeros);
        let ends = [0, 1, 2].map(|r| (0..REACH).fold(Columns::zeros(), |s, c| s + rest[c] * inverse[(r, c)]));
        for (x, y) in x.iter_mut().zip(&y) {
            *x -= ends[0] * y[0] + ends[1] * y[1] + ends[2] * y[2];
        }
        x.extend(ends);
        x
    }

    /// Solves with the root in place of the band.
    fn backed(&self, x: &mut [Columns]) {
        for i in 0..x.len() {
            for m in i.saturating_sub(REACH)..i {
                let before = x[m];
                x[i] -= before * self.band[i][i - m];
            }
            x[i] /= self.band[i][0];
        }
        for i in (0..x.len()).rev() {
            for m in i + 1..(i + 1 + REACH).min(x.len()) {
                let behind = x[m];
                x[i] -= behind * self.band[m][m - i];
            }
            x[i] /= self.band[i][0];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;
    use proptest::prelude::*;

    proptest! {
        /// As a full matrix tells it, on a line and on a circle.
        #[test]
        fn the_band_says_what_the_full_matrix_says(count in 8..20usize, is_round in any::<bool>(),
                                                   numbers in prop::collection::vec(prop::array::uniform5(-1.0..1.0f64), 60..90)) {
            let mut banded = Banded::new(count, is_round);
            let (mut full, mut right) = (DMatrix::<f64>::zeros(count, count), DMatrix::<f64>::zeros(count, 5));
            for (k, n) in numbers.iter().enumerate() {
                let first = if is_round { k % count } else { k % (count - 3) };
                let unknowns = [0, 1, 2, 3].map(|j| (first + j) % count);
                let factors = [n[0], n[1] + 2.0, n[2], n[3]];
                let values = Columns::from(*n);
                banded.add(unknowns, factors, &values, 1.0 + n[4]);
                for (i, fi) in unknowns.iter().zip(factors) {
                    for (j, fj) in unknowns.iter().zip(factors) {
                        full[(*i, *j)] += fi * fj * (1.0 + n[4]);
                    }
                    for c in 0..5 {
                        right[(*i, c)] += values[c] * fi * (1.0 + n[4]);
                    }
                }
            }
            let found = banded.solved();
            // What the unknowns give back: they themselves may be told badly.
            for i in 0..count {
                for c in 0..5 {
                    let back: f64 = (0..count).map(|j| full[(i, j)] * found[j][c]).sum();
                    prop_assert!((back - right[(i, c)]).abs() < 1e-6, "{} {}", back, right[(i, c)]);
                }
            }
        }
    }
}
