//! Comparison of planners: a summary of each, a test of each pair, a rank table.

use serde::{Deserialize, Serialize};

use super::{Friedman, Summary, friedman, holm, proportion, rank_sum};

/// The value of a failed run among ranks: more than any other, and, unlike infinity, with a difference of 0 from itself.
pub const LAST: f64 = f64::MAX;

/// Numbers nearer to each other than this share of them are the same.
const SAME: f64 = 1e-12;

/// The runs of a planner, or another group to compare.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Group {
    /// Its name.
    pub name: String,
    /// The result of each run, smaller is better; `None` without a feasible result. In all groups the same index stands for the
    /// same scene and seed.
    pub values: Vec<Option<f64>>,
}

/// The summary of a group.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct GroupSummary {
    /// Its name.
    pub name: String,
    /// The number of runs.
    pub runs: usize,
    /// The number of runs with a feasible result.
    pub feasible: usize,
    /// The feasibility rate, from 0 to 1.
    pub rate: f64,
    /// The 95 % confidence interval of `rate` (Wilson).
    pub rate_interval: [f64; 2],
    /// The summary of the feasible results; `None` if there are none.
    pub summary: Option<Summary>,
}

/// The comparison of two groups.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Pair {
    /// The index of the first group.
    pub first: usize,
    /// The index of the second group.
    pub second: usize,
    /// Mann and Whitney's U of the first group.
    pub u: f64,
    /// The p-value of Wilcoxon's rank-sum test, two-sided. Runs without a feasible result rank last.
    pub p: f64,
    /// The p-value corrected for the number of pairs (Holm).
    pub corrected: f64,
    /// The probability of superiority: that a run of the first group is better than one of the second; ties count half.
    pub better: f64,
}

/// The comparison of several groups.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Comparison {
    /// A summary of each group.
    pub groups: Vec<GroupSummary>,
    /// The comparison of each pair.
    pub pairs: Vec<Pair>,
    /// Friedman's test over scenes and seeds; `None` if the groups are not equally long, or there is only one.
    pub friedman: Option<Friedman>,
}

/// Summarises groups and tests whether they differ.
///
/// ```
/// use forage::statistics::{Group, compare};
/// let group = |name: &str, values: [f64; 5]| Group { name: name.into(), values: values.map(Some).to_vec() };
/// let found = compare(&[group("a", [1.0, 2.0, 3.0, 4.0, 5.0]), group("b", [6.0, 7.0, 8.0, 9.0, 10.0])]);
/// assert!(found.pairs[0].p < 0.01 && found.pairs[0].better == 1.0);
/// ```
pub fn compare(groups: &[Group]) -> Comparison {
    let ranked = comparable(groups.iter().map(|group| &group.values[..]));
    let mut pairs = Vec::new();
    for first in 0..groups.len() {
        for second in first + 1..groups.len() {
            if let Some(test) = rank_sum(&ranked[first], &ranked[second]) {
                pairs.push(Pair { first, second, u: test.u, p: test.p, corrected: test.p, better: test.smaller });
            }
        }
    }
    let corrected = holm(&pairs.iter().map(|pair| pair.p).collect::<Vec<_>>());
    pairs.iter_mut().zip(corrected).for_each(|(pair, p)| pair.corrected = p);
    Comparison { groups: groups.iter().map(GroupSummary::of).collect(), pairs, friedman: ranks(&ranked) }
}

/// The results of runs for rank tests: a failed run ranks last, and numbers that differ by rounding alone become equal. The
/// same path, summed in another order, is not a shorter one.
pub fn comparable<'a>(groups: impl IntoIterator<Item = &'a [Option<f64>]>) -> Vec<Vec<f64>> {
    let mut groups: Vec<Vec<f64>> = groups.into_iter().map(|group| group.iter().map(|value| value.unwrap_or(LAST)).collect()).collect();
    let order = crate::math::ordered(groups.iter().flatten().copied());
    let mut all: Vec<&mut f64> = groups.iter_mut().flatten().collect();
    let mut level = f64::NAN;
    for (value, place) in order {
        if (value - level).abs() <= SAME * level.abs() {
            *all[place] = level;
        } else {
            level = value;
        }
    }
    groups
}

fn ranks(groups: &[Vec<f64>]) -> Option<Friedman> {
    let blocks = groups.first()?.len();
    if groups.len() < 2 || groups.iter().any(|group| group.len() != blocks) {
        return None;
    }
    friedman(&(0..blocks).map(|block| groups.iter().map(|group| group[block]).collect()).collect::<Vec<_>>())
}

impl GroupSummary {
    fn of(group: &Group) -> Self {
        let (runs, feasible) = (group.values.len(), group.values.iter().flatten().count());
        Self {
            name: group.name.clone(),
            runs,
            feasible,
            rate: if runs == 0 { 0.0 } else { feasible as f64 / runs as f64 },
            rate_interval: proportion(feasible, runs).unwrap_or([0.0, 1.0]),
            summary: Summary::of(group.values.iter().flatten().copied()),
        }
    }
}
