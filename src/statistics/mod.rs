//! Statistics of many runs: summaries, confidence intervals, rank-sum tests with correction, rank tables.
//!
//! Distributions are those of the `statrs` crate. Nothing here is part of a
//! run: the bits of a p-value are not promised.

mod bootstrap;
mod compare;
mod critical;
mod curves;
mod running_time;
mod summary;
mod tests_between;

pub use bootstrap::{RESAMPLES, bootstrap};
pub use compare::{Comparison, Group, GroupSummary, LAST, Pair, Ranks, comparable, compare};
pub use critical::{critical_difference, homogeneous_groups};
pub use curves::{Band, Bands, Curve, Reached, bands, reached};
pub use running_time::{Attempt, RunningTime, expected_running_time, performance_ratios};
pub use summary::{Moments, Summary, proportion};
pub use tests_between::{Friedman, RankSum, friedman, holm, rank_sum};

/// The level of all intervals.
pub const CONFIDENCE: f64 = 0.95;
