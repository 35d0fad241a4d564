//! The stepped contract: what a planner's author writes.
//!
//! One call of [`Planner::advance`] is one drawable iteration. A planner owns its random stream and shares its scene by
//! `Arc`; a clone of it is a keyframe. Counting iterations, the limit, the status and the way back are the run's.

use std::any::Any;

use super::{Candidate, Facets, Frame, Readings, State, Status, Subtasks};

/// A planner that can be stepped, drawn, read, rewound and judged; what few planners can do besides is among its
/// [`Facets`].
///
/// It is deterministic, never panics, and allocates in `advance` only when something really grows. Its [`State`] is derived:
/// it gives the run's hash and the size of a keyframe.
pub trait Planner: State + CloneBox + Any + Send {
    /// Takes one step. It is not called again after it was done.
    fn advance(&mut self) -> Progress;
    /// How many candidate solutions were evaluated.
    fn evaluations(&self) -> u64;
    /// The best solution so far.
    fn best(&self) -> Option<Candidate>;
    /// The numbers of this iteration.
    fn read(&self, out: &mut Readings);
    /// Draws itself into a cleared frame.
    fn draw(&self, frame: &mut Frame);
    /// What it can do besides: explain itself, list its members, …
    fn facets(&self) -> Facets<'_> {
        Facets::default()
    }
    /// The runs of other planners that its steps rest on, if it needs any.
    fn subtasks(&mut self) -> Option<&mut dyn Subtasks> {
        None
    }
}

/// Whether a run goes on after a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// There is more to do, unless the limit is reached.
    Continue,
    /// It is over, and why; not [`Status::Running`].
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
