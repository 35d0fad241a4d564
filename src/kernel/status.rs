//! The status of a run, and its stages.

use serde::Serialize;

use super::Message;

/// The status of a run: whether it goes on, or why it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Status {
    /// There are more steps to take.
    Running,
    /// The goal is reached and nothing better can be found.
    Solved,
    /// The iteration limit is reached.
    Exhausted,
    /// There is no solution, or none was found.
    Infeasible,
    /// Something could not be computed, e.g. a cost that is no number: the run's failure says what and where.
    Failed,
}

/// A part of a run with its own kind of step.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Stage {
    /// An identifier.
    pub name: &'static str,
    /// The title, a few words.
    pub title: Message,
    /// Its last iteration; the next stage's first step follows. `None`: when the run ends, which is not yet known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub end: Option<u64>,
}
