//! `pso`: the swarm with constant coefficients, [WCPSO] (1) and (2).

use crate::describe::Entry;

use super::{
    encoding::with_paths,
    flight::Flight,
    parameters::{C1, C2, ITERATIONS, KINDS, LAYERS, POPULATION, POSITION, RANDOM, READINGS, V_MAX, V_MAX_UNIT, VELOCITY, W},
    schedule::{Law, Schedule},
};

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "pso",
    title: "PSO: constant coefficients",
    family: "swarm",
    source: "[WCPSO] §1",
    summary: "Particles keep part of their velocity and are drawn to their own best and to the swarm’s. All coefficients stay constant.",
    kinds: KINDS,
    parameters: with_paths![POPULATION, ITERATIONS, W, C1, C2, RANDOM, V_MAX, V_MAX_UNIT],
    readings: READINGS,
    formulas: &[VELOCITY, POSITION],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, seed| {
        let [w, c1, c2] = ["w", "c1", "c2"].map(|name| Law::Constant(settings.number(name)));
        super::start(scene, settings, seed, Flight { schedule: Schedule { w, c1, c2 }, perturbation: None })
    },
};
