//! Planners beside each other: a summary of each, a test of each two, a rank table.

use serde::{Deserialize, Serialize};

use super::{Friedman, Summary, friedman, holm, proportion, rank_sum};

/// What a failed run counts among ranks: more than any other, and, unlike infinity, equal to itself by difference.
pub const LAST: f64 = f64::MAX;

/// Numbers nearer to each other than this share of them are the same.
const SAME: f64 = 1e-12;

/// The runs of a planner, or whatever is compared.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Group {
    /// What it is called.
    pub name: String,
    /// What each run came to, small being good; `None` without a feasible result. In all groups the same place stands for
    /// the same scene and seed.
    pub values: Vec<Option<f64>>,
}

/// What there is to say of a group.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GroupSummary {
    /// What it is called.
    pub name: String,
    /// How many runs.
    pub runs: usize,
    /// How many have a feasible result.
    pub feasible: usize,
    /// The share that has, and its 95 % confidence interval (Wilson).
    pub rate: f64,
    /// See `rate`.
    pub rate_interval: [f64; 2],
    /// Of the runs with a feasible result; `None` if there are none.
    pub summary: Option<Summary>,
}

/// Two groups beside each other.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Pair {
    /// One's place among the groups.
    pub first: usize,
    /// The other's.
    pub second: usize,
    /// Mann and Whitney's U of the first.
    pub u: f64,
    /// Wilcoxon's rank-sum test, two-sided. Runs without a feasible result rank last.
    pub p: f64,
    /// The same, corrected for the number of pairs (Holm).
    pub corrected: f64,
    /// How probable it is that a run of the first is better than one of the second; ties count half.
    pub better: f64,
}

/// All that is said of several groups.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// A summary of each.
    pub groups: Vec<GroupSummary>,
    /// Each two of them.
    pub pairs: Vec<Pair>,
    /// Over the scenes and seeds that all groups have; `None` if the groups are not equally long, or there is only one.
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

/// The numbers of runs as tests by ranks take them: a failed run comes last, and numbers that differ by rounding alone are one.
/// The same path, summed up in another order, is not a shorter one.
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
