//! `aco`: the traditional ant colony, [ANTBAT](crate#papers) §3.1.

use crate::{
    describe::{Entry, Preset},
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

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "aco",
    "ACO: ants",
    "[ANTBAT] §3.1, (1)",
    "Ants go from cell to cell, more likely where there is more pheromone and where the goal is near; shorter paths gather more of it.",
    |start| planner::start(start, Variant::TRADITIONAL),
)
.family("ants")
.kinds(KINDS)
.parameters(&[OWN, WALKS])
.readings(READINGS)
.formulas(&[CHOICE, DISTANCE, EVAPORATION, TRADITIONAL])
.layers(LAYERS)
.presets(&[AS_IN_PAPER]);
