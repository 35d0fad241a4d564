//! The result of a run on a function of the suite `bbob`.

use forage::scene::function::BBOB_FUNCTIONS;
use serde::{Deserialize, Serialize};

use super::super::{super::rows::KeyedRow, suite::planner_label};

/// What the functions are called, by number.
pub const TITLES: [&str; BBOB_FUNCTIONS] = [
    "Sphere",
    "Ellipsoid",
    "Rastrigin",
    "BuecheRastrigin",
    "LinearSlope",
    "AttractiveSector",
    "StepEllipsoid",
    "Rosenbrock",
    "RosenbrockRotated",
    "EllipsoidRotated",
    "Discus",
    "BentCigar",
    "SharpRidge",
    "DifferentPowers",
    "RastriginRotated",
    "Weierstrass",
    "Schaffers10",
    "Schaffers1000",
    "GriewankRosenbrock",
    "Schwefel",
    "Gallagher101",
    "Gallagher21",
    "Katsuura",
    "LunacekBiRastrigin",
];

/// The result of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The planner.
    pub planner: String,
    /// What was set of it: `w=0.7 c1=2`.
    pub params: String,
    /// The number of the function.
    pub function: usize,
    /// How many variables.
    pub dimension: usize,
    /// The instance, which is the seed, too.
    pub instance: usize,
    /// The budget of evaluations.
    pub budget: u64,
    /// How many there were: fewer where it was solved or the planner came to its end.
    pub evaluations: u64,
    /// How far above the optimum the best was.
    pub gap: f64,
    /// After how many evaluations the best value fell, and how far above the optimum it was then: `1:3.5 4:0.2`.
    pub improvements: String,
}

impl Row {
    /// The improvements as numbers.
    pub(super) fn improvements(&self) -> Vec<(u64, f64)> {
        let pair = |pair: &str| pair.split_once(':').and_then(|(at, gap)| Some((at.parse().ok()?, gap.parse().ok()?)));
        self.improvements.split(' ').filter_map(pair).collect()
    }

    /// The planner with its overrides.
    pub(super) fn contender(&self) -> String {
        planner_label(&self.planner, &self.params)
    }
}

impl KeyedRow for Row {
    fn key(&self) -> String {
        key(&self.contender(), self.function, self.dimension, self.instance, self.budget)
    }
}

pub(super) fn key(contender: &str, function: usize, dimension: usize, instance: usize, budget: u64) -> String {
    format!("{contender} on bbob-{function} D {dimension} instance {instance} within {budget}")
}
