//! `bat-continuous`: bats with frequency, velocity and position, [ANTBAT](crate#papers) (7)–(11), which the discrete bats come
//! from.
//!
//! Readings. The paper prints the equations and no more; what it leaves open is Yang's (2010): with its pulse rate as the
//! probability not to, a bat walks about the best instead of flying, as far as the bats are loud on average; it accepts a
//! position that is not worse than its own with its loudness as the probability, and only then gets quieter. The best
//! position that was ever evaluated is kept, accepted or not. As printed, (8) adds x − x_best: bats fly away from the best.

mod explain;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use crate::{
    describe::{Case, Entry, Formula, Group, Layer, Preset, Reading, layers},
    kernel::{Candidate, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, Started, State, rng::Stream},
    math::{self, clamp},
    message,
    params::{Choice, Fixed, Param, Parameters},
};

use super::{
    clock::Clock,
    encoding,
    objective::Objective,
    parameters::{
        BEST, EVALUATIONS, FREE, GUIDES, ITERATIONS, K, KINDS, LENGTH, MEAN, POPULATION, POSITION, SMOOTHED, SMOOTHNESS, SPREAD, V_MAX,
        V_MAX_ABSOLUTE,
    },
    paths::{CHARGED, ENCODED},
    population::{Held, Population},
    sheet,
};

/// Bats: v ← v ± (x − g) f, x ← x + v, and walks about the best.
#[derive(Clone, State)]
struct Bats {
    population: Population,
    /// Velocities v.
    v: Vec<f64>,
    /// The most each coordinate of a velocity may be.
    #[state(shared)]
    v_max: Arc<[f64]>,
    /// How far a walk leads at a loudness of 1, for each coordinate.
    #[state(shared)]
    stride: Arc<[f64]>,
    loudness: Vec<f64>,
    pulse_rate: Vec<f64>,
    last: Vec<Last>,
    /// f_min and f_max.
    #[state(shared)]
    frequencies: [f64; 2],
    /// One β for all coordinates of a bat instead of one for each.
    #[state(shared)]
    per_particle: bool,
    /// Of x − g in (8): 1 as printed, −1 toward the best.
    #[state(shared)]
    sign: f64,
    /// ε and λ.
    #[state(shared)]
    epsilon: f64,
    #[state(shared)]
    lambda: f64,
    /// The mean loudness before the step that led here.
    mean_loudness: f64,
    /// Where bats were before they moved.
    #[state(skip)]
    held: Held,
    rng: Stream,
    clock: Clock,
}

/// What a bat did in the last iteration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
struct Last {
    walked: bool,
    accepted: bool,
}

/// One coordinate of a bat's move.
#[derive(Debug, Clone, Copy)]
struct Term {
    /// The frequency f.
    f: f64,
    /// The velocity, limited.
    v: f64,
    /// The random number ε of a walk; 0 if it flew.
    epsilon: f64,
    /// The candidate.
    to: f64,
}

/// Sees one bat's move. `()` sees nothing and costs nothing.
trait Watch {
    /// Which one it watches.
    fn particle(&self) -> Option<usize> {
        None
    }
    /// It is about to be moved.
    fn begins(&mut self, _bats: &mut Bats) {}
    fn term(&mut self, _term: Term) {}
}

impl Watch for () {}

/// Starts it on any objective; `settings` are the parameters of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64) -> Started {
    let mut rng = Stream::new(seed, 0);
    let population = Population::new(objective, settings[POPULATION] as usize, &mut rng);
    let size = population.size;
    let sides: Vec<_> = population.objective.search_box().sides().collect();
    let (v_max, absolute) = (settings[V_MAX], settings[V_MAX_ABSOLUTE]);
    let [low, high] = [settings[F_MIN], settings[F_MAX]];
    let bats = Bats {
        v: vec![0.0; population.x.len()],
        v_max: sides.iter().map(|side| if absolute { v_max } else { v_max * side }).collect(),
        stride: sides.iter().map(|side| settings[WALK] * side).collect(),
        loudness: vec![settings[A0]; size],
        pulse_rate: vec![settings[R0]; size],
        last: vec![Last { walked: false, accepted: false }; size],
        frequencies: [low, high.max(low)],
        per_particle: settings[PER_BAT],
        sign: settings[PULL],
        epsilon: settings[EPSILON],
        lambda: settings[LAMBDA],
        mean_loudness: settings[A0],
        held: Held::new(&population),
        rng,
        clock: Clock::new(settings, population.bests()),
        population,
    };
    bats.clock.start(bats)
}

impl Bats {
    /// One iteration. `watch` sees the move of a bat that somebody asked about.
    fn iterate(&mut self, watch: &mut dyn Watch) -> Progress {
        let watched = watch.particle();
        if !self.population.is_under_way() {
            self.mean_loudness = mean(&self.loudness);
        }
        let t = (self.clock.iteration + 1) as f64;
        let fading = 1.0 - math::exp(-self.lambda * t);
        let part = self.population.next_part(1);
        self.held.hold(&self.population, part.clone());
        for i in part.clone() {
            if watched == Some(i) {
                watch.begins(self);
            }
            let walked = self.rng.unit() > self.pulse_rate[i];
            if watched == Some(i) {
                self.fly(i, walked, watch);
            } else {
                self.fly(i, walked, &mut ());
            }
            self.last[i] = Last { walked, accepted: self.rng.unit() < self.loudness[i] };
        }
        self.population.evaluate_all(part.clone());
        for i in part {
            let accepted = self.last[i].accepted && self.population.cost[i] <= self.held.cost(i);
            self.last[i].accepted = accepted;
            if accepted {
                self.loudness[i] *= self.epsilon; // (10)
                self.pulse_rate[i] *= fading; // (11)
            } else {
                self.held.put_back(&mut self.population, i);
            }
        }
        if self.population.is_under_way() {
            return Progress::Partly;
        }
        self.population.end(&mut self.clock)
    }

    /// (7) to (9), or a walk about the best. Reading: velocities are limited, positions are kept in the box, and a coordinate
    /// that hits a wall stops.
    fn fly<W: Watch + ?Sized>(&mut self, i: usize, walked: bool, watch: &mut W) {
        let row = self.population.row(i);
        let Population { x, g, objective, .. } = &mut self.population;
        let search_box = objective.search_box();
        let (x, v) = (&mut x[row.clone()], &mut self.v[row]);
        let [low, high] = self.frequencies;
        let shared = self.per_particle.then(|| self.rng.unit());
        for j in 0..x.len() {
            let f = low + (high - low) * shared.unwrap_or_else(|| self.rng.unit()); // (7)
            let step = clamp(v[j] + self.sign * (x[j] - g[j]) * f, -self.v_max[j], self.v_max[j]); // (8)
            let epsilon = if walked { self.rng.between(-1.0, 1.0) } else { 0.0 };
            let reached = if walked { g[j] + epsilon * self.mean_loudness * self.stride[j] } else { x[j] + step }; // (9)
            x[j] = search_box.clamp(j, reached);
            v[j] = if walked || x[j] == reached { step } else { 0.0 };
            watch.term(Term { f, v: step, epsilon, to: x[j] });
        }
    }
}

fn mean(of: &[f64]) -> f64 {
    of.iter().sum::<f64>() / of.len() as f64
}

impl Planner for Bats {
    fn advance(&mut self) -> Progress {
        self.iterate(&mut ())
    }

    fn evaluations(&self) -> u64 {
        self.population.evaluations
    }

    fn best(&self) -> Option<Candidate> {
        Some(self.population.best())
    }

    fn read(&self, out: &mut Readings) {
        self.population.read(out);
        out.push(K, self.clock.iteration.saturating_sub(1) as f64);
        out.push(MEAN_LOUDNESS, mean(&self.loudness));
        out.push(MEAN_PULSE_RATE, mean(&self.pulse_rate));
        out.push(ACCEPTED, self.last.iter().filter(|last| last.accepted).count() as f64);
        out.push(EVALUATIONS, self.population.evaluations as f64);
    }

    fn draw(&self, frame: &mut Frame) {
        self.population.draw_members(frame);
        self.population.draw_velocities(frame, &self.v);
        self.population.draw_result(frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).failure(&self.population)
    }
}

impl Explain for Bats {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        let i = item.index;
        let origin = message!("swarm-bat-begins", "Bat {i} begins here, drawn at random; its velocity is zero.", i);
        let mut inspection = (self.clock.iteration == 0).then(|| sheet::introduce(&self.population, item, origin)).flatten()?;
        inspection.title = message!("swarm-bat", "Bat {i}", i);
        Some(inspection)
    }

    fn explain_next(&self, item: Item) -> Option<Inspection> {
        self.explain_step(item, None)
    }

    fn suppose(&self, item: Item, supposition: &str, others: &Stream) -> Option<Inspection> {
        self.explain_step(item, Some((supposition, others)))
    }
}

const F_MIN: Param<f64> =
    Param::number("f_min", "f_{\\min}", "Lowest frequency", [0.0, 100.0, 0.0], "The least that f of (7) can be.").slider(0.0, 2.0, false);
const F_MAX: Param<f64> = Param::number(
    "f_max",
    "f_{\\max}",
    "Highest frequency",
    [0.0, 100.0, 2.0],
    "The most that f of (7) can be; at least f_min. The higher, the faster velocities change. Yang’s programme: 2.",
)
.slider(0.0, 5.0, false);
const PULL: Param<f64> = Param::choice(
    "pull",
    "",
    "Sign in (8)",
    &[
        Choice::new("toward", "Toward the best", "v ← v + (x_best − x) f: bats fly toward the best."),
        Choice::new("printed", "As printed", "v ← v + (x − x_best) f, as (8) and Yang print it: bats fly away from the best."),
    ],
    &[-1.0, 1.0],
    "In which direction the best changes a velocity.",
);
const WALK: Param<f64> = Param::number(
    "walk",
    "s",
    "Length of a walk",
    [0.0, 1.0, 0.01],
    "How far from the best a walk leads at most, as a share of the search box’s side, at a mean loudness of 1.",
)
.slider(0.0, 0.1, false);
const A0: Param<f64> = Param::number(
    "a0",
    "A_0",
    "Loudness at the start",
    [0.0, 1.0, 1.0],
    "With what probability a bat accepts a position that is not worse, at first.",
);
const R0: Param<f64> = Param::number(
    "r0",
    "r_0",
    "Pulse rate at the start",
    [0.0, 1.0, 0.5],
    "With what probability a bat flies instead of walking about the best, at first.",
);
const PER_BAT: Param<bool> = Param::choice(
    "random",
    "\\beta",
    "Random numbers",
    &[
        Choice::new("coordinate", "Each coordinate", "Each coordinate of a bat has a frequency of its own."),
        Choice::new("particle", "Each bat", "All coordinates of a bat share one frequency."),
    ],
    &[false, true],
    "How often β of (7) is drawn. The paper calls it a random vector; Yang’s programme draws one number for each bat.",
);
const EPSILON: Param<f64> = Param::number(
    "epsilon",
    "\\varepsilon",
    "Fading of loudness",
    [0.0, 1.0, 0.98],
    "What a bat’s loudness is multiplied by when it accepts a position, (10). Published: 0.98.",
);
const LAMBDA: Param<f64> = Param::number(
    "lambda",
    "\\lambda",
    "Pulse coefficient",
    [0.0, 100.0, 0.98],
    "How fast the factor 1 − e^(−λt) of (11) approaches 1. Published: 0.98.",
)
.slider(0.0, 2.0, false);

const FREQUENCY: Formula =
    Formula::of_item("frequency", "[ANTBAT] (7)", "Frequency", "f_i = f_{\\min} + (f_{\\max} - f_{\\min}) \\beta", "f = @f@");
const BAT_VELOCITY: Formula = Formula::of_item(
    "bat-velocity",
    "[ANTBAT] (8)",
    "Velocity",
    "v_i \\leftarrow \\class{inertia}{v_i} + \\class{social}{(x_i - x_{\\text{best}}) f_i}",
    "v = \\class{inertia}{@v_before@} + \\class{social}{(@x_before@ - @g@) \\cdot @f@} \\;\\to\\; \\class{velocity}{@v@}",
)
.when(PULL, "printed");
const BAT_VELOCITY_TOWARD: Formula = Formula::of_item(
    "bat-velocity-toward",
    "[ANTBAT] (8), other sign",
    "Velocity",
    "v_i \\leftarrow \\class{inertia}{v_i} + \\class{social}{(x_{\\text{best}} - x_i) f_i}",
    "v = \\class{inertia}{@v_before@} + \\class{social}{(@g@ - @x_before@) \\cdot @f@} \\;\\to\\; \\class{velocity}{@v@}",
)
.when(PULL, "toward");
const BAT_POSITION: Formula = Formula { source: "[ANTBAT] (9)", ..POSITION };
const WALK_ABOUT: Formula = Formula::of_item(
    "walk",
    "Yang 2010 (5)",
    "Walk about the best",
    "x_i \\leftarrow x_{\\text{best}} + \\class{jump}{\\epsilon \\bar A s}",
    "x = @g@ + \\class{jump}{@random@ \\cdot @mean_loudness@ \\, s} \\;\\to\\; @x@",
);
const LOUDNESS: Formula = Formula::of_item("loudness", "[ANTBAT] (10)", "Loudness", "A_i \\leftarrow \\varepsilon A_i", "A = @loudness@");
const PULSE: Formula =
    Formula::of_item("pulse", "[ANTBAT] (11)", "Pulse rate", "r_i \\leftarrow r_i \\left(1 - e^{-\\lambda t}\\right)", "r = @pulse_rate@");

const MEAN_LOUDNESS: Reading = Reading::new("loudness", "\\bar A", "Loudness", Group::Schedule, "The mean of the bats’ loudness.");
const MEAN_PULSE_RATE: Reading = Reading::new("pulse_rate", "\\bar r", "Pulse rate", Group::Schedule, "The mean of the bats’ pulse rates.");
const ACCEPTED: Reading =
    Reading::new("accepted", "n_a", "Accepted", Group::Count, "Bats that accepted their new position in this iteration.");

const BATS_LAYER: Layer = layers::PARTICLES.titled("Bats", "Where the bats are: points, or the paths they stand for.");

const PRINTED: Preset = Preset::new(
    "paper",
    "As printed",
    "(8) with its printed sign: bats fly away from the best, and only the walks about it improve it.",
    "sphere-2",
    &[("pull", Fixed::Text("printed"))],
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "crate",
    "Quieter with each success",
    "A bat that found something better gets quieter, and accepts less often from then on.",
    "egg-crate",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ bats begins at a random position, with $v = 0$",
    "repeat until iteration @iterations@:",
    "  for each bat:",
    "    with its pulse rate (on average @pulse_rate@) it flies: $v \\leftarrow v + (g - x) f$, $x’ = x + v$",
    "    otherwise it walks a little about the global best $g$",
    "    if $x’$ is not worse, with its loudness (on average @loudness@) as probability:",
    "      $x \\leftarrow x’$, and the bat gets quieter (@accepted@ did)",
    "  $g \\leftarrow$ the best position so far, with $f(g)$ = @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "bat-continuous",
    "Bat algorithm: continuous",
    "[ANTBAT] (7)–(11)",
    "Each bat has a frequency, a velocity and a position. With its pulse rate it flies, otherwise it walks about the global best; loudness decides whether it accepts what is not worse.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[POPULATION.entry(), ITERATIONS.entry(), F_MIN.entry(), F_MAX.entry(), PULL.entry(), WALK.entry()],
    &[A0.entry(), R0.entry(), EPSILON.entry(), LAMBDA.entry()],
    &[PER_BAT.entry(), V_MAX.entry(), V_MAX_ABSOLUTE.entry()],
    ENCODED,
    CHARGED,
])
.readings(&[BEST, MEAN, SPREAD, FREE, LENGTH, SMOOTHNESS, K, MEAN_LOUDNESS, MEAN_PULSE_RATE, ACCEPTED, EVALUATIONS])
.formulas(&[FREQUENCY, BAT_VELOCITY, BAT_VELOCITY_TOWARD, BAT_POSITION, WALK_ABOUT, LOUDNESS, PULSE])
.layers(&[
    GUIDES,
    layers::PERSONAL_BESTS,
    BATS_LAYER,
    layers::VELOCITIES,
    layers::BEST,
    SMOOTHED,
    layers::BEFORE,
    layers::INERTIA,
    layers::SOCIAL,
    layers::VELOCITY,
    layers::JUMP,
    layers::AFTER,
    layers::SUPPOSED,
])
.presets(&[PRINTED])
.cases(CASES)
.pseudocode(PSEUDOCODE);
