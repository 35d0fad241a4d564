//! Statistics against SciPy's and NumPy's, which are stored with the command that made them.

use forage::statistics::{self, Group, Summary, compare};
use serde_json::Value;

fn stored() -> Value {
    serde_json::from_str(include_str!("statistics/scipy.json")).unwrap()
}

fn list<'a>(value: &'a Value, name: &str) -> &'a [Value] {
    value[name].as_array().unwrap()
}

/// null stands for an infinite number.
fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap_or(f64::INFINITY)).collect()
}

fn agrees(found: f64, expected: &Value, digits: f64, what: &str) {
    let expected = expected.as_f64().unwrap();
    let scale = expected.abs().max(f64::MIN_POSITIVE);
    assert!((found - expected).abs() <= digits * scale, "{what}: {found} instead of {expected}");
}

#[test]
fn summaries_agree_with_numpy_and_scipy() {
    for case in list(&stored(), "summaries") {
        let what = |part: &str| format!("{}, {part}", case["name"]);
        let found = Summary::of(numbers(&case["values"])).unwrap();
        let parts = [("mean", found.mean), ("min", found.min), ("lower", found.lower), ("median", found.median)];
        for (part, number) in parts.into_iter().chain([("upper", found.upper), ("max", found.max), ("std", found.std.unwrap())]) {
            agrees(number, &case[part], 1e-12, &what(part));
        }
        let interval = found.interval.unwrap();
        // The interval's ends may nearly cancel: as exact as its width.
        for (end, expected) in interval.into_iter().zip(numbers(&case["interval"])) {
            // No mean of values that are not negative is.
            let expected = if found.min < 0.0 { expected } else { expected.max(0.0) };
            let scale = found.mean.abs() + (interval[1] - interval[0]);
            assert!((end - expected).abs() <= 1e-10 * scale, "{}: {end} instead of {expected}", what("interval"));
        }
    }
}

#[test]
fn rank_sums_agree_with_scipy_with_ties_without_and_with_failed_runs() {
    for (k, case) in list(&stored(), "rank_sums").iter().enumerate() {
        let found = statistics::rank_sum(&numbers(&case["first"]), &numbers(&case["second"])).unwrap();
        agrees(found.u, &case["u"], 1e-12, &format!("U of {k}"));
        let p = case["p"].as_f64().unwrap();
        assert!((found.p - p).abs() <= 1e-9 * p, "p of {k}: {} instead of {p}", found.p);
    }
}

#[test]
fn samples_without_any_difference_have_a_p_of_one() {
    let found = statistics::rank_sum(&[2.5; 12], &[2.5; 9]).unwrap();
    assert_eq!((found.p, found.smaller), (1.0, 0.5));
    assert_eq!(statistics::rank_sum(&[], &[1.0]), None);
    // What is no number cannot be ranked.
    assert_eq!(statistics::rank_sum(&[f64::NAN], &[1.0]), None);
    assert_eq!(statistics::friedman(&[vec![1.0, f64::NAN, 2.0]]), None);
}

#[test]
fn corrections_agree_with_their_definition() {
    for case in list(&stored(), "holm") {
        for (found, expected) in statistics::holm(&numbers(&case["p"])).into_iter().zip(list(case, "corrected")) {
            agrees(found, expected, 1e-12, "corrected");
        }
    }
}

#[test]
fn rank_tables_agree_with_scipy() {
    for case in list(&stored(), "friedman") {
        let blocks: Vec<_> = list(case, "blocks").iter().map(numbers).collect();
        let found = statistics::friedman(&blocks).unwrap();
        assert_eq!(found.blocks, blocks.len());
        agrees(found.statistic.unwrap(), &case["statistic"], 1e-9, "statistic");
        agrees(found.p.unwrap(), &case["p"], 1e-9, "p");
        for (rank, expected) in found.ranks.into_iter().zip(list(case, "ranks")) {
            agrees(rank, expected, 1e-12, "rank");
        }
    }
}

#[test]
fn shares_have_wilsons_interval() {
    for case in list(&stored(), "wilson") {
        let count = |name: &str| case[name].as_u64().unwrap() as usize;
        let found = statistics::proportion(count("successes"), count("count")).unwrap();
        for (end, expected) in found.into_iter().zip(numbers(&case["interval"])) {
            assert!((end - expected).abs() < 1e-12, "{end} instead of {expected}");
        }
    }
}

#[test]
fn a_comparison_ranks_failed_runs_last_and_leaves_them_out_of_the_mean() {
    let group = |name: &str, values: &[Option<f64>]| Group::new(name, values.to_vec());
    let groups = [
        group("good", &[Some(1.0), Some(2.0), Some(3.0)]),
        group("often", &[Some(1.5), None, Some(2.5)]),
        group("never", &[None, None, None]),
    ];
    let found = compare(&groups);
    assert_eq!(found.groups.iter().map(|group| group.feasible).collect::<Vec<_>>(), [3, 2, 0]);
    assert_eq!(found.groups[1].summary.unwrap().mean, 2.0);
    assert!(found.groups[2].summary.is_none());
    assert_eq!(found.pairs.iter().map(|pair| [pair.first, pair.second]).collect::<Vec<_>>(), [[0, 1], [0, 2], [1, 2]]);
    // 1 < 1.5, 2.5, failed; 2 < 2.5, failed; 3 < failed: 6 of 9.
    assert_eq!((found.pairs[0].better, found.pairs[1].better), (6.0 / 9.0, 1.0));
    let ranks = found.friedman.unwrap();
    // Seed by seed: 1 2 3, then 1 and two failed, then 2 1 3.
    assert_eq!(ranks.ranks, [4.0 / 3.0, 5.5 / 3.0, 8.5 / 3.0].map(Some));
    assert!(compare(&groups[..1]).friedman.is_none() && compare(&[]).groups.is_empty());
}

/// Ten paths of one length, summed up in two orders: neither planner is better.
#[test]
fn numbers_that_differ_by_rounding_alone_are_ties() {
    let length = 42.041_630_560_342_62;
    let group = |name: &str, value: f64| Group::new(name, vec![Some(value); 10]);
    let found = compare(&[group("a", length), group("b", length + 2.0 * f64::EPSILON * 32.0)]);
    assert!(length < length + 2.0 * f64::EPSILON * 32.0);
    assert_eq!((found.pairs[0].p, found.pairs[0].better, found.friedman.unwrap().ranks), (Some(1.0), 0.5, vec![Some(1.5); 2]));
    // What differs by more is none, however small it is.
    let errors = compare(&[group("a", 1e-150), group("b", 1.1e-150)]);
    assert!(errors.pairs[0].better == 1.0 && errors.pairs[0].p.unwrap() < 1e-3);
}

#[test]
fn what_is_deterministic_takes_no_part_in_tests() {
    let values = [3.0, 1.0, 2.0, 5.0, 4.0];
    let group = |name: &str, values: [f64; 5]| Group::new(name, values.map(Some).to_vec());
    let (first, last) = (group("a", values), group("c", values.map(|value| value + 10.0)));
    let sure = Group { deterministic: true, ..group("b", [1.0; 5]) };
    let alone = compare(&[first.clone(), last.clone()]);
    let found = compare(&[first, sure, last]);
    let tested: Vec<_> = found.pairs.iter().map(|pair| (pair.first, pair.second, pair.p.is_some(), pair.corrected)).collect();
    assert_eq!(tested, [(0, 1, false, None), (0, 2, true, alone.pairs[0].p), (1, 2, false, None)]);
    assert_eq!((found.pairs[0].better, found.pairs[1].better, found.pairs[2].better), (0.1, 1.0, 1.0));
    assert_eq!(found.friedman.unwrap().ranks, [Some(1.0), None, Some(2.0)]);
}
