//! The result of a tree's run on a scene.

use serde::{Deserialize, Serialize};

use super::super::{super::rows::KeyedRow, suite::planner_label};

/// The result of a run. Times are measured, and no part of the result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The planner.
    pub planner: String,
    /// Parameters that differ from the defaults.
    pub params: String,
    /// The scene.
    pub scene: String,
    /// A hash of the scene's content (FNV-1a, hexadecimal): another scene of the same name has another one.
    pub content: String,
    /// The seed.
    pub seed: u64,
    /// The budget of evaluations.
    pub budget: u64,
    /// Whether a collision-free path was found.
    pub solved: bool,
    /// Its length.
    pub length: Option<f64>,
    /// Its smallest distance to an obstacle.
    pub clearance: Option<f64>,
    /// The exact optimum, where it is known.
    pub exact: Option<f64>,
    /// Nodes of the trees.
    pub nodes: Option<f64>,
    /// Iterations taken.
    pub iterations: u64,
    /// Evaluations: straight pieces that were tested.
    pub evaluations: u64,
    /// When the best path changed, and its length then: `evaluations:length`.
    pub improvements: String,
    /// How many seconds it took.
    pub seconds: f64,
    /// Seconds from the start of the run to each improvement.
    pub times: String,
}

impl Row {
    /// The planner with its overrides.
    pub(super) fn contender(&self) -> String {
        planner_label(&self.planner, &self.params)
    }

    /// How much longer than the optimum, as a share of it.
    pub(super) fn gap(&self) -> Option<f64> {
        Some(self.length? / self.exact.filter(|exact| *exact > 0.0)? - 1.0)
    }

    /// Evaluations, lengths and seconds of the improvements.
    pub(super) fn progress(&self) -> Vec<(u64, f64, f64)> {
        let pair = |pair: &str| pair.split_once(':').and_then(|(at, length)| Some((at.parse().ok()?, length.parse().ok()?)));
        let seconds = self.times.split(' ').filter_map(|seconds| seconds.parse().ok());
        self.improvements.split(' ').filter_map(pair).zip(seconds).map(|((at, length), seconds)| (at, length, seconds)).collect()
    }

    /// After how many evaluations there was a way.
    pub(super) fn first(&self) -> Option<u64> {
        self.solved.then(|| self.progress().first().map(|(at, ..)| *at))?
    }
}

impl KeyedRow for Row {
    fn key(&self) -> String {
        key(&self.contender(), &self.scene, &self.content, self.seed, self.budget)
    }

    fn computed(&self) -> Self {
        Self { seconds: 0.0, times: String::new(), ..self.clone() }
    }
}

pub(super) fn key(contender: &str, scene: &str, content: &str, seed: u64, budget: u64) -> String {
    format!("{contender} on {scene} ({content}) seed {seed} within {budget}")
}
