//! A search by the stepped contract, and how it starts.

use crate::{
    describe::Start,
    kernel::{
        Candidate, Error, Explain, Facets, Frame, Inspection, Item, Planner, Progress, Readings, ReferenceOptimum, Solution, Started,
    },
    message,
    scene::grid_path,
};

use super::{
    best_first::Search,
    parameters::{BEST, EXPANDED, FOUND_AFTER, FRONTIER, LOWEST},
    rules::{Heuristic, Relaxation, Rules},
};

/// Starts a search by these rules on a grid; the entry lists the parameters of [`dijkstra`](super::dijkstra::ENTRY). A cell's place on the
/// open list is the length of the path to it and `weight` times the heuristic: 1 is A*, more is greedier, and settles fewer cells.
///
/// # Errors
/// [`Error::Refused`] for another kind of scene, a grid without start and goal, and a weight that is negative or not finite.
pub fn start(start: &Start, heuristic: Heuristic, weight: f64, relaxation: Relaxation) -> Result<Started, Error> {
    if !(weight >= 0.0 && weight.is_finite()) {
        return Err(Error::refused("weight", weight, message!("error-finite-from", "a finite number from {low} on", low = 0.0)));
    }
    let search = Search::new(start, Rules { heuristic, relaxation }, weight)?;
    let (limit, smooth) = (search.task.limit, search.task.smooth);
    let cells = relaxation == Relaxation::Step && !smooth;
    Ok(Started::new(search, limit).open_ended().measured_by(if cells { ReferenceOptimum::Cells } else { ReferenceOptimum::AnyAngle }))
}

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

    fn suppose_now(&self, item: Item, supposition: &str) -> Option<Inspection> {
        Some(self.suppose(item, supposition))
    }
}
