//! Which treatments differ by their mean ranks: Nemenyi's test, as critical-difference diagrams show it (Demšar 2006).

use statrs::distribution::{Continuous, ContinuousCDF, Normal};

use super::CONFIDENCE;

/// Steps of the integral, and how far from 0 it is taken.
const STEPS: usize = 400;
const FAR: f64 = 9.0;

/// The distribution of the range of `k` standard normal numbers: the studentised range with infinitely many degrees of freedom, by
/// Simpson's rule.
fn range_cdf(q: f64, k: usize) -> f64 {
    let normal = Normal::standard();
    let width = 2.0 * FAR / STEPS as f64;
    let at = |i: usize| {
        let z = -FAR + i as f64 * width;
        let within = (normal.cdf(z + q) - normal.cdf(z)).max(0.0);
        k as f64 * normal.pdf(z) * (1..k).map(|_| within).product::<f64>()
    };
    let weight = |i: usize| if i == 0 || i == STEPS { 1.0 } else { f64::from(2 + 2 * u8::from(i % 2 == 1)) };
    (0..=STEPS).map(|i| weight(i) * at(i)).sum::<f64>() * width / 3.0
}

/// The critical difference: how far apart two mean ranks over `blocks` must be to differ at the 5 % level, by Nemenyi's test after
/// [`friedman`](super::friedman). `None` for fewer than two treatments, or without blocks.
///
/// ```
/// use forage::statistics::critical_difference;
/// // Demšar's example: 4 classifiers on 14 data sets, 2.569 √(4 · 5 / (6 · 14)).
/// assert!((critical_difference(4, 14).unwrap() - 1.25).abs() < 0.01);
/// ```
pub fn critical_difference(treatments: usize, blocks: usize) -> Option<f64> {
    if treatments < 2 || blocks == 0 {
        return None;
    }
    let (mut low, mut high) = (0.0, 2.0 * FAR);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if range_cdf(middle, treatments) < CONFIDENCE { low = middle } else { high = middle }
    }
    let k = treatments as f64;
    // q of the studentised range is √2 times that of the test.
    Some(high / 2_f64.sqrt() * (k * (k + 1.0) / (6.0 * blocks as f64)).sqrt())
}

/// The maximal groups of treatments whose mean ranks differ by at most `difference`, two or more in each, from the best: the bars of a
/// critical-difference diagram.
///
/// ```
/// use forage::statistics::homogeneous_groups;
/// assert_eq!(homogeneous_groups(&[1.2, 3.0, 1.9, 4.9], 1.5), [vec![0, 2], vec![2, 1]]);
/// ```
pub fn homogeneous_groups(ranks: &[f64], difference: f64) -> Vec<Vec<usize>> {
    let order: Vec<usize> = crate::math::ordered(ranks.iter().copied()).into_iter().map(|(_, k)| k).collect();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut reached = 0;
    for first in 0..order.len() {
        let end = order.iter().rposition(|&k| ranks[k] - ranks[order[first]] <= difference).map_or(first, |last| last + 1);
        if end > reached && end > first + 1 {
            groups.push(order[first..end].to_vec());
            reached = end;
        }
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXPECTED: [(usize, f64); 6] = [
        (2, 1.959_963_984_540_053_4),
        (3, 2.343_700_586_378_409),
        (5, 2.727_774_370_870_376_3),
        (10, 3.163_683_577_053_373),
        (20, 3.543_799_131_517_781_5),
        (40, 3.887_627_306_808_624_4),
    ];

    /// python3 -c 'import scipy.stats as s, math; print([s.studentized_range.ppf(0.95, k, math.inf) / math.sqrt(2) for k in (2, 3, 5, 10, 20, 40)])'
    #[test]
    fn the_quantiles_agree_with_scipy() {
        for (k, expected) in EXPECTED {
            let difference = critical_difference(k, 1).unwrap();
            let found = difference / ((k * (k + 1)) as f64 / 6.0).sqrt();
            assert!((found - expected).abs() < 1e-6, "{k}: {found} instead of {expected}");
        }
        assert_eq!((critical_difference(1, 5), critical_difference(5, 0)), (None, None));
    }

    #[test]
    fn bars_join_what_does_not_differ() {
        assert_eq!(homogeneous_groups(&[1.0, 2.0, 3.0], 0.5), Vec::<Vec<usize>>::new());
        assert_eq!(homogeneous_groups(&[1.0, 2.0, 3.0], 2.0), [vec![0, 1, 2]]);
        // Within the first bar there is no smaller one.
        assert_eq!(homogeneous_groups(&[3.5, 1.0, 2.0, 2.1], 1.2), [vec![1, 2, 3]]);
        assert_eq!(homogeneous_groups(&[], 1.0), Vec::<Vec<usize>>::new());
    }
}
