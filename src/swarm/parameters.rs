//! What the entries of the swarms share: parameters, readings, equations and layers.

use crate::{
    describe::{Formula, Group, Layer, Preset, Reading, layers},
    kernel::SceneKindId,
    params::{Choice, Fixed, Param, Parameter},
    scene::{DISCS, FUNCTION, GRID},
};

/// The kinds of scene that a swarm runs on.
pub(super) const KINDS: &[SceneKindId] = &[DISCS, GRID, FUNCTION];

/// The kinds of scene in which a path is searched.
pub(super) const PATHS: &[SceneKindId] = &[DISCS, GRID];

/// How many particles.
pub const POPULATION: Param<u64> =
    Param::integer("population", "N", "Population", [1, 100_000, 60], "How many particles. Published: 60 on functions, 150 among discs.")
        .defaults_on(&[(DISCS, Fixed::Number(150.0)), (GRID, Fixed::Number(150.0))])
        .slider(2.0, 2000.0, true);
/// After how many iterations a swarm stops.
pub const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "k_{\\max}",
    "Iterations",
    [1, 1_000_000_000, 1000],
    "After how many iterations it stops; schedules stretch over them. Published: 1000 on functions, 500 among discs.",
)
.defaults_on(&[(DISCS, Fixed::Number(500.0)), (GRID, Fixed::Number(500.0))])
.slider(10.0, 5000.0, true);
pub(super) const V_MAX: Param<f64> =
    Param::number("v_max", "v_{\\max}", "Velocity limit", [0.001, 1000.0, 0.2], "The most a coordinate may change in an iteration.")
        .slider(0.01, 1.0, false);
pub(super) const V_MAX_ABSOLUTE: Param<bool> = Param::choice(
    "v_max_unit",
    "",
    "Velocity limit in",
    &[
        Choice::new("fraction", "Shares of the side", "v_max is a share of the search box’s side."),
        Choice::new("absolute", "The scene’s unit", "v_max is a distance in the scene’s unit."),
    ],
    &[false, true],
    "What the velocity limit is measured in.",
);
pub(super) const PER_PARTICLE: Param<bool> = Param::choice(
    "random",
    "r_1, r_2",
    "Random numbers",
    &[
        Choice::new("coordinate", "Each coordinate", "Each coordinate of a particle has a pair r1, r2 of its own."),
        Choice::new(
            "particle",
            "Each particle",
            "All coordinates of a particle share one pair r1, r2: it moves in the plane of its two pulls.",
        ),
    ],
    &[false, true],
    "How often r1 and r2 of (1) are drawn. The paper does not say; its Table 2 fits one pair per particle.",
);
/// Random numbers and velocity limit of a [`Swarm`](super::Swarm).
pub const FLIGHT: &[Parameter] = &[PER_PARTICLE.entry(), V_MAX.entry(), V_MAX_ABSOLUTE.entry()];
pub(super) const W: Param<f64> = Param::number(
    "w",
    "\\omega",
    "Inertia weight",
    [0.0, 1.5, 0.7298],
    "How much of its velocity a particle keeps. The paper gives no value; 0.7298 is Clerc and Kennedy’s.",
);
pub(super) const C1: Param<f64> = Param::number(
    "c1",
    "c_1",
    "Cognitive coefficient",
    [0.0, 5.0, 1.496_18],
    "How strongly a particle is drawn to the best it has found itself.",
);
pub(super) const C2: Param<f64> = Param::number(
    "c2",
    "c_2",
    "Social coefficient",
    [0.0, 5.0, 1.496_18],
    "How strongly a particle is drawn to the best that the swarm has found.",
);
pub(super) const W_MAX: Param<f64> = Param::number(
    "w_max",
    "\\omega_{\\max}",
    "Inertia weight at the start",
    [0.0, 1.5, 0.95],
    "ω falls from here, so that the swarm first explores.",
);
pub(super) const W_MIN: Param<f64> =
    Param::number("w_min", "\\omega_{\\min}", "Inertia weight at the end", [0.0, 1.5, 0.4], "ω falls to here, so that the swarm settles.");
/// The defaults of a swarm of [WCPSO](crate#papers): coefficients as the text prints them.
pub(super) const AS_IN_TEXT: Preset =
    Preset::new("paper", "As in the text", "The coefficients that [WCPSO] prints: the defaults.", "matyas", &[]);

/// What every swarm tells; those that perturb tell [`PERTURBED`].
pub(super) const READINGS: &[Reading] =
    &[BEST, MEAN, SPREAD, FREE, LENGTH, SMOOTHNESS, K, OMEGA, COGNITIVE, SOCIAL, STAGNATING, EVALUATIONS];
pub(super) const PERTURBED: &[Reading] =
    &[BEST, MEAN, SPREAD, FREE, LENGTH, SMOOTHNESS, K, OMEGA, COGNITIVE, SOCIAL, STAGNATING, HENS, CHICKS, EVALUATIONS];

pub(super) const BEST: Reading = Reading::new("best", "f(g)", "Best cost", Group::Cost, "The cost of the global best, penalty included.");
pub(super) const MEAN: Reading =
    Reading::new("mean", "\\bar f", "Mean cost", Group::Cost, "The mean cost of the particles where they are now.");
pub(super) const SPREAD: Reading = Reading::new(
    "spread",
    "\\bar\\sigma",
    "Spread",
    Group::Measure,
    "The mean standard deviation of the particles’ coordinates, as a share of the box.",
);
pub(super) const FREE: Reading = Reading::new(
    "free",
    "L_{\\text{free}}",
    "Best without penalty",
    Group::Cost,
    "The cost of the cheapest path without penalty so far: the result.",
);
pub(super) const LENGTH: Reading =
    Reading::new("length", "L_D", "Raw length", Group::Length, "The result’s length before smoothing, [LTQPSO] (17).");
pub(super) const SMOOTHNESS: Reading = Reading::new(
    "smoothness",
    "L_S",
    "Smoothness",
    Group::Measure,
    "The sum of the squared distances between the result’s points, [LTQPSO] (18): the smaller, the more even.",
);
pub(super) const K: Reading =
    Reading::new("k", "k", "Update", Group::Count, "The number of the update that led here, counted from 0 as in the paper.");
pub(super) const OMEGA: Reading = Reading::new("w", "\\omega", "Inertia weight", Group::Schedule, "ω in the step that led here.");
pub(super) const COGNITIVE: Reading = Reading::new("c1", "c_1", "Cognitive coefficient", Group::Schedule, "c1 in the step that led here.");
pub(super) const SOCIAL: Reading = Reading::new("c2", "c_2", "Social coefficient", Group::Schedule, "c2 in the step that led here.");
pub(super) const STAGNATING: Reading = Reading::new(
    "stagnating",
    "n_s",
    "Stagnating",
    Group::Count,
    "Particles whose cost has just risen in that many consecutive iterations.",
);
pub(super) const HENS: Reading =
    Reading::new("hens", "n_h", "Moved by the hen", Group::Count, "Particles that the hen equation moved in this iteration.");
pub(super) const CHICKS: Reading =
    Reading::new("chicks", "n_c", "Moved by the chick", Group::Count, "Particles that the chick equation moved in this iteration.");
pub(super) const FROM_TREES: Reading =
    Reading::new("from_trees", "n_T", "Begun by trees", Group::Count, "Particles whose first path came from a tree.");
pub(super) const EVALUATIONS: Reading =
    Reading::new("evaluations", "n_f", "Evaluations", Group::Count, "How many positions were evaluated so far.");

pub(super) const VELOCITY: Formula = Formula::of_item(
    "velocity",
    "[WCPSO] (1, 6)",
    "Velocity",
    "v \\leftarrow \\class{inertia}{\\omega v} + \\class{cognitive}{c_1 r_1 (p - x)} + \\class{social}{c_2 r_2 (g - x)}",
    "v = \\class{inertia}{@w@ \\cdot @v_before@} + \\class{cognitive}{@c1@ \\cdot @r1@ \\, (@p@ - @x_before@)} \
     + \\class{social}{@c2@ \\cdot @r2@ \\, (@g@ - @x_before@)} \
     = \\class{inertia}{@inertia@} + \\class{cognitive}{@cognitive@} + \\class{social}{@social@} \\;\\to\\; \\class{velocity}{@v@}",
);
pub(super) const POSITION: Formula = Formula::of_item(
    "position",
    "[WCPSO] (2, 7)",
    "Position",
    "x \\leftarrow x + \\class{velocity}{v}",
    "x = @x_before@ + \\class{velocity}{@v@} \\;\\to\\; @x@",
);
pub(super) const LINEAR_W: Formula = Formula::new(
    "w",
    "[WCPSO] fig. 1, dashed",
    "Inertia weight, linear",
    "\\omega(k) = \\omega_{\\max} - (\\omega_{\\max} - \\omega_{\\min}) \\frac{k}{k_{\\max}}",
    "\\omega(@k@) = @w_max@ - (@w_max@ - @w_min@) \\cdot \\frac{@k@}{@iterations@} = @w@",
);

/// What every swarm draws; those that perturb draw [`PERTURBED_LAYERS`].
pub(super) const LAYERS: &[Layer] = &[
    GUIDES,
    layers::PERSONAL_BESTS,
    layers::PARTICLES,
    layers::VELOCITIES,
    layers::BEST,
    SMOOTHED,
    layers::BEFORE,
    layers::AFTER,
    layers::SUPPOSED,
    layers::INERTIA,
    layers::COGNITIVE,
    layers::SOCIAL,
    layers::VELOCITY,
];
pub(super) const PERTURBED_LAYERS: &[Layer] = &[
    GUIDES,
    layers::PERSONAL_BESTS,
    layers::PARTICLES,
    layers::HENS,
    layers::CHICKS,
    layers::VELOCITIES,
    layers::BEST,
    SMOOTHED,
    layers::BEFORE,
    layers::AFTER,
    layers::SUPPOSED,
    layers::INERTIA,
    layers::COGNITIVE,
    layers::SOCIAL,
    layers::VELOCITY,
    layers::JUMP,
];

pub(super) const GUIDES: Layer = layers::GUIDES.when("encoding", "polar");
pub(super) const SMOOTHED: Layer = layers::SMOOTHED.when("smooth", "true");

/// What swarms with a velocity do, with the numbers of the iteration.
pub(super) const PSEUDOCODE: &[&str] = &[
    "each of the @population@ particles begins at a random position, with $v = 0$",
    "repeat until iteration @iterations@, with $\\omega$ = @w@, $c_1$ = @c1@, $c_2$ = @c2@:",
    "  for each particle, in each coordinate:",
    "    $v \\leftarrow \\omega v + c_1 r_1 (p - x) + c_2 r_2 (g - x)$, with $r_1$ and $r_2$ random",
    "    $x \\leftarrow x + v$, kept in the search box",
    "  if $f(x) < f(p)$: its own best $p \\leftarrow x$",
    "  $g \\leftarrow$ the best $p$ of all, with $f(g)$ = @best@",
];
