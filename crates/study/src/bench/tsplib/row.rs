//! The result of a run on an instance.

use serde::{Deserialize, Serialize};

use forage::{kernel::Message, message};

use super::super::{super::rows::KeyedRow, suite::planner_label};

/// The result of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The planner.
    pub planner: String,
    /// Parameters that differ from the defaults.
    pub params: String,
    /// The instance.
    pub instance: String,
    /// How many stops it has.
    pub stops: usize,
    /// The seed.
    pub seed: u64,
    /// The budget of evaluations.
    pub budget: u64,
    /// The published length of the shortest tour.
    pub optimum: Option<f64>,
    /// The length of the tour that was found, if it is one.
    pub length: Option<f64>,
    /// Iterations taken.
    pub iterations: u64,
    /// How many evaluations there were: tours, or moves of one, that were measured.
    pub evaluations: u64,
    /// How long it took, in seconds; measured.
    pub seconds: f64,
}

impl Row {
    /// How much longer than the optimum, as a share of it.
    pub(super) fn gap(&self) -> Option<f64> {
        let (length, optimum) = (self.length?, self.optimum?);
        if length == optimum { Some(0.0) } else { Some(length / optimum - 1.0).filter(|gap| gap.is_finite()) }
    }

    /// The planner with its overrides.
    pub(super) fn contender(&self) -> String {
        planner_label(&self.planner, &self.params)
    }

    /// What must not be: a tour that is shorter than the shortest.
    pub(super) fn fault(&self) -> Option<Message> {
        let (length, optimum) = (self.length?, self.optimum?);
        (length < optimum - 1e-6).then(|| shorter(&self.key(), length, optimum))
    }
}

fn shorter(row: &str, length: f64, optimum: f64) -> Message {
    message!("study-shorter", "{row}: {length} is shorter than the published optimum, {optimum}", row, length, optimum)
}

impl KeyedRow for Row {
    fn key(&self) -> String {
        key(&self.contender(), &self.instance, self.seed, self.budget)
    }

    fn computed(&self) -> Self {
        Self { seconds: 0.0, optimum: None, ..self.clone() }
    }
}

pub(super) fn key(contender: &str, instance: &str, seed: u64, budget: u64) -> String {
    format!("{contender} on {instance} seed {seed} within {budget}")
}
