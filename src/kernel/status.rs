//! Whether a run goes on, and its parts.

use serde::Serialize;

/// Whether there is more to do, or why not.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// There is more to do.
    Running,
    /// The goal is reached and nothing better can be found.
    Solved,
    /// The iteration limit is reached.
    Exhausted,
    /// There is no solution, or no way to one was found.
    Infeasible,
}

/// A part of a run that has its own kind of step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Stage {
    /// An identifier.
    pub name: &'static str,
    /// A few words.
    pub title: &'static str,
    /// Its last iteration; the next stage's first step follows. `None`: when the run ends, which is not yet known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end: Option<u64>,
}
