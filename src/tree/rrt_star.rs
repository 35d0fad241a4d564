//! `rrt-star`: the tree that goes on getting better, Karaman and Frazzoli 2011; with informed sampling once a path is known,
//! Gammell, Srinivasa and Barfoot 2014.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry},
    kernel::{Error, Started, State, rng::Stream},
    math,
    params::Parameters,
};

use super::{
    draw::LAYERS,
    finish::{FITTED, HERMITE},
    forest::NONE,
    grow::{Forest, SampleOutcome, Source},
    method::{Method, Trees},
    parameters::{BIAS, FINISH, FORMULA_INFORMED, FORMULA_RADIUS, FORMULA_STEP, INFORMED, ITERATIONS, KINDS, READINGS, REWIRE, STEP},
    sample::{Informed, ball},
    space::{self, Space},
    task::Task,
    vector::distance,
};

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "slalom",
        "Ever shorter",
        "The first path comes soon; the tree is rewired, and the path gets ever shorter.",
        "discs-slalom",
        &[],
    ),
    Case::new("cuboid", "Rewired around a cuboid", "The path comes near to the tip’s shortest way.", "arm-cuboid", &[]),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "the tree begins at the start",
    "repeat until extension @iterations@:",
    "  draw a random point; once there is a path, only where a shorter one can lead",
    "  the nearest node takes a step of @step_size@ toward it",
    "  if that is free: the new node takes the parent with the shortest way",
    "    neighbours to which the way over it is shorter take it as parent",
    "  nodes: @nodes@, rejected steps: @rejected@",
    "  the shortest path so far has length @best@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "rrt-star",
    "RRT*: ever shorter",
    "Karaman and Frazzoli 2011",
    "A new node takes the parent with the shortest way, and its neighbours take it as theirs where that is shorter. The path approaches the shortest. Once there is one, samples come only from where a shorter one could lead.",
    |start| space::start(start, on),
)
.family("tree")
.evaluating(crate::tree::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[
        ITERATIONS.default_to(5_000).help("After how many extensions it stops: the path gets shorter as long as it goes on.").entry(),
        STEP.entry(),
        BIAS.default_to(0.05).help("How often the sample is the goal itself until there is a path, as a share of the steps.").entry(),
        REWIRE.entry(),
        INFORMED.entry(),
    ],
    FINISH,
])
.readings(READINGS)
.formulas(&[FORMULA_STEP, FORMULA_RADIUS, FORMULA_INFORMED, FITTED, HERMITE])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it in any space; `settings` are the parameters of [`ENTRY`].
///
/// # Errors
/// As [`Trees::new`].
pub fn on<const N: usize>(space: Arc<dyn Space<N>>, settings: &Parameters, seed: u64) -> Result<Started, Error> {
    Ok(Trees::new(space, settings, seed, |task| Star::new(task, settings))?.into())
}

#[derive(Clone, State)]
pub(super) struct Star<const N: usize> {
    /// How often the sample is the goal itself until there is a path.
    #[state(shared)]
    goal_bias: f64,
    #[state(shared)]
    informed: Option<Informed<N>>,
    #[state(shared)]
    dimensions: usize,
    /// γ: with it the radius shrinks so slowly that the path still approaches the shortest.
    #[state(shared)]
    gamma: f64,
    /// The radius is at most so long.
    #[state(shared)]
    most: f64,
    /// The volume of the space.
    #[state(shared)]
    volume: f64,
    /// The goal, once it is a node.
    goal: Option<usize>,
    /// Of each node its newest child, and the child of the same parent that came before it.
    newest: Vec<u32>,
    sibling: Vec<u32>,
    /// Neighbours by the length of the way over them, re-used.
    #[state(skip)]
    near: Vec<u32>,
    #[state(skip)]
    order: Vec<(f64, usize)>,
    #[state(skip)]
    stack: Vec<u32>,
}

impl<const N: usize> Star<N> {
    pub(super) fn new(task: &Task<N>, settings: &Parameters) -> Self {
        let dimensions = task.space.dimensions().clamp(1, N);
        let d = dimensions as f64;
        let volume = (0..dimensions).map(|i| task.max[i] - task.min[i]).product::<f64>();
        Self {
            goal_bias: settings[BIAS],
            informed: settings[INFORMED].then(|| Informed::new(task.start, task.goal(), dimensions)),
            dimensions,
            // The free part is not known; all of it is an upper bound, so γ is large enough.
            gamma: 1.1 * math::pow(2.0 * (1.0 + 1.0 / d) * volume / ball(dimensions), 1.0 / d),
            most: settings[REWIRE] * task.step,
            volume,
            goal: None,
            newest: vec![NONE],
            sibling: vec![NONE],
            near: Vec::new(),
            order: Vec::new(),
            stack: Vec::new(),
        }
    }

    /// r of Karaman and Frazzoli for n nodes.
    fn radius(&self, n: usize) -> f64 {
        let n = n as f64;
        (self.gamma * math::pow(math::ln(n) / n, 1.0 / self.dimensions as f64)).min(self.most)
    }

    fn sample(&self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) -> [f64; N] {
        if rng.unit() < self.goal_bias && self.goal.is_none() {
            forest.begin(Source::Goal, 0);
            return task.goal();
        }
        let best = forest.found.as_ref().map(|found| found.cost);
        if let (Some(informed), Some(length)) = (&self.informed, best)
            && informed.volume(length) < self.volume
        {
            // Part of it may lie outside.
            for _ in 0..100 {
                let sample = informed.draw(length, rng);
                if task.contains(&sample) {
                    forest.begin(Source::Informed, 0);
                    return sample;
                }
            }
        }
        forest.begin(Source::Uniform, 0);
        task.uniform(rng)
    }

    /// Adds a node as the child of the neighbour with the shortest way, then makes it the parent of those whose way over it
    /// is shorter.
    fn insert(&mut self, forest: &mut Forest<N>, task: &Task<N>, new: [f64; N], nearest: usize) -> usize {
        let radius = self.radius(forest.trees[0].len() + 1);
        forest.trees[0].within(&new, radius, &mut self.near);
        self.order.clear();
        for &node in &self.near {
            let node = node as usize;
            self.order.push((forest.trees[0].costs[node] + distance(&forest.trees[0].points[node], &new), node));
        }
        math::sort(&mut self.order);
        // The nearest is known to see it.
        let mut parent = nearest;
        let known = forest.trees[0].costs[nearest] + distance(&forest.trees[0].points[nearest], &new);
        for &(cost, node) in self.order.iter().take_while(|(cost, _)| *cost < known) {
            debug_assert!(cost < known);
            if forest.test(task, 0, node, &new) == SampleOutcome::Taken {
                parent = node;
                break;
            }
        }
        let node = forest.add(task, 0, new, parent);
        self.newest.push(NONE);
        self.sibling.push(NONE);
        self.adopt(parent, node);
        for i in 0..self.near.len() {
            let other = self.near[i] as usize;
            let (point, way) =
                (forest.trees[0].points[other], forest.trees[0].costs[node] + distance(&forest.trees[0].points[other], &new));
            if other != parent
                && way < forest.trees[0].costs[other]
                && forest.test_to(task, 0, node, &point, Some(other)) == SampleOutcome::Taken
            {
                self.rewire(forest, other, node);
                forest.last.rewired += 1;
            }
        }
        node
    }

    fn adopt(&mut self, parent: usize, child: usize) {
        self.sibling[child] = std::mem::replace(&mut self.newest[parent], child as u32);
    }

    /// Gives a node another parent, and all that comes after it the lengths that follow.
    fn rewire(&mut self, forest: &mut Forest<N>, node: usize, parent: usize) {
        let tree = &mut forest.trees[0];
        let old = tree.parents[node] as usize;
        if self.newest[old] == node as u32 {
            self.newest[old] = self.sibling[node];
        } else {
            let mut before = self.newest[old] as usize;
            while self.sibling[before] != node as u32 {
                before = self.sibling[before] as usize;
            }
            self.sibling[before] = self.sibling[node];
        }
        self.adopt(parent, node);
        tree.parents[node] = parent as u32;
        self.stack.push(node as u32);
        while let Some(at) = self.stack.pop() {
            let at = at as usize;
            let parent = tree.parents[at] as usize;
            tree.costs[at] = tree.costs[parent] + distance(&tree.points[parent], &tree.points[at]);
            let mut child = self.newest[at];
            while child != NONE {
                self.stack.push(child);
                child = self.sibling[child as usize];
            }
        }
    }
}

impl<const N: usize> Method<N> for Star<N> {
    const ANYTIME: bool = true;

    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) {
        let sample = self.sample(forest, task, rng);
        let near = forest.trees[0].nearest(&sample);
        let from = forest.trees[0].points[near];
        let far = distance(&from, &sample);
        let new = if far <= task.step { sample } else { task.towards(&from, &sample) };
        let outcome = if far == 0.0 { SampleOutcome::TooNear } else { forest.test(task, 0, near, &new) };
        forest.last.near = near;
        forest.record(sample, outcome);
        if outcome != SampleOutcome::Taken {
            return;
        }
        let node = self.insert(forest, task, new, near);
        let goal = task.goal();
        if self.goal.is_none() && new == goal {
            self.goal = Some(node);
        } else if self.goal.is_none() && distance(&new, &goal) <= task.step && forest.test(task, 0, node, &goal) == SampleOutcome::Taken {
            self.goal = Some(self.insert(forest, task, goal, node));
        }
        // The goal's way is a path; kept when it became shorter.
        let Some(goal) = self.goal else { return };
        let cost = forest.trees[0].costs[goal];
        if forest.found.as_ref().is_none_or(|found| cost < found.cost) {
            let (path, postures) = (forest.trees[0].path_to(goal), forest.trees[0].postures_to(goal));
            forest.keep(path, postures);
        }
    }
}
