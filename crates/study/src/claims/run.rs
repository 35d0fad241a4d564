//! One run of a claim's arm, as a row.

use serde::{Deserialize, Serialize};

use super::{super::rows::KeyedRow, measure::Measure};

/// A run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// The scene’s name, or the generator and the number of its map.
    pub scene: String,
    /// The planner.
    pub planner: String,
    /// The parameters that were given, then those of the motion.
    pub parameters: String,
    /// When it was looked at.
    pub until: String,
    /// The seed.
    pub seed: u64,
    /// The result was checked and breaks nothing.
    pub feasible: bool,
    /// Whether the planner had come to its goal; only drives say so.
    pub solved: bool,
    /// A feasible result's length, or a function's value.
    pub value: Option<f64>,
    /// What the planner minimised.
    pub cost: Option<f64>,
    /// (length − exact) / exact.
    pub gap: Option<f64>,
    /// Iterations until then.
    pub iterations: u64,
    /// Evaluations until then.
    pub evaluations: u64,
    /// Evaluations when it was first within 1 % of the optimum.
    pub reached: Option<u64>,
    /// The most iterations without improvement that an improvement followed.
    pub longest_wait: u64,
    /// All other numbers: `turns=9 nodes=120`.
    pub numbers: String,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        format!("{}, {}, {}, {}, seed {}", self.scene, self.planner, self.parameters, self.until, self.seed)
    }
}

impl Run {
    /// A number of the run.
    pub fn number(&self, measure: &Measure) -> Option<f64> {
        if measure.of_feasible && !self.feasible {
            return None;
        }
        let number = match measure.key {
            "value" => self.value,
            "cost" => self.cost,
            "gap" => self.gap,
            "iterations" => Some(self.iterations as f64),
            "evaluations" => Some(self.evaluations as f64),
            "reached" => self.reached.map(|evaluations| evaluations as f64),
            key => self.other(key),
        };
        number.map(|number| if number.abs() < measure.floor { 0.0 } else { number })
    }

    /// One of the other numbers.
    pub fn other(&self, key: &str) -> Option<f64> {
        let pair = |pair: &str| pair.split_once('=').filter(|(name, _)| *name == key).and_then(|(_, number)| number.parse().ok());
        self.numbers.split_whitespace().find_map(pair)
    }
}
