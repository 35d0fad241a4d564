//! `dijkstra`: the search without a guess, Dijkstra 1959.

use crate::{describe::Entry, scene::grid_path::SMOOTH};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_STEP, ITERATIONS, KINDS, LAYERS, READINGS},
    planner,
    rules::{Heuristic, Relaxation},
};

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "dijkstra",
    "Dijkstra: exact, evenly outwards",
    "Dijkstra 1959",
    "Settles the cells in the order of their distance from the start until the goal is one of them. Exact from cell to cell.",
    |start| planner::start(start, Heuristic::Nothing, 1.0, Relaxation::Step),
)
.family("search")
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), EXPAND.entry(), SMOOTH.entry()]])
.readings(READINGS)
.formulas(&[BOUND, FORMULA_STEP])
.layers(LAYERS);
