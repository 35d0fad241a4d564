//! The entry's parts: what is tuned, the swarm's own parameters, readings, equations and layers.

use crate::{
    ants::COLONIES,
    describe::{CONVERGED, Formula, Group, Layer, Reading, layers},
    params::{Choice, Param, Selection},
};

const fn tunable(value: &'static str, title: &'static str, help: &'static str) -> Choice {
    Choice::new(value, title, help)
}

/// Every numeric parameter of the colonies; a test compares the list with the catalogue.
pub(super) const TUNABLE: &[Choice] = &[
    tunable("alpha", "α", "Weight of pheromone."),
    tunable("beta", "β", "Weight of sight."),
    tunable("rho", "ρ", "Evaporation."),
    tunable("q", "Q", "Pheromone of an ant."),
    tunable("epsilon", "ε", "Unit of sight; only of the wolf-pack colony, where it cancels out."),
    tunable("gamma", "γ", "Weight of direction; only of direction."),
    tunable("phi1", "φ1", "Reward by the median; only of direction."),
    tunable("phi2", "φ2", "Reward by the best; only of direction."),
    tunable("seeded", "τD", "Pheromone of the Dijkstra path; only of that colony."),
    tunable("q0_start", "q0 start", "Greed at the start; only of the Dijkstra path."),
    tunable("q0_end", "q0 end", "Greed at the end; only of the Dijkstra path."),
    tunable("tau_0", "τ0", "Pheromone at the start."),
    tunable("tau_min", "τ min", "Least pheromone."),
    tunable("tau_max", "τ max", "Most pheromone."),
    tunable("ants", "m", "Ants."),
    tunable("step_limit", "Steps", "Most steps of an ant."),
];

pub(super) const COLONY: Param<&str> = Param::name_of("colony", "", "Colony", COLONIES, "Whose parameters are searched.");
pub(super) const TUNE: Param<Selection> = Param::subset(
    "tune",
    "Parameters to tune",
    TUNABLE,
    "alpha,beta,rho,q,epsilon",
    "Each is searched in the range that its slider offers. Those that the colony has not are left out. Published: α, β, ρ, Q, ε.",
);
pub(super) const POPULATION: Param<u64> =
    Param::integer("population", "N", "Particles", [1, 1000, 20], "How many sets of parameters are tried side by side. Published: 20.")
        .slider(2.0, 100.0, true);
pub(super) const ITERATIONS: Param<u64> =
    Param::integer("iterations", "k_{\\max}", "Iterations", [1, 1_000_000, 30], "After how many rounds it stops. Published: 30.")
        .slider(2.0, 200.0, true);
pub(super) const W: Param<f64> =
    Param::number("w", "\\omega", "Inertia weight", [0.0, 1.5, 0.729], "How much of its velocity a particle keeps. Published: 0.729.");
pub(super) const C1: Param<f64> = Param::number(
    "c1",
    "c_1",
    "Cognitive coefficient",
    [0.0, 5.0, 1.4962],
    "How strongly a particle is drawn to the best it has found itself. Published: 1.4962.",
);
pub(super) const C2: Param<f64> = Param::number(
    "c2",
    "c_2",
    "Social coefficient",
    [0.0, 5.0, 1.4962],
    "How strongly a particle is drawn to the best that the swarm has found. Published: 1.4962.",
);
pub(super) const SEEDS: Param<u64> = Param::integer(
    "seeds",
    "n_s",
    "Runs a particle",
    [1, 100, 3],
    "Over how many runs of the colony a set of parameters is judged: the same seeds for all, drawn at the start. The paper does not say; reading: a few.",
)
.slider(1.0, 20.0, false);
pub(super) const ROUNDS: Param<u64> = Param::integer(
    "colony_iterations",
    "t_{\\max}",
    "Iterations of the colony",
    [1, 2_000, 100],
    "How many iterations each run of the colony has. Published: 100.",
)
.slider(5.0, 500.0, true);

pub(super) const BEST: Reading =
    Reading::new("best", "\\bar L_g", "Best", Group::Cost, "The mean length that the best parameters so far gave.");
pub(super) const MEAN: Reading =
    Reading::new("mean", "\\bar L", "Mean", Group::Cost, "The mean over this round’s particles whose colonies found a way.");
pub(super) const LENGTH: Reading =
    Reading::new("length", "L", "Shortest", Group::Length, "The length of the best parameters’ shortest way.");
pub(super) const FOUND: Reading =
    CONVERGED.described("\\bar t^*", "Converged", "The mean iteration in which the best parameters’ runs found their result.");
pub(super) const RUNS: Reading = Reading::new("runs", "", "Runs", Group::Count, "Runs of the colony so far.");

const fn tuned(name: &'static str, symbol: &'static str, title: &'static str) -> Reading {
    Reading::new(name, symbol, title, Group::Schedule, "Its value in the best set so far.")
}

pub(super) const VELOCITY: Formula = Formula::new(
    "velocity",
    "[WOLF-ANT] §5.2",
    "Velocity and position",
    "v \\leftarrow \\omega v + c_1 r_1 (p - x) + c_2 r_2 (g - x), \\quad x \\leftarrow x + v",
    "",
);

/// What the swarm tells: of its particles, and the best value of each parameter that is searched.
pub(super) const READINGS: &[Reading] = &[
    BEST,
    MEAN,
    LENGTH,
    FOUND,
    RUNS,
    tuned("alpha", "\\alpha", "Weight of pheromone"),
    tuned("beta", "\\beta", "Weight of sight"),
    tuned("rho", "\\rho", "Evaporation"),
    tuned("q", "Q", "Pheromone of an ant"),
    tuned("epsilon", "\\varepsilon", "Unit of sight"),
    tuned("gamma", "\\gamma", "Weight of direction"),
    tuned("phi1", "\\varphi_1", "Reward by the median"),
    tuned("phi2", "\\varphi_2", "Reward by the best"),
    tuned("seeded", "\\tau_D / \\tau_0", "Pheromone of the Dijkstra path"),
    tuned("q0_start", "q_{0,\\text{start}}", "Greed at the start"),
    tuned("q0_end", "q_{0,\\text{end}}", "Greed at the end"),
    tuned("tau_0", "\\tau_0", "Pheromone at the start"),
    tuned("tau_min", "\\tau_{\\min}", "Least pheromone"),
    tuned("tau_max", "\\tau_{\\max}", "Most pheromone"),
    tuned("ants", "m", "Ants"),
    tuned("step_limit", "", "Most steps of an ant"),
];

/// What the swarm draws.
pub(super) const LAYERS: &[Layer] = &[
    layers::PARTICLES.titled("Particles", "The shortest way that each particle’s parameters gave in this round."),
    layers::BEST.titled("Best", "The shortest way that the best parameters gave."),
    layers::AFTER,
];
