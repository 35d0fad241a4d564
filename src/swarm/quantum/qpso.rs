//! `qpso`: the quantum swarm, [LTQPSO](crate#papers) §2.1.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, layers},
    kernel::Started,
    params::Parameters,
    swarm::{
        encoding,
        objective::Objective,
        parameters::{BEST, EVALUATIONS, FREE, GUIDES, K, KINDS, LENGTH, MEAN as MEAN_COST, SMOOTHED, SMOOTHNESS, SPREAD},
        paths::{CHARGED, ENCODED},
    },
};

use super::{
    leap::Quantum,
    parameters::{ALPHA, ALPHA_END, ALPHA_START, C1, C2, ITERATIONS, MEAN, PHI, POPULATION, WIDTH, suggest},
};

const ATTRACTOR: Formula = Formula::of_item(
    "attractor",
    "[LTQPSO] (2, 4)",
    "Local attractor",
    "\\class{attractors}{p_{ij}} = \\varphi P_{ij} + (1 - \\varphi) G_j = G_j + \\varphi (P_{ij} - G_j)",
    "p = @g@ + @phi@ \\, (@p@ - @g@) = \\class{attractors}{@attractor@}",
);
const LEAP: Formula = Formula::of_item(
    "leap",
    "[LTQPSO] (1, 23)",
    "Leap",
    "X_{ij} \\leftarrow \\class{attractors}{p_{ij}} \\pm \\alpha \\, |\\class{mean-best}{m_j} - X_{ij}| \\ln\\frac{1}{u}",
    "X = \\class{attractors}{@attractor@} + (@sign@) \\cdot @alpha@ \\cdot |\\class{mean-best}{@m@} - @x_before@| \\ln\\frac{1}{@u@} \\;\\to\\; @x@",
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "funnel",
    "Leaps without velocity",
    "Particles leap about their attractors, less far as α falls. Click one to see its leap.",
    "ackley-2",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ particles begins at a random position; none has a velocity",
    "repeat until iteration @iterations@, with $\\alpha$ = @alpha@:",
    "  $m \\leftarrow$ the mean of all personal bests $P$",
    "  for each particle, in each coordinate:",
    "    attractor $p$: a random point between its own best $P$ and the swarm’s $G$",
    "    $X \\leftarrow p \\pm \\alpha \\, |m - X| \\ln(1/u)$",
    "    if $f(X) < f(P)$: $P \\leftarrow X$",
    "  $G \\leftarrow$ the best $P$, with $f(G)$ = @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "qpso",
    "QPSO: quantum swarm",
    "[LTQPSO] §2.1",
    "No velocity: each particle leaps about a point between its own best and the swarm’s, the wider the farther it is from the mean of all bests.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[POPULATION.entry(), ITERATIONS.entry(), ALPHA_START.entry(), ALPHA_END.entry(), C1.entry(), C2.entry()],
    ENCODED,
    CHARGED,
])
.readings(&[BEST, MEAN_COST, SPREAD, FREE, LENGTH, SMOOTHNESS, K, ALPHA, EVALUATIONS])
.formulas(&[WIDTH, LEAP, ATTRACTOR, PHI, MEAN])
.layers(&[
    GUIDES,
    layers::PERSONAL_BESTS,
    layers::PARTICLES,
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
    Quantum::new(objective, settings, seed, None).into()
}
