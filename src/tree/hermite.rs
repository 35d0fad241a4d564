//! Cubic Hermite smoothing, [ARM-RRT](crate#papers) (12): through the corners of a polyline, with continuous velocity.

use super::{
    free::Free,
    vector::{between, distance, dot, minus},
};

/// A curved piece is drawn and tested by so many straight ones.
const PIECES: usize = 12;
/// Where a piece touches, the tangents at its ends are halved; so often at most, then they are 0 and the piece is straight.
const HALVINGS: usize = 5;

/// p(t) of (12), 0 ≤ t ≤ 1, between two points with their tangents.
#[inline]
pub(super) fn hermite<const N: usize>([p0, p1]: [&[f64; N]; 2], [r0, r1]: [&[f64; N]; 2], t: f64) -> [f64; N] {
    let (t2, t3) = (t * t, t * t * t);
    let (a, b, c, d) = (2.0 * t3 - 3.0 * t2 + 1.0, t3 - 2.0 * t2 + t, t3 - t2, -2.0 * t3 + 3.0 * t2);
    std::array::from_fn(|i| a * p0[i] + b * r0[i] + c * r1[i] + d * p1[i])
}

/// A polyline's corners smoothed: on each side of a corner, `blend` away or half-way to the next, the curve begins.
/// Tangents come from neighbouring points, as long as the shorter of the two pieces; one tangent for the two pieces that
/// meet in a point, so that the velocity is continuous. The result is a polyline again, with its curves in short pieces,
/// each of which was tested.
pub(super) fn smooth<const N: usize>(path: &[[f64; N]], blend: f64, free: Free<N>) -> Vec<[f64; N]> {
    let knots = knots(path, blend);
    let n = knots.len();
    if n < 3 {
        return path.to_vec();
    }
    let mut tangents: Vec<[f64; N]> = (0..n).map(|i| tangent(&knots, i)).collect();
    let mut halved = vec![0; n];
    // A piece whose tangents change is tested again, and so is the one before it: until all are free. Where both tangents
    // are 0 the piece is one of the polyline's own.
    let mut i = 0;
    while i + 1 < n {
        let own = halved[i] > HALVINGS && halved[i + 1] > HALVINGS;
        if own || is_free(&knots, &tangents, i, free) {
            i += 1;
            continue;
        }
        for end in [i, i + 1] {
            halved[end] += 1;
            let scale = if halved[end] > HALVINGS { 0.0 } else { 0.5 };
            tangents[end] = tangents[end].map(|x| x * scale);
        }
        i = i.saturating_sub(1);
    }
    let mut out = vec![knots[0]];
    for i in 0..n - 1 {
        out.extend(pieces(&knots, &tangents, i));
    }
    out
}

/// The corners, and a point on each side of each.
fn knots<const N: usize>(path: &[[f64; N]], blend: f64) -> Vec<[f64; N]> {
    let mut knots: Vec<[f64; N]> = Vec::with_capacity(3 * path.len());
    for (i, corner) in path.iter().enumerate() {
        if i == 0 || i + 1 == path.len() {
            knots.push(*corner);
            continue;
        }
        let beside = |other: &[f64; N]| {
            let far = distance(corner, other);
            if far > 0.0 { between(corner, other, (blend / far).min(0.5)) } else { *corner }
        };
        knots.extend([beside(&path[i - 1]), *corner, beside(&path[i + 1])]);
    }
    knots.dedup();
    knots
}

/// From the point before to the point after, as long as the shorter piece.
fn tangent<const N: usize>(knots: &[[f64; N]], i: usize) -> [f64; N] {
    let (before, after) = (i.saturating_sub(1), (i + 1).min(knots.len() - 1));
    let way = minus(&knots[after], &knots[before]);
    let length = dot(&way, &way).sqrt();
    let lengths = [before, after].map(|other| distance(&knots[other], &knots[i])).into_iter().filter(|&length| length > 0.0);
    let scale = lengths.fold(f64::INFINITY, f64::min);
    if length > 0.0 && scale.is_finite() { way.map(|x| x / length * scale) } else { [0.0; N] }
}

/// The points of a piece after its first: its end only, where it is straight.
fn pieces<'a, const N: usize>(knots: &'a [[f64; N]], tangents: &'a [[f64; N]], i: usize) -> impl Iterator<Item = [f64; N]> + 'a {
    let (ends, rates) = ([&knots[i], &knots[i + 1]], [&tangents[i], &tangents[i + 1]]);
    let way = minus(ends[1], ends[0]);
    // Parallel to the piece: no curve.
    let straight = rates.iter().all(|rate| {
        let along = dot(rate, &way);
        along >= 0.0 && along * along >= (1.0 - 1e-12) * dot(rate, rate) * dot(&way, &way)
    });
    let n = if straight { 1 } else { PIECES };
    (1..=n).map(move |k| if k == n { *ends[1] } else { hermite(ends, rates, k as f64 / n as f64) })
}

fn is_free<const N: usize>(knots: &[[f64; N]], tangents: &[[f64; N]], i: usize, free: Free<N>) -> bool {
    let mut from = knots[i];
    pieces(knots, tangents, i).all(|to| {
        let is_free = free(&from, &to);
        from = to;
        is_free
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_has_the_given_ends_and_tangents() {
        let (p0, p1, r0, r1) = ([0.0, 1.0, 2.0], [3.0, -1.0, 2.5], [1.0, 1.0, 0.0], [0.0, -2.0, 1.0]);
        let at = |t| hermite([&p0, &p1], [&r0, &r1], t);
        assert_eq!((at(0.0), at(1.0)), (p0, p1));
        // By hand at t = 1/2: p0/2 + R0/8 − R1/8 + p1/2.
        assert_eq!(at(0.5), [1.5 + 0.125, 0.125 + 0.25, 2.25 - 0.125]);
        let h = 1e-6;
        for i in 0..3 {
            assert!(((at(h)[i] - p0[i]) / h - r0[i]).abs() < 1e-4 && ((p1[i] - at(1.0 - h)[i]) / h - r1[i]).abs() < 1e-4);
        }
    }

    /// A corner round the end of a wall from (1, 0) up to (1, 1).
    #[test]
    fn the_velocity_is_continuous_and_the_curve_swings_away_from_what_it_goes_round() {
        let wall = |a: &[f64; 2], b: &[f64; 2]| {
            let crosses = (a[0] - 1.0) * (b[0] - 1.0) < 0.0;
            !crosses || a[1] + (1.0 - a[0]) / (b[0] - a[0]) * (b[1] - a[1]) >= 1.0
        };
        let path = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]];
        let curve = smooth(&path, 0.4, &wall);
        assert!(curve.windows(2).all(|w| wall(&w[0], &w[1])));
        assert_eq!((curve[0], curve[curve.len() - 1]), (path[0], path[2]));
        let top = curve.iter().map(|p| p[1]).fold(0.0, f64::max);
        assert!(curve.contains(&[1.0, 1.0]) && top <= 1.0 + 1e-12, "through the corner, level there: {top}");
        // Directions of neighbouring pieces differ by little everywhere: no corner is left.
        for w in curve.windows(3) {
            let (a, b) = (minus(&w[1], &w[0]), minus(&w[2], &w[1]));
            assert!(dot(&a, &b) > 0.9 * (dot(&a, &a) * dot(&b, &b)).sqrt(), "{w:?}");
        }
        assert!(crate::tree::vector::length(&curve) < 1.1 * crate::tree::vector::length(&path));
    }

    #[test]
    fn where_nothing_else_is_free_the_polyline_stays() {
        let path = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [3.0, 3.0]];
        // On the polyline only.
        let on = |p: &[f64; 2]| path.windows(2).any(|w| distance(&w[0], p) + distance(p, &w[1]) <= distance(&w[0], &w[1]) * (1.0 + 1e-12));
        let curve = smooth(&path, 0.3, &|a, b| on(a) && on(b) && on(&between(a, b, 0.5)));
        assert!(curve.windows(2).all(|w| on(&w[0]) && on(&w[1]) && on(&between(&w[0], &w[1], 0.5))));
        assert!(path.iter().all(|corner| curve.contains(corner)));
        assert_eq!(smooth(&path[..2], 0.3, &|_, _| true), &path[..2]);
    }
}
