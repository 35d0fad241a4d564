//! `pso`: the swarm with constant coefficients, [WCPSO] (1) and (2).

use crate::catalogue::Entry;

use super::{
    flight::Flight,
    parameters::{
        C1, C2, ITERATIONS, KINDS, LAYERS, ORDERED, PENALTY, PENALTY_WEIGHT, POPULATION, POSITION, READINGS, V_MAX, VELOCITY, W, WAYPOINTS,
    },
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
    parameters: &[POPULATION, ITERATIONS, W, C1, C2, V_MAX, WAYPOINTS, PENALTY, PENALTY_WEIGHT, ORDERED],
    readings: READINGS,
    formulas: &[VELOCITY, POSITION],
    layers: LAYERS,
    start: |scene, settings, seed| {
        let [w, c1, c2] = ["w", "c1", "c2"].map(|name| Law::Constant(settings.number(name)));
        Ok(super::start(scene, settings, seed, Flight { schedule: Schedule { w, c1, c2 }, perturbation: None }))
    },
};
