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
    /// The result of each run, smaller is better; `None` without a feasible result. In all groups the same index means the
    /// same scene and seed.
    pub values: Vec<Option<f64>>,
    /// Every seed gives the same run: then tests, which ask whether chance alone explains a difference, say nothing of it.
    #[serde(default)]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<bool>"))]
    pub deterministic: bool,
}

impl Group {
    /// Runs that differ from seed to seed.
    pub fn new(name: impl Into<String>, values: Vec<Option<f64>>) -> Self {
        Self { name: name.into(), values, deterministic: false }
    }
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
    /// Mann and Whitney's U of the first group; this and what follows is `None` if one of the two is deterministic.
    pub u: Option<f64>,
    /// The p-value of Wilcoxon's rank-sum test, two-sided. Runs without a feasible result rank last.
    pub p: Option<f64>,
    /// The p-value corrected for the number of tested pairs (Holm).
    pub corrected: Option<f64>,
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
    /// Friedman's test over scenes and seeds, of the groups that are not deterministic; `None` if they are not equally long, or
    /// fewer than two.
    pub friedman: Option<Ranks>,
}

/// Mean ranks of groups over common scenes and seeds, and Friedman's test of whether they differ.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Friedman"))]
pub struct Ranks {
    /// The number of scenes and seeds.
    pub blocks: usize,
    /// The mean rank of each group, 1 is the best; ties share their mean rank. `None` of a deterministic one.
    pub ranks: Vec<Option<f64>>,
    /// Friedman's statistic, corrected for ties; `None` for two groups, or if all are tied everywhere.
    pub statistic: Option<f64>,
    /// Its p-value by the chi-squared distribution.
    pub p: Option<f64>,
    /// How far apart two mean ranks must be to differ at the 5 % level, by Nemenyi's test.
    pub critical_difference: Option<f64>,
}

/// Summarises groups and tests whether they differ.
///
/// ```
/// use forage::statistics::{Group, compare};
/// let group = |name, values: [f64; 5]| Group::new(name, values.map(Some).to_vec());
/// let found = compare(&[group("a", [1.0, 2.0, 3.0, 4.0, 5.0]), group("b", [6.0, 7.0, 8.0, 9.0, 10.0])]);
/// assert!(found.pairs[0].p.unwrap() < 0.01 && found.pairs[0].better == 1.0);
/// ```
pub fn compare(groups: &[Group]) -> Comparison {
    let ranked = comparable(groups.iter().map(|group| &group.values[..]));
    let mut pairs = Vec::new();
    for first in 0..groups.len() {
        for second in first + 1..groups.len() {
            if let Some(test) = rank_sum(&ranked[first], &ranked[second]) {
                let drawn = !(groups[first].deterministic || groups[second].deterministic);
                let (u, p) = (drawn.then_some(test.u), drawn.then_some(test.p));
                pairs.push(Pair { first, second, u, p, corrected: None, better: test.smaller });
            }
        }
    }
    let corrected = holm(&pairs.iter().filter_map(|pair| pair.p).collect::<Vec<_>>());
    pairs.iter_mut().filter(|pair| pair.p.is_some()).zip(corrected).for_each(|(pair, p)| pair.corrected = Some(p));
    Comparison { groups: groups.iter().map(GroupSummary::of).collect(), pairs, friedman: ranks(groups, &ranked) }
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

fn ranks(groups: &[Group], ranked: &[Vec<f64>]) -> Option<Ranks> {
    let drawn: Vec<&Vec<f64>> = groups.iter().zip(ranked).filter(|(group, _)| !group.deterministic).map(|(_, values)| values).collect();
    let blocks = drawn.first()?.len();
    if drawn.len() < 2 || drawn.iter().any(|values| values.len() != blocks) {
        return None;
    }
    let found = friedman(&(0..blocks).map(|block| drawn.iter().map(|values| values[block]).collect()).collect::<Vec<_>>())?;
    let Friedman { blocks, ranks, statistic, p, critical_difference } = found;
    let mut each = ranks.into_iter();
    let ranks = groups.iter().map(|group| if group.deterministic { None } else { each.next() }).collect();
    Some(Ranks { blocks, ranks, statistic, p, critical_difference })
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
