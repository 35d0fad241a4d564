//! `@NAME@`: not published. TODO: what it does, and where that is from, with equation numbers.
//!
//! TODO: what stands here works, and is to be replaced: it runs an ant colony with a random α in each iteration, and keeps the α
//! that led to the shortest path.

use crate::{
    describe::{Entry, Group, Reading, Start, layers},
    kernel::{
        Candidate, Error, Facets, Frame, Planner, Progress, Readings, Recommend, Recommendation, ReferenceOptimum, Shape, Solution, Started,
        State, Subtask, SubtaskResult, Subtasks, rng::Stream,
    },
    params::{Overrides, Param, Value},
    scene::GRID,
};

/// The planner whose parameters are searched, and the one that is.
const TUNED: &str = "aco";
const ALPHA: &str = "alpha";

const ITERATIONS: Param<u64> =
    Param::integer("iterations", "k_{\\max}", "Iterations", [1, 1_000_000, 30], "The number of iterations after which it stops.");
/// A parameter of its own. TODO: replace it.
const ROUNDS: Param<u64> = Param::integer(
    "colony_iterations",
    "t_{\\max}",
    "Iterations of the colony",
    [1, 2000, 20],
    "The number of iterations of each run of the colony. More take longer and say more.",
);

const BEST: Reading = Reading::new("best", "L", "Shortest", Group::Cost, "The length of the shortest path so far.");
const LAST: Reading = Reading::new("alpha", "\\alpha", "Last α", Group::Schedule, "The α that was tried last.");

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "@NAME@",
    "@TITLE@",
    "not published",
    "Runs an ant colony with random weights of pheromone and keeps the weight that led to the shortest path.",
    start,
)
.family("@FAMILY@")
.kinds(&[GRID])
.parameters(&[&[ITERATIONS.entry(), ROUNDS.entry()]])
.readings(&[BEST, LAST])
.layers(&[layers::BEST]);

/// The state: all that the next step depends on. A clone of it is a keyframe, and `State` gives its hash and size.
#[derive(Clone, State)]
struct @TYPE@ {
    /// What follows from the setup is shared.
    #[state(shared)]
    rounds: u64,
    /// The only source of random numbers.
    rng: Stream,
    /// The α that the next step tries.
    next: f64,
    last: f64,
    provided: Vec<SubtaskResult>,
    runs: u64,
    best: Option<Best>,
}

/// The shortest path so far, and the α that led to it.
#[derive(Clone, State)]
struct Best {
    length: f64,
    alpha: f64,
    path: Vec<[f64; 2]>,
}

fn start(start: &Start) -> Result<Started, Error> {
    // A build may be without it.
    start.entries.planner(TUNED)?;
    let mut rng = Stream::new(start.seed, 0);
    let next = rng.between(0.0, 5.0);
    let rounds = start.parameters[ROUNDS];
    let planner = @TYPE@ { rounds, rng, next, last: f64::NAN, provided: Vec::new(), runs: 0, best: None };
    Ok(Started::new(planner, start.parameters[ITERATIONS]).measured_by(ReferenceOptimum::Cells))
}

impl @TYPE@ {
    fn overrides(&self, alpha: f64) -> Overrides {
        [("iterations", self.rounds as f64), (ALPHA, alpha)].map(|(name, value)| (name, Value::from(value))).into_iter().collect()
    }
}

impl Planner for @TYPE@ {
    /// One iteration: judges what the runs of [`Subtasks`] found. TODO: the algorithm's steps, each a function with the number of
    /// its equation.
    fn advance(&mut self) -> Progress {
        for SubtaskResult { cost, path, .. } in std::mem::take(&mut self.provided) {
            self.runs += 1;
            let Some(length) = cost else { continue };
            if self.best.as_ref().is_none_or(|best| length < best.length) {
                self.best = Some(Best { length, alpha: self.next, path });
            }
        }
        self.last = self.next;
        self.next = self.rng.between(0.0, 5.0);
        Progress::Continue
    }

    fn evaluations(&self) -> u64 {
        self.runs
    }

    fn best(&self) -> Option<Candidate> {
        self.best.as_ref().map(|best| Candidate { cost: best.length, solution: Solution::Path(best.path.clone()) })
    }

    fn read(&self, out: &mut Readings) {
        // What is not there yet is not a number.
        out.push(BEST, self.best.as_ref().map_or(f64::NAN, |best| best.length));
        out.push(LAST, self.last);
    }

    fn draw(&self, frame: &mut Frame) {
        if let Some(best) = &self.best {
            frame.begin(layers::BEST.key, Shape::Polyline);
            best.path.iter().for_each(|&corner| frame.push(corner, 0.0));
        }
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().recommend(self)
    }

    fn subtasks(&mut self) -> Option<&mut dyn Subtasks> {
        Some(self)
    }
}

impl Subtasks for @TYPE@ {
    /// The runs of other planners that the next step needs: the planner never runs them itself.
    fn requests(&self) -> Vec<Subtask> {
        vec![Subtask { planner: TUNED, params: self.overrides(self.next), seed: self.runs, ends: None }]
    }

    fn provide(&mut self, found: Vec<SubtaskResult>) {
        self.provided = found;
    }
}

impl Recommend for @TYPE@ {
    fn recommendation(&self) -> Option<Recommendation> {
        self.best.as_ref().map(|best| Recommendation { planner: TUNED, params: self.overrides(best.alpha) })
    }
}
