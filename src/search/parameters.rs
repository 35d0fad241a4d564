//! What the entries of the searches share: parameters, readings, equations and layers.

use crate::{
    describe::{CONVERGED, Formula, Group, Layer, Reading, layers},
    kernel::SceneKindId,
    params::Param,
    scene::grid_path::{LENGTH, SMOOTH_LENGTH, SMOOTH_TURNING, SMOOTH_TURNS, TURNING, TURNS},
    scene::{GRID, MAX_SIDE},
};

/// The kinds of scene that a search runs on.
pub(super) const KINDS: &[SceneKindId] = &[GRID];

pub(super) const ITERATIONS: Param<u64> = Param::integer(
    "iterations",
    "k_{\\max}",
    "Iterations",
    [1, 1_000_000_000, 1_000_000],
    "After how many steps it stops at the latest, found or not.",
)
.slider(1.0, 5000.0, true);
pub(super) const EXPAND: Param<u64> = Param::integer(
    "expand",
    "n_e",
    "Cells a step",
    [0, (MAX_SIDE * MAX_SIDE) as u64, 0],
    "How many cells a step settles; the result is the same. 0: as many as there are cells, over 1024, so that no run takes more steps than that.",
)
.slider(0.0, 1000.0, false);
pub(super) const WEIGHT: Param<f64> = Param::number(
    "weight",
    "w",
    "Weight of the heuristic",
    [1.0, 5.0, 1.0],
    "What the way to the goal is multiplied by. 1: the path is the shortest. Above, fewer cells are settled, and the path may be up to that many times as long as the shortest: the gap shows it.",
);
pub(super) const BEST: Reading = Reading::new("best", "L", "Path found", Group::Cost, "The length of the path, once it is found.");
pub(super) const LOWEST: Reading = Reading::new(
    "f",
    "f_{\\min}",
    "Least on the frontier",
    Group::Cost,
    "The lowest f = g + h of a cell on the frontier. Where the heuristic is exact and unweighted it only rises, no path is shorter, and it ends as the path’s length.",
);
pub(super) const EXPANDED: Reading = Reading::new("expanded", "n_c", "Settled", Group::Count, "Cells settled so far.");
pub(super) const FRONTIER: Reading = Reading::new("frontier", "n_o", "Frontier", Group::Count, "Cells reached and not settled.");
pub(super) const FOUND_AFTER: Reading = CONVERGED.described("k^*", "Found after", "The step in which the path was found.");

/// What every search tells.
pub(super) const READINGS: &[Reading] =
    &[BEST, LOWEST, LENGTH, TURNS, TURNING, SMOOTH_LENGTH, SMOOTH_TURNS, SMOOTH_TURNING, EXPANDED, FRONTIER, FOUND_AFTER];

pub(super) const BOUND: Formula = Formula::of_item(
    "f",
    "Hart, Nilsson and Raphael 1968",
    "Length of the way over a cell, at least",
    "f(s) = \\class{way}{g(s)} + w\\,\\class{to-goal}{h(s)}",
    "f = \\class{way}{@g@} + @w@ \\cdot \\class{to-goal}{@h@} = @f@",
);
pub(super) const FORMULA_STEP: Formula = Formula::of_item(
    "g",
    "Dijkstra 1959",
    "Length of the way to a cell",
    "g(s') = \\min_s \\left(\\class{way}{g(s)} + \\class{step}{c(s, s')}\\right)",
    "g = \\class{way}{@g_parent@} + \\class{step}{@c@} = @g@",
);
pub(super) const FORMULA_SIGHT: Formula = Formula::of_item(
    "g",
    "Nash et al. 2007",
    "Length of the way to a cell",
    "g(s') = \\min_s \\begin{cases} \\class{way}{g(p)} + \\class{step}{c(p, s')} & \\text{if } p = \\operatorname{parent}(s) \\text{ sees } s' \\\\ \\class{way}{g(s)} + \\class{step}{c(s, s')} & \\text{otherwise} \\end{cases}",
    "g = \\class{way}{@g_parent@} + \\class{step}{@c@} = @g@",
);
pub(super) const FORMULA_OCTILE: Formula = Formula::of_item(
    "h",
    "octile distance",
    "Length of the way to the goal, at least",
    "\\class{to-goal}{h} = l \\left(\\max(\\Delta x, \\Delta y) + (\\sqrt 2 - 1) \\min(\\Delta x, \\Delta y)\\right)",
    "h = @side@ \\left(\\max(@dx@, @dy@) + (\\sqrt 2 - 1) \\min(@dx@, @dy@)\\right) = \\class{to-goal}{@h@}",
);
pub(super) const FORMULA_STRAIGHT: Formula = Formula::of_item(
    "h",
    "straight line",
    "Length of the way to the goal, at least",
    "\\class{to-goal}{h} = l \\sqrt{\\Delta x^2 + \\Delta y^2}",
    "h = @side@ \\sqrt{@dx@^2 + @dy@^2} = \\class{to-goal}{@h@}",
);

/// What every search draws.
pub(super) const LAYERS: &[Layer] = &[
    layers::CLOSED,
    layers::FRONTIER,
    layers::BEST.titled("Path", "The path, once the goal is settled."),
    layers::SMOOTHED.titled("Smoothed", "The path without its redundant nodes: the result that is handed over.").when("smooth", "true"),
    layers::WAY,
    layers::TO_GOAL,
    layers::STEP,
    layers::AFTER,
    layers::SUPPOSED,
];
