//! `cpso`: the swarm whose accelerations change linearly, [WCPSO] §3.1 and its reference [18].

use crate::{
    catalogue::{Entry, Formula},
    params::Parameter,
};

use super::{
    encoding::with_paths,
    flight::Flight,
    parameters::{ITERATIONS, KINDS, LAYERS, POPULATION, POSITION, READINGS, V_MAX, VELOCITY, W, schedule},
    schedule::{Law, Schedule},
};

const C1_START: Parameter = Parameter::number(
    "c1_start",
    "c_{1,0}",
    "Cognitive coefficient at the start",
    [0.0, 5.0, 2.5],
    "c1 changes from here: first each for itself.",
);
const C1_END: Parameter =
    Parameter::number("c1_end", "c_{1,\\max}", "Cognitive coefficient at the end", [0.0, 5.0, 0.5], "c1 changes to here.");
const C2_START: Parameter =
    Parameter::number("c2_start", "c_{2,0}", "Social coefficient at the start", [0.0, 5.0, 0.5], "c2 changes from here.");
const C2_END: Parameter = Parameter::number(
    "c2_end",
    "c_{2,\\max}",
    "Social coefficient at the end",
    [0.0, 5.0, 2.5],
    "c2 changes to here: in the end all for one.",
);

const COGNITIVE: Formula = schedule(
    "c1",
    "[WCPSO] fig. 2, dashed",
    "Cognitive coefficient, linear",
    "c_1(k) = c_{1,0} + (c_{1,\\max} - c_{1,0}) \\frac{k}{k_{\\max}}",
    "c_1(@k@) = @c1_start@ + (@c1_end@ - @c1_start@) \\cdot \\frac{@k@}{@iterations@} = @c1@",
);
const SOCIAL: Formula = schedule(
    "c2",
    "[WCPSO] fig. 3, dashed",
    "Social coefficient, linear",
    "c_2(k) = c_{2,0} + (c_{2,\\max} - c_{2,0}) \\frac{k}{k_{\\max}}",
    "c_2(@k@) = @c2_start@ + (@c2_end@ - @c2_start@) \\cdot \\frac{@k@}{@iterations@} = @c2@",
);

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "cpso",
    title: "CPSO: linear accelerations",
    family: "swarm",
    source: "[WCPSO] §3.1",
    summary: "The pull of the own best falls linearly and that of the swarm’s best rises.",
    kinds: KINDS,
    parameters: with_paths![POPULATION, ITERATIONS, W, C1_START, C1_END, C2_START, C2_END, V_MAX],
    readings: READINGS,
    formulas: &[COGNITIVE, SOCIAL, VELOCITY, POSITION],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    suggest: |_| None,
    start: |scene, settings, seed| {
        let linear = |from, to| Law::Linear(settings.number(from), settings.number(to));
        let schedule =
            Schedule { w: Law::Constant(settings.number("w")), c1: linear("c1_start", "c1_end"), c2: linear("c2_start", "c2_end") };
        super::start(scene, settings, seed, Flight { schedule, perturbation: None })
    },
};
