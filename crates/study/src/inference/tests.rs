//! The tests against hand-computed values, closed forms, R and SciPy.

use forage::statistics::{holm, proportion};

use super::*;

/// Equal to within a relative error of 1e-10.
#[track_caller]
fn assert_close(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-10 * expected.abs(), "{value} is not {expected}");
}

/// Samples of all sizes from 3 to 12, with ties and with different spread.
fn samples() -> Vec<[Vec<f64>; 2]> {
    let sample = |n: u64, factor: u64, scale: f64| (0..n).map(|i| (i * factor % 7) as f64 * scale).collect::<Vec<_>>();
    (3..13).map(|n| [sample(n, 3, 1.0), sample(15 - n, 5, 2.5)]).collect()
}

/// Times "9 13+": censored with a plus sign, as R prints them.
fn times(text: &str) -> Vec<(f64, bool)> {
    text.split(' ').map(|time| (time.trim_end_matches('+').parse().unwrap(), !time.ends_with('+'))).collect()
}

/// The example of R's help page of `wilcox.test`, depression scores (V = 40; its one-sided p is 0.01953), and Darwin's plants
/// in SciPy's of `wilcoxon`. Of all choices of signs, 20 of 512 and 1352 of 32768 are as extreme.
#[test]
fn signed_ranks_agree_with_all_choices_of_signs() {
    let differences = [0.952, -0.147, 1.022, 0.43, 0.62, 0.59, 0.49, -0.08, 0.01];
    assert_eq!(signed_rank(&differences).unwrap().p, 20.0 / 512.0);
    let plants = [6.0, 8.0, 14.0, 16.0, 23.0, 24.0, 28.0, 29.0, 41.0, -48.0, 49.0, 56.0, 60.0, -67.0, 75.0];
    assert_eq!(signed_rank(&plants).unwrap().p, 1352.0 / 32_768.0);
}

/// Ties: the ranks 1.5 (twice), 3.5 (twice), 6 (three times), 8, ..., 11 less −3.5 of −2 have the positive sum
/// 66 − 3.5 − 8 = 54.5, the mean 33 and the variance Σ rank² / 4 = 125.75; p = erfc(21 / √125.75 / √2).
/// Many: 1, ..., 30, of which 4, 8, ..., 28 (sum 112) are negative: 465 − 112 = 353, mean 232.5,
/// variance 30 · 31 · 61 / 24 = 2363.75; p = erfc(120 / √2363.75 / √2).
#[test]
fn ties_and_many_differences_are_tested_by_the_normal_approximation() {
    let ties = [1.0, 1.0, -2.0, 2.0, 3.0, 3.0, 3.0, -4.0, 5.0, 6.0, 7.0, 0.0];
    assert_close(signed_rank(&ties).unwrap().p, 0.061_111_558_675_362_82);
    let many: Vec<f64> = (1..=30).map(|i| if i % 4 == 0 { -f64::from(i) } else { f64::from(i) }).collect();
    assert_close(signed_rank(&many).unwrap().p, 0.013_579_415_038_448_952);
}

/// 1, ..., 25, of which 3, 6, ..., 24 (sum 108) are negative: 4982148 of 2^25 choices of signs are as extreme. The normal
/// approximation, which goes on from there, is 0.1462.
#[test]
fn many_untied_differences_are_tested_exactly() {
    let differences: Vec<f64> = (1..=25).map(|i| if i % 3 == 0 { -f64::from(i) } else { f64::from(i) }).collect();
    assert_eq!(signed_rank(&differences).unwrap().p, 4_982_148.0 / 33_554_432.0);
}

#[test]
fn few_differences_are_never_significant() {
    for n in 1..=5_i32 {
        let smallest = 2.0 / f64::from(1 << n);
        assert_eq!(signed_rank(&(1..=n).map(f64::from).collect::<Vec<_>>()).unwrap().p, smallest);
        assert_eq!(signed_rank(&vec![-2.0; n as usize]).unwrap().p, smallest);
    }
    assert_eq!(signed_rank(&[]), None);
    assert_eq!(signed_rank(&[0.0, -0.0]).unwrap().p, 1.0);
    assert_eq!(signed_rank(&[1.0, -1.0, 0.0]).unwrap().p, 1.0);
    assert_eq!(signed_rank(&[1.0, -1.0].repeat(20)).unwrap().p, 1.0);
}

/// Deviations 1, 0, 4 and 10, 0, 40: means 5/3 and 50/3, between 337.5, within 26/3 + 2600/3, F(1, 4) = 2025/1313. Student's t with
/// 4 degrees of freedom has the closed form P(|T| > t) = 1 − sin θ (1 + cos² θ / 2), tan θ = t / 2, t² = F.
/// In the same way F(1, 8) = 8664/1385 of the second pair, with 1 − sin θ (1 + c / 2 + 3 c² / 8 + 5 c³ / 16), c = cos² θ,
/// and F(1, 7) = 3844/873 of the third, with the closed form of odd degrees of freedom.
#[test]
fn spreads_agree_with_closed_forms() {
    let p = |first: &[f64], second: &[f64]| brown_forsythe(first, second).unwrap().p;
    assert_close(p(&[0.0, 1.0, 5.0], &[10.0, 20.0, 60.0]), 0.282_121_857_446_013_26);
    assert_close(p(&[5.0, 6.0, 7.0, 8.0], &[1.0, 4.0, 9.0, 16.0, 25.0, 36.0]), 0.036_877_688_640_551_52);
    assert_close(p(&[5.0, 6.0, 7.0, 8.0], &[1.0, 4.0, 9.0, 16.0, 25.0]), 0.074_047_883_995_142_84);
}

#[test]
fn spreads_without_a_difference_or_without_variance() {
    let p = |first: &[f64], second: &[f64]| brown_forsythe(first, second).map(|test| test.p);
    assert_eq!(p(&[0.1; 5], &[0.3; 7]), Some(1.0));
    assert_eq!(p(&[1.0, 2.0, 4.0], &[101.0, 102.0, 104.0]), Some(1.0));
    // 0.1 + 0.2 is not 0.3: the spreads differ by rounding alone.
    assert_eq!(p(&[0.1 + 0.2, 0.3, 0.3, 0.1 + 0.2], &[0.3; 4]), Some(1.0));
    assert_eq!(p(&[0.0, 0.0, 2.0, 2.0], &[5.0; 4]), Some(0.0));
    assert_eq!(p(&[], &[1.0, 2.0, 3.0]), None);
    assert_eq!(p(&[1.0, 2.0, 3.0], &[1.0, 2.0]), None);
}

/// 34 of 70 tables: Fisher's tea. R's help page of `fisher.test` has the convictions of twins, SciPy's of `fisher_exact`
/// [[8, 2], [1, 5]] with 0.034965034965034975; the fractions are sums of products of binomial coefficients, and so are the last two.
#[test]
fn counts_agree_with_sums_of_binomial_coefficients() {
    assert_close(fisher([3, 1], [1, 3]).p, 34.0 / 70.0);
    assert_close(fisher([8, 2], [1, 5]).p, 5.0 / 143.0);
    assert_close(fisher([10, 2], [3, 15]).p, 3571.0 / 6_653_325.0);
    assert_close(fisher([30, 0], [12, 18]).p, 13.0 / 69_516_337.0);
    assert_close(fisher([0, 30], [30, 0]).p, 1.0 / 59_132_290_782_430_712.0);
    assert_close(fisher([60, 40], [30, 70]).p, 3.304_592_989_272_318_6e-5);
    assert_close(fisher([500, 500], [450, 550]).p, 0.028_203_568_904_234_012);
}

#[test]
fn counts_without_a_difference() {
    for (first, second) in [([0, 0], [0, 0]), ([0, 0], [3, 4]), ([5, 0], [9, 0]), ([0, 5], [0, 9]), ([7, 3], [7, 3]), ([70, 30], [7, 3])] {
        assert_eq!(fisher(first, second).p, 1.0, "{first:?} {second:?}");
    }
    assert!(fisher([0, 5_000], [5_000, 0]).p < 1e-300);
}

/// 2 (1 + 10) / 1024, 2 / 32, and sums of binomial coefficients in whole numbers. (86, 150) is R's example of
/// `mcnemar.test`, the approval of a president.
#[test]
fn paired_counts_agree_with_sums_of_binomial_coefficients() {
    assert_close(mcnemar(1, 9).p, 22.0 / 1024.0);
    assert_close(mcnemar(0, 5).p, 2.0 / 32.0);
    assert_close(mcnemar(86, 150).p, 3.715_936_139_571_442e-5);
    assert_close(mcnemar(900, 1_100).p, 8.457_089_535_503_927e-6);
    assert_close(mcnemar(0, 1_000).p, 1.866_527_237_006_437_8e-301);
    for (only_first, only_second) in [(0, 0), (4, 5), (5, 5), (0, 1), (100_000, 100_000)] {
        assert_eq!(mcnemar(only_first, only_second).p, 1.0);
    }
}

/// Two blocks as predicted: L = 28, mean 24, variance 2 · 9 · 16 · 2 / 144 = 4, z = 2. Five blocks of four: L = 141, mean
/// 125, variance 125/3. SciPy's help page of `page_trend_test` (L = 133.5, mean 120) has ties: the variance over all
/// permutations of the ranks is 35/2, not 20 as without ties. The p-values are erfc(z / √2) / 2.
#[test]
fn trends_agree_with_all_permutations() {
    let p = |blocks: &[&[f64]]| page(&blocks.iter().map(|block| block.to_vec()).collect::<Vec<_>>()).unwrap().p;
    assert_close(p(&[&[1.0, 2.0, 3.0], &[10.0, 20.0, 30.0]]), 0.022_750_131_948_179_22);
    assert_close(p(&[&[3.0, 2.0, 1.0], &[3.0, 2.0, 1.0]]), 0.977_249_868_051_820_8);
    let four: [&[f64]; 5] =
        [&[1.0, 3.0, 2.0, 4.0], &[1.0, 2.0, 3.0, 4.0], &[2.0, 1.0, 3.0, 4.0], &[1.0, 2.0, 4.0, 3.0], &[4.0, 1.0, 2.0, 3.0]];
    assert_close(p(&four), 0.006_592_935_425_732_919);
    let ties: [&[f64]; 10] = [
        &[3.0, 4.0, 3.0],
        &[2.0, 2.0, 4.0],
        &[3.0, 3.0, 5.0],
        &[1.0, 3.0, 2.0],
        &[2.0, 3.0, 2.0],
        &[2.0, 4.0, 5.0],
        &[1.0, 2.0, 4.0],
        &[3.0, 4.0, 4.0],
        &[2.0, 4.0, 5.0],
        &[1.0, 3.0, 4.0],
    ];
    assert_close(p(&ties), 0.000_625_221_056_705_236_8);
}

#[test]
fn a_trend_needs_three_columns_of_different_numbers() {
    assert_eq!(page(&[]), None);
    assert_eq!(page(&[vec![]]), None);
    assert_eq!(page(&[vec![1.0, 2.0], vec![1.0, 2.0]]), None);
    assert_eq!(page(&[vec![1.0, 2.0, 3.0], vec![1.0, 2.0]]), None);
    assert_eq!(page(&[vec![0.1; 3], vec![0.7; 3]]).unwrap().p, 1.0);
    // A constant block says nothing.
    let blocks = [vec![1.0, 2.0, 3.0], vec![2.0, 1.0, 3.0]];
    assert_eq!(page(&[&blocks[..], &[vec![5.0; 3]]].concat()), page(&blocks));
}

/// R's `survdiff` prints chi-squared 3.4 and p = 0.0653 of its data set `aml`, and 16.8 and 4.17e-05 of `gehan`; more digits are from
/// sums of fractions. By hand, of times 1, 2 and 3, 4: one event of four, of three with one of the first, and twice none of
/// the first. Expected 1/2 + 1/3, variance 1/4 + 2/9 = 17/36.
#[test]
fn times_agree_with_r() {
    let maintained = times("9 13 13+ 18 23 28+ 31 34 45+ 48 161+");
    let not_maintained = times("5 5 8 8 12 16+ 23 27 30 33 43 45");
    assert_close(log_rank(&maintained, &not_maintained).unwrap().p, 0.065_339_322_040_504_92);
    let treated = times("6 6 6 6+ 7 9+ 10 10+ 11+ 13 16 17+ 19+ 20+ 22 23 25+ 32+ 32+ 34+ 35+");
    let control = times("1 1 2 2 3 4 4 5 5 8 8 8 8 11 11 12 12 15 17 22 23");
    assert_close(log_rank(&treated, &control).unwrap().p, 4.168_809_109_334_561e-5);
    assert_close(log_rank(&times("1 2"), &times("3 4")).unwrap().p, two_sided(7.0 / 17.0_f64.sqrt()));
    assert_close(log_rank(&times("1 2"), &times("3 4")).unwrap().p, 0.089_555_074_413_642_6);
}

#[test]
fn times_without_events_or_without_a_difference() {
    let p = |first: &str, second: &str| log_rank(&times(first), &times(second)).unwrap().p;
    assert_eq!(p("5+ 6+", "7+"), 1.0);
    assert_eq!(p("5 5 5", "5 5"), 1.0);
    assert_eq!(p("1 2 2+ 7 9+", "1 2 2+ 7 9+"), 1.0);
    // Events only after the other sample is censored.
    assert_eq!(p("1+ 2+", "3 4"), 1.0);
    assert_eq!(log_rank(&[], &times("1")), None);
    assert_eq!(log_rank(&times("1"), &[]), None);
}

/// Of the pairs of 1, 2, 3 and 2, 4 the first is smaller in 2 + 1 + 1 and tied in 1: 4.5 of 6.
#[test]
fn superiority_is_a_share_of_pairs() {
    assert_eq!(superiority(&[1.0, 2.0, 3.0], &[2.0, 4.0]), 4.5 / 6.0);
    assert_eq!(superiority(&[1.0, 2.0], &[3.0]), 1.0);
    assert_eq!(superiority(&[0.1; 4], &[0.1; 6]), 0.5);
    assert_eq!(superiority(&[f64::MAX], &[1.0, f64::MAX]), 0.25);
    assert_eq!((superiority(&[], &[1.0]), superiority(&[1.0], &[])), (0.5, 0.5));
    for [first, second] in samples() {
        let pairs = first.iter().flat_map(|x| second.iter().map(move |y| (x, y)));
        let sum: f64 = pairs.map(|(x, y)| if x < y { 1.0 } else { f64::from(u8::from(x == y)) / 2.0 }).sum();
        assert_close(superiority(&first, &second), sum / (first.len() * second.len()) as f64);
    }
}

/// Resamples of 1, 3 have the means 1, 2, 3 with the shares 1/4, 1/2, 1/4, so that the interval holds all three. If the
/// second sample is 1, 3, the means 1, 2, 3 over 1, 2, 3 lie between −2/3 and 2, which have shares of 1/16.
#[test]
fn a_bootstrap_of_two_numbers_has_the_range_of_its_means() {
    assert_eq!(mean_difference(&[1.0, 3.0], &[1.0], 1), Some(Interval { value: 100.0, low: 0.0, high: 200.0 }));
    assert_eq!(mean_difference(&[1.0, 3.0], &[-1.0], 1), Some(Interval { value: 300.0, low: 200.0, high: 400.0 }));
    let both = mean_difference(&[1.0, 3.0], &[1.0, 3.0], 1).unwrap();
    assert_eq!((both.value, both.high), (0.0, 200.0));
    assert_close(both.low, -200.0 / 3.0);
    // A quarter of the resamples of 0, 1 has the mean 0.
    assert_eq!(mean_difference(&[2.0], &[0.0, 1.0], 1), Some(Interval { value: 300.0, low: 100.0, high: f64::INFINITY }));
}

#[test]
fn a_bootstrap_without_spread_or_without_a_base() {
    assert_eq!(mean_difference(&[0.1; 3], &[0.1; 7], 4), Some(Interval { value: 0.0, low: 0.0, high: 0.0 }));
    assert_eq!(mean_difference(&[3.0], &[2.0], 4), Some(Interval { value: 50.0, low: 50.0, high: 50.0 }));
    assert_eq!(mean_difference(&[], &[2.0], 4), None);
    assert_eq!(mean_difference(&[2.0], &[], 4), None);
    assert_eq!(mean_difference(&[2.0], &[-1.0, 1.0], 4), None);
}

/// The mean of 0, ..., 99 is 49.5, its standard error √(833.25 / 100) without Bessel's correction, as the bootstrap has it:
/// ± 1.96 standard errors are ± 11.43 % of 49.5. The second sample has no spread.
#[test]
fn a_bootstrap_of_many_numbers_is_nearly_normal_and_repeatable() {
    let first: Vec<f64> = (0..100).map(f64::from).collect();
    for seed in 0..5 {
        let found = mean_difference(&first, &[49.5], seed).unwrap();
        assert_eq!(found.value, 0.0);
        assert!((found.high - 11.43).abs() < 1.2 && (found.low + 11.43).abs() < 1.2, "{found:?}");
        assert_eq!(mean_difference(&first, &[49.5], seed).unwrap(), found);
    }
    assert_ne!(mean_difference(&first, &[49.5], 0), mean_difference(&first, &[49.5], 1));
}

#[test]
fn two_sided_tests_do_not_depend_on_the_order_of_the_samples() {
    for [first, second] in samples() {
        let negated: Vec<f64> = first.iter().map(|x| 4.0 - x).collect();
        let differences: Vec<f64> = first.iter().map(|x| x - 4.0).collect();
        assert_eq!(signed_rank(&differences), signed_rank(&negated));
        assert_close(brown_forsythe(&first, &second).unwrap().p, brown_forsythe(&second, &first).unwrap().p);
        let timed = |sample: &[f64]| sample.iter().map(|&x| (x, x % 2.0 < 1.5)).collect::<Vec<_>>();
        let (one, other) = (timed(&first), timed(&second));
        assert_close(log_rank(&one, &other).unwrap().p, log_rank(&other, &one).unwrap().p);
        assert_close(superiority(&first, &second), 1.0 - superiority(&second, &first));
    }
    for a in 0..12 {
        for b in 0..9 {
            assert_eq!(mcnemar(a, b), mcnemar(b, a));
            // Swapped groups, and failures for successes.
            let p = fisher([a, 11 - a], [b, 8 - b]).p;
            assert_close(fisher([b, 8 - b], [a, 11 - a]).p, p);
            assert_close(fisher([11 - a, a], [8 - b, b]).p, p);
        }
    }
}

#[test]
fn p_values_are_never_above_1_nor_nan() {
    for [first, second] in samples() {
        let blocks: Vec<Vec<f64>> = first.iter().map(|&x| vec![x, 3.0, second[0], 2.0]).collect();
        let timed = |sample: &[f64]| sample.iter().map(|&x| (x, x > 1.0)).collect::<Vec<_>>();
        let tests = [signed_rank(&first), brown_forsythe(&first, &second), page(&blocks), log_rank(&timed(&first), &timed(&second))];
        for test in tests.map(Option::unwrap) {
            assert!((0.0..=1.0).contains(&test.p), "{test:?}");
        }
    }
}

/// Wilson's interval of 5 of 10, with z² = 3.8414588: 0.5 ± z / (1 + z² / 10) · √(0.025 + z² / 400) = 0.5 ± 0.2634.
#[test]
fn the_interval_of_a_share_is_wilsons() {
    let [low, high] = proportion(5, 10).unwrap();
    assert!((low - 0.2366).abs() < 1e-4 && (high - 0.7634).abs() < 1e-4, "{low} {high}");
    assert_eq!(holm(&[0.01, 0.04, 0.03]), [0.03, 0.06, 0.06]);
}

/// Of 1 and 3: single numbers are 1 or 3, and the mean of many is 2.
#[test]
fn the_mean_of_numbers_drawn_again_has_an_interval() {
    assert_eq!(mean_of(&[1.0, 3.0], 1, 1), [1.0, 3.0]);
    let [low, high] = mean_of(&[1.0, 3.0], 10_000, 1);
    assert!(1.97 < low && low < 2.0 && 2.0 < high && high < 2.03, "{low} {high}");
    assert!(mean_of(&[], 3, 1)[0].is_nan());
}
