//! Baseline planners that suites compare with.

use std::sync::Arc;

use forage::{
    Frame,
    describe::{Entry, Group, Layer, Reading, Start, layers},
    kernel::{Candidate, Planner, Progress, Readings, Shape, Started, State, rng::Stream},
    params::Param,
    scene::{FUNCTION, FunctionScene},
    swarm::objective::{Evaluation, Objective, Scratch},
};

/// All of them.
pub const ALL: &[&Entry] = &[&RANDOM_SEARCH];

/// Positions an iteration.
const POSITIONS: usize = 100;

const ITERATIONS: Param<u64> =
    Param::integer("iterations", "t_{\\max}", "Iterations", [1, 10_000_000, 100], "How many times positions are drawn.");
const SAMPLES: Layer = Layer { pickable: false, ..layers::SAMPLES };
const BEST: Reading = Reading::new("best", "f(g)", "Best", Group::Cost, "The least cost so far.");

/// Uniform random search.
pub const RANDOM_SEARCH: Entry = Entry::new(
    "random-search",
    "Random search",
    "Brooks, Operations Research 6 (1958)",
    "Positions are drawn uniformly from the search box, 100 an iteration; the best is kept. A baseline: a useful planner must do better.",
    |start: &Start| {
        let objective = Arc::clone(start.scene.get::<FunctionScene>()?.objective());
        Ok(Started::new(RandomSearch::new(objective, start.seed), start.parameters[ITERATIONS]))
    },
)
.family("random search")
.kinds(&[FUNCTION])
.parameters(&[&[ITERATIONS.entry()]])
.readings(&[BEST])
.layers(&[SAMPLES, layers::BEST]);

#[derive(Clone, State)]
struct RandomSearch {
    #[state(shared)]
    objective: Arc<dyn Objective>,
    #[state(skip)]
    scratch: Scratch,
    positions: Vec<f64>,
    costs: Vec<Evaluation>,
    best: Vec<f64>,
    best_cost: f64,
    evaluations: u64,
    rng: Stream,
}

impl RandomSearch {
    fn new(objective: Arc<dyn Objective>, seed: u64) -> Self {
        let n = objective.search_box().dimension();
        let mut search = Self {
            objective,
            scratch: Scratch::default(),
            positions: vec![0.0; n * POSITIONS],
            costs: vec![Evaluation::from(f64::INFINITY); POSITIONS],
            best: vec![0.0; n],
            best_cost: f64::INFINITY,
            evaluations: 0,
            rng: Stream::new(seed, 0),
        };
        search.draw_all();
        search
    }

    fn draw_all(&mut self) {
        let area = self.objective.search_box();
        let n = area.dimension();
        self.positions.chunks_exact_mut(n).for_each(|x| area.draw(x, &mut self.rng));
        self.objective.evaluate_all(&self.positions, &mut self.scratch, &mut self.costs);
        self.evaluations += POSITIONS as u64;
        for (x, found) in self.positions.chunks_exact(n).zip(&self.costs) {
            if found.cost < self.best_cost {
                self.best_cost = found.cost;
                self.best.copy_from_slice(x);
            }
        }
    }
}

impl Planner for RandomSearch {
    fn advance(&mut self) -> Progress {
        self.draw_all();
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn best(&self) -> Option<Candidate> {
        Some(Candidate { cost: self.best_cost, solution: self.objective.solution(&self.best) })
    }

    fn read(&self, out: &mut Readings) {
        out.push(BEST, self.best_cost);
    }

    fn draw(&self, frame: &mut Frame) {
        frame.begin(SAMPLES.key, Shape::Points);
        let n = self.objective.search_box().dimension();
        self.positions.chunks_exact(n).for_each(|x| frame.push(self.objective.point(x, 0), 0.0));
        frame.begin(layers::BEST.key, Shape::Points);
        frame.push(self.objective.point(&self.best, 0), 0.0);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use forage::{Registry, testing};

    use super::ALL;

    #[test]
    fn peers_keep_to_what_every_planner_must() {
        let registry = Arc::new(Registry::standard().with_all(ALL));
        ALL.iter().for_each(|entry| testing::assert_conforms(&registry, entry.name));
    }
}
