//! `a-star`: the search with the octile heuristic, Hart, Nilsson and Raphael 1968.

use crate::{describe::Entry, scene::grid_path::SMOOTH};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_OCTILE, FORMULA_STEP, ITERATIONS, KINDS, LAYERS, READINGS, WEIGHT},
    planner,
    rules::{Heuristic, Relaxation},
};

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "a-star",
    "A*: exact, towards the goal",
    "Hart, Nilsson and Raphael 1968",
    "Settles first the cells whose way from the start and least way to the goal are together shortest. Exact from cell to cell, with fewer cells than Dijkstra.",
    |start| planner::start(start, Heuristic::Octile, start.parameters[WEIGHT], Relaxation::Step),
)
.family("search")
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), EXPAND.entry(), WEIGHT.entry(), SMOOTH.entry()]])
.readings(READINGS)
.formulas(&[BOUND, FORMULA_STEP, FORMULA_OCTILE])
.layers(LAYERS);
