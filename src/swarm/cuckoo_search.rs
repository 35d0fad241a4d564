//! `cuckoo-search`: cuckoo search by Yang and Deb (2009), Lévy flights and abandoned nests. [ANTBAT](crate#papers) fig. 8 compares with a
//! variant of it (Liu and Liu, Computer Science 2019, 46(7), 165–171: directional mutation), of which it prints no details. This is Yang
//! and Deb's own.
//!
//! Readings. Where the paper's pseudo-code leaves something open, Yang and Deb's program decides: in each iteration every nest
//! is tried twice, first by a Lévy flight, then by a random walk along the difference of two nests, and a candidate that is not
//! worse replaces its own nest. Flights are drawn by Mantegna's algorithm (1994) and scaled by α and the distance from the best
//! nest, so the best nest itself does not fly. r of the walk is one number for all nests of an iteration. Each coordinate walks
//! with probability `p_a`, as Yang's H(p_a − ε) says; the program tests the opposite, so `p_a` = 0.75 gives what it does with 0.25.

#[cfg(test)]
mod tests;

use std::{ops::Range, sync::Arc};

use crate::{
    describe::{Case, Entry, Formula, Group, Layer, Preset, ROAD, Reading, layers},
    kernel::{Candidate, Explain, Facets, Frame, Inspection, Item, Label, Planner, Progress, Readings, Started, State, rng::Stream},
    label, message,
    params::{Fixed, Param, Parameters},
    scene::{DISCS, GRID},
};

use super::{
    clock::Clock,
    encoding,
    levy::{Draw, Levy},
    objective::Objective,
    parameters::{BEST, EVALUATIONS, FREE, GUIDES, ITERATIONS, K, KINDS, LENGTH, MEAN, SMOOTHED, SMOOTHNESS, SPREAD},
    paths::{CHARGED, ENCODED},
    population::{Held, Population},
    sheet::{self, OTHER_NUMBERS, arrows, mark, particle, quantities, sheet},
};

/// Nests: x ← x + α s (x − g) ε by Lévy flights, then x ← x + r H(p_a − ε) (x_j − x_k).
#[derive(Clone, State)]
struct Nests {
    population: Population,
    #[state(shared)]
    levy: Levy,
    #[state(shared)]
    alpha: f64,
    #[state(shared)]
    p_a: f64,
    /// Which two nests x_j and x_k each nest walks by, drawn as two permutations in each iteration.
    pairs: [Vec<usize>; 2],
    /// r of the walks that are under way.
    #[state(skip)]
    r: f64,
    /// All nests before the walks, which the differences are taken of.
    #[state(skip)]
    before: Vec<f64>,
    /// Where a nest was before it was tried.
    #[state(skip)]
    held: Held,
    last: Vec<Last>,
    rng: Stream,
    clock: Clock,
}

/// Whether a nest took what its flight and its walk led to in the last iteration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, State)]
struct Last {
    flown: bool,
    walked: bool,
}

/// Sees what happens to one nest. `()` sees nothing and costs nothing.
trait Watch {
    /// Which one it watches.
    fn particle(&self) -> Option<usize> {
        None
    }
    /// It is about to be tried.
    fn begins(&mut self, _nests: &mut Nests) {}
    /// One coordinate of its flight: what was drawn, ε, and the candidate.
    fn flight(&mut self, _draw: Draw, _epsilon: f64, _to: f64) {}
    /// What the flight's candidate costs.
    fn flown(&mut self, _cost: f64) {}
    /// One coordinate of its walk: whether it changes, x_j, x_k, and the candidate.
    fn walk(&mut self, _changes: bool, _pair: [f64; 2], _to: f64) {}
    /// r of the walks, and what the walk's candidate costs.
    fn walked(&mut self, _r: f64, _cost: f64) {}
}

impl Watch for () {}

/// Starts it on any objective; `settings` are the parameters of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, settings: &Parameters, seed: u64) -> Started {
    let mut rng = Stream::new(seed, 0);
    let population = Population::new(objective, settings[POPULATION] as usize, &mut rng);
    let size = population.size;
    let numbers: Vec<_> = (0..size).collect();
    let nests = Nests {
        levy: Levy::new(settings[LAMBDA]),
        alpha: settings[ALPHA],
        p_a: settings[P_A],
        pairs: [numbers.clone(), numbers],
        r: 0.0,
        before: population.x.clone(),
        held: Held::new(&population),
        last: vec![Last { flown: false, walked: false }; size],
        rng,
        clock: Clock::new(settings, population.bests()),
        population,
    };
    nests.clock.start(nests)
}

impl Nests {
    /// An iteration, or a part of it. `watch` sees what happens to a nest that somebody asked about.
    fn iterate(&mut self, watch: &mut dyn Watch) -> Progress {
        let watched = watch.particle();
        let size = self.population.size;
        let part = self.population.next_part(2);
        self.try_flights(part.start.min(size)..part.end.min(size), watched, watch);
        if part.contains(&size) {
            self.before.copy_from_slice(&self.population.x);
            self.pairs.iter_mut().for_each(|numbers| self.rng.shuffle(numbers));
            self.r = self.rng.unit();
        }
        self.try_walks(part.start.max(size) - size..part.end.max(size) - size, watched, watch);
        if self.population.is_under_way() {
            return Progress::Partly;
        }
        self.population.end(&mut self.clock)
    }

    fn try_flights(&mut self, nests: Range<usize>, watched: Option<usize>, watch: &mut dyn Watch) {
        self.held.hold(&self.population, nests.clone());
        for i in nests.clone() {
            if watched == Some(i) {
                watch.begins(self);
                self.fly(i, watch);
            } else {
                self.fly(i, &mut ());
            }
        }
        self.population.evaluate_all(nests.clone());
        for i in nests {
            if watched == Some(i) {
                watch.flown(self.population.cost[i]);
            }
            self.last[i].flown = self.keep_better(i);
        }
    }

    fn try_walks(&mut self, nests: Range<usize>, watched: Option<usize>, watch: &mut dyn Watch) {
        self.held.hold(&self.population, nests.clone());
        for i in nests.clone() {
            if watched == Some(i) {
                self.walk(i, self.r, watch);
            } else {
                self.walk(i, self.r, &mut ());
            }
        }
        self.population.evaluate_all(nests.clone());
        for i in nests {
            if watched == Some(i) {
                watch.walked(self.r, self.population.cost[i]);
            }
            self.last[i].walked = self.keep_better(i);
        }
    }

    /// A Lévy flight to a candidate, which is kept in the box.
    fn fly<W: Watch + ?Sized>(&mut self, i: usize, watch: &mut W) {
        let row = self.population.row(i);
        let Population { x, g, objective, .. } = &mut self.population;
        let x = &mut x[row];
        for (j, x) in x.iter_mut().enumerate() {
            let draw = self.levy.draw(&mut self.rng);
            let epsilon = self.rng.normal();
            *x = objective.search_box().clamp(j, *x + self.alpha * draw.s * (*x - g[j]) * epsilon);
            watch.flight(draw, epsilon, *x);
        }
    }

    /// A random walk along the difference of two nests, kept in the box.
    fn walk<W: Watch + ?Sized>(&mut self, i: usize, r: f64, watch: &mut W) {
        let row = self.population.row(i);
        let [of_j, of_k] = [0, 1].map(|one| self.population.row(self.pairs[one][i]));
        let Population { x, objective, .. } = &mut self.population;
        let x = &mut x[row];
        let (x_j, x_k) = (&self.before[of_j], &self.before[of_k]);
        for (j, x) in x.iter_mut().enumerate() {
            let changes = self.rng.unit() < self.p_a;
            if changes {
                *x = objective.search_box().clamp(j, *x + r * (x_j[j] - x_k[j]));
            }
            watch.walk(changes, [x_j[j], x_k[j]], *x);
        }
    }

    /// Leaves a nest where it was if its candidate costs more than it did.
    fn keep_better(&mut self, i: usize) -> bool {
        let better = self.population.cost[i] <= self.held.cost(i);
        if !better {
            self.held.put_back(&mut self.population, i);
        }
        better
    }

    fn count(&self, what: impl Fn(&Last) -> bool) -> f64 {
        self.last.iter().filter(|last| what(last)).count() as f64
    }
}

impl Planner for Nests {
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
        out.push(FLOWN, self.count(|last| last.flown));
        out.push(REBUILT, self.count(|last| last.walked));
        out.push(EVALUATIONS, self.population.evaluations as f64);
    }

    fn draw(&self, frame: &mut Frame) {
        self.population.draw_particles(frame);
        self.population.draw_result(frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).failure(&self.population)
    }
}

impl Explain for Nests {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        let i = item.index;
        let origin = message!("swarm-nest-begins", "Nest {i} begins here, drawn at random.", i);
        let mut inspection = (self.clock.iteration == 0).then(|| sheet::introduce(&self.population, item, origin)).flatten()?;
        inspection.title = message!("swarm-nest", "Nest {i}", i);
        Some(inspection)
    }

    fn explain_next(&self, item: Item) -> Option<Inspection> {
        self.explain_step(item, None)
    }

    fn suppose(&self, item: Item, _supposition: &str, others: &Stream) -> Option<Inspection> {
        self.explain_step(item, Some(others))
    }
}

const FLIGHT: [Label; 8] = [
    label!("swarm-position-before-first-coordinate", "x_before", "x", "position before, first coordinate"),
    label!("swarm-global-best-first-coordinate", "g", "g", "global best, first coordinate"),
    label!("swarm-standard-deviation-of-u", "sigma", "\\sigma", "standard deviation of u"),
    label!("swarm-normal-random-number-of-deviation-first-coordinate", "u", "u", "normal random number of deviation σ, first coordinate"),
    label!("swarm-normal-random-number-first-coordinate", "v", "v", "normal random number, first coordinate"),
    label!("swarm-l-vy-step-first-coordinate", "s", "s", "Lévy step, first coordinate"),
    label!(
        "swarm-normal-random-number-that-scales-it-first-coordinate",
        "epsilon",
        "\\epsilon",
        "normal random number that scales it, first coordinate"
    ),
    label!("swarm-candidate-of-the-flight-first-coordinate", "candidate", "x'", "candidate of the flight, first coordinate"),
];
const WALK: [Label; 6] = [
    label!("swarm-position-after-the-flight-first-coordinate", "x_between", "x", "position after the flight, first coordinate"),
    label!("swarm-random-number-of-the-walks", "r", "r", "random number of the walks"),
    label!("swarm-whether-the-first-coordinate-walks", "changes", "H", "whether the first coordinate walks"),
    label!("swarm-one-random-nest-first-coordinate", "x_j", "x_j", "one random nest, first coordinate"),
    label!("swarm-another-random-nest-first-coordinate", "x_k", "x_k", "another random nest, first coordinate"),
    label!("swarm-candidate-of-the-walk-first-coordinate", "rebuilt", "x'", "candidate of the walk, first coordinate"),
];
const COSTS: [Label; 4] = [
    label!("swarm-cost-before", "cost_before", "f(x)", "cost before"),
    label!("swarm-cost-of-the-flights-candidate", "cost_flown", "f(x)", "cost of the flight’s candidate"),
    label!("swarm-cost-of-the-walks-candidate", "cost_walked", "f(x)", "cost of the walk’s candidate"),
    label!("swarm-cost-after", "cost", "f(x)", "cost after"),
];
const COLUMNS: [Label; 6] = [
    label!("swarm-position-before", "x_before", "x", "position before"),
    label!("swarm-l-vy-step", "s", "s", "Lévy step"),
    label!("swarm-normal-random-number", "epsilon", "\\epsilon", "normal random number"),
    label!("swarm-candidate-of-the-flight", "candidate", "x'", "candidate of the flight"),
    label!("swarm-1-if-this-coordinate-walks", "changes", "H", "1 if this coordinate walks"),
    label!("swarm-candidate-of-the-walk", "rebuilt", "x'", "candidate of the walk"),
];

/// What was done to a nest, coordinate by coordinate.
#[derive(Default)]
struct Record<'a> {
    nest: usize,
    others: Option<&'a Stream>,
    flight: Vec<(Draw, f64, f64)>,
    walk: Vec<(bool, [f64; 2], f64)>,
    r: f64,
    costs: [f64; 2],
}

impl Watch for Record<'_> {
    fn particle(&self) -> Option<usize> {
        Some(self.nest)
    }

    fn begins(&mut self, nests: &mut Nests) {
        if let Some(others) = self.others {
            nests.rng = others.clone();
        }
    }

    fn flight(&mut self, draw: Draw, epsilon: f64, to: f64) {
        self.flight.push((draw, epsilon, to));
    }

    fn flown(&mut self, cost: f64) {
        self.costs[0] = cost;
    }

    fn walk(&mut self, changes: bool, pair: [f64; 2], to: f64) {
        self.walk.push((changes, pair, to));
    }

    fn walked(&mut self, r: f64, cost: f64) {
        (self.r, self.costs[1]) = (r, cost);
    }
}

impl Nests {
    /// What the next step does to a nest, or would do with other random numbers.
    fn explain_step(&self, item: Item, others: Option<&Stream>) -> Option<Inspection> {
        let i = particle(&self.population, item)?;
        let mut record = Record { nest: i, others, ..Record::default() };
        let mut after = self.clone();
        while after.iterate(&mut record) == Progress::Partly {}
        let Record { flight, walk, r, costs, .. } = &record;
        let (now, next) = (&self.population, &after.population);
        let (meaning, row) = (&*now.objective, now.row(i));
        let x = &now.x[row.clone()];
        let Last { flown, walked } = after.last[i];
        let candidate: Vec<_> = flight.iter().map(|&(_, _, to)| to).collect();
        let rebuilt: Vec<_> = walk.iter().map(|&(_, _, to)| to).collect();
        let between = if flown { &candidate[..] } else { x };

        let flight_led = if flown {
            message!("swarm-egg-taken", "Nest {i} is tried twice. The egg of a Lévy flight replaces the nest.", i)
        } else {
            message!("swarm-egg-dropped", "Nest {i} is tried twice. The egg of a Lévy flight costs more and is dropped.", i)
        };
        let walk_led = if walked {
            message!("swarm-rebuilt-taken", "The nest that a random walk rebuilds replaces it.")
        } else {
            message!("swarm-rebuilt-dropped", "The nest that a random walk rebuilds costs more and is dropped.")
        };
        let event = match (flown, walked) {
            (_, true) => "rebuilt",
            (true, false) => "flight",
            (false, false) => "kept",
        };
        let mut inspection = sheet(meaning, item, event, flight_led.then(walk_led), now.dimension);
        inspection.title = message!("swarm-nest", "Nest {i}", i);
        inspection.columns = COLUMNS.to_vec();
        let rows = flight.iter().zip(walk).zip(x);
        inspection.rows = rows.map(|((&(draw, e, to), &(h, _, end)), &x)| vec![x, draw.s, e, to, f64::from(u8::from(h)), end]).collect();
        inspection.suppositions = vec![OTHER_NUMBERS];
        inspection.formulas = vec![SIGMA.name, STEP.name, FLY.name, ABANDON.name];
        let (draw, epsilon, to) = flight[0];
        quantities(&mut inspection, &FLIGHT, &[x[0], now.g[0], self.levy.sigma, draw.u, draw.v, draw.s, epsilon, to]);
        let (changes, [x_j, x_k], end) = walk[0];
        quantities(&mut inspection, &WALK, &[between[0], *r, f64::from(u8::from(changes)), x_j, x_k, end]);
        quantities(&mut inspection, &COSTS, &[now.cost[i], costs[0], costs[1], next.cost[i]]);
        inspection.marks = vec![
            mark(meaning, layers::BEFORE.key, x),
            arrows(meaning, layers::JUMP.key, x, &candidate),
            arrows(meaning, layers::STEP.key, between, &rebuilt),
            mark(meaning, layers::AFTER.key, &next.x[row]),
        ];
        Some(inspection)
    }
}

const POPULATION: Param<u64> = Param::integer(
    "population",
    "n",
    "Nests",
    [1, 100_000, 30],
    "How many nests. Each is evaluated twice in an iteration, so the defaults are half of the other swarms’. Yang and Deb: 15 to 40 are enough.",
)
.defaults_on(&[(DISCS, Fixed::Number(75.0)), (GRID, Fixed::Number(75.0))])
.slider(2.0, 2000.0, true);
const P_A: Param<f64> = Param::number(
    "p_a",
    "p_a",
    "Share abandoned",
    [0.0, 1.0, 0.25],
    "With what probability each coordinate of a nest is rebuilt by a random walk; a higher value changes more of each nest at once. Yang and Deb: 0.25.",
);
const ALPHA: Param<f64> = Param::number(
    "alpha",
    "\\alpha",
    "Step scale",
    [0.0, 10.0, 0.01],
    "What a Lévy step times the distance from the best nest is multiplied by; a higher value leads farther. Yang and Deb’s program: 0.01.",
)
.slider(0.001, 1.0, true);
const LAMBDA: Param<f64> = Param::number(
    "lambda",
    "\\lambda",
    "Lévy exponent",
    [0.3, 1.99, 1.5],
    "How fast long flights become rare; a lower value makes them more frequent. Mantegna’s algorithm holds from 0.3 to 1.99; Yang and Deb’s program: 1.5.",
);

const SIGMA: Formula = Formula::of_item(
    "sigma",
    "Mantegna 1994",
    "Deviation of u",
    "\\sigma = \\left(\\frac{\\Gamma(1 + \\lambda) \\sin(\\pi \\lambda / 2)}{\\Gamma\\left(\\frac{1 + \\lambda}{2}\\right) \\lambda \\, 2^{(\\lambda - 1)/2}}\\right)^{1/\\lambda}",
    "\\sigma = @sigma@",
);
const STEP: Formula = Formula::of_item(
    "levy-step",
    "Mantegna 1994",
    "Lévy step",
    "s = \\frac{u}{|v|^{1/\\lambda}}",
    "s = \\frac{@u@}{|@v@|^{1/\\lambda}} = @s@",
);
const FLY: Formula = Formula::of_item(
    "levy-flight",
    "Yang and Deb 2009 (1), its program",
    "Lévy flight",
    "x' = x + \\class{jump}{\\alpha s (x - g) \\, \\epsilon}",
    "x' = @x_before@ + \\class{jump}{\\alpha \\cdot @s@ \\, (@x_before@ - @g@) \\cdot @epsilon@} \\;\\to\\; @candidate@",
);
const ABANDON: Formula = Formula::of_item(
    "abandon",
    "Yang and Deb 2009, its program",
    "Abandoned coordinates",
    "x' = x + \\class{step}{r \\, H(p_a - \\epsilon) \\, (x_j - x_k)}",
    "x' = @x_between@ + \\class{step}{@r@ \\cdot @changes@ \\cdot (@x_j@ - @x_k@)} \\;\\to\\; @rebuilt@",
);

const FLOWN: Reading =
    Reading::new("flown", "n_L", "Flights kept", Group::Count, "Nests that took the candidate of their Lévy flight in this iteration.");
const REBUILT: Reading =
    Reading::new("rebuilt", "n_a", "Nests rebuilt", Group::Count, "Nests that took the candidate of their random walk in this iteration.");

const NESTS: Layer = layers::PARTICLES.titled("Nests", "Where the nests are: points, or the paths they stand for.");

const ONE_ROAD: Preset = Preset::new(
    ROAD,
    "One of many roads",
    "Sizes for one of many roads between stops: 25 nests and 200 iterations instead of 75 and 500. Paths are longer, and found sooner.",
    "ant-bat-30",
    &[("population", Fixed::Number(25.0)), ("iterations", Fixed::Number(200.0))],
);

/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "hollows",
    "Many short flights, few long ones",
    "Most Lévy flights are short; a few leave a hollow for a far one.",
    "rastrigin",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "each of the @population@ nests begins at a random position",
    "repeat until iteration @iterations@:",
    "  for each nest: a Lévy flight makes a candidate; it replaces the nest if not worse (@flown@ did)",
    "  for each nest: each coordinate, with probability $p_a$ = @p_a@,",
    "    is moved along the difference of two random nests",
    "    the candidate replaces the nest if not worse (@rebuilt@ did)",
    "  the best nest has cost @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "cuckoo-search",
    "Cuckoo search: Lévy flights",
    "Yang and Deb 2009",
    "Each nest is a candidate solution. A Lévy flight makes a new one from it, mostly near and seldom far away; then some of its coordinates are rebuilt along the difference of two random nests. A nest is replaced only by what is not worse.",
    |start| encoding::start(start, on),
)
.family("swarm")
.evaluating(crate::swarm::EVALUATION)
.kinds(KINDS)
.parameters(&[&[POPULATION.entry(), ITERATIONS.entry(), P_A.entry(), ALPHA.entry(), LAMBDA.entry()], ENCODED, CHARGED])
.readings(&[BEST, MEAN, SPREAD, FREE, LENGTH, SMOOTHNESS, K, FLOWN, REBUILT, EVALUATIONS])
.formulas(&[SIGMA, STEP, FLY, ABANDON])
.layers(&[GUIDES, NESTS, layers::BEST, SMOOTHED, layers::BEFORE, layers::JUMP, layers::STEP, layers::AFTER, layers::SUPPOSED])
.presets(&[ONE_ROAD])
.cases(CASES)
.pseudocode(PSEUDOCODE);
