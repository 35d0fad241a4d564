//! Functions that give the same bits natively, in Node and in every browser.
//!
//! std's transcendental functions call the platform's and differ by an ulp; these come from `libm` or are written out here.

pub use libm::{acos, asin, atan2, cos, exp, log as ln, log10, pow, sin, tgamma as gamma};

use std::{
    cmp::Ordering,
    f64::consts::{PI, TAU},
};

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

/// An angle from 0 to 2π, of one that is less than two turns away from 0. Its bits are those of `rem_euclid`, which takes a division of
/// 128 bits.
pub fn turn(mut angle: f64) -> f64 {
    for _ in 0..2 {
        if angle >= TAU {
            angle -= TAU;
        } else if angle < 0.0 {
            angle += TAU;
        }
    }
    angle
}

/// `x`, but not below `low` and not above `high`. Unlike `f64::min` and `max` it leaves no choice between 0 and −0,
/// and unlike `f64::clamp` it has nothing to check.
#[inline]
pub fn clamp(x: f64, low: f64, high: f64) -> f64 {
    if x < low {
        low
    } else if x > high {
        high
    } else {
        x
    }
}

/// A length that can be ordered; lengths here are never NaN.
#[derive(PartialEq)]
pub(crate) struct Length(pub f64);

impl Eq for Length {}

impl PartialOrd for Length {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Length {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// Sorts numbers with an index: by number, equal ones by index.
#[inline(never)]
pub fn sort(pairs: &mut [(f64, usize)]) {
    sort_by(pairs, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).is_gt());
}

/// The numbers in order, each with its index among those given; equal ones by index.
pub fn ordered(numbers: impl IntoIterator<Item = f64>) -> Vec<(f64, usize)> {
    let mut pairs: Vec<_> = numbers.into_iter().zip(0..).collect();
    sort(&mut pairs);
    pairs
}

/// Sorts numbers.
pub fn sort_numbers(numbers: &mut [f64]) {
    sort_by(numbers, |a, b| a.total_cmp(&b).is_gt());
}

/// Sorts indices.
pub fn sort_indices<T: Copy + Ord>(indices: &mut [T]) {
    sort_by(indices, |a, b| a > b);
}

/// Sorts by Shell's method: a fifteenth of the code of std's sort, which would be another instance of it in the download.
fn sort_by<T: Copy>(items: &mut [T], behind: impl Fn(T, T) -> bool) {
    let mut gap = items.len();
    while gap > 1 {
        gap = if gap < 5 { 1 } else { (gap * 5 - 1) / 11 };
        for i in gap..items.len() {
            let item = items[i];
            let mut at = i;
            while at >= gap && behind(items[at - gap], item) {
                items[at] = items[at - gap];
                at -= gap;
            }
            items[at] = item;
        }
    }
}

/// cos(2π t) for `t` in turns, |t| < 2^51, to within 5e-16; exactly 1 and −1 at whole and half turns.
///
/// The reduction to an eighth of a turn is exact in floating point, so no digits are lost for large `t`. From there it
/// is ±(1 − 2 sin² π u): one short series, no branches, about half the time of a general cosine.
#[inline]
pub fn cos_turns(t: f64) -> f64 {
    let r = (t - nearest(t)).abs();
    let from_quarter = 0.25 - r;
    let u = 0.25 - from_quarter.abs();
    let x = PI * u;
    let s = x * x;
    let sine = x + x * SIN.iter().rev().fold(0.0, |sum, c| (sum + c) * s);
    (1.0 - 2.0 * sine * sine).copysign(from_quarter)
}

/// Σ cos(2π t) over many `t`, in pairs (so that the compiler can use two lanes): the even-numbered and the odd-numbered
/// are summed apart, in their order, then added.
#[inline]
pub fn sum_cos_turns(turns: &[f64]) -> f64 {
    let pairs = turns.chunks_exact(2);
    let last = pairs.remainder().first().map_or(0.0, |&t| cos_turns(t));
    let mut sums = [0.0; 2];
    for pair in pairs {
        let cosines = [cos_turns(pair[0]), cos_turns(pair[1])];
        sums[0] += cosines[0];
        sums[1] += cosines[1];
    }
    (sums[0] + sums[1]) + last
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_sorted_as_std_does() {
        let mut rng = crate::kernel::rng::Stream::new(1, 0);
        for n in (0..40).chain([1000, 4097]) {
            let mut numbers: Vec<_> = (0..n).map(|_| (rng.unit() * 50.0).round() - 25.0).collect();
            numbers.extend([-0.0, 0.0, f64::INFINITY, f64::NAN]);
            let mut expected = numbers.clone();
            expected.sort_by(f64::total_cmp);
            sort_numbers(&mut numbers);
            assert_eq!(numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), expected.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_turn_is_what_is_left_of_an_angle() {
        for k in -1999..2000 {
            let angle = f64::from(k) * TAU / 1000.0;
            assert_eq!(turn(angle), angle.rem_euclid(TAU), "{angle}");
        }
    }

    #[test]
    fn cos_turns_agrees_with_libm_and_is_exact_at_half_turns() {
        for (t, expected) in [(0.0, 1.0), (0.5, -1.0), (1.0, 1.0), (-3.5, -1.0), (1e9, 1.0)] {
            assert_eq!(cos_turns(t), expected, "t = {t}");
        }
        for i in -4000..=4000 {
            let t = f64::from(i) * 0.000_731;
            // The reference is taken where its own argument is small, so that rounding that does not count.
            let r = (t - nearest(t)).abs();
            let reference = if r > 0.375 {
                -cos(2.0 * PI * (0.5 - r))
            } else if r > 0.125 {
                sin(2.0 * PI * (0.25 - r))
            } else {
                cos(2.0 * PI * r)
            };
            let difference = (cos_turns(t) - reference).abs();
            assert!(difference <= 5e-16, "t = {t}: {difference:e}");
        }
    }
}
