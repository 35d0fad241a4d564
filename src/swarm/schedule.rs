//! How ω, c1 and c2 change over the iterations. Evaluated once per iteration.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::{kernel::State, math};

/// A coefficient as a function of the iteration k, 0 ≤ k < `k_max`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Law {
    /// The same throughout.
    Constant(f64),
    /// From the first value at k = 0 straight to the second at `k_max`.
    Linear(f64, f64),
    /// Half a cosine wave from `max` down to `min`, [WCPSO](crate#papers) (3).
    Cosine {
        /// At k = 0.
        max: f64,
        /// At k = `k_max`.
        min: f64,
    },
    /// `amplitude` · sin(π/2 · s) + `middle`, where s falls from 1 to −1, [WCPSO](crate#papers) (4), or rises for a negative
    /// amplitude, (5).
    Sine {
        /// Half of what it covers.
        amplitude: f64,
        /// The value at half time.
        middle: f64,
    },
}

impl Law {
    /// The value in iteration `k` of `k_max`.
    pub fn at(self, k: u64, k_max: u64) -> f64 {
        let (k, k_max) = (k as f64, k_max as f64);
        match self {
            Self::Constant(value) => value,
            Self::Linear(from, to) => from + (to - from) * (k / k_max),
            Self::Cosine { max, min } => (max - min) / 2.0 * math::cos(PI * k / k_max) + f64::midpoint(max, min),
            Self::Sine { amplitude, middle } => {
                let half = k_max / 2.0;
                amplitude * math::sin(FRAC_PI_2 * (half - k) / half) + middle
            }
        }
    }
}

/// The laws of a swarm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schedule {
    /// Inertia weight ω.
    pub w: Law,
    /// Cognitive coefficient c1.
    pub c1: Law,
    /// Social coefficient c2.
    pub c2: Law,
}

/// The values of an iteration.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub struct Coefficients {
    /// Inertia weight ω.
    pub w: f64,
    /// Cognitive coefficient c1.
    pub c1: f64,
    /// Social coefficient c2.
    pub c2: f64,
}

impl Schedule {
    /// The coefficients of iteration `k` of `k_max`.
    pub fn at(&self, k: u64, k_max: u64) -> Coefficients {
        Coefficients { w: self.w.at(k, k_max), c1: self.c1.at(k, k_max), c2: self.c2.at(k, k_max) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(value: f64, expected: f64) {
        assert!((value - expected).abs() < 1e-15, "{value} is not {expected}");
    }

    #[test]
    fn inertia_falls_along_a_cosine_3() {
        let w = Law::Cosine { max: 0.95, min: 0.4 };
        close(w.at(0, 1000), 0.95);
        close(w.at(250, 1000), 0.675 + 0.275 * std::f64::consts::FRAC_1_SQRT_2);
        close(w.at(500, 1000), 0.675);
        close(w.at(1000, 1000), 0.4);
    }

    #[test]
    fn accelerations_cross_along_sines_4_and_5() {
        let c1 = Law::Sine { amplitude: 1.0, middle: 1.5 };
        let c2 = Law::Sine { amplitude: -1.0, middle: 1.5 };
        for (k, first) in [(0, 2.5), (250, 1.5 + std::f64::consts::FRAC_1_SQRT_2), (500, 1.5), (1000, 0.5)] {
            close(c1.at(k, 1000), first);
            close(c2.at(k, 1000), 3.0 - first);
        }
        // sin(π/2 · 1/3) = 1/2
        close(c1.at(200, 600), 2.0);
    }

    #[test]
    fn linear_laws_meet_their_ends() {
        close(Law::Linear(2.5, 0.5).at(0, 10), 2.5);
        close(Law::Linear(2.5, 0.5).at(4, 10), 1.7);
        close(Law::Linear(2.5, 0.5).at(10, 10), 0.5);
        assert_eq!(Law::Constant(0.7298).at(5, 10), 0.7298);
    }
}
