//! The entry of `pso-tuning`.

use crate::{
    describe::{Case, Entry},
    scene::GRID,
};

use super::{
    parameters::{C1, C2, COLONY, ITERATIONS, LAYERS, POPULATION, READINGS, ROUNDS, SEEDS, TUNE, VELOCITY, W},
    planner::start,
};

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "rooms",
    "A swarm tunes ants",
    "Each particle is a set of the colony’s parameters, judged by a few runs. The best mean length never rises.",
    "rooms-20",
    &[],
)
.seed(2)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ particles is a set of parameters of the colony, drawn at random",
    "repeat until round @iterations@:",
    "  for each particle:",
    "    @seeds@ runs of the colony with @colony_iterations@ iterations: the mean length is its cost",
    "    $v \\leftarrow \\omega v + c_1 r_1 (p - x) + c_2 r_2 (g - x)$, then $x \\leftarrow x + v$",
    "  runs of the colony so far: @runs@; the best mean length is @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "pso-tuning",
    "PSO tunes a colony",
    "[WOLF-ANT] §5.2",
    "A particle swarm whose particles are parameters of an ant colony: each is judged by what a few runs of the colony find.",
    start,
)
.family("tuning")
.evaluating(crate::tuning::EVALUATION)
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
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);
