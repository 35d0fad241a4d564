//! `pso`: the swarm with constant coefficients, [WCPSO](crate#papers) (1) and (2).

use std::sync::Arc;

use crate::{
    describe::{Case, Entry},
    kernel::Started,
    params::Parameters,
};

use super::{
    encoding,
    flight::{Flight, Swarm},
    objective::Objective,
    parameters::{C1, C2, FLIGHT, ITERATIONS, KINDS, LAYERS, POPULATION, POSITION, PSEUDOCODE, READINGS, VELOCITY, W},
    paths::{CHARGED, ENCODED},
    schedule::{Law, Schedule},
};

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "discs",
        "A swarm finds its way",
        "Paths differ at first and agree in the end. Click one: which pull was the strongest?",
        "wcpso-discs",
        &[],
    ),
    Case::new(
        "crate",
        "Many hollows",
        "Particles fall into several hollows of the egg crate; the lowest draws them all.",
        "egg-crate",
        &[],
    ),
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "pso",
    "PSO: constant coefficients",
    "[WCPSO] §1",
    "Particles keep part of their velocity and are drawn to their own best and to the swarm’s. All coefficients stay constant.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[&[POPULATION.entry(), ITERATIONS.entry(), W.entry(), C1.entry(), C2.entry()], FLIGHT, ENCODED, CHARGED])
.readings(READINGS)
.formulas(&[VELOCITY, POSITION])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it on any objective; `settings` are the parameters of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64) -> Started {
    let [w, c1, c2] = [settings[W], settings[C1], settings[C2]].map(Law::Constant);
    Swarm::new(objective, settings, seed, Flight { schedule: Schedule { w, c1, c2 }, perturbation: None }).into()
}
