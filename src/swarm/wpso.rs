//! `wpso`: the swarm whose inertia weight falls linearly, [WCPSO](crate#papers) §3.1 and its reference 16.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Preset},
    kernel::Started,
    params::{Fixed, Parameters},
};

use super::{
    encoding,
    flight::{Flight, Swarm},
    objective::Objective,
    parameters::{
        AS_IN_TEXT, C1, C2, FLIGHT, ITERATIONS, KINDS, LAYERS, LINEAR_W, POPULATION, POSITION, PSEUDOCODE, READINGS, VELOCITY, W_MAX, W_MIN,
    },
    paths::{CHARGED, ENCODED},
    schedule::{Law, Schedule},
};

const FITTED: Preset = Preset::new(
    "fitted",
    "Fitted to Table 2",
    "ω from 0.9 and c1 = c2 = 1.5, one pair r1, r2 per particle: chosen because [WCPSO] Table 2 then comes out on f1 to f3 with 2 variables.",
    "matyas",
    &[("w_max", Fixed::Number(0.9)), ("c1", Fixed::Number(1.5)), ("c2", Fixed::Number(1.5)), ("random", Fixed::Text("particle"))],
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "slalom",
    "Falling inertia",
    "The inertia weight falls, so steps get shorter. The swarm settles a few percent above the optimum.",
    "discs-slalom",
    &[],
)];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "wpso",
    "WPSO: linear inertia",
    "[WCPSO] §3.1",
    "The inertia weight falls linearly, so the swarm explores first and settles later.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[POPULATION.entry(), ITERATIONS.entry(), W_MAX.entry(), W_MIN.entry(), C1.default_to(2.0).entry(), C2.default_to(2.0).entry()],
    FLIGHT,
    ENCODED,
    CHARGED,
])
.readings(READINGS)
.formulas(&[LINEAR_W, VELOCITY, POSITION])
.layers(LAYERS)
.presets(&[AS_IN_TEXT, FITTED])
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it on any objective; `settings` are the parameters of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64) -> Started {
    let schedule =
        Schedule { w: Law::Linear(settings[W_MAX], settings[W_MIN]), c1: Law::Constant(settings[C1]), c2: Law::Constant(settings[C2]) };
    Swarm::new(objective, settings, seed, Flight { schedule, perturbation: None }).into()
}
