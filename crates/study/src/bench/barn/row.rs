//! The result of a robot's run through a world.

use serde::{Deserialize, Serialize};

use super::{
    super::{super::rows::KeyedRow, suite::planner_label},
    load::FASTEST,
};

/// The challenge's score of a run through a world whose best path is so long.
pub(super) fn score(success: bool, best: f64, time: f64) -> f64 {
    let best = best / FASTEST;
    if success { best / time.clamp(2.0 * best, 8.0 * best) } else { 0.0 }
}

/// The result of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The planner.
    pub planner: String,
    /// Parameters that differ from the defaults.
    pub params: String,
    /// `BARN` or `DynaBARN`.
    pub set: String,
    /// The world's number in the challenge.
    pub world: usize,
    /// The robot's radius, in metres.
    pub radius: f64,
    /// The seed.
    pub seed: u64,
    /// Whether it came within a metre of the goal in time, and touched nothing.
    pub success: bool,
    /// Whether it touched something.
    pub collided: bool,
    /// Whether it was still under way after 100 s.
    pub timeout: bool,
    /// How long it took, in seconds of the simulation.
    pub time: f64,
    /// How far it went, in metres.
    pub length: f64,
    /// The smallest distance between its rim and a static cylinder, in metres.
    pub clearance: Option<f64>,
    /// The length of the challenge's reference path, in metres.
    pub best: f64,
    /// The challenge's score.
    pub score: f64,
    /// How long that took to compute, in seconds; measured.
    pub seconds: f64,
}

impl Row {
    /// The planner with its overrides.
    pub(super) fn contender(&self) -> String {
        planner_label(&self.planner, &self.params)
    }
}

impl KeyedRow for Row {
    fn key(&self) -> String {
        key(&self.contender(), self.world, self.seed, self.radius)
    }

    fn computed(&self) -> Self {
        Self { seconds: 0.0, ..self.clone() }
    }
}

pub(super) fn key(contender: &str, world: usize, seed: u64, radius: f64) -> String {
    format!("{contender} in world {world} seed {seed} radius {radius}")
}
