//! Gallagher’s peaks: functions 21 and 22.

use crate::math;

use super::{
    draws::{Matrix, uniform},
    shape::{growing, share},
};

/// The heights of the lowest and the highest of the peaks that are not the optimum.
const HEIGHTS: [f64; 2] = [1.1, 9.1];
/// The height of the optimum.
const HIGHEST: f64 = 10.0;
/// The optimum is nearer to the middle than the others may be.
const NEARER: f64 = 0.8;
/// How differently wide peaks are at most.
const CONDITION: f64 = 1000.0;

/// Peaks in a position that was turned: the highest is the first.
#[derive(Debug)]
pub(super) struct Peaks {
    heights: Vec<f64>,
    /// Of each peak, one after the other, its position and how much each coordinate counts.
    places: Vec<[f64; 2]>,
}

impl Peaks {
    /// So many, and where the highest is before everything is turned.
    pub fn new(count: usize, seed: i64, n: usize) -> (Self, Vec<f64>) {
        let many = count > 21;
        let (reach, first) = if many { (10.0, CONDITION.sqrt()) } else { (9.8, CONDITION) };
        let order = |seed: i64, count: usize| math::ordered(uniform(seed, count)).into_iter().map(|(_, index)| index);
        let widths = growing(CONDITION, count - 1);
        let widths = order(seed, count - 1).map(|index| widths[index]);
        let conditions = std::iter::once(first).chain(widths);
        let heights = (0..count - 1).map(|i| share(i, count - 1) * (HEIGHTS[1] - HEIGHTS[0]) + HEIGHTS[0]);
        let rotation = Matrix::rotation(seed, n);
        let mut places = Vec::with_capacity(count * n);
        let mut turned = vec![0.0; n];
        let mut highest = Vec::new();
        let drawn = uniform(seed, count * n);
        for (i, (drawn, condition)) in drawn.chunks_exact(n).zip(conditions).enumerate() {
            let nearer = if i == 0 { NEARER } else { 1.0 };
            let position: Vec<f64> = drawn.iter().map(|drawn| nearer * (reach * drawn - reach / 2.0)).collect();
            rotation.apply(&position, &mut turned);
            let factors = growing(condition, n);
            let counts = order(seed + 1000 * i as i64, n).map(|index| factors[index] / condition.sqrt());
            places.extend(turned.iter().zip(counts).map(|(&x, count)| [x, count]));
            if i == 0 {
                highest = position;
            }
        }
        (Self { heights: std::iter::once(HIGHEST).chain(heights).collect(), places }, highest)
    }

    /// How high the highest peak is here.
    pub fn height(&self, z: &[f64]) -> f64 {
        let n = z.len();
        let factor = -0.5 / n as f64;
        let one = |(height, place): (&f64, &[[f64; 2]])| {
            let far: f64 = place.iter().zip(z).map(|([x, count], z)| count * (z - x) * (z - x)).sum();
            height * math::exp(factor * far)
        };
        self.heights.iter().zip(self.places.chunks_exact(n)).map(one).fold(0.0, f64::max)
    }
}
