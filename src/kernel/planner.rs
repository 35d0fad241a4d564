//! The stepped contract: what a planner's author writes.
//!
//! One step is one drawable iteration. A planner owns its random stream and shares its scene by `Arc`; a clone of it is
//! a keyframe. The caller owns the loop.

use super::{Best, Digest, Event, Finding, Frame, Inspection, Item, Job, Readings, Round, Stage, Status, Tuned, Yardstick};

/// A planner that can be stepped, drawn, read, explained, rewound and judged.
///
/// It is deterministic, never panics, and allocates in `step` only when something really grows.
pub trait Planner: Clone {
    /// Takes one step; does nothing once finished.
    fn step(&mut self) -> Status;
    /// Whether there is more to do.
    fn status(&self) -> Status;
    /// How many steps were taken.
    fn iteration(&self) -> u64;
    /// After how many steps it stops at the latest.
    fn limit(&self) -> u64;
    /// How many candidate solutions were evaluated.
    fn evaluations(&self) -> u64;
    /// The best solution so far.
    fn best(&self) -> Option<Best>;
    /// The numbers of this iteration.
    fn read(&self, out: &mut Readings);
    /// Draws itself into a cleared frame.
    fn draw(&self, frame: &mut Frame);
    /// What can be said of an item from the present state alone.
    fn inspect(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// What the next step does to an item and why; takes that step on a copy. The session asks the state before.
    /// So nothing has to be recorded in the inner loop for the one particle that somebody may click.
    fn explain(&self, _item: Item) -> Option<Inspection> {
        None
    }
    /// The iteration whose step is to be explained for an item that came about then; `None`: the last one.
    fn made(&self, _item: Item) -> Option<u64> {
        None
    }
    /// Which optimum its results are measured by.
    fn yardstick(&self) -> Yardstick {
        Yardstick::default()
    }
    /// The runs of other planners that the next step needs; none, for most.
    fn jobs(&self) -> Vec<Job> {
        Vec::new()
    }
    /// Takes what the runs of [`Planner::jobs`] found, in their order; the next step uses it.
    fn supply(&mut self, _found: Vec<Finding>) {}
    /// The parts of a run, in their order; none, for most: all steps are of one kind.
    fn stages(&self) -> Vec<Stage> {
        Vec::new()
    }
    /// What happened so far, in the order of time; nothing, for most.
    fn events(&self) -> &[Event] {
        &[]
    }
    /// What the ends of its tours are, if it finds tours.
    fn round(&self) -> Option<Round> {
        None
    }
    /// The numbers of those that search side by side: for each of them, in the order of the layer that can be inspected,
    /// one for each of the entry's `members`.
    fn members(&self, _out: &mut Vec<f64>) {}
    /// What keeps it from a result, if something does, in a sentence without a full stop.
    fn trouble(&self) -> Option<String> {
        None
    }
    /// The parameters that it recommends for another planner.
    fn tuned(&self) -> Option<Tuned> {
        None
    }
    /// Adds the whole state to a hash.
    fn digest(&self, out: &mut Digest);
    /// About how much memory a clone takes, in bytes.
    fn bytes(&self) -> usize;
}
