//! What a run on a form of a function came to.

use serde::{Deserialize, Serialize};

use super::{
    super::{super::rows::Row as Kept, suite::named},
    form::Form,
};

/// What it came to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The planner.
    pub planner: String,
    /// What was set of it.
    pub params: String,
    /// The function.
    pub function: String,
    /// How many variables.
    pub dimension: usize,
    /// What was done to the function.
    pub form: Form,
    /// Where the minimum was moved to and how the axes were turned; the seed, too.
    pub instance: u64,
    /// How many evaluations there could be.
    pub budget: u64,
    /// How many there were.
    pub evaluations: u64,
    /// How far above the minimum the best was in the end.
    pub gap: f64,
    /// The common logarithm of that, averaged over the evaluations.
    pub level: f64,
}

impl Row {
    /// What tells planners apart, with what is set of them.
    pub(super) fn contender(&self) -> String {
        named(&self.planner, &self.params)
    }
}

impl Kept for Row {
    fn key(&self) -> String {
        key(&self.contender(), &self.function, self.dimension, self.form, self.instance, self.budget)
    }
}

pub(super) fn key(contender: &str, function: &str, dimension: usize, form: Form, instance: u64, budget: u64) -> String {
    format!("{contender} on {function} {form} D {dimension} instance {instance} within {budget}")
}
