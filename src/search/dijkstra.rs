//! `dijkstra`: the search without a guess, Dijkstra 1959.

use crate::{
    describe::{Case, Entry},
    scene::grid_path::SMOOTH,
};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_STEP, ITERATIONS, KINDS, LAYERS, READINGS},
    planner,
    rules::{Heuristic, Relaxation},
};

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "rooms",
    "Evenly outwards",
    "Cells are closed by their distance from the start: three times as many as with A*, for the same length.",
    "rooms-20",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "$g(\\text{start}) = 0$; only the start is open",
    "repeat until the goal is closed:",
    "  take the open cell with the least $g$; the next has $g$ = @f@",
    "  close it; closed cells: @expanded@",
    "  for each free neighbour that it reaches by a shorter way:",
    "    set $g$ and the parent, and open the neighbour",
    "  open cells: @frontier@",
    "follow the parents back from the goal: length @length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "dijkstra",
    "Dijkstra: exact, evenly outwards",
    "Dijkstra 1959",
    "Settles the cells in the order of their distance from the start until the goal is one of them. Exact from cell to cell.",
    |start| planner::start(start, Heuristic::Nothing, 1.0, Relaxation::Step),
)
.family("search")
.evaluating(crate::search::EVALUATION)
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), EXPAND.entry(), SMOOTH.entry()]])
.readings(READINGS)
.formulas(&[BOUND, FORMULA_STEP])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE)
.exact(|parameters| !parameters[SMOOTH]);
