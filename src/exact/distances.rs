//! Distances between stops, from which the length of a tour is computed.

use std::sync::Arc;

use crate::{kernel::Error, math, message};

/// The metric of distances between points. All but the first are TSPLIB's, by its own formulas and in whole numbers, for
/// comparison with published optima.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "kebab-case"))]
pub enum Metric {
    /// The straight line, unrounded.
    #[default]
    Euclidean,
    /// The straight line, rounded to the nearest whole number.
    #[cfg_attr(feature = "types", ts(rename = "euc-2d"))]
    Euc2d,
    /// The straight line, rounded up.
    #[cfg_attr(feature = "types", ts(rename = "ceil-2d"))]
    Ceil2d,
    /// Pseudo-Euclidean: the straight line over √10, rounded up.
    Att,
    /// Kilometres on a sphere; a point is longitude and latitude as degrees and minutes, DDD.MM.
    Geo,
}

impl Metric {
    /// All metrics.
    pub const ALL: [Self; 5] = [Self::Euclidean, Self::Euc2d, Self::Ceil2d, Self::Att, Self::Geo];

    /// The name that scene files use; in capitals and with `_` it is TSPLIB's.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Euclidean => "euclidean",
            Self::Euc2d => "euc-2d",
            Self::Ceil2d => "ceil-2d",
            Self::Att => "att",
            Self::Geo => "geo",
        }
    }

    /// The distance of two points.
    #[inline(never)]
    pub fn distance(self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
        let straight = || (dx * dx + dy * dy).sqrt();
        match self {
            Self::Euclidean => straight(),
            Self::Euc2d => (straight() + 0.5).floor(),
            Self::Ceil2d => straight().ceil(),
            Self::Att => ((dx * dx + dy * dy) / 10.0).sqrt().ceil(),
            Self::Geo if a == b => 0.0,
            Self::Geo => on_sphere(a, b),
        }
    }
}

/// TSPLIB's kilometres between longitudes and latitudes, with its π and its radius of the earth.
fn on_sphere(a: [f64; 2], b: [f64; 2]) -> f64 {
    #[expect(clippy::approx_constant, reason = "published optima are by this π")]
    const PI: f64 = 3.141_592;
    const RADIUS: f64 = 6378.388;
    let radians = |x: f64| {
        let degrees = x.trunc();
        PI * (degrees + 5.0 * (x - degrees) / 3.0) / 180.0
    };
    let ([long_a, lat_a], [long_b, lat_b]) = (a.map(radians), b.map(radians));
    let (q1, q2, q3) = (math::cos(long_a - long_b), math::cos(lat_a - lat_b), math::cos(lat_a + lat_b));
    (RADIUS * math::acos(0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3)) + 1.0).trunc()
}

/// The most stops whose distances are kept as a matrix: 32 MB. Those of more are computed whenever they are needed.
pub const MAX_MATRIX: usize = 2000;

/// The symmetric distances of `n` stops from each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Distances {
    n: usize,
    /// Row by row; empty where they are computed.
    values: Vec<f64>,
    points: Arc<[[f64; 2]]>,
    metric: Metric,
    fixed: Arc<[[usize; 2]]>,
    /// How much shorter than nothing a fixed edge counts: a whole number.
    bonus: f64,
}

impl Distances {
    fn matrix(n: usize, values: Vec<f64>) -> Self {
        Self { n, values, points: Arc::new([]), metric: Metric::default(), fixed: Arc::new([]), bonus: 0.0 }
    }

    /// The distances by a function of two stops, which is called once for each pair, the smaller index first.
    pub fn of(n: usize, mut between: impl FnMut(usize, usize) -> f64) -> Self {
        let mut values = vec![0.0; n * n];
        for i in 0..n {
            for j in i + 1..n {
                let d = between(i, j);
                (values[i * n + j], values[j * n + i]) = (d, d);
            }
        }
        Self::matrix(n, values)
    }

    /// The distances of so many points that they are computed whenever they are needed.
    pub fn through(points: &[[f64; 2]], metric: Metric) -> Self {
        Self { points: points.into(), metric, ..Self::matrix(points.len(), Vec::new()) }
    }

    /// Has tours go from one stop of each of these pairs straight to the other. What is fixed costs nothing, as in published optima:
    /// the length of a tour is that of the rest. Only for distances that are kept as a matrix.
    #[must_use]
    pub fn fixing(mut self, fixed: &[[usize; 2]]) -> Self {
        let longest = self.values.iter().copied().fold(0.0, f64::max);
        for &[a, b] in fixed {
            (self.values[a * self.n + b], self.values[b * self.n + a]) = (0.0, 0.0);
            self.bonus = (2.0 * longest * self.n as f64).ceil() + 1.0;
        }
        Self { fixed: fixed.into(), ..self }
    }

    /// The pairs of stops that follow each other in every tour.
    pub fn fixed(&self) -> &[[usize; 2]] {
        &self.fixed
    }

    /// All bonuses: what tours with all fixed edges have too little when their ways are [counted](Self::counted).
    pub fn bonuses(&self) -> f64 {
        self.bonus * self.fixed.len() as f64
    }

    /// What a way costs in a search: a fixed one has a negative cost, larger in size than any tour is long, so that no tour without it
    /// is shorter.
    #[inline(never)]
    pub fn counted(&self, i: usize, j: usize) -> f64 {
        self.between(i, j) - if self.is_fixed(i, j) { self.bonus } else { 0.0 }
    }

    fn is_fixed(&self, i: usize, j: usize) -> bool {
        self.fixed.iter().any(|fixed| *fixed == [i, j] || *fixed == [j, i])
    }

    /// Whether a tour in this order has all fixed edges.
    pub fn has_fixed(&self, order: &[usize], closed: bool) -> bool {
        if self.fixed.is_empty() {
            return true;
        }
        let mut found = 0;
        let mut last = order.last().filter(|_| closed && order.len() > 2);
        for stop in order {
            found += usize::from(last.is_some_and(|&last| self.is_fixed(last, *stop)));
            last = Some(stop);
        }
        found == self.fixed.len()
    }

    /// The distances of a matrix, row by row.
    ///
    /// # Errors
    /// [`Error::Refused`] with the entry of `field` that is negative, not finite, not the same both ways, or not 0 from a
    /// stop to itself.
    pub fn new(field: &str, n: usize, values: Vec<f64>) -> Result<Self, Error> {
        for i in 0..n {
            for j in 0..n {
                let (there, back) = (values[i * n + j], values[j * n + i]);
                let at = || format!("{field}[{i}][{j}]");
                if !(0.0..=LONGEST).contains(&there) {
                    let allowed = message!("exact-distance", "a distance from 0 to {most}", most = LONGEST);
                    return Err(Error::refused(at(), there, allowed));
                }
                if i == j && there != 0.0 {
                    let allowed = message!("exact-distance-to-itself", "0, as it is the distance of a stop from itself");
                    return Err(Error::refused(at(), there, allowed));
                }
                if there != back {
                    let allowed = message!("exact-symmetric", "{back}, as in the other direction: distances are symmetric", back);
                    return Err(Error::refused(at(), there, allowed));
                }
            }
        }
        Ok(Self::matrix(n, values))
    }

    /// The number of stops.
    pub fn len(&self) -> usize {
        self.n
    }

    /// Whether there are no stops.
    pub fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// The distance from stop `i` to stop `j`.
    #[inline]
    pub fn between(&self, i: usize, j: usize) -> f64 {
        if self.values.is_empty() {
            return self.metric.distance(self.points[i], self.points[j]);
        }
        self.values[i * self.n + j]
    }

    /// The points that the distances are computed from; empty where there is a matrix.
    pub fn points(&self) -> &Arc<[[f64; 2]]> {
        &self.points
    }

    /// The rows of the matrix; none above [`MAX_MATRIX`].
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.values.chunks_exact(self.n.max(1))
    }

    /// The length of a tour in this order; a closed one returns to the first stop.
    pub fn length(&self, order: &[usize], closed: bool) -> f64 {
        let back = order.first().zip(order.last()).filter(|_| closed).map_or(0.0, |(&first, &last)| self.between(last, first));
        order.windows(2).map(|w| self.between(w[0], w[1])).sum::<f64>() + back
    }
}

/// The largest distance that a matrix may hold: sums of it keep their digits.
pub const LONGEST: f64 = 1e12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_metric_against_hand_computed_distances() {
        let d = |metric: Metric, b| metric.distance([0.0, 0.0], b);
        assert_eq!([3.0, 3.5, 4.0].map(|y| d(Metric::Euclidean, [0.0, y])), [3.0, 3.5, 4.0]);
        assert_eq!([3.4, 3.5, 3.6].map(|y| d(Metric::Euc2d, [0.0, y])), [3.0, 4.0, 4.0]);
        assert_eq!([3.0, 3.1].map(|y| d(Metric::Ceil2d, [0.0, y])), [3.0, 4.0]);
        // √(100 / 10) = 3.16, √(1000 / 10) = 10.
        assert_eq!([[10.0, 0.0], [30.0, 10.0]].map(|b| d(Metric::Att, b)), [4.0, 10.0]);
        // A degree on the equator: 6378.388 · π / 180 = 111.32, + 1, cut off; half a degree is 30 minutes.
        assert_eq!([[1.0, 0.0], [0.3, 0.0], [0.0, 1.0]].map(|b| d(Metric::Geo, b)), [112.0, 56.0, 112.0]);
        assert_eq!(d(Metric::Geo, [0.0, 0.0]), 0.0);
        // The first distances of TSPLIB's burma14, in degrees and minutes.
        let first = [96.10, 16.47];
        let from_first = [[94.44, 16.47], [92.54, 20.09], [93.37, 22.39], [97.24, 25.23]].map(|b| Metric::Geo.distance(first, b));
        assert_eq!(from_first, [153.0, 510.0, 706.0, 966.0]);
    }

    #[test]
    fn a_matrix_that_is_none_is_refused_by_its_entry() {
        let refused = |values: [f64; 4]| Distances::new("matrix", 2, values.to_vec()).unwrap_err().field().to_owned();
        assert_eq!(refused([0.0, 1.0, 2.0, 0.0]), "matrix[0][1]");
        assert_eq!(refused([0.0, 1.0, 1.0, 3.0]), "matrix[1][1]");
        assert_eq!(refused([0.0, -1.0, -1.0, 0.0]), "matrix[0][1]");
        assert_eq!(refused([0.0, f64::NAN, 1.0, 0.0]), "matrix[0][1]");
        let fine = Distances::new("matrix", 2, vec![0.0, 1.5, 1.5, 0.0]).unwrap();
        assert_eq!([fine.length(&[1, 0], true), fine.length(&[1, 0], false)], [3.0, 1.5]);
        assert_eq!((fine.len(), fine.is_empty()), (2, false));
        assert!(Distances::new("matrix", 0, Vec::new()).unwrap().is_empty());
    }
}
