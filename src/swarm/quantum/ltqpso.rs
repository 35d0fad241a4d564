//! `ltqpso`: the quantum swarm with evolution speed, dispersion and natural selection, [LTQPSO](crate#papers) §2.2.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, layers},
    kernel::Started,
    params::{Choice, Param, Parameters},
    swarm::{
        encoding,
        objective::Objective,
        parameters::{BEST, EVALUATIONS, FREE, GUIDES, K, KINDS, LENGTH, MEAN as MEAN_COST, SMOOTHED, SMOOTHNESS, SPREAD},
        paths::{CHARGED, ENCODED},
    },
};

use super::{
    leap::{Adaptation, Quantum},
    parameters::{ALPHA, ALPHA_END, ALPHA_START, C1, C2, GS, IP, ITERATIONS, MEAN, PHI, POPULATION, SELECTED, WIDTH, suggest},
};

const ATTRACTOR: Formula = Formula::of_item(
    "attractor",
    "[LTQPSO] (7)",
    "Local attractor",
    "\\class{attractors}{p_{ij}} = G_j + \\varphi \\cdot ip_i \\, (P_{ij} - G_j)",
    "p = @g@ + @phi@ \\cdot @ip@ \\, (@p@ - @g@) = \\class{attractors}{@attractor@}",
);
const LEAP: Formula = Formula::of_item(
    "leap",
    "[LTQPSO] (9)",
    "Leap",
    "X_{ij} \\leftarrow \\class{attractors}{p_{ij}} \\pm \\alpha \\cdot gs_j \\, |\\class{mean-best}{m_j} - X_{ij}| \\ln\\frac{1}{u}",
    "X = \\class{attractors}{@attractor@} + (@sign@) \\cdot @alpha@ \\cdot @gs@ \\, |\\class{mean-best}{@m@} - @x_before@| \\ln\\frac{1}{@u@} \\;\\to\\; @x@",
);
const EVOLUTION: Formula =
    Formula::of_item("ip", "[LTQPSO] (5)", "Evolution speed", "ip_i = \\frac{F(G)}{F(P_i)}", "ip = \\frac{@f_g@}{@f_p@} = @ip@");
const DISPERSION: Formula = Formula::of_item(
    "gs",
    "[LTQPSO] (6)",
    "Dispersion",
    "gs_j = \\frac{\\sigma(P_{\\cdot j})}{\\sigma(X_{\\cdot j})}",
    "gs = \\frac{@sigma_p@}{@sigma_x@} \\;\\to\\; @gs@",
);

const EVOLVE: Param<bool> = Param::flag("evolution", "Evolution speed", true, "Whether ip scales the pull, (5) and (7). Off: ip = 1.");
const MOST_DISPERSION: Param<Option<f64>> = Param::choice(
    "dispersion",
    "",
    "Dispersion",
    &[
        Choice::new("capped", "At most 1", "gs of (6), at most 1, as in fig. 1."),
        Choice::new("uncapped", "As printed", "gs of (6); it may exceed 1."),
        Choice::new("off", "Off", "gs = 1."),
    ],
    &[Some(1.0), Some(f64::INFINITY), None],
    "How gs of (6) scales the leap.",
);
const SELECT: Param<bool> = Param::flag("selection", "Natural selection", true, "Whether the better half replaces the worse.");

/// The parts that are switched on.
pub(super) fn adaptation(settings: &Parameters) -> Adaptation {
    Adaptation { evolution: settings[EVOLVE], most_dispersion: settings[MOST_DISPERSION], selection: settings[SELECT] }
}

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "walls",
    "Ten metres of walls",
    "Particles leap less and less far. The robot can drive along the result.",
    "qpso-10m",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ particles begins at a random position; none has a velocity",
    "repeat until iteration @iterations@, with $\\alpha$ = @alpha@:",
    "  $m \\leftarrow$ the mean of all personal bests $P$; dispersion $gs$, on average @gs@",
    "  for each particle, with its evolution speed $ip$ (on average @ip@), in each coordinate:",
    "    attractor $p = G + \\varphi \\cdot ip \\, (P - G)$",
    "    $X \\leftarrow p \\pm \\alpha \\cdot gs \\, |m - X| \\ln(1/u)$",
    "    if $f(X) < f(P)$: $P \\leftarrow X$",
    "  the better half takes the places of the worse (@selected@ particles)",
    "  $G \\leftarrow$ the best $P$, with $f(G)$ = @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "ltqpso",
    "LTQPSO: evolving quantum swarm",
    "[LTQPSO] §2.2",
    "A quantum swarm whose pull follows each particle’s evolution speed and whose leaps follow the swarm’s dispersion; the better half then takes the worse half’s places.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[POPULATION.entry(), ITERATIONS.entry(), ALPHA_START.entry(), ALPHA_END.entry(), C1.entry(), C2.entry()],
    &[EVOLVE.entry(), MOST_DISPERSION.entry(), SELECT.entry()],
    ENCODED,
    CHARGED,
])
.readings(&[BEST, MEAN_COST, SPREAD, FREE, LENGTH, SMOOTHNESS, K, ALPHA, IP, GS, SELECTED, EVALUATIONS])
.formulas(&[WIDTH, LEAP, ATTRACTOR, PHI, EVOLUTION, DISPERSION, MEAN])
.layers(&[
    GUIDES,
    layers::PERSONAL_BESTS,
    layers::PARTICLES,
    layers::SELECTED,
    layers::ATTRACTORS,
    layers::MEAN_BEST,
    layers::BEST,
    SMOOTHED,
    layers::BEFORE,
    layers::JUMP,
    layers::AFTER,
    layers::SUPPOSED,
])
.suggest(suggest)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it on any objective; `settings` are the parameters of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64) -> Started {
    Quantum::new(objective, settings, seed, Some(adaptation(settings))).into()
}
