//! A path from start to goal, and what is made of it.

use crate::{arm::Posture, kernel::State};

use std::sync::OnceLock;

use super::{
    finish::{Finished, finish},
    space::Postures,
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
    /// An arm's posture at each point; empty where there is none.
    pub(super) postures: Postures,
    #[state(skip)]
    finished: OnceLock<Finished<N>>,
}

impl<const N: usize> Found<N> {
    pub(super) fn new(raw: Vec<[f64; N]>, postures: Vec<Posture>, iteration: u64) -> Self {
        Self { cost: length(&raw), raw, postures: Postures(postures), iteration, finished: OnceLock::new() }
    }

    /// Shortened, fitted and smoothed, as the settings say.
    pub(super) fn finished(&self, task: &Task<N>) -> &Finished<N> {
        self.finished.get_or_init(|| finish(&self.raw, &self.postures.0, &task.finish, &*task.space))
    }
}
