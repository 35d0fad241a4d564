//! A search by the stepped contract.

use crate::{
    kernel::{Candidate, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, Solution},
    scene::grid_path,
};

use super::{
    best_first::Search,
    parameters::{BEST, EXPANDED, FOUND_AFTER, FRONTIER, LOWEST},
};

impl Planner for Search {
    fn advance(&mut self) -> Progress {
        self.settle_some()
    }

    /// Cells settled.
    fn evaluations(&self) -> u64 {
        self.expanded
    }

    fn best(&self) -> Option<Candidate> {
        let found = self.found.as_ref()?;
        let path = if self.task.smooth { found.way.smooth(&self.task.grid) } else { &found.way.path };
        Some(Candidate { cost: found.cost, solution: Solution::Path(path.to_vec()) })
    }

    fn read(&self, out: &mut Readings) {
        let found = self.found.as_deref();
        let lowest = self.lowest.map_or(f64::NAN, |f| self.task.length(f) + self.task.endpoints.stubs);
        out.push(BEST, found.map_or(f64::NAN, |found| found.cost));
        out.push(LOWEST, lowest);
        grid_path::read(found.map(|found| &found.way), &self.task.grid, out);
        out.push(EXPANDED, self.expanded as f64);
        out.push(FRONTIER, self.frontier as f64);
        out.push(FOUND_AFTER, found.map_or(f64::NAN, |found| found.iteration as f64));
    }

    fn draw(&self, frame: &mut Frame) {
        self.draw_layers(frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self)
    }
}

impl Explain for Search {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        self.explain(item)
    }
}
