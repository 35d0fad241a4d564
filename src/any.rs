//! The object-safe twin of [`Planner`], so that a session holds any planner. Kept apart from the trait itself because
//! the same method names in one scope would clash.

use crate::kernel::{
    Best, Digest, Event, Finding, Frame, Inspection, Item, Job, Planner, Readings, Round, Stage, Status, Tuned, Yardstick,
};

/// Any planner, boxed. Implemented for every [`Planner`] by one blanket implementation.
pub trait AnyPlanner: Send {
    /// Takes one step and says whether there was one to take.
    fn step_taken(&mut self) -> bool;
    /// A copy of the whole state.
    fn checkpoint(&self) -> Box<dyn AnyPlanner>;
    /// See [`Planner::status`].
    fn status(&self) -> Status;
    /// See [`Planner::iteration`].
    fn iteration(&self) -> u64;
    /// See [`Planner::limit`].
    fn limit(&self) -> u64;
    /// See [`Planner::evaluations`].
    fn evaluations(&self) -> u64;
    /// See [`Planner::best`].
    fn best(&self) -> Option<Best>;
    /// Replaces `out` by the numbers of this iteration.
    fn read(&self, out: &mut Readings);
    /// See [`Planner::draw`].
    fn draw(&self, frame: &mut Frame);
    /// See [`Planner::inspect`].
    fn inspect(&self, item: Item) -> Option<Inspection>;
    /// See [`Planner::explain`].
    fn explain(&self, item: Item) -> Option<Inspection>;
    /// See [`Planner::made`].
    fn made(&self, item: Item) -> Option<u64>;
    /// See [`Planner::yardstick`].
    fn yardstick(&self) -> Yardstick;
    /// See [`Planner::jobs`].
    fn jobs(&self) -> Vec<Job>;
    /// See [`Planner::supply`].
    fn supply(&mut self, found: Vec<Finding>);
    /// See [`Planner::stages`].
    fn stages(&self) -> Vec<Stage>;
    /// See [`Planner::events`].
    fn events(&self) -> &[Event];
    /// See [`Planner::round`].
    fn round(&self) -> Option<Round>;
    /// Replaces `out` by the members' numbers.
    fn members(&self, out: &mut Vec<f64>);
    /// See [`Planner::trouble`].
    fn trouble(&self) -> Option<String>;
    /// See [`Planner::tuned`].
    fn tuned(&self) -> Option<Tuned>;
    /// See [`Planner::digest`].
    fn digest(&self, out: &mut Digest);
    /// See [`Planner::bytes`].
    fn bytes(&self) -> usize;
}

impl<P: Planner + Send + 'static> AnyPlanner for P {
    fn step_taken(&mut self) -> bool {
        let before = Planner::iteration(self);
        self.step();
        Planner::iteration(self) > before
    }

    fn checkpoint(&self) -> Box<dyn AnyPlanner> {
        Box::new(self.clone())
    }

    fn status(&self) -> Status {
        Planner::status(self)
    }

    fn iteration(&self) -> u64 {
        Planner::iteration(self)
    }

    fn limit(&self) -> u64 {
        Planner::limit(self)
    }

    fn evaluations(&self) -> u64 {
        Planner::evaluations(self)
    }

    fn best(&self) -> Option<Best> {
        Planner::best(self)
    }

    fn read(&self, out: &mut Readings) {
        out.clear();
        Planner::read(self, out);
    }

    fn draw(&self, frame: &mut Frame) {
        Planner::draw(self, frame);
    }

    fn inspect(&self, item: Item) -> Option<Inspection> {
        Planner::inspect(self, item)
    }

    fn explain(&self, item: Item) -> Option<Inspection> {
        Planner::explain(self, item)
    }

    fn made(&self, item: Item) -> Option<u64> {
        Planner::made(self, item)
    }

    fn yardstick(&self) -> Yardstick {
        Planner::yardstick(self)
    }

    fn jobs(&self) -> Vec<Job> {
        Planner::jobs(self)
    }

    fn supply(&mut self, found: Vec<Finding>) {
        Planner::supply(self, found);
    }

    fn stages(&self) -> Vec<Stage> {
        Planner::stages(self)
    }

    fn events(&self) -> &[Event] {
        Planner::events(self)
    }

    fn round(&self) -> Option<Round> {
        Planner::round(self)
    }

    fn members(&self, out: &mut Vec<f64>) {
        out.clear();
        Planner::members(self, out);
    }

    fn trouble(&self) -> Option<String> {
        Planner::trouble(self)
    }

    fn tuned(&self) -> Option<Tuned> {
        Planner::tuned(self)
    }

    fn digest(&self, out: &mut Digest) {
        Planner::digest(self, out);
    }

    fn bytes(&self) -> usize {
        Planner::bytes(self)
    }
}
