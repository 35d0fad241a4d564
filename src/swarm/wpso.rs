//! `wpso`: the swarm whose inertia weight falls linearly, [WCPSO] §3.1 and its reference [16].

use crate::{
    describe::{Entry, Preset},
    params::Fixed,
};

use super::{
    encoding::with_paths,
    flight::Flight,
    parameters::{
        AS_IN_TEXT, C1, C2, ITERATIONS, KINDS, LAYERS, LINEAR_W, POPULATION, POSITION, RANDOM, READINGS, V_MAX, V_MAX_UNIT, VELOCITY,
        W_MAX, W_MIN,
    },
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
    parameters: with_paths![POPULATION, ITERATIONS, W_MAX, W_MIN, C1.default_to(2.0), C2.default_to(2.0), RANDOM, V_MAX, V_MAX_UNIT],
    readings: READINGS,
    formulas: &[LINEAR_W, VELOCITY, POSITION],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[
        AS_IN_TEXT,
        Preset {
            name: "fitted",
            title: "Fitted to Table 2",
            help: "ω from 0.9 and c1 = c2 = 1.5, one pair r1, r2 per particle: chosen because [WCPSO] Table 2 then comes out on f1 to f3 with 2 variables.",
            scene: "matyas",
            values: &[
                ("w_max", Fixed::Number(0.9)),
                ("c1", Fixed::Number(1.5)),
                ("c2", Fixed::Number(1.5)),
                ("random", Fixed::Text("particle")),
            ],
        },
    ],
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
