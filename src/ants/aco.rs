//! `aco`: the traditional ant colony, [ANTBAT] §3.1.

use crate::{
    describe::{Entry, Preset},
    params::{Fixed, Parameter, Settings},
    way::SMOOTH,
};

use super::{
    Traits,
    parameters::{
        CHOICE, DEAD_END, DISTANCE, EVAPORATION, ITERATIONS, KINDS, LAYERS, READINGS, STEP_LIMIT, TAU_MAX, TRADITIONAL, alpha, ants, beta,
        q, rho, tau_0, tau_min,
    },
};

pub(super) const ANTS: Parameter = ants(50, "How many ants set out in an iteration. Published: 50.");
const ALPHA: Parameter =
    alpha(1.0, "How much pheromone counts in an ant’s choice. Published: 1.5. The larger, the more an ant follows the others.");
const BETA: Parameter = beta(
    4.0,
    "How much the distance to the goal counts in an ant’s choice. Published: 8. The larger, the more an ant heads straight for the goal.",
);
pub(super) const RHO: Parameter = rho(0.4, "The share of the pheromone that is gone after an iteration. Published: 0.4.");
pub(super) const Q: Parameter = q(1.0, [0.1, 100.0], "An ant lays Q / L on each step of a way of length L. The paper gives no value.");

pub(super) const TAU_0: Parameter =
    tau_0(1.0, "What lies on every step before the first ant sets out. The paper gives no value; 1 is about what fifty ants lay.");
pub(super) const TAU_MIN: Parameter = tau_min(1e-3);

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "aco",
    title: "ACO: ants",
    family: "ants",
    source: "[ANTBAT] §3.1, (1)",
    summary: "Ants go from cell to cell, the rather where pheromone lies and where the goal is near; short ways gather more of it.",
    kinds: KINDS,
    parameters: &[ANTS, ITERATIONS, ALPHA, BETA, RHO, Q, TAU_0, TAU_MIN, TAU_MAX, DEAD_END, STEP_LIMIT, SMOOTH],
    readings: READINGS,
    formulas: &[CHOICE, DISTANCE, EVAPORATION, TRADITIONAL],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[Preset {
        name: "paper",
        title: "As in the paper",
        help: "α = 1.5 and β = 8, as [ANTBAT] prints them. The defaults were chosen on random maps.",
        scene: "ant-bat-30",
        values: &[("alpha", Fixed::Number(1.5)), ("beta", Fixed::Number(8.0))],
    }],
    suggest: |_| None,
    start: |scene, settings, seed| super::start(scene, settings, seed, traits(settings)),
};

/// What sets this colony apart.
pub(super) fn traits(_: &Settings) -> Traits {
    Traits::TRADITIONAL
}
