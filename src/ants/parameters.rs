//! What the entries of the colonies share: parameters, readings, equations and layers.

use crate::{
    describe::{CONVERGED, Formula, Group, Layer, Reading, layers},
    kernel::SceneKindId,
    params::{Choice, Param, Parameter},
    scene::GRID,
    scene::grid_path::{LENGTH, SMOOTH, SMOOTH_LENGTH, SMOOTH_TURNING, SMOOTH_TURNS, TURNING, TURNS},
    settled::SETTLED,
};

/// The kinds of scene that a colony runs on.
pub(super) const KINDS: &[SceneKindId] = &[GRID];

pub(super) const ITERATIONS: Param<u64> =
    Param::integer("iterations", "t_{\\max}", "Iterations", [1, 1_000_000, 100], "After how many iterations it stops. Published: 100.")
        .slider(10.0, 1000.0, true);
pub(super) const ANTS: Param<u64> =
    Param::integer("ants", "m", "Ants", [1, 10_000, 50], "How many ants set out in an iteration. Published: 50.").slider(1.0, 500.0, true);
/// As [ANTBAT](crate#papers) prints it, and β.
pub(super) const ALPHA: Param<f64> = Param::number(
    "alpha",
    "\\alpha",
    "Weight of pheromone",
    [0.0, 10.0, 1.5],
    "How much pheromone counts in an ant’s choice. Published: 1.5.",
);
pub(super) const BETA: Param<f64> = Param::number(
    "beta",
    "\\beta",
    "Weight of sight",
    [0.0, 20.0, 8.0],
    "How much the distance to the goal counts in an ant’s choice. Published: 8.",
);
pub(super) const RHO: Param<f64> = Param::number(
    "rho",
    "\\rho",
    "Evaporation",
    [0.0, 1.0, 0.4],
    "The share of the pheromone that is gone after an iteration. Published: 0.4.",
);
pub(super) const Q: Param<f64> = Param::number(
    "q",
    "Q",
    "Pheromone of an ant",
    [0.0, 1_000_000.0, 1.0],
    "An ant lays Q / L on each step of a way of length L. The paper gives no value.",
)
.slider(0.1, 100.0, false);
pub(super) const TAU_0: Param<f64> = Param::number(
    "tau_0",
    "\\tau_0",
    "Pheromone at the start",
    [1e-9, 1e9, 1.0],
    "What lies on every step before the first ant sets out. The paper gives no value; 1 is about what fifty ants lay.",
)
.slider(0.01, 10_000.0, true);
pub(super) const TAU_MIN: Param<f64> = Param::number(
    "tau_min",
    "\\tau_{\\min}",
    "Least pheromone",
    [1e-12, 1e3, 1e-3],
    "No step keeps less than this, so that none is lost for ever and punishment leaves τ positive. The papers give no value.",
)
.slider(1e-6, 10.0, true);
pub(super) const TAU_MAX: Param<f64> =
    Param::number("tau_max", "\\tau_{\\max}", "Most pheromone", [1e3, 1e12, 1e6], "No step gathers more than this.").slider(1e3, 1e9, true);
pub(super) const BACKTRACKS: Param<bool> = Param::choice(
    "dead_end",
    "",
    "In a dead end",
    &[
        Choice::new(
            "backtrack",
            "It goes back",
            "The ant takes its last step back and chooses again; with enough steps it always arrives.",
        ),
        Choice::new("stay", "It stays", "The ant is out: it lays nothing. In rooms and mazes whole colonies are lost."),
    ],
    &[true, false],
    "What an ant does when every cell around it is blocked or already behind it. The papers do not say.",
);
pub(super) const STEP_LIMIT: Param<u64> = Param::integer(
    "step_limit",
    "",
    "Most steps of an ant",
    [0, 1_000_000_000, 0],
    "After how many steps an ant is lost. 0: twice as many as there are cells, which is enough for every way.",
)
.slider(0.0, 1000.0, false);
pub(super) const BEST: Reading = Reading::new("best", "L_{\\text{best}}", "Shortest", Group::Cost, "The shortest way so far: the result.");
pub(super) const MEAN: Reading =
    Reading::new("mean", "\\bar L", "Mean", Group::Cost, "The mean length of the ways of this iteration’s ants that arrived.");
pub(super) const ARRIVED: Reading = Reading::new("arrived", "", "Arrived", Group::Count, "Ants of this iteration that reached the goal.");
pub(super) const STUCK: Reading = Reading::new("stuck", "", "In dead ends", Group::Count, "Ants of this iteration that had no way on.");
pub(super) const LOST: Reading = Reading::new("lost", "", "Lost", Group::Count, "Ants of this iteration that reached the step limit.");
pub(super) const ANT_STEPS: Reading = Reading::new("ant_steps", "", "Steps", Group::Count, "The steps of all ants so far.");
pub(super) const GREED: Reading =
    Reading::new("q0", "q_0", "Greed", Group::Schedule, "How often an ant took the best step instead of drawing one.");

pub(super) const CHOICE: Formula = Formula::of_item(
    "choice",
    "[ANTBAT] (1)",
    "Choice",
    "p_{ij} = \\frac{\\class{step}{\\tau_{ij}^{\\alpha} \\, \\eta_{ij}^{\\beta}}}{\\class{candidates}{\\sum_s \\tau_{is}^{\\alpha} \\, \\eta_{is}^{\\beta}}}",
    "p = \\frac{\\class{step}{@tau@^{@alpha@} \\cdot @eta@^{@beta@}}}{\\class{candidates}{@sum@}} = @p@",
);
pub(super) const DISTANCE: Formula = Formula::of_item(
    "distance",
    "[ANTBAT] §3.1",
    "Sight",
    "\\eta_j = \\frac{1}{\\class{to-goal}{d(j, \\text{goal})}}",
    "\\eta = \\frac{1}{\\class{to-goal}{@d@}} = @eta@",
);
pub(super) const TRADITIONAL: Formula = Formula::of_item(
    "laid",
    "[ANTBAT] §3.1",
    "What an ant lays",
    "\\Delta\\tau^k = \\frac{Q}{\\class{way}{L_k}}",
    "\\Delta\\tau = \\frac{@q@}{\\class{way}{@length@}} = @laid@",
);
pub(super) const EVAPORATION: Formula = Formula::new(
    "evaporation",
    "[ANTBAT] (4)",
    "Pheromone",
    "\\tau_{ij} \\leftarrow (1 - \\rho) \\, \\tau_{ij} + \\sum_k \\Delta\\tau_{ij}^k",
    "\\tau \\leftarrow (1 - @rho@) \\, \\tau + \\textstyle\\sum_{k=1}^{@arrived@} \\Delta\\tau^k",
);

/// What an ant may do, and what is handed over: the same for every colony.
pub(super) const WALKS: &[Parameter] = &[TAU_MAX.entry(), BACKTRACKS.entry(), STEP_LIMIT.entry(), SMOOTH.entry()];

/// What every colony draws.
pub(super) const LAYERS: &[Layer] = &[
    layers::PHEROMONE,
    layers::TRAILS,
    layers::ANTS,
    layers::BEST.titled("Shortest", "The shortest way so far: the result."),
    layers::SMOOTHED.titled("Smoothed", "The shortest way without redundant nodes: the result that is handed over.").when("smooth", "true"),
    layers::CANDIDATES,
    layers::WAY,
    layers::TO_GOAL,
    layers::STEP,
    layers::SUPPOSED,
];

/// What every colony tells.
pub(super) const READINGS: &[Reading] =
    &[BEST, MEAN, LENGTH, TURNS, TURNING, SMOOTH_LENGTH, SMOOTH_TURNS, SMOOTH_TURNING, CONVERGED, SETTLED, ARRIVED, STUCK, LOST, ANT_STEPS];
