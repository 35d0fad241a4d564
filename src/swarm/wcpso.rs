//! `wcpso`: the swarm with trigonometric coefficients and hen/chick perturbation, [WCPSO](crate#papers) §2.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Preset},
    kernel::Started,
    params::{Choice, Fixed, Param, ParamValue, Parameters},
};

use super::{
    encoding,
    flight::{Flight, Swarm},
    objective::Objective,
    parameters::{
        AS_IN_TEXT, FLIGHT, ITERATIONS, KINDS, LINEAR_W, PERTURBED, PERTURBED_LAYERS, POPULATION, POSITION, VELOCITY, W_MAX, W_MIN,
    },
    paths::{CHARGED, ENCODED},
    perturbation::{Keep, Partner, Perturbation, Sign, Timing},
    schedule::{Law, Schedule},
};

impl ParamValue for Sign {}
impl ParamValue for Timing {}
impl ParamValue for Keep {}
impl ParamValue for Partner {}

const C_A: Param<f64> = Param::number("c_a", "c_a", "Amplitude of c1", [0.0, 2.5, 1.0], "c1 falls from c_b + c_a to c_b − c_a, (4).");
const C_B: Param<f64> = Param::number("c_b", "c_b", "Middle of c1", [0.0, 5.0, 1.5], "c1 at half time, (4).");
const C_ALPHA: Param<f64> =
    Param::number("c_alpha", "c_\\alpha", "Amplitude of c2", [0.0, 2.5, 1.0], "c2 rises from c_β − c_α to c_β + c_α, (5).");
const C_BETA: Param<f64> = Param::number("c_beta", "c_\\beta", "Middle of c2", [0.0, 5.0, 1.5], "c2 at half time, (5).");
const TRIGONOMETRIC: Choice = Choice::new("sine", "Sine", "Along half a sine wave, as published.");
const LINEAR: Choice = Choice::new("linear", "Linear", "Linearly between the same values: tells what the wave is worth.");
const W_LINEAR: Param<bool> = Param::choice(
    "w_law",
    "",
    "Course of the inertia weight",
    &[Choice::new("cosine", "Cosine", "Along half a cosine wave, (3), as published."), LINEAR],
    &[false, true],
    "How ω falls over the iterations.",
);
const C1_LINEAR: Param<bool> =
    Param::choice("c1_law", "", "Course of c1", &[TRIGONOMETRIC, LINEAR], &[false, true], "How c1 falls over the iterations.");
const C2_LINEAR: Param<bool> =
    Param::choice("c2_law", "", "Course of c2", &[TRIGONOMETRIC, LINEAR], &[false, true], "How c2 rises over the iterations.");
const PERTURB: Param<bool> =
    Param::flag("perturb", "Hen and chick", true, "Whether particles that stagnate are perturbed, §2.2. Off: the schedules alone.");
const PATIENCE: Param<u64> = Param::integer(
    "patience",
    "n_p",
    "Patience",
    [1, 100, 3],
    "A particle whose cost rose in this many consecutive iterations is perturbed, §2.2.",
)
.slider(1.0, 20.0, false)
.when(PERTURB, "true");
const F_L: Param<f64> = Param::number(
    "f_l",
    "F_L",
    "Chick’s jump",
    [0.0, 4.0, 2.0],
    "How far across the best a chick jumps, (12): 1 onto it, 2 to its mirror image.",
)
.when(PERTURB, "true");
const S2_SIGN: Param<Sign> = Param::choice(
    "s2",
    "s_2",
    "Sign in (11)",
    &[
        Choice::new("printed", "As printed", "s2 = exp(f_i − f_t), as [WCPSO] (11) prints it."),
        Choice::new("source", "As in its source", "s2 = exp(f_t − f_i), as in chicken swarm optimisation, where the equation comes from."),
    ],
    &[Sign::Printed, Sign::Source],
    "Which way the costs of the two particles are subtracted.",
)
.when(PERTURB, "true");
const HEN_TIMING: Param<Timing> = Param::choice(
    "hen_timing",
    "",
    "Hen and chick jump",
    &[
        Choice::new("instead", "Instead of flying", "A stagnating particle jumps in the next iteration and does not fly."),
        Choice::new("after", "After flying", "It jumps in the same iteration, after its flight."),
    ],
    &[Timing::Instead, Timing::After],
    "When a stagnating particle jumps. The paper does not say.",
)
.when(PERTURB, "true");
const HEN_KEEP: Param<Keep> = Param::choice(
    "hen_keep",
    "",
    "Hen’s jump counts",
    &[
        Choice::new("always", "Always", "The particle goes where the jump leads."),
        Choice::new("better", "If better", "The particle stays where it is unless the jump lowers its cost."),
    ],
    &[Keep::Always, Keep::Better],
    "Which jumps of the hen count. The paper does not say.",
)
.when(PERTURB, "true");
const HEN_PARTNER: Param<Partner> = Param::choice(
    "hen_partner",
    "",
    "Hen is drawn to",
    &[
        Choice::new("position", "The other’s position", "x_t, where the other particle is: as printed in (9)."),
        Choice::new("best", "The other’s best", "p_t, the other particle’s personal best."),
    ],
    &[Partner::Position, Partner::Best],
    "What the hen takes from the other particle t.",
)
.when(PERTURB, "true");

const INERTIA: Formula = Formula::new(
    "w",
    "[WCPSO] (3)",
    "Inertia weight",
    "\\omega(k) = \\frac{\\omega_{\\max} - \\omega_{\\min}}{2} \\cos\\frac{\\pi k}{k_{\\max}} + \\frac{\\omega_{\\max} + \\omega_{\\min}}{2}",
    "\\omega(@k@) = \\frac{@w_max@ - @w_min@}{2} \\cos\\frac{\\pi \\cdot @k@}{@iterations@} + \\frac{@w_max@ + @w_min@}{2} = @w@",
);
const COGNITIVE: Formula = Formula::new(
    "c1",
    "[WCPSO] (4)",
    "Cognitive coefficient",
    "c_1(k) = c_a \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{k_{\\max}/2 - k}{k_{\\max}/2}\\right) + c_b",
    "c_1(@k@) = @c_a@ \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{@iterations@/2 - @k@}{@iterations@/2}\\right) + @c_b@ = @c1@",
);
const SOCIAL: Formula = Formula::new(
    "c2",
    "[WCPSO] (5)",
    "Social coefficient",
    "c_2(k) = c_\\alpha \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{k - k_{\\max}/2}{k_{\\max}/2}\\right) + c_\\beta",
    "c_2(@k@) = @c_alpha@ \\sin\\left(\\frac{\\pi}{2} \\cdot \\frac{@k@ - @iterations@/2}{@iterations@/2}\\right) + @c_beta@ = @c2@",
);

const LINEAR_COGNITIVE: Formula = Formula::new(
    "c1_linear",
    "[WCPSO] fig. 2, dashed",
    "Cognitive coefficient, linear",
    "c_1(k) = c_b + c_a - 2 c_a \\frac{k}{k_{\\max}}",
    "c_1(@k@) = @c_b@ + @c_a@ - 2 \\cdot @c_a@ \\cdot \\frac{@k@}{@iterations@} = @c1@",
)
.when(C1_LINEAR, "linear");
const LINEAR_SOCIAL: Formula = Formula::new(
    "c2_linear",
    "[WCPSO] fig. 3, dashed",
    "Social coefficient, linear",
    "c_2(k) = c_\\beta - c_\\alpha + 2 c_\\alpha \\frac{k}{k_{\\max}}",
    "c_2(@k@) = @c_beta@ - @c_alpha@ + 2 \\cdot @c_alpha@ \\cdot \\frac{@k@}{@iterations@} = @c2@",
)
.when(C2_LINEAR, "linear");

const HEN: Formula = Formula::of_item(
    "hen",
    "[WCPSO] (9)",
    "Hen",
    "x \\leftarrow x + \\class{jump}{s_1 r (p_g - x) + s_2 r' (x_t - x)}",
    "x = @x_before@ + \\class{jump}{@s1@ \\cdot @r@ \\, (@g@ - @x_before@)} + \\class{jump}{@s2@ \\cdot @r_@ \\, (@x_t@ - @x_before@)} \\;\\to\\; @x@",
)
.when(HEN_PARTNER, "position");
const HEN_BEST: Formula = Formula::of_item(
    "hen_best",
    "[WCPSO] (9) with the personal best of the other",
    "Hen",
    "x \\leftarrow x + \\class{jump}{s_1 r (p_g - x) + s_2 r' (p_t - x)}",
    "x = @x_before@ + \\class{jump}{@s1@ \\cdot @r@ \\, (@g@ - @x_before@)} + \\class{jump}{@s2@ \\cdot @r_@ \\, (@x_t@ - @x_before@)} \\;\\to\\; @x@",
)
.when(HEN_PARTNER, "best");
const S1: Formula = Formula::of_item(
    "s1",
    "[WCPSO] (10)",
    "Pull of the best",
    "s_1 = \\exp\\frac{f_i - f_g}{|f_i| + \\varepsilon}",
    "s_1 = \\exp\\frac{@f_i@ - @f_g@}{|@f_i@| + \\varepsilon} = @s1@",
);
const S2: Formula = Formula::of_item(
    "s2",
    "[WCPSO] (11), exponent at most 1",
    "Pull of the other",
    "s_2 = \\exp\\left(f_i - f_t\\right)",
    "s_2 = \\exp\\left(\\min(@f_i@ - @f_t@,\\, 1)\\right) = @s2@",
)
.when(S2_SIGN, "printed");
const S2_SOURCE: Formula = Formula::of_item(
    "s2_source",
    "[WCPSO] (11) with the sign of its source, exponent at most 1",
    "Pull of the other",
    "s_2 = \\exp\\left(f_t - f_i\\right)",
    "s_2 = \\exp\\left(\\min(@f_t@ - @f_i@,\\, 1)\\right) = @s2@",
)
.when(S2_SIGN, "source");
const CHICK: Formula = Formula::of_item(
    "chick",
    "[WCPSO] (12)",
    "Chick",
    "x \\leftarrow x + F_L (p_g - x)",
    "x = @x_before@ + @f_l@ \\, (@g@ - @x_before@) \\;\\to\\; @x@",
);

/// Between the same values at the same ends along a wave or straight.
fn law(linear: bool, amplitude: f64, middle: f64) -> Law {
    if linear { Law::Linear(middle + amplitude, middle - amplitude) } else { Law::Sine { amplitude, middle } }
}

const FITTED: Preset = Preset::new(
    "fitted",
    "Nearest to Table 2",
    "A variant chosen because it comes nearest to [WCPSO] Table 2 on f1 to f3 with 2 variables: ω from 0.9, one pair r1, r2 per particle, the hen after the flight whenever the cost rises, towards the personal best of the other, and only if that is better; no chick.",
    "matyas",
    &[
        ("w_max", Fixed::Number(0.9)),
        ("random", Fixed::Text("particle")),
        ("patience", Fixed::Number(1.0)),
        ("f_l", Fixed::Number(0.0)),
        ("hen_timing", Fixed::Text("after")),
        ("hen_keep", Fixed::Text("better")),
        ("hen_partner", Fixed::Text("best")),
    ],
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "discs",
    "Hens and chicks",
    "Particles that stagnate jump (the paper’s hen and chick moves). The exact optimum is 12.1416.",
    "wcpso-discs",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ particles begins at a random position, with $v = 0$",
    "repeat until iteration @iterations@:",
    "  $\\omega$ = @w@, $c_1$ = @c1@, $c_2$ = @c2@: curves of the iteration",
    "  for each particle:",
    "    if its cost rose @patience@ times in a row: it jumps like a hen (@hens@ did)",
    "    if the hen’s jump did not help: it jumps like a chick (@chicks@ did)",
    "    otherwise: $v \\leftarrow \\omega v + c_1 r_1 (p - x) + c_2 r_2 (g - x)$, then $x \\leftarrow x + v$",
    "    if $f(x) < f(p)$: $p \\leftarrow x$",
    "  $g \\leftarrow$ the best $p$, with $f(g)$ = @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "wcpso",
    "WCPSO: hens and chicks",
    "[WCPSO] §2",
    "Inertia falls along a cosine, the pulls cross along sines, and particles that stagnate jump like hens, then like chicks.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[POPULATION.entry(), ITERATIONS.entry(), W_MAX.entry(), W_MIN.entry(), C_A.entry(), C_B.entry(), C_ALPHA.entry(), C_BETA.entry()],
    &[PERTURB.entry(), PATIENCE.entry(), F_L.entry(), S2_SIGN.entry(), HEN_TIMING.entry(), HEN_KEEP.entry(), HEN_PARTNER.entry()],
    FLIGHT,
    &[W_LINEAR.entry(), C1_LINEAR.entry(), C2_LINEAR.entry()],
    ENCODED,
    CHARGED,
])
.readings(PERTURBED)
.formulas(&[
    INERTIA.when(W_LINEAR, "cosine"),
    LINEAR_W.when(W_LINEAR, "linear"),
    COGNITIVE.when(C1_LINEAR, "sine"),
    LINEAR_COGNITIVE,
    SOCIAL.when(C2_LINEAR, "sine"),
    LINEAR_SOCIAL,
    VELOCITY,
    POSITION,
    HEN,
    HEN_BEST,
    S1,
    S2,
    S2_SOURCE,
    CHICK,
])
.layers(PERTURBED_LAYERS)
.presets(&[AS_IN_TEXT, FITTED])
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it on any objective; `settings` are the parameters of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64) -> Started {
    let (max, min) = (settings[W_MAX], settings[W_MIN]);
    let schedule = Schedule {
        w: if settings[W_LINEAR] { Law::Linear(max, min) } else { Law::Cosine { max, min } },
        c1: law(settings[C1_LINEAR], settings[C_A], settings[C_B]),
        c2: law(settings[C2_LINEAR], -settings[C_ALPHA], settings[C_BETA]),
    };
    let perturbation = settings[PERTURB].then(|| Perturbation {
        patience: settings[PATIENCE] as u8,
        f_l: settings[F_L],
        sign: settings[S2_SIGN],
        timing: settings[HEN_TIMING],
        keep: settings[HEN_KEEP],
        partner: settings[HEN_PARTNER],
    });
    Swarm::new(objective, settings, seed, Flight { schedule, perturbation }).into()
}
