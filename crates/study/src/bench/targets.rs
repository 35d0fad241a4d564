//! The values above the optimum that COCO looks at: how soon a run comes below each.

use forage::math;

/// What counts as solved.
pub(super) const FINAL: f64 = 1e-8;
/// Targets for running times: 51 from 100 down to what counts as solved.
pub(super) const COUNT: usize = 51;

/// The `k`-th of them, from the largest.
pub(super) fn target(k: usize) -> f64 {
    math::pow(10.0, 2.0 - 0.2 * k as f64)
}

/// Where a run's best value came below a level: evaluations, if it did.
pub(super) fn hitting_time(improvements: &[(u64, f64)], level: f64) -> Option<u64> {
    let at = improvements.partition_point(|(_, gap)| *gap > level);
    improvements.get(at).map(|(evaluations, _)| *evaluations)
}
