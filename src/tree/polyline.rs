//! A path approximated by few straight pieces, by least squares, [ARM-RRT](crate#papers) step 3.

use super::{
    free::Free,
    vector::{between, distance},
};

/// More points are not fitted: the work would grow with their square.
const MOST: usize = 2000;

/// The polyline of few pieces that comes nearest to a path, in the sum of squares over points `spacing` apart; its ends are
/// the path's. Pieces are added where it is farthest off until it is off by `tolerance` at most and free. The path itself,
/// where that takes no fewer corners than it has.
pub(super) fn fitted<const N: usize>(path: &[[f64; N]], tolerance: f64, spacing: f64, free: Free<N>) -> Vec<[f64; N]> {
    let points = spaced(path, spacing);
    if path.len() < 3 || points.len() > MOST {
        return path.to_vec();
    }
    let along: Vec<f64> = std::iter::once(0.0)
        .chain(points.windows(2).scan(0.0, |sum, w| {
            *sum += distance(&w[0], &w[1]);
            Some(*sum)
        }))
        .collect();
    let last = points.len() - 1;
    let mut breaks = vec![0, last];
    while breaks.len() < path.len() {
        let corners = least_squares(&points, &along, &breaks);
        let worst = worst(&points, &along, &breaks, &corners);
        let blocked = corners.windows(2).position(|w| !free(&w[0], &w[1]));
        let add = match (blocked, worst) {
            // In the middle of the piece that touches.
            (Some(piece), _) => usize::midpoint(breaks[piece], breaks[piece + 1]),
            (None, (at, off)) if off > tolerance => at,
            _ => return corners,
        };
        // Where there is no room for another, the path has its own corners for a reason.
        match breaks.binary_search(&add) {
            Ok(_) => break,
            Err(place) => breaks.insert(place, add),
        }
    }
    path.to_vec()
}

/// The path's corners, and points between them no farther apart than `spacing`.
fn spaced<const N: usize>(path: &[[f64; N]], spacing: f64) -> Vec<[f64; N]> {
    let mut out: Vec<[f64; N]> = path.first().copied().into_iter().collect();
    for w in path.windows(2) {
        let n = (distance(&w[0], &w[1]) / spacing).ceil().clamp(1.0, MOST as f64) as usize;
        out.extend((1..=n).map(|i| if i == n { w[1] } else { between(&w[0], &w[1], i as f64 / n as f64) }));
        if out.len() > MOST {
            break;
        }
    }
    out
}

/// The corners c_j of the polyline with the least Σ ‖x_i − Σ_j Λ_j(u_i) c_j‖², Λ_j the hat functions over the breaks; the
/// first and the last are given. The normal equations have three diagonals.
fn least_squares<const N: usize>(points: &[[f64; N]], along: &[f64], breaks: &[usize]) -> Vec<[f64; N]> {
    let n = breaks.len();
    let (mut diagonal, mut beside, mut right) = (vec![0.0; n], vec![0.0; n], vec![[0.0; N]; n]);
    for (j, w) in breaks.windows(2).enumerate() {
        let (from, to) = (along[w[0]], along[w[1]]);
        // A point on a break belongs to one piece.
        let first = if j == 0 { w[0] } else { w[0] + 1 };
        for i in first..=w[1] {
            let t = if to > from { (along[i] - from) / (to - from) } else { 0.0 };
            let (a, b) = (1.0 - t, t);
            diagonal[j] += a * a;
            diagonal[j + 1] += b * b;
            beside[j] += a * b;
            for (k, x) in points[i].iter().enumerate() {
                right[j][k] += a * x;
                right[j + 1][k] += b * x;
            }
        }
    }
    let mut corners = vec![[0.0; N]; n];
    (corners[0], corners[n - 1]) = (points[0], points[points.len() - 1]);
    if n == 2 {
        return corners;
    }
    for k in 0..N {
        right[1][k] -= beside[0] * corners[0][k];
        right[n - 2][k] -= beside[n - 2] * corners[n - 1][k];
    }
    // Thomas' algorithm; the matrix is positive definite, each piece having points of its own.
    for j in 2..n - 1 {
        let factor = beside[j - 1] / diagonal[j - 1];
        diagonal[j] -= factor * beside[j - 1];
        let before = right[j - 1];
        right[j].iter_mut().zip(before).for_each(|(x, before)| *x -= factor * before);
    }
    for j in (1..n - 1).rev() {
        for k in 0..N {
            let after = if j + 1 < n - 1 { beside[j] * corners[j + 1][k] } else { 0.0 };
            corners[j][k] = (right[j][k] - after) / diagonal[j];
        }
    }
    corners
}

/// The point that the polyline is farthest from, and how far.
fn worst<const N: usize>(points: &[[f64; N]], along: &[f64], breaks: &[usize], corners: &[[f64; N]]) -> (usize, f64) {
    let mut worst = (0, 0.0);
    for (j, w) in breaks.windows(2).enumerate() {
        let (from, to) = (along[w[0]], along[w[1]]);
        for i in w[0]..=w[1] {
            let t = if to > from { (along[i] - from) / (to - from) } else { 0.0 };
            let off = distance(&points[i], &between(&corners[j], &corners[j + 1], t));
            if off > worst.1 {
                worst = (i, off);
            }
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_piece_fitted_by_hand() {
        // Three points over a break in the middle: the middle corner alone is free, and takes the middle point.
        let points = [[0.0, 0.0], [1.0, 3.0], [2.0, 0.0]];
        assert_eq!(least_squares(&points, &[0.0, 1.0, 2.0], &[0, 1, 2]), points);
        // Five points, one corner c in the middle: 0, 1 | 4 | 1, 0 with hats 0, ½, 1, ½, 0: c = (½ + 4 + ½) / (¼ + 1 + ¼).
        let points = [0.0, 1.0, 4.0, 1.0, 0.0].map(|y| [y]);
        let fit = least_squares(&points, &[0.0, 1.0, 2.0, 3.0, 4.0], &[0, 2, 4]);
        assert!((fit[1][0] - 5.0 / 1.5).abs() < 1e-15, "{fit:?}");
        // The gradient of the sum of squares is 0 for three corners too.
        let points: Vec<[f64; 2]> = (0..21).map(|i| [f64::from(i), f64::from(i * i % 17)]).collect();
        let (along, breaks) = ((0..21).map(f64::from).collect::<Vec<_>>(), [0, 4, 9, 15, 20]);
        let fit = least_squares(&points, &along, &breaks);
        let sum = |corners: &[[f64; 2]]| -> f64 {
            (0..21)
                .map(|i| {
                    let j = breaks.windows(2).position(|w| i <= w[1]).unwrap();
                    let t = (i - breaks[j]) as f64 / (breaks[j + 1] - breaks[j]) as f64;
                    super::super::vector::squared(&points[i], &between(&corners[j], &corners[j + 1], t))
                })
                .sum()
        };
        for j in 1..4 {
            for k in 0..2 {
                for by in [-1e-3, 1e-3] {
                    let mut moved = fit.clone();
                    moved[j][k] += by;
                    assert!(sum(&moved) > sum(&fit));
                }
            }
        }
    }

    #[test]
    fn a_path_that_trembles_becomes_few_pieces_and_none_goes_through_a_wall() {
        let path: Vec<[f64; 2]> = (0..=60).map(|i| [f64::from(i) * 0.1, f64::from(i - 30).abs() * 0.1 + 0.02 * f64::from(i % 2)]).collect();
        let fit = fitted(&path, 0.05, 0.1, &|_, _| true);
        assert!(fit.len() == 3 || fit.len() == 4, "{fit:?}");
        assert_eq!((fit[0], fit[fit.len() - 1]), (path[0], path[60]));
        // A wall above y = 1 between: the straight line from end to end is blocked, and found out.
        let free = |a: &[f64; 2], b: &[f64; 2]| {
            !(0..=100).any(|i| {
                let p = between(a, b, f64::from(i) / 100.0);
                (p[0] - 3.0).abs() < 0.5 && p[1] > 1.0
            })
        };
        let fit = fitted(&path, 100.0, 0.1, &free);
        assert!(fit.len() > 2 && fit.len() < 10 && fit.windows(2).all(|w| free(&w[0], &w[1])), "{fit:?}");
        assert_eq!(fitted(&path, 0.05, 0.1, &|_, _| false), path);
    }
}
