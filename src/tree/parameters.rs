//! What the entries of the trees share: parameters, readings and equations.

use crate::{
    describe::{CONVERGED, Formula, Group, Reading},
    kernel::SceneKindId,
    params::{Fixed, Param, Parameter},
    scene::{ARM, DISCS, GRID},
};

/// The kinds of scene that a tree of places grows in.
pub(super) const KINDS: &[SceneKindId] = &[ARM, DISCS, GRID];

pub(super) const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "k_{\\max}",
    "Iterations",
    [1, 1_000_000, 20_000],
    "After how many extensions it stops at the latest, found or not. In a large maze it takes many more.",
)
.slider(100.0, 100_000.0, true);
pub(super) const STEP: Param<f64> = Param::number(
    "step_size",
    "L",
    "Step size",
    [1e-4, 1e6, 0.03],
    "How far a node grows, in the scene’s unit; on grids, in cells. The goal is reached from as near as that. Published: 0.03 and 0.05 m.",
)
.defaults_on(&[(DISCS, Fixed::Number(0.5)), (GRID, Fixed::Number(1.0))])
.slider(0.005, 2.0, true);
pub(super) const MARGIN: Param<f64> = Param::number(
    "margin",
    "m",
    "Margin",
    [0.0, 1.0, 0.005],
    "How far the tip keeps away from cuboids and column, in metres, so that the tool has room; less where start or goal have less. In the paper 0. Links with a radius need as much.",
)
.only_on(&[ARM])
.slider(0.0, 0.1, false);
pub(super) const REACHABLE: Param<bool> = Param::flag(
    "reachable",
    "Reachable",
    true,
    "Grow only where the arm can go along: a posture for each node, from which the whole arm gets to the next without touching anything. Two trees that meet grow on unless the arm gets from one to the other. In the paper only the tip counts.",
)
.only_on(&[ARM]);
pub(super) const BIAS: Param<f64> = Param::number(
    "goal_bias",
    "p_g",
    "Goal bias",
    [0.0, 0.95, 0.0],
    "How often the sample is the goal itself, as a share of the steps. In the paper never: 0. Usual elsewhere: 0.05.",
)
.slider(0.0, 0.5, false);
pub(super) const SAMPLES: Param<u64> =
    Param::integer("samples", "n_s", "Samples", [1, 1000, 20], "How many random points are drawn a step. Published: 20.")
        .slider(1.0, 100.0, false);
pub(super) const KEEP: Param<u64> =
    Param::integer("keep", "n_k", "Kept", [1, 1000, 4], "How many of them are kept for the tree to grow toward. Published: 4.")
        .slider(1.0, 20.0, false);
pub(super) const REWIRE: Param<f64> = Param::number(
    "rewire",
    "r_{\\max}",
    "Longest rewiring",
    [1.0, 100.0, 4.0],
    "How far away a neighbour may be, at most, that changes its parent: in steps. With more, more parents are tried, at more cost.",
)
.slider(1.0, 20.0, false);
pub(super) const INFORMED: Param<bool> = Param::flag(
    "informed",
    "Informed",
    true,
    "Once there is a path, draw samples only where a shorter one can lead: from the ellipsoid about start and goal.",
);
pub(super) const SHORTEN: Param<bool> = Param::flag(
    "shorten",
    "Shorten",
    true,
    "Hand over the path without detours: straight on wherever that is free, and corners cut as far as that is free. Not in the paper.",
);
pub(super) const POLYLINE: Param<bool> =
    Param::flag("polyline", "Fit a polyline", true, "Approximate it by few straight pieces, by least squares, [ARM-RRT] step 3.");
pub(super) const TOLERANCE: Param<f64> = Param::number(
    "tolerance",
    "\\varepsilon",
    "Tolerance",
    [0.0, 10.0, 0.25],
    "How far the polyline may be off, in steps. The paper prints nothing.",
)
.when(POLYLINE, "true")
.slider(0.0, 2.0, false);
pub(super) const SMOOTH: Param<bool> = Param::flag(
    "smooth",
    "Hermite smoothing",
    true,
    "Round its corners by cubic Hermite curves with continuous velocity, (12); never into an obstacle.",
)
.defaults_on(&[(DISCS, Fixed::Flag(false)), (GRID, Fixed::Flag(false))]);
pub(super) const BLEND: Param<f64> = Param::number(
    "blend",
    "b",
    "Blend",
    [0.1, 100.0, 3.0],
    "How far from a corner its curve begins, in steps; at most half-way to the next corner.",
)
.when(SMOOTH, "true")
.slider(0.1, 20.0, false);

/// The margin of the tip, whether the arm goes along, and what a planner makes of its path; its own parameters come before.
pub(super) const FINISH: &[Parameter] =
    &[MARGIN.entry(), REACHABLE.entry(), SHORTEN.entry(), POLYLINE.entry(), TOLERANCE.entry(), SMOOTH.entry(), BLEND.entry()];

pub(super) const BEST: Reading =
    Reading::new("best", "L_T", "Path of the tree", Group::Cost, "The length of the path along the tree, once there is one.");
pub(super) const SHORT_LENGTH: Reading =
    Reading::new("short_length", "L_s", "Shortened", Group::Length, "The length of the path without detours.");
pub(super) const FINAL_LENGTH: Reading =
    Reading::new("final_length", "L", "Final length", Group::Length, "The length of what is handed over.");
pub(super) const TO_GOAL: Reading = Reading::new("to_goal", "d_g", "To the goal", Group::Measure, "How far the tree is from the goal.");
pub(super) const NODES: Reading =
    Reading::new("nodes", "n", "Nodes", Group::Count, "How many nodes there are, in both trees if there are two.");
pub(super) const REJECTED: Reading =
    Reading::new("rejected", "n_r", "Rejected extensions", Group::Count, "How many extensions added no node.");
pub(super) const TESTED: Reading =
    Reading::new("tested", "n_t", "Tests", Group::Count, "How many straight pieces were tested for collisions.");
pub(super) const FOUND_AFTER: Reading =
    CONVERGED.described("k^*", "Found after", "The step in which the path was found, or last became shorter.");

/// What every tree tells.
pub(super) const READINGS: &[Reading] = &[BEST, SHORT_LENGTH, FINAL_LENGTH, TO_GOAL, NODES, REJECTED, TESTED, FOUND_AFTER];

pub(super) const FORMULA_STEP: Formula = Formula::of_item(
    "extend",
    "[ARM-RRT] (11)",
    "A step towards the sample",
    "\\class{after}{x_{\\text{new}}} = \\class{before}{x_{\\text{near}}} + \\class{step}{L \\frac{\\class{chosen}{x_{\\text{rand}}} - x_{\\text{near}}}{\\lVert x_{\\text{rand}} - x_{\\text{near}} \\rVert}}",
    "\\class{chosen}{\\lVert x_{\\text{rand}} - x_{\\text{near}} \\rVert} = @far@, \\quad \\class{step}{L} = @step@",
);
pub(super) const FORMULA_RADIUS: Formula = Formula::of_item(
    "radius",
    "Karaman and Frazzoli 2011",
    "How far neighbours are looked for",
    "r = \\min\\left(\\gamma \\left(\\tfrac{\\ln n}{n}\\right)^{1/d},\\; r_{\\max} L\\right)",
    "",
);
pub(super) const FORMULA_INFORMED: Formula = Formula::of_item(
    "informed",
    "Gammell, Srinivasa and Barfoot 2014",
    "Where a shorter path can lead",
    "\\lVert x - x_{\\text{start}} \\rVert + \\lVert x - x_{\\text{goal}} \\rVert < L_T",
    "",
);
