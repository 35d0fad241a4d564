//! `cpso`: the swarm whose accelerations change linearly, [WCPSO](crate#papers) §3.1 and its reference 18.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Preset},
    kernel::Started,
    params::{Choice, Fixed, Param, Parameters},
};

use super::{
    encoding,
    flight::{Flight, Swarm},
    objective::Objective,
    parameters::{
        AS_IN_TEXT, FLIGHT, ITERATIONS, KINDS, LAYERS, LINEAR_W, POPULATION, POSITION, PSEUDOCODE, READINGS, VELOCITY, W, W_MAX, W_MIN,
    },
    paths::{CHARGED, ENCODED},
    schedule::{Law, Schedule},
};

const W_LINEAR: Param<bool> = Param::choice(
    "w_law",
    "",
    "Course of the inertia weight",
    &[
        Choice::new("constant", "Constant", "ω stays what it is, as in the text."),
        Choice::new("linear", "Linear", "ω falls linearly, as in wpso."),
    ],
    &[false, true],
    "How ω changes over the iterations.",
);
const C1_START: Param<f64> = Param::number(
    "c1_start",
    "c_{1,0}",
    "Cognitive coefficient at the start",
    [0.0, 5.0, 2.5],
    "c1 changes from here: first each for itself.",
);
const C1_END: Param<f64> =
    Param::number("c1_end", "c_{1,\\max}", "Cognitive coefficient at the end", [0.0, 5.0, 0.5], "c1 changes to here.");
const C2_START: Param<f64> =
    Param::number("c2_start", "c_{2,0}", "Social coefficient at the start", [0.0, 5.0, 0.5], "c2 changes from here.");
const C2_END: Param<f64> =
    Param::number("c2_end", "c_{2,\\max}", "Social coefficient at the end", [0.0, 5.0, 2.5], "c2 changes to here: in the end all for one.");

const COGNITIVE: Formula = Formula::new(
    "c1",
    "[WCPSO] fig. 2, dashed",
    "Cognitive coefficient, linear",
    "c_1(k) = c_{1,0} + (c_{1,\\max} - c_{1,0}) \\frac{k}{k_{\\max}}",
    "c_1(@k@) = @c1_start@ + (@c1_end@ - @c1_start@) \\cdot \\frac{@k@}{@iterations@} = @c1@",
);
const SOCIAL: Formula = Formula::new(
    "c2",
    "[WCPSO] fig. 3, dashed",
    "Social coefficient, linear",
    "c_2(k) = c_{2,0} + (c_{2,\\max} - c_{2,0}) \\frac{k}{k_{\\max}}",
    "c_2(@k@) = @c2_start@ + (@c2_end@ - @c2_start@) \\cdot \\frac{@k@}{@iterations@} = @c2@",
);

const FITTED: Preset = Preset::new(
    "fitted",
    "Fitted to Table 2",
    "ω falls from 0.95 to 0.4, one pair r1, r2 per particle: chosen because [WCPSO] Table 2 then comes out on f1 to f3 with 2 variables.",
    "matyas",
    &[("w_law", Fixed::Text("linear")), ("random", Fixed::Text("particle"))],
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "discs",
    "From own bests to the swarm’s",
    "At first the own best pulls more, later the swarm’s: paths spread, then gather.",
    "wcpso-discs",
    &[],
)];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "cpso",
    "CPSO: linear accelerations",
    "[WCPSO] §3.1",
    "The pull of the own best falls linearly and that of the swarm’s best rises.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[POPULATION.entry(), ITERATIONS.entry(), W_LINEAR.entry()],
    &[W.when(W_LINEAR, "constant").entry(), W_MAX.when(W_LINEAR, "linear").entry(), W_MIN.when(W_LINEAR, "linear").entry()],
    &[C1_START.entry(), C1_END.entry(), C2_START.entry(), C2_END.entry()],
    FLIGHT,
    ENCODED,
    CHARGED,
])
.readings(READINGS)
.formulas(&[LINEAR_W.when(W_LINEAR, "linear"), COGNITIVE, SOCIAL, VELOCITY, POSITION])
.layers(LAYERS)
.presets(&[AS_IN_TEXT, FITTED])
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it on any objective; `settings` are the parameters of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64) -> Started {
    let schedule = Schedule {
        w: if settings[W_LINEAR] { Law::Linear(settings[W_MAX], settings[W_MIN]) } else { Law::Constant(settings[W]) },
        c1: Law::Linear(settings[C1_START], settings[C1_END]),
        c2: Law::Linear(settings[C2_START], settings[C2_END]),
    };
    Swarm::new(objective, settings, seed, Flight { schedule, perturbation: None }).into()
}
