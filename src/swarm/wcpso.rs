//! `wcpso`: the swarm with trigonometric coefficients and hen/chick perturbation, [WCPSO] §2.

use crate::{
    describe::{Entry, Formula, Preset},
    params::{Choice, Fixed, Parameter, Settings},
};

use super::{
    encoding::with_paths,
    flight::Flight,
    parameters::{
        AS_IN_TEXT, CHICK, HEN, HEN_BEST, ITERATIONS, KINDS, LINEAR_W, PERTURBED, PERTURBED_LAYERS, POPULATION, POSITION, RANDOM, S1, S2,
        S2_SOURCE, V_MAX, V_MAX_UNIT, VELOCITY, W_MAX, W_MIN, schedule,
    },
    perturbation::{Keep, Partner, Perturbation, Sign, Timing},
    schedule::{Law, Schedule},
};

const C_A: Parameter = Parameter::number("c_a", "c_a", "Amplitude of c1", [0.0, 2.5, 1.0], "c1 falls from c_b + c_a to c_b − c_a, (4).");
const C_B: Parameter = Parameter::number("c_b", "c_b", "Middle of c1", [0.0, 5.0, 1.5], "c1 at half time, (4).");
const C_ALPHA: Parameter =
    Parameter::number("c_alpha", "c_\\alpha", "Amplitude of c2", [0.0, 2.5, 1.0], "c2 rises from c_β − c_α to c_β + c_α, (5).");
const C_BETA: Parameter = Parameter::number("c_beta", "c_\\beta", "Middle of c2", [0.0, 5.0, 1.5], "c2 at half time, (5).");
const TRIGONOMETRIC: Choice = Choice { value: "sine", title: "Sine", help: "Along half a sine wave, as published." };
const LINEAR: Choice = Choice { value: "linear", title: "Linear", help: "Linearly between the same values: tells what the wave is worth." };
const W_LAW: Parameter = Parameter::choice(
    "w_law",
    "",
    "Course of the inertia weight",
    &[Choice { value: "cosine", title: "Cosine", help: "Along half a cosine wave, (3), as published." }, LINEAR],
    "How ω falls over the iterations.",
);
const C1_LAW: Parameter = Parameter::choice("c1_law", "", "Course of c1", &[TRIGONOMETRIC, LINEAR], "How c1 falls over the iterations.");
const C2_LAW: Parameter = Parameter::choice("c2_law", "", "Course of c2", &[TRIGONOMETRIC, LINEAR], "How c2 rises over the iterations.");
const PERTURB: Parameter =
    Parameter::flag("perturb", "Hen and chick", true, "Whether particles that stagnate are perturbed, §2.2. Off: the schedules alone.");
const PATIENCE: Parameter = Parameter::integer(
    "patience",
    "n_p",
    "Patience",
    [1, 100, 3],
    "A particle whose cost rose in this many consecutive iterations is perturbed, §2.2.",
)
.slider(1.0, 20.0, false)
.when("perturb", "true");
const F_L: Parameter = Parameter::number(
    "f_l",
    "F_L",
    "Chick’s jump",
    [0.0, 4.0, 2.0],
    "How far across the best a chick jumps, (12): 1 onto it, 2 to its mirror image.",
)
.when("perturb", "true");
const S2_SIGN: Parameter = Parameter::choice(
    "s2",
    "s_2",
    "Sign in (11)",
    &[
        Choice { value: "printed", title: "As printed", help: "s2 = exp(f_i − f_t), as [WCPSO] (11) prints it." },
        Choice {
            value: "source",
            title: "As in its source",
            help: "s2 = exp(f_t − f_i), as in chicken swarm optimisation, where the equation comes from.",
        },
    ],
    "Which way the costs of the two particles are subtracted.",
)
.when("perturb", "true");
const HEN_TIMING: Parameter = Parameter::choice(
    "hen_timing",
    "",
    "Hen and chick jump",
    &[
        Choice {
            value: "instead",
            title: "Instead of flying",
            help: "A stagnating particle jumps in the next iteration and does not fly.",
        },
        Choice { value: "after", title: "After flying", help: "It jumps in the same iteration, after its flight." },
    ],
    "When a stagnating particle jumps. The paper does not say.",
)
.when("perturb", "true");
const HEN_KEEP: Parameter = Parameter::choice(
    "hen_keep",
    "",
    "Hen’s jump counts",
    &[
        Choice { value: "always", title: "Always", help: "The particle goes where the jump leads." },
        Choice { value: "better", title: "If better", help: "The particle stays where it is unless the jump lowers its cost." },
    ],
    "Which jumps of the hen count. The paper does not say.",
)
.when("perturb", "true");
const HEN_PARTNER: Parameter = Parameter::choice(
    "hen_partner",
    "",
    "Hen is drawn to",
    &[
        Choice { value: "position", title: "The other’s position", help: "x_t, where the other particle is: as printed in (9)." },
        Choice { value: "best", title: "The other’s best", help: "p_t, the other particle’s personal best." },
    ],
    "What the hen takes from the other particle t.",
)
.when("perturb", "true");

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

const LINEAR_COGNITIVE: Formula = schedule(
    "c1_linear",
    "[WCPSO] fig. 2, dashed",
    "Cognitive coefficient, linear",
    "c_1(k) = c_b + c_a - 2 c_a \\frac{k}{k_{\\max}}",
    "c_1(@k@) = @c_b@ + @c_a@ - 2 \\cdot @c_a@ \\cdot \\frac{@k@}{@iterations@} = @c1@",
)
.when("c1_law", "linear");
const LINEAR_SOCIAL: Formula = schedule(
    "c2_linear",
    "[WCPSO] fig. 3, dashed",
    "Social coefficient, linear",
    "c_2(k) = c_\\beta - c_\\alpha + 2 c_\\alpha \\frac{k}{k_{\\max}}",
    "c_2(@k@) = @c_beta@ - @c_alpha@ + 2 \\cdot @c_alpha@ \\cdot \\frac{@k@}{@iterations@} = @c2@",
)
.when("c2_law", "linear");

/// Between the same values at the same ends along a wave or straight.
fn law(settings: &Settings, name: &str, amplitude: f64, middle: f64) -> Law {
    if settings.choice(name) == "linear" { Law::Linear(middle + amplitude, middle - amplitude) } else { Law::Sine { amplitude, middle } }
}

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "wcpso",
    title: "WCPSO: hens and chicks",
    family: "swarm",
    source: "[WCPSO] §2",
    summary: "Inertia falls along a cosine, the pulls cross along sines, and particles that stagnate jump like hens, then like chicks.",
    kinds: KINDS,
    parameters: with_paths![
        POPULATION,
        ITERATIONS,
        W_MAX,
        W_MIN,
        C_A,
        C_B,
        C_ALPHA,
        C_BETA,
        PERTURB,
        PATIENCE,
        F_L,
        S2_SIGN,
        HEN_TIMING,
        HEN_KEEP,
        HEN_PARTNER,
        RANDOM,
        V_MAX,
        V_MAX_UNIT,
        W_LAW,
        C1_LAW,
        C2_LAW
    ],
    readings: PERTURBED,
    formulas: &[
        INERTIA.when("w_law", "cosine"),
        LINEAR_W.when("w_law", "linear"),
        COGNITIVE.when("c1_law", "sine"),
        LINEAR_COGNITIVE,
        SOCIAL.when("c2_law", "sine"),
        LINEAR_SOCIAL,
        VELOCITY,
        POSITION,
        HEN,
        HEN_BEST,
        S1,
        S2,
        S2_SOURCE,
        CHICK,
    ],
    layers: PERTURBED_LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[
        AS_IN_TEXT,
        Preset {
            name: "fitted",
            title: "Nearest to Table 2",
            help: "A variant chosen because it comes nearest to [WCPSO] Table 2 on f1 to f3 with 2 variables: ω from 0.9, one pair r1, r2 per particle, the hen after the flight whenever the cost rises, towards the personal best of the other, and only if that is better; no chick.",
            scene: "matyas",
            values: &[
                ("w_max", Fixed::Number(0.9)),
                ("random", Fixed::Text("particle")),
                ("patience", Fixed::Number(1.0)),
                ("f_l", Fixed::Number(0.0)),
                ("hen_timing", Fixed::Text("after")),
                ("hen_keep", Fixed::Text("better")),
                ("hen_partner", Fixed::Text("best")),
            ],
        },
    ],
    suggest: |_| None,
    start: |scene, settings, seed| {
        let (max, min) = (settings.number("w_max"), settings.number("w_min"));
        let schedule = Schedule {
            w: if settings.choice("w_law") == "linear" { Law::Linear(max, min) } else { Law::Cosine { max, min } },
            c1: law(settings, "c1_law", settings.number("c_a"), settings.number("c_b")),
            c2: law(settings, "c2_law", -settings.number("c_alpha"), settings.number("c_beta")),
        };
        let perturbation = settings.flag("perturb").then(|| Perturbation {
            patience: settings.integer("patience") as u8,
            f_l: settings.number("f_l"),
            sign: if settings.choice("s2") == "source" { Sign::Source } else { Sign::Printed },
            timing: if settings.choice("hen_timing") == "after" { Timing::After } else { Timing::Instead },
            keep: if settings.choice("hen_keep") == "better" { Keep::Better } else { Keep::Always },
            partner: if settings.choice("hen_partner") == "best" { Partner::Best } else { Partner::Position },
        });
        super::start(scene, settings, seed, Flight { schedule, perturbation })
    },
};
