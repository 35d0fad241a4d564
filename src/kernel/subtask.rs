//! Subtasks: runs of other planners that a step needs, and their results.

use serde::{Deserialize, Serialize};

use crate::params::Overrides;

use super::State;

/// Runs of other planners that a planner's steps need. The planner does not run them; its run does, one after another, in
/// parallel or elsewhere. The result is the same.
pub trait Subtasks {
    /// The runs that the next step needs; none if it needs none.
    fn requests(&self) -> Vec<Subtask>;
    /// Takes the results of these runs, in their order; the next step uses them.
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
    /// Start and goal, if they are not the scene's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<[[f64; 2]; 2]>,
}

/// The result of a [`Subtask`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, State)]
pub struct SubtaskResult {
    /// The best cost; `None` if nothing feasible was found.
    pub cost: Option<f64>,
    /// The iteration in which the best was found.
    pub converged: f64,
    /// The best path; empty if nothing feasible was found.
    pub path: Vec<[f64; 2]>,
}

/// Parameters that a tuning planner recommends for another planner.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Recommendation {
    /// The planner that they are for.
    pub planner: &'static str,
    /// The parameters that were searched and those that were given.
    pub params: Overrides,
}
