//! Points of a space of N dimensions.

/// a − b.
#[inline]
pub(super) fn minus<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Σ aᵢ bᵢ.
#[inline]
pub(super) fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    (0..N).fold(0.0, |sum, i| sum + a[i] * b[i])
}

/// The squared distance.
#[inline]
pub(super) fn squared<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    (0..N).fold(0.0, |sum, i| sum + (a[i] - b[i]) * (a[i] - b[i]))
}

/// ‖a − b‖.
#[inline]
pub(super) fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    squared(a, b).sqrt()
}

/// a + t (b − a).
#[inline]
pub(super) fn between<const N: usize>(a: &[f64; N], b: &[f64; N], t: f64) -> [f64; N] {
    std::array::from_fn(|i| a[i] + t * (b[i] - a[i]))
}

/// The length of a polyline.
pub(super) fn length<const N: usize>(path: &[[f64; N]]) -> f64 {
    path.windows(2).fold(0.0, |sum, w| sum + distance(&w[0], &w[1]))
}
