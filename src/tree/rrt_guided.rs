//! `rrt-guided`: the tree that looks where the goal is, [ARM-RRT](crate#papers) §3.2.1 and §3.3.
//!
//! The paper describes the choice twice, and differently (`choice`): by §3.2.1 the samples with the smallest angles are kept
//! and a roulette wheel chooses among them; by step 2 (2) of the algorithm the wheel draws those that are kept by their
//! distances to the goal, and the nearest comes first.
//!
//! Readings. x_near is the node nearest to the goal, as step 2 (2) says. The wheel's weights are not printed: ours are π − φ
//! and 1/d, which fall with the angle and the distance. A candidate that is blocked, outside, or doubles back is dropped, and
//! the next one is chosen.

use std::{f64::consts::PI, sync::Arc};

use crate::{
    describe::{Case, Entry, Formula},
    kernel::{Error, Started, State, rng::Stream},
    params::{Choice, Param, ParamValue, Parameters},
};

use super::{
    draw::GUIDED_LAYERS,
    finish::{FITTED, HERMITE},
    grow::{By, Forest, Sample, SampleOutcome, Source},
    method::{Method, Trees},
    parameters::{FINISH, FORMULA_STEP, ITERATIONS, KEEP, KINDS, READINGS, SAMPLES, STEP},
    sample::angle,
    space::{self, Space},
    task::Task,
    vector::{distance, minus},
};

impl ParamValue for By {}

const CHOICE: Param<By> = Param::choice(
    "choice",
    "",
    "Choice of the sample",
    &[
        Choice::new("angle", "By angle", "§3.2.1: the smallest angles are kept, a roulette wheel chooses."),
        Choice::new("distance", "By distance", "Step 2 (2): a roulette wheel keeps some by their distance to the goal, nearest first."),
    ],
    &[By::Angle, By::Distance],
    "How the sample is chosen that the tree grows toward. [ARM-RRT] describes both.",
);

const FALLBACK: Param<bool> = Param::flag(
    "fallback",
    "Random step",
    true,
    "Whether a step of plain RRT follows if no kept sample can be used, [ARM-RRT] step 2 (4).",
);

const FORMULA_ANGLE: Formula = Formula::of_item(
    "angle",
    "[ARM-RRT] §3.2.1",
    "Angle with the goal’s direction",
    "\\varphi = \\arccos \\frac{\\class{chosen}{(x_{\\text{rand}} - x_{\\text{near}})} \\cdot \\class{to-goal}{(x_{\\text{goal}} - x_{\\text{near}})}}{\\lVert x_{\\text{rand}} - x_{\\text{near}} \\rVert\\, \\lVert x_{\\text{goal}} - x_{\\text{near}} \\rVert}",
    "\\varphi = @angle@",
)
.when(CHOICE, "angle");
const FORMULA_ROULETTE: Formula = Formula::of_item(
    "roulette",
    "[ARM-RRT] §3.3, our weights",
    "Share of the roulette wheel",
    "p_i = \\frac{\\class{chosen}{\\pi - \\varphi_i}}{\\class{samples}{\\sum_j (\\pi - \\varphi_j)}}",
    "p = @share@",
)
.when(CHOICE, "angle");
const FORMULA_ROULETTE_DISTANCE: Formula = Formula::of_item(
    "roulette-distance",
    "[ARM-RRT] §3.3, our weights",
    "Share of the roulette wheel",
    "p_i = \\frac{\\class{chosen}{1/d_i}}{\\class{samples}{\\sum_j 1/d_j}}, \\quad d_i = \\lVert x_{\\text{goal}} - x_i \\rVert",
    "p = @share@, \\quad d = @to_goal@",
)
.when(CHOICE, "distance");
/// Runs that show something.
const CASES: &[Case] = &[Case::new(
    "cuboid",
    "Guided around a cuboid",
    "The tree slides along the cuboid. Click a node: its twenty samples, the four kept, and the one chosen.",
    "arm-cuboid",
    &[],
)];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "the tree begins at the start",
    "repeat until a node is within a step of the goal:",
    "  draw @samples@ random points, and keep @keep@ that lie toward the goal",
    "  a roulette wheel chooses one; the node nearest to the goal takes a step of @step_size@ toward it",
    "  if that is blocked: try the others kept, then a step of a basic tree",
    "  nodes: @nodes@, rejected steps: @rejected@, to go: @to_goal@",
    "follow the parents back from the goal: length @final_length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "rrt-guided",
    "Guided RRT: towards the goal",
    "[ARM-RRT] §3.2.1",
    "Of twenty random points four are kept, by angle with the goal’s direction or by distance to the goal. The node nearest to the goal grows toward one of them. If all four are blocked, a random step follows.",
    |start| space::start(start, on),
)
.family("tree")
.evaluating(crate::tree::EVALUATION)
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), STEP.entry(), SAMPLES.entry(), KEEP.entry(), CHOICE.entry(), FALLBACK.entry()], FINISH])
.readings(READINGS)
.formulas(&[FORMULA_STEP, FORMULA_ANGLE, FORMULA_ROULETTE, FORMULA_ROULETTE_DISTANCE, FITTED, HERMITE])
.layers(GUIDED_LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it in any space; `settings` are the parameters of [`ENTRY`].
///
/// # Errors
/// As [`Trees::new`].
pub fn on<const N: usize>(space: Arc<dyn Space<N>>, settings: &Parameters, seed: u64) -> Result<Started, Error> {
    Ok(Trees::new(space, settings, seed, |_| Guided::new(settings))?.into())
}

#[derive(Clone, State)]
pub(super) struct Guided {
    #[state(shared)]
    samples: usize,
    #[state(shared)]
    keep: usize,
    #[state(shared)]
    by: By,
    /// Whether a step of plain RRT follows when nothing can be chosen.
    #[state(shared)]
    falls_back: bool,
    /// Angles with the goal's direction, or distances to the goal, and numbers of the samples; re-used.
    #[state(skip)]
    order: Vec<(f64, usize)>,
}

impl<const N: usize> Method<N> for Guided {
    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) {
        forest.begin(Source::Guided(self.by), 0);
        let near = forest.nearest_node;
        self.draw(forest, task, near, rng);
        let chosen = self.choose(forest, task, near, rng);
        if let Some(new) = chosen.or_else(|| if self.falls_back { plain(forest, task, rng) } else { None }) {
            forest.reach(task, new);
        }
    }
}

impl Guided {
    pub(super) fn new(settings: &Parameters) -> Self {
        let (samples, keep) = (settings[SAMPLES] as usize, settings[KEEP] as usize);
        Self { samples, keep, by: settings[CHOICE], falls_back: settings[FALLBACK], order: Vec::with_capacity(samples) }
    }

    /// The weight on the roulette wheel.
    fn weight(&self, key: f64) -> f64 {
        match self.by {
            By::Angle => PI - key,
            // At the goal itself all the others weigh nothing.
            By::Distance => 1.0 / key.max(f64::MIN_POSITIVE.sqrt()),
        }
    }

    fn weights(&self, of: &[(f64, usize)]) -> f64 {
        of.iter().fold(0.0, |sum, &(key, _)| sum + self.weight(key))
    }

    /// Spins the roulette wheel: a place among the samples from `first` on.
    fn spin(&self, first: usize, rng: &mut Stream) -> usize {
        let mut left = rng.unit() * self.weights(&self.order[first..]);
        let chosen = self.order[first..].iter().position(|&(key, _)| {
            left -= self.weight(key);
            left < 0.0
        });
        // Rounding may leave a little.
        chosen.map_or(self.order.len() - 1, |place| first + place)
    }

    /// Draws the samples and keeps some, in the order in which explanations list them.
    fn draw<const N: usize>(&mut self, forest: &mut Forest<N>, task: &Task<N>, near: usize, rng: &mut Stream) {
        let (from, goal) = (forest.trees[0].points[near], task.goal());
        let ahead = minus(&goal, &from);
        self.order.clear();
        for i in 0..self.samples {
            let point = task.uniform(rng);
            let angle = angle(&minus(&point, &from), &ahead);
            self.order.push((if self.by == By::Angle { angle } else { distance(&point, &goal) }, i));
            forest.last.samples.push(Sample { point, angle, share: 0.0, outcome: SampleOutcome::NotKept });
        }
        forest.last.near = near;
        if self.by == By::Angle {
            crate::math::sort(&mut self.order);
            self.order.truncate(self.keep);
        }
        let all = self.weights(&self.order);
        for &(key, i) in &self.order {
            forest.last.samples[i].share = if all > 0.0 { self.weight(key) / all } else { 1.0 / self.order.len() as f64 };
        }
        if self.by == By::Distance {
            for kept in 0..self.keep.min(self.samples) {
                let drawn = self.spin(kept, rng);
                self.order.swap(kept, drawn);
            }
            self.order.truncate(self.keep);
            crate::math::sort(&mut self.order);
        }
        for &(_, i) in &self.order {
            forest.last.samples[i].outcome = SampleOutcome::NotDrawn;
        }
    }

    /// Chooses one kept sample after another until the tree can grow toward it, or none is left.
    fn choose<const N: usize>(&mut self, forest: &mut Forest<N>, task: &Task<N>, near: usize, rng: &mut Stream) -> Option<usize> {
        let from = forest.trees[0].points[near];
        while !self.order.is_empty() {
            let chosen = if self.by == By::Angle { self.spin(0, rng) } else { 0 };
            let (_, i) = self.order.remove(chosen);
            let sample = forest.last.samples[i].point;
            let (outcome, new) = if distance(&from, &sample) < task.step {
                (SampleOutcome::TooNear, from)
            } else {
                let new = task.towards(&from, &sample);
                let doubles_back = task.contains(&new) && forest.trees[0].nearest(&new) != near;
                (if doubles_back { SampleOutcome::DoublesBack } else { forest.test(task, 0, near, &new) }, new)
            };
            forest.last.samples[i].outcome = outcome;
            if outcome == SampleOutcome::Taken {
                return Some(forest.add(task, 0, new, near));
            }
        }
        None
    }
}

/// A plain step, but for a sample that is nearer than a step: that is skipped.
fn plain<const N: usize>(forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) -> Option<usize> {
    forest.last.fell_back = true;
    let sample = task.uniform(rng);
    let near = forest.trees[0].nearest(&sample);
    if distance(&forest.trees[0].points[near], &sample) < task.step {
        forest.last.near = near;
        forest.record(sample, SampleOutcome::TooNear);
        return None;
    }
    forest.extend(task, sample, false)
}
