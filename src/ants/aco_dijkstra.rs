//! `aco-dijkstra`: ants that set out on a Dijkstra path's pheromone and choose greedily more and more, the paper's
//! reference 14.

use crate::{
    describe::{CONVERGED, Case, Entry, Formula},
    params::{Param, Parameters},
    scene::grid_path::{LENGTH, SMOOTH_LENGTH, SMOOTH_TURNING, SMOOTH_TURNS, TURNING, TURNS},
    settled::SETTLED,
};

use super::{
    colony::Variant,
    parameters::{
        ALPHA, ANT_STEPS, ANTS, ARRIVED, BEST, BETA, CHOICE, DISTANCE, EVAPORATION, GREED, ITERATIONS, KINDS, LAYERS, LOST, MEAN, Q, RHO,
        STUCK, TAU_0, TAU_MIN, TRADITIONAL, WALKS,
    },
    planner,
};

const SEEDED: Param<f64> = Param::number(
    "seeded",
    "\\tau_D / \\tau_0",
    "Pheromone of the Dijkstra path",
    [1.0, 1000.0, 2.0],
    "How many times τ0 lies on the steps of a Dijkstra path before the first ant sets out. The paper gives no value.",
)
.slider(1.0, 20.0, false);
const Q0_START: Param<f64> = Param::number(
    "q0_start",
    "q_{0,\\text{start}}",
    "Greed at the start",
    [0.0, 1.0, 0.1],
    "How often an ant takes the best step instead of drawing one, in the first iteration. Reading: the rule adapts by rising evenly.",
);
const Q0_END: Param<f64> =
    Param::number("q0_end", "q_{0,\\text{end}}", "Greed at the end", [0.0, 1.0, 0.9], "The same, in the last iteration.");
const RULE: Formula = Formula::new(
    "rule",
    "[ANTBAT] §3.1, its [14]",
    "Pseudo-random proportional rule",
    "j = \\begin{cases} \\arg\\max_s \\tau_{is}^{\\alpha} \\eta_{is}^{\\beta} & u < q_0 \\\\ \\text{drawn by (1)} & \\text{otherwise} \\end{cases}",
    "q_0 = @q0@",
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "map",
    "Ants on a Dijkstra path",
    "Pheromone begins on an exact path, so the colony needs about ten iterations.",
    "wolf-ant-20",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "the steps of a Dijkstra path begin with @seeded@ times the pheromone of all others",
    "repeat until iteration @iterations@:",
    "  each of the @ants@ ants goes from the start, cell by cell:",
    "    with probability $q_0$ = @q0@ it takes the best step, otherwise it draws one",
    "    it enters no cell twice",
    "    a step’s weight is $\\tau^\\alpha \\eta^\\beta$, with $\\alpha$ = @alpha@ and $\\beta$ = @beta@",
    "  ants at the goal: @arrived@, in a dead end: @stuck@",
    "  pheromone evaporates, with $\\rho$ = @rho@; each ant that arrived lays $Q / L$",
    "  the shortest path so far has length @length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "aco-dijkstra",
    "ACO on a Dijkstra path",
    "[ANTBAT] §3.1, its [14]",
    "A Dijkstra path lies on the map as pheromone before the first ant sets out; ants choose ever more greedily.",
    |start| planner::start(start, variant(start.parameters)),
)
.family("ants")
.evaluating(crate::ants::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[ANTS.entry(), ITERATIONS.entry(), ALPHA.entry(), BETA.entry(), RHO.entry(), Q.entry()],
    &[SEEDED.entry(), Q0_START.entry(), Q0_END.entry(), TAU_0.entry(), TAU_MIN.entry()],
    WALKS,
])
.readings(&[
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
])
.formulas(&[RULE, CHOICE, DISTANCE, EVAPORATION, TRADITIONAL])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// What sets this colony apart.
fn variant(settings: &Parameters) -> Variant {
    Variant { greed: [settings[Q0_START], settings[Q0_END]], seeded: settings[SEEDED], ..Variant::TRADITIONAL }
}
