//! `theta-star`: the search at any angle, Nash, Daniel, Koenig and Felner 2007.

use crate::{describe::Entry, scene::grid_path::SMOOTH};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_SIGHT, FORMULA_STRAIGHT, ITERATIONS, KINDS, LAYERS, READINGS},
    planner,
    rules::{Heuristic, Relaxation},
};

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "theta-star",
    "Theta*: at any angle",
    "Nash et al. 2007",
    "A* whose cells are joined to their neighbour’s parent wherever they see it, so that paths go straight at any angle. They need not be the shortest there are.",
    |start| planner::start(start, Heuristic::Straight, 1.0, Relaxation::Sight),
)
.family("search")
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), EXPAND.entry(), SMOOTH.entry()]])
.readings(READINGS)
.formulas(&[BOUND, FORMULA_SIGHT, FORMULA_STRAIGHT])
.layers(LAYERS);
