//! `wpso`: the swarm whose inertia weight falls linearly, [WCPSO] §3.1 and its reference [16].

use crate::catalogue::Entry;

use super::{
    encoding::with_paths,
    flight::Flight,
    parameters::{C1, C2, ITERATIONS, KINDS, LAYERS, LINEAR_W, POPULATION, POSITION, READINGS, V_MAX, VELOCITY, W_MAX, W_MIN},
    schedule::{Law, Schedule},
};

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "wpso",
    title: "WPSO: linear inertia",
    family: "swarm",
    source: "[WCPSO] §3.1",
    summary: "The inertia weight falls linearly, so the swarm explores first and settles later.",
    kinds: KINDS,
    parameters: with_paths![POPULATION, ITERATIONS, W_MAX, W_MIN, C1.default_to(2.0), C2.default_to(2.0), V_MAX],
    readings: READINGS,
    formulas: &[LINEAR_W, VELOCITY, POSITION],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    suggest: |_| None,
    start: |scene, settings, seed| {
        let schedule = Schedule {
            w: Law::Linear(settings.number("w_max"), settings.number("w_min")),
            c1: Law::Constant(settings.number("c1")),
            c2: Law::Constant(settings.number("c2")),
        };
        super::start(scene, settings, seed, Flight { schedule, perturbation: None })
    },
};
