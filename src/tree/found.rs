//! A path from start to goal, and what is made of it.

use crate::kernel::State;

use std::sync::OnceLock;

use super::{
    finish::{Finished, finish},
    space::{Carried, Load},
    task::Task,
    vector::length,
};

/// A path along the trees' nodes. What is made of it is made when it is first needed.
#[derive(Debug, State)]
pub(super) struct Found<const N: usize> {
    pub(super) iteration: u64,
    pub(super) raw: Vec<[f64; N]>,
    /// Its length: what is minimised.
    pub(super) cost: f64,
    /// What is carried at each point, where anything is.
    pub(super) carried: Load,
    #[state(skip)]
    finished: OnceLock<Finished<N>>,
}

impl<const N: usize> Found<N> {
    pub(super) fn new(raw: Vec<[f64; N]>, carried: Vec<Carried>, iteration: u64) -> Self {
        Self { cost: length(&raw), raw, carried: Load(carried), iteration, finished: OnceLock::new() }
    }

    /// Shortened, fitted and smoothed, as the settings say.
    pub(super) fn finished(&self, task: &Task<N>) -> &Finished<N> {
        self.finished.get_or_init(|| finish(&self.raw, &self.carried.0, &task.finish, &*task.space))
    }
}
