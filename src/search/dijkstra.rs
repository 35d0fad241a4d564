//! `dijkstra`: the search without a guess, Dijkstra 1959.

use crate::{describe::Entry, way::SMOOTH};

use super::{
    parameters::{BOUND, EXPAND, FORMULA_STEP, ITERATIONS, KINDS, LAYERS, READINGS},
    rules::{Heuristic, Relaxation},
};

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "dijkstra",
    title: "Dijkstra: exact, evenly outwards",
    family: "search",
    source: "Dijkstra 1959",
    summary: "Settles the cells in the order of their distance from the start until the goal is one of them. Exact from cell to cell.",
    kinds: KINDS,
    parameters: &[&[ITERATIONS.entry(), EXPAND.entry(), SMOOTH.entry()]],
    readings: READINGS,
    formulas: &[BOUND, FORMULA_STEP],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, _| super::start(scene, settings, Heuristic::Nothing, 1.0, Relaxation::Step),
};
