//! The values of the functions, where their optimum is at 0 or at 1 and nothing is distorted.

use std::f64::consts::TAU;

use crate::math;

use super::{
    draws::Matrix,
    peaks::Peaks,
    shape::{oscillated, share},
};

/// Twice the distance of each coordinate of Schwefel’s optimum from 0.
pub(super) const SCHWEFEL: f64 = 4.209_687_463_7;
/// Where Schwefel’s function ends, with its own penalty beyond.
const SCHWEFEL_SIDE: f64 = 500.0;
/// What is subtracted so that the minimum is 0.
const SCHWEFEL_MINIMUM: f64 = 418.982_887_272_433_9;
/// µ₀ of Lunacek’s function: the middle of its better half.
pub(super) const LUNACEK: f64 = 2.5;
/// How many terms Weierstrass’ sum has here.
const TERMS: u32 = 12;
/// How many digits Katsuura’s sum looks at.
const DIGITS: u32 = 32;

/// A function of a position that was moved, turned and distorted before.
#[derive(Debug)]
pub(super) enum Core {
    /// The sum of squares with weights: sphere, ellipsoid, discus, bent cigar.
    Squares(Vec<f64>),
    Rastrigin,
    /// Down to a corner of the box, with how steep it is in each coordinate.
    Slope(Vec<f64>, Vec<f64>),
    /// The side of the optimum costs 10⁴ times as much.
    Sector(Vec<f64>),
    /// Plateaus, then a rotation, and the sum of squares with weights.
    Steps(Matrix, Vec<f64>),
    Rosenbrock,
    Ridge,
    Powers,
    /// With the value of the sum at the optimum.
    Weierstrass(f64),
    Schaffers,
    GriewankRosenbrock,
    /// With the factors of Λ^10.
    Schwefel(Vec<f64>),
    Gallagher(Peaks),
    Katsuura,
    /// With R Λ^100 Q.
    Lunacek(Matrix),
}

fn square(x: f64) -> f64 {
    x * x
}

/// The whole number nearest to `x`, halves upwards.
fn rounded(x: f64) -> f64 {
    (x + 0.5).floor()
}

/// The sum over all coordinates, each with its number. Of one copy for all functions: it is downloaded.
#[inline(never)]
fn total(z: &[f64], of: &dyn Fn(usize, f64) -> f64) -> f64 {
    z.iter().enumerate().map(|(i, z)| of(i, *z)).sum()
}

/// The sum over all pairs of neighbours.
#[inline(never)]
fn total_of_pairs(z: &[f64], of: &dyn Fn(f64, f64) -> f64) -> f64 {
    z.windows(2).map(|pair| of(pair[0], pair[1])).sum()
}

/// The sum of squares.
fn squares(z: &[f64]) -> f64 {
    total(z, &|_, z| z * z)
}

/// Σ cos 2πz.
fn cosines(z: &[f64]) -> f64 {
    total(z, &|_, z| math::cos_turns(z))
}

/// Weierstrass’ sum for one coordinate.
#[inline(never)]
fn weierstrass(x: f64) -> f64 {
    let (mut sum, mut rough, mut small) = (0.0, 1.0, 1.0);
    for _ in 0..TERMS {
        sum += math::cos(TAU * (x + 0.5) * rough) * small;
        rough *= 3.0;
        small *= 0.5;
    }
    sum
}

/// Katsuura’s sum for one coordinate: how far it is from having so many binary digits.
#[inline(never)]
fn katsuura(x: f64) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    for _ in 0..DIGITS {
        power *= 2.0;
        sum += (power * x - rounded(power * x)).abs() / power;
    }
    sum
}

impl Core {
    pub fn weierstrass() -> Self {
        Self::Weierstrass(weierstrass(0.0))
    }

    /// The value at `z`, with `room` of the same length.
    pub fn value(&self, z: &mut [f64], room: &mut [f64]) -> f64 {
        let count = z.len();
        let n = count as f64;
        match self {
            Self::Squares(weights) => total(z, &|i, z| weights[i] * z * z),
            Self::Rastrigin => 10.0 * (n - cosines(z)) + squares(z),
            Self::Slope(corner, steepness) => total(z, &|i, x| {
                let slope = steepness[i] * corner[i].signum();
                5.0 * slope.abs() - slope * if x * corner[i] < 25.0 { x } else { corner[i] }
            }),
            Self::Sector(optimum) => {
                let sum = total(z, &|i, z| square(if z * optimum[i] > 0.0 { 100.0 * z } else { z }));
                math::pow(oscillated(sum), 0.9)
            }
            Self::Steps(rotation, weights) => {
                let first = z[0].abs();
                z.iter_mut().for_each(|z| *z = if z.abs() > 0.5 { rounded(*z) } else { rounded(10.0 * *z) / 10.0 });
                rotation.apply(z, room);
                0.1 * f64::max(1e-4 * first, total(room, &|i, z| weights[i] * z * z))
            }
            Self::Rosenbrock => total_of_pairs(z, &|a, b| 100.0 * square(a * a - b) + square(a - 1.0)),
            Self::Ridge => square(z[0]) + 100.0 * squares(&z[1..]).sqrt(),
            Self::Powers => total(z, &|i, z| math::pow(z.abs(), 2.0 + 4.0 * share(i, count))).sqrt(),
            Self::Weierstrass(least) => {
                let difference = total(z, &|_, z| weierstrass(z)) / n - least;
                10.0 * difference * difference * difference
            }
            Self::Schaffers => {
                let sum = total_of_pairs(z, &|a, b| {
                    let length = a * a + b * b;
                    length.sqrt().sqrt() * (1.0 + square(math::sin(50.0 * math::pow(length, 0.1))))
                });
                square(sum / (n - 1.0))
            }
            Self::GriewankRosenbrock => {
                let sum = total_of_pairs(z, &|a, b| {
                    let rosenbrock = 100.0 * square(a * a - b) + square(1.0 - a);
                    rosenbrock / 4000.0 - math::cos(rosenbrock)
                });
                10.0 + 10.0 * sum / (n - 1.0)
            }
            Self::Schwefel(factors) => {
                for (i, room) in room.iter_mut().enumerate() {
                    let before = if i == 0 { SCHWEFEL } else { z[i - 1] };
                    let leaning = z[i] + 0.25 * (before - SCHWEFEL);
                    *room = 100.0 * (factors[i] * (leaning - SCHWEFEL) + SCHWEFEL);
                }
                let penalty = total(room, &|_, z| square(f64::max(z.abs() - SCHWEFEL_SIDE, 0.0)));
                let sum = total(room, &|_, z| z * math::sin(z.abs().sqrt()));
                0.01 * (penalty + SCHWEFEL_MINIMUM - sum / n)
            }
            Self::Gallagher(peaks) => square(oscillated(10.0 - peaks.height(z))),
            Self::Katsuura => {
                let exponent = 10.0 / math::pow(n, 1.2);
                let product = z.iter().enumerate().fold(1.0, |product, (i, z)| product * (1.0 + (i + 1) as f64 * katsuura(*z)));
                10.0 / (n * n) * (math::pow(product, exponent) - 1.0)
            }
            Self::Lunacek(turn) => {
                let s = 1.0 - 0.5 / ((n + 20.0).sqrt() - 4.1);
                let other = -((square(LUNACEK) - 1.0) / s).sqrt();
                let about = |middle: f64| total(z, &|_, x| square(x - middle));
                let bowls = f64::min(about(LUNACEK), n + s * about(other));
                z.iter_mut().for_each(|x| *x -= LUNACEK);
                turn.apply(z, room);
                bowls + 10.0 * (n - cosines(room))
            }
        }
    }
}
