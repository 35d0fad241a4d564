//! `aco-direction`: ants that mind their direction, rewarded and punished by the median, [ANTBAT] §3.1.

use crate::{
    describe::{Entry, Formula},
    params::{Choice, Parameter, Settings},
    way::SMOOTH,
};

use super::{
    Traits,
    aco::{ANTS, RHO},
    ground::Direction,
    parameters::{
        DEAD_END, DISTANCE, EVAPORATION, ITERATIONS, KINDS, LAYERS, PUBLISHED_ALPHA, PUBLISHED_BETA, READINGS, STEP_LIMIT, TAU_MAX, q,
        tau_0, tau_min,
    },
    update::Update,
};

const GAMMA: Parameter = Parameter::number(
    "gamma",
    "\\gamma",
    "Weight of direction",
    [0.0, 20.0, 2.5],
    "How much it counts in an ant’s choice that a step goes straight on and towards the goal. Published: 2.5.",
);
const DIRECTION_LAW: Parameter = Parameter::choice(
    "direction",
    "\\psi",
    "Angles in (2)",
    &[
        Choice { value: "squared", title: "Squared", help: "exp(−((θ1/π)² + (θ2/π)²)): small turns cost little." },
        Choice { value: "linear", title: "Linear", help: "exp(−(θ1 + θ2)/(π/2)): every turn costs in proportion." },
    ],
    "How the angles enter the direction factor. The scan of (2) is damaged; squares are the likelier reading.",
);
const Q_RELATIVE: Parameter = q(
    50.0,
    [1.0, 100.0],
    "An ant lays Q / L on each step of a way of length L, before reward and punishment. The paper gives no value; with 50, colonies settle on random maps of every kind.",
);
const TAU_0: Parameter = tau_0(
    10_000.0,
    "What lies on every step before the first ant sets out. The paper gives no value; as much as this keeps the first paths from deciding everything.",
);
const TAU_MIN: Parameter = tau_min(0.1);
const Q_UNIT: Parameter = Parameter::choice(
    "q_unit",
    "",
    "Q in",
    &[
        Choice {
            value: "distance",
            title: "Distances from start to goal",
            help: "Q is multiplied by the straight distance from start to goal: it means the same on every map.",
        },
        Choice { value: "absolute", title: "The scene’s unit", help: "Q is taken as it is." },
    ],
    "What Q is measured in.",
);
const PHI1: Parameter = Parameter::number(
    "phi1",
    "\\varphi_1",
    "Reward by the median",
    [0.0, 1000.0, 1.0],
    "How much more an ant lays that went less than the median, and how much less one that went more. The paper gives no value.",
)
.slider(0.0, 10.0, false);
const PHI2: Parameter = Parameter::number(
    "phi2",
    "\\varphi_2",
    "Reward by the best",
    [0.0, 1000.0, 1.0],
    "How much less an ant lays the longer its way is than the best so far. The paper gives no value.",
)
.slider(0.0, 10.0, false);

const CHOICE: Formula = Formula::of_item(
    "choice",
    "[ANTBAT] (3)",
    "Choice",
    "p_{ij} = \\frac{\\tau_{ij}^{\\alpha} \\, \\eta_j^{\\beta} \\, \\psi_{ij}^{\\gamma}}{\\sum_s \\tau_{is}^{\\alpha} \\, \\eta_s^{\\beta} \\, \\psi_{is}^{\\gamma}}",
    "p = \\frac{@tau@^{@alpha@} \\cdot @eta@^{@beta@} \\cdot @psi@^{@gamma@}}{@sum@} = @p@",
);
const DIRECTION: Formula = Formula::of_item(
    "direction",
    "[ANTBAT] (2)",
    "Direction",
    "\\psi = \\exp\\left(-\\left(\\left(\\frac{\\theta_1}{\\pi}\\right)^2 + \\left(\\frac{\\theta_2}{\\pi}\\right)^2\\right)\\right)",
    "\\psi = \\exp\\left(-\\frac{@theta1@^2 + @theta2@^2}{\\pi^2}\\right) = @psi@",
)
.when("direction", "squared");
const DIRECTION_LINEAR: Formula = Formula::of_item(
    "direction_linear",
    "[ANTBAT] (2), linear reading",
    "Direction",
    "\\psi = \\exp\\left(-\\left(\\frac{\\theta_1}{\\pi/2} + \\frac{\\theta_2}{\\pi/2}\\right)\\right)",
    "\\psi = \\exp\\left(-\\frac{@theta1@ + @theta2@}{\\pi/2}\\right) = @psi@",
)
.when("direction", "linear");
const REWARD: Formula = Formula::of_item(
    "laid",
    "[ANTBAT] (5)",
    "What an ant lays",
    "\\Delta\\tau^k = \\frac{Q}{L_k} + \\varphi_1 \\frac{L_{\\text{median}} - L_k}{L_{\\text{median}}} + \\varphi_2 \\frac{L_{\\text{global}} - L_k}{L_{\\text{global}}}",
    "\\Delta\\tau = \\frac{@q@}{@length@} + @phi1@ \\cdot \\frac{@median@ - @length@}{@median@} + @phi2@ \\cdot \\frac{@global@ - @length@}{@global@} = @laid@",
);

/// See the module.
pub const ENTRY: Entry = Entry {
    name: "aco-direction",
    title: "ACO with direction",
    family: "ants",
    source: "[ANTBAT] §3.1, (2)–(5)",
    summary: "Ants that would rather go straight on and towards the goal; ways under the median are rewarded, those above it punished.",
    kinds: KINDS,
    parameters: &[
        ANTS,
        ITERATIONS,
        PUBLISHED_ALPHA,
        PUBLISHED_BETA,
        GAMMA,
        DIRECTION_LAW,
        RHO,
        Q_RELATIVE,
        Q_UNIT,
        PHI1,
        PHI2,
        TAU_0,
        TAU_MIN,
        TAU_MAX,
        DEAD_END,
        STEP_LIMIT,
        SMOOTH,
    ],
    readings: READINGS,
    formulas: &[CHOICE, DISTANCE, DIRECTION, DIRECTION_LINEAR, EVAPORATION, REWARD],
    layers: LAYERS,
    stops: false,
    most_stops: None,
    members: &[],
    events: &[],
    presets: &[],
    suggest: |_| None,
    start: |scene, settings, seed| super::start(scene, settings, seed, traits(settings)),
};

/// What sets this colony apart.
pub(super) fn traits(settings: &Settings) -> Traits {
    Traits {
        gamma: settings.number("gamma"),
        direction: if settings.choice("direction") == "linear" { Direction::Linear } else { Direction::Squared },
        relative: settings.choice("q_unit") == "distance",
        update: Update::Reward { phi1: settings.number("phi1"), phi2: settings.number("phi2") },
        ..Traits::TRADITIONAL
    }
}
