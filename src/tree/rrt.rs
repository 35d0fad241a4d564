//! `rrt`: the basic rapidly-exploring random tree, [ARM-RRT](crate#papers) §3.2, LaValle 1998.

use crate::{
    describe::{Entry, Start},
    kernel::{Error, State, rng::Stream},
};

use super::{
    draw::LAYERS,
    explain::SYMBOLS,
    finish::{FITTED, HERMITE},
    grow::{Forest, Grown, Method, Source},
    parameters::{BIAS, FINISH, FORMULA_STEP, ITERATIONS, KINDS, READINGS, STEP},
    sample::uniform,
    task::Task,
};

/// See the module.
pub const ENTRY: Entry = Entry::new(
    "rrt",
    "RRT: a random tree",
    "[ARM-RRT] §3.2",
    "The node nearest to a random point grows by a step towards it, until the tree comes within a step of the goal.",
    |start| Ok(grown(start)?.into()),
)
.family("tree")
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
.symbols(SYMBOLS)
.layers(LAYERS);

/// The planner behind the entry.
pub(super) fn grown(start: &Start) -> Result<Grown<3, Rrt>, Error> {
    super::grown(start, start.parameters[BIAS], |_| Rrt)
}

#[derive(Clone, State)]
pub(super) struct Rrt;

impl<const N: usize> Method<N> for Rrt {
    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream) {
        let to_goal = rng.unit() < task.goal_bias;
        let sample = if to_goal { task.goal() } else { uniform(&task.min, &task.max, rng) };
        forest.begin(if to_goal { Source::Goal } else { Source::Uniform }, 0);
        let Some(new) = forest.extend(task, sample, to_goal) else { return };
        forest.reach(task, new);
    }
}
