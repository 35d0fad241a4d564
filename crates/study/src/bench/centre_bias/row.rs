//! The result of a run on a form of a function.

use serde::{Deserialize, Serialize};

use super::{
    super::{super::rows::KeyedRow, suite::planner_label},
    form::Form,
};

/// The result of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The planner.
    pub planner: String,
    /// Parameters that differ from the defaults.
    pub params: String,
    /// The function.
    pub function: String,
    /// How many variables.
    pub dimension: usize,
    /// What was done to the function.
    pub form: Form,
    /// Where the minimum was moved to and how the axes were turned; the seed, too.
    pub instance: u64,
    /// The budget of evaluations.
    pub budget: u64,
    /// How many there were.
    pub evaluations: u64,
    /// How far above the minimum the best was in the end.
    pub gap: f64,
    /// The mean over the run of log10 of the gap.
    pub level: f64,
}

impl Row {
    /// The planner with its overrides.
    pub(super) fn contender(&self) -> String {
        planner_label(&self.planner, &self.params)
    }
}

impl KeyedRow for Row {
    fn key(&self) -> String {
        key(&self.contender(), &self.function, self.dimension, self.form, self.instance, self.budget)
    }
}

pub(super) fn key(contender: &str, function: &str, dimension: usize, form: Form, instance: u64, budget: u64) -> String {
    format!("{contender} on {function} {form} D {dimension} instance {instance} within {budget}")
}
