//! The entry of `pso-tuning`.

use crate::{describe::Entry, scene::GRID};

use super::{
    parameters::{C1, C2, COLONY, ITERATIONS, LAYERS, POPULATION, READINGS, ROUNDS, SEEDS, TUNE, VELOCITY, W},
    planner::start,
};

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "pso-tuning",
    "PSO tunes a colony",
    "[WOLF-ANT] §5.2",
    "A particle swarm whose particles are parameters of an ant colony: each is judged by what a few runs of the colony find.",
    start,
)
.family("tuning")
.kinds(&[GRID])
.parameters(&[&[
    COLONY.entry(),
    TUNE.entry(),
    POPULATION.entry(),
    ITERATIONS.entry(),
    W.entry(),
    C1.entry(),
    C2.entry(),
    SEEDS.entry(),
    ROUNDS.entry(),
]])
.readings(READINGS)
.formulas(&[VELOCITY])
.layers(LAYERS);
