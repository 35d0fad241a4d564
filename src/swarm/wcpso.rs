//! `wcpso`: the swarm with trigonometric coefficients and hen/chick perturbation, [WCPSO] §2.

use crate::{
    catalogue::{Entry, Formula},
    params::Parameter,
};

use super::{
    encoding::with_paths,
    flight::Flight,
    parameters::{
        CHICK, HEN, ITERATIONS, KINDS, PERTURBED, PERTURBED_LAYERS, POPULATION, POSITION, S1, S2, V_MAX, VELOCITY, W_MAX, W_MIN, schedule,
    },
    perturbation::Perturbation,
    schedule::{Law, Schedule},
};

const C_A: Parameter = Parameter::number("c_a", "c_a", "Amplitude of c1", [0.0, 2.5, 1.0], "c1 falls from c_b + c_a to c_b − c_a, (4).");
const C_B: Parameter = Parameter::number("c_b", "c_b", "Middle of c1", [0.0, 5.0, 1.5], "c1 at half time, (4).");
const C_ALPHA: Parameter =
    Parameter::number("c_alpha", "c_\\alpha", "Amplitude of c2", [0.0, 2.5, 1.0], "c2 rises from c_β − c_α to c_β + c_α, (5).");
const C_BETA: Parameter = Parameter::number("c_beta", "c_\\beta", "Middle of c2", [0.0, 5.0, 1.5], "c2 at half time, (5).");
const PATIENCE: Parameter = Parameter::integer(
    "patience",
    "n_p",
    "Patience",
    [1, 100, 3],
    "A particle whose cost rose in this many consecutive iterations is perturbed, §2.2.",
)
.slider(1.0, 20.0, false);
const F_L: Parameter = Parameter::number(
    "f_l",
    "F_L",
    "Chick’s jump",
    [0.0, 4.0, 2.0],
    "How far across the best a chick jumps, (12): 1 onto it, 2 to its mirror image.",
);

const INERTIA: Formula = schedule(
    "w",
    "[WCPSO] (3)",
    "Inertia weight",
    "\\omega(k) = \\frac{\\omega_{\\max} - \\omega_{\\min}}{2} \\cos\\frac{\\pi k}{k_{\\max}} + \\frac{\\omega_{\\max} + \\omega_{\\min}}{2}",
    "\\omega(@k@) = \\frac{@w_max@ - @w_min@}{2} \\cos\\frac{\\pi \\cdot @k@}{@iterations@} + \\frac{@w_max@ + @w_min@}{2} = @w@",
);
const COGNITIVE: Formula = schedule(
    "c1",
    "[WCPSO] (4)",
    "Cognitive coefficient",
    "c_1(k) = c_a \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{k_{\\max}/2 - k}{k_{\\max}/2}\\right) + c_b",
    "c_1(@k@) = @c_a@ \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{@iterations@/2 - @k@}{@iterations@/2}\\right) + @c_b@ = @c1@",
);
const SOCIAL: Formula = schedule(
    "c2",
    "[WCPSO] (5)",
    "Social coefficient",
    "c_2(k) = c_\\alpha \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{k - k_{\\max}/2}{k_{\\max}/2}\\right) + c_\\beta",
    "c_2(@k@) = @c_alpha@ \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{@k@ - @iterations@/2}{@iterations@/2}\\right) + @c_beta@ = @c2@",
);

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "wcpso",
    title: "WCPSO: hens and chicks",
    family: "swarm",
    source: "[WCPSO] §2",
    summary: "Inertia falls along a cosine, the pulls cross along sines, and particles that stagnate jump like hens, then like chicks.",
    kinds: KINDS,
    parameters: with_paths![POPULATION, ITERATIONS, W_MAX, W_MIN, C_A, C_B, C_ALPHA, C_BETA, PATIENCE, F_L, V_MAX],
    readings: PERTURBED,
    formulas: &[INERTIA, COGNITIVE, SOCIAL, VELOCITY, POSITION, HEN, S1, S2, CHICK],
    layers: PERTURBED_LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    suggest: |_| None,
    start: |scene, settings, seed| {
        let schedule = Schedule {
            w: Law::Cosine { max: settings.number("w_max"), min: settings.number("w_min") },
            c1: Law::Sine { amplitude: settings.number("c_a"), middle: settings.number("c_b") },
            c2: Law::Sine { amplitude: -settings.number("c_alpha"), middle: settings.number("c_beta") },
        };
        let perturbation = Perturbation { patience: settings.integer("patience") as u8, f_l: settings.number("f_l") };
        super::start(scene, settings, seed, Flight { schedule, perturbation: Some(perturbation) })
    },
};
