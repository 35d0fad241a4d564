//! `theta-star`: the search at any angle, Nash, Daniel, Koenig and Felner 2007.

use crate::{
    describe::{Case, Entry},
    scene::grid_path::SMOOTH,
};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_SIGHT, FORMULA_STRAIGHT, ITERATIONS, KINDS, LAYERS, READINGS},
    planner,
    rules::{Heuristic, Relaxation},
};

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "rooms",
    "Shortcuts by sight",
    "A cell keeps a parent that it sees, so paths turn only at corners: shorter than from cell to cell.",
    "rooms-20",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "$g(\\text{start}) = 0$; only the start is open",
    "repeat until the goal is closed:",
    "  take the open cell $s$ with the least $f = g + h$; the next has $f$ = @f@",
    "  close it; closed cells: @expanded@",
    "  for each free neighbour:",
    "    if the parent of $s$ sees it: that is the parent to try, otherwise $s$",
    "    if the way over it is shorter: set $g$ and the parent, and open the neighbour",
    "  open cells: @frontier@",
    "follow the parents back from the goal: length @length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "theta-star",
    "Theta*: at any angle",
    "Nash et al. 2007",
    "A* whose cells are joined to their neighbour’s parent wherever they see it, so that paths go straight at any angle. They need not be the shortest there are.",
    |start| planner::start(start, Heuristic::Straight, 1.0, Relaxation::Sight),
)
.family("search")
.evaluating(crate::search::EVALUATION)
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), EXPAND.entry(), SMOOTH.entry()]])
.readings(READINGS)
.formulas(&[BOUND, FORMULA_SIGHT, FORMULA_STRAIGHT])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);
