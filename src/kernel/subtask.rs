//! Runs of other planners that a step needs, and what they found.

use serde::{Deserialize, Serialize};

use crate::params::Overrides;

use super::State;

/// Runs of other planners that a planner's steps rest on. It never runs them itself: the run that holds it does, one after
/// another, in parallel or elsewhere. The result is the same.
pub trait Subtasks {
    /// The runs that the next step needs; none if it needs none.
    fn requests(&self) -> Vec<Subtask>;
    /// Takes what these runs found, in their order; the next step uses it.
    fn provide(&mut self, found: Vec<SubtaskResult>);
}

/// A run of another planner on the same scene that the next step needs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Subtask {
    /// The planner's name.
    pub planner: &'static str,
    /// Parameters that differ from its defaults.
    pub params: Overrides,
    /// The seed.
    pub seed: u64,
    /// Where it starts and where it leads, if not where the scene says.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<[[f64; 2]; 2]>,
}

/// What a [`Subtask`] found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, State)]
pub struct SubtaskResult {
    /// The best cost; `None` if nothing feasible was found.
    pub cost: Option<f64>,
    /// The iteration in which the best was found.
    pub converged: f64,
    /// The best path; empty if nothing feasible was found.
    pub path: Vec<[f64; 2]>,
}

/// Parameters that a planner of planners recommends.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Recommendation {
    /// For this planner.
    pub planner: &'static str,
    /// Those that were searched and those that were given.
    pub params: Overrides,
}
