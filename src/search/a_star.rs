//! `a-star`: the search with the octile heuristic, Hart, Nilsson and Raphael 1968.

use crate::{
    describe::{Case, Entry},
    scene::grid_path::SMOOTH,
};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_OCTILE, FORMULA_STEP, ITERATIONS, KINDS, LAYERS, READINGS, WEIGHT},
    planner,
    rules::{Heuristic, Relaxation},
};

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "rooms",
    "Toward the goal first",
    "A* closes the cells toward the goal first, and needs a third of Dijkstra’s steps here.",
    "rooms-20",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "$g(\\text{start}) = 0$; only the start is open",
    "repeat until the goal is closed:",
    "  take the open cell with the least $f = g + w h$, with $w$ = @weight@; the next has $f$ = @f@",
    "  close it; closed cells: @expanded@",
    "  for each free neighbour that it reaches by a shorter way:",
    "    set $g$ and the parent, and open the neighbour",
    "  open cells: @frontier@",
    "follow the parents back from the goal: length @length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "a-star",
    "A*: exact, towards the goal",
    "Hart, Nilsson and Raphael 1968",
    "Settles first the cells whose way from the start and least way to the goal are together shortest. Exact from cell to cell, with fewer cells than Dijkstra.",
    |start| planner::start(start, Heuristic::Octile, start.parameters[WEIGHT], Relaxation::Step),
)
.family("search")
.evaluating(crate::search::EVALUATION)
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), EXPAND.entry(), WEIGHT.entry(), SMOOTH.entry()]])
.readings(READINGS)
.formulas(&[BOUND, FORMULA_STEP, FORMULA_OCTILE])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE)
.exact(|parameters| parameters[WEIGHT] == 1.0 && !parameters[SMOOTH]);
