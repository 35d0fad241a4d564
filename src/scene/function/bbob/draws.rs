//! What an instance is drawn from. The generator is that of the suite’s first version, which later ones keep.

use std::f64::consts::TAU;

use crate::math;

use super::precise;

/// The modulus of the generator, 2³¹ − 1, and its multiplier with Schrage’s factors.
const MODULUS: i64 = 2_147_483_647;
const MULTIPLIER: i64 = 16_807;
const QUOTIENT: i64 = 127_773;
const REMAINDER: i64 = 2_836;
/// Numbers are drawn through a table, as Bays and Durham do.
const TABLE: usize = 32;
/// So many numbers are drawn before the table is full.
const WARM_UP: usize = 40;
/// Which place of the table a number stands for.
const SHARE: i64 = 67_108_865;
/// In place of 0, of which there is no logarithm.
const LEAST: f64 = 1e-99;

/// Numbers between 0 and 1.
#[inline(never)]
pub(super) fn uniform(seed: i64, count: usize) -> Vec<f64> {
    let mut state = seed.abs().max(1);
    let mut next = move || {
        let quotient = state / QUOTIENT;
        state = MULTIPLIER * (state - quotient * QUOTIENT) - REMAINDER * quotient;
        if state < 0 {
            state += MODULUS;
        }
        state
    };
    let mut table = [0; TABLE];
    for at in (0..WARM_UP).rev() {
        let drawn = next();
        if let Some(place) = table.get_mut(at) {
            *place = drawn;
        }
    }
    let mut last = table[0];
    let mut one = || {
        let place = &mut table[(last / SHARE) as usize];
        last = std::mem::replace(place, next());
        last as f64 / MODULUS as f64
    };
    (0..count).map(|_| Some(one()).filter(|drawn| *drawn != 0.0).unwrap_or(LEAST)).collect()
}

/// Normally distributed numbers, by Box and Muller.
#[inline(never)]
pub(super) fn normal(seed: i64, count: usize) -> Vec<f64> {
    let drawn = uniform(seed, 2 * count);
    let (radii, angles) = drawn.split_at(count);
    let one = |(radius, angle): (&f64, &f64)| (-2.0 * precise::ln(*radius)).sqrt() * precise::cos(TAU * angle);
    radii.iter().zip(angles).map(one).map(|drawn| if drawn == 0.0 { LEAST } else { drawn }).collect()
}

/// The position of an optimum: from −4 to 4, with four digits, never 0.
pub(super) fn position(seed: i64, n: usize) -> Vec<f64> {
    let rounded = |drawn: f64| 8.0 * (1e4 * drawn).floor() / 1e4 - 4.0;
    uniform(seed, n).into_iter().map(rounded).map(|x| if x == 0.0 { -1e-5 } else { x }).collect()
}

/// The value of an optimum: Cauchy distributed, with two digits, from −1000 to 1000.
pub(super) fn value(seed: i64) -> f64 {
    let [a, b] = [seed, seed + 1].map(|seed| normal(seed, 1)[0]);
    let rounded = (1e4 * a / b + 0.5).floor() / 100.0;
    math::clamp(rounded, -1000.0, 1000.0)
}

/// A square matrix, row by row.
#[derive(Debug)]
pub(super) struct Matrix {
    n: usize,
    rows: Vec<f64>,
}

impl Matrix {
    /// A rotation: normally distributed numbers, whose columns are made orthonormal one after the other.
    #[inline(never)]
    pub fn rotation(seed: i64, n: usize) -> Self {
        let mut drawn = normal(seed, n * n);
        let mut columns: Vec<&[f64]> = Vec::with_capacity(n);
        for column in drawn.chunks_exact_mut(n) {
            for before in &columns {
                let along = dot(column, before);
                column.iter_mut().zip(*before).for_each(|(x, before)| *x -= along * before);
            }
            let norm = dot(column, column).sqrt();
            column.iter_mut().for_each(|x| *x /= norm);
            columns.push(column);
        }
        Self { n, rows: (0..n * n).map(|k| columns[k % n][k / n]).collect() }
    }

    /// Each row times a factor.
    #[inline(never)]
    pub fn stretched(mut self, factors: &[f64]) -> Self {
        for (row, factor) in self.rows.chunks_exact_mut(self.n).zip(factors) {
            row.iter_mut().for_each(|x| *x *= factor);
        }
        self
    }

    /// The product `self` · `other`.
    #[inline(never)]
    pub fn times(&self, other: &Self) -> Self {
        let n = self.n;
        let entry = |k: usize| (0..n).map(|m| self.rows[k / n * n + m] * other.rows[m * n + k % n]).sum();
        Self { n, rows: (0..n * n).map(entry).collect() }
    }

    /// The sum of each column.
    #[inline(never)]
    pub fn columns(&self) -> Vec<f64> {
        (0..self.n).map(|j| self.rows.iter().skip(j).step_by(self.n).sum()).collect()
    }

    /// The product with a vector.
    #[inline(never)]
    pub fn apply(&self, x: &[f64], out: &mut [f64]) {
        out.iter_mut().zip(self.rows.chunks_exact(self.n)).for_each(|(out, row)| *out = dot(row, x));
    }
}

#[inline(never)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
