//! Tests between samples.

use serde::Serialize;
use statrs::{
    distribution::{ChiSquared, ContinuousCDF},
    statistics::{Data, OrderStatistics, RankTieBreaker},
    stats_tests::{
        Alternative,
        mannwhitneyu::{MannWhitneyUMethod, mannwhitneyu},
    },
};

/// A sample of up to so many without ties is tested exactly, as SciPy does,
const FEW: usize = 8;
/// unless the other is so large that the approximation is as good.
const MANY: usize = 1000;

/// What Wilcoxon's rank-sum test says of two samples.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RankSum {
    /// Mann and Whitney's U of the first sample.
    pub u: f64,
    /// The probability of so large a difference, either way, if both came from one distribution: exact for a sample of up
    /// to 8 without ties, otherwise by the normal approximation with corrections for ties and continuity. It is one minus a
    /// share: below 1e-15 it says nothing but that it is small.
    pub p: f64,
    /// How probable it is that a number of the first is smaller than one of the second, ties counted half.
    pub smaller: f64,
}

/// Wilcoxon's rank-sum test, two-sided; `None` if a sample is empty or holds a NaN.
pub fn rank_sum(first: &[f64], second: &[f64]) -> Option<RankSum> {
    let pairs = first.len() as f64 * second.len() as f64;
    let (u, approximate) =
        mannwhitneyu(first, second, MannWhitneyUMethod::AsymptoticInclContinuityCorrection, Alternative::TwoSided).ok()?;
    let mut all: Vec<f64> = first.iter().chain(second).copied().collect();
    all.sort_by(f64::total_cmp);
    let p = if all.first() == all.last() {
        // There is no spread to measure a difference by.
        1.0
    } else if first.len().min(second.len()) <= FEW && first.len().max(second.len()) <= MANY && all.windows(2).all(|two| two[0] != two[1]) {
        exact(u, first.len(), second.len())
    } else {
        approximate
    };
    Some(RankSum { u, p, smaller: (pairs - u) / pairs })
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
    let larger = u.max((m * n) as f64 - u) as usize;
    let share = ways[larger..].iter().sum::<f64>() / ways.iter().sum::<f64>();
    (2.0 * share).min(1.0)
}

/// Holm's correction of p-values for their number, in their order.
pub fn holm(p: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by(|&a, &b| p[a].total_cmp(&p[b]));
    let mut corrected = vec![0.0; p.len()];
    let mut largest = 0.0_f64;
    for (rank, k) in order.into_iter().enumerate() {
        largest = largest.max((p[k] * (p.len() - rank) as f64).min(1.0));
        corrected[k] = largest;
    }
    corrected
}

/// What Friedman's test says of treatments that were tried on the same blocks.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Friedman {
    /// How many blocks.
    pub blocks: usize,
    /// Each treatment's mean rank over the blocks; 1 is best. Equal numbers share their ranks.
    pub ranks: Vec<f64>,
    /// χ² corrected for ties, with one degree of freedom fewer than treatments. `None` for fewer than three treatments, or
    /// if all blocks are ties.
    pub statistic: Option<f64>,
    /// The probability of so large a statistic if the treatments were alike.
    pub p: Option<f64>,
}

/// Friedman's test. `blocks` holds the treatments' numbers block by block, small ones being good; `None` without blocks, or if
/// they differ in length.
pub fn friedman(blocks: &[Vec<f64>]) -> Option<Friedman> {
    let (n, k) = (blocks.len() as f64, blocks.first()?.len());
    if k == 0 || blocks.iter().any(|block| block.len() != k) {
        return None;
    }
    let (mut sums, mut ties) = (vec![0.0; k], 0.0);
    for block in blocks {
        let ranks = Data::new(block.clone()).ranks(RankTieBreaker::Average);
        sums.iter_mut().zip(&ranks).for_each(|(sum, rank)| *sum += rank);
        ties += block.iter().map(|x| block.iter().filter(|y| *y == x).count() as f64).map(|t| t * t - 1.0).sum::<f64>();
    }
    let k_ = k as f64;
    let raw = 12.0 / (n * k_ * (k_ + 1.0)) * sums.iter().map(|sum| sum * sum).sum::<f64>() - 3.0 * n * (k_ + 1.0);
    let left = 1.0 - ties / (n * k_ * (k_ * k_ - 1.0));
    let statistic = (k >= 3 && left > 0.0).then(|| (raw / left).max(0.0));
    let p = statistic.and_then(|statistic| Some(ChiSquared::new(k_ - 1.0).ok()?.sf(statistic)));
    Some(Friedman { blocks: blocks.len(), ranks: sums.iter().map(|sum| sum / n).collect(), statistic, p })
}
