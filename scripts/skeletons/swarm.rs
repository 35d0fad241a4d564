//! `@NAME@`: not published. TODO: what it does, and where that is from, with equation numbers.
//!
//! TODO: what stands here works, and is to be replaced: it draws each particle in a box around its personal best.

use std::sync::Arc;

use crate::{
    describe::{Entry, Start, layers},
    kernel::{Candidate, Error, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, Started, State, rng::Stream},
    message,
    params::{Param, Parameters},
};

use super::{
    clock::Clock,
    encoding,
    objective::Objective,
    parameters::{GUIDES, ITERATIONS, KINDS, POPULATION, SMOOTHED},
    paths::{CHARGED, ENCODED},
    population::Population,
    sheet,
};

/// A parameter of its own. TODO: replace it.
const REACH: Param<f64> = Param::number(
    "reach",
    "",
    "Reach",
    [0.0, 1.0, 0.1],
    "How far from its personal best a particle is drawn, as a share of the search box. Higher values explore more.",
);

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "@NAME@",
    "@TITLE@",
    "not published",
    "Draws each particle near its personal best and keeps the best position.",
    start,
)
.family("swarm")
.kinds(KINDS)
// `reach` is its own; the others say how paths are encoded, charged and smoothed.
.parameters(&[&[POPULATION.entry(), ITERATIONS.entry(), REACH.entry()], ENCODED, CHARGED])
.readings(Population::READINGS)
// Those that only explanations mark come last.
.layers(&[GUIDES, layers::PERSONAL_BESTS, layers::PARTICLES, layers::BEST, SMOOTHED, layers::AFTER]);

/// The state: all that the next step depends on. A clone of it is a keyframe, and `State` gives its hash and size.
#[derive(Clone, State)]
struct @TYPE@ {
    population: Population,
    /// What follows from the setup is shared.
    #[state(shared)]
    reach: f64,
    rng: Stream,
    clock: Clock,
}

fn start(start: &Start) -> Result<Started, Error> {
    encoding::start(start, on)
}

/// Starts it on any objective; `parameters` are those of [`ENTRY`].
pub fn on(objective: Arc<dyn Objective>, parameters: &Parameters, seed: u64) -> Started {
    // The only source of random numbers.
    let mut rng = Stream::new(seed, 0);
    let population = Population::new(objective, parameters[POPULATION] as usize, &mut rng);
    let clock = Clock::new(parameters, population.bests());
    clock.start(@TYPE@ { population, reach: parameters[REACH], rng, clock })
}

impl Planner for @TYPE@ {
    /// One iteration, or a part of a long one. TODO: the algorithm's steps, each a function with the number of its equation.
    fn advance(&mut self) -> Progress {
        for i in self.population.next_part(1) {
            let row = self.population.row(i);
            let Population { x, p, objective, .. } = &mut self.population;
            let search_box = objective.search_box();
            for (j, (x, p)) in x[row.clone()].iter_mut().zip(&p[row]).enumerate() {
                let side = search_box.high()[j] - search_box.low()[j];
                *x = search_box.clamp(j, *p + self.reach * side * self.rng.between(-1.0, 1.0));
            }
            self.population.evaluate(i);
        }
        if self.population.is_under_way() {
            return Progress::Partly;
        }
        self.population.settle();
        self.clock.tick(self.population.bests())
    }

    fn evaluations(&self) -> u64 {
        self.population.evaluations
    }

    fn best(&self) -> Option<Candidate> {
        Some(self.population.best())
    }

    fn read(&self, out: &mut Readings) {
        self.population.read(out);
    }

    fn draw(&self, frame: &mut Frame) {
        self.population.draw_members(frame);
        self.population.draw_result(frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self)
    }
}

impl Explain for @TYPE@ {
    /// TODO: what the last step did to a particle and why; `cuckoo_search.rs` shows how to step a copy and watch it.
    fn inspect(&self, item: Item) -> Option<Inspection> {
        let drawn = message!("@NAME@-drawn", "Particle {i} is drawn near its personal best in each iteration.", i = item.index);
        sheet::introduce(&self.population, item, drawn)
    }
}
