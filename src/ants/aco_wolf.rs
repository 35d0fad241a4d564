//! `aco-wolf`: ants that rank the cells around them, whose best is rewarded and whose worst is punished like wolves,
//! [WOLF-ANT](crate#papers) §5.1.

use crate::{
    describe::{Case, Entry, Formula, Preset},
    params::{Choice, Fixed, Param, ParamValue, Parameter, Parameters},
};

use super::{
    colony::Variant,
    ground::Heuristic,
    parameters::{ALPHA, ANTS, BETA, DISTANCE, ITERATIONS, KINDS, LAYERS, Q, READINGS, RHO, TAU_0, TAU_MIN, TRADITIONAL, WALKS},
    planner,
    update::Update,
};

impl ParamValue for Update {}

const EPSILON: Param<f64> = Param::number(
    "epsilon",
    "\\varepsilon",
    "Unit of sight",
    [0.0, 20.0, 2.0],
    "What the ranks 1 to 5 are multiplied by, [WOLF-ANT] (6). Published: 2. It cancels out of the choice (4) unless it is 0: then nothing is seen.",
);

const RANKS: Param<bool> = Param::choice(
    "heuristic",
    "",
    "Heuristic",
    &[Choice::new("ranks", "Ranks", "[WOLF-ANT] (6)."), Choice::new("distance", "Distance", "1 / distance to the goal.")],
    &[true, false],
    "What draws ants to the goal.",
);
const UPDATE: Param<Update> = Param::choice(
    "update",
    "",
    "Pheromone update",
    &[Choice::new("wolf", "Wolf pack", "[WOLF-ANT] (10) to (12)."), Choice::new("ant", "Traditional", "Q / L of every ant, (9) alone.")],
    &[Update::Wolf, Update::Traditional],
    "How much pheromone ants deposit.",
);

pub(crate) const CHOICE: Formula = Formula::of_item(
    "choice",
    "[WOLF-ANT] (4)",
    "Choice",
    "p_{ij} = \\frac{\\class{step}{\\tau_{ij}^{\\alpha} \\, \\eta_{ij}^{\\beta}}}{\\class{candidates}{\\sum_s \\tau_{is}^{\\alpha} \\, \\eta_{is}^{\\beta}}}",
    "p = \\frac{\\class{step}{@tau@^{@alpha@} \\cdot @eta@^{@beta@}}}{\\class{candidates}{@sum@}} = @p@",
);
pub(crate) const RANKED: Formula = Formula::of_item(
    "ranked",
    "[WOLF-ANT] (6)",
    "Sight by rank",
    "\\eta_{ij} = \\varepsilon \\cdot (5, 4, 4, 3, 3, 2, 2, 1) \\text{ by } \\class{to-goal}{\\text{distance to the goal}}",
    "\\eta = @epsilon@ \\cdot \\class{to-goal}{@rank@} = @eta@",
);
const PHEROMONE: Formula = Formula::new(
    "pheromone",
    "[WOLF-ANT] (10)",
    "Pheromone",
    "\\tau \\leftarrow (1 - \\rho) \\, \\tau + \\sum_a \\Delta\\tau^a + \\Delta\\tau_{\\text{best}} - \\Delta\\tau_{\\text{worst}}",
    "\\tau \\leftarrow (1 - @rho@) \\, \\tau + \\textstyle\\sum_{a=1}^{@arrived@} \\Delta\\tau^a + \\Delta\\tau_{\\text{best}} - \\Delta\\tau_{\\text{worst}}",
);
pub(crate) const LAID: Formula = Formula::of_item(
    "laid_shares",
    "[WOLF-ANT] (9), (11), (12)",
    "What an ant lays",
    "\\Delta\\tau^a = \\frac{Q}{\\class{way}{L_a}}, \\quad \\Delta\\tau_{\\text{best}} = \\delta \\frac{Q}{L_{\\text{best}}}, \\quad \\Delta\\tau_{\\text{worst}} = \\omega \\frac{Q}{L_{\\text{worst}}}",
    "\\Delta\\tau = @share@ \\cdot \\frac{@q@}{\\class{way}{@length@}} = @laid@",
);

const AS_IN_PAPER: Preset = Preset::new(
    "paper",
    "As in the paper",
    "β = 7 and ρ = 0.367, which [WOLF-ANT] found by a particle swarm on its map. Where obstacles lead away from the goal, paths become much longer than with the defaults.",
    "wolf-ant-20",
    &[("beta", Fixed::Number(7.0)), ("rho", Fixed::Number(0.367))],
);

const OWN: &[Parameter] = &[
    ANTS.default_to(30).help("How many ants set out in an iteration. Published: 30.").entry(),
    ITERATIONS.entry(),
    ALPHA.default_to(1.0).help("How much pheromone counts in an ant’s choice. Published: 1, found by a particle swarm.").entry(),
    BETA.default_to(1.0)
        .help("How much a cell’s rank counts in an ant’s choice. Published: 7, found by a particle swarm; ants then follow the rank into dead ends.")
        .entry(),
    RANKS.entry(),
    EPSILON.when(RANKS, "ranks").entry(),
    UPDATE.entry(),
    RHO.default_to(0.2)
        .help("The share of the pheromone that is gone after an iteration. Published: 0.367, found by a particle swarm.")
        .entry(),
    Q.default_to(333.0).slider(100.0, 1000.0, false)
        .help("An ant lays Q / L on each step of a way of length L, in the scene’s unit. Published: 333, found by a particle swarm.")
        .entry(),
    TAU_0.default_to(50.0)
        .help("What lies on every step before the first ant sets out. The paper gives no value; 50 is about what thirty ants keep on a way.")
        .entry(),
    TAU_MIN.default_to(1.0).entry(),
];

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "map",
        "The best way gets twice as much, the worst nothing",
        "The colony agrees after some forty iterations.",
        "wolf-ant-20",
        &[],
    ),
    Case::new(
        "misled",
        "Ranks mislead in rooms",
        "With the published parameters ants follow a cell’s rank even where walls lead away from the goal.",
        "rooms-20",
        &[("beta", Fixed::Number(7.0)), ("rho", Fixed::Number(0.367))],
    ),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "every step from cell to cell begins with pheromone $\\tau_0$ = @tau_0@",
    "repeat until iteration @iterations@:",
    "  each of the @ants@ ants goes from the start, cell by cell:",
    "    it takes a step with probability $\\propto \\tau^\\alpha \\eta^\\beta$, with $\\alpha$ = @alpha@ and $\\beta$ = @beta@",
    "    it enters no cell twice",
    "    $\\eta$ ranks the neighbours by their distance to the goal",
    "  ants at the goal: @arrived@, in a dead end: @stuck@",
    "  pheromone evaporates, with $\\rho$ = @rho@; each ant that arrived lays $Q / L$",
    "  the iteration’s best way gets $Q / L$ once more for each of its ants, its worst way nothing",
    "  the shortest path so far has length @length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "aco-wolf",
    "Wolf-pack ant colony",
    "[WOLF-ANT] §5.1",
    "Ants that rank the cells around them by their distance to the goal; an iteration’s best way gets twice the pheromone, its worst way none.",
    |start| planner::start(start, variant(start.parameters)),
)
.family("ants")
.evaluating(crate::ants::EVALUATION)
.kinds(KINDS)
.parameters(&[OWN, WALKS])
.readings(READINGS)
.formulas(&[
    CHOICE,
    RANKED.when(RANKS, "ranks"),
    DISTANCE.when(RANKS, "distance"),
    PHEROMONE,
    LAID.when(UPDATE, "wolf"),
    TRADITIONAL.when(UPDATE, "ant"),
])
.layers(LAYERS)
.presets(&[AS_IN_PAPER])
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// What sets this colony apart.
fn variant(settings: &Parameters) -> Variant {
    let heuristic = if settings[RANKS] { Heuristic::Ranked { epsilon: settings[EPSILON] } } else { Heuristic::Distance };
    Variant { heuristic, update: settings[UPDATE], ..Variant::TRADITIONAL }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Overrides, Value, scene::GRID};

    #[test]
    fn heuristic_and_update_are_switched_apart() {
        let of = |given: &[(&str, &str)]| {
            let given: Overrides = given.iter().map(|&(name, value)| (name, Value::from(value))).collect();
            let Variant { heuristic, update, .. } = variant(&Parameters::new(ENTRY.parameters, GRID, &given).unwrap());
            (matches!(heuristic, Heuristic::Ranked { epsilon } if epsilon == 2.0), matches!(update, Update::Wolf))
        };
        assert_eq!(of(&[]), (true, true));
        assert_eq!(of(&[("heuristic", "distance")]), (false, true));
        assert_eq!(of(&[("update", "ant")]), (true, false));
    }
}
