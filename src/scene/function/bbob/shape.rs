//! How the suite bends space: what its functions are made of.

use crate::math;

/// From 0 to 1 with the coordinate.
pub(super) fn share(i: usize, n: usize) -> f64 {
    i as f64 / (n - 1) as f64
}

/// From 1 to `last`, by the same factor from coordinate to coordinate.
#[inline(never)]
pub(super) fn growing(last: f64, n: usize) -> Vec<f64> {
    (0..n).map(|i| math::pow(last, share(i, n))).collect()
}

/// T_osz of a number.
#[inline(never)]
pub(super) fn oscillated(x: f64) -> f64 {
    let distorted = |x: f64, a: f64, b: f64| {
        let t = 10.0 * math::ln(x);
        math::exp(0.1 * (t + 0.49 * (math::sin(a * t) + math::sin(b * t))))
    };
    if x > 0.0 {
        distorted(x, 1.0, 0.79)
    } else if x < 0.0 {
        -distorted(-x, 0.55, 0.31)
    } else {
        0.0
    }
}

/// Each number becomes another one. Of one copy for all functions: it is downloaded.
#[inline(never)]
pub(super) fn each(z: &mut [f64], of: &dyn Fn(usize, f64) -> f64) {
    z.iter_mut().enumerate().for_each(|(i, z)| *z = of(i, *z));
}
