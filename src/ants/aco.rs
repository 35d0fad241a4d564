//! `aco`: the traditional ant colony, [ANTBAT](crate#papers) §3.1.

use crate::{
    describe::{Case, Entry, Preset},
    params::{Fixed, Parameter},
};

use super::{
    colony::Variant,
    parameters::{
        ALPHA, ANTS, BETA, CHOICE, DISTANCE, EVAPORATION, ITERATIONS, KINDS, LAYERS, Q, READINGS, RHO, TAU_0, TAU_MIN, TRADITIONAL, WALKS,
    },
    planner,
};

const AS_IN_PAPER: Preset = Preset::new(
    "paper",
    "As in the paper",
    "α = 1.5 and β = 8, as [ANTBAT] prints them. The defaults were chosen on random maps.",
    "ant-bat-30",
    &[("alpha", Fixed::Number(1.5)), ("beta", Fixed::Number(8.0))],
);

const OWN: &[Parameter] = &[
    ANTS.entry(),
    ITERATIONS.entry(),
    ALPHA.default_to(1.0)
        .help("How much pheromone counts in an ant’s choice. Published: 1.5. The larger, the more an ant follows the others.")
        .entry(),
    BETA.default_to(4.0)
        .help("How much the distance to the goal counts in an ant’s choice. Published: 8. The larger, the more an ant heads straight for the goal.")
        .entry(),
    RHO.entry(),
    Q.entry(),
    TAU_0.entry(),
    TAU_MIN.entry(),
];

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "trail",
    "A trail builds up",
    "Ants wander at first. Pheromone gathers on short ways, and after some dozens of iterations all follow one.",
    "ant-bat-30",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "every step from cell to cell begins with pheromone $\\tau_0$ = @tau_0@",
    "repeat until iteration @iterations@:",
    "  each of the @ants@ ants goes from the start, cell by cell:",
    "    it takes a step with probability $\\propto \\tau^\\alpha \\eta^\\beta$, with $\\alpha$ = @alpha@ and $\\beta$ = @beta@",
    "    it enters no cell twice",
    "  ants at the goal: @arrived@, in a dead end: @stuck@",
    "  pheromone evaporates: $\\tau \\leftarrow (1 - \\rho) \\tau$, with $\\rho$ = @rho@",
    "  each ant that arrived lays $Q / L$ on its steps, with $Q$ = @q@",
    "  the shortest path so far has length @length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "aco",
    "ACO: ants",
    "[ANTBAT] §3.1, (1)",
    "Ants go from cell to cell, more likely where there is more pheromone and where the goal is near; shorter paths gather more of it.",
    |start| planner::start(start, Variant::TRADITIONAL),
)
.family("ants")
.evaluating(crate::ants::EVALUATION)
.kinds(KINDS)
.parameters(&[OWN, WALKS])
.readings(READINGS)
.formulas(&[CHOICE, DISTANCE, EVAPORATION, TRADITIONAL])
.layers(LAYERS)
.presets(&[AS_IN_PAPER])
.cases(CASES)
.pseudocode(PSEUDOCODE);
