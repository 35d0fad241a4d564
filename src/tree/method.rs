//! Trees that a method grows: the state of every tree planner.

use std::sync::Arc;

use crate::{
    kernel::{Error, Progress, State, Status, rng::Stream},
    params::Parameters,
};

use super::{grow::Forest, space::Space, task::Task};

/// How one extension is made. A method is one of these, with what it remembers from extension to extension.
pub trait Method<const N: usize>: Clone + State + Send + Sync + 'static {
    /// It goes on when there is a path, for a better one.
    const ANYTIME: bool = false;
    /// A second tree grows from the goals.
    const FROM_GOAL: bool = false;
    /// Extends a tree once: begins by [`Forest::begin`], and keeps a path when one is found.
    fn grow(&mut self, forest: &mut Forest<N>, task: &Task<N>, rng: &mut Stream);
}

/// A tree planner: trees, and the method that grows them. `Started::from(Trees::new(…)?)` is a run of it.
#[derive(Clone, State)]
pub struct Trees<const N: usize, M> {
    #[state(shared)]
    pub(super) task: Arc<Task<N>>,
    pub(super) forest: Forest<N>,
    pub(super) method: M,
    pub(super) rng: Stream,
}

/// What there is to see of a planner, whatever its method: drawn and explained once for all methods.
pub(super) struct Seen<'a, const N: usize> {
    pub(super) task: &'a Task<N>,
    pub(super) forest: &'a Forest<N>,
}

impl<const N: usize, M: Method<N>> Trees<N, M> {
    /// A planner before its first extension, by a method that may look at the task first. It reads `iterations`, `step_size` and
    /// what is to be made of the path: the parameters of every entry of this family, e.g. of [`rrt`](super::rrt::ENTRY).
    ///
    /// # Errors
    /// [`Error::Refused`] for a space without goals, for bounds, a start or goals that are not finite, for bounds in the wrong order,
    /// and for a step of 0.
    pub fn new(space: Arc<dyn Space<N>>, parameters: &Parameters, seed: u64, method: impl FnOnce(&Task<N>) -> M) -> Result<Self, Error> {
        let task = Task::new(space, parameters)?;
        let method = method(&task);
        Ok(Self::of(task, method, seed))
    }

    /// Of a task.
    pub(super) fn of(task: Task<N>, method: M, seed: u64) -> Self {
        let mut forest = Forest::new(&task);
        if M::FROM_GOAL {
            task.space.goals().iter().for_each(|&goal| forest.root(&task, 1, goal));
        }
        Self { task: Arc::new(task), forest, method, rng: Stream::new(seed, 0) }
    }

    /// The trees and the path.
    pub fn forest(&self) -> &Forest<N> {
        &self.forest
    }

    /// What there is to see.
    pub(super) fn seen(&self) -> Seen<'_, N> {
        Seen { task: &self.task, forest: &self.forest }
    }

    /// One extension.
    #[inline(never)]
    pub(super) fn extend(&mut self) -> Progress {
        let Self { task, forest, method, rng } = self;
        forest.iteration += 1;
        method.grow(forest, task, rng);
        forest.rejected += u64::from(!forest.last.added && forest.found.as_ref().is_none_or(|found| found.iteration != forest.iteration));
        if forest.found.is_some() && !M::ANYTIME { Progress::Done(Status::Solved) } else { Progress::Continue }
    }
}
