//! The straight line through points by least squares, with what Matlab's `regress` tells of it, as in [LTQPSO](forage#papers)
//! §3.

use nalgebra::{Matrix2, Vector2};
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, FisherSnedecor, StudentsT};

/// y = b0 + b1 x.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Fit {
    /// b0 and b1.
    pub b: [f64; 2],
    /// Their 95 % confidence intervals.
    pub interval: [[f64; 2]; 2],
    /// The share of the variance that the line explains.
    pub r2: f64,
    /// The F statistic of b1 ≠ 0, with 1 and n − 2 degrees of freedom; infinite where all points lie on the line.
    pub f: f64,
    /// How probable an F at least as large is if there is no relation.
    pub p: f64,
    /// How many points.
    pub count: usize,
}

/// The line through these points; `None` for fewer than three, or if all have the same x.
pub fn line(points: &[[f64; 2]]) -> Option<Fit> {
    let freedom = points.len().checked_sub(2).filter(|&n| n > 0)? as f64;
    let count = points.len() as f64;
    let mean = |axis: usize| points.iter().map(|point| point[axis]).sum::<f64>() / count;
    let (x_mean, y_mean) = (mean(0), mean(1));
    // About the mean of x the two coefficients are independent, so nothing is lost to rounding.
    let sum = |of: &dyn Fn(f64, f64) -> f64| points.iter().map(|[x, y]| of(x - x_mean, y - y_mean)).sum::<f64>();
    let normal = Matrix2::new(count, 0.0, 0.0, sum(&|x, _| x * x));
    let inverse = normal.try_inverse()?;
    let centred = inverse * Vector2::new(0.0, sum(&|x, y| x * y));
    let left = sum(&|x, y| (y - centred[1] * x) * (y - centred[1] * x));
    let total = sum(&|_, y| y * y);
    let variance = left / freedom;
    // Back from the mean to x = 0: b0 = ȳ − b1 x̄, and its variance by the same step.
    let b = [y_mean - centred[1] * x_mean, centred[1]];
    let errors = [inverse[(0, 0)] + x_mean * x_mean * inverse[(1, 1)], inverse[(1, 1)]].map(|diagonal| (variance * diagonal).sqrt());
    let t = StudentsT::new(0.0, 1.0, freedom).ok()?.inverse_cdf(0.975);
    let interval = [0, 1].map(|k| [b[k] - t * errors[k], b[k] + t * errors[k]]);
    // A level line explains nothing, and there is nothing to explain.
    let f = if total > 0.0 { (total - left) / variance } else { 0.0 };
    let p = FisherSnedecor::new(1.0, freedom).ok().filter(|_| f.is_finite()).map_or(0.0, |of| of.sf(f));
    Some(Fit { b, interval, r2: if total > 0.0 { 1.0 - left / total } else { 1.0 }, f, p, count: points.len() })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In Python with SciPy 1.17:
    /// `r = linregress(range(1, 7), [2.1, 3.9, 6.2, 7.8, 10.1, 12.2]); q = t.ppf(.975, 4)`, which
    /// prints b0, b1, their intervals `b ± t · stderr`, R² = `r.rvalue**2`, F = `(r.slope / r.stderr)**2` and `r.pvalue`.
    #[test]
    fn the_line_agrees_with_scipy() {
        let points = [2.1, 3.9, 6.2, 7.8, 10.1, 12.2].iter().zip(1..).map(|(&y, x)| [f64::from(x), y]).collect::<Vec<_>>();
        let fit = line(&points).unwrap();
        let close = |value: f64, expected: f64| assert!((value - expected).abs() < 1e-9 * expected.abs(), "{value} is not {expected}");
        SCIPY
            .iter()
            .zip([fit.b[0], fit.b[1], fit.interval[0][0], fit.interval[0][1], fit.interval[1][0], fit.interval[1][1]])
            .for_each(|(&expected, value)| close(value, expected));
        close(fit.r2, SCIPY[6]);
        close(fit.f, SCIPY[7]);
        assert!((fit.p / SCIPY[8] - 1.0).abs() < 1e-6, "{}", fit.p);
    }

    #[expect(clippy::unreadable_literal, reason = "as it was printed")]
    const SCIPY: [f64; 9] = [
        -0.019999999999998685,
        2.0199999999999996,
        -0.4823705099899754,
        0.442370509989978,
        1.9012742132933,
        2.138725786706699,
        0.9982106661074996,
        2231.468749999773,
        1.2013602560217847e-06,
    ];

    #[test]
    fn points_on_a_line_leave_nothing_over() {
        let fit = line(&[[0.0, 1.0], [1.0, 3.0], [2.0, 5.0]]).unwrap();
        assert_eq!((fit.b, fit.interval, fit.r2, fit.p), ([1.0, 2.0], [[1.0, 1.0], [2.0, 2.0]], 1.0, 0.0));
    }

    #[test]
    fn too_few_points_have_no_line() {
        assert_eq!(line(&[[0.0, 1.0], [1.0, 3.0]]), None);
        assert_eq!(line(&[[1.0, 1.0], [1.0, 3.0], [1.0, 4.0]]), None);
        assert_eq!(line(&[]), None);
    }
}
