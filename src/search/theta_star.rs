//! `theta-star`: the search at any angle, Nash, Daniel, Koenig and Felner 2007.

use crate::{describe::Entry, way::SMOOTH};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_SIGHT, FORMULA_STRAIGHT, ITERATIONS, KINDS, LAYERS, READINGS},
    rules::{Heuristic, Relaxation},
};

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "theta-star",
    title: "Theta*: at any angle",
    family: "search",
    source: "Nash et al. 2007",
    summary: "A* whose cells are joined to their neighbour’s parent wherever they see it, so that paths go straight at any angle. They need not be the shortest there are.",
    kinds: KINDS,
    parameters: &[&[ITERATIONS.entry(), EXPAND.entry(), SMOOTH.entry()]],
    readings: READINGS,
    formulas: &[BOUND, FORMULA_SIGHT, FORMULA_STRAIGHT],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, _| super::start(scene, settings, Heuristic::Straight, 1.0, Relaxation::Sight),
};
