//! Functions that give the same bits natively, in Node and in every browser.
//!
//! std's transcendental functions call the platform's and differ by an ulp; these come from `libm` or are written out here.

pub use libm::{acos, asin, atan2, cos, exp, log as ln, log10, pow, sin};

use std::f64::consts::PI;

/// Taylor coefficients in x² of cos x − 1; for |x| ≤ π/4 what is left out is under 1e-17.
const COS: [f64; 8] = [
    -1.0 / 2.0,
    1.0 / 24.0,
    -1.0 / 720.0,
    1.0 / 40_320.0,
    -1.0 / 3_628_800.0,
    1.0 / 479_001_600.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 20_922_789_888_000.0,
];
/// Taylor coefficients in x² of sin x / x − 1; what is left out is under 1e-16.
const SIN: [f64; 7] =
    [-1.0 / 6.0, 1.0 / 120.0, -1.0 / 5_040.0, 1.0 / 362_880.0, -1.0 / 39_916_800.0, 1.0 / 6_227_020_800.0, -1.0 / 1_307_674_368_000.0];

/// The whole number nearest to `t`, ties to even, for |t| < 2^51. Adding 1.5 · 2^52 leaves no bits for a fraction;
/// unlike `round`, it needs no instruction that a plain x86-64 lacks.
#[inline]
fn nearest(t: f64) -> f64 {
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    (t + SHIFT) - SHIFT
}

/// `x`, but not below `low` and not above `high`. Unlike `f64::min` and `max` it leaves no choice between 0 and −0,
/// and unlike `f64::clamp` it has nothing to check.
#[inline]
pub fn limit(x: f64, low: f64, high: f64) -> f64 {
    if x < low {
        low
    } else if x > high {
        high
    } else {
        x
    }
}

/// Sorts numbers that carry an index: by number, equals by index. (One instance of the sort for all who need one.)
pub fn sort(pairs: &mut [(f64, usize)]) {
    pairs.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
}

/// cos(2π t) for `t` in turns, |t| < 2^51.
///
/// The reduction to one turn is exact in floating point, so no digits are lost for large `t`, and the
/// body has no branches, so a loop over it can be vectorised.
#[inline]
pub fn cos_turns(t: f64) -> f64 {
    // One turn: r in [0, 1/2]. Near 0 and 1/2 use cos about that end, else sin about the quarter turn: |x| <= pi/4.
    let r = (t - nearest(t)).abs();
    let from_quarter = 0.25 - r;
    let near_end = from_quarter.abs() > 0.125;
    let to_end = 0.25 - from_quarter.abs();
    let x = 2.0 * PI * if near_end { to_end } else { from_quarter };
    let s = x * x;
    let cosine = 1.0 + COS.iter().rev().fold(0.0, |sum, c| (sum + c) * s);
    let sine = x + x * SIN.iter().rev().fold(0.0, |sum, c| (sum + c) * s);
    if near_end { cosine.copysign(from_quarter) } else { sine }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cos_turns_agrees_with_libm_and_is_exact_at_quarters() {
        for (t, expected) in [(0.0, 1.0), (0.25, 0.0), (0.5, -1.0), (0.75, 0.0), (1.0, 1.0), (-3.5, -1.0), (1e9 + 0.25, 0.0)] {
            assert_eq!(cos_turns(t), expected, "t = {t}");
        }
        for i in -4000..=4000 {
            let t = f64::from(i) * 0.000_731;
            let r = t - t.round_ties_even();
            // The reference's own argument is rounded: up to π · 2^-53, and an ulp of the result on either side.
            let difference = (cos_turns(t) - cos(2.0 * PI * r)).abs();
            assert!(difference <= 3.5e-16 + 2.2e-16, "t = {t}: {difference:e}");
        }
    }
}
