//! The statistical tests by which claims of papers are judged.
//!
//! Each test takes plain numbers and gives a [`Test`], whose `p` is always a number from 0 to 1. Samples that are identical,
//! or have no spread to measure a difference by, have p = 1. No argument may hold a NaN. Tests by ranks take numbers for
//! tied only if they are equal; [`forage::statistics::comparable`] makes numbers equal that differ by rounding alone, and
//! gives failed runs the last rank.
//!
//! Three more tools are in [`forage::statistics`]: `rank_sum` is Wilcoxon's rank-sum test of two independent samples
//! (Mann and Whitney 1947), `holm` corrects p-values for their number (Holm 1979), and `proportion` is Wilson's score
//! interval (1927) of a share, at 95 % and without continuity correction.

#[cfg(test)]
mod tests;

use std::iter;

use serde::Serialize;
use statrs::{
    distribution::{ContinuousCDF, FisherSnedecor, Normal},
    statistics::{Data, OrderStatistics, RankTieBreaker},
};

use forage::{
    kernel::rng::Stream,
    math,
    statistics::{CONFIDENCE, Moments, Summary, rank_sum},
};

/// Up to so many untied differences have their exact signed-rank distribution.
const EXACT_UNTIED: usize = 25;
/// Up to so many differences have it with ties, too: the smallest possible p of five is 1/16, and the normal approximation
/// would give less.
const EXACT_TIED: usize = 5;
/// Two tables whose probabilities differ by no more than this share are equally probable; the same as in R and SciPy.
const EQUALLY_PROBABLE: f64 = 1e-7;
/// Deviations below this share of the largest number are rounding errors.
const ROUNDING: f64 = 1e-12;
/// How often a bootstrap resamples.
const RESAMPLES: usize = 2_000;

/// The result of a statistical test.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Test {
    /// The name of the test.
    pub name: &'static str,
    /// The probability of a result at least as extreme if the null hypothesis holds.
    pub p: f64,
}

impl Test {
    fn new(name: &'static str, p: f64) -> Self {
        // Sums of probabilities, and two tails that overlap, can exceed 1.
        Self { name, p: p.min(1.0) }
    }
}

/// An estimate with its 95 % confidence interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// The estimate.
    pub value: f64,
    /// The lower end of the interval.
    pub low: f64,
    /// The upper end of the interval.
    pub high: f64,
}

/// Wilcoxon's signed-rank test (1945) of paired data, two-sided; `None` without differences.
///
/// Zero differences are dropped, as Wilcoxon does; if all are zero, p = 1. The null distribution is exact for up to 25
/// non-zero differences without ties, and for up to 5 with ties (given their average ranks), so that few differences are
/// never called significant: the smallest p of n is 2^(1 − n). Otherwise p is the normal approximation with corrections for
/// ties and continuity.
pub fn signed_rank(differences: &[f64]) -> Option<Test> {
    const NAME: &str = "Wilcoxon signed-rank test";
    let signed: Vec<f64> = differences.iter().copied().filter(|&x| x != 0.0).collect();
    if signed.is_empty() {
        return (!differences.is_empty()).then(|| Test::new(NAME, 1.0));
    }
    let ranks = average_ranks(signed.iter().map(|x| x.abs()));
    let positive: f64 = ranks.iter().zip(&signed).filter(|(_, x)| **x > 0.0).map(|(rank, _)| rank).sum();
    let n = signed.len() as f64;
    // Σ rank² is exact in floating point, and ties make it smaller.
    let squares: f64 = ranks.iter().map(|rank| rank * rank).sum();
    let tied = squares != n * (n + 1.0) * (2.0 * n + 1.0) / 6.0;
    let p = if signed.len() <= if tied { EXACT_TIED } else { EXACT_UNTIED } {
        signed_rank_exact(&ranks, positive)
    } else {
        // The variance Σ rank² / 4 is n (n + 1) (2 n + 1) / 24 with the usual correction for ties.
        let distance = (positive - n * (n + 1.0) / 4.0).abs();
        two_sided((distance - 0.5).max(0.0) / (squares / 4.0).sqrt())
    };
    Some(Test::new(NAME, p))
}

/// The exact two-sided p-value of this sum of positive ranks: all signs are equally probable. Average ranks are multiples of
/// a half, so that twice a rank is an index.
fn signed_rank_exact(ranks: &[f64], positive: f64) -> f64 {
    let doubled: Vec<usize> = ranks.iter().map(|rank| (2.0 * rank) as usize).collect();
    let total: usize = doubled.iter().sum();
    // How many choices of signs give each sum.
    let mut choices = vec![0.0; total + 1];
    choices[0] = 1.0;
    for rank in doubled {
        (rank..=total).rev().for_each(|sum| choices[sum] += choices[sum - rank]);
    }
    let positive = (2.0 * positive) as usize;
    2.0 * choices[..=positive.min(total - positive)].iter().sum::<f64>() / choices.iter().sum::<f64>()
}

/// Brown and Forsythe's test (1974) of equal spread: a one-way analysis of variance of the absolute deviations from the
/// medians, with F(1, n − 2). `None` if a sample has fewer than three numbers, because two always deviate equally.
///
/// Spreads that differ by rounding alone have p = 1. If the deviations differ between the samples and not within them,
/// F is infinite and p = 0.
pub fn brown_forsythe(first: &[f64], second: &[f64]) -> Option<Test> {
    const NAME: &str = "Brown-Forsythe test";
    if first.len().min(second.len()) < 3 {
        return None;
    }
    let count = (first.len() + second.len()) as f64;
    let (of_first, of_second) = (deviations(first)?, deviations(second)?);
    let distance = of_first.mean - of_second.mean;
    let between = of_first.count * of_second.count / count * distance * distance;
    let within = of_first.squares + of_second.squares;
    let unit = ROUNDING * first.iter().chain(second).fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let negligible = count * unit * unit;
    let p = if between <= negligible {
        1.0
    } else if within <= negligible {
        0.0
    } else {
        FisherSnedecor::new(1.0, count - 2.0).ok()?.sf(between / (within / (count - 2.0)))
    };
    Some(Test::new(NAME, p))
}

/// The moments of the absolute deviations from the median; `None` of none.
fn deviations(sample: &[f64]) -> Option<Moments> {
    let median = Summary::of(sample.iter().copied())?.median;
    Some(moments(sample.iter().map(|x| (x - median).abs())))
}

/// Fisher's exact test (1935) of two independent counts, each [successes, failures], two-sided: p is the probability of all
/// tables with the same margins that are at most as probable as the one found. An empty group has p = 1.
pub fn fisher(first: [u64; 2], second: [u64; 2]) -> Test {
    let (of_first, of_second, successes) = (first[0] + first[1], second[0] + second[1], first[0] + second[0]);
    // The possible numbers of successes of the first group.
    let (low, high) = (successes.saturating_sub(of_second), of_first.min(successes));
    let (n, m, k) = (of_first as f64, of_second as f64, successes as f64);
    let mode = ((k + 1.0) * (n + 1.0) / (n + m + 2.0)) as u64;
    let probabilities = relative_probabilities((high - low) as usize, (mode.clamp(low, high) - low) as usize, |index| {
        let x = index as f64 + low as f64;
        (n - x) * (k - x) / ((x + 1.0) * (m - k + x + 1.0))
    });
    let limit = probabilities[(first[0] - low) as usize] * (1.0 + EQUALLY_PROBABLE);
    let extreme: f64 = probabilities.iter().filter(|&&probability| probability <= limit).sum();
    Test::new("Fisher's exact test", extreme / probabilities.iter().sum::<f64>())
}

/// McNemar's test (1947) of paired yes-or-no results in its exact, binomial form, two-sided. It takes the numbers of pairs
/// in which only the first and only the second is a yes; without such pairs p = 1.
pub fn mcnemar(only_first: u64, only_second: u64) -> Test {
    let pairs = only_first + only_second;
    let probabilities = relative_probabilities(pairs as usize, (pairs / 2) as usize, |x| (pairs as f64 - x as f64) / (x as f64 + 1.0));
    let tail: f64 = probabilities[..=only_first.min(only_second) as usize].iter().sum();
    Test::new("exact McNemar test", 2.0 * tail / probabilities.iter().sum::<f64>())
}

/// The probabilities of 0, …, `last`, divided by that of `mode`, the most probable number, so that none overflows.
/// `ratio(x)` is the probability of x + 1 divided by that of x.
fn relative_probabilities(last: usize, mode: usize, ratio: impl Fn(usize) -> f64) -> Vec<f64> {
    let mut probabilities = vec![1.0; last + 1];
    (mode..last).for_each(|x| probabilities[x + 1] = probabilities[x] * ratio(x));
    (0..mode).rev().for_each(|x| probabilities[x] = probabilities[x + 1] / ratio(x));
    probabilities
}

/// Page's trend test (1963) of the prediction that the columns increase from left to right, one-sided. Each block holds one
/// number per column. `None` without blocks, with fewer than three columns, or if the blocks differ in length.
///
/// Equal numbers of a block share their average rank. p is the normal approximation without continuity correction. The
/// variance is that of all permutations of the ranks within blocks; without ties it is Page's. If all blocks are constant,
/// p = 1.
pub fn page(blocks: &[Vec<f64>]) -> Option<Test> {
    const NAME: &str = "Page's trend test";
    let columns = blocks.first()?.len();
    if columns < 3 || blocks.iter().any(|block| block.len() != columns) {
        return None;
    }
    let k = columns as f64;
    let middle = f64::midpoint(k, 1.0);
    // L less its expected value, Σ (column − middle) (rank − middle), and its variance.
    let (mut excess, mut squares) = (0.0, 0.0);
    for block in blocks {
        for (column, rank) in average_ranks(block.iter().copied()).into_iter().enumerate() {
            excess += (column as f64 + 1.0 - middle) * (rank - middle);
            squares += (rank - middle) * (rank - middle);
        }
    }
    let variance = squares * k * (k + 1.0) / 12.0;
    Some(Test::new(NAME, if variance > 0.0 { Normal::standard().sf(excess / variance.sqrt()) } else { 1.0 }))
}

/// The log-rank test (Mantel 1966) of two samples of times, two-sided; `None` if one is empty.
///
/// Each time comes with whether the event was reached then; `false` means that it was not reached by that time (censored).
/// A run censored at the time of an event is still at risk then. Without events p = 1.
pub fn log_rank(first: &[(f64, bool)], second: &[(f64, bool)]) -> Option<Test> {
    const NAME: &str = "log-rank test";
    if first.is_empty() || second.is_empty() {
        return None;
    }
    let reached: Vec<bool> = first.iter().chain(second).map(|&(_, reached)| reached).collect();
    let times = math::ordered(first.iter().chain(second).map(|&(time, _)| time));
    let (mut first_at_risk, mut at_risk) = (first.len() as f64, times.len() as f64);
    // Events of the first sample less their expected number, and the variance of that.
    let (mut excess, mut variance) = (0.0, 0.0);
    for same in times.chunk_by(|a, b| a.0 == b.0) {
        let count = |is_counted: &dyn Fn(usize) -> bool| same.iter().filter(|(_, place)| is_counted(*place)).count() as f64;
        let events = count(&|place| reached[place]);
        let share = first_at_risk / at_risk;
        excess += count(&|place| reached[place] && place < first.len()) - events * first_at_risk / at_risk;
        if at_risk > 1.0 {
            variance += events * share * (1.0 - share) * (at_risk - events) / (at_risk - 1.0);
        }
        first_at_risk -= count(&|place| place < first.len());
        at_risk -= same.len() as f64;
    }
    Some(Test::new(NAME, if variance > 0.0 { two_sided(excess / variance.sqrt()) } else { 1.0 }))
}

/// Vargha and Delaney's A (2000): the share of pairs in which the number of the first sample is the smaller one. Ties count
/// half. It is 0.5 if a sample is empty.
pub fn superiority(first: &[f64], second: &[f64]) -> f64 {
    rank_sum(first, second).map_or(0.5, |test| test.smaller)
}

/// The relative difference of the means, (mean of the first − mean of the second) / |mean of the second|, in per cent, with
/// the 95 % percentile interval of 2,000 bootstrap resamples (Efron 1979). `None` if a sample is empty or the mean of the
/// second is 0.
///
/// The two samples are resampled independently, by a generator that `seed` determines. The ends of the interval are the 50th
/// smallest and the 50th largest difference. A resample whose second mean is 0 counts as infinite, unless both means are 0;
/// an end is infinite only if there are at least 50 of these.
pub fn mean_difference(first: &[f64], second: &[f64], seed: u64) -> Option<Interval> {
    let mean = |sample: &[f64]| moments(sample.iter().copied()).mean;
    let base = mean(second);
    if first.is_empty() || second.is_empty() || base == 0.0 {
        return None;
    }
    let mut stream = Stream::new(seed, 0);
    let [low, high] =
        central(|| relative_difference(resampled_mean(first, first.len(), &mut stream), resampled_mean(second, second.len(), &mut stream)));
    Some(Interval { value: relative_difference(mean(first), base), low, high })
}

/// The 95 % percentile interval of the mean of `count` numbers of a sample, drawn with replacement 2,000 times by a generator
/// that `seed` determines; NaN of an empty sample.
pub fn mean_of(sample: &[f64], count: usize, seed: u64) -> [f64; 2] {
    if sample.is_empty() {
        return [f64::NAN; 2];
    }
    let mut stream = Stream::new(seed, 0);
    central(|| resampled_mean(sample, count, &mut stream))
}

/// The same of the standard deviation (with n − 1) of a sample; NaN of fewer than two numbers.
pub fn std_of(sample: &[f64], seed: u64) -> [f64; 2] {
    if sample.len() < 2 {
        return [f64::NAN; 2];
    }
    let mut stream = Stream::new(seed, 0);
    let mut draw = || moments((0..sample.len()).map(|_| sample[stream.below(sample.len())])).std().unwrap_or(f64::NAN);
    central(&mut draw)
}

/// The ends of the middle 95 % of so many draws.
fn central(draw: impl FnMut() -> f64) -> [f64; 2] {
    let mut draws: Vec<f64> = iter::repeat_with(draw).take(RESAMPLES).collect();
    math::sort_numbers(&mut draws);
    let outside = (RESAMPLES as f64 * (1.0 - CONFIDENCE) / 2.0).round() as usize;
    [draws[outside - 1], draws[RESAMPLES - outside]]
}

fn resampled_mean(sample: &[f64], count: usize, stream: &mut Stream) -> f64 {
    moments((0..count).map(|_| sample[stream.below(sample.len())])).mean
}

/// In per cent of the absolute value of the second; infinite only if that is 0 and the first is not.
fn relative_difference(first: f64, second: f64) -> f64 {
    let difference = first - second;
    if difference == 0.0 { 0.0 } else { 100.0 * difference / second.abs() }
}

fn moments(numbers: impl Iterator<Item = f64>) -> Moments {
    numbers.fold(Moments::default(), Moments::with)
}

/// The numbers' ranks from 1. Equal numbers share the average of their ranks.
fn average_ranks(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    Data::new(numbers.collect::<Vec<_>>()).ranks(RankTieBreaker::Average)
}

/// How probable it is that a standard normal number is at least as far from 0.
fn two_sided(z: f64) -> f64 {
    2.0 * Normal::standard().sf(z.abs())
}
