//! `rrt`: the basic rapidly-exploring random tree, [ARM-RRT](crate#papers) §3.2, LaValle 1998.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry},
    kernel::{Error, Started, State, rng::Stream},
    params::Parameters,
};

use super::{
    draw::LAYERS,
    finish::{FITTED, HERMITE},
    grow::{Forest, Source},
    method::{Method, Trees},
    parameters::{BIAS, FINISH, FORMULA_STEP, ITERATIONS, KINDS, READINGS, STEP},
    space::{self, Space},
    task::Task,
};

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "slalom",
        "A tree finds a way",
        "Samples fall anywhere; it takes some hundred steps to wind through the slalom.",
        "discs-slalom",
        &[],
    ),
    Case::new(
        "cuboid",
        "A tree fills the room",
        "The basic tree goes everywhere: compare its nodes with the guided tree’s.",
        "arm-cuboid",
        &[],
    ),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "the tree begins at the start",
    "repeat until a node is within a step of the goal:",
    "  draw a random point $x_{\\text{rand}}$; with probability @goal_bias@ it is the goal",
    "  the node nearest to it takes a step of @step_size@ toward it",
    "  if that is free: it becomes a node; otherwise it is rejected",
    "  nodes: @nodes@, rejected steps: @rejected@, to go: @to_goal@",
    "follow the parents back from the goal: length @final_length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "rrt",
    "RRT: a random tree",
    "[ARM-RRT] §3.2",
    "The node nearest to a random point grows by a step towards it, until the tree comes within a step of the goal.",
    |start| space::start(start, on),
)
.family("tree")
.evaluating(crate::tree::EVALUATION)
.kinds(KINDS)
.parameters(&[
    &[
        ITERATIONS
            .default_to(100_000)
            .help("After how many extensions it stops at the latest, found or not. Without a goal bias it may take many.")
            .entry(),
        STEP.entry(),
        BIAS.entry(),
    ],
    FINISH,
])
.readings(READINGS)
.formulas(&[FORMULA_STEP, FITTED, HERMITE])
.layers(LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it in any space; `settings` are the parameters of [`ENTRY`].
///
/// # Errors
/// As [`Trees::new`].
pub fn on<const N: usize>(space: Arc<dyn Space<N>>, settings: &Parameters, seed: u64) -> Result<Started, Error> {
    Ok(Trees::new(space, settings, seed, |_| Rrt::new(settings))?.into())
}

#[derive(Clone, Copy, State)]
pub(super) struct Rrt {
    /// How often the sample is the goal itself.
    #[state(shared)]
    pub(super) goal_bias: f64,
}

impl Rrt {
    pub(super) fn new(settings: &Parameters) -> Self {
        Self { goal_bias: settings[BIAS] }
    }
}

impl<const N: usize> Method<N> for Rrt {
    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) {
        let to_goal = rng.unit() < self.goal_bias;
        let sample = if to_goal { task.goal() } else { task.uniform(rng) };
        forest.begin(if to_goal { Source::Goal } else { Source::Uniform }, 0);
        let Some(new) = forest.extend(task, sample, to_goal) else { return };
        forest.reach(task, new);
    }
}
