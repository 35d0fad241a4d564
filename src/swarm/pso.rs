//! `pso`: the swarm with constant coefficients, [WCPSO](crate#papers) (1) and (2).

use crate::{
    describe::{Entry, Start},
    kernel::{Error, Started},
};

use super::{
    flight::Flight,
    parameters::{C1, C2, FLIGHT, ITERATIONS, KINDS, LAYERS, POPULATION, POSITION, READINGS, VELOCITY, W},
    paths::{CHARGED, ENCODED},
    schedule::{Law, Schedule},
    sheet::SYMBOLS,
};

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "pso",
    "PSO: constant coefficients",
    "[WCPSO] §1",
    "Particles keep part of their velocity and are drawn to their own best and to the swarm’s. All coefficients stay constant.",
    start,
)
.family("swarm")
.kinds(KINDS)
.parameters(&[&[POPULATION.entry(), ITERATIONS.entry(), W.entry(), C1.entry(), C2.entry()], FLIGHT, ENCODED, CHARGED])
.readings(READINGS)
.formulas(&[VELOCITY, POSITION])
.symbols(SYMBOLS)
.layers(LAYERS);

fn start(start: &Start) -> Result<Started, Error> {
    let settings = start.parameters;
    let [w, c1, c2] = [settings[W], settings[C1], settings[C2]].map(Law::Constant);
    super::start(start, Flight { schedule: Schedule { w, c1, c2 }, perturbation: None })
}
