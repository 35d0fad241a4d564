//! `aco-dijkstra`: ants that set out on a Dijkstra path's pheromone and choose greedily more and more, the paper's [14].

use crate::{
    describe::{Entry, Formula, Scope},
    params::{Parameter, Settings},
    settled::SETTLED,
    way::{LENGTH, SMOOTH, SMOOTH_LENGTH, SMOOTH_TURNING, SMOOTH_TURNS, TURNING, TURNS},
};

use super::{
    Traits,
    aco::{ANTS, Q, RHO, TAU_0, TAU_MIN},
    parameters::{
        ANT_STEPS, ARRIVED, BEST, CHOICE, CONVERGED, DEAD_END, DISTANCE, EVAPORATION, GREED, ITERATIONS, KINDS, LAYERS, LOST, MEAN,
        PUBLISHED_ALPHA, PUBLISHED_BETA, STEP_LIMIT, STUCK, TAU_MAX, TRADITIONAL,
    },
};

const SEEDED: Parameter = Parameter::number(
    "seeded",
    "\\tau_D / \\tau_0",
    "Pheromone of the Dijkstra path",
    [1.0, 1000.0, 2.0],
    "How many times τ0 lies on the steps of a Dijkstra path before the first ant sets out. The paper gives no value.",
)
.slider(1.0, 20.0, false);
const Q0_START: Parameter = Parameter::number(
    "q0_start",
    "q_{0,\\text{start}}",
    "Greed at the start",
    [0.0, 1.0, 0.1],
    "How often an ant takes the best step instead of drawing one, in the first iteration. Reading: the rule adapts by rising evenly.",
);
const Q0_END: Parameter =
    Parameter::number("q0_end", "q_{0,\\text{end}}", "Greed at the end", [0.0, 1.0, 0.9], "The same, in the last iteration.");
const RULE: Formula = Formula {
    name: "rule",
    source: "[ANTBAT] §3.1, its [14]",
    title: "Pseudo-random proportional rule",
    tex: "j = \\begin{cases} \\arg\\max_s \\tau_{is}^{\\alpha} \\eta_{is}^{\\beta} & u < q_0 \\\\ \\text{drawn by (1)} & \\text{otherwise} \\end{cases}",
    live: "q_0 = @q0@",
    scope: Scope::Iteration,
    when: None,
};

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "aco-dijkstra",
    title: "ACO on a Dijkstra path",
    family: "ants",
    source: "[ANTBAT] §3.1, its [14]",
    summary: "A Dijkstra path lies on the map as pheromone before the first ant sets out; ants choose ever more greedily.",
    kinds: KINDS,
    parameters: &[
        ANTS,
        ITERATIONS,
        PUBLISHED_ALPHA,
        PUBLISHED_BETA,
        RHO,
        Q,
        SEEDED,
        Q0_START,
        Q0_END,
        TAU_0,
        TAU_MIN,
        TAU_MAX,
        DEAD_END,
        STEP_LIMIT,
        SMOOTH,
    ],
    readings: &[
        BEST,
        MEAN,
        LENGTH,
        TURNS,
        TURNING,
        SMOOTH_LENGTH,
        SMOOTH_TURNS,
        SMOOTH_TURNING,
        CONVERGED,
        SETTLED,
        ARRIVED,
        STUCK,
        LOST,
        ANT_STEPS,
        GREED,
    ],
    formulas: &[RULE, CHOICE, DISTANCE, EVAPORATION, TRADITIONAL],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, seed| super::start(scene, settings, seed, traits(settings)),
};

/// What sets this colony apart.
pub(super) fn traits(settings: &Settings) -> Traits {
    Traits { greed: [settings.number("q0_start"), settings.number("q0_end")], seeded: settings.number("seeded"), ..Traits::TRADITIONAL }
}
