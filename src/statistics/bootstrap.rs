//! Intervals of any statistic, by drawing from the sample.

use super::{CONFIDENCE, summary::quantile};
use crate::{kernel::rng::Stream, math};

/// How many times a sample is drawn again, unless there is a reason for another number.
pub const RESAMPLES: usize = 2000;

/// The 95 % interval of a statistic by the percentile bootstrap (Efron 1979): the statistic of `resamples` samples that are drawn from the
/// given one with replacement, each group from itself; values that are not numbers are left out. `None` for a group without values, and
/// where less than half of the samples have a number.
///
/// ```
/// use forage::{kernel::rng::Stream, statistics::{RESAMPLES, bootstrap}};
///
/// let mean = |groups: &[Vec<f64>]| groups[0].iter().sum::<f64>() / groups[0].len() as f64;
/// let sample = vec![(1..=50).map(f64::from).collect::<Vec<_>>()];
/// let [low, high] = bootstrap(&sample, RESAMPLES, &mut Stream::new(1, 0), mean).unwrap();
/// assert!(20.0 < low && low < 23.0 && 28.0 < high && high < 31.0);
/// ```
pub fn bootstrap<T: Clone>(
    groups: &[Vec<T>],
    resamples: usize,
    stream: &mut Stream,
    statistic: impl Fn(&[Vec<T>]) -> f64,
) -> Option<[f64; 2]> {
    if groups.is_empty() || groups.iter().any(Vec::is_empty) {
        return None;
    }
    let mut drawn = groups.to_vec();
    let mut found = Vec::with_capacity(resamples);
    for _ in 0..resamples {
        for (drawn, group) in drawn.iter_mut().zip(groups) {
            drawn.iter_mut().for_each(|one| one.clone_from(&group[stream.below(group.len())]));
        }
        found.push(statistic(&drawn));
    }
    found.retain(|value| !value.is_nan());
    if found.len() < resamples.div_ceil(2) {
        return None;
    }
    math::sort_numbers(&mut found);
    Some([1.0 - CONFIDENCE, 1.0 + CONFIDENCE].map(|level| quantile(&found, level / 2.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The quantiles of a mean over all 27 samples of three values, each as probable: what many draws come near to.
    #[test]
    fn the_interval_is_that_of_all_samples() {
        let sample = vec![vec![0.0, 3.0, 30.0]];
        let mean = |groups: &[Vec<f64>]| groups[0].iter().sum::<f64>() / 3.0;
        // 1 of 27 samples has the mean 0, and 1 the mean 30: 3.7 % each, more than 2.5 %.
        assert_eq!(bootstrap(&sample, 20_000, &mut Stream::new(1, 0), mean), Some([0.0, 30.0]));
    }

    /// python3 -c 'import numpy as n, scipy.stats as s; x=n.array([1.2,0.4,3.3,2.2,8.1,0.9,1.7,2.9,4.4,0.1]); print(s.bootstrap((x,), n.mean, n_resamples=200000, method="percentile", random_state=1).confidence_interval)'
    #[test]
    fn the_interval_of_a_mean_agrees_with_scipy() {
        let sample = vec![vec![1.2, 0.4, 3.3, 2.2, 8.1, 0.9, 1.7, 2.9, 4.4, 0.1]];
        let mean = |groups: &[Vec<f64>]| groups[0].iter().sum::<f64>() / 10.0;
        let [low, high] = bootstrap(&sample, 50_000, &mut Stream::new(2, 0), mean).unwrap();
        assert!((low - 1.28).abs() < 0.03 && (high - 4.05).abs() < 0.03, "{low} {high}");
    }

    #[test]
    fn each_group_is_drawn_from_itself_and_what_is_no_number_is_left_out() {
        let groups = vec![vec![1.0; 4], vec![100.0, 200.0]];
        let difference = |groups: &[Vec<f64>]| groups[1][0].min(groups[1][1]) - groups[0][0];
        assert_eq!(bootstrap(&groups, 1000, &mut Stream::new(3, 0), difference), Some([99.0, 199.0]));
        assert_eq!(bootstrap(&[vec![1.0], vec![]], 1000, &mut Stream::new(3, 0), difference), None);
        assert_eq!(bootstrap(&groups, 1000, &mut Stream::new(3, 0), |_| f64::NAN), None);
    }
}
