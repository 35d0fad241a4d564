//! `aco-direction`: ants that mind their direction, rewarded and punished by the median, [ANTBAT](crate#papers) §3.1.

use crate::{
    describe::{Case, Entry, Formula},
    params::{Choice, Param, ParamValue, Parameter, Parameters},
};

use super::{
    colony::Variant,
    ground::Direction,
    parameters::{ALPHA, ANTS, BETA, DISTANCE, EVAPORATION, ITERATIONS, KINDS, LAYERS, Q, READINGS, RHO, TAU_0, TAU_MIN, WALKS},
    planner,
    update::Update,
};

impl ParamValue for Direction {}

const GAMMA: Param<f64> = Param::number(
    "gamma",
    "\\gamma",
    "Weight of direction",
    [0.0, 20.0, 2.5],
    "How much it counts in an ant’s choice that a step goes straight on and towards the goal. Published: 2.5.",
);
const DIRECTION_LAW: Param<Direction> = Param::choice(
    "direction",
    "\\psi",
    "Angles in (2)",
    &[
        Choice::new("squared", "Squared", "exp(−((θ1/π)² + (θ2/π)²)): small turns cost little."),
        Choice::new("linear", "Linear", "exp(−(θ1 + θ2)/(π/2)): every turn costs in proportion."),
    ],
    &[Direction::Squared, Direction::Linear],
    "How the angles enter the direction factor. The scan of (2) is damaged; squares are the likelier reading.",
);
const Q_RELATIVE: Param<bool> = Param::choice(
    "q_unit",
    "",
    "Q in",
    &[
        Choice::new(
            "distance",
            "Distances from start to goal",
            "Q is multiplied by the straight distance from start to goal: it means the same on every map.",
        ),
        Choice::new("absolute", "The scene’s unit", "Q is taken as it is."),
    ],
    &[true, false],
    "What Q is measured in.",
);
const PHI1: Param<f64> = Param::number(
    "phi1",
    "\\varphi_1",
    "Reward by the median",
    [0.0, 1000.0, 1.0],
    "How much more an ant lays that went less than the median, and how much less one that went more. The paper gives no value.",
)
.slider(0.0, 10.0, false);
const PHI2: Param<f64> = Param::number(
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
    "p_{ij} = \\frac{\\class{step}{\\tau_{ij}^{\\alpha} \\, \\eta_j^{\\beta} \\, \\psi_{ij}^{\\gamma}}}{\\class{candidates}{\\sum_s \\tau_{is}^{\\alpha} \\, \\eta_s^{\\beta} \\, \\psi_{is}^{\\gamma}}}",
    "p = \\frac{\\class{step}{@tau@^{@alpha@} \\cdot @eta@^{@beta@} \\cdot @psi@^{@gamma@}}}{\\class{candidates}{@sum@}} = @p@",
);
const DIRECTION: Formula = Formula::of_item(
    "direction",
    "[ANTBAT] (2)",
    "Direction",
    "\\psi = \\exp\\left(-\\left(\\left(\\frac{\\class{way}{\\theta_1}}{\\pi}\\right)^2 + \\left(\\frac{\\class{to-goal}{\\theta_2}}{\\pi}\\right)^2\\right)\\right)",
    "\\psi = \\exp\\left(-\\frac{\\class{way}{@theta1@}^2 + \\class{to-goal}{@theta2@}^2}{\\pi^2}\\right) = @psi@",
)
.when(DIRECTION_LAW, "squared");
const DIRECTION_LINEAR: Formula = Formula::of_item(
    "direction_linear",
    "[ANTBAT] (2), linear reading",
    "Direction",
    "\\psi = \\exp\\left(-\\left(\\frac{\\class{way}{\\theta_1}}{\\pi/2} + \\frac{\\class{to-goal}{\\theta_2}}{\\pi/2}\\right)\\right)",
    "\\psi = \\exp\\left(-\\frac{\\class{way}{@theta1@} + \\class{to-goal}{@theta2@}}{\\pi/2}\\right) = @psi@",
)
.when(DIRECTION_LAW, "linear");
const REWARD: Formula = Formula::of_item(
    "laid",
    "[ANTBAT] (5)",
    "What an ant lays",
    "\\Delta\\tau^k = \\frac{Q}{\\class{way}{L_k}} + \\varphi_1 \\frac{L_{\\text{median}} - \\class{way}{L_k}}{L_{\\text{median}}} + \\varphi_2 \\frac{\\class{best}{L_{\\text{global}}} - \\class{way}{L_k}}{\\class{best}{L_{\\text{global}}}}",
    "\\Delta\\tau = \\frac{@q@}{\\class{way}{@length@}} + @phi1@ \\cdot \\frac{@median@ - \\class{way}{@length@}}{@median@} + @phi2@ \\cdot \\frac{\\class{best}{@global@} - \\class{way}{@length@}}{\\class{best}{@global@}} = @laid@",
);

const OWN: &[Parameter] = &[
    ANTS.entry(),
    ITERATIONS.entry(),
    ALPHA.entry(),
    BETA.entry(),
    GAMMA.entry(),
    DIRECTION_LAW.entry(),
    RHO.entry(),
    Q.default_to(50.0).slider(1.0, 100.0, false)
        .help("An ant lays Q / L on each step of a way of length L, before reward and punishment. The paper gives no value; with 50, colonies settle on random maps of every kind.")
        .entry(),
    Q_RELATIVE.entry(),
    PHI1.entry(),
    PHI2.entry(),
    TAU_0.default_to(10_000.0)
        .help("What lies on every step before the first ant sets out. The paper gives no value; as much as this keeps the first paths from deciding everything.")
        .entry(),
    TAU_MIN.default_to(0.1).entry(),
];

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "direction",
        "Ants with a sense of direction",
        "They prefer steps that go straight on and toward the goal, and agree within about ten iterations.",
        "ant-bat-30",
        &[],
    ),
    Case::new(
        "rooms",
        "Direction misleads in rooms",
        "Walls lead away from the goal: ants that mind its direction stay on a longer way.",
        "rooms-20",
        &[],
    ),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "every step from cell to cell begins with pheromone $\\tau_0$ = @tau_0@",
    "repeat until iteration @iterations@:",
    "  each of the @ants@ ants goes from the start, cell by cell:",
    "    probability $\\propto \\tau^\\alpha \\eta^\\beta \\psi^\\gamma$, with $\\alpha$ = @alpha@, $\\beta$ = @beta@, $\\gamma$ = @gamma@",
    "    it enters no cell twice",
    "    $\\psi$ is the larger, the less it turns and the nearer it keeps to the goal’s direction",
    "  ants at the goal: @arrived@, in a dead end: @stuck@",
    "  pheromone evaporates, with $\\rho$ = @rho@",
    "  each ant that arrived lays $Q / L$, more on ways below the median, less on others",
    "  the shortest path so far has length @length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "aco-direction",
    "ACO with direction",
    "[ANTBAT] §3.1, (2)–(5)",
    "Ants that would rather go straight on and towards the goal; ways under the median are rewarded, those above it punished.",
    |start| planner::start(start, variant(start.parameters)),
)
.family("ants")
.evaluating(crate::ants::EVALUATION)
.kinds(KINDS)
.parameters(&[OWN, WALKS])
.readings(READINGS)
.formulas(&[CHOICE, DISTANCE, DIRECTION, DIRECTION_LINEAR, EVAPORATION, REWARD])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// What sets this colony apart.
fn variant(settings: &Parameters) -> Variant {
    Variant {
        gamma: settings[GAMMA],
        direction: settings[DIRECTION_LAW],
        relative: settings[Q_RELATIVE],
        update: Update::Reward { phi1: settings[PHI1], phi2: settings[PHI2] },
        ..Variant::TRADITIONAL
    }
}
