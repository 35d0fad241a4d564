//! `rrt-connect`: two trees that grow towards each other, Kuffner and LaValle 2000. One extension a step.

use std::sync::Arc;

use crate::{
    describe::{Case, Entry},
    kernel::{Error, Started, State, rng::Stream},
    params::Parameters,
};

use super::{
    draw::CONNECT_LAYERS,
    finish::{FITTED, HERMITE},
    grow::{Forest, SampleOutcome, Source},
    method::{Method, Trees},
    parameters::{FINISH, FORMULA_STEP, ITERATIONS, KINDS, READINGS, STEP},
    space::{self, Space},
    task::Task,
};

/// Runs that show something.
const CASES: &[Case] = &[
    Case::new(
        "slalom",
        "Two trees meet",
        "One tree grows from each end; each goes straight for the other until they meet.",
        "discs-slalom",
        &[],
    ),
    Case::new(
        "cuboid",
        "Two trees around a cuboid",
        "The trees meet beside the cuboid. Let the arm follow the path: the verdict is of the whole arm.",
        "arm-cuboid",
        &[],
    ),
];
/// What it does, with the numbers of the iteration.
const PSEUDOCODE: &[&str] = &[
    "one tree begins at the start, one at the goal",
    "repeat until a path leads through both:",
    "  draw a random point; the nearest node of one tree takes a step of @step_size@ toward it",
    "  if that is free: the other tree goes straight for the new node, as far as it can",
    "  the trees change places",
    "  nodes: @nodes@, rejected steps: @rejected@",
    "follow both trees from where they meet: length @final_length@",
];

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "rrt-connect",
    "RRT-Connect: two trees",
    "Kuffner and LaValle 2000",
    "A tree grows from the start and one from the goal. One takes a step towards a random point; the other then goes straight for the new node, step by step, as far as it can. They change places until a path leads through both.",
    |start| space::start(start, on),
)
.family("tree")
.evaluating(crate::tree::EVALUATION)
.kinds(KINDS)
.parameters(&[&[ITERATIONS.entry(), STEP.entry()], FINISH])
.readings(READINGS)
.formulas(&[FORMULA_STEP, FITTED, HERMITE])
.layers(CONNECT_LAYERS)
.cases(CASES)
.pseudocode(PSEUDOCODE);

/// Starts it in any space; `settings` are the parameters of [`ENTRY`].
///
/// # Errors
/// As [`Trees::new`].
pub fn on<const N: usize>(space: Arc<dyn Space<N>>, settings: &Parameters, seed: u64) -> Result<Started, Error> {
    Ok(Trees::new(space, settings, seed, |_| Connect::default())?.into())
}

/// Which tree's turn it is, and what the other one goes for.
#[derive(Clone, Default, State)]
pub(super) struct Connect {
    /// The tree that explores.
    explorer: usize,
    /// Its newest node, while the other tree can still come nearer to it.
    newest: Option<usize>,
}

impl<const N: usize> Method<N> for Connect {
    const FROM_GOAL: bool = true;

    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) {
        let Some(newest) = self.newest else {
            forest.begin(Source::Uniform, self.explorer);
            let sample = task.uniform(rng);
            self.newest = forest.extend(task, sample, true);
            if self.newest.is_none() {
                self.explorer = 1 - self.explorer;
            }
            return;
        };
        let (explorer, other) = (self.explorer, 1 - self.explorer);
        forest.begin(Source::Other, other);
        let target = forest.trees[explorer].points[newest];
        match forest.extend(task, target, true) {
            Some(node) if forest.trees[other].points[node] == target => {
                let (of_start, of_goal) = if explorer == 0 { (newest, node) } else { (node, newest) };
                if !join(forest, task, of_start, of_goal) {
                    (self.newest, self.explorer) = (None, other);
                }
            }
            Some(_) => {}
            None => (self.newest, self.explorer) = (None, other),
        }
    }
}

/// Keeps the path over a node of each tree, both in one place. Each may have another posture there: from that of the start's tree the arm
/// has to get on to the goal. Whether it does.
fn join<const N: usize>(forest: &mut Forest<N>, task: &Task<N>, of_start: usize, of_goal: usize) -> bool {
    let (mut path, mut postures) = (forest.trees[0].path_to(of_start), forest.trees[0].postures_to(of_start));
    for point in forest.trees[1].path_to(of_goal).into_iter().rev().skip(1) {
        if let Some(at) = postures.last() {
            forest.tested += 1;
            let Some(there) = task.space.posture_at(&path[path.len() - 1], at, &point, None) else {
                forest.record(point, SampleOutcome::Unreachable);
                return false;
            };
            postures.push(there);
        }
        path.push(point);
    }
    forest.keep(path, postures);
    true
}
