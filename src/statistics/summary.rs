//! Summaries of one sample: mean, spread, order statistics and confidence intervals.

use serde::Serialize;
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use super::CONFIDENCE;

/// A place so near to a whole number is that number.
const ROUNDING: f64 = 1e-12;

/// Mean, spread and order statistics of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Summary {
    /// The number of values.
    pub count: usize,
    /// The mean.
    pub mean: f64,
    /// The sample's standard deviation, with n − 1 as in Matlab's `std`; `None` for a single number.
    pub std: Option<f64>,
    /// The 95 % confidence interval of the mean by Student's t, not below 0 where no value is; `None` for a single number.
    pub interval: Option<[f64; 2]>,
    /// The smallest value.
    pub min: f64,
    /// The lower quartile, median-unbiased as Hyndman and Fan's type 8 (numpy's `median_unbiased`).
    pub lower: f64,
    /// The median: the middle value, or the mean of the two in the middle.
    pub median: f64,
    /// The upper quartile, as the lower one.
    pub upper: f64,
    /// The largest value.
    pub max: f64,
}

impl Summary {
    /// The summary of these numbers; `None` if there are none.
    pub fn of(numbers: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        crate::math::sort_numbers(&mut sorted);
        let count = sorted.len();
        let (&min, &max) = (sorted.first()?, sorted.last()?);
        let moments = sorted.iter().fold(Moments::default(), |moments, &x| moments.with(x));
        let [lower, median, upper] = [0.25, 0.5, 0.75].map(|share| quantile(&sorted, share));
        let interval = moments.interval().map(|[low, high]| [if min < 0.0 { low } else { low.max(0.0) }, high]);
        Some(Self { count, mean: moments.mean, std: moments.std(), interval, min, lower, median, upper, max })
    }
}

/// Count, mean and sum of squared deviations, one number after the other (Welford).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Moments {
    /// The number of values.
    pub count: f64,
    /// Their mean.
    pub mean: f64,
    /// Σ (x − mean)². Another number never makes it smaller.
    pub squares: f64,
}

impl Moments {
    /// The same with one more number.
    #[must_use]
    pub fn with(self, x: f64) -> Self {
        let count = self.count + 1.0;
        let deviation = x - self.mean;
        let mean = self.mean + deviation / count;
        Self { count, mean, squares: self.squares + deviation * (x - mean) }
    }

    /// The standard deviation, with n − 1; `None` for fewer than two numbers.
    pub fn std(&self) -> Option<f64> {
        (self.count > 1.0).then(|| (self.squares / (self.count - 1.0)).sqrt())
    }

    /// The 95 % confidence interval of the mean, by Student's t with n − 1 degrees of freedom; `None` for fewer than two
    /// numbers.
    pub fn interval(&self) -> Option<[f64; 2]> {
        let std = self.std()?;
        let t = StudentsT::new(0.0, 1.0, self.count - 1.0).ok()?.inverse_cdf(f64::midpoint(1.0, CONFIDENCE));
        let half = t * std / self.count.sqrt();
        Some([self.mean - half, self.mean + half])
    }
}

/// The 95 % confidence interval of a share, `successes` of `count`, by Wilson's score; `None` if `count` is 0.
pub fn proportion(successes: usize, count: usize) -> Option<[f64; 2]> {
    if count == 0 {
        return None;
    }
    let (n, share) = (count as f64, successes as f64 / count as f64);
    let z = Normal::standard().inverse_cdf(f64::midpoint(1.0, CONFIDENCE));
    let scale = 1.0 + z * z / n;
    let middle = (share + z * z / (2.0 * n)) / scale;
    let half = z / scale * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
    // At the ends the formula gives 0 and 1, but for rounding.
    Some([if successes == 0 { 0.0 } else { middle - half }, if successes == count { 1.0 } else { middle + half }])
}

/// A quantile of numbers in order, some of which may be infinite: Hyndman and Fan's type 8, numpy's `median_unbiased`. NaN
/// of none.
pub(super) fn quantile(sorted: &[f64], share: f64) -> f64 {
    let at = (sorted.len() as f64 + 1.0 / 3.0) * share + 1.0 / 3.0;
    let place = ((at + ROUNDING).floor() as usize).clamp(1, sorted.len().max(1));
    let Some(&low) = sorted.get(place - 1) else { return f64::NAN };
    let high = sorted.get(place).copied().unwrap_or(low);
    let part = at - place as f64;
    // Nothing is added to what may be infinite already.
    if part <= ROUNDING || low == high { low } else { low + part * (high - low) }
}

#[cfg(test)]
mod tests {
    use statrs::statistics::{Data, OrderStatistics};

    use super::*;

    /// python3 -c 'import numpy as n; x=[2,4,4,4,5,5,7,9.5]; print(n.mean(x), n.std(x, ddof=1), n.median(x))'
    #[test]
    fn a_summary_agrees_with_numpy() {
        let found = Summary::of([5.0, 9.5, 4.0, 2.0, 4.0, 7.0, 5.0, 4.0]).unwrap();
        assert_eq!((found.count, found.mean, found.median, found.min, found.max), (8, 5.0625, 4.5, 2.0, 9.5));
        assert!((found.std.unwrap() - 2.274_666_380_561_585).abs() < 1e-14, "{:?}", found.std);
    }

    #[test]
    fn one_number_has_no_spread_and_none_has_nothing() {
        let one = Summary::of([3.0]).unwrap();
        assert_eq!((one.mean, one.median, one.std, one.interval), (3.0, 3.0, None, None));
        assert_eq!((one.lower, one.upper), (3.0, 3.0));
        assert_eq!(Summary::of([]), None);
    }

    /// python3 -c 'import numpy as n; x=[1,2,4,8,16]; print([n.quantile(x, q, method="median_unbiased") for q in (.25,.5,.75)])'
    #[test]
    fn quantiles_agree_with_numpy() {
        let of = |share| quantile(&[1.0, 2.0, 4.0, 8.0, 16.0], share);
        assert!((of(0.25) - 1.666_666_666_666_666_7).abs() < 1e-12 && of(0.5) == 4.0 && (of(0.75) - 10.666_666_666_666_668).abs() < 1e-12);
        assert!(quantile(&[], 0.5).is_nan());
        for count in 1..=23 {
            let mut numbers: Vec<f64> = (0..count).map(|k| f64::from(7 * k % 23) + f64::from(k) / 9.0).collect();
            crate::math::sort_numbers(&mut numbers);
            for share in [0.0, 0.025, 0.25, 0.5, 0.75, 0.975, 1.0] {
                let expected = Data::new(numbers.clone()).quantile(share);
                assert!((quantile(&numbers, share) - expected).abs() < 1e-12, "{share} of {count}");
            }
        }
    }
}
