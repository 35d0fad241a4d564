//! A tree by the stepped contract.

use crate::{
    describe::layers,
    kernel::{Candidate, Explain, Facets, Frame, Inspection, Item, Members, Planner, Progress, Readings, Started, rng::Stream},
};

use super::{
    method::{Method, Seen, Trees},
    parameters::{BEST, FINAL_LENGTH, FOUND_AFTER, NODES, REJECTED, SHORT_LENGTH, TESTED, TO_GOAL},
    vector::length,
};

impl<const N: usize, M: Method<N>> Planner for Trees<N, M> {
    fn advance(&mut self) -> Progress {
        self.extend()
    }

    /// Straight pieces tested.
    fn evaluations(&self) -> u64 {
        self.forest.tested
    }

    fn best(&self) -> Option<Candidate> {
        let found = self.forest.found.as_ref()?;
        let path = if self.task.finish.is_raw() { &found.raw } else { &found.finished(&self.task).path };
        Some(Candidate { cost: found.cost, solution: self.task.space.solution(path) })
    }

    fn read(&self, out: &mut Readings) {
        self.seen().read(out);
    }

    fn draw(&self, frame: &mut Frame) {
        self.seen().draw_layers(frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).members(self)
    }
}

impl<const N: usize, M: Method<N>> Trees<N, M> {
    /// After another extension, with these random numbers or its own.
    #[inline(never)]
    fn extended(&self, others: Option<&Stream>) -> Self {
        let mut next = self.clone();
        next.rng.clone_from(others.unwrap_or(&self.rng));
        next.extend();
        next
    }
}

impl<const N: usize, M: Method<N>> Explain for Trees<N, M> {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        self.seen().explain(item)
    }

    fn explain_next(&self, item: Item) -> Option<Inspection> {
        self.extended(None).seen().describe_birth(item)
    }

    fn suppose(&self, item: Item, _supposition: &str, others: &Stream) -> Option<Inspection> {
        Some(self.extended(Some(others)).seen().describe_supposed(item, self.forest.births.len()))
    }

    fn created_at(&self, item: Item) -> Option<u64> {
        let births = &self.forest.births;
        (item.layer == layers::NODES.key).then(|| births.get(item.index).map(|birth| u64::from(birth.iteration)))?
    }
}

impl<const N: usize, M: Method<N>> Members for Trees<N, M> {
    fn members(&self, out: &mut Vec<f64>) {
        self.seen().members(out);
    }
}

impl<const N: usize, M: Method<N>> From<Trees<N, M>> for Started {
    fn from(trees: Trees<N, M>) -> Self {
        let limit = trees.task.limit;
        let started = Self::new(trees, limit);
        if M::ANYTIME { started } else { started.open_ended() }
    }
}

impl<const N: usize> Seen<'_, N> {
    fn read(&self, out: &mut Readings) {
        let (forest, task) = (self.forest, self.task);
        let found = forest.found.as_deref();
        let finished = found.map(|found| found.finished(task));
        out.push(BEST, found.map_or(f64::NAN, |found| found.cost));
        out.push(SHORT_LENGTH, finished.map_or(f64::NAN, |finished| length(&finished.short)));
        out.push(FINAL_LENGTH, finished.map_or(f64::NAN, |finished| length(&finished.path)));
        out.push(TO_GOAL, forest.nearest.sqrt());
        out.push(NODES, forest.births.len() as f64);
        out.push(REJECTED, forest.rejected as f64);
        out.push(TESTED, forest.tested as f64);
        out.push(FOUND_AFTER, found.map_or(f64::NAN, |found| found.iteration as f64));
    }

    /// The nodes' parents, trees and coordinates in the order in which they were added.
    fn members(&self, out: &mut Vec<f64>) {
        if !self.task.space.has_members() {
            return;
        }
        // The number in the order of birth of each tree's nodes.
        let mut numbers = [vec![0.0; self.forest.trees[0].len()], vec![0.0; self.forest.trees[1].len()]];
        for (i, birth) in self.forest.births.iter().enumerate() {
            let (tree, node) = (usize::from(birth.tree), birth.node as usize);
            numbers[tree][node] = i as f64;
            let parent = self.forest.trees[tree].parents[node];
            out.extend([if parent == super::forest::NONE { -1.0 } else { numbers[tree][parent as usize] }, tree as f64]);
            out.extend(self.forest.trees[tree].points[node].iter().map(|angle| angle.to_degrees()));
        }
    }
}
