//! Tests between samples.

use std::cmp::Ordering;

use serde::Serialize;
use statrs::distribution::{ChiSquared, ContinuousCDF, Normal};

use super::critical::critical_difference;

/// A sample of up to so many without ties is tested exactly, as SciPy does,
const FEW: usize = 8;
/// unless the other is so large that the approximation is as good.
const MANY: usize = 1000;

/// The result of Wilcoxon's rank-sum test of two samples.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RankSum {
    /// Mann and Whitney's U of the first sample.
    pub u: f64,
    /// The p-value, two-sided: exact for a sample of up to 8 without ties, otherwise by the normal approximation with
    /// corrections for ties and continuity.
    pub p: f64,
    /// The probability that a number of the first sample is smaller than one of the second; ties count half.
    pub smaller: f64,
}

/// Wilcoxon's rank-sum test, two-sided; `None` if a sample is empty or holds a NaN.
pub fn rank_sum(first: &[f64], second: &[f64]) -> Option<RankSum> {
    let pairs = first.len() as f64 * second.len() as f64;
    let all = crate::math::ordered(first.iter().chain(second).copied());
    if pairs == 0.0 || all.iter().any(|(x, _)| x.is_nan()) {
        return None;
    }
    let (u, approximate) = approximate(first.len(), second.len(), &all);
    let p = if all[0].0 == all[all.len() - 1].0 {
        // There is no spread to measure a difference by.
        1.0
    } else if first.len().min(second.len()) <= FEW
        && first.len().max(second.len()) <= MANY
        && all.windows(2).all(|two| two[0].0 != two[1].0)
    {
        exact(u, first.len(), second.len())
    } else {
        approximate
    };
    Some(RankSum { u, p, smaller: (pairs - u) / pairs })
}

/// U of the first and the approximate p-value, from the runs of equal numbers in the sorted samples. By hand: `statrs` compares
/// every pair of them.
fn approximate(first: usize, second: usize, all: &[(f64, usize)]) -> (f64, f64) {
    let (mut before, mut sum, mut ties) = (0.0, 0.0, 0.0);
    for run in all.chunk_by(|a, b| a.0 == b.0) {
        let (length, of_first) = (run.len() as f64, run.iter().filter(|(_, place)| *place < first).count() as f64);
        sum += of_first * (before + f64::midpoint(length, 1.0));
        ties += length * length * length - length;
        before += length;
    }
    let (n, m, all) = (first as f64, second as f64, before);
    let u = sum - n * (n + 1.0) / 2.0;
    let spread = (n * m / 12.0 * (all + 1.0 - ties / (all * (all - 1.0)))).sqrt();
    let z = (u.max(n * m - u) - n * m / 2.0 - 0.5) / spread;
    (u, (2.0 * Normal::standard().sf(z)).min(1.0))
}

/// The exact p-value of U without ties. By hand: `statrs` 0.19 gives the complement when the first sample is the smaller one,
/// and goes through all subsets one by one, which takes days for 8 of 50.
///
/// How many ways there are to each U are the coefficients of the Gaussian binomial Π (1 − q^(n + i)) / (1 − q^i).
fn exact(u: f64, first: usize, second: usize) -> f64 {
    let (m, n) = (first.min(second), first.max(second));
    let mut ways = vec![0.0; m * n + 1];
    ways[0] = 1.0;
    for i in 1..=m {
        (n + i..ways.len()).rev().for_each(|k| ways[k] -= ways[k - n - i]);
        (i..ways.len()).for_each(|k| ways[k] += ways[k - i]);
    }
    // The shorter tail, which begins with the small counts that are exact: there are as many ways to U as to m n − U.
    let smaller = u.min((m * n) as f64 - u) as usize;
    let share = ways[..=smaller].iter().sum::<f64>() / ways.iter().sum::<f64>();
    (2.0 * share).min(1.0)
}

/// Holm's correction of p-values for their number, in their order.
pub fn holm(p: &[f64]) -> Vec<f64> {
    let mut corrected = vec![0.0; p.len()];
    let mut largest = 0.0_f64;
    for (rank, (_, k)) in crate::math::ordered(p.iter().copied()).into_iter().enumerate() {
        largest = largest.max((p[k] * (p.len() - rank) as f64).min(1.0));
        corrected[k] = largest;
    }
    corrected
}

/// The result of Friedman's test of treatments that were tried on the same blocks.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Friedman {
    /// The number of blocks.
    pub blocks: usize,
    /// Each treatment's mean rank over the blocks; 1 is best. Equal numbers share their ranks.
    pub ranks: Vec<f64>,
    /// χ² corrected for ties, with one degree of freedom fewer than treatments. `None` for fewer than three treatments, or
    /// if all blocks are ties.
    pub statistic: Option<f64>,
    /// The p-value; `None` without a statistic.
    pub p: Option<f64>,
    /// How far apart two mean ranks must be to differ at the 5 % level, by Nemenyi's test; `None` for fewer than two treatments.
    pub critical_difference: Option<f64>,
}

/// Friedman's test. `blocks` holds the treatments' numbers block by block, smaller is better; `None` without blocks, if they
/// differ in length, or with a NaN.
pub fn friedman(blocks: &[Vec<f64>]) -> Option<Friedman> {
    let (n, k) = (blocks.len() as f64, blocks.first()?.len());
    if k == 0 || blocks.iter().any(|block| block.len() != k || block.iter().any(|x| x.is_nan())) {
        return None;
    }
    let (mut sums, mut ties) = (vec![0.0; k], 0.0);
    for block in blocks {
        for (sum, x) in sums.iter_mut().zip(block) {
            let count = |order| block.iter().filter(|y| y.partial_cmp(&x) == Some(order)).count() as f64;
            let (smaller, equal) = (count(Ordering::Less), count(Ordering::Equal));
            *sum += smaller + f64::midpoint(equal, 1.0);
            ties += equal * equal - 1.0;
        }
    }
    let k_ = k as f64;
    let raw = 12.0 / (n * k_ * (k_ + 1.0)) * sums.iter().map(|sum| sum * sum).sum::<f64>() - 3.0 * n * (k_ + 1.0);
    let left = 1.0 - ties / (n * k_ * (k_ * k_ - 1.0));
    let statistic = (k >= 3 && left > 0.0).then(|| (raw / left).max(0.0));
    let p = statistic.and_then(|statistic| Some(ChiSquared::new(k_ - 1.0).ok()?.sf(statistic)));
    let critical_difference = critical_difference(k, blocks.len());
    Some(Friedman { blocks: blocks.len(), ranks: sums.iter().map(|sum| sum / n).collect(), statistic, p, critical_difference })
}

#[cfg(test)]
mod tests {
    use statrs::stats_tests::{
        Alternative,
        mannwhitneyu::{MannWhitneyUMethod, mannwhitneyu},
    };

    use super::*;

    #[test]
    fn it_says_what_statrs_says() {
        // Whole numbers with ties, the second sample a little larger, and some failed runs.
        let sample = |n: u64, shift: u64| -> Vec<f64> {
            (0..n).map(|i| if i % 41 == 0 { f64::MAX } else { (i * 7919 % 257 + shift) as f64 }).collect()
        };
        for (n, m, shift) in [(300, 200, 0), (200, 300, 9), (400, 400, 3), (50, 700, 30)] {
            let (first, second) = (sample(n, 0), sample(m, shift));
            let method = MannWhitneyUMethod::AsymptoticInclContinuityCorrection;
            let (u, p) = mannwhitneyu(&first, &second, method, Alternative::TwoSided).unwrap();
            let found = rank_sum(&first, &second).unwrap();
            assert_eq!(found.u, u);
            assert!((found.p - p).abs() < 1e-12, "{} instead of {p}", found.p);
        }
        assert_eq!(rank_sum(&[1.0, f64::NAN], &[2.0]), None);
        assert_eq!(rank_sum(&[], &[2.0]), None);
        let both = [sample(100_000, 0), sample(100_000, 3)];
        assert!(rank_sum(&both[0], &both[1]).unwrap().p < 1e-10);
    }
}
