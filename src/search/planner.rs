//! A search by the stepped contract.

use crate::{
    kernel::{Best, Digest, Frame, Inspection, Item, Planner, Readings, Solution, Status, Yardstick},
    way,
};

use super::{best_first::Search, rules::Relaxation};

impl Planner for Search {
    fn step(&mut self) -> Status {
        self.advance();
        self.status
    }

    fn status(&self) -> Status {
        self.status
    }

    fn iteration(&self) -> u64 {
        self.iteration
    }

    fn limit(&self) -> u64 {
        self.task.limit
    }

    /// Cells settled.
    fn evaluations(&self) -> u64 {
        self.expanded
    }

    fn best(&self) -> Option<Best> {
        let found = self.found.as_ref()?;
        let path = if self.task.smooth { found.way.smooth(&self.task.scene) } else { &found.way.path };
        Some(Best { cost: found.cost, solution: Solution::Path(path.to_vec()) })
    }

    fn read(&self, out: &mut Readings) {
        let found = self.found.as_deref();
        let lowest = self.lowest.map_or(f64::NAN, |f| self.task.length(f) + self.task.course.stubs);
        out.push("best", found.map_or(f64::NAN, |found| found.cost));
        out.push("f", lowest);
        way::read(found.map(|found| &found.way), &self.task.scene, out);
        out.push("expanded", self.expanded as f64);
        out.push("frontier", self.frontier as f64);
        out.push("converged", found.map_or(f64::NAN, |found| found.iteration as f64));
    }

    fn draw(&self, frame: &mut Frame) {
        self.draw_layers(frame);
    }

    fn inspect(&self, item: Item) -> Option<Inspection> {
        self.tell(item)
    }

    fn yardstick(&self) -> Yardstick {
        match self.task.rules.relaxation {
            Relaxation::Step if !self.task.smooth => Yardstick::Cells,
            _ => Yardstick::AnyAngle,
        }
    }

    fn digest(&self, out: &mut Digest) {
        out.word(self.iteration);
        out.word(self.status as u64);
        self.digest_cells(out);
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.bytes_of_cells() + self.found.as_ref().map_or(0, |found| found.bytes())
    }
}
