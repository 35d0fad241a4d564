//! The contract of planners: what the author of a planner writes.
//!
//! One step, mostly one call of [`Planner::advance`], is one drawable iteration. A planner owns its random stream and shares its scene
//! by `Arc`; a clone of it is a keyframe. The run counts iterations, keeps limit and status, and rewinds.

use std::any::Any;

use super::{Candidate, Facets, Frame, Readings, State, Status, Subtasks};

/// A planner that can be stepped, drawn, read, rewound and judged. Abilities that few planners have are [`Facets`].
///
/// It is deterministic, never panics, and allocates in `advance` only when something really grows. Its [`State`] is derived:
/// it gives the run's hash and the size of a keyframe.
pub trait Planner: State + CloneBox + Any + Send {
    /// Takes one step, or a part of one that is long: see [`Part`](super::Part). Not called again after [`Progress::Done`].
    fn advance(&mut self) -> Progress;
    /// The number of candidate solutions evaluated so far.
    fn evaluations(&self) -> u64;
    /// The best solution so far.
    fn best(&self) -> Option<Candidate>;
    /// Pushes the numbers of this iteration.
    fn read(&self, out: &mut Readings);
    /// Draws itself into a cleared frame.
    fn draw(&self, frame: &mut Frame);
    /// Its further abilities: explanations, members, events, …
    fn facets(&self) -> Facets<'_> {
        Facets::default()
    }
    /// The runs of other planners that its steps need, if any.
    fn subtasks(&mut self) -> Option<&mut dyn Subtasks> {
        None
    }
}

/// Whether a run goes on after a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// There is more to do, unless the limit is reached.
    Continue,
    /// The step is not over: the next call goes on with it. Only a whole step is an iteration and a keyframe; but a planner can be drawn
    /// and read within a step as well.
    Partly,
    /// The run is over, with this status; not [`Status::Running`].
    Done(Status),
}

/// Copies a boxed planner. Every planner that can be cloned has it.
pub trait CloneBox {
    /// A copy of the whole state.
    fn clone_box(&self) -> Box<dyn Planner>;
}

impl<P: Planner + Clone> CloneBox for P {
    fn clone_box(&self) -> Box<dyn Planner> {
        Box::new(self.clone())
    }
}
